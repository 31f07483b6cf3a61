/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "pairOperator.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Flux, class Limiter, bool Viscous>
inline void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::gradients
(
    const label slice
)
{
    const label i0 = slice*nLanes;
    const int* neighbour = pairs_.neighbour();
    const scalar* area = pairs_.area();

    const scalar* W[nVars];
    for (int v = 0; v < nVars; ++v)
    {
        W[v] = W_[v];
    }
    const scalar* n[nDims];
    for (int d = 0; d < nDims; ++d)
    {
        n[d] = pairs_.n(d);
    }

    scalar sum[nVars*nDims][nLanes] = {};

    for (label row = pairs_.start(slice); row < pairs_.start(slice + 1); ++row)
    {
        #pragma omp simd
        for (label lane = 0; lane < nLanes; ++lane)
        {
            const std::size_t e = std::size_t(row)*nLanes + lane;
            const label i = i0 + lane;
            const label j = neighbour[e];
            const scalar halfArea = 0.5*area[e];

            for (int v = 0; v < nVars; ++v)
            {
                const scalar difference = halfArea*(W[v][j] - W[v][i]);
                for (int d = 0; d < nDims; ++d)
                {
                    sum[v*nDims + d][lane] += difference*n[d][e];
                }
            }
        }
    }

    for (int v = 0; v < nVars; ++v)
    {
        const slicedField& B = (*gradientWeights_)[v];
        for (int a = 0; a < nDims; ++a)
        {
            scalar* G = G_[v*nDims + a] + i0;

            #pragma omp simd
            for (label lane = 0; lane < nLanes; ++lane)
            {
                scalar g = 0;
                for (int b = 0; b < nDims; ++b)
                {
                    g += B[a*nDims + b][i0 + lane]*sum[v*nDims + b][lane];
                }
                G[lane] = g;
            }
        }
    }
}


template<class Flux, class Limiter, bool Viscous>
inline bool Foam::SPH::pairOperator<Flux, Limiter, Viscous>::calm
(
    const scalar difference,
    const vars& scale,
    const int v
)
{
    const scalar allowed = sleepingSlices::threshold*scale[v];
    return (difference <= allowed) & (difference >= -allowed);
}


template<class Flux, class Limiter, bool Viscous>
inline void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::findCalm
(
    const label slice
)
{
    const label end =
        min((slice + 1)*nLanes, particles_.nParticles());

    for (label i = slice*nLanes; i < end; ++i)
    {
        const vars I(load(W_, i));
        const vars scale(flux_.scale(I));

        bool isCalm = true;
        for
        (
            label row = pairs_.start(slice);
            isCalm && row < pairs_.start(slice + 1);
            ++row
        )
        {
            const vars J
            (
                load
                (
                    W_,
                    pairs_.neighbour()[std::size_t(row)*nLanes + i % nLanes]
                )
            );
            for (int v = 0; v < nVars; ++v)
            {
                isCalm = isCalm & calm(J[v] - I[v], scale, v);
            }
        }
        sleeping_.setCalm(i, isCalm);
    }
}


template<class Flux, class Limiter, bool Viscous>
inline void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::addFaceGradients
(
    const label k
)
{
    const label i = faces_.owners()[k];
    const vars I(load(W_, i));
    const bool awake = sleeping_.isAwake(i/nLanes);

    for (const label facei : faces_.faces(k))
    {
        vec n;
        for (int d = 0; d < nDims; ++d)
        {
            n[d] = faces_.n()[facei][d];
        }

        // At a plane of symmetry the normal velocity is zero, and nothing else
        // differs from the particle
        const bool mirrored = faces_.type(facei) == faceStates::slip;
        const scalar through = normalVelocity(I, n);

        for (int v = 0; v < nVars; ++v)
        {
            if (faces_.fixed(v, facei))
            {
                const slicedField& B = (*gradientWeights_)[v];
                const bool velocity = v >= 1 && v <= nDims;
                const scalar step =
                    !mirrored ? faces_.value(v, facei) - I[v]
                  : velocity ? -through*n[v - 1]
                  : 0;
                const scalar difference = faces_.magSf()[facei]*step;

                if (!awake && !calm(step, flux_.scale(I), v))
                {
                    sleeping_.setCalm(i, false);
                }

                for (int a = 0; a < nDims; ++a)
                {
                    for (int b = 0; b < nDims; ++b)
                    {
                        G_[v*nDims + a][i] +=
                            B[a*nDims + b][i]
                           *difference*n[b];
                    }
                }
            }
        }
    }
}


template<class Flux, class Limiter, bool Viscous>
inline void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::limitGradients
(
    const label slice
)
{
    const label i0 = slice*nLanes;
    const label start = pairs_.start(slice);
    const label end = pairs_.start(slice + 1);
    const int* neighbour = pairs_.neighbour();
    const scalar* area = pairs_.area();

    for (int v = 0; v < nVars; ++v)
    {
        const scalar* W = W_[v];
        scalar lowest[nLanes] = {};
        scalar highest[nLanes] = {};
        scalar limiter[nLanes];

        #pragma omp simd
        for (label lane = 0; lane < nLanes; ++lane)
        {
            limiter[lane] = 1;
        }

        for (label row = start; row < end; ++row)
        {
            #pragma omp simd
            for (label lane = 0; lane < nLanes; ++lane)
            {
                const std::size_t e = std::size_t(row)*nLanes + lane;
                const scalar difference = W[neighbour[e]] - W[i0 + lane];
                lowest[lane] =
                    difference < lowest[lane] ? difference : lowest[lane];
                highest[lane] =
                    difference > highest[lane] ? difference : highest[lane];
            }
        }

        for (label row = start; row < end; ++row)
        {
            #pragma omp simd
            for (label lane = 0; lane < nLanes; ++lane)
            {
                const std::size_t e = std::size_t(row)*nLanes + lane;
                scalar halfStep = 0;
                for (int d = 0; d < nDims; ++d)
                {
                    halfStep +=
                        G_[v*nDims + d][i0 + lane]*pairs_.delta(d)[e];
                }

                // Rows without a pair limit nothing
                halfStep *= area[e] > 0 ? 0.5 : area[e] < 0 ? -0.5 : 0;

                const scalar allowed = limiters::barthJespersen
                (
                    halfStep, lowest[lane], highest[lane]
                );
                limiter[lane] =
                    allowed < limiter[lane] ? allowed : limiter[lane];
            }
        }

        for (int d = 0; d < nDims; ++d)
        {
            scalar* G = G_[v*nDims + d] + i0;

            #pragma omp simd
            for (label lane = 0; lane < nLanes; ++lane)
            {
                G[lane] *= limiter[lane];
            }
        }
    }
}


template<class Flux, class Limiter, bool Viscous>
inline Foam::scalar
Foam::SPH::pairOperator<Flux, Limiter, Viscous>::increment
(
    const int v,
    const label i,
    const vec& x
) const
{
    scalar e = 0;
    for (int d = 0; d < nDims; ++d)
    {
        e += G_[v*nDims + d][i]*x[d];
    }
    return e;
}


// ************************************************************************* //
