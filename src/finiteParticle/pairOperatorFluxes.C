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
template<bool Sleeping, bool Parts>
inline Foam::label
Foam::SPH::pairOperator<Flux, Limiter, Viscous>::pairFluxes
(
    const label slice,
    const scalar step
)
{
    const Flux flux(flux_);
    const label i0 = slice*nLanes;
    const pairSlices::rows rows = pairs_.forward(slice);
    const scalar* codes = sleeping_.code();
    scalar* fluxes = fluxes_.data();

    const scalar* steps = levels_.step();

    // States at present, and at the start of each one's step
    const scalar* W[nVars];
    const scalar* start[nVars];
    const scalar* change[nVars];
    const scalar* G[nVars*nDims];
    for (int v = 0; v < nVars; ++v)
    {
        W[v] = present()[v];
        start[v] = W_[v];
        if constexpr (predictable)
        {
            change[v] = change_[v];
        }
        for (int d = 0; d < nDims && Limiter::linear; ++d)
        {
            G[v*nDims + d] = G_[v*nDims + d];
        }
    }
    scalar rate[nVars][nLanes] = {};
    scalar fallback[nLanes] = {};

    // A function of its own, so that its variables are scalars to the compiler
    // and not arrays over the lanes
    const auto addPair = [&](const label row, const label lane)
    __attribute__((always_inline))
    {
        const label i = i0 + lane;
        const label j = rows.neighbour[row*nLanes + lane];

        const scalar* g = pairs_.geometry().row(row) + lane;
        const scalar area = g[nDims*nLanes];
        vec n;
        vec delta;
        for (int d = 0; d < nDims; ++d)
        {
            n[d] = g[d*nLanes];
            delta[d] = g[(nDims + 1 + d)*nLanes];
        }

        vars I;
        vars J;
        for (int v = 0; v < nVars; ++v)
        {
            I[v] = W[v][i];
            J[v] = W[v][j];
        }

        // The shorter step of the two, over each one's own
        scalar duration = step;
        scalar shareI = 1;
        scalar shareJ = 1;
        if constexpr (Parts)
        {
            const scalar stepI = std::abs(steps[i]);
            const scalar stepJ = std::abs(steps[j]);
            const scalar shorter = stepI < stepJ ? stepI : stepJ;
            shareI = shorter/stepI;
            shareJ = shorter/stepJ;
            duration = (steps[i] > 0) | (steps[j] > 0) ? shorter : 0;
        }

        const auto meanGradient = [&](const int v, const int d)
        {
            if constexpr (Limiter::linear)
            {
                return 0.5*(G[v*nDims + d][i] + G[v*nDims + d][j]);
            }
            else
            {
                return scalar(0);
            }
        };

        vars L(I);
        vars R(J);
        if constexpr (Limiter::linear)
        {
            vars stepI(vars::zero());
            vars stepJ(vars::zero());
            for (int v = 0; v < nVars; ++v)
            {
                for (int d = 0; d < nDims; ++d)
                {
                    const scalar half = 0.5*delta[d];
                    const scalar skew = g[(2*nDims + 1 + d)*nLanes];
                    stepI[v] += G[v*nDims + d][i]*(skew + half);
                    stepJ[v] += G[v*nDims + d][j]*(skew - half);
                }
            }
            flux.template limitedStates<Limiter>(I, J, stepI, stepJ, L, R);

            if constexpr (predictable)
            {
                for (int v = 0; v < nVars; ++v)
                {
                    L[v] += shareI*change[v][i];
                    R[v] += shareJ*change[v][j];
                }
            }

            if constexpr (Flux::damped)
            {
                scalar divU = 0;
                for (int d = 0; d < nDims; ++d)
                {
                    divU += meanGradient(1 + d, d);
                }
                const scalar pressure =
                    flux.dampingPressure(divU, std::sqrt(dot(delta, delta)));
                L[0] += pressure;
                R[0] += pressure;
            }

            const bool physical = flux.physical(L) & flux.physical(R);
            for (int v = 0; v < nVars; ++v)
            {
                L[v] = physical ? L[v] : I[v];
                R[v] = physical ? R[v] : J[v];
            }
            fallback[lane] +=
                (physical | (j == i) | (duration <= 0)) ? 0 : 1;
        }

        bool still = false;
        if constexpr (Sleeping)
        {
            still = sleepingSlices::still(codes[i], codes[j]);
            const bool useI = sleepingSlices::isAsleep(codes[i]);
            for (int v = 0; v < nVars; ++v)
            {
                const scalar undisturbed = useI ? I[v] : J[v];
                L[v] = still ? undisturbed : L[v];
                R[v] = still ? undisturbed : R[v];
            }
        }

        vars viscous(vars::zero());
        if constexpr (Viscous)
        {
            // The area is chosen and not the flux: so it rounds the same with
            // and without sleep
            flux.addViscous
            (
                I, J, meanGradient, n, still ? 0 : area, delta, viscous
            );
        }

        // One flux for both, less that of each one's own state, which has to
        // be the same for all its pairs
        if constexpr (Parts)
        {
            for (int v = 0; v < nVars; ++v)
            {
                I[v] = start[v][i];
                J[v] = start[v][j];
            }
        }
        const scalar given = duration*area;
        const auto face(flux.crossing(L, R, n));
        const vars outOfI(flux.difference(face, I, n));
        const vars intoJ(flux.difference(face, J, n));
        for (int v = 0; v < nVars; ++v)
        {
            rate[v][lane] -= given*outOfI[v] + viscous[v];
            fluxes[(std::size_t(row)*nVars + v)*nLanes + lane] =
                given*intoJ[v] + viscous[v];
        }
    };

    for (label row = rows.begin; row < rows.end; ++row)
    {
        #pragma omp simd
        for (label lane = 0; lane < nLanes; ++lane)
        {
            addPair(row, lane);
        }
    }

    // Halo particles get theirs on their rank
    if (slice >= pairs_.nSlices())
    {
        return 0;
    }

    for (int v = 0; v < nVars; ++v)
    {
        for (label lane = 0; lane < nLanes; ++lane)
        {
            scalar& R = R_[v][i0 + lane];
            const bool within = Parts && !levels_.begins(i0 + lane);
            R = within ? R + rate[v][lane] : rate[v][lane];
        }
    }

    label nFallbacks = 0;
    for (label lane = 0; lane < nLanes; ++lane)
    {
        nFallbacks += label(fallback[lane]);
    }
    return nFallbacks;
}


template<class Flux, class Limiter, bool Viscous>
template<bool Parts>
inline void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::addBackwardFluxes
(
    const label slice
)
{
    const label i0 = slice*nLanes;
    const pairSlices::rows rows = pairs_.backward(slice);
    const int* entry = pairs_.entry();
    const scalar* fluxes = fluxes_.data();
    const scalar* steps = levels_.step();

    scalar rate[nVars][nLanes];
    for (int v = 0; v < nVars; ++v)
    {
        std::copy_n(R_[v] + i0, nLanes, rate[v]);
    }

    for (label row = rows.begin; row < rows.end; ++row)
    {
        #pragma omp simd
        for (label lane = 0; lane < nLanes; ++lane)
        {
            const std::size_t first =
                rowField::start(entry[row*nLanes + lane], nVars);

            // Those of pairs that begin no step are of an earlier part
            bool begins = true;
            if constexpr (Parts)
            {
                const label j = rows.neighbour[row*nLanes + lane];
                begins = (steps[i0 + lane] > 0) | (steps[j] > 0);
            }
            for (int v = 0; v < nVars; ++v)
            {
                const scalar flux = fluxes[first + v*nLanes];
                rate[v][lane] += begins ? flux : 0;
            }
        }
    }

    for (int v = 0; v < nVars; ++v)
    {
        std::copy_n(rate[v], nLanes, R_[v] + i0);
    }

    if (!closed_)
    {
        for (label i = i0; i < i0 + nLanes; ++i)
        {
            vec a;
            for (int d = 0; d < nDims; ++d)
            {
                a[d] = residualArea_[d][i];
            }
            const vars F(flux_.flux(load(W_, i), a));
            for (int v = 0; v < nVars; ++v)
            {
                R_[v][i] -= duration(i)*F[v];
            }
        }
    }
}


// ************************************************************************* //
