/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    Meshes that can have no particles: the error names the patch and what is
    supported.

\*---------------------------------------------------------------------------*/

#include "particleMesh.H"
#include "patchSurface.H"
#include "periodicImages.H"
#include "testCase.H"
#include "mathematicalConstants.H"
#include "polyMesh.H"
#include "volFields.H"

#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

void expectMessage
(
    const std::vector<std::string>& parts,
    const std::function<void()>& function
)
{
    const std::string message(errorMessage(function));
    for (const std::string& part : parts)
    {
        EXPECT_NE(message.find(part), std::string::npos)
            << "no '" << part << "' in: " << message;
    }
}


//- Give a patch another type on disk, with the entries that this needs
void setType(testCase& c, const std::string& patch, const std::string& type)
{
    const fileName file(c.path()/"constant"/"polyMesh"/"boundary");
    std::ostringstream os;
    os << std::ifstream(file).rdbuf();
    std::string text(os.str());

    const auto entry = text.find("type", text.find("    " + patch + '\n'));
    ASSERT_NE(entry, std::string::npos);
    text.replace(entry, text.find(';', entry) - entry, "type " + type);
    std::ofstream(file) << text;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * //

TEST(RefusedMesh, wedge)
{
    testCase::layout layout;
    layout.twoD = false;
    layout.box = boundBox(point(0, 1, -0.05), point(1, 2, 0.05));
    layout.transform = [](const point& p)
    {
        return point(p.x(), p.y(), p.z()*p.y());
    };
    layout.patchTypes.set("back", "wedge");
    layout.patchTypes.set("front", "wedge");
    testCase c(layout);

    expectMessage
    (
        {"Patch back", c.path()/"constant", "wedge", "empty patches"},
        [&]{ solutionSpace(c.mesh()); }
    );
}


TEST(RefusedMesh, withoutCells)
{
    testCase::layout layout;
    layout.hole = boundBox(-point::one, 2*point::one);
    testCase c(layout);

    expectMessage
    (
        {c.path()/"constant"/"polyMesh", "has no cells"},
        [&]{ solutionSpace(c.mesh()); }
    );
}


TEST(RefusedMesh, emptyInAllDirections)
{
    testCase::layout layout;
    for (const char* name : {"left", "right", "bottom", "top"})
    {
        layout.patchTypes.set(name, "empty");
    }
    testCase c(layout);

    expectMessage
    (
        {c.path()/"constant", "boundary", "All directions"},
        [&]{ solutionSpace(c.mesh()); }
    );
}


TEST(RefusedMesh, onePartOfADecomposedOne)
{
    testCase c(testCase::layout{});
    setType(c, "left", "processor; myProcNo 0; neighbProcNo 1");
    c.reopen();

    expectMessage
    (
        {"Patch left", "processor patch", "decomposePar -case sph"},
        [&]{ patchSurface(c.mesh(), solutionSpace(c.mesh())); }
    );
}


TEST(RefusedMesh, cyclicByRotation)
{
    testCase::layout layout;
    layout.periodic[0] = true;
    layout.transform = [](const point& p)
    {
        const scalar angle = 0.5*constant::mathematical::pi*p.x();
        const scalar r = 1 + p.y();
        return point(-r*std::cos(angle), r*std::sin(angle), p.z());
    };
    testCase c(layout);

    expectMessage
    (
        {"patches left and right", "not a translation", "translational"},
        [&]{ patchSurface(c.mesh(), solutionSpace(c.mesh())); }
    );
    expectMessage
    (
        {"patches left and right", "boundary", "not a translation"},
        [&]{ periodicTranslations(c.mesh()); }
    );
}


TEST(RefusedMesh, boundaryWithAGap)
{
    testCase c(testCase::layout{});
    const polyMesh& whole = c.mesh();

    // A face of the left patch with points of its own
    pointField points(whole.points());
    faceList faces(whole.faces());
    for (label& pointi : faces[whole.boundaryMesh()["left"].start()])
    {
        const point p(points[pointi]);
        pointi = points.size();
        points.append(p);
    }

    polyMesh open
    (
        IOobject
        (
            "open", c.time().constant(), c.time(), IOobject::NO_READ,
            IOobject::NO_WRITE, false
        ),
        std::move(points),
        std::move(faces),
        labelList(whole.faceOwner()),
        labelList(whole.faceNeighbour())
    );
    List<polyPatch*> patches;
    for (const polyPatch& pp : whole.boundaryMesh())
    {
        patches.append(pp.clone(open.boundaryMesh()).ptr());
    }
    open.addPatches(patches);

    expectMessage
    (
        {"not a closed surface", "left", "checkMesh"},
        [&]{ patchSurface(open, solutionSpace(open)); }
    );
}


// ************************************************************************* //
