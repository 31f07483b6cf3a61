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

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Weakly compressible Eulerian SPH solver for laminar flow"
    );
    flowSolver::addOptions();

    #include "setRootCaseLists.H"
    printVersion();
    #include "createTime.H"
    #include "createReadMesh.H"

    flowSolver::checkCase(args, mesh);
    autoPtr<particleMesh> particles(treatedParticleMesh(mesh));
    weaklyCompressibleFlow flow(runTime, *particles);

    #include "startTimeLoop.H"

    while (runTime.run())
    {
        flow.setDeltaT();
        ++runTime;

        Info<< "Time = " << runTime.timeName() << nl << endl;

        // Pressure and momentum of all particles, by the fluxes
        // between them, in one stable step or in several
        flow.advance();

        // p and U with their boundary values
        flow.updateFields();

        flow.printDrift();
        flow.write();
    }

    Info<< "End\n" << endl;

    return 0;
}


// ************************************************************************* //
