/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    Quality measures of particle meshes of which they are known.

\*---------------------------------------------------------------------------*/

#include "particleScene.H"
#include "largestVoid.H"
#include "meshQuality.H"
#include "OSstream.H"

#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The hole of the scene 'hole' filled with a lattice
List<particleSet> filledHole()
{
    List<particleSet> solids(1);
    solids[0].name = "block";
    DynamicList<point> points;
    for (label j = 0; j < 4; ++j)
    {
        for (label i = 0; i < 6; ++i)
        {
            points.append(point(0.325 + 0.05*i, 0.425 + 0.05*j, 0.05));
        }
    }
    solids[0].points.transfer(points);
    solids[0].spacing = scalarField(solids[0].points.size(), 0.05);
    return solids;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST(MeshQuality, periodicLatticeIsPerfect)
{
    const auto scene = particleScene::New("periodic", 0);
    const auto m = scene->assemble("order 1;");
    const meshQuality quality
    (
        scene->mesh(), *m, List<particleSet>(), scene->fluid()
    );

    EXPECT_NEAR(quality.value("kernelGradientSumMax", "fluid"), 0, 1e-12);
    EXPECT_NEAR(quality.value("volume", "fluid"), 0, 1e-13);
    EXPECT_NEAR(quality.value("spacingMin", "fluid"), 1, 1e-12);
    EXPECT_NEAR(quality.value("spacingVoid", "fluid"), std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(quality.value("spacingRatioMin", "fluid"), 1, 1e-12);
    EXPECT_NEAR(quality.value("spacingRatioMax", "fluid"), 1, 1e-12);
    EXPECT_EQ(quality.value("flippedAreas", "pairs"), 0);

    std::ostringstream text;
    OSstream os(text, "report");
    EXPECT_EQ(quality.report(os), 0);
    EXPECT_NE(text.str().find("Particle mesh OK."), std::string::npos);
    EXPECT_EQ(text.str().find("***"), std::string::npos) << text.str();
}


TEST(MeshQuality, missingParticleIsAVoid)
{
    const auto scene = particleScene::New("periodic", 0);
    particleSet& particles = scene->particles();
    const label last = particles.points.size()/2 + 7;
    particles.points[last] = particles.points.last();
    particles.points.setSize(particles.points.size() - 1);
    particles.spacing.setSize(particles.points.size());

    const auto m = scene->assemble("type none;");
    const meshQuality quality
    (
        scene->mesh(), *m, List<particleSet>(), scene->fluid()
    );

    EXPECT_NEAR(quality.value("spacingVoid", "fluid"), 1, 1e-12);
    EXPECT_GT(quality.value("kernelGradientSumMax", "fluid"), 0.1);

    std::ostringstream text;
    OSstream os(text, "report");
    EXPECT_EQ(quality.report(os), 1);
    EXPECT_NE(text.str().find(" ***Max radius of a void"), std::string::npos)
        << text.str();
}


TEST(MeshQuality, movedParticleIsTooClose)
{
    const auto scene = particleScene::New("box", 0);
    point& p = scene->particles().points[210];
    p.x() += 0.7*0.05;

    const auto m = scene->assemble("order 0;");
    const meshQuality quality
    (
        scene->mesh(), *m, List<particleSet>(), scene->fluid()
    );

    EXPECT_NEAR(quality.value("spacingMin", "fluid"), 0.3, 1e-10);
    EXPECT_NEAR(quality.value("offSurfaceMax", "boundary"), 0, 1e-12);
    EXPECT_LT(quality.value("closureResidual", "fluid"), 1e-12);
    EXPECT_LT(quality.value("patchArea", "top"), 1e-12);
    EXPECT_GT(quality.value("linearResidualMax", "fluid"), 1e-3);
}


TEST(MeshQuality, solidsCompleteTheKernelAtTheInterface)
{
    // A lattice that goes on in the hole
    const auto scene = particleScene::New("hole", 0);
    const auto m = scene->assemble("order 1;");
    const meshQuality with
    (
        scene->mesh(), *m, filledHole(), scene->fluid()
    );
    const meshQuality without
    (
        scene->mesh(), *m, List<particleSet>(), scene->fluid()
    );

    EXPECT_NEAR(with.value("kernelGradientSumMax", "interface"), 0, 1e-12);
    EXPECT_NEAR(with.value("spacingMin", "interface"), 1, 1e-12);

    // Half a spacing off the sides, and so off the corners
    EXPECT_NEAR
    (
        with.value("offSurfaceMax", "interface"), std::sqrt(0.5) - 0.5, 1e-12
    );
    EXPECT_LT(with.value("linearResidualMax", "fluid"), 1e-12);

    // Without them the first layer is no interface
    EXPECT_NE
    (
        errorMessage
        (
            [&]{ without.value("kernelGradientSumMax", "interface"); }
        ).find("measure kernelGradientSumMax of the set interface"),
        std::string::npos
    );
}


TEST(MeshQuality, isWrittenAsCommaSeparatedValues)
{
    const auto scene = particleScene::New("box", 0.2);
    const auto m = scene->assemble("order 1;");
    const meshQuality quality
    (
        scene->mesh(), *m, List<particleSet>(), scene->fluid()
    );

    const fileName file(scene->files().path()/"postProcessing"/"quality.csv");
    quality.write(file);

    std::ifstream is(file);
    std::string line;
    std::getline(is, line);
    EXPECT_EQ(line, "measure,set,value");

    label n = 0;
    while (std::getline(is, line))
    {
        const meshQuality::row& row = quality.rows()[n++];
        const std::string start(row.measure + "," + row.set + ",");
        ASSERT_EQ(line.substr(0, start.size()), start);
        EXPECT_NEAR
        (
            std::stod(line.substr(start.size())),
            row.value,
            1e-10*mag(row.value)
        );
    }
    EXPECT_EQ(n, quality.rows().size());
}


TEST(LargestVoid, isTheEmptySphereOfALattice)
{
    for (const label nDims : {1, 2, 3})
    {
        DynamicList<vector> points;
        for (label k = 0; k < (nDims > 2 ? 7 : 1); ++k)
        {
            for (label j = 0; j < (nDims > 1 ? 7 : 1); ++j)
            {
                for (label i = 0; i < 7; ++i)
                {
                    points.append(0.2*vector(i, j, k));
                }
            }
        }
        const scalarField spacing(points.size(), 0.2);

        EXPECT_NEAR
        (
            largestVoid(nDims, points, spacing, [](const vector&)
            {
                return true;
            }),
            0.5*std::sqrt(scalar(nDims)),
            1e-9
        );
        EXPECT_EQ
        (
            largestVoid(nDims, points, spacing, [](const vector&)
            {
                return false;
            }),
            0
        );
    }
}


TEST(LargestVoid, ofOneLayerInThreeDimensionsIsNone)
{
    // In one plane but for round-off
    DynamicList<vector> points;
    for (label j = 0; j < 9; ++j)
    {
        for (label i = 0; i < 9; ++i)
        {
            points.append(0.2*vector(i, j, 0) + vector(0, 0, 1e-17*(i*j % 3)));
        }
    }
    EXPECT_EQ
    (
        largestVoid
        (
            3,
            points,
            scalarField(points.size(), 0.2),
            [](const vector&) { return true; }
        ),
        0
    );
}


// ************************************************************************* //
