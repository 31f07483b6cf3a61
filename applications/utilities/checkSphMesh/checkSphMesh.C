/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Application
    checkSphMesh

Description
    Checks the particles of sph/: what checkMesh is to cells.

    Prints the quality measures of the particles and of their closure, marks
    those beyond their limit with ***, and writes all of them to
    postProcessing/checkSphMesh/\<time\>/quality.csv.

Usage
    \b checkSphMesh [OPTION]

      - \par -writeVTK
        Write particles of fluid and solids, boundary surface vectors and the
        area vectors of the FVM faces as VTK PolyData beside quality.csv

      - \par -picture
        Draw the particles with their kernel gradient sums in particles.png
        beside quality.csv, and in 2-D the area vectors of the boundary, those
        of the mesh's faces beside those of the particles, in areaVectors.png

      - \par -view "(xMin yMin zMin) (xMax yMax zMax)"
        Draw this part of them

\*---------------------------------------------------------------------------*/

#include "areaVectorPicture.H"
#include "fvCFD.H"
#include "fluidRegion.H"
#include "meshQuality.H"
#include "meshQualityVtp.H"
#include "particleFiles.H"
#include "particleMesh.H"
#include "particleResults.H"
#include "patchSurface.H"
#include "qualityPicture.H"
#include "solidBodies.H"
#include "solidParticles.H"
#include "version.H"
#include "virtualDisplay.H"
#include "zoneParticles.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote("Check the quality of a particle mesh");
    argList::noParallel();
    argList::addBoolOption("writeVTK", "Write particles and surface vectors");
    argList::addBoolOption("picture", "Draw the particles");
    argList::addOption("view", "boundBox", "Part of the particles to draw");

    #include "setRootCase.H"
    SPH::printVersion();
    #include "createTime.H"
    #include "createMesh.H"

    const SPH::particleResults results(runTime);
    const SPH::particleMesh all(results.mesh());
    const SPH::particleZone zone(mesh, all.properties());
    const autoPtr<SPH::particleMesh> inZone
    (
        zone.everywhere()
      ? nullptr
      : SPH::zoneParticles(zone, all, results.cellMap()).ptr()
    );
    const SPH::particleMesh& particles = inZone.valid() ? *inZone : all;
    const fvMesh& filled = zone.mesh();
    const List<SPH::particleSet> solids
    (
        SPH::readSolidParticles(SPH::particleFiles(results.mesh().time()))
    );

    const SPH::patchSurface surface(filled, particles.space());

    // Named by sphMesh where they have no patches
    const autoPtr<SPH::solidBodies> bodies
    (
        particles.properties().found("bodies")
      ? new SPH::solidBodies(surface, particles.properties(), 1)
      : nullptr
    );
    const PtrList<SPH::solidBody> none;
    const SPH::fluidRegion fluid
    (
        surface,
        bodies.valid() ? *bodies : none,
        particles.W().support(max(particles.spacing()))
    );
    const SPH::meshQuality quality(filled, particles, solids, fluid);

    Info<< "Time = " << runTime.timeName() << nl << nl
        << "Particle mesh" << nl
        << "    particles:       " << particles.nParticles() << nl
        << "    pairs:           " << particles.nPairs() << nl
        << "    boundary faces:  " << particles.boundary().nFaces() << nl
        << "    solid particles: "
        << quality.nearest().size() - particles.nParticles() << nl << nl
        << "Checking quality..." << nl;
    quality.report(Info());

    const fileName folder
    (
        runTime.path()/"postProcessing"/"checkSphMesh"/runTime.timeName()
    );
    quality.write(folder/"quality.csv");
    if (args.found("writeVTK"))
    {
        SPH::writeMeshQualityVtp(filled, particles, solids, quality, folder);
    }
    if (args.found("picture") || args.found("view"))
    {
        const SPH::virtualDisplay display;
        if (SPH::virtualDisplay::available())
        {
            const boundBox view
            (
                args.getOrDefault<boundBox>("view", filled.bounds())
            );
            SPH::writeQualityPicture
            (
                filled, particles, quality, view, folder/"particles.png"
            );
            if (particles.space().nDims() == 2)
            {
                SPH::writeAreaVectorPicture
                (
                    filled, particles, view, folder/"areaVectors.png"
                );
            }
        }
        else
        {
            WarningInFunction
                << "No picture: it needs an X server, or Xvfb to start one"
                << endl;
        }
    }

    Info<< nl << "Written to " << folder << nl << nl << "End" << nl << endl;

    return 0;
}


// ************************************************************************* //
