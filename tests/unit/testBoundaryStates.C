/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "boundaryStates.H"
#include "particleScene.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Particle mesh of a scene
struct closedScene
{
    std::unique_ptr<particleScene> scene;
    std::unique_ptr<sceneParticles> particles;

    explicit closedScene(const word& name)
    :
        scene(particleScene::New(name, 0.3)),
        particles(scene->assemble("type consistent; order 0;"))
    {}
};


//- Fields of a weakly compressible flow, and their boundary states
struct flowStates
{
    volVectorField U;
    volScalarField p;
    surfaceScalarField phi;
    std::unique_ptr<boundaryStates> states;

    flowStates
    (
        const particleMesh& particles,
        const dictionary& UDict,
        const dictionary& pDict
    )
    :
        U(io("U", particles), particles.mesh(), UDict),
        p(io("p", particles), particles.mesh(), pDict),
        phi
        (
            io("phi", particles),
            particles.mesh(),
            dimensionedScalar(dimVolume/dimTime, Zero)
        )
    {
        std::vector<boundaryStates::scalarVariable> scalars;
        scalars.push_back({p, 0});
        states = std::make_unique<boundaryStates>
        (
            particles, U, scalars, phi, false
        );
    }

    static IOobject io(const word& name, const particleMesh& particles)
    {
        const fvMesh& mesh = particles.mesh();
        return IOobject(name, mesh.time().timeName(), mesh);
    }

    //- A field's dictionary from its text
    static dictionary dict
    (
        const std::string& dimensions,
        const std::string& value,
        const std::string& patches
    )
    {
        return dictionary
        (
            IStringStream
            (
                "dimensions " + dimensions + "; internalField uniform "
              + value + "; boundaryField { \".*\" { " + patches
              + " } frontAndBack { type empty; } }"
            )()
        );
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * //

TEST(BoundaryStates, SlipWallsAroundAnEdgeDoNotBlow)
{
    const closedScene scene("hole");

    for (const char* type : {"slip", "fixedNormalSlip"})
    {
        const flowStates flow
        (
            *scene.particles,
            flowStates::dict
            (
                "[0 1 -1 0 0 0 0]",
                "(3 0 0)",
                std::string("type ") + type
              + "; fixedValue uniform (0 0 0); value uniform (3 0 0);"
            ),
            flowStates::dict
            (
                "[0 2 -2 0 0 0 0]", "0", "type zeroGradient;"
            )
        );

        label nFaces = 0;
        for (const particlePatch& patch : scene.particles->boundary())
        {
            for
            (
                label facei = patch.start();
                facei < patch.start() + patch.size();
                ++facei
            )
            {
                ++nFaces;
                const vector n(flow.states->n()[facei]);
                ASSERT_EQ(flow.states->type(facei), faceStates::slip);
                EXPECT_EQ
                (
                    flow.states->value(1, facei)*n[0]
                  + flow.states->value(2, facei)*n[1],
                    0
                )   << type << ' ' << patch.name();
            }
        }
        EXPECT_GT(nFaces, 50);
    }
}


TEST(BoundaryStates, AGivenVelocityGivesTheFluxOfWhatFlowsIn)
{
    const closedScene scene("box");
    const auto type = [&](const char* U, const char* p)
    {
        const flowStates flow
        (
            *scene.particles,
            flowStates::dict("[0 1 -1 0 0 0 0]", "(1 0 0)", U),
            flowStates::dict("[0 2 -2 0 0 0 0]", "0", p)
        );
        return flow.states->type(0);
    };
    const char* fixed = "type fixedValue; value $internalField;";
    const char* own = "type zeroGradient;";

    EXPECT_EQ(type(fixed, own), faceStates::given);
    EXPECT_EQ(type(fixed, fixed), faceStates::given);
    EXPECT_EQ(type(own, fixed), faceStates::open);
    EXPECT_EQ
    (
        type
        (
            "type pressureInletVelocity; value uniform (0 0 0);",
            "type totalPressure; p0 uniform 1; value uniform 0;"
        ),
        faceStates::open
    );
}


TEST(BoundaryStates, ConditionsGetTheTimeOfTheStage)
{
    const closedScene scene("box");
    const flowStates flow
    (
        *scene.particles,
        flowStates::dict("[0 1 -1 0 0 0 0]", "(0 0 0)", "type zeroGradient;"),
        flowStates::dict
        (
            "[0 2 -2 0 0 0 0]",
            "0",
            "type uniformFixedValue; uniformValue table ((0 0) (10 20));"
        )
    );

    Time& time = const_cast<Time&>(scene.particles->mesh().time());
    time.setTime(5, 1);
    const slicedField W(3, slicedField::slices(scene.particles->nParticles()));

    for (const scalar timeLeft : {0.0, 0.5, 3.0})
    {
        flow.states->correct(W, timeLeft);
        for (label facei = 0; facei < flow.states->size(); ++facei)
        {
            EXPECT_NEAR
            (
                flow.states->value(0, facei), 2*(5 - timeLeft), 1e-13
            );
        }
        EXPECT_EQ(time.value(), 5);
        EXPECT_EQ(time.timeIndex(), 1);
    }
}


// ************************************************************************* //
