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
    const scalar step = duration(i);
    if (step <= 0)
    {
        return;
    }

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
            R_[v][i] -=
                still ? 0 : step*magSf*(F.difference[v] + viscous[v]);
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
