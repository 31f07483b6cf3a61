/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Application
    particleSums

Description
    Prints, for the latest time of a particle case, the sums of volume, pressure
    and, where the solver writes them, momentum, density and energy over the
    particles, and the largest deviation of their velocity from a given one.

Usage
    \b particleSums -case sph [OPTION]

      - \par -velocity \<vector\>
        Velocity to compare with, default (0 0 0)

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "particleMesh.H"

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

    const SPH::particleMesh particles(mesh);
    const auto io = [&](const word& name)
    {
        return IOobject
        (
            name,
            runTime.timeName(),
            mesh,
            IOobject::MUST_READ
        );
    };
    const volVectorField U(io("U"), mesh);

    // The integral of a scalar field
    const auto total = [&](const word& name)
    {
        const volScalarField field(io(name), mesh);
        return sum(particles.V()*field.primitiveField());
    };

    OSstream& os = Info;
    os.precision(17);
    const vector velocity(args.getOrDefault<vector>("velocity", Zero));

    Info<< "time " << runTime.value() << nl
        << "volume " << sum(particles.V()) << nl
        << "pressure " << total("p") << nl
        << "deviation " << max(mag(U.primitiveField() - velocity)) << nl;
    if (io("rhoU").typeHeaderOk<volVectorField>(true))
    {
        const volVectorField rhoU(io("rhoU"), mesh);
        const vector momentum(sum(particles.V()*rhoU.primitiveField()));
        Info<< "momentumX " << momentum.x() << nl
            << "momentumY " << momentum.y() << nl;
    }
    for (const word& name : {"rho", "rhoE"})
    {
        if (io(name).typeHeaderOk<volScalarField>(true))
        {
            Info<< (name == "rho" ? "mass " : "energy ") << total(name) << nl;
        }
    }
    Info<< "End\n" << endl;

    return 0;
}


// ************************************************************************* //
