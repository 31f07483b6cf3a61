/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "viscousInertialRelaxation.H"
#include "addToRunTimeSelectionTable.H"
#include "verletList.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    defineTypeNameAndDebug(viscousInertialRelaxation, 0);
    addToRunTimeSelectionTable
    (
        relaxationMethod,
        viscousInertialRelaxation,
        dictionary
    );
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::viscousInertialRelaxation::viscousInertialRelaxation
(
    const dictionary& dict,
    const relaxationDomain& domain
)
:
    gradientDescentRelaxation(dict, domain),
    viscosity_(dict.getOrDefault<scalar>("viscosity", 0.5))
{
    if (viscosity_ <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry viscosity is " << viscosity_
            << ", but must be positive" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::SPH::viscousInertialRelaxation::displacements
(
    const label bodyi,
    const particleSystem& particles,
    const verletList& list,
    const labelUList& targets,
    const vectorField& sums,
    vectorField& steps
)
{
    const scalar ratio = domain_.bodies[bodyi].smoothingRatio;
    const label nParticles = particles.nParticles();

    if (velocity_.size() != nParticles)
    {
        velocity_.setSize(nParticles);
        velocity_ = Zero;
    }

    vectorField acceleration(targets.size());
    scalar largest = VSMALL;

    #pragma omp parallel for schedule(dynamic, 256) reduction(max: largest)
    for (label t = 0; t < targets.size(); ++t)
    {
        const label i = targets[t];
        const vector p(particles.position(i));
        const scalar dp = particles.spacing[i];

        vector friction(Zero);
        for (const label* s = list.begin(i); s < list.end(i); ++s)
        {
            const label j = particles.origin(*s);
            const scalar r = mag(p - particles.position(*s)) + VSMALL;
            friction +=
                particles.V[j]*domain_.W.dWdr(r, ratio*dp)/r
               *(velocity_[i] - velocity_[j]);
        }

        acceleration[t] = viscosity_*dp*friction - 2*sums[t];
        largest = max(largest, mag(acceleration[t])*dp);
    }

    // dt/dp: as far as gradient descent from rest, a quarter of what the
    // stiffest mode bears without growing faster than friction damps it, and
    // the decay time of its velocity
    const scalar dt = min
    (
        sqrt(stepLength()*ratio/largest),
        min
        (
            0.25*sqrt(stableStep_[bodyi]),
            0.5*stableStep_[bodyi]/viscosity_
        )
    );

    steps.setSize(targets.size());

    #pragma omp parallel for
    for (label t = 0; t < targets.size(); ++t)
    {
        const label i = targets[t];
        const scalar dti = dt*particles.spacing[i];

        steps[t] = velocity_[i]*dti + 0.5*acceleration[t]*sqr(dti);
        velocity_[i] += acceleration[t]*dti;
    }

    return sqr(dt);
}


// ************************************************************************* //
