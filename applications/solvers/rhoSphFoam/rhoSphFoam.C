/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Application
    rhoSphFoam

Description
    Compressible laminar flow of a perfect gas by Eulerian SPH, on the
    particles of a particle case and from the fields, properties and
    controls that rhoCentralFoam uses.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "compressibleFlow.H"
#include "treatedParticleMesh.H"
#include "version.H"

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Eulerian SPH solver for compressible laminar flow"
    );
    flowSolver::addOptions();

    #include "setRootCaseLists.H"
    printVersion();
    #include "createTime.H"
    #include "createReadMesh.H"

    flowSolver::checkCase(args, mesh);
    autoPtr<particleMesh> particles(treatedParticleMesh(mesh));
    compressibleFlow flow(runTime, *particles);

    #include "startTimeLoop.H"

    while (runTime.run())
    {
        flow.setDeltaT();
        ++runTime;

        Info<< "Time = " << runTime.timeName() << nl << endl;

        // Mass, momentum and energy of all particles, by the fluxes
        // between them, in one stable step or in several
        flow.advance();

        // p, T and U with their boundary values
        flow.updateFields();

        flow.printDrift();
        flow.write();
    }

    Info<< "End\n" << endl;

    return 0;
}


// ************************************************************************* //
