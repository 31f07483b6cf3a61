/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Application
    sphMesh

Description
    Generates body-fitted particles from the mesh of a case: what blockMesh
    is to cells.

    Reads the mesh and system/sphMeshDict, fills the fluid and the solid
    bodies with particles, relaxes them, finds the pairs and their area
    vectors, closes every particle and writes constant/sphMesh. A particle
    mesh that already belongs to this mesh and dictionary is kept.

Usage
    \b sphMesh [OPTION]

      - \par -dict \<file\>
        Alternative to system/sphMeshDict

      - \par -dry-run
        Say the number of particles, the memory and the grid, and stop

      - \par -overwrite
        Regenerate even if the stored particle mesh is up to date

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "particleGenerator.H"
#include "particleMeshAssembly.H"
#include "particleMeshProperties.H"

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote("Generate body-fitted particles from a mesh");
    argList::noParallel();
    argList::addOption("dict", "file", "Alternative to system/sphMeshDict");
    argList::addBoolOption("dry-run", "Say what would be generated, and stop");
    argList::addBoolOption("overwrite", "Regenerate in any case");

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    const IOdictionary dict(readSphMeshDict(mesh, args));
    dictionary properties(particleMeshProperties(mesh, dict));

    if
    (
        !args.found("overwrite")
     && !args.found("dry-run")
     && SPH::sphMesh::storedDigest(mesh) == properties.get<word>("digest")
    )
    {
        Info<< "The particle mesh in " << SPH::sphMesh::directory(mesh)
            << " is up to date\n\nEnd\n" << endl;
        return 0;
    }

    const autoPtr<closure> method(closure::New(dict.subOrEmptyDict("closure")));
    particleGenerator generator(mesh, dict);

    if (generator.filesCutMesh() && method->type() != noClosure::typeName)
    {
        FatalIOErrorInFunction(dict)
            << "Bodies read from files overlap the mesh, which has no patches"
            << " there to close the particles' areas with. Use a mesh whose"
            << " patches are the bodies, made by snappyHexMesh or polygonMesh,"
            << " or 'closure {type none;}' for particles alone"
            << exit(FatalIOError);
    }

    if (args.found("dry-run"))
    {
        generator.estimate(Info);
        Info<< "End\n" << endl;
        return 0;
    }

    generator.generate();
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
    const SPH::sphMesh particles
    (
        mesh,
        properties,
        assembleParticleMesh
        (
            mesh,
            generator.W(),
            generator.fluid(),
            generator.fluidDistance(),
            *method
        )
    );

    particles.writeMesh(generator.solids());

    Info<< "    particles: " << particles.nParticles()
        << "  pairs: " << particles.nPairs()
        << "  boundary faces: " << particles.boundary().nFaces() << nl
        << "Written to " << SPH::sphMesh::directory(mesh) << nl << nl
        << "ExecutionTime = " << runTime.elapsedCpuTime() << " s"
        << "  ClockTime = " << runTime.elapsedClockTime() << " s\n\nEnd\n"
        << endl;

    return 0;
}


// ************************************************************************* //
