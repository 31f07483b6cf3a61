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

#include "compressibleFlow.H"
#include "runSolver.H"

int main(int argc, char *argv[])
{
    return Foam::SPH::runSolver<Foam::SPH::compressibleFlow>
    (
        argc,
        argv,
        "Eulerian SPH solver for compressible laminar flow"
    );
}


// ************************************************************************* //
