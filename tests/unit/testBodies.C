/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    Solid bodies from patches and from surface files, and the messages for
    bodies that cannot be.

\*---------------------------------------------------------------------------*/

#include "fileSurface.H"
#include "particleZone.H"
#include "patchSurface.H"
#include "solidBodies.H"
#include "spacingFunction.H"
#include "surfaceShapes.H"
#include "testCase.H"

#include "IStringStream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "volFields.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

dictionary dict(const std::string& content)
{
    return dictionary(IStringStream(content)());
}


//- A square or box with a hole of known size
testCase::layout withHole(const bool twoD)
{
    testCase::layout layout;
    layout.nCells = labelVector(10, 10, twoD ? 1 : 10);
    layout.box = boundBox(point::zero, point(1, 1, twoD ? 0.1 : 1));
    layout.twoD = twoD;
    layout.hole = boundBox(point(0.4, 0.4, twoD ? -1 : 0.4), 0.7*point::one);
    return layout;
}


//- Write a surface as STL to constant/triSurface, without some triangles
void writeSTL
(
    const testCase& c,
    const word& name,
    const orientedSurface& surface,
    const label nMissing = 0,
    const bool reverse = false
)
{
    mkDir(c.path()/"constant/triSurface");
    OFstream os(c.path()/"constant/triSurface"/name);

    os  << "solid s" << nl;
    for (label i = nMissing; i < surface.size(); ++i)
    {
        os  << "facet normal 0 0 0" << nl << "outer loop" << nl;
        for (label k = 0; k < 3; ++k)
        {
            const label v = surface.elements()[i].vertices[reverse ? 2 - k : k];
            const point& p = surface.points()[v];
            os  << "vertex " << p.x() << ' ' << p.y() << ' ' << p.z() << nl;
        }
        os  << "endloop" << nl << "endfacet" << nl;
    }
    os  << "endsolid s" << nl;
}


void expectMessage
(
    const std::function<void()>& function,
    const std::vector<std::string>& words
)
{
    const std::string message(errorMessage(function));
    for (const std::string& word : words)
    {
        EXPECT_NE(message.find(word), std::string::npos)
            << "no '" << word << "' in: " << message;
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * From patches  * * * * * * * * * * * * * * //

TEST(SolidBodies, everyClosedWallIsABody)
{
    for (const bool twoD : {true, false})
    {
        testCase c(withHole(twoD));
        const solutionSpace space(c.mesh());
        const patchSurface surface(c.mesh(), space);
        const solidBodies bodies(surface, dict(""), 1.3);

        ASSERT_EQ(bodies.size(), 1);
        EXPECT_EQ(bodies[0].name(), "hole");
        EXPECT_EQ
        (
            bodies[0].patches(),
            labelList(1, c.mesh().boundaryMesh().findPatchID("hole"))
        );
        EXPECT_DOUBLE_EQ(bodies[0].smoothingRatio(), 1.3);
        EXPECT_NEAR
        (
            bodies[0].surface().volume(),
            0.3*0.3*(twoD ? 0.1 : 0.3),
            1e-14
        );

        // The solid is on the other side of the fluid's surface
        const surfaceDistance fluid(surface);
        const point inSolid(0.5, 0.45, twoD ? 0 : 0.5);
        EXPECT_NEAR(bodies[0].distance().distance(inSolid), -0.05, 1e-14);
        EXPECT_NEAR(fluid.distance(inSolid), 0.05, 1e-14);

        for (const point& x : c.mesh().cellCentres())
        {
            EXPECT_GT(bodies[0].distance().distance(x), 0);
        }
    }
}


TEST(SolidBodies, wallsAroundTheFluidAreNoBody)
{
    testCase::layout layout(withHole(true));
    for (const char* name : {"left", "right", "bottom", "top"})
    {
        layout.patchTypes.set(name, "wall");
    }

    testCase cavity(layout);
    const patchSurface surface(cavity.mesh(), solutionSpace(cavity.mesh()));

    EXPECT_EQ(solidBodies(surface, dict(""), 1.3).size(), 1);
}


TEST(SolidBodies, namedPatchesAndTheirErrors)
{
    testCase c(withHole(true));
    const patchSurface surface(c.mesh(), solutionSpace(c.mesh()));

    const auto bodies = [&](const std::string& content)
    {
        return solidBodies
        (
            surface,
            dict("bodies { block { " + content + " } }"),
            1.3
        );
    };

    const solidBodies block(bodies("patches (\"ho.*\"); smoothingRatio 1.05;"));
    ASSERT_EQ(block.size(), 1);
    EXPECT_EQ(block[0].name(), "block");
    EXPECT_DOUBLE_EQ(block[0].smoothingRatio(), 1.05);

    expectMessage
    (
        [&]{ bodies("patches (hoel);"); },
        {"block", "hoel", "left right bottom top hole"}
    );
    expectMessage
    (
        [&]{ bodies("patches (hole left);"); },
        {"block", "not a closed surface", "1(left)", "top"}
    );
    expectMessage
    (
        [&]{ bodies("patches (left right top bottom);"); },
        {"block", "encloses the fluid"}
    );
    expectMessage([&]{ bodies(""); }, {"block", "'patches' and 'surface'"});
    expectMessage
    (
        [&]{ solidBodies(surface, dict("bodies { block 3; }"), 1.3); },
        {"Entry block", "not a dictionary", "left right bottom top hole"}
    );
    expectMessage
    (
        [&]{ bodies("patches (hole); smoothingRatio -1;"); },
        {"block", "smoothingRatio -1"}
    );
}


TEST(SolidBodies, surfaceFilesNeedTwoDimensions)
{
    testCase::layout layout;
    layout.nCells = labelVector(8, 1, 1);
    layout.patchTypes.set("bottom", "empty");
    layout.patchTypes.set("top", "empty");
    testCase c(layout);
    writeSTL(c, "s.stl", boxSurface(-0.1*point::one, 0.1*point::one, 2));
    const patchSurface surface(c.mesh(), solutionSpace(c.mesh()));

    expectMessage
    (
        [&]
        {
            solidBodies
            (
                surface, dict("bodies { block { surface \"s.stl\"; } }"), 1.3
            );
        },
        {"Body block", "s.stl", "one-dimensional", "entry patches"}
    );
}


TEST(SolidBodies, bodySmallerThanTheSpacingIsRefused)
{
    testCase c(withHole(true));
    const patchSurface surface(c.mesh(), solutionSpace(c.mesh()));
    const solidBodies bodies(surface, dict(""), 1.3);

    const auto check = [&](const std::string& spacing)
    {
        return errorMessage
        (
            [&]
            {
                bodies.checkSize
                (
                    *spacingFunction::New(surface, dict("spacing " + spacing))
                );
            }
        );
    };

    EXPECT_EQ(check("0.29;"), "");
    EXPECT_NE(check("0.31;").find("Body hole"), std::string::npos);
    EXPECT_NE(check("0.31;").find("0.31"), std::string::npos);
    EXPECT_EQ
    (
        check("{ type refined; base 1; near { hole { spacing 0.1; } } }"),
        ""
    );
}


// * * * * * * * * * * * * * * * * * From files  * * * * * * * * * * * * * * //

TEST(FileSurface, closedSurfaceIsTakenOutward)
{
    testCase box(withHole(false));
    testCase plane(withHole(true));
    const orientedSurface brick(boxSurface(-point::one, point(1, 2, 3), 2));

    for (const bool reverse : {false, true})
    {
        for (const testCase* c : {&box, &plane})
        {
            writeSTL(*c, "brick.stl", brick, 0, reverse);
        }

        const dictionary entry(dict("surface \"brick.stl\"; scale 0.5;"));

        const fileSurface solid
        (
            box.time(),
            solutionSpace(box.mesh()),
            entry
        );
        EXPECT_NEAR(solid.volume(), 2*3*4/8.0, 1e-14);

        // A 2-D case sees the cut with its mid-plane, 0.1 m thick
        const fileSurface cut
        (
            plane.time(),
            solutionSpace(plane.mesh()),
            entry
        );
        EXPECT_TRUE(cut.openElements().empty());
        EXPECT_NEAR(cut.volume(), 1*1.5*0.1, 1e-14);

        const surfaceDistance distance(cut);
        EXPECT_NEAR(distance.distance(point(0.4, 0, 9)), -0.1, 1e-14);
        EXPECT_NEAR(distance.distance(point(0, 1.2, 0)), 0.2, 1e-14);
    }
}


TEST(FileSurface, aPartWithinAnotherBoundsACavity)
{
    testCase c(withHole(false));
    const orientedSurface outer(boxSurface(-point::one, point::one, 2));
    const orientedSurface inner(boxSurface(-0.5*point::one, 0.5*point::one, 2));

    pointField points(outer.points());
    points.append(inner.points());
    List<orientedSurface::element> elements(outer.elements());
    for (orientedSurface::element e : inner.elements())
    {
        for (label& v : e.vertices)
        {
            v += outer.points().size();
        }
        elements.append(e);
    }
    writeSTL
    (
        c,
        "hollow.stl",
        orientedSurface
        (
            outer.space(), std::move(points), std::move(elements)
        )
    );

    const fileSurface hollow
    (
        c.time(), solutionSpace(c.mesh()), dict("surface \"hollow.stl\";")
    );
    EXPECT_NEAR(hollow.volume(), 8 - 1, 1e-12);
    EXPECT_NEAR(surfaceDistance(hollow).distance(point::zero), 0.5, 1e-12);
}


TEST(FileSurface, smallHolesAreRepairedAndLargeOnesRefused)
{
    testCase c(withHole(false));
    const solutionSpace space(c.mesh());

    // One of 6 x 2 x 100 triangles is missing
    const orientedSurface brick(boxSurface(-point::one, point::one, 10));
    writeSTL(c, "brick.stl", brick, 1);
    const fileSurface repaired(c.time(), space, dict("surface \"brick.stl\";"));
    EXPECT_TRUE(repaired.openElements().empty());
    EXPECT_NEAR(repaired.volume(), 8, 1e-12);

    // A whole side is missing
    writeSTL(c, "open.stl", brick, 200);
    expectMessage
    (
        [&]{ fileSurface(c.time(), space, dict("surface \"open.stl\";")); },
        {"open.stl", "not a closed surface", "maxHoleSize 0.1"}
    );
    const fileSurface filled
    (
        c.time(),
        space,
        dict("surface \"open.stl\"; maxHoleSize 1;")
    );
    EXPECT_NEAR(filled.volume(), 8, 1e-12);
}


TEST(FileSurface, missingFileNamesTheOthers)
{
    testCase c(withHole(false));
    writeSTL(c, "brick.stl", boxSurface(-point::one, point::one, 1));

    expectMessage
    (
        [&]
        {
            fileSurface
            (
                c.time(),
                solutionSpace(c.mesh()),
                dict("surface \"brik.stl\";")
            );
        },
        {"brik.stl", "constant/triSurface", "\"brick.stl\""}
    );
}


// * * * * * * * * * * * * * * * Cut out of meshes * * * * * * * * * * * * * //

TEST(CutBodies, meshHasThePatchAndTheVolumeThatIsLeft)
{
    for (const bool twoD : {true, false})
    {
        testCase::layout layout(withHole(twoD));
        layout.hole = boundBox();
        layout.nCells = labelVector(16, 16, twoD ? 1 : 16);
        testCase c(layout);
        const scalar low = twoD ? -1 : 0.375;
        const scalar high = twoD ? 1 : 0.625;
        writeSTL
        (
            c,
            "brick.stl",
            boxSurface(point(0.375, 0.375, low), point(0.5, 0.75, high), 3)
        );
        const scalar solid = 0.125*0.375*(twoD ? 0.1 : 0.25);
        const dictionary entries
        (
            dict("bodies { brick { surface \"brick.stl\"; } }")
        );

        for (const bool everywhere : {false, true})
        {
            dictionary withZone(entries);
            withZone.merge
            (
                dict
                (
                    everywhere
                  ? "zone { type boxToCell; box (-9 -9 -9) (9 9 9); }"
                  : "zone { type boxToCell; box (.1 .1 -9) (.9 .9 9); }"
                )
            );
            const particleZone zone(c.mesh(), withZone);
            const fvMesh& mesh = zone.mesh();
            EXPECT_EQ(zone.everywhere(), everywhere);

            scalar cells = 0;
            forAll(zone.inside(), celli)
            {
                cells += zone.inside()[celli]*c.mesh().V()[celli];
            }
            EXPECT_NEAR(gSum(mesh.V()), cells - solid, 1e-14);

            const patchSurface surface(mesh, solutionSpace(mesh));
            EXPECT_NEAR(surface.volume(), cells - solid, 1e-14);

            const label patchi = mesh.boundaryMesh().findPatchID("brick");
            ASSERT_EQ(patchi, c.mesh().boundaryMesh().size());
            const solidBodies bodies(surface, withZone, 1.3);
            ASSERT_EQ(bodies.size(), 1);
            EXPECT_EQ(bodies[0].patches(), labelList(1, patchi));
            EXPECT_NEAR(bodies[0].surface().volume(), solid, 1e-14);

            // Cells with their centres in the solid
            scalar inside = 0;
            for (const label celli : zone.bodies().cells())
            {
                inside += c.mesh().V()[celli];
            }
            EXPECT_NEAR(inside, solid, 1e-14);
        }
    }
}


TEST(CutBodies, withoutClosureNothingIsCut)
{
    testCase::layout layout(withHole(false));
    layout.hole = boundBox();
    testCase c(layout);
    writeSTL(c, "brick.stl", boxSurface(0.3*point::one, 0.6*point::one, 3));
    const dictionary entries
    (
        dict
        (
            "bodies { brick { surface \"brick.stl\"; } }"
            " closure { type none; }"
        )
    );

    const particleZone zone(c.mesh(), entries);
    EXPECT_EQ(&zone.mesh(), &c.mesh());
    EXPECT_EQ(zone.bodies().size(), 0);
}

// ************************************************************************* //
