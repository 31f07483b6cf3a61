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

    const bool all = !levels_.on();
    const scalar* steps = levels_.step();
    const scalar* W[nVars];
    for (int v = 0; v < nVars; ++v)
    {
        W[v] = present()[v];
    }

    scalar sum[nVars*nDims][nLanes] = {};

    // A pair of area vector a
    const auto addPair = [&]
    (
        const label lane,
        const label j,
        const vec& a
    )
    __attribute__((always_inline))
    {
        for (int v = 0; v < nVars; ++v)
        {
            const scalar difference = 0.5*(W[v][j] - W[v][i0 + lane]);
            for (int d = 0; d < nDims; ++d)
            {
                sum[v*nDims + d][lane] += difference*a[d];
            }
        }
    };

    const pairSlices::rows forward = pairs_.forward(slice);
    for (label row = forward.begin; row < forward.end; ++row)
    {
        const scalar* g = pairs_.geometry().row(row);

        #pragma omp simd
        for (label lane = 0; lane < nLanes; ++lane)
        {
            vec a;
            for (int d = 0; d < nDims; ++d)
            {
                a[d] = g[nDims*nLanes + lane]*g[d*nLanes + lane];
            }
            addPair(lane, forward.neighbour[row*nLanes + lane], a);
        }
    }

    const pairSlices::rows backward = pairs_.backward(slice);
    for (label row = backward.begin; row < backward.end; ++row)
    {
        const scalar* A = pairs_.backwardArea().row(row);

        #pragma omp simd
        for (label lane = 0; lane < nLanes; ++lane)
        {
            vec a;
            for (int d = 0; d < nDims; ++d)
            {
                a[d] = A[d*nLanes + lane];
            }
            addPair(lane, backward.neighbour[row*nLanes + lane], a);
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
                if (all || steps[i0 + lane] > 0)
                {
                    G[lane] = g;
                }
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
        if (!levels_.begins(i))
        {
            continue;
        }
        const vars I(load(W_, i));
        const vars scale(flux_.scale(I));

        bool isCalm = true;
        for (const pairSlices::rows& rows : pairs_.all(slice))
        {
            for (label row = rows.begin; isCalm && row < rows.end; ++row)
            {
                const label e = row*nLanes + i % nLanes;
                const vars J(load(present(), rows.neighbour[e]));
                for (int v = 0; v < nVars; ++v)
                {
                    isCalm = isCalm & calm(J[v] - I[v], scale, v);
                }
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
    if (!levels_.begins(i))
    {
        return;
    }

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
    const scalar* geometry = pairs_.geometry().data();

    for (int v = 0; v < nVars; ++v)
    {
        const scalar* W = present()[v];
        scalar lowest[nLanes] = {};
        scalar highest[nLanes] = {};
        scalar limiter[nLanes];
        std::fill_n(limiter, nLanes, scalar(1));

        for (const pairSlices::rows& rows : pairs_.all(slice))
        {
            for (label row = rows.begin; row < rows.end; ++row)
            {
                #pragma omp simd
                for (label lane = 0; lane < nLanes; ++lane)
                {
                    const label j = rows.neighbour[row*nLanes + lane];
                    const scalar difference = W[j] - W[i0 + lane];
                    lowest[lane] =
                        difference < lowest[lane] ? difference : lowest[lane];
                    highest[lane] =
                        difference > highest[lane]
                      ? difference
                      : highest[lane];
                }
            }
        }

        const auto limit = [&]
        (
            const label lane,
            const std::size_t first,
            const scalar direction
        )
        __attribute__((always_inline))
        {
            scalar step = 0;
            for (int d = 0; d < nDims; ++d)
            {
                const scalar half =
                    0.5*direction*geometry[first + (nDims + 1 + d)*nLanes];
                const scalar skew = geometry[first + (2*nDims + 1 + d)*nLanes];
                step += G_[v*nDims + d][i0 + lane]*(skew + half);
            }

            // Rows without a pair limit nothing
            step = geometry[first + nDims*nLanes] > 0 ? step : 0;

            const scalar allowed = limiters::barthJespersen
            (
                step, lowest[lane], highest[lane]
            );
            limiter[lane] = allowed < limiter[lane] ? allowed : limiter[lane];
        };

        const pairSlices::rows forward = pairs_.forward(slice);
        for (label row = forward.begin; row < forward.end; ++row)
        {
            const std::size_t first = std::size_t(row)*nGeometry*nLanes;

            #pragma omp simd
            for (label lane = 0; lane < nLanes; ++lane)
            {
                limit(lane, first + lane, 1);
            }
        }

        const pairSlices::rows backward = pairs_.backward(slice);
        const int* entry = pairs_.entry();
        for (label row = backward.begin; row < backward.end; ++row)
        {
            #pragma omp simd
            for (label lane = 0; lane < nLanes; ++lane)
            {
                const label e = entry[row*nLanes + lane];
                limit(lane, rowField::start(e, nGeometry), -1);
            }
        }

        // Gradients of those within a step are limited already
        for (label lane = 0; lane < nLanes; ++lane)
        {
            limiter[lane] = levels_.begins(i0 + lane) ? limiter[lane] : 1;
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
void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::predict
(
    const labelUList& slices
)
{
    const Flux flux(flux_);
    const slicedField& states = present();
    const bool all = !levels_.on();
    const scalar* steps = levels_.step();
    const bool anyAsleep = sleeping_.anywhere();
    const scalar* codes = sleeping_.code();

    #pragma omp parallel for
    for (label k = 0; k < slices.size(); ++k)
    {
        const label slice = slices[k];

        #pragma omp simd
        for (label lane = 0; lane < nLanes; ++lane)
        {
            const label i = slice*nLanes + lane;
            const auto g = [&](const int v, const int d)
            {
                return G_[v*nDims + d][i];
            };

            // Half-way through each one's own step
            const scalar ahead = all ? ahead_ : 0.5*steps[i];
            const vars step(flux.step(load(states, i), g, ahead));
            const bool still = anyAsleep && sleepingSlices::still(codes[i], 1);
            for (int v = 0; v < nVars; ++v)
            {
                if (all || ahead > 0)
                {
                    change_[v][i] = still ? 0 : step[v];
                }
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
