/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "fluidDensity.H"
#include "cellGridLevels.H"
#include "latticePattern.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Smoothing ratio at which the lattices' sums agree best
    static scalar smoothingRatio(const relaxationDomain& domain)
    {
        const label nDims = domain.nDims();
        const latticePattern square(latticePattern::SQUARE, nDims);
        const latticePattern hexagonal(latticePattern::HEXAGONAL, nDims);

        scalar best = 0;
        scalar least = GREAT;
        for (label step = 0; step <= 4; ++step)
        {
            const scalar ratio = domain.bodies[0].smoothingRatio + 0.05*step;
            const scalar difference = mag
            (
                square.characteristicVolume(domain.W, ratio)
               /hexagonal.characteristicVolume(domain.W, ratio)
              - 1
            );
            if (difference < least)
            {
                least = difference;
                best = ratio;
            }
        }

        return best;
    }
}
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::SPH::fluidDensity
(
    const relaxationDomain& domain,
    const relaxationMethod& method,
    particleSystem& particles
)
{
    const kernel& W = domain.W;
    const scalar ratio = smoothingRatio(domain);

    particles.makeImages
    (
        domain.low,
        domain.high,
        W.cutOff()*ratio*max(particles.spacing)
    );

    const scalarField radius(W.cutOff()*ratio*particles.spacing);
    const cellGridLevels grid(particles.positions(), radius, 0.5);

    // Fixed points have roles of their own
    boolList seen(2*particles.nBodies());
    forAll(seen, role)
    {
        seen[role] = method.sees(0, role);
    }

    DynamicList<label> fluid(particles.nParticles());
    for (label i = 0; i < particles.nParticles(); ++i)
    {
        if (particles.role[i] == 0)
        {
            fluid.append(i);
        }
    }

    auto tdensity = tmp<scalarField>::New(fluid.size());
    scalarField& density = tdensity.ref();

    #pragma omp parallel for schedule(dynamic, 256)
    for (label k = 0; k < fluid.size(); ++k)
    {
        const label i = fluid[k];
        const vector p(particles.position(i));
        const scalar h = ratio*particles.spacing[i];

        scalar sum = 0;
        grid.forNear
        (
            p,
            [&](const scalar) { return radius[i]; },
            [&](const label j)
            {
                if (seen[particles.role[j]])
                {
                    const scalar r = mag(p - particles.position(j));
                    sum += particles.V[j]*W.W(r, h);
                }
            }
        );
        density[k] = sum;
    }

    return tdensity;
}


// ************************************************************************* //
