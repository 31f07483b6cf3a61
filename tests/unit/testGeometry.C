/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    The boundary of a mesh as a closed oriented surface, against the mesh's
    own face areas and volumes.

\*---------------------------------------------------------------------------*/

#include "patchSurface.H"
#include "surfaceDistance.H"
#include "surfaceShapes.H"
#include "testCase.H"
#include "emptyPolyPatch.H"
#include "volFields.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Largest deviation of the elements of a face from its area vector
scalar areaError(const patchSurface& surface)
{
    scalar error = 0;

    for (const polyPatch& pp : surface.mesh().boundaryMesh())
    {
        if (isA<emptyPolyPatch>(pp))
        {
            continue;
        }

        vectorField sum(pp.faceAreas());
        const labelList elements
        (
            surface.patchElements(labelList(1, pp.index()))
        );
        for (const label elementi : elements)
        {
            sum[surface.elements()[elementi].facei] -=
                surface.areaVector(elementi);
        }

        error = max(error, max(mag(sum)/mag(pp.faceAreas())));
    }

    return error;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * patchSurface  * * * * * * * * * * * * * * //

TEST(PatchSurface, squareIsOneLoopOnTheMidPlane)
{
    testCase square(testCase::layout{});
    const patchSurface surface(square.mesh(), solutionSpace(square.mesh()));

    label nParts;
    surface.parts(nParts);

    EXPECT_EQ(surface.size(), 32);
    EXPECT_EQ(surface.points().size(), 32);
    EXPECT_EQ(nParts, 1);
    EXPECT_TRUE(surface.openElements().empty());
    EXPECT_LT(areaError(surface), 1e-14);
    EXPECT_NEAR(surface.volume(), 0.1, 1e-15);
    EXPECT_NEAR(surface.bounds().min().z(), 0.05, 1e-16);
    EXPECT_NEAR(surface.bounds().max().z(), 0.05, 1e-16);
}


TEST(PatchSurface, planesOfAnyOrientationAreAlike)
{
    for (const label shift : {1, 2})
    {
        testCase::layout layout;
        layout.hole = boundBox(point(0.3, 0.3, -1), point(0.6, 0.6, 1));
        layout.transform = [=](const point& p)
        {
            return point(p[shift], p[(shift + 1) % 3], p[(shift + 2) % 3]);
        };

        testCase turned(layout);
        const solutionSpace space(turned.mesh());
        const patchSurface surface(turned.mesh(), space);

        EXPECT_EQ(space.nDims(), 2);
        EXPECT_LT(areaError(surface), 1e-14);
        EXPECT_NEAR(surface.volume(), gSum(turned.mesh().V()), 1e-15);

        const surfaceDistance distance(surface);
        for (const point& c : turned.mesh().cellCentres())
        {
            EXPECT_LT(distance.find(c).distance, 0);
        }
    }
}


TEST(PatchSurface, warpedFacesKeepTheirAreaVectors)
{
    testCase::layout layout;
    layout.nCells = labelVector(4, 5, 3);
    layout.twoD = false;
    layout.hole = boundBox(point(0.3, 0.3, -1), point(0.6, 0.6, 1));
    layout.transform = [](const point& p)
    {
        return point(p.x() + 0.3*p.y()*p.z(), p.y() - 0.2*p.x()*p.z(), p.z());
    };

    testCase box(layout);
    const patchSurface surface(box.mesh(), solutionSpace(box.mesh()));

    EXPECT_TRUE(surface.openElements().empty());
    EXPECT_LT(areaError(surface), 1e-14);
}


TEST(PatchSurface, planeFacesOfABoxGiveItsVolume)
{
    testCase::layout layout;
    layout.nCells = labelVector(4, 5, 4);
    layout.box = boundBox(point(10, 20, 30), point(11, 22, 33));
    layout.twoD = false;
    layout.hole = boundBox(point(10.3, 20.3, 30.5), point(10.7, 21.7, 32.4));

    testCase box(layout);
    const patchSurface surface(box.mesh(), solutionSpace(box.mesh()));

    label nParts;
    surface.parts(nParts);

    EXPECT_EQ(nParts, 2);
    EXPECT_NEAR(surface.volume()/gSum(box.mesh().V()), 1, 1e-13);
}


TEST(PatchSurface, oneDimensionIsTwoPoints)
{
    testCase::layout layout;
    layout.nCells = labelVector(8, 1, 1);
    layout.patchTypes.set("bottom", "empty");
    layout.patchTypes.set("top", "empty");

    testCase line(layout);
    const solutionSpace space(line.mesh());
    const patchSurface surface(line.mesh(), space);
    const surfaceDistance distance(surface);

    EXPECT_EQ(space.nDims(), 1);
    EXPECT_EQ(surface.size(), 2);
    EXPECT_TRUE(surface.openElements().empty());
    EXPECT_LT(areaError(surface), 1e-15);
    EXPECT_NEAR(surface.volume(), 0.1, 1e-15);

    EXPECT_NEAR(distance.find(point(0.2, 5, 7)).distance, -0.2, 1e-15);
    EXPECT_NEAR(distance.find(point(0.9, 0, 0)).distance, -0.1, 1e-15);
    EXPECT_NEAR(distance.find(point(1.5, 0, 0)).distance, 0.5, 1e-15);
    EXPECT_NEAR(distance.find(point(-1, 0, 0)).normal.x(), -1, 1e-15);
}


TEST(PatchSurface, meshThatIsNotExtrudedIsRefused)
{
    testCase::layout oneEmptySide;
    oneEmptySide.twoD = false;
    oneEmptySide.patchTypes.set("top", "empty");

    testCase::layout tapered;
    tapered.transform = [](const point& p)
    {
        return point(p.x(), p.y(), p.z()*(1 + p.x()));
    };

    testCase::layout oblique;
    oblique.transform = [](const point& p)
    {
        return point(p.x() + p.z(), p.y(), p.z());
    };

    for (const auto& layout : {oneEmptySide, tapered, oblique})
    {
        testCase c(layout);
        const std::string message
        (
            errorMessage
            (
                [&]{ patchSurface(c.mesh(), solutionSpace(c.mesh())); }
            )
        );
        EXPECT_NE(message.find("not one layer of cells"), std::string::npos)
            << message;
        EXPECT_NE(message.find(c.path()), std::string::npos) << message;
    }
}


TEST(PatchSurface, periodicDistancesRepeat)
{
    testCase::layout layout;
    layout.nCells = labelVector(20, 20, 1);
    layout.box = boundBox(point(0, 0, 0), point(2, 1, 0.1));

    // A hole near the cyclic plane
    layout.hole = boundBox(point(0.1, 0.3, -1), point(0.3, 0.5, 1));

    layout.periodic[0] = true;

    testCase channel(layout);
    const fvMesh& mesh = channel.mesh();
    const patchSurface surface(mesh, solutionSpace(mesh));
    const surfaceDistance distance(surface, 0.5);

    ASSERT_EQ(surface.periods().size(), 1);
    EXPECT_NEAR(mag(surface.periods()[0]), 2, 1e-14);

    for (const scalar y : {0.02, 0.29, 0.4, 0.51, 0.9})
    {
        for (const scalar x : {-0.27, -0.1, -1e-9, 1e-9, 0.05, 0.22})
        {
            const auto here = distance.find(point(x, y, 0.05));
            const auto there = distance.find(point(x + 2, y, 0.05));
            EXPECT_NEAR(here.distance, there.distance, 1e-14) << x << ' ' << y;
            EXPECT_NEAR(mag(here.normal - there.normal), 0, 1e-9);
        }
    }

    // The cyclic plane is no boundary, but closes the region
    EXPECT_NEAR(distance.find(point(-0.05, 0.15, 0)).distance, -0.15, 1e-14);
    EXPECT_NEAR(distance.find(point(1.99, 0.8, 0)).distance, -0.2, 1e-14);
    EXPECT_FALSE(distance.inside(point(-0.05, 0.15, 0)));
    EXPECT_TRUE(distance.inside(point(0.05, 0.15, 0)));
    EXPECT_TRUE(distance.inside(point(1.99, 0.8, 0)));
    EXPECT_FALSE(distance.inside(point(2.01, 0.8, 0)));
    EXPECT_FALSE(distance.inside(point(0.2, 0.4, 0)));

    // The image of the hole is nearer than anything in the region
    EXPECT_NEAR(distance.find(point(1.95, 0.4, 0)).distance, -0.15, 1e-14);
}


// ************************************************************************* //
