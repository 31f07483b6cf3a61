/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    The meshes that the other tests stand on are what they claim to be.

\*---------------------------------------------------------------------------*/

#include "testCase.H"
#include "volFields.H"
#include "wallPolyPatch.H"

#include <gtest/gtest.h>

using namespace Foam;
using SPH::testCase;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST(TestCase, squareHasTheVolumeAndPatchesOfItsBox)
{
    testCase square(testCase::layout{});
    const fvMesh& mesh = square.mesh();

    EXPECT_FALSE(mesh.checkMesh(false));
    EXPECT_EQ(mesh.nSolutionD(), 2);
    EXPECT_EQ(mesh.nCells(), 64);
    EXPECT_NEAR(gSum(mesh.V()), 0.1, 1e-15);
    EXPECT_EQ
    (
        mesh.boundaryMesh().names(),
        wordList({"left", "right", "bottom", "top", "frontAndBack"})
    );

    const vectorField Sf(mesh.boundary()["top"].Sf());
    EXPECT_NEAR(mag(sum(Sf) - vector(0, 0.1, 0)), 0, 1e-15);
}


TEST(TestCase, holeIsAWallThatClosesTheMesh)
{
    testCase::layout layout;
    layout.nCells = labelVector(6, 8, 10);
    layout.box = boundBox(point(-1, -1, -1), point(1, 2, 3));
    layout.twoD = false;
    layout.hole = boundBox(point(-0.4, 0, 0), point(0.4, 1, 1));

    testCase box(layout);
    const fvMesh& mesh = box.mesh();
    const polyPatch& hole = mesh.boundaryMesh()["hole"];

    EXPECT_FALSE(mesh.checkMesh(false));
    EXPECT_EQ(mesh.nSolutionD(), 3);
    EXPECT_TRUE(isA<wallPolyPatch>(hole));
    EXPECT_NEAR(mag(sum(hole.faceAreas())), 0, 1e-14);

    // The centres of 2 x 3 x 2 cells of 1/3 x 3/8 x 2/5 are in the hole
    EXPECT_EQ(mesh.nCells(), 6*8*10 - 12);
    EXPECT_NEAR(gSum(mesh.V()), 24 - 12*(1.0/3)*(3.0/8)*(2.0/5), 1e-12);
}


TEST(TestCase, takesPatchTypesAndATransformation)
{
    testCase::layout layout;
    layout.patchTypes.set("top", "symmetryPlane");
    layout.transform = [](const point& p)
    {
        return point(p.x() + 0.5*p.y(), 2*p.y(), p.z());
    };

    testCase sheared(layout);
    const fvMesh& mesh = sheared.mesh();

    EXPECT_FALSE(mesh.checkMesh(false));
    EXPECT_EQ(mesh.boundaryMesh()["top"].type(), "symmetryPlane");
    EXPECT_NEAR(gSum(mesh.V()), 0.2, 1e-15);
}


TEST(TestCase, errorMessageNamesFileAndEntry)
{
    testCase square(testCase::layout{});
    square.write("system/sphMeshDict", "spacing 0.1;");

    const IOdictionary dict
    (
        IOobject
        (
            "sphMeshDict",
            square.time().system(),
            square.time(),
            IOobject::MUST_READ
        )
    );

    EXPECT_EQ(SPH::errorMessage([&]{ dict.get<scalar>("spacing"); }), "");

    const std::string message
    (
        SPH::errorMessage([&]{ dict.get<scalar>("kernel"); })
    );
    EXPECT_NE(message.find("'kernel'"), std::string::npos) << message;
    EXPECT_NE(message.find("sphMeshDict"), std::string::npos) << message;
}


// ************************************************************************* //
