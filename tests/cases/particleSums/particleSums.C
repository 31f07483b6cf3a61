/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Application
    particleSums

Description
    Prints, for the latest time of a case, the sums of volume, density and
    momentum of the particles and the largest deviation of their velocity
    from a given one.

Usage
    \b particleSums [OPTION]

      - \par -velocity \<vector\>
        Velocity to compare with, default (0 0 0)

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "scalarIOField.H"
#include "vectorIOField.H"
#include "sphMesh.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::noParallel();
    argList::addOption("velocity", "vector", "Default (0 0 0)");

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    const instantList times(runTime.times());
    runTime.setTime(times.last(), times.size() - 1);

    const SPH::sphMesh particles(mesh);
    const auto io = [&](const word& name)
    {
        return IOobject
        (
            name,
            runTime.timeName(),
            "lagrangian/sph",
            mesh,
            IOobject::MUST_READ
        );
    };
    const scalarIOField rho(io("rho"));
    const vectorIOField rhoU(io("rhoU"));
    const vectorIOField U(io("U"));
    IOobject energyIO(io("rhoE"));
    energyIO.readOpt() = IOobject::READ_IF_PRESENT;
    const scalarIOField rhoE
    (
        energyIO,
        scalarField(particles.V().size(), Zero)
    );

    OSstream& os = Info;
    os.precision(17);
    const vector momentum(sum(particles.V()*rhoU));
    const vector velocity(args.getOrDefault<vector>("velocity", Zero));

    Info<< "time " << runTime.value() << nl
        << "volume " << sum(particles.V()) << nl
        << "mass " << sum(particles.V()*rho) << nl
        << "momentumX " << momentum.x() << nl
        << "momentumY " << momentum.y() << nl
        << "energy " << sum(particles.V()*rhoE) << nl
        << "deviation " << max(mag(U - velocity)) << nl
        << "End\n" << endl;

    return 0;
}


// ************************************************************************* //
