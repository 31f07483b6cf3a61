/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    The polyMesh of particles: OpenFOAM's geometry of it, read back from disk,
    is that of the particles, and OpenFOAM's operators work on it.

\*---------------------------------------------------------------------------*/

#include "particleScene.H"
#include "particleFaces.H"
#include "cyclicFvPatch.H"
#include "fvc.H"
#include "fvmLaplacian.H"
#include "fvMatrices.H"
#include "periodicImages.H"

#include <gtest/gtest.h>
#include <map>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Name of a scene
class ParticlePolyMesh
:
    public testing::TestWithParam<const char*>
{
protected:

    std::unique_ptr<particleScene> scene =
        particleScene::New(GetParam(), 0.3);

    std::unique_ptr<sceneParticles> particles = scene->assemble("order 1;");

    const fvMesh& mesh = particles->mesh();

    const scalar dp = particles->written().spacing[0];

    //- Area of a face between particles
    scalar faceArea() const
    {
        return particles->space().volume(dp)/dp;
    }
};


//- Largest magnitude
template<class Type>
scalar largest(const Field<Type>& values)
{
    return values.empty() ? 0 : max(mag(values));
}


//- A linear field, its values on the patches given
volScalarField linearField(const fvMesh& mesh, const vector& slope)
{
    wordList types(mesh.boundary().size(), "fixedValue");
    forAll(types, patchi)
    {
        if (polyPatch::constraintType(mesh.boundary()[patchi].type()))
        {
            types[patchi] = mesh.boundary()[patchi].type();
        }
    }
    volScalarField f
    (
        IOobject("f", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimless, Zero),
        types
    );
    f.primitiveFieldRef() = mesh.C().primitiveField() & slope;
    for (auto& values : f.boundaryFieldRef())
    {
        if (!values.coupled())
        {
            values == (values.patch().Cf() & slope);
        }
    }
    f.correctBoundaryConditions();
    return f;
}


//- Is a particle away from the boundary, with so many particles between
boolList isInner(const fvMesh& mesh, const label nBetween)
{
    boolList inner(mesh.nCells(), true);
    for (const fvPatch& patch : mesh.boundary())
    {
        if (patch.size() && !patch.coupled())
        {
            for (const label i : patch.faceCells())
            {
                inner[i] = false;
            }
        }
    }
    for (label layer = 0; layer < nBetween; ++layer)
    {
        const boolList before(inner);
        forAll(mesh.faceNeighbour(), facei)
        {
            const label i = mesh.faceOwner()[facei];
            const label j = mesh.faceNeighbour()[facei];
            inner[i] = inner[i] && before[j];
            inner[j] = inner[j] && before[i];
        }
    }
    return inner;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * *  Geometry * * * * * * * * * * * * * * * * * //

TEST_P(ParticlePolyMesh, cellsAreTheParticles)
{
    const particleMeshData& data = particles->written();
    ASSERT_EQ(mesh.nCells(), data.points.size());
    EXPECT_EQ(mesh.nGeometricD(), particles->nDims());

    EXPECT_LT(largest(scalarField(mesh.cellVolumes()/data.V - 1)), 1e-11);

    // In 3-D the centre of a closed polyhedron is off the particle by
    // sum_f (A_f.r_f) r_f/(4 V)
    vectorField offset(mesh.nCells(), Zero);
    if (particles->nDims() == 3)
    {
        forAll(mesh.cells(), i)
        {
            for (const label facei : mesh.cells()[i])
            {
                const vector r(mesh.faceCentres()[facei] - data.points[i]);
                const vector A
                (
                    mesh.faceOwner()[facei] == i
                  ? mesh.faceAreas()[facei]
                  : -mesh.faceAreas()[facei]
                );
                offset[i] += (A & r)*r/(4*data.V[i]);
            }
        }
    }
    EXPECT_LT
    (
        largest(vectorField(mesh.cellCentres() - data.points - offset)),
        1e-11*dp
    );
}


TEST_P(ParticlePolyMesh, cellsAreClosed)
{
    vectorField sum(mesh.nCells(), Zero);
    forAll(mesh.faceOwner(), facei)
    {
        sum[mesh.faceOwner()[facei]] += mesh.faceAreas()[facei];
        if (mesh.isInternalFace(facei))
        {
            sum[mesh.faceNeighbour()[facei]] -= mesh.faceAreas()[facei];
        }
    }
    EXPECT_LT(largest(sum), 1e-11*faceArea());
}


TEST_P(ParticlePolyMesh, patchesKeepTypeAndArea)
{
    const polyBoundaryMesh& fvm = scene->mesh().boundaryMesh();
    for (const polyPatch& pp : fvm)
    {
        const polyPatch& patch = mesh.boundaryMesh()[pp.index()];
        EXPECT_EQ(patch.name(), pp.name());
        EXPECT_EQ(patch.type(), pp.type());
        if (!pp.coupled() && pp.type() != "empty")
        {
            const vector area(gSum(pp.faceAreas()));
            EXPECT_LT
            (
                mag(gSum(patch.faceAreas()) - area),
                1e-12*gSum(mag(pp.faceAreas()))
            )   << pp.name();
        }
    }
    for (label patchi = fvm.size(); patchi < mesh.boundary().size(); ++patchi)
    {
        EXPECT_TRUE(mesh.boundary()[patchi].coupled());
    }
}


TEST_P(ParticlePolyMesh, facesAreSimplePolygonsOfTheirOwn)
{
    label nPoints = 0;
    for (const face& f : mesh.faces())
    {
        EXPECT_TRUE(f.size() == 3 || f.size() == 4);
        nPoints += f.size();
    }
    EXPECT_EQ(nPoints, mesh.nPoints());
}


TEST_P(ParticlePolyMesh, facesAreInUpperTriangularOrder)
{
    const labelList& owner = mesh.faceOwner();
    const labelList& neighbour = mesh.faceNeighbour();

    for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
    {
        ASSERT_LT(owner[facei], neighbour[facei]);
        if (facei > 0)
        {
            ASSERT_TRUE
            (
                owner[facei] > owner[facei - 1]
             || (
                    owner[facei] == owner[facei - 1]
                 && neighbour[facei] > neighbour[facei - 1]
                )
            );
        }
    }
}


TEST_P(ParticlePolyMesh, cyclicHalvesMatch)
{
    label nCyclic = 0;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        const auto* half = isA<cyclicPolyPatch>(pp);
        if (!half)
        {
            continue;
        }
        const cyclicPolyPatch& other = half->neighbPatch();
        ASSERT_EQ(pp.size(), other.size());
        ASSERT_GT(pp.size(), 0);
        ++nCyclic;

        const vector translation(other.faceCentres()[0] - pp.faceCentres()[0]);
        forAll(pp, k)
        {
            EXPECT_LT
            (
                mag(pp.faceAreas()[k] + other.faceAreas()[k]),
                1e-12*faceArea()
            );
            EXPECT_LT
            (
                mag
                (
                    other.faceCentres()[k] - pp.faceCentres()[k] - translation
                ),
                1e-12
            );
        }
    }

    const word name(GetParam());
    EXPECT_EQ
    (
        nCyclic,
        name == "periodic" ? 8 : name == "channel" || name == "pipe" ? 2 : 0
    );
}


// * * * * * * * * * * * * * * *  particleMesh * * * * * * * * * * * * * * * //

TEST_P(ParticlePolyMesh, pairsAreThoseWritten)
{
    const particleMeshData& data = particles->written();
    std::map<std::pair<label, label>, label> pairOf;
    label nPairs = 0;
    forAll(data.owner, k)
    {
        // Areas of round-off are left out
        const label i = data.owner[k];
        if (mag(data.Sf[k]) > 1e-12*data.V[i]/data.spacing[i])
        {
            pairOf[{data.owner[k], data.neighbour[k]}] = k;
            ++nPairs;
        }
    }
    ASSERT_EQ(label(pairOf.size()), nPairs);
    ASSERT_EQ(particles->nPairs(), nPairs);

    scalar area = 0;
    scalar delta = 0;
    scalar skew = 0;
    for (label k = 0; k < nPairs; ++k)
    {
        const auto found = pairOf.find
        (
            {particles->owner()[k], particles->neighbour()[k]}
        );
        ASSERT_NE(found, pairOf.end());
        const label w = found->second;
        area = max(area, mag(particles->Sf()[k] - data.Sf[w]));
        delta = max(delta, mag(particles->delta()[k] - data.delta[w]));
        skew = max(skew, mag(particles->skew()[k] - data.skew[w]));
    }
    EXPECT_LT(area, 1e-12*faceArea());
    EXPECT_LT(delta, 1e-12*dp);
    EXPECT_LT(skew, 1e-12*dp);

    EXPECT_EQ(particles->spacing(), data.spacing);
    EXPECT_LT(largest(vectorField(particles->C() - data.points)), 1e-12*dp);
    EXPECT_LT(largest(scalarField(particles->V()/data.V - 1)), 1e-11);
}


TEST_P(ParticlePolyMesh, boundaryFacesAreThoseWritten)
{
    const boundaryFaces& faces = particles->boundary().faces();
    const boundaryFaces& written = particles->written().boundary;
    ASSERT_EQ(faces.owner, written.owner);

    EXPECT_LT(largest(vectorField(faces.Sf - written.Sf)), 1e-12*faceArea());
    EXPECT_LT(largest(vectorField(faces.Cf - written.Cf)), 1e-12*dp);

    for (const fvPatch& patch : scene->mesh().boundary())
    {
        EXPECT_EQ
        (
            faces.start[patch.index() + 1], written.start[patch.index() + 1]
        );

        // Normal to a patch of the box or of its hole
        const particlePatch& part = particles->boundary()[patch.index()];
        const labelList fvmFaces(particles->fvmFaces(part));
        forAll(part.owner(), s)
        {
            const point& x = particles->C()[part.owner()[s]];
            const scalar distance =
                (part.Cf()[s] - x) & patch.nf()()[fvmFaces[s]];
            EXPECT_NEAR
            (
                part.distance()[s], max(distance, 0.05*dp), 1e-11*dp
            )   << patch.name();
            EXPECT_EQ(part.face()[s], s);
        }
    }
}


INSTANTIATE_TEST_SUITE_P
(
    Scenes,
    ParticlePolyMesh,
    testing::Values
    (
        "line", "box", "hole", "channel", "periodic", "cube", "pipe"
    )
);


TEST(ParticlePolyMesh, pairsAcrossTwoPeriodsHaveAPatchPair)
{
    const auto scene = particleScene::New("periodic", 0.3);
    const auto particles = scene->assemble("order 1;");
    const polyBoundaryMesh& patches = particles->mesh().boundaryMesh();
    const label nFvm = scene->mesh().boundaryMesh().size();

    // Two diagonals, and both halves of each
    ASSERT_EQ(patches.size(), nFvm + 4);
    for (label patchi = nFvm; patchi < patches.size(); ++patchi)
    {
        EXPECT_TRUE(patches[patchi].inGroups().found(cornerGroup));
        const auto& half = refCast<const cyclicPolyPatch>(patches[patchi]);
        const vector period
        (
            half.neighbPatch().faceCentres()[0] - half.faceCentres()[0]
        );
        EXPECT_NEAR(mag(period.x()), 1, 1e-12);
        EXPECT_NEAR(mag(period.y()), 1, 1e-12);
    }
}


TEST(ParticlePolyMesh, pairsAcrossNoPeriodAreAnError)
{
    const auto scene = particleScene::New("periodic", 0.3);
    const auto particles = scene->assemble("order 1;");
    particleMeshData data(particles->written());
    data.delta[0] *= 3;

    EXPECT_NE
    (
        errorMessage
        (
            [&]{ particleFaces(scene->mesh(), particles->space(), data); }
        ).find("apart at their face, which no period of the mesh is"),
        std::string::npos
    );
}


TEST(ParticlePolyMesh, patchesKeepTheirConstraints)
{
    testCase::layout layout;
    layout.patchTypes.set("top", "symmetryPlane");
    layout.patchTypes.set("left", "wall");
    particleScene scene(layout, 0.05, 0.3);
    const auto particles = scene.assemble("order 1;");

    const polyBoundaryMesh& patches = particles->mesh().boundaryMesh();
    EXPECT_EQ(patches["top"].type(), "symmetryPlane");
    EXPECT_EQ(patches["left"].type(), "wall");
    EXPECT_EQ(patches["frontAndBack"].type(), "empty");
    EXPECT_EQ(patches["frontAndBack"].size(), 2*particles->nParticles());
}


TEST(ParticlePolyMesh, particlesWithoutClosureKeepVolumeAndPlace)
{
    for (const char* name : {"box", "cube"})
    {
        const auto scene = particleScene::New(name, 0.3);
        const auto particles = scene->assemble("type none;");
        const particleMeshData& data = particles->written();

        EXPECT_LT
        (
            largest(vectorField(particles->C() - data.points)), 1e-11*0.05
        )   << name;
        EXPECT_LT
        (
            largest(scalarField(particles->V()/data.V - 1)), 1e-11
        )   << name;
    }
}


// * * * * * * * * * * * * * *  Stock operators  * * * * * * * * * * * * * * //

TEST(StockOperators, aConstantVelocityHasNoDivergence)
{
    for (const char* name : {"box", "hole", "channel", "periodic", "cube"})
    {
        const auto scene = particleScene::New(name, 0.3);
        const auto particles = scene->assemble("order 1;");
        const fvMesh& mesh = particles->mesh();
        const vector velocity(0.8, -0.3, particles->nDims() == 3 ? 0.5 : 0);

        const volVectorField U
        (
            IOobject("U", mesh.time().timeName(), mesh),
            mesh,
            dimensionedVector("U", dimVelocity, velocity)
        );
        const volScalarField divU(fvc::div(fvc::flux(U)));
        EXPECT_LT
        (
            largest(divU.primitiveField())*particles->spacing()[0],
            1e-11*mag(velocity)
        )   << name;
    }
}


TEST(StockOperators, gradientsOfALinearField)
{
    const vector slope(3, -2, 0);

    for (const char* name : {"box", "hole"})
    {
        const auto scene = particleScene::New(name, 0.3);
        const auto particles = scene->assemble("order 1;");
        const fvMesh& mesh = particles->mesh();
        const volScalarField f(linearField(mesh, slope));

        // Off the face's centre by what the closure moves it
        const volVectorField gaussGrad
        (
            fv::gaussGrad<scalar>(mesh).grad(f)
        );
        const scalarField error(mag(gaussGrad.primitiveField() - slope));
        EXPECT_LT(std::sqrt(average(sqr(error))), 0.05*mag(slope)) << name;

        const volVectorField leastSquaresGrad
        (
            fv::gradScheme<scalar>::New
            (
                mesh, IStringStream("leastSquares")()
            )().grad(f)
        );
        // OpenFOAM takes the distance of a patch along its normal
        const boolList inner(isInner(mesh, 0));
        forAll(inner, i)
        {
            if (inner[i])
            {
                EXPECT_LT(mag(leastSquaresGrad[i] - slope), 1e-11*mag(slope))
                    << name;
            }
        }
    }
}


TEST(StockOperators, laplacianIsConservativeAndConsistent)
{
    const auto scene = particleScene::New("hole", 0.3);
    scene->files().write
    (
        "system/fvSchemes",
        "ddtSchemes { default Euler; } gradSchemes { default leastSquares; }"
        "divSchemes { default none; }"
        "laplacianSchemes { default Gauss linear corrected; }"
        "interpolationSchemes { default linear; }"
        "snGradSchemes { default corrected; }"
    );
    const auto particles = scene->assemble("order 1;");
    const fvMesh& mesh = particles->mesh();
    const scalar dp = particles->spacing()[0];
    const boolList inner(isInner(mesh, 1));

    // A linear field has none
    const vector slope(3, -2, 0);
    volScalarField f(linearField(mesh, slope));
    const volScalarField none(fvc::laplacian(f));
    forAll(none, i)
    {
        if (inner[i])
        {
            EXPECT_LT(mag(none[i])*dp, 1e-10*mag(slope));
        }
    }

    // x^2 + y^2 has 4
    f.primitiveFieldRef() = magSqr(mesh.C().primitiveField());
    for (auto& values : f.boundaryFieldRef())
    {
        values == magSqr(values.patch().Cf());
    }
    const volScalarField four(fvc::laplacian(f));
    scalar sum = 0;
    scalar volume = 0;
    forAll(four, i)
    {
        if (inner[i])
        {
            sum += mesh.V()[i]*four[i];
            volume += mesh.V()[i];
        }
    }
    EXPECT_NEAR(sum/volume, 4, 0.1);

    // The sum over all is the flux through the patches, and the matrix says
    // the same
    scalar flux = 0;
    for (const auto& values : f.boundaryField())
    {
        flux += gSum(values.snGrad()*values.patch().magSf());
    }
    EXPECT_NEAR(gSum(mesh.V()*four.primitiveField()), flux, 1e-11*mag(flux));

    const scalarField matrix((fvm::laplacian(f) & f)().primitiveField());
    EXPECT_LT
    (
        largest(scalarField(matrix - four.primitiveField())),
        1e-9*largest(four.primitiveField())
    );
}


// ************************************************************************* //
