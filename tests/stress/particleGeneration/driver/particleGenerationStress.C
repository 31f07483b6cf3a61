/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Application
    particleGenerationStress

Description
    Generates particles in random scenes (randomScene.H), each in a process of
    its own with a time limit, and checks them: all inside, none closer than
    0.4 spacings to another, no void into which another particle would fit a
    spacing off all others, areas closed to 1e-12.

Usage
    \b particleGenerationStress -kind \<kind\> -first \<seed\> -last \<seed\>

      - \par -step \<number\>
        From one seed to the next, default 1

      - \par -limit \<seconds\>
        Processor time for each scene, default 30

      - \par -write
        Write the mesh, the dictionary and the particles to the case

    Prints a line 'PASS name' or 'FAIL name why' for each scene. An error with
    a message is a pass only if it names the spacing as its cause.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "fvMesh.H"
#include "largestVoid.H"
#include "particleCase.H"
#include "particleGenerator.H"
#include "particleMeshAssembly.H"
#include "particleMeshProperties.H"
#include "polygonMesh.H"
#include "randomScene.H"
#include "surfaceFields.H"
#include "Time.H"
#include "volFields.H"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <iostream>
#include <string>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

//- What is wrong with the particles, empty if nothing
//  \param closest smallest distance of two particles over dp
//  \param widest largest radius of a void over dp
static std::string findFaults
(
    const fvMesh& mesh,
    const particleMeshData& particles,
    const signedDistance& fluid,
    scalar& closest,
    scalar& widest
)
{
    const solutionSpace space(mesh);
    const label n = particles.points.size();
    const scalarField& dp = particles.spacing;
    OStringStream faults;

    vectorField x(n);
    label nOutside = 0;
    forAll(x, i)
    {
        x[i] = space.toLocal(particles.points[i]);
        nOutside += fluid.distance(particles.points[i]) > 0;
    }
    if (nOutside)
    {
        faults << " particles outside: " << nOutside;
    }

    closest = GREAT;
    for (label i = 0; i < n; ++i)
    {
        for (label j = i + 1; j < n; ++j)
        {
            closest = min(closest, mag(x[i] - x[j])/max(dp[i], dp[j]));
        }
    }
    if (closest < 0.4)
    {
        faults << " particles too close";
    }

    // In a notch narrower than a particle no particle is missing: it would
    // have to be nearer to a surface than others are to each other
    const scalar depth = 0.4*min(dp);
    const scalar radius = largestVoid
    (
        space.nDims(),
        x,
        dp,
        [&](const vector& p)
        {
            return fluid.distance(space.position(p)) < -depth;
        }
    );
    widest = radius;
    if (radius >= 1)
    {
        faults << " a particle would fit into a void";
    }

    // Area sum of each particle over V^((d-1)/d)
    vectorField sum(n, Zero);
    forAll(particles.Sf, pairi)
    {
        sum[particles.owner[pairi]] += particles.Sf[pairi];
        sum[particles.neighbour[pairi]] -= particles.Sf[pairi];
    }
    forAll(particles.boundary.Sf, facei)
    {
        sum[particles.boundary.owner[facei]] += particles.boundary.Sf[facei];
    }
    scalar residual = 0;
    forAll(sum, i)
    {
        residual = max
        (
            residual,
            mag(sum[i])
           /(space.thickness()*pow(dp[i], space.nDims() - 1))
        );
    }
    if (!(residual < 1e-12))
    {
        faults << " area sum: " << residual;
    }

    const scalar volume =
        mag(Foam::sum(particles.V)/gSum(mesh.V()) - 1);
    if (!(volume < 1e-12))
    {
        faults << " volume: " << volume;
    }

    return faults.str();
}


//- Generate and check a scene; prints one line
static void run
(
    Time& runTime,
    const randomScene& scene,
    const word& name,
    const bool write
)
{
    messageStream::level = 0;
    FatalError.throwExceptions();
    FatalIOError.throwExceptions();

    std::string faults;
    label nParticles = 0;
    scalar closest = 0;
    scalar widest = 0;
    try
    {
        dictionary outlines;
        outlines.set("size", 2*scene.spacing());
        dictionary patches;
        forAll(scene.loops(), i)
        {
            dictionary patch;
            patch.set("loop", scene.loops()[i]);
            patches.set(word("loop" + Foam::name(i)), patch);
        }
        outlines.set("patches", patches);

        const IOobject io
        (
            polyMesh::defaultRegion,
            runTime.constant(),
            runTime,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        );
        const autoPtr<polyMesh> prisms(newPolygonMesh(io, outlines));

        fvMesh mesh
        (
            io,
            pointField(prisms->points()),
            faceList(prisms->faces()),
            labelList(prisms->faceOwner()),
            labelList(prisms->faceNeighbour())
        );
        List<polyPatch*> meshPatches(prisms->boundaryMesh().size());
        forAll(meshPatches, patchi)
        {
            meshPatches[patchi] =
                prisms->boundaryMesh()[patchi].clone(mesh.boundaryMesh()).ptr();
        }
        mesh.addFvPatches(meshPatches);

        IOdictionary dict
        (
            IOobject
            (
                "sphMeshDict",
                runTime.system(),
                runTime,
                IOobject::NO_READ,
                IOobject::AUTO_WRITE
            )
        );
        dict.add("spacing", scene.spacing());

        if (write)
        {
            mesh.polyMesh::write();
            dict.regIOobject::write();
        }

        particleGenerator generator(mesh, dict);
        generator.generate();

        const autoPtr<closure> method(closure::New(dictionary()));
        const particleMeshData particles
        (
            assembleParticleMesh
            (
                mesh,
                generator.W(),
                generator.fluid(),
                generator.fluidDistance(),
                *method
            )
        );
        if (write)
        {
            const particleZone everywhere(mesh, dictionary());
            particleCase(mesh).writeMesh
            (
                particleMeshProperties(everywhere, dict),
                everywhere,
                particles,
                generator.solids(),
                boundaryFaces()
            );
        }

        nParticles = particles.points.size();
        faults = findFaults
        (
            mesh, particles, generator.fluidDistance(), closest, widest
        );
    }
    catch (const Foam::error& e)
    {
        const std::string message(e.message());
        if (message.find("spacing") == std::string::npos)
        {
            faults = " error: " + message;
        }
    }

    std::cout
        << (faults.empty() ? "PASS " : "FAIL ") << name
        << " (sharpest angle " << scene.sharpest() << ", "
        << nParticles << " particles, closest " << closest << ", widest void "
        << widest << ')' << faults << std::endl;
}


int main(int argc, char *argv[])
{
    argList::addNote("Generate particles in random scenes and check them");
    argList::noParallel();
    argList::addOption("kind", "word", "Kind of scene");
    argList::addOption("first", "label", "First seed");
    argList::addOption("last", "label", "Last seed");
    argList::addOption("step", "label", "From one seed to the next, default 1");
    argList::addOption
    (
        "limit", "seconds", "Processor time for each scene, default 30"
    );
    argList::addBoolOption("write", "Write mesh and particles to the case");

    #include "setRootCase.H"
    #include "createTime.H"

    const randomScene::kind kind =
        randomScene::kindNames[args.get<word>("kind")];
    const label first = args.get<label>("first");
    const label last = args.get<label>("last");
    const label step = args.getOrDefault<label>("step", 1);
    const label limit = args.getOrDefault<label>("limit", 30);
    const bool write = args.found("write");

    for (label seed = first; seed <= last; seed += step)
    {
        const word name
        (
            randomScene::kindNames[kind] + '.' + Foam::name(seed)
        );

        const pid_t child = fork();
        if (child == 0)
        {
            // On a busy machine the time of the clock says little
            const rlimit cpu = {rlim_t(limit), rlim_t(limit)};
            ::setrlimit(RLIMIT_CPU, &cpu);
            ::signal(SIGALRM, SIG_DFL);
            ::alarm(10*limit);
            run(runTime, randomScene(kind, seed), name, write);
            ::_exit(0);
        }

        int status = 0;
        ::waitpid(child, &status, 0);
        if (WIFSIGNALED(status))
        {
            const int number = WTERMSIG(status);
            const bool hangs =
                number == SIGALRM || number == SIGXCPU || number == SIGKILL;

            std::cout
                << "FAIL " << name
                << (hangs ? " hangs" : " crashes")
                << ": signal " << number << std::endl;
        }
        else if (WEXITSTATUS(status) != 0)
        {
            std::cout
                << "FAIL " << name << " ends with status "
                << WEXITSTATUS(status) << std::endl;
        }
    }

    return 0;
}


// ************************************************************************* //
