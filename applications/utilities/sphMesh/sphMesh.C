/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Application
    sphMesh

Description
    Generates body-fitted particles from the mesh of a case and writes them as
    a case of their own, sph/, whose mesh is the particles: what blockMesh is
    to cells.

    Reads the mesh and system/sphMeshDict (without it particles follow the
    cells), fills the fluid and the solid bodies with particles, relaxes them,
    finds the pairs and their area vectors and closes every particle. With an
    entry zone particles fill that part of the mesh, and the FVM cells around it
    stay as they are in the mesh of sph/. Maps the
    fields of the start time with their boundary conditions. Particles that
    already belong to this mesh and dictionary are kept, and so is what was
    edited in sph/.

Usage
    \b sphMesh [OPTION]

      - \par -dict \<file\>
        Alternative to system/sphMeshDict

      - \par -init
        Write a commented system/sphMeshDict, and stop

      - \par -dry-run
        Say the number of particles, the memory and the time, and stop

      - \par -overwrite
        Generate anew in any case; results on the old particles are removed

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "consistentClosure.H"
#include "contactFaces.H"
#include "particleGenerator.H"
#include "particleMeshAssembly.H"
#include "particleMeshProperties.H"
#include "startFields.H"
#include "surfaceVectorClosure.H"
#include "version.H"
#include "wallPolyPatch.H"
#include "OSspecific.H"

#include <algorithm>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

//- Copy the commented dictionary into the case
void writeDefaultDict(const Time& runTime)
{
    const fileName to(runTime.path()/runTime.system()/"sphMeshDict");
    const fileName from
    (
        fileName(getEnv("EULERIANSPH_DIR"))
       /"etc"/"caseDicts"/"annotated"/"sphMeshDict"
    );

    if (isFile(to))
    {
        FatalErrorInFunction
            << to << " exists already: it is not overwritten"
            << exit(FatalError);
    }
    if (!cp(from, to))
    {
        FatalErrorInFunction
            << "Cannot copy " << from << " to " << to << ": source"
            << " eulerianSPH's etc/bashrc first" << exit(FatalError);
    }
    Info<< "Written " << to << nl << endl;
}


//- FatalError for cases of several regions
void checkRegions(const Time& runTime)
{
    const fileName file(runTime.path()/runTime.constant()/"regionProperties");

    if (isFile(file))
    {
        FatalErrorInFunction
            << "The case has several regions (" << file << "), which are not"
            << " supported. Valid choices: a case of one mesh in"
            << " constant/polyMesh" << exit(FatalError);
    }
}


//- Warn of the narrowest passage between walls if fewer than four particles
//  stand across it, which are too few for a flow
void warnOfFew(const fvMesh& mesh, const particleMeshData& data)
{
    const boundaryFaces& faces = data.boundary;

    labelList patchIDs(faces.owner.size());
    List<DynamicList<label>> own(data.points.size());
    forAll(mesh.boundaryMesh(), patchi)
    {
        for (label i = faces.start[patchi]; i < faces.start[patchi + 1]; ++i)
        {
            patchIDs[i] = patchi;
            if (isA<wallPolyPatch>(mesh.boundaryMesh()[patchi]))
            {
                own[faces.owner[i]].append(i);
            }
        }
    }

    // Of three particles across, the one in the middle has both walls beside it
    List<DynamicList<label>> near(own);
    forAll(data.owner, pairi)
    {
        const label i = data.owner[pairi];
        const label j = data.neighbour[pairi];
        const vector apart(data.points[j] - data.points[i]);
        if (mag(data.delta[pairi] - apart) < 0.1*mag(apart))
        {
            near[i].append(own[j]);
            near[j].append(own[i]);
        }
    }

    scalar least = 3.5;
    labelPair walls(-1, -1);
    forAll(near, particlei)
    {
        for (const label i : near[particlei])
        {
            for (const label j : near[particlei])
            {
                const vector across(faces.Cf[j] - faces.Cf[i]);
                const vector ni(normalised(faces.Sf[i]));
                const vector nj(normalised(faces.Sf[j]));

                // Opposite, with the fluid between them
                if
                (
                    (ni & nj) < -0.95
                 && (across & (nj - ni)) > 1.4*mag(across)
                 && mag(across) < least*data.spacing[particlei]
                )
                {
                    least = mag(across)/data.spacing[particlei];
                    walls = labelPair(i, j);
                }
            }
        }
    }

    if (walls.first() >= 0)
    {
        const point& a = faces.Cf[walls.first()];
        const point& b = faces.Cf[walls.second()];
        WarningInFunction
            << "Between the patches "
            << mesh.boundaryMesh()[patchIDs[walls.first()]].name() << " and "
            << mesh.boundaryMesh()[patchIDs[walls.second()]].name() << " at "
            << 0.5*(a + b) << ", " << mag(b - a) << " m apart, particles: "
            << max(label(round(least)), label(1))
            << ". Fewer than four are too few for a flow: refine the mesh"
            << " there, or give system/sphMeshDict a spacing there of "
            << mag(b - a)/4 << " m or less" << endl;
    }
}


//- Generate, relax and close the particles and write them
void generateParticles
(
    const particleZone& zone,
    const dictionary& dict,
    particleGenerator& generator,
    const closure& method,
    dictionary& properties,
    particleCase& sph
)
{
    const fvMesh& mesh = zone.mesh();

    generator.generate();
    const fileName directory(mesh.time().path()/"postProcessing"/"sphMesh");
    mkDir(directory);
    generator.monitor().write(directory/"convergence.csv");
    if (generator.monitor().history().size())
    {
        properties.add
        (
            "kineticEnergy",
            generator.monitor().history().last().kineticEnergy
        );
    }
    if (generator.filesCutMesh())
    {
        properties.add("fluidVolume", generator.fluid().volume);
        properties.add("bodies", dict.subDict("bodies"));
    }

    Info<< "Pairs and closure" << endl;
    const particleMeshData data
    (
        assembleParticleMesh
        (
            mesh,
            generator.W(),
            generator.fluid(),
            generator.fluidDistance(),
            method
        )
    );

    boundaryFaces contact;
    if (method.type() == surfaceVectorClosure::typeName)
    {
        contact = contactFaces
        (
            mesh,
            solutionSpace(mesh),
            generator.W(),
            data,
            generator.solids(),
            generator.fluidDistance()
        );
    }

    if (!zone.everywhere())
    {
        Info<< "    FVM cells: "
            << std::count(zone.inside().begin(), zone.inside().end(), false)
            << " of " << zone.inside().size() << ", border faces: "
            << mesh.boundaryMesh()[zone.borderPatch()].size() << nl;
    }
    for (label bodyi = 0; bodyi < zone.bodies().size(); ++bodyi)
    {
        const orientedSurface& surface = zone.bodies().surface(bodyi);
        Info<< "    body " << zone.bodies().name(bodyi)
            << ": elements: " << surface.size() << ", volume: "
            << surface.volume() << nl;
    }
    Info<< "    particles: " << data.points.size()
        << "  pairs: " << data.owner.size()
        << "  boundary faces: " << data.boundary.owner.size() << endl;
    warnOfFew(mesh, data);

    sph.writeMesh(properties, zone, data, generator.solids(), contact);
}


int main(int argc, char *argv[])
{
    argList::addNote("Generate body-fitted particles from a mesh");
    argList::noParallel();
    argList::addOption("dict", "file", "Alternative to system/sphMeshDict");
    argList::addBoolOption("init", "Write a commented sphMeshDict, and stop");
    argList::addBoolOption("dry-run", "Say what would be generated, and stop");
    argList::addBoolOption("overwrite", "Generate anew in any case");

    #include "setRootCase.H"
    printVersion();
    #include "createTime.H"

    if (args.found("init"))
    {
        writeDefaultDict(runTime);
        return 0;
    }

    particleCase::requireFvm(runTime);
    runTime.setTime(particleCase::startTime(runTime), 0);
    checkRegions(runTime);

    #include "createReadMesh.H"

    const IOdictionary dict(readSphMeshDict(mesh, args));
    const particleZone zone(mesh, dict);
    dictionary properties(particleMeshProperties(zone, dict));
    particleCase sph(mesh);

    if
    (
        !args.found("overwrite")
     && !args.found("dry-run")
     && sph.digest() == properties.get<word>("digest")
    )
    {
        Info<< "The particles in " << sph.path() << " are up to date" << endl;
        sph.updateSource();
    }
    else
    {
        const autoPtr<closure> method
        (
            closure::New(dict.subOrEmptyDict("closure"))
        );
        if (!zone.everywhere() && method->type() != consistentClosure::typeName)
        {
            FatalIOErrorInFunction(dict)
                << "closure " << method->type() << " does not close the"
                << " particles of a zone against the FVM cells around it."
                << " Valid closures with an entry 'zone': "
                << consistentClosure::typeName << exit(FatalIOError);
        }
        particleGenerator generator(zone.mesh(), dict);

        if (generator.filesCutMesh() && method->type() != noClosure::typeName)
        {
            FatalIOErrorInFunction(dict)
                << "Bodies read from files overlap the mesh in part. Valid"
                << " bodies lie wholly among its cells, or beside it; or give"
                << " 'closure {type none;}' for particles alone"
                << exit(FatalIOError);
        }

        if (args.found("dry-run"))
        {
            generator.estimate(Info);
            Info<< "End\n" << endl;
            return 0;
        }

        if (args.found("overwrite"))
        {
            sph.removeResults();
        }
        sph.requireNoResults();
        generator.checkMemory();
        generateParticles(zone, dict, generator, *method, properties, sph);
    }

    Info<< "Particle case " << sph.path() << endl;
    sph.writeDictionaries();
    startFields(mesh, sph).write();

    Info<< nl << "ExecutionTime = " << runTime.elapsedCpuTime() << " s"
        << "  ClockTime = " << runTime.elapsedClockTime() << " s\n\nEnd\n"
        << endl;

    return 0;
}


// ************************************************************************* //
