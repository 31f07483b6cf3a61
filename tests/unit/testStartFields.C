/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    Fields of the FVM case on the particles at the start: values, and boundary
    conditions with their data.

\*---------------------------------------------------------------------------*/

#include "particleScene.H"
#include "IFstream.H"
#include "OSspecific.H"
#include "startFields.H"

#include <gtest/gtest.h>
#include <sstream>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A list of values as text
template<class Function>
std::string listOf(const label n, const Function& value)
{
    std::ostringstream os;
    os.precision(17);
    os << "nonuniform List<scalar> " << n << '(';
    for (label i = 0; i < n; ++i)
    {
        os << value(i) << ' ';
    }
    os << ')';
    return os.str();
}


//- A scene whose fields are mapped
class StartFields
:
    public testing::Test
{
protected:

    std::unique_ptr<particleScene> scene;

    std::unique_ptr<sceneParticles> particles;

    void make(const char* name)
    {
        scene = particleScene::New(name, 0.3);
        particles = scene->assemble("order 1;");
    }

    void writeScalar
    (
        const word& name,
        const std::string& internal,
        const std::string& patches = "\".*\" { type zeroGradient; }",
        const std::string& dimensions = "[0 0 0 0 0 0 0]"
    )
    {
        scene->files().write
        (
            "0/" + name,
            "dimensions " + dimensions + "; internalField " + internal
          + "; boundaryField { " + patches
          + " frontAndBack { type empty; } }",
            "volScalarField"
        );
    }

    void writeVelocity(const std::string& patches)
    {
        scene->files().write
        (
            "0/U",
            "dimensions [0 1 -1 0 0 0 0]; internalField uniform (1 2 0);"
            "boundaryField { " + patches
          + " frontAndBack { type empty; } }",
            "volVectorField"
        );
    }

    void map()
    {
        startFields(scene->mesh(), particles->sph()).write();
    }

    //- A mapped field as a solver reads it
    template<class Type>
    GeometricField<Type, fvPatchField, volMesh> read(const word& name)
    {
        const fvMesh& mesh = particles->mesh();
        return GeometricField<Type, fvPatchField, volMesh>
        (
            IOobject
            (
                name,
                mesh.time().timeName(),
                mesh,
                IOobject::MUST_READ,
                IOobject::NO_WRITE,
                false
            ),
            mesh
        );
    }

    //- The file of a mapped field
    fileName file(const word& name) const
    {
        return scene->files().path()/"sph"/"0"/name;
    }

    //- The entries of a patch in the file
    dictionary patchDict(const word& field, const word& patch) const
    {
        IFstream is(file(field), IOstream::BINARY);
        return dictionary(is).subDict("boundaryField").subDict(patch);
    }

    labelList fvmFaces(const word& patch) const
    {
        return particles->fvmFaces
        (
            particles->boundary()
            [
                particles->mesh().boundaryMesh().findPatchID(patch)
            ]
        );
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * *  Values * * * * * * * * * * * * * * * * //

TEST_F(StartFields, uniformStaysUniform)
{
    make("hole");
    const scalar value = 0.1 + 1.0/3.0;
    std::ostringstream os;
    os.precision(17);
    os << "uniform " << value;
    writeScalar("p", os.str());
    map();

    const volScalarField p(read<scalar>("p"));
    EXPECT_EQ(min(p.primitiveField()), max(p.primitiveField()));
    EXPECT_NEAR(p[0], value, 1e-11);
}


TEST_F(StartFields, linearFieldsAreExactInside)
{
    make("hole");
    const auto f = [](const point& x)
    {
        return 10 + 0.2*x.x() - 0.1*x.y();
    };
    const pointField& C = scene->mesh().cellCentres();
    writeScalar
    (
        "p", listOf(C.size(), [&](const label i) { return f(C[i]); })
    );
    map();

    const volScalarField p(read<scalar>("p"));
    label nInside = 0;
    forAll(p, i)
    {
        // Further from the surface than half a cell there are centres around
        if (scene->fluid().distance(particles->C()[i]) < -0.06)
        {
            EXPECT_NEAR(p[i], f(particles->C()[i]), 1e-9);
            ++nInside;
        }
    }
    EXPECT_GT(nInside, 150);
}


TEST_F(StartFields, fieldsInConstantAreMappedToo)
{
    make("box");
    const auto f = [](const point& x) { return 1 + x.x(); };
    const pointField& C = scene->mesh().cellCentres();
    scene->files().write
    (
        "constant/h0",
        "dimensions [0 1 0 0 0 0 0]; internalField "
      + listOf(C.size(), [&](const label i) { return f(C[i]); })
      + "; boundaryField { \".*\" { type zeroGradient; }"
        " frontAndBack { type empty; } }",
        "volScalarField"
    );
    particles->sph().writeDictionaries();
    EXPECT_FALSE(exists(scene->files().path()/"sph"/"constant"/"h0"));
    map();

    const fvMesh& mesh = particles->mesh();
    const volScalarField h0
    (
        IOobject
        (
            "h0",
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh
    );
    forAll(h0, i)
    {
        // Beside the walls, where there are no cells around, bounded
        EXPECT_NEAR(h0[i], f(particles->C()[i]), 0.05);
    }
}


TEST_F(StartFields, aJumpIsNotSmeared)
{
    make("box");
    const pointField& C = scene->mesh().cellCentres();
    writeScalar
    (
        "alpha",
        listOf(C.size(), [&](const label i) { return C[i].x() < 0.4; })
    );
    writeScalar
    (
        "T",
        listOf(C.size(), [&](const label i) { return C[i].x() < 0.4 ? 10 : 1; })
    );
    map();

    const volScalarField alpha(read<scalar>("alpha"));
    const volScalarField T(read<scalar>("T"));
    forAll(alpha, i)
    {
        // The cells' sides are at 0.375. A tenth of the jump, or of a positive
        // value, is none
        const bool left = particles->C()[i].x() < 0.375;
        EXPECT_NEAR(alpha[i], left, 0.1);
        EXPECT_GE(alpha[i], 0);
        EXPECT_LE(alpha[i], 1);
        EXPECT_NEAR(T[i], left ? 10 : 1, left ? 1 : 0.1);
        if (mag(particles->C()[i].x() - 0.375) > 0.25)
        {
            EXPECT_EQ(alpha[i], scalar(left));
        }
    }
}


// * * * * * * * * * * * * *  Boundary conditions  * * * * * * * * * * * * * //

TEST_F(StartFields, givenValuesGoToThePartsOfTheirFaces)
{
    make("box");
    const label left = scene->mesh().boundaryMesh().findPatchID("left");
    const label nFaces = scene->mesh().boundary()[left].size();
    const std::string ramp
    (
        listOf(nFaces, [](const label facei) { return 3 + 0.5*facei; })
    );
    writeScalar
    (
        "p",
        "uniform 7",
        "left { type fixedValue; value " + ramp + "; }"
        "right { type inletOutlet; inletValue " + ramp + "; value " + ramp
      + "; }"
        "bottom { type zeroGradient; }"
        "top { type mixed; refValue uniform 2; refGradient uniform 0;"
        " valueFraction " + ramp + "; value " + ramp + "; }"
    );
    map();

    const volScalarField p(read<scalar>("p"));
    const char* types[] =
        {"fixedValue", "inletOutlet", "zeroGradient", "mixed"};
    for (label patchi = 0; patchi < 4; ++patchi)
    {
        EXPECT_EQ(p.boundaryField()[patchi].type(), types[patchi]);
    }

    const auto check = [&](const word& patch, const word& entry)
    {
        const labelList face(fvmFaces(patch));
        const scalarField values
        (
            entry, patchDict("p", patch), face.size()
        );
        forAll(values, k)
        {
            EXPECT_NEAR(values[k], 3 + 0.5*face[k], 1e-11)
                << patch << ' ' << entry;
        }
        EXPECT_EQ(max(face), nFaces - 1);
    };
    check("left", "value");
    check("right", "inletValue");
    check("top", "valueFraction");
}


TEST_F(StartFields, everyConditionComesAlong)
{
    make("channel");
    const std::string cyclic
    (
        "left { type cyclic; } right { type cyclic; }"
    );
    writeVelocity
    (
        cyclic
      + "bottom { type flowRateInletVelocity; volumetricFlowRate constant 0.3;"
        " value uniform (0 0 0); }"
        "top { type pressureInletOutletVelocity; value uniform (0 0 0); }"
    );
    writeScalar
    (
        "p",
        "uniform 1",
        cyclic
      + "bottom { type fixedFluxPressure; gradient uniform 0;"
        " value uniform 1; }"
        "top { type totalPressure; p0 uniform 5; value uniform 1; }",
        "[0 2 -2 0 0 0 0]"
    );
    writeScalar
    (
        "s",
        "uniform 1",
        cyclic
      + "bottom { type uniformFixedValue;"
        " uniformValue table ((0 1) (10 2)); }"
        "top { type advective; phi flow; value uniform 1; }"
    );
    map();

    const volVectorField U(read<vector>("U"));
    EXPECT_EQ(U.boundaryField()[0].type(), "cyclic");
    EXPECT_EQ(U.boundaryField()[2].type(), "flowRateInletVelocity");
    EXPECT_EQ(U.boundaryField()[3].type(), "pressureInletOutletVelocity");
    EXPECT_EQ(max(mag(U.primitiveField() - vector(1, 2, 0))), 0);
    EXPECT_EQ
    (
        patchDict("U", "bottom").get<word>("type"), "flowRateInletVelocity"
    );

    // The rate is that of the particles' patch
    volVectorField V(U);
    V.boundaryFieldRef()[2].updateCoeffs();
    const fvPatch& bottom = particles->mesh().boundary()[2];
    EXPECT_NEAR
    (
        gSum(V.boundaryField()[2] & bottom.Sf()), -0.3, 1e-13
    );

    const volScalarField p(read<scalar>("p"));
    EXPECT_EQ(p.boundaryField()[2].type(), "fixedFluxPressure");
    EXPECT_EQ(p.boundaryField()[3].type(), "totalPressure");
    EXPECT_EQ
    (
        scalarField("p0", patchDict("p", "top"), fvmFaces("top").size())[0], 5
    );

    const volScalarField s(read<scalar>("s"));
    EXPECT_EQ(s.boundaryField()[2].type(), "uniformFixedValue");
    EXPECT_EQ(s.boundaryField()[3].type(), "advective");
    EXPECT_EQ(patchDict("s", "top").get<word>("phi"), "flow");
}


TEST_F(StartFields, cornerPatchesOfTwoPeriodsAreCyclic)
{
    make("periodic");
    writeScalar("p", "uniform 1", "\".*\" { type cyclic; }");
    map();

    const volScalarField p(read<scalar>("p"));
    EXPECT_EQ(p.boundaryField().size(), scene->mesh().boundary().size() + 4);
    for (label patchi = 5; patchi < p.boundaryField().size(); ++patchi)
    {
        EXPECT_EQ(p.boundaryField()[patchi].type(), "cyclic");
    }
}


TEST_F(StartFields, laminarWallsGetTheGradientOfSecondOrder)
{
    make("hole");
    const std::string conditions
    (
        "\"(left|right|bottom|top)\" { type fixedValue; value uniform "
    );
    writeVelocity
    (
        conditions + "(1 0 0); } hole { type noSlip; }"
    );
    writeScalar
    (
        "T",
        "uniform 300",
        conditions + "300; } hole { type fixedValue; value uniform 350; }",
        "[0 0 0 1 0 0 0]"
    );
    writeScalar
    (
        "q", "uniform 1", conditions + "1; } hole { type fixedValue;"
        " value uniform 2; }"
    );
    map();

    EXPECT_EQ(patchDict("U", "hole").get<word>("type"), "quadraticFixedValue");
    EXPECT_EQ(patchDict("T", "hole").get<word>("type"), "quadraticFixedValue");
    EXPECT_EQ(patchDict("q", "hole").get<word>("type"), "fixedValue");
    EXPECT_EQ(patchDict("U", "left").get<word>("type"), "fixedValue");

    const label hole = scene->mesh().boundaryMesh().findPatchID("hole");
    const volScalarField T(read<scalar>("T"));
    EXPECT_EQ(min(T.boundaryField()[hole]), 350);
    EXPECT_EQ(max(T.boundaryField()[hole]), 350);
    const volVectorField U(read<vector>("U"));
    EXPECT_EQ(gMax(mag(U.boundaryField()[hole])), 0);

    // Wall functions take the gradient themselves
    scene->files().write
    (
        "constant/turbulenceProperties", "simulationType RAS;"
    );
    map();
    EXPECT_EQ(patchDict("U", "hole").get<word>("type"), "noSlip");
    EXPECT_EQ(patchDict("T", "hole").get<word>("type"), "fixedValue");
}


TEST_F(StartFields, whatTheUserHasEditedIsKept)
{
    make("box");
    writeScalar("p", "uniform 1");
    writeScalar("s", "uniform 1");
    writeScalar("p.sph", "uniform 1");
    map();
    EXPECT_FALSE(exists(file("p.sph"))) << "a result of particles";

    scene->files().write
    (
        "sph/0/p",
        "dimensions [0 0 0 0 0 0 0]; internalField uniform 9; boundaryField"
        " { \".*\" { type zeroGradient; } frontAndBack { type empty; } }",
        "volScalarField"
    );
    writeScalar("p", "uniform 2");
    writeScalar("s", "uniform 2");
    map();
    EXPECT_EQ(read<scalar>("p")[0], 9);
    EXPECT_EQ(read<scalar>("s")[0], 2);

    rm(file("p"));
    map();
    EXPECT_EQ(read<scalar>("p")[0], 2);
}


// ************************************************************************* //
