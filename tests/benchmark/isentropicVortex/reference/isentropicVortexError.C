/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Application
    isentropicVortexError

Description
    Error of the densities of an isentropic vortex in a particle case, at the
    latest time, against the exact solution, and the change of the total mass,
    momentum and energy since the first time that has a density, over
    the total of the magnitude.

    The vortex of strength 5 starts in (5 5) of a periodic square of side 10,
    in a stream of velocity (1 1 0) with rho = 1 and p = 1:

        rho = (1 - (gamma - 1) 25/(8 gamma pi^2) exp(1 - r^2))^(1/(gamma - 1))

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "particleMesh.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Distance of x from c in a periodic interval of length 10
static scalar periodicDistance(const scalar x, const scalar c)
{
    return std::remainder(x - c, 10);
}


//- A particle field of the current time
template<class Type>
static Field<Type> readParticles(const fvMesh& mesh, const word& name)
{
    return GeometricField<Type, fvPatchField, volMesh>
    (
        IOobject
        (
            name,
            mesh.time().timeName(),
            mesh,
            IOobject::MUST_READ
        ),
        mesh
    ).primitiveField();
}


//- Total mass, momentum and energy, then those of their magnitudes
static FixedList<scalar, 8> totals(const SPH::particleMesh& particles)
{
    const fvMesh& mesh = particles.mesh();
    const scalarField& V = particles.V();
    const scalarField rho(readParticles<scalar>(mesh, "rho"));
    const vectorField rhoU(readParticles<vector>(mesh, "rhoU"));
    const scalarField rhoE(readParticles<scalar>(mesh, "rhoE"));

    FixedList<scalar, 8> t(Zero);
    forAll(V, i)
    {
        const FixedList<scalar, 4> q
        ({
            rho[i], rhoU[i].x(), rhoU[i].y(), rhoE[i]
        });
        for (label k = 0; k < 4; ++k)
        {
            t[k] += V[i]*q[k];
            t[4 + k] += V[i]*mag(q[k]);
        }
    }
    return t;
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::noParallel();

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    const SPH::particleMesh particles(mesh);
    const instantList times(runTime.times());

    const auto stored = [&](const instant& t)
    {
        return isFile(runTime.path()/t.name()/"rho");
    };
    label first = 0;
    while (first < times.size() - 1 && !stored(times[first]))
    {
        ++first;
    }

    runTime.setTime(times[first], first);
    const FixedList<scalar, 8> before(totals(particles));
    runTime.setTime(times.last(), times.size() - 1);
    const FixedList<scalar, 8> after(totals(particles));

    scalar change = 0;
    for (label k = 0; k < 4; ++k)
    {
        change = max(change, mag(after[k] - before[k])/before[4 + k]);
    }

    const scalarField rho(readParticles<scalar>(mesh, "rho"));
    const scalar gamma = 1.4;
    const scalar centre = 5 + runTime.value();

    scalar error = 0;
    scalar largest = 0;
    forAll(rho, i)
    {
        const point& x = particles.C()[i];
        const scalar r2 =
            sqr(periodicDistance(x.x(), centre))
          + sqr(periodicDistance(x.y(), centre));
        const scalar exact =
            std::pow
            (
                1 - (gamma - 1)*25/(8*gamma*sqr(M_PI))*std::exp(1 - r2),
                1/(gamma - 1)
            );
        error += particles.V()[i]*sqr(rho[i] - exact);
        largest = max(largest, mag(rho[i] - exact));
    }

    Info<< "particles " << rho.size() << " time " << runTime.value()
        << " conservation " << change << " Linf " << largest << " L2 "
        << std::sqrt(error/sum(particles.V())) << nl << "End\n" << endl;

    return 0;
}


// ************************************************************************* //
