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
template<bool Sleeping>
inline Foam::label
Foam::SPH::pairOperator<Flux, Limiter, Viscous>::pairFluxes
(
    const label slice
)
{
    const Flux flux(flux_);
    const label i0 = slice*nLanes;
    const int* neighbour = pairs_.neighbour();
    const scalar* areas = pairs_.area();
    const scalar* gradWeights = pairs_.gradWeight();
    const scalar* codes = sleeping_.code();

    const scalar* W[nVars];
    const scalar* G[nVars*nDims];
    for (int v = 0; v < nVars; ++v)
    {
        W[v] = W_[v];
        for (int d = 0; d < nDims && Limiter::linear; ++d)
        {
            G[v*nDims + d] = G_[v*nDims + d];
        }
    }
    const scalar* normals[nDims];
    const scalar* deltas[nDims];
    const scalar* skews[nDims];
    for (int d = 0; d < nDims; ++d)
    {
        normals[d] = pairs_.n(d);
        deltas[d] = pairs_.delta(d);
        skews[d] = pairs_.skew(d);
    }

    scalar rate[nVars][nLanes] = {};
    scalar fallback[nLanes] = {};

    // A function of its own, so that its variables are scalars to the compiler
    // and not arrays over the lanes
    const auto addPair = [&](const label row, const label lane)
    __attribute__((always_inline))
    {
        const std::size_t e = std::size_t(row)*nLanes + lane;
        const label i = i0 + lane;
        const label j = neighbour[e];
        const scalar area = areas[e];
        const scalar sign = std::copysign(scalar(1), area);
        const bool atOwner = sign > 0;

        vec n;
        vec delta;
        for (int d = 0; d < nDims; ++d)
        {
            n[d] = normals[d][e];
            delta[d] = deltas[d][e];
        }

        vars I;
        vars J;
        for (int v = 0; v < nVars; ++v)
        {
            I[v] = W[v][i];
            J[v] = W[v][j];
        }

        vars stateI(I);
        vars stateJ(J);
        if constexpr (Limiter::linear)
        {
            vars stepI(vars::zero());
            vars stepJ(vars::zero());
            for (int v = 0; v < nVars; ++v)
            {
                for (int d = 0; d < nDims; ++d)
                {
                    const scalar half = 0.5*sign*delta[d];
                    const scalar skew = skews[d][e];
                    stepI[v] += G[v*nDims + d][i]*(skew + half);
                    stepJ[v] += G[v*nDims + d][j]*(skew - half);
                }
            }
            stateI = flux.template limitedState<Limiter>(I, J, stepI);
            stateJ = flux.template limitedState<Limiter>(J, I, stepJ);

            if constexpr (Flux::damped)
            {
                scalar divU = 0;
                scalar magSqrDelta = 0;
                for (int d = 0; d < nDims; ++d)
                {
                    const int c = (1 + d)*nDims + d;
                    divU += 0.5*(G[c][i] + G[c][j]);
                    magSqrDelta += delta[d]*delta[d];
                }
                const scalar pressure =
                    flux.dampingPressure(divU, std::sqrt(magSqrDelta));
                stateI[0] += pressure;
                stateJ[0] += pressure;
            }

            const bool physical =
                flux.physical(stateI) & flux.physical(stateJ);
            for (int v = 0; v < nVars; ++v)
            {
                stateI[v] = physical ? stateI[v] : I[v];
                stateJ[v] = physical ? stateJ[v] : J[v];
            }
            fallback[lane] += (physical | (j == i)) ? 0 : 1;
        }

        bool still = false;
        if constexpr (Sleeping)
        {
            still = sleepingSlices::still(codes[i], codes[j]);
            const bool useI = sleepingSlices::isAsleep(codes[i]);
            for (int v = 0; v < nVars; ++v)
            {
                const scalar undisturbed = useI ? I[v] : J[v];
                stateI[v] = still ? undisturbed : stateI[v];
                stateJ[v] = still ? undisturbed : stateJ[v];
            }
        }

        vars L;
        vars R;
        for (int v = 0; v < nVars; ++v)
        {
            L[v] = atOwner ? stateI[v] : stateJ[v];
            R[v] = atOwner ? stateJ[v] : stateI[v];
        }

        const vars F(flux.pairFlux(L, R, I, n));
        for (int v = 0; v < nVars; ++v)
        {
            rate[v][lane] -= area*F[v];
        }

        if constexpr (Viscous)
        {
            vars owner;
            vars other;
            for (int v = 0; v < nVars; ++v)
            {
                owner[v] = atOwner ? I[v] : J[v];
                other[v] = atOwner ? J[v] : I[v];
            }

            const auto meanGradient = [&](const int v, const int d)
            {
                if constexpr (Limiter::linear)
                {
                    return
                        0.5*(G[v*nDims + d][i] + G[v*nDims + d][j]);
                }
                else
                {
                    return scalar(0);
                }
            };

            vars viscous(vars::zero());
            flux.addViscous
            (
                owner, other, meanGradient,
                n, sign*area, delta, gradWeights[e],
                viscous
            );

            // A product, which rounds the same with and without sleep
            const scalar factor = still ? 0 : sign;
            for (int v = 0; v < nVars; ++v)
            {
                rate[v][lane] -= factor*viscous[v];
            }
        }
    };

    for (label row = pairs_.start(slice); row < pairs_.start(slice + 1); ++row)
    {
        #pragma omp simd
        for (label lane = 0; lane < nLanes; ++lane)
        {
            addPair(row, lane);
        }
    }

    for (int v = 0; v < nVars; ++v)
    {
        scalar* R = R_[v] + i0;

        #pragma omp simd
        for (label lane = 0; lane < nLanes; ++lane)
        {
            R[lane] = rate[v][lane];
        }
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
            const vars F(flux.flux(load(W_, i), a));
            for (int v = 0; v < nVars; ++v)
            {
                R_[v][i] -= F[v];
            }
        }
    }

    label nFallbacks = 0;
    if constexpr (Limiter::linear)
    {
        for (label lane = 0; lane < nLanes; ++lane)
        {
            nFallbacks += label(fallback[lane]);
        }
    }
    return nFallbacks;
}


template<class Flux, class Limiter, bool Viscous>
inline typename Flux::vars
Foam::SPH::pairOperator<Flux, Limiter, Viscous>::faceState
(
    const label i,
    const label facei
) const
{
    const vars I(load(W_, i));

    if constexpr (Limiter::linear)
    {
        if (Limiter::limitsPairs && !faces_.reflects(facei))
        {
            return I;
        }

        vec x;
        for (int d = 0; d < nDims; ++d)
        {
            x[d] = faces_.relative()[facei][d];
        }

        vars state(I);
        for (int v = 0; v < nVars; ++v)
        {
            state[v] += increment(v, i, x);
        }
        return flux_.physical(state) ? state : I;
    }
    else
    {
        return I;
    }
}


template<class Flux, class Limiter, bool Viscous>
inline typename Flux::faceFlux
Foam::SPH::pairOperator<Flux, Limiter, Viscous>::reflectedFlux
(
    const vars& L,
    const vars& wall,
    const vars& I,
    const vec& n,
    const label facei
) const
{
    if (!faces_.contact(facei))
    {
        return flux_.wallFlux(L, wall, I, n);
    }

    // The solid particle's state: velocity reversed relative to a no-slip
    // wall, reflected by a slip wall, all else equal
    vars solid(L);
    if (faces_.type(facei) == faceStates::noSlip)
    {
        for (int d = 1; d <= nDims; ++d)
        {
            solid[d] = 2*wall[d] - L[d];
        }
    }
    else
    {
        vec wallNormal;
        for (int d = 0; d < nDims; ++d)
        {
            wallNormal[d] = faces_.wallNormal(facei)[d];
        }
        const scalar through =
            normalVelocity(L, wallNormal) - normalVelocity(wall, wallNormal);
        for (int d = 0; d < nDims; ++d)
        {
            solid[1 + d] -= 2*through*wallNormal[d];
        }
    }

    return totalFlux<nDims>
    (
        flux_.pairFlux(L, solid, I, n), flux_.flux(I, n), flux_.massFactor()
    );
}


template<class Flux, class Limiter, bool Viscous>
inline typename Flux::vars
Foam::SPH::pairOperator<Flux, Limiter, Viscous>::faceViscousFlux
(
    const label i,
    const label facei,
    const vars& outer,
    const vec& n
) const
{
    const vars I(load(W_, i));
    const bool wall = faces_.type(facei) == faceStates::noSlip;
    const scalar r = faces_.distance()[facei];

    vars normalGradient(vars::zero());
    for (int v = 0; v < nVars; ++v)
    {
        if (!faces_.own(v, facei))
        {
            normalGradient[v] = (outer[v] - I[v])/r;

            if constexpr (Limiter::linear)
            {
                // A contact pair does not end at the wall: its gradient is
                // the difference of two particles
                if (wall && quadraticWall_ && !faces_.contact(facei))
                {
                    normalGradient[v] =
                        2*normalGradient[v] - increment(v, i, n);
                }
            }
        }
    }

    return flux_.viscousBoundaryFlux(outer, normalGradient, n);
}


template<class Flux, class Limiter, bool Viscous>
inline void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::addFaceFluxes
(
    const label k
)
{
    const label i = faces_.owners()[k];
    const vars I(load(W_, i));
    const bool sleeping = sleeping_.on() && sleeping_.isStill(i);
    const vars scale(flux_.scale(I));

    for (const label facei : faces_.faces(k))
    {
        vec n;
        for (int d = 0; d < nDims; ++d)
        {
            n[d] = faces_.n()[facei][d];
        }

        const vars L(faceState(i, facei));
        vars outer;
        for (int v = 0; v < nVars; ++v)
        {
            outer[v] = faces_.own(v, facei) ? L[v] : faces_.value(v, facei);
        }

        vars absorbing(outer);
        faces_.complete(L, absorbing, facei);

        // What comes in undisturbed is no change
        const auto type = faces_.type(facei);
        bool still = sleeping && !faces_.reflects(facei);
        for (int v = 0; still && v < nVars; ++v)
        {
            still = calm(absorbing[v] - I[v], scale, v);
        }

        const typename Flux::faceFlux F
        (
            type == faceStates::given
          ? flux_.givenFlux(L, absorbing, I, n)
          : type == faceStates::open
          ? flux_.openFlux(L, absorbing, I, n)
          : reflectedFlux(L, outer, I, n, facei)
        );

        vars viscous(vars::zero());
        if (Viscous && type != faceStates::slip)
        {
            viscous = faceViscousFlux(i, facei, outer, n);
        }

        const scalar magSf = faces_.magSf()[facei];
        for (int v = 0; v < nVars; ++v)
        {
            R_[v][i] -= still ? 0 : magSf*(F.difference[v] + viscous[v]);
        }

        faces_.massFlux()[facei] = magSf*F.mass;
        for (int d = 0; d < nDims; ++d)
        {
            faces_.pressureForce()[facei][d] = magSf*F.momentum[d];
            faces_.viscousForce()[facei][d] = magSf*viscous[1 + d];
        }
    }
}


// ************************************************************************* //
