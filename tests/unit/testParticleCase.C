/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    The files of a particle case: what is written, what is kept because the
    user has edited it, what follows the FVM case and what is refused.

\*---------------------------------------------------------------------------*/

#include "particleScene.H"
#include "IFstream.H"
#include "labelIOList.H"
#include "IStringStream.H"
#include "OSspecific.H"
#include "particleMeshProperties.H"
#include "particleZone.H"
#include "Random.H"
#include "solidParticles.H"

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


void append(const fileName& file, const std::string& text)
{
    setContent(file, content(file) + text);
}


bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}


//- A dictionary as a solver reads it, with what it includes
dictionary readDict(const fileName& file)
{
    IFstream is(file);
    return dictionary(is);
}


//- An FVM case whose dictionaries ask for everything that particles change,
//- and its particle case
class ParticleDictionaries
:
    public testing::Test
{
protected:

    testCase fvm{testCase::layout()};

    const fileName sph = fvm.path()/"sph";

    void writeControlDict(const std::string& entries)
    {
        fvm.write
        (
            "system/controlDict",
            "application icoFoam; startFrom startTime; startTime 0;"
            "stopAt endTime; endTime 1; deltaT 0.1;"
            "writeControl timeStep; writeInterval 1; writeFormat ascii;"
            + entries
        );
        fvm.reopen();
    }

    dictionary written(const fileName& file)
    {
        particleCase(fvm.mesh()).writeDictionaries();
        return readDict(sph/file);
    }
};


//- A box with a particle case
class StoredParticles
:
    public testing::Test
{
protected:

    std::unique_ptr<particleScene> scene = particleScene::New("box", 0.3);

    const fileName path = scene->files().path();

    const fileName folder = path/"sph"/"constant"/"sphMesh";

    //- Error of opening the particle case
    std::string openError()
    {
        return errorMessage
        (
            [&]{ particleCase::openTime(scene->files().time()); }
        );
    }

    //- Error of reading the particles
    std::string readError()
    {
        return errorMessage
        (
            [&]
            {
                particleCase sph(scene->mesh());
                particleMesh particles(sph.particles().mesh());
            }
        );
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * *  Files written  * * * * * * * * * * * * * * * //

TEST(WrittenFiles, editedOnesAreKept)
{
    testCase box(testCase::layout{});
    const fileName path(box.path()/"sph");
    const auto write = [&](const std::string& text)
    {
        writtenFiles files(path);
        files.writeText("system/dict", text);
        files.write();
        return content(path/"system"/"dict");
    };

    EXPECT_EQ(write("first"), "first");
    EXPECT_EQ(write("second"), "second");

    setContent(path/"system"/"dict", "edited");
    EXPECT_FALSE(writtenFiles(path).mayWrite("system/dict"));
    EXPECT_EQ(write("third"), "edited");
    EXPECT_EQ(write("fourth"), "edited");

    // Taken back, or removed
    setContent(path/"system"/"dict", "second");
    EXPECT_EQ(write("fifth"), "fifth");
    setContent(path/"system"/"dict", "edited");
    rm(path/"system"/"dict");
    EXPECT_EQ(write("sixth"), "sixth");
}


TEST(WrittenFiles, filesOfTheUserAreKept)
{
    testCase box(testCase::layout{});
    const fileName path(box.path()/"sph");
    mkDir(path/"system");
    setContent(path/"system"/"dict", "mine");
    setContent(path/"system"/"link", "mine");

    writtenFiles files(path);
    files.writeText("system/dict", "other");
    files.link("system/link", "../../system/controlDict");
    files.link("system/new", "../../system/controlDict");

    EXPECT_EQ(content(path/"system"/"dict"), "mine");
    EXPECT_EQ(content(path/"system"/"link"), "mine");
    EXPECT_EQ
    (
        content(path/"system"/"new"),
        content(box.path()/"system"/"controlDict")
    );
}


// * * * * * * * * * * * * * *  Dictionaries * * * * * * * * * * * * * * * * //

TEST_F(ParticleDictionaries, theControlsAreThoseOfTheFvmCase)
{
    writeControlDict("libs (fieldFunctionObjects); purgeWrite 3;");
    const dictionary control(written("system/controlDict"));

    EXPECT_EQ(control.get<scalar>("endTime"), 1);
    EXPECT_EQ(control.get<label>("purgeWrite"), 3);
    EXPECT_EQ(control.get<word>("writeFormat"), "binary");
    EXPECT_EQ
    (
        control.get<fileNameList>("libs"),
        fileNameList({"fieldFunctionObjects", "eulerianSPH"})
    );

    // A change of the FVM case is one of both
    writeControlDict("libs (eulerianSPH); purgeWrite 4;");
    EXPECT_EQ(readDict(sph/"system/controlDict").get<label>("purgeWrite"), 4);
    EXPECT_EQ
    (
        written("system/controlDict").get<fileNameList>("libs"),
        fileNameList({"eulerianSPH"})
    );
}


TEST_F(ParticleDictionaries, functionObjectsThatTrackAreLeftOut)
{
    writeControlDict
    (
        "functions {"
        "lines { type streamLine; libs (fieldFunctionObjects); }"
        "tracked { type sets; libs (sampling); sets"
        " ( x { type uniform; axis x; start (0 0 0); end (1 0 0); } ); }"
        "cloud { type sets; libs (sampling); sets"
        " ( x { type cloud; axis x; points ((0 0 0)); } ); }"
        "probes { type probes; libs (sampling); fields (p);"
        " probeLocations ((0.5 0.5 0.05)); }"
        "}"
    );
    const dictionary functions
    (
        written("system/controlDict").subDict("functions")
    );
    EXPECT_EQ(functions.size(), 4);

    for (const char* name : {"lines", "tracked"})
    {
        EXPECT_FALSE(functions.subDict(name).get<bool>("enabled")) << name;
    }
    for (const char* name : {"cloud", "probes"})
    {
        EXPECT_TRUE
        (
            functions.subDict(name).getOrDefault<bool>("enabled", true)
        )   << name;
    }
}


TEST_F(ParticleDictionaries, linearConvectionAndPressureAreReconstructed)
{
    std::string gradSchemes("default none;");
    const auto written = [&](const std::string& divSchemes)
    {
        fvm.write
        (
            "system/fvSchemes",
            "ddtSchemes { default Euler; } gradSchemes { " + gradSchemes + "}"
            "divSchemes { " + divSchemes + "}"
            "laplacianSchemes { default none; }"
            "interpolationSchemes { default linear; }"
            "snGradSchemes { default corrected; }"
        );
        fvm.reopen();
        return this->written("system/fvSchemes");
    };
    const auto textOf = [](const dictionary& schemes, const word& name)
    {
        ITstream& is = schemes.lookup(name);
        std::string text;
        for (const token& t : is)
        {
            text += (text.empty() ? "" : " ") + t.wordToken();
        }
        return text;
    };
    const auto scheme = [&](const std::string& divSchemes, const word& name)
    {
        return textOf(written(divSchemes).subDict("divSchemes"), name);
    };

    const std::string each
    (
        "default none; div(phi,U) Gauss linear; div(phi,k) Gauss upwind;"
        " div((nuEff*dev2(T(grad(U))))) Gauss linear;"
    );
    EXPECT_EQ(scheme(each, "div(phi,U)"), "GaussAhead reconstructed");
    EXPECT_EQ(scheme(each, "div(phi,k)"), "Gauss upwind");
    EXPECT_EQ
    (
        scheme(each, "div((nuEff*dev2(T(grad(U)))))"), "Gauss linear"
    );
    EXPECT_EQ
    (
        scheme("default Gauss linear;", "div(phi,U)"),
        "GaussAhead reconstructed"
    );
    EXPECT_EQ
    (
        scheme("default none; div(phi,U) GaussAhead linear;", "div(phi,U)"),
        "GaussAhead reconstructed"
    );
    EXPECT_EQ(scheme("default Gauss linear;", "default"), "Gauss linear");
    EXPECT_EQ
    (
        scheme("default Gauss linear; div(phi,U) Gauss limitedLinear;",
            "div(phi,U)"),
        "Gauss limitedLinear"
    );

    const auto pressure = [&](const char* schemes)
    {
        gradSchemes = schemes;
        const dictionary grad(written(each).subDict("gradSchemes"));
        return textOf(grad, grad.found("grad(p)") ? "grad(p)" : "default");
    };
    EXPECT_EQ
    (
        pressure("default Gauss linear;"), "Gauss reconstructed exact(p)"
    );
    EXPECT_EQ
    (
        pressure("default none; grad(p) Gauss linear;"),
        "Gauss reconstructed exact(p)"
    );
    EXPECT_EQ(pressure("default none;"), "none");
    gradSchemes = "default Gauss linear;";
    EXPECT_FALSE
    (
        written("default none; div(phi,U) Gauss limitedLinearV 1;")
            .subDict("gradSchemes").found("grad(p)")
    );
    EXPECT_TRUE
    (
        written("default none; div(phi,U) bounded Gauss linear;")
            .subDict("gradSchemes").found("grad(p)")
    );
    EXPECT_EQ(pressure("default leastSquares;"), "leastSquares");
}


TEST_F(ParticleDictionaries, whatMakesTheFvmMeshIsLeftOut)
{
    fvm.write("system/blockMeshDict", "");
    fvm.write("system/sphMeshDict", "spacing 0.1;");
    fvm.write("system/sphSchemes", "maxCo 0.7;");
    fvm.write("constant/transportProperties", "nu 0.01;");
    fvm.write("constant/geometry/surface", "");
    setContent(fvm.path()/"system"/"parameters", "spacing 0.1;\n");

    EXPECT_EQ(written("system/sphSchemes").get<scalar>("maxCo"), 0.7);
    EXPECT_FALSE(exists(sph/"system"/"blockMeshDict"));
    EXPECT_FALSE(exists(sph/"system"/"sphMeshDict"));
    EXPECT_EQ(content(sph/"system"/"parameters"), "spacing 0.1;\n");
    EXPECT_TRUE(isFile(sph/"constant"/"geometry"/"surface"));

    fvm.write("constant/transportProperties", "nu 0.02;");
    EXPECT_EQ
    (
        readDict(sph/"constant"/"transportProperties").get<scalar>("nu"), 0.02
    );
}


TEST_F(StoredParticles, referenceCellIsANearParticle)
{
    const label celli = 19;
    scene->files().write
    (
        "system/fvSolution",
        "solvers {} PISO { nCorrectors 2; pRefCell 19; pRefValue 0; }"
    );
    const_cast<fvMesh&>(scene->mesh()).fvSolution::read();
    const auto particles = scene->assemble("order 1;");
    particles->sph().writeDictionaries();

    const dictionary solution
    (
        readDict(path/"sph"/"system"/"fvSolution").subDict("PISO")
    );
    EXPECT_EQ(solution.get<label>("nCorrectors"), 2);
    EXPECT_FALSE(solution.found("pRefCell"));

    // A particle's centre, so that it is found whichever number it has
    const point chosen(solution.get<point>("pRefPoint"));
    const label i = particles->mesh().findCell
    (
        chosen, polyMesh::FACE_PLANES
    );
    ASSERT_GE(i, 0);
    EXPECT_LT(mag(particles->C()[i] - chosen), 1e-10);

    const point& C = scene->mesh().cellCentres()[celli];
    EXPECT_LE(mag(chosen - C), particles->spacing()[i]);

    // The old particles are looked at for it, and not kept
    scene->particles().points.setSize(300);
    scene->particles().spacing.setSize(300);
    EXPECT_EQ(scene->assemble("type none;")->nParticles(), 300);
    EXPECT_TRUE(isFile(folder/"writtenFiles"));
}


// * * * * * * * * * * * * * * Stored particles  * * * * * * * * * * * * * * //

TEST_F(StoredParticles, keepTheSolids)
{
    const List<particleSet> solids(twoSolids());
    const auto particles = scene->assemble("order 1;", solids);
    const particleFiles files(particles->mesh().time());
    const List<particleSet> read(readSolidParticles(files));

    ASSERT_EQ(read.size(), 2);
    forAll(read, bodyi)
    {
        EXPECT_EQ(read[bodyi].name, solids[bodyi].name);
        EXPECT_EQ(read[bodyi].smoothingRatio, solids[bodyi].smoothingRatio);
        EXPECT_TRUE(sameBytes(read[bodyi].points, solids[bodyi].points));
        EXPECT_TRUE(sameBytes(read[bodyi].spacing, solids[bodyi].spacing));
    }

    // Damaged
    const std::string spacing(content(folder/"solidSpacing"));
    const auto error = [&]
    {
        return errorMessage([&]{ readSolidParticles(files); });
    };
    ASSERT_EQ(error(), "");
    setContent(folder/"solidSpacing", content(folder/"spacing"));
    EXPECT_TRUE(contains(error(), "inconsistent")) << error();
    rm(folder/"solidSpacing");
    EXPECT_TRUE(contains(error(), "solidSpacing")) << error();

    // New particles leave nothing of the old ones
    scene->assemble("order 1;");
    EXPECT_TRUE(readSolidParticles(files).empty());
    EXPECT_FALSE(exists(folder/"solidPoints"));
    EXPECT_FALSE(exists(path/"sph"/"constant"/"new"));
}


TEST_F(StoredParticles, areInBinaryWithTheirProperties)
{
    EXPECT_EQ(particleCase(scene->mesh()).digest(), "");
    const auto particles = scene->assemble("order 1;");
    EXPECT_EQ(particleCase(scene->mesh()).digest(), "test");

    EXPECT_EQ(particles->properties().get<word>("digest"), "test");
    EXPECT_EQ
    (
        particles->properties().get<label>("nParticles"),
        particles->nParticles()
    );
    EXPECT_EQ
    (
        particles->properties().subDict("closure").get<label>("order"), 1
    );

    EXPECT_TRUE(contains(content(folder/"spacing").substr(0, 1000), "binary"));
    EXPECT_TRUE
    (
        contains
        (
            content(path/"sph"/"constant"/"polyMesh"/"points").substr(0, 1000),
            "binary"
        )
    );
}


TEST_F(StoredParticles, damagedArraysAreRefusedByName)
{
    const auto particles = scene->assemble("order 1;");
    ASSERT_EQ(readError(), "");
    const std::string good(content(folder/"spacing"));

    setContent(folder/"spacing", good.substr(0, good.size()/2));
    EXPECT_TRUE(contains(readError(), "spacing")) << readError();

    const particleFiles files(particles->mesh().time());
    files.writeArray<IOField<scalar>>("spacing", scalarField(3, 0.1));
    EXPECT_TRUE(contains(readError(), "3 values")) << readError();

    files.writeArray<IOField<scalar>>
    (
        "spacing", scalarField(particles->nParticles(), Zero)
    );
    EXPECT_TRUE(contains(readError(), "spacings")) << readError();

    files.writeArray<labelIOList>("spacing", labelList(3, Zero));
    EXPECT_TRUE(contains(readError(), "No scalarField in")) << readError();
    EXPECT_TRUE(contains(readError(), "sphMesh -overwrite")) << readError();

    setContent(folder/"spacing", good);
    EXPECT_EQ(readError(), "");
}


TEST_F(StoredParticles, anotherMeshOrDictionaryMakesThemOld)
{
    EXPECT_TRUE(contains(openError(), "Generate it with sphMesh"));

    scene->assemble("order 1;");
    EXPECT_EQ(openError(), "");

    const fileName points(path/"constant"/"polyMesh"/"points");
    const std::string before(content(points));
    append(points, "\n");
    EXPECT_TRUE(contains(openError(), "older than points")) << openError();
    EXPECT_TRUE(contains(openError(), "run sphMesh")) << openError();
    setContent(points, before);
    EXPECT_EQ(openError(), "");

    scene->files().write("system/sphMeshDict", "spacing 0.05;");
    EXPECT_TRUE(contains(openError(), "older than sphMeshDict"));

    // As sphMesh says that they still belong to the files
    particleCase(scene->mesh()).updateSource();
    EXPECT_EQ(openError(), "");

    scene->files().write("system/sphMeshDict", "spacing 0.0500000001;");
    EXPECT_TRUE(contains(openError(), "older than sphMeshDict"));
    particleCase(scene->mesh()).updateSource();

    rm(folder/"sphMeshProperties");
    EXPECT_TRUE(contains(openError(), "is no particle case")) << openError();
    EXPECT_TRUE(contains(openError(), "-cells")) << openError();
}


TEST_F(StoredParticles, haveADigestOfAllDigits)
{
    const particleZone whole(scene->mesh(), dictionary());
    const auto digest = [&](const std::string& text)
    {
        return particleMeshProperties
        (
            whole, dictionary(IStringStream(text)())
        ).get<word>("digest");
    };

    EXPECT_EQ(digest("spacing 0.05;"), digest("spacing 5e-2;"));
    EXPECT_NE(digest("spacing 0.05;"), digest("spacing 0.0500000001;"));
}


TEST_F(StoredParticles, resultsOnThemAreNotMadeUnreadable)
{
    const auto particles = scene->assemble("order 1;");
    const auto error = [&]
    {
        return errorMessage([&]{ particles->sph().requireNoResults(); });
    };
    const fileName sph(path/"sph");
    mkDir(sph/"0");
    EXPECT_EQ(error(), "");

    for (const word name : {"0.5", "2", "processor0"})
    {
        mkDir(sph/name);
        EXPECT_TRUE(contains(error(), name)) << error();
        particles->sph().removeResults();
        EXPECT_FALSE(exists(sph/name)) << name;
        EXPECT_EQ(error(), "");
    }
    EXPECT_TRUE(isDir(sph/"0"));
}


// ************************************************************************* //
