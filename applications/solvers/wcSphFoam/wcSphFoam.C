/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Application
    wcSphFoam

Description
    Laminar flow of an incompressible fluid by weakly compressible Eulerian
    SPH, on the particles of a particle case and from the fields, properties
    and controls that icoFoam uses.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "weaklyCompressibleFlow.H"
#include "treatedParticleMesh.H"
#include "version.H"

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Weakly compressible Eulerian SPH solver for laminar flow"
    );
    SPH::flowSolver::addOptions();

    #include "setRootCaseLists.H"
    SPH::printVersion();
    #include "createTime.H"
    #include "createReadMesh.H"

    SPH::flowSolver::checkCase(args, mesh);
    const autoPtr<SPH::particleMesh> particles(SPH::treatedParticleMesh(mesh));
    SPH::weaklyCompressibleFlow flow(runTime, *particles);

    if (args.found("dry-run"))
    {
        Info<< "The case is complete\n\nEnd\n" << endl;
        return 0;
    }

    Info<< "Starting time loop\n" << endl;

    while (runTime.run())
    {
        flow.setDeltaT();
        ++runTime;

        Info<< "Time = " << runTime.timeName() << nl << endl;

        flow.advance();
        flow.write();
    }

    Info<< "End\n" << endl;

    return 0;
}


// ************************************************************************* //
