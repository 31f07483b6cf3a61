/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "convectionScheme.H"
#include "fixedValueFvPatchFields.H"
#include "fvmLaplacian.H"
#include "fvcLaplacian.H"
#include "fvMatrices.H"
#include "HashSet.H"
#include "surfaceFields.H"
#include "surfaceInterpolationScheme.H"
#include "testCase.H"
#include "volFields.H"

#include <cmath>
#include <gtest/gtest.h>
#include <utility>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const word quadratic("quadraticFixedValue");

//- Sheared, stretched and disordered; periodic in x, walls stay plane
point distorted(const point& p)
{
    const scalar wave = std::sin(constant::mathematical::twoPi*p.x());
    const scalar inside = p.y()*(1 - p.y());

    return point
    (
        p.x() + 0.3*p.y() + 0.2*inside*wave,
        p.y()*(0.6 + 0.4*p.y()) + 0.2*inside*wave,
        p.z() + (p.z() > 0.15 ? 0.1*p.z()*wave : 0)
    );
}


//- A box with the schemes that the tests need
struct schemesCase
:
    public testCase
{
    explicit schemesCase(const testCase::layout& l)
    :
        testCase(l)
    {
        write
        (
            "system/fvSchemes",
            "ddtSchemes { default Euler; }"
            "gradSchemes { default Gauss linear; exact leastSquares;"
            " grad(loop) Gauss reconstructed; }"
            "divSchemes { default none; }"
            "laplacianSchemes { default Gauss linear orthogonal; }"
            "interpolationSchemes { default linear; }"
            "snGradSchemes { default orthogonal; }"
        );
        mesh().fvSchemes::read();
    }
};


testCase::layout distortedBox(const label nDims, const bool periodic)
{
    testCase::layout box;
    box.nCells = labelVector(9, 7, nDims == 3 ? 5 : 1);
    box.box = boundBox(point(0, 0, 0), point(1, 1, nDims == 3 ? 1 : 0.1));
    box.twoD = nDims == 2;
    box.periodic[0] = periodic;
    box.transform = distorted;

    return box;
}


//- A field of given patch type, but for the patches that set their own, with
//- values everywhere
template<class Type, class Function>
GeometricField<Type, fvPatchField, volMesh> fieldOf
(
    const fvMesh& mesh,
    const Function& f,
    const word& patchType = quadratic,
    const word& name = "f"
)
{
    wordList types(mesh.boundary().size(), patchType);
    forAll(types, patchi)
    {
        if (polyPatch::constraintType(mesh.boundary()[patchi].type()))
        {
            types[patchi] = mesh.boundary()[patchi].type();
        }
    }

    GeometricField<Type, fvPatchField, volMesh> result
    (
        IOobject(name, mesh.time().timeName(), mesh),
        mesh,
        dimensioned<Type>("zero", dimless, Zero),
        types
    );
    forAll(result, celli)
    {
        result.primitiveFieldRef()[celli] = f(mesh.C()[celli]);
    }
    for (auto& values : result.boundaryFieldRef())
    {
        Field<Type> given(values.size());
        forAll(given, facei)
        {
            given[facei] = f(values.patch().Cf()[facei]);
        }
        values == given;
    }
    result.correctBoundaryConditions();

    return result;
}


template<class Type>
tmp<GeometricField<Type, fvsPatchField, surfaceMesh>> interpolated
(
    const GeometricField<Type, fvPatchField, volMesh>& vf,
    const char* scheme
)
{
    IStringStream is("scheme " + std::string(scheme) + ";");
    dictionary dict(is);
    return
        surfaceInterpolationScheme<Type>::New
        (
            vf.mesh(),
            dict.lookup("scheme")
        )().interpolate(vf);
}


//- Largest error of the values on faces between cells off the uncoupled
//- patches, in whose cells OpenFOAM's gradients are not exact if faces are
//- skewed
template<class Type, class Function>
scalar faceError
(
    const GeometricField<Type, fvsPatchField, surfaceMesh>& values,
    const Function& f
)
{
    const fvMesh& mesh = values.mesh();
    labelHashSet outer;
    for (const fvPatch& patch : mesh.boundary())
    {
        if (!patch.coupled())
        {
            outer.insert(patch.faceCells());
        }
    }

    scalar error = 0;
    label nFaces = 0;
    forAll(mesh.owner(), facei)
    {
        if
        (
            !outer.found(mesh.owner()[facei])
         && !outer.found(mesh.neighbour()[facei])
        )
        {
            error = max(error, mag(values[facei] - f(mesh.Cf()[facei])));
            ++nFaces;
        }
    }
    for (const auto& patchValues : values.boundaryField())
    {
        const labelUList& cells = patchValues.patch().faceCells();
        for (label i = 0; patchValues.coupled() && i < cells.size(); ++i)
        {
            if (!outer.found(cells[i]))
            {
                const point& x = patchValues.patch().Cf()[i];
                error = max(error, mag(patchValues[i] - f(x)));
                ++nFaces;
            }
        }
    }
    EXPECT_GT(nFaces, 20);

    return error;
}


//- Largest error of the normal gradients on uncoupled patches
template<class Type, class Gradient>
scalar wallError
(
    const GeometricField<Type, fvPatchField, volMesh>& vf,
    const Gradient& gradient
)
{
    scalar error = 0;
    for (const auto& values : vf.boundaryField())
    {
        if (!values.coupled() && values.size())
        {
            const Field<Type> normalGradient(values.snGrad());
            const vectorField n(values.patch().nf());
            forAll(n, facei)
            {
                const point& x = values.patch().Cf()[facei];
                error =
                    max
                    (
                        error,
                        mag(normalGradient[facei] - (n[facei] & gradient(x)))
                    );
            }
        }
    }

    return error;
}


const vector slope(2, -5, 0.7);
const tensor slopes(1, 2, -3, 0.4, 5, 6, -7, 0.8, 0.9);

scalar linearScalar(const point& p)
{
    return 3 + (slope & p);
}


vector linearVector(const point& p)
{
    return vector(3, 2, 1) + (p & slopes);
}


//- Meshes in two and three dimensions
class Schemes
:
    public testing::TestWithParam<label>
{};

} // End anonymous namespace


// * * * * * * * * * * * * * * Interpolation * * * * * * * * * * * * * * * * //

TEST_P(Schemes, reconstructedKeepsUniformFields)
{
    schemesCase box(distortedBox(GetParam(), true));
    const auto uniform = [](const point&) { return 1.0/3.0; };
    const volScalarField f(fieldOf<scalar>(box.mesh(), uniform));

    const auto values = interpolated(f, "reconstructed");
    EXPECT_LT(max(mag(values() - 1.0/3.0)).value(), 1e-14);
}


TEST_P(Schemes, reconstructedIsExactForLinearFields)
{
    schemesCase box(distortedBox(GetParam(), false));
    const fvMesh& mesh = box.mesh();

    const volScalarField s(fieldOf<scalar>(mesh, linearScalar));
    const volVectorField v(fieldOf<vector>(mesh, linearVector));
    const auto linearTensor = [](const point& p)
    {
        return symmTensor(p.x(), p.y(), 2, p.x() - p.y(), p.z(), 3*p.y());
    };
    const volSymmTensorField t(fieldOf<symmTensor>(mesh, linearTensor));
    const char* scheme = "reconstructed exact";

    EXPECT_LT(faceError(interpolated(s, scheme)(), linearScalar), 1e-12);
    EXPECT_LT(faceError(interpolated(v, scheme)(), linearVector), 1e-12);
    EXPECT_LT(faceError(interpolated(t, scheme)(), linearTensor), 1e-12);

    EXPECT_GT(faceError(interpolated(s, "linear")(), linearScalar), 1e-3)
        << "not a mesh that needs it";
}


TEST_P(Schemes, reconstructedIsExactAcrossCyclicPatches)
{
    schemesCase box(distortedBox(GetParam(), true));
    const auto inY = [](const point& p) { return 4 - 3*p.y(); };
    const volScalarField f(fieldOf<scalar>(box.mesh(), inY));

    EXPECT_LT(faceError(interpolated(f, "reconstructed exact")(), inY), 1e-12);

    // Both halves have the same values
    const auto values = interpolated(f, "reconstructed");
    EXPECT_LT
    (
        max(mag(values().boundaryField()[0] - values().boundaryField()[1])),
        1e-13
    );
}


TEST(SchemesCase, reconstructedRefusesItsOwnGradient)
{
    schemesCase box(testCase::layout{});
    const volScalarField f
    (
        fieldOf<scalar>(box.mesh(), linearScalar, quadratic, "loop")
    );

    const std::string message
    (
        errorMessage([&] { interpolated(f, "reconstructed"); })
    );
    EXPECT_NE(message.find("grad(loop)"), std::string::npos) << message;
    EXPECT_NE(message.find("is itself"), std::string::npos) << message;
}


// * * * * * * * * * * * * * * * Convection  * * * * * * * * * * * * * * * * //

//- Largest difference of the coefficients of GaussAhead from those of Gauss
//- by the flux of the new time, before and after the flux is updated to it;
//- the flux grows linearly in time
std::pair<scalar, scalar> aheadErrors
(
    const dimensionSet& dims,
    const bool secondOrder
)
{
    schemesCase box(distortedBox(2, true));
    const fvMesh& mesh = box.mesh();
    Time& time = const_cast<Time&>(mesh.time());

    const auto wave = [](const point& p) { return std::sin(7*p.x()) + p.y(); };
    volScalarField f(fieldOf<scalar>(mesh, wave));
    const auto fluxAt = [&](const scalar t)
    {
        surfaceScalarField flux
        (
            IOobject("flux", mesh.time().timeName(), mesh),
            (mesh.Sf() & dimensionedVector("u", dimless, vector(2, -1, 0)))
           *dimensionedScalar("t", dimless, t)
        );
        flux.dimensions().reset(dims);
        return flux;
    };
    const auto coefficients = [&]
    (
        const surfaceScalarField& flux,
        const std::string& schemeData
    )
    {
        IStringStream is(schemeData);
        const fvScalarMatrix matrix
        (
            fv::convectionScheme<scalar>::New(mesh, flux, is)().fvmDiv(flux, f)
        );
        scalarField all(matrix.upper());
        all.append(matrix.lower());
        all.append(matrix.diag());
        all.append(matrix.source());
        return all;
    };

    // Two steps of different length
    surfaceScalarField flux(fluxAt(1));
    flux.oldTime().oldTime();
    time.setDeltaT(0.25, false);
    ++time;
    flux.oldTime();
    flux.primitiveFieldRef() = fluxAt(1.25).primitiveField();
    time.setDeltaT(0.5, false);
    ++time;
    f.oldTime();
    if (secondOrder)
    {
        f.oldTime().oldTime();
    }

    const scalarField expected(coefficients(fluxAt(1.75), "Gauss linear"));
    const scalar before =
        max(mag(coefficients(flux, "GaussAhead linear") - expected));
    flux.oldTime();
    flux.primitiveFieldRef() = fluxAt(1.75).primitiveField();
    const scalar after =
        max(mag(coefficients(flux, "GaussAhead linear") - expected));

    return {before, after};
}


TEST(SchemesCase, aheadConvectionHasTheFluxOfTheNewTime)
{
    const dimensionSet volumeFlux(dimVelocity*dimArea);
    const auto errors = aheadErrors(volumeFlux, true);
    EXPECT_LT(errors.first, 1e-14);
    EXPECT_LT(errors.second, 1e-14);

    // Neither for schemes of first order nor for mass fluxes
    EXPECT_GT(aheadErrors(volumeFlux, false).first, 1e-3);
    const auto massErrors = aheadErrors(dimMass/dimTime, true);
    EXPECT_GT(massErrors.first, 1e-3);
    EXPECT_LT(massErrors.second, 1e-14);
}


// * * * * * * * * * * * * * * * Wall Gradient * * * * * * * * * * * * * * * //

TEST_P(Schemes, wallGradientIsExactForLinearFields)
{
    schemesCase box(distortedBox(GetParam(), false));
    const fvMesh& mesh = box.mesh();

    const volScalarField s(fieldOf<scalar>(mesh, linearScalar));
    const volVectorField v(fieldOf<vector>(mesh, linearVector));

    EXPECT_LT(wallError(s, [](const point&) { return slope; }), 1e-10);
    EXPECT_LT(wallError(v, [](const point&) { return slopes; }), 1e-10);
}


TEST_P(Schemes, wallGradientIsExactForParabolas)
{
    // Uniform values on walls along x and z, cells skewed to them
    testCase::layout layout(distortedBox(GetParam(), true));
    if (GetParam() == 3)
    {
        layout.periodic[2] = true;
        layout.transform = [](const point& p)
        {
            return point(p.x() + 0.2*p.y(), sqr(p.y() + 0.3), p.z());
        };
    }
    schemesCase box(layout);

    const auto parabola = [](const point& p)
    {
        return 1 + 3*p.y() - 2*sqr(p.y());
    };
    const auto gradient = [](const point& p)
    {
        return vector(0, 3 - 4*p.y(), 0);
    };

    const volScalarField f(fieldOf<scalar>(box.mesh(), parabola));
    const volScalarField twoPoint
    (
        fieldOf<scalar>(box.mesh(), parabola, "fixedValue")
    );
    EXPECT_LT(wallError(f, gradient), 1e-10);
    EXPECT_GT(wallError(twoPoint, gradient), 1e-2);
}


TEST(SchemesCase, wallGradientConvergesAtSecondOrder)
{
    const auto profile = [](const point& p) { return std::exp(2*p.y()); };
    const auto gradient = [&](const point& p)
    {
        return vector(0, 2*profile(p), 0);
    };
    const auto error = [&](const label n, const word& patchType)
    {
        testCase::layout layout;
        layout.nCells = labelVector(3, n, 1);
        layout.periodic[0] = true;
        schemesCase box(layout);
        const fvMesh& mesh = box.mesh();
        return wallError(fieldOf<scalar>(mesh, profile, patchType), gradient);
    };

    EXPECT_NEAR(error(64, quadratic)/error(32, quadratic), 0.25, 0.03);
    EXPECT_NEAR(error(64, "fixedValue")/error(32, "fixedValue"), 0.5, 0.03);
    EXPECT_LT(error(32, quadratic), 0.05*error(32, "fixedValue"));
}


TEST(SchemesCase, wallGradientIsThatOfTheEquations)
{
    schemesCase box(distortedBox(3, true));
    const fvMesh& mesh = box.mesh();
    const auto smooth = [](const point& p)
    {
        return vector(std::sin(3*p.y()), std::cos(2*p.z()), sqr(p.y()));
    };
    const volVectorField U(fieldOf<vector>(mesh, smooth));

    fvVectorMatrix equation(fvm::laplacian(U));
    const volVectorField byMatrix(equation & U);
    const volVectorField explicitly(fvc::laplacian(U));

    EXPECT_LT
    (
        max(mag(byMatrix.primitiveField() - explicitly.primitiveField())),
        1e-11*max(mag(explicitly.primitiveField()))
    );
}


TEST(SchemesCase, channelFlowIsExact)
{
    testCase::layout layout;
    layout.nCells = labelVector(3, 8, 1);
    layout.periodic[0] = true;
    schemesCase box(layout);
    const fvMesh& mesh = box.mesh();

    // laplacian(u) = -2 between walls at 0 and 1
    const auto exact = [](const point& p) { return p.y()*(1 - p.y()); };
    const auto solve = [&](const word& patchType)
    {
        const auto zero = [](const point&) { return scalar(0); };
        volScalarField u(fieldOf<scalar>(mesh, zero, patchType, patchType));
        IStringStream controls
        (
            "solver PCG; preconditioner DIC; tolerance 1e-15; relTol 0;"
            " maxIter 100;"
        );
        const dictionary dict(controls);
        const dimensionedScalar source("G", dimless/dimArea, 2);

        // The explicit part of the wall gradient converges
        for (label i = 0; i < 40; ++i)
        {
            fvScalarMatrix equation(fvm::laplacian(u) == -source);
            equation.solve(dict);
        }
        return u;
    };

    const label level = messageStream::level;
    messageStream::level = 0;
    const volScalarField u(solve(quadratic));
    const volScalarField twoPoint(solve("fixedValue"));
    messageStream::level = level;

    const volScalarField expected(fieldOf<scalar>(mesh, exact));
    const auto error = [&](const volScalarField& f)
    {
        return max(mag(f.primitiveField() - expected.primitiveField()));
    };
    EXPECT_LT(error(u), 1e-12);
    EXPECT_GT(error(twoPoint), 1e-3);

    // The walls carry the whole source
    const label bottom = mesh.boundaryMesh().findPatchID("bottom");
    EXPECT_LT(max(mag(u.boundaryField()[bottom].snGrad() + 1)), 1e-11);
}


//- Largest change in the last of some solutions of laplacian(f) = 0 from zero,
//- by how much the implicit and the explicit part differ
scalar lastChange(testCase::layout layout)
{
    schemesCase box(layout);
    const fvMesh& mesh = box.mesh();
    const auto wave = [](const point& p)
    {
        return std::sin(7*p.x())*std::cos(5*p.y()) + p.z();
    };
    volScalarField f(fieldOf<scalar>(mesh, wave));
    f.primitiveFieldRef() = Zero;

    IStringStream controls
    (
        "solver PCG; preconditioner DIC; tolerance 1e-14; relTol 0;"
    );
    const dictionary dict(controls);
    const label level = messageStream::level;
    messageStream::level = 0;
    scalar change = 0;
    for (label i = 0; i < 60; ++i)
    {
        const scalarField before(f.primitiveField());
        fvScalarMatrix equation(fvm::laplacian(f));
        equation.solve(dict);
        change = max(mag(f.primitiveField() - before));
    }
    messageStream::level = level;

    return change;
}


TEST_P(Schemes, explicitPartConverges)
{
    EXPECT_LT(lastChange(distortedBox(GetParam(), false)), 1e-10);

    // Flat cells, sheared by many times their thickness
    testCase::layout flat(distortedBox(GetParam(), false));
    flat.transform = [](const point& p)
    {
        return point(p.x() + 0.5*p.y(), 0.01*p.y() + 0.003*p.x(), p.z());
    };
    EXPECT_LT(lastChange(flat), 1e-10);

    // Cells that grow fourfold from the walls on
    testCase::layout graded(distortedBox(GetParam(), false));
    graded.transform = [](const point& p)
    {
        return point(p.x(), std::pow(4.0, 7*p.y()), p.z());
    };
    EXPECT_LT(lastChange(graded), 1e-10);
}


TEST(SchemesCase, wallGradientFollowsMovement)
{
    schemesCase box(distortedBox(2, false));
    fvMesh& mesh = box.mesh();
    const auto gradient = [](const point&) { return slope; };

    EXPECT_LT(wallError(fieldOf<scalar>(mesh, linearScalar), gradient), 1e-10);

    pointField points(mesh.points());
    for (point& p : points)
    {
        p.x() *= 1 + 0.3*p.x();
        p.y() += 0.2*p.x();
    }
    mesh.movePoints(points);
    EXPECT_LT(wallError(fieldOf<scalar>(mesh, linearScalar), gradient), 1e-10);
}


TEST(SchemesCase, wallGradientSurvivesCopiesAndFiles)
{
    schemesCase box(distortedBox(2, false));
    const fvMesh& mesh = box.mesh();
    const volVectorField U
    (
        fieldOf<vector>(mesh, linearVector, quadratic, "U")
    );
    const auto gradient = [](const point&) { return slopes; };

    const volVectorField copy("copy", U);
    EXPECT_LT(wallError(copy, gradient), 1e-10);

    U.write();
    volVectorField read
    (
        IOobject("U", mesh.time().timeName(), mesh, IOobject::MUST_READ), mesh
    );
    read.correctBoundaryConditions();
    EXPECT_EQ(read.boundaryField()[0].type(), quadratic);
    EXPECT_LT(wallError(read, gradient), 1e-10);
}


INSTANTIATE_TEST_SUITE_P(Dimensions, Schemes, testing::Values(2, 3));

// ************************************************************************* //
