/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    What is written to constant/sphMesh is read back bit for bit, and what is
    damaged is refused.

\*---------------------------------------------------------------------------*/

#include "particleScene.H"
#include "solidParticles.H"
#include "OSspecific.H"
#include "Random.H"

#include <cstring>
#include <fstream>
#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

template<class List>
bool sameBytes(const List& a, const List& b)
{
    return
        a.size() == b.size()
     && std::memcmp(a.cdata(), b.cdata(), a.size()*sizeof(a[0])) == 0;
}


//- Two solids of random particles
List<particleSet> twoSolids()
{
    Random random(3);
    List<particleSet> solids(2);
    solids[0].name = "wing";
    solids[0].smoothingRatio = 1.05;
    solids[1].name = "a_cylinder";
    for (particleSet& solid : solids)
    {
        solid.points.setSize(30 + 10*random.sample01<scalar>());
        solid.spacing.setSize(solid.points.size());
        forAll(solid.points, i)
        {
            solid.points[i] = random.sample01<vector>();
            solid.spacing[i] = 0.1 + random.sample01<scalar>();
        }
    }
    return solids;
}


std::string content(const fileName& file)
{
    std::ifstream is(file, std::ios::binary);
    return std::string
    (
        std::istreambuf_iterator<char>(is),
        std::istreambuf_iterator<char>()
    );
}


void setContent(const fileName& file, const std::string& text)
{
    std::ofstream(file, std::ios::binary) << text;
}


//- A scene with a written particle mesh
class StoredMesh
:
    public testing::Test
{
protected:

    std::unique_ptr<particleScene> scene = particleScene::New("channel", 0.3);

    const fileName folder = sphMesh::directory(scene->mesh());

    void write()
    {
        scene->assemble("order 1;")->writeMesh(twoSolids());
    }

    //- Error of reading the particle mesh
    std::string readError()
    {
        return errorMessage([&]{ sphMesh read(scene->mesh()); });
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_F(StoredMesh, isReadBackBitForBit)
{
    const auto written = scene->assemble("order 1;");
    written->writeMesh();
    const sphMesh read(scene->mesh());

    EXPECT_TRUE(sameBytes(read.C(), written->C()));
    EXPECT_TRUE(sameBytes(read.V(), written->V()));
    EXPECT_TRUE(sameBytes(read.spacing(), written->spacing()));
    EXPECT_TRUE(sameBytes(read.owner(), written->owner()));
    EXPECT_TRUE(sameBytes(read.neighbour(), written->neighbour()));
    EXPECT_TRUE(sameBytes(read.Sf(), written->Sf()));
    EXPECT_TRUE(sameBytes(read.delta(), written->delta()));
    EXPECT_TRUE(sameBytes(read.skew(), written->skew()));

    const boundaryFaces& a = read.boundary().faces();
    const boundaryFaces& b = written->boundary().faces();
    EXPECT_EQ(a.start, b.start);
    EXPECT_TRUE(sameBytes(a.owner, b.owner));
    EXPECT_TRUE(sameBytes(a.Sf, b.Sf));
    EXPECT_TRUE(sameBytes(a.Cf, b.Cf));
    EXPECT_TRUE(sameBytes(a.distance, b.distance));
    EXPECT_TRUE(sameBytes(a.face, b.face));

    EXPECT_EQ(sphMesh::storedDigest(scene->mesh()), "test");
    EXPECT_TRUE(readSolidParticles(scene->mesh()).empty());
}


TEST_F(StoredMesh, keepsTheSolids)
{
    write();
    const List<particleSet> written(twoSolids());
    const List<particleSet> read(readSolidParticles(scene->mesh()));

    ASSERT_EQ(read.size(), 2);
    forAll(read, bodyi)
    {
        EXPECT_EQ(read[bodyi].name, written[bodyi].name);
        EXPECT_EQ(read[bodyi].smoothingRatio, written[bodyi].smoothingRatio);
        EXPECT_TRUE(sameBytes(read[bodyi].points, written[bodyi].points));
        EXPECT_TRUE(sameBytes(read[bodyi].spacing, written[bodyi].spacing));
    }

    // A new particle mesh leaves nothing of the old one
    scene->assemble("type none;")->writeMesh();
    EXPECT_TRUE(readSolidParticles(scene->mesh()).empty());
    EXPECT_FALSE(isFile(folder/"skew"));
}


TEST_F(StoredMesh, missingMeshSaysHowToMakeIt)
{
    EXPECT_EQ(sphMesh::storedDigest(scene->mesh()), "");

    const std::string message(readError());
    EXPECT_NE(message.find("No particle mesh"), std::string::npos) << message;
    EXPECT_NE(message.find(folder), std::string::npos) << message;
}


TEST_F(StoredMesh, meshOfAnotherCaseIsRefused)
{
    write();
    auto other = particleScene::New("box", 0);
    cp(folder, sphMesh::directory(other->mesh()));

    const std::string message
    (
        errorMessage([&]{ sphMesh read(other->mesh()); })
    );
    EXPECT_NE(message.find("another mesh"), std::string::npos) << message;
}


TEST_F(StoredMesh, damagedFilesAreRefusedByName)
{
    write();
    ASSERT_EQ(readError(), "");

    for
    (
        const char* name :
        {
            "points", "V", "owner", "Sf", "boundary", "boundarySf",
            "boundaryFace"
        }
    )
    {
        const fileName file(folder/name);
        const std::string good(content(file));

        rm(file);
        EXPECT_NE(readError().find(name), std::string::npos)
            << name << " missing: " << readError();

        setContent(file, good.substr(0, good.size()/2));
        EXPECT_NE(readError(), "") << name << " cut short";

        setContent(file, good);
    }

    // Readable, but of another size or with senseless values
    const std::string V(content(folder/"V"));
    setContent(folder/"V", content(folder/"boundaryDistance"));
    EXPECT_NE(readError().find("inconsistent"), std::string::npos)
        << readError();
    setContent(folder/"V", V);

    const std::string owner(content(folder/"owner"));
    setContent(folder/"owner", content(folder/"neighbour"));
    EXPECT_NE(readError().find("inconsistent"), std::string::npos)
        << readError();
    setContent(folder/"owner", owner);

    EXPECT_EQ(readError(), "");
}


TEST_F(StoredMesh, damagedSolidsAreRefused)
{
    write();
    const auto error = [&]
    {
        return errorMessage([&]{ readSolidParticles(scene->mesh()); });
    };
    ASSERT_EQ(error(), "");

    setContent(folder/"solid"/"spacing", content(folder/"V"));
    EXPECT_NE(error().find("inconsistent"), std::string::npos) << error();

    rm(folder/"solid"/"spacing");
    EXPECT_NE(error().find("spacing"), std::string::npos) << error();
}

// ************************************************************************* //
