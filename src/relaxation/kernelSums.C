/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "kernelSums.H"
#include "shapedKernel.H"

#include <type_traits>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- x^n with n known to the compiler
    template<int n>
    static inline scalar power(const scalar x)
    {
        if constexpr (n == 0)
        {
            return 1;
        }
        else
        {
            return x*power<n - 1>(x);
        }
    }


    template<int nDims, class Shape, bool uniform>
    static void gradientLoop
    (
        const particleSystem& particles,
        const verletList& list,
        const kernel& W,
        const scalar smoothingRatio,
        const labelUList& targets,
        vectorField& sums
    )
    {
        const scalar* const x = particles.x[0].cdata();
        const scalar* const y = particles.x[1].cdata();
        const scalar* const z = particles.x[2].cdata();
        const scalar* const V = particles.V.cdata();
        const scalar* const dp = particles.spacing.cdata();
        const scalar sigma = W.sigma(1);
        const scalar rRatio = 1/smoothingRatio;

        #pragma omp parallel for schedule(dynamic, 256) \
            if (targets.size() > 1024)
        for (label t = 0; t < targets.size(); ++t)
        {
            const label i = targets[t];
            const label* const row = list.begin(i);
            const label n = list.end(i) - row;
            const scalar xi = x[i];
            const scalar yi = y[i];
            const scalar zi = z[i];
            const scalar rhi = rRatio/dp[i];
            const scalar ci = sigma*power<nDims + 2>(rhi);

            scalar sx = 0;
            scalar sy = 0;
            scalar sz = 0;

            #pragma omp simd reduction(+:sx, sy, sz)
            for (label s = 0; s < n; ++s)
            {
                const label j = row[s];
                const scalar dx = xi - x[j];
                const scalar dy = nDims > 1 ? yi - y[j] : 0;
                const scalar dz = nDims > 2 ? zi - z[j] : 0;

                const scalar r = std::sqrt(dx*dx + dy*dy + dz*dz);

                // dW/dr over r, which is finite where particles meet
                scalar dWByR = ci*Shape::dwByQ(r*rhi);
                if constexpr (!uniform)
                {
                    const scalar rhj = rRatio/dp[j];
                    dWByR = 0.5
                       *(
                            dWByR
                          + sigma*power<nDims + 2>(rhj)*Shape::dwByQ(r*rhj)
                        );
                }

                const scalar f = V[j]*dWByR;
                sx += f*dx;
                sy += f*dy;
                sz += f*dz;
            }

            sums[t] = vector(sx, sy, sz);
        }
    }
}
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::SPH::gradientSums
(
    const particleSystem& particles,
    const verletList& list,
    const kernel& W,
    const scalar smoothingRatio,
    const bool uniform,
    const labelUList& targets,
    vectorField& sums
)
{
    sums.setSize(targets.size());

    withShape
    (
        W,
        [&](auto shape)
        {
            typedef decltype(shape) Shape;

            const auto loop = [&](auto dims)
            {
                constexpr int nDims = decltype(dims)::value;
                if (uniform)
                {
                    gradientLoop<nDims, Shape, true>
                        (particles, list, W, smoothingRatio, targets, sums);
                }
                else
                {
                    gradientLoop<nDims, Shape, false>
                        (particles, list, W, smoothingRatio, targets, sums);
                }
            };

            switch (particles.nDims())
            {
                case 1: loop(std::integral_constant<int, 1>()); break;
                case 2: loop(std::integral_constant<int, 2>()); break;
                default: loop(std::integral_constant<int, 3>());
            }
        }
    );
}


void Foam::SPH::volumeFractions
(
    const particleSystem& particles,
    const verletList& list,
    const kernel& W,
    const scalar smoothingRatio,
    const label roleEnd,
    const labelUList& targets,
    scalarField& fractions
)
{
    fractions.setSize(targets.size());

    #pragma omp parallel for schedule(dynamic, 256)
    for (label t = 0; t < targets.size(); ++t)
    {
        const label i = targets[t];
        const vector p(particles.position(i));
        const scalar hi = smoothingRatio*particles.spacing[i];

        scalar sum = particles.V[i]*W.W(0, hi);
        for (const label* s = list.begin(i); s < list.end(i); ++s)
        {
            const label j = *s;
            if (particles.role[j] < roleEnd)
            {
                const scalar r = mag(p - particles.position(j));
                const scalar hj = smoothingRatio*particles.spacing[j];
                sum += 0.5*particles.V[j]*(W.W(r, hi) + W.W(r, hj));
            }
        }
        fractions[t] = sum;
    }
}


// ************************************************************************* //
