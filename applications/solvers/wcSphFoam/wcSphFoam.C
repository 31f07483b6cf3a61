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

#include "weaklyCompressibleFlow.H"
#include "runSolver.H"

int main(int argc, char *argv[])
{
    return Foam::SPH::runSolver<Foam::SPH::weaklyCompressibleFlow>
    (
        argc,
        argv,
        "Weakly compressible Eulerian SPH solver for laminar flow"
    );
}


// ************************************************************************* //
