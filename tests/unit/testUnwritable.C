/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    What cannot be written is an error that names the file: below a file where
    a folder should be, and on a full disk.

\*---------------------------------------------------------------------------*/

#include "fieldNorms.H"
#include "htmlReport.H"
#include "meshQuality.H"
#include "OSspecific.H"
#include "particleFiles.H"
#include "particleScene.H"
#include "particleVtp.H"
#include "pictureCanvas.H"
#include "scalarIOField.H"
#include "virtualDisplay.H"
#include "writtenFiles.H"

#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

class Unwritable
:
    public testing::Test
{
protected:

    std::unique_ptr<particleScene> scene = particleScene::New("box", 0.3);

    const fileName path = scene->files().path();

    void makeFile(const fileName& file)
    {
        mkDir((path/file).path());
        std::ofstream(path/file) << "a file" << std::endl;
    }

    void expectRefused
    (
        const std::string& expected,
        const std::function<void()>& write
    )
    {
        const std::string message(errorMessage(write));
        EXPECT_NE(message.find(expected), std::string::npos)
            << "no '" << expected << "' in: " << message;
    }

    //- In the place of its folder there is a file
    void expectNoFolder(const std::function<void(const fileName&)>& write)
    {
        makeFile("plain");
        const fileName file(path/"plain"/"result");
        expectRefused("Cannot write \"" + file, [&]{ write(file); });
    }

    //- There is no space left for it
    void expectFullDisk(const std::function<void(const fileName&)>& write)
    {
        const fileName file(path/"full");
        ASSERT_EQ(symlink("/dev/full", file.c_str()), 0);
        expectRefused("Cannot write \"" + file, [&]{ write(file); });
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * //

TEST_F(Unwritable, norms)
{
    expectNoFolder([](const fileName& file) { fieldNorms().write(file); });
}


TEST_F(Unwritable, report)
{
    const auto write = [](const fileName& file)
    {
        htmlReport("title").write(file);
    };
    expectNoFolder(write);
    expectFullDisk(write);
}


TEST_F(Unwritable, quality)
{
    const auto particles = scene->assemble("order 1;");
    const meshQuality quality
    (
        scene->mesh(), *particles, List<particleSet>(), scene->fluid()
    );
    expectNoFolder([&](const fileName& file) { quality.write(file); });
}


TEST_F(Unwritable, points)
{
    expectNoFolder
    (
        [](const fileName& file)
        {
            particleVtp vtp(file);
            vtp.add("V", scalarField(2, 1.0));
            vtp.write(pointField(2, point(Zero)));
        }
    );
}


TEST_F(Unwritable, pictures)
{
    const virtualDisplay display;
    if (!virtualDisplay::available())
    {
        GTEST_SKIP() << "no X server, Xvfb is not installed";
    }
    expectNoFolder
    (
        [](const fileName& file) { pictureCanvas(20, 10).write(file); }
    );
}


TEST_F(Unwritable, filesOfTheParticleCase)
{
    const fileName sph(path/"sph");
    writtenFiles files(sph);

    makeFile("sph/system");
    expectRefused
    (
        "Cannot write \"" + sph/"system"/"controlDict",
        [&]{ files.writeText("system/controlDict", "endTime 1;"); }
    );
    expectRefused
    (
        "Cannot link \"" + sph/"system"/"fvSchemes",
        [&]{ files.link("system/fvSchemes", "../../system/fvSchemes"); }
    );

    makeFile("sph/constant/sphMesh");
    expectRefused
    (
        "Cannot write \"" + sph/"constant"/"sphMesh"/"writtenFiles",
        [&]{ files.write(); }
    );
}


TEST_F(Unwritable, arraysOfTheParticles)
{
    const auto particles = scene->assemble("order 1;");
    const particleFiles files(particles->mesh().time());
    const fileName spacing(files.arrayPath("spacing"));

    rm(spacing);
    mkDir(spacing);
    expectRefused
    (
        "Cannot write \"" + spacing,
        [&]{ files.writeArray<scalarIOField>("spacing", scalarField(3, 0.1)); }
    );
}


TEST_F(Unwritable, particlesInThePlaceOfAFile)
{
    makeFile("sph/constant/polyMesh");
    expectRefused
    (
        "to \"" + path/"sph"/"constant"/"polyMesh",
        [&]{ scene->assemble("order 1;"); }
    );
}


// ************************************************************************* //
