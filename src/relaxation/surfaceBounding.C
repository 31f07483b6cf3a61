/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "surfaceBounding.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::SPH::surfaceBounding::bound
(
    const label bodyi,
    const scalar dp,
    vector& p
) const
{
    const scalar farther = dp*max
    (
        method_.boundingDistance(bodyi, false),
        method_.boundingDistance(bodyi, true)
    );

    signedDistance::nearest n(domain_.find(bodyi, p));

    // Where two surfaces are near, putting back from one may lead to the
    // other: the position between both is the best one
    const label maxBounces = 3;
    for (label bounce = 0; bounce < maxBounces; ++bounce)
    {
        if (n.distance <= -farther)
        {
            break;
        }

        const bool interface =
            bodyi == 0
         && domain_.nearSolid(p, max(-n.distance, scalar(0)) + 1e-6*dp);
        scalar d = method_.boundingDistance(bodyi, interface)*dp;
        const scalar atSolid = method_.solidDistance()*dp;

        if
        (
            interface
         && n.distance > -d
         && atSolid < d
         && bearsParticles(n, dp, p)
        )
        {
            d = atSolid;
        }

        if (d < 0 || n.distance <= -d)
        {
            break;
        }

        const vector back((n.distance + d)*n.normal);
        const vector q(p - back);
        const signedDistance::nearest m(domain_.find(bodyi, q));

        if (m.distance > -d + 1e-6*dp && m.distance > n.distance - 1e-6*dp)
        {
            const vector between(p - 0.5*back);
            const scalar phi = domain_.distance(bodyi, between);
            if (phi < n.distance)
            {
                p = between;
                return phi;
            }
            break;
        }

        p = q;
        n = m;
    }

    return n.distance;
}


bool Foam::SPH::surfaceBounding::bearsParticles
(
    const signedDistance::nearest& n,
    const scalar dp,
    const vector& p
) const
{
    // From just behind the surface inwards: yes at an edge of a right angle,
    // no in a foil thinner than three spacings
    const vector behind(p + (0.3*dp - n.distance)*n.normal);
    const vector inwards(domain_.find(0, behind).normal);
    return domain_.distance(0, behind + 2.5*dp*inwards) > 0.25*dp;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::SPH::surfaceBounding::move
(
    const label bodyi,
    const label i,
    const vector& step,
    particleSystem& particles
) const
{
    const scalar dp = particles.spacing[i];
    const vector from(particles.position(i));

    vector to(from + step);
    particles.drift[i] += mag(step);

    if (-particles.phi[i] - particles.drift[i] < method_.band(bodyi)*dp)
    {
        particles.phi[i] = bound(bodyi, dp, to);
        particles.drift[i] = 0;
    }

    particles.setPosition(i, to);

    return to - from;
}


// ************************************************************************* //
