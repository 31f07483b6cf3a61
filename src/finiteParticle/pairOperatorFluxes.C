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
    const pairSlices::rows rows = pairs_.forward(slice);
    const scalar* codes = sleeping_.code();
    scalar* fluxes = fluxes_.data();

    const scalar* W[nVars];
    const scalar* change[nVars];
    const scalar* G[nVars*nDims];
    for (int v = 0; v < nVars; ++v)
    {
        W[v] = W_[v];
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
                    L[v] += change[v][i];
                    R[v] += change[v][j];
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

        // One flux for both, less that of each one's own state
        const auto face(flux.crossing(L, R, n));
        const vars outOfI(flux.difference(face, I, n));
        const vars intoJ(flux.difference(face, J, n));
        for (int v = 0; v < nVars; ++v)
        {
            rate[v][lane] -= area*outOfI[v] + viscous[v];
            fluxes[(std::size_t(row)*nVars + v)*nLanes + lane] =
                area*intoJ[v] + viscous[v];
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
        std::copy_n(rate[v], nLanes, R_[v] + i0);
    }

    label nFallbacks = 0;
    for (label lane = 0; lane < nLanes; ++lane)
    {
        nFallbacks += label(fallback[lane]);
    }
    return nFallbacks;
}


template<class Flux, class Limiter, bool Viscous>
inline void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::addBackwardFluxes
(
    const label slice
)
{
    const label i0 = slice*nLanes;
    const pairSlices::rows rows = pairs_.backward(slice);
    const int* entry = pairs_.entry();
    const scalar* fluxes = fluxes_.data();

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
            for (int v = 0; v < nVars; ++v)
            {
                rate[v][lane] += fluxes[first + v*nLanes];
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
                R_[v][i] -= F[v];
            }
        }
    }
}


template<class Flux, class Limiter, bool Viscous>
inline typename Flux::vars
Foam::SPH::pairOperator<Flux, Limiter, Viscous>::faceState
(
    const label i,
    const label facei
) const
{
    const vars I(stateAhead(i));

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
        pairFlux(flux_, L, solid, I, n), flux_.flux(I, n), flux_.massFactor()
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
                // A condition that gives the gradient has this difference
                // for it. A contact pair does not end at the wall: its gradient
                // is the difference of two particles
                if
                (
                    wall
                 && quadraticWall_
                 && faces_.givesValue(v, facei)
                 && !faces_.contact(facei)
                )
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
        const prescribed gives = faces_.gives(Flux::pressure, facei);
        bool still = sleeping && !faces_.reflects(facei);
        for (int v = 0; still && v < nVars; ++v)
        {
            still = calm(absorbing[v] - I[v], scale, v);
        }

        const typename Flux::faceFlux F
        (
            type == faceStates::given
          ? flux_.givenFlux(L, absorbing, I, n, gives)
          : type == faceStates::open
          ? flux_.openFlux(L, absorbing, I, n, gives)
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
