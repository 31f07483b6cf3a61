/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleScene.H"
#include "DynamicList.H"
#include "movingLeastSquares.H"
#include "OSspecific.H"
#include "particlesToMesh.H"
#include "Random.H"

#include <cmath>
#include <chrono>
#include <filesystem>
#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Directions 0 .. nDims - 1 of a unit cube
solutionSpace unitSpace(const label nDims)
{
    return solutionSpace(nDims, FixedList<direction, 3>({0, 1, 2}), 1, Zero);
}


//- n points a direction in the unit cube, moved by up to jitter/2 spacings
pointField lattice(const label nDims, const label n, const scalar jitter)
{
    Random random(17);
    DynamicList<point> points;

    for (label k = 0; k < (nDims > 2 ? n : 1); ++k)
    {
        for (label j = 0; j < (nDims > 1 ? n : 1); ++j)
        {
            for (label i = 0; i < n; ++i)
            {
                const labelVector ijk(i, j, k);
                point p(Zero);
                for (direction d = 0; d < nDims; ++d)
                {
                    p[d] =
                        (
                            ijk[d] + 0.5
                          + jitter*(random.sample01<scalar>() - 0.5)
                        )/n;
                }
                points.append(p);
            }
        }
    }
    return pointField(points);
}


scalarField values
(
    const pointField& points,
    const std::function<scalar(const point&)>& f
)
{
    scalarField result(points.size());
    forAll(result, i)
    {
        result[i] = f(points[i]);
    }
    return result;
}


scalar linear(const point& p)
{
    return 1e3*(3 + 2*p.x() - 5*p.y() + 0.7*p.z());
}


scalar smooth(const point& p)
{
    return std::sin(3*p.x() + 0.3)*std::cos(2*p.y())*std::exp(p.z());
}


//- Values of f mapped from a jittered lattice of n to a lattice of m points
scalarField mapped
(
    const label nDims,
    const label n,
    const label m,
    const std::function<scalar(const point&)>& f
)
{
    const pointField from(lattice(nDims, n, 0.5));
    const pointField to(lattice(nDims, m, 0));
    const scalarField fromSpacing(from.size(), 1.0/n);
    const scalarField toSpacing(to.size(), 1.0/m);

    const movingLeastSquares map
    (
        unitSpace(nDims), {from, fromSpacing}, {to, toSpacing}
    );

    scalarField result(to.size());
    map.map(values(from, f), result);
    return result;
}


//- A scalar volField with zeroGradient patches that is not written
volScalarField cellField(const fvMesh& mesh, const scalar value)
{
    return volScalarField
    (
        IOobject("f", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("f", dimless, value),
        "zeroGradient"
    );
}


//- One whose patches take what they are given
volScalarField calculatedField(const fvMesh& mesh)
{
    return volScalarField
    (
        IOobject("f", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimless, Zero)
    );
}


//- Every number of points a direction of sources with targets of two fifths,
//- of the same and of four times the spacing
class MappedSpacing
:
    public testing::TestWithParam<std::tuple<label, scalar>>
{
protected:

    label nDims() const
    {
        return std::get<0>(GetParam());
    }

    //- Targets a direction for n sources
    label targets(const label n) const
    {
        return max(label(1), label(n/std::get<1>(GetParam())));
    }

    label sources() const
    {
        return nDims() == 3 ? 12 : 24;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_P(MappedSpacing, uniformFieldsStayBitwiseUniform)
{
    const scalar value = 0.1 + 1.0/3.0;
    const label n = sources();

    const scalarField result
    (
        mapped(nDims(), n, targets(n), [&](const point&) { return value; })
    );
    for (const scalar v : result)
    {
        EXPECT_EQ(v, value);
    }
}


TEST_P(MappedSpacing, linearFieldsAreExact)
{
    const label n = sources();
    const label m = targets(n);
    const scalarField expected(values(lattice(nDims(), m, 0), linear));
    const scalarField result(mapped(nDims(), n, m, linear));

    // Magnitude of the field 1e4, weights up to 4
    EXPECT_LT(max(mag(result - expected)), 1e-11*1e4);
}


TEST_P(MappedSpacing, smoothFieldsConvergeAtSecondOrder)
{
    scalar coarse = 0;
    for (const label n : {sources(), 2*sources()})
    {
        const label m = targets(n);
        const scalarField expected(values(lattice(nDims(), m, 0), smooth));
        const scalarField result(mapped(nDims(), n, m, smooth));
        const scalar error = std::sqrt(average(sqr(result - expected)));

        if (coarse > 0)
        {
            // 4 in the limit, 2 if it were of first order
            EXPECT_GT(coarse/error, 3) << coarse << " to " << error;
        }
        coarse = error;
    }
}


INSTANTIATE_TEST_SUITE_P
(
    MovingLeastSquares,
    MappedSpacing,
    testing::Combine(testing::Values(1, 2, 3), testing::Values(0.4, 1.0, 4.0))
);


TEST(MovingLeastSquares, largeTargetsGetTheirAverage)
{
    // The average of x^2 + y^2 over a square of edge s is s^2/6 more than the
    // value at its centre
    const auto f = [](const point& p) { return magSqr(p); };
    const label m = 8;
    const scalarField centre(values(lattice(2, m, 0), f));
    const scalarField result(mapped(2, 16*m, m, f));
    const scalar excess = 1.0/(6*m*m);

    for (label j = 2; j < m - 2; ++j)
    {
        for (label i = 2; i < m - 2; ++i)
        {
            const label k = i + m*j;
            EXPECT_NEAR(result[k] - centre[k], excess, 0.1*excess);
        }
    }
}


TEST(MovingLeastSquares, awkwardSourcesGiveFiniteValuesWithinReason)
{
    const solutionSpace space(unitSpace(3));
    const pointField targets(lattice(3, 3, 0));
    const scalarField targetSpacing(targets.size(), 1.0/3.0);

    DynamicList<pointField> clouds;
    clouds.append(pointField(1, point(0.5, 0.5, 0.5)));
    clouds.append(pointField(30, point(0.2, 0.7, 0.1)));
    clouds.append(pointField(1, point(100, -30, 5)));
    clouds.append(lattice(1, 10, 0));
    clouds.append(lattice(2, 10, 0));

    // A line askew, and a far and thin pair of lines
    pointField askew(10);
    pointField thin(20);
    forAll(askew, i)
    {
        askew[i] = 0.1*i*vector(1, 1, 1);
        thin[2*i] = point(0.1*i, 0, 3);
        thin[2*i + 1] = point(0.1*i, 1e-9, 3);
    }
    clouds.append(askew);
    clouds.append(thin);

    for (const pointField& cloud : clouds)
    {
        const scalarField spacing(cloud.size(), 0.1);
        const movingLeastSquares map
        (
            space, {cloud, spacing}, {targets, targetSpacing}
        );

        scalarField ones(targets.size());
        map.map(scalarField(cloud.size(), 1), ones);
        EXPECT_EQ(ones, scalarField(targets.size(), 1));

        // Alternating values between -1 and 1, for which a fit that divides
        // by the thickness of the cloud explodes
        scalarField alternating(cloud.size());
        forAll(alternating, i)
        {
            alternating[i] = i % 2 ? 1 : -1;
        }
        scalarField result(targets.size());
        map.map(alternating, result);
        for (const scalar v : result)
        {
            EXPECT_TRUE(std::isfinite(v));
            EXPECT_LT(mag(v), 100);
        }
    }
}


TEST(MovingLeastSquares, sourcesOnALineAreExactAlongIt)
{
    const pointField line(lattice(1, 10, 0));
    const scalarField spacing(line.size(), 0.1);
    const pointField target(1, point(0.33, 0.4, 0));

    const movingLeastSquares map
    (
        unitSpace(2), {line, spacing}, {target, scalarField(1, 0.1)}
    );
    scalarField result(1);
    map.map(values(line, linear), result);

    EXPECT_NEAR(result[0], linear(point(0.33, 0, 0)), 1e-9);
}


TEST(MovingLeastSquares, oneLayerIsAsSmoothInSpaceAsInThePlane)
{
    const label n = 20;
    const pointField layer(lattice(2, n, 0));
    const pointField targets(lattice(2, 3*n, 0) + vector(0, 0, 0.3/n));
    const scalarField spacing(layer.size(), 1.0/n);
    const scalarField targetSpacing(targets.size(), 1.0/(3*n));
    const auto wave = [](const point& p)
    {
        return std::sin(20*p.x())*std::cos(15*p.y());
    };

    scalarField inPlane(targets.size());
    scalarField inSpace(targets.size());
    for (scalarField* result : {&inPlane, &inSpace})
    {
        movingLeastSquares
        (
            unitSpace(result == &inPlane ? 2 : 3),
            {layer, spacing},
            {targets, targetSpacing}
        ).map(values(layer, wave), *result);
    }

    const scalarField exact(values(targets, wave));
    const scalar error = sum(mag(inPlane - exact));
    EXPECT_GT(error, 0);
    EXPECT_LT(sum(mag(inSpace - exact)), 1.1*error);
}


TEST(MovingLeastSquares, flatCellsKeepTheirProfileAcross)
{
    // As many cells as in a square lattice, 25 times as long as high
    const label n = 60;
    pointField flat(n*n);
    forAll(flat, i)
    {
        flat[i] = point((i/(5*n) + 0.5)*5/n, (i % (5*n) + 0.5)/(5*n), 0);
    }
    const pointField targets(lattice(2, n, 0));
    const scalarField spacing(n*n, 1.0/n);
    const auto layer = [](const point& p) { return std::tanh(20*p.y()); };
    const auto error =
        [&](const pointField& from, const std::function<scalar(const point&)> f)
    {
        scalarField result(n*n);
        movingLeastSquares
        (
            unitSpace(2), {from, spacing}, {targets, spacing}
        ).map(values(from, f), result);
        return max(mag(result - values(targets, f)));
    };

    // The weights' mean over R has the curvature's error, the lattice less
    EXPECT_LT(error(flat, layer), 2*error(lattice(2, n, 0.1), layer));
    EXPECT_LT(error(flat, linear), 1e-9);
}


TEST(MovingLeastSquares, boundedMappingKeepsAJumpInItsRange)
{
    const pointField from(lattice(2, 12, 0.3));
    const pointField to(lattice(2, 50, 0));
    const scalarField fromSpacing(from.size(), 1.0/12);
    const scalarField toSpacing(to.size(), 1.0/50);
    const scalarField jump
    (
        values
        (
            from,
            [](const point& p) { return p.x() + 0.6*p.y() < 0.7 ? 116.5 : 1; }
        )
    );

    const movingLeastSquares map
    (
        unitSpace(2), {from, fromSpacing}, {to, toSpacing}
    );

    scalarField free(to.size());
    scalarField bounded(to.size());
    map.map(jump, free);
    map.map(jump, bounded, true);

    EXPECT_LT(min(free), 1) << "not a case that needs bounds";
    EXPECT_GE(min(bounded), 1);
    EXPECT_LE(max(bounded), 116.5);
}


TEST(MovingLeastSquares, farTargetsDoNotAmplifyErrors)
{
    // Two spacings beyond the corner of sources, where a linear function
    // through the nearest few has large weights of both signs
    const pointField from(lattice(2, 6, 0));
    const pointField to(1, point(1.25, 1.25, 0));
    const movingLeastSquares map
    (
        unitSpace(2),
        {from, scalarField(from.size(), 1.0/6)},
        {to, scalarField(1, 1.0/6)}
    );

    // What an error of size one at every source may give
    scalar sum = 0;
    forAll(from, k)
    {
        scalarField error(from.size(), Zero);
        error[k] = 1;
        scalarField mapped(1);
        map.map(error, mapped);
        sum += mag(mapped[0]);
    }
    EXPECT_LE(sum, 4 + 1e-12);
}


TEST(MovingLeastSquares, needsSources)
{
    const pointField none;
    const pointField target(1, point(Zero));

    EXPECT_NE
    (
        errorMessage
        (
            [&]
            {
                movingLeastSquares
                (
                    unitSpace(2),
                    {none, scalarField()},
                    {target, scalarField(1, 0.1)}
                );
            }
        ).find("from no points"),
        std::string::npos
    );
}


TEST(ParticlesToMesh, linearFieldsAreExactInCells)
{
    for (const char* name : {"box", "hole", "cube"})
    {
        const auto scene = particleScene::New(name, 0.3);
        scene->assemble("order 1;");
        const particleResults particles(scene->files().time());
        const particlesToMesh mapper(scene->mesh(), particles);

        volScalarField field(cellField(particles.mesh(), 0));
        field.primitiveFieldRef() =
            values(particles.mesh().cellCentres(), linear);
        const volScalarField result(mapper.map(field));

        EXPECT_EQ(result.name(), "f.sph");
        EXPECT_LT
        (
            max
            (
                mag
                (
                    result.primitiveField()
                  - values(scene->mesh().cellCentres(), linear)
                )
            ),
            1e-7
        )   << name;
    }
}


TEST(ParticlesToMesh, patchFacesGetTheMeanOfTheirParts)
{
    for (const char* name : {"box", "hole", "cube"})
    {
        const auto scene = particleScene::New(name, 0.3);
        scene->assemble("order 1;");
        const particleResults particles(scene->files().time());
        const particlesToMesh mapper(scene->mesh(), particles);

        // A value on all parts of a face is that of the face
        volScalarField field(calculatedField(particles.mesh()));
        for (auto& values : field.boundaryFieldRef())
        {
            const label start =
                values.patch().start() - particles.mesh().nInternalFaces();
            scalarField given(values.size());
            forAll(given, k)
            {
                given[k] = 7 + particles.boundaryFace()[start + k];
            }
            values == given;
        }
        const volScalarField faces(mapper.map(field));
        for (const auto& values : faces.boundaryField())
        {
            forAll(values, facei)
            {
                EXPECT_NEAR(values[facei], 7 + facei, 1e-10)
                    << name << ' ' << values.patch().name();
            }
        }

        // Random values keep their integral over the patch
        Random random(3);
        for (auto& values : field.boundaryFieldRef())
        {
            scalarField given(values.size());
            for (scalar& v : given)
            {
                v = random.sample01<scalar>();
            }
            values == given;
        }
        const volScalarField means(mapper.map(field));
        for (const auto& values : means.boundaryField())
        {
            const auto& from = field.boundaryField()[values.patch().index()];
            if (values.size())
            {
                const scalar given = sum(from.patch().magSf()*from);
                EXPECT_NEAR
                (
                    sum(values.patch().magSf()*values), given, 1e-10*given
                )   << name << ' ' << values.patch().name();
            }
        }
    }
}


TEST(ParticleResults, ReadsFieldsWithoutTheirBoundaryConditions)
{
    const auto scene = particleScene::New("box", 0.3);
    scene->assemble("order 1;");
    testCase& box = scene->files();

    box.write
    (
        "sph/0.5/p",
        "dimensions [0 2 -2 0 0 0 0]; internalField uniform 7;"
        " boundaryField { left { type fixedValue; value uniform 3; }"
        " right { type neverHeardOf; value uniform 5; }"
        " bottom { type zeroGradient; }"
        " top { type uniformFixedValue; uniformValue constant 4; }"
        " frontAndBack { type empty; } }",
        "volScalarField"
    );
    box.write("sph/0.5/phi", "", "surfaceScalarField");
    box.write("sph/0.5/cloud", "", "IOField<scalar>");

    const particleResults particles(box.time());
    const instant time(0.5, "0.50");
    EXPECT_EQ(particles.timeName(time), "0.5");
    EXPECT_EQ(particles.timeName(instant(0.7, "0.7")), "");
    EXPECT_EQ(particles.fields(instant(0.7, "0.7")).size(), 0);

    const IOobjectList fields(particles.fields(time));
    EXPECT_EQ(fields.sortedNames(), wordList({"p"}));

    const volScalarField p(particles.read<scalar>(*fields["p"]));
    EXPECT_EQ(p.dimensions(), dimPressure/dimDensity);
    EXPECT_EQ(p.primitiveField(), scalarField(p.size(), 7));

    const scalar expected[] = {3, 5, 7, 4};
    for (label patchi = 0; patchi < 4; ++patchi)
    {
        const auto& values = p.boundaryField()[patchi];
        EXPECT_EQ(values.type(), "calculated");
        EXPECT_GT(values.size(), 10);
        EXPECT_EQ
        (
            scalarField(values), scalarField(values.size(), expected[patchi])
        );
    }

    // On the cells, at the same time of the FVM case
    box.time().setTime(0.5, 5);
    const particlesToMesh mapper(scene->mesh(), particles);
    EXPECT_EQ(mapper.write(wordRes({wordRe("q")})), 0);
    EXPECT_EQ(mapper.write(wordRes()), 1);

    // The clock of a file system may not tell files written at once apart
    const std::string source(box.path()/"sph"/"0.5"/"p");
    std::filesystem::last_write_time
    (
        source,
        std::filesystem::last_write_time(source) - std::chrono::seconds(1)
    );
    EXPECT_EQ(mapper.write(wordRes(), instant(0.5, "0.5"), true), 0);
    EXPECT_TRUE(isFile(box.path()/"0.5"/"p.sph"));
    EXPECT_FALSE(isFile(box.path()/"0.5"/"p"));
}

// ************************************************************************* //
