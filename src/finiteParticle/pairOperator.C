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
Foam::SPH::pairOperator<Flux, Limiter, Viscous>::load
(
    const slicedField& field,
    const label i
)
{
    vars values;
    for (int v = 0; v < nVars; ++v)
    {
        values[v] = field[v][i];
    }
    return values;
}


template<class Flux, class Limiter, bool Viscous>
inline void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::save
(
    const vars& values,
    slicedField& field,
    const label i
)
{
    for (int v = 0; v < nVars; ++v)
    {
        field[v][i] = values[v];
    }
}


template<class Flux, class Limiter, bool Viscous>
void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::setGradients()
{
    const labelList& inner = pairs_.innerSlices();
    const labelList& outer = pairs_.outerSlices();

    #pragma omp parallel for
    for (label k = 0; k < inner.size(); ++k)
    {
        gradients(inner[k]);
    }

    halo_.finish(W_);

    #pragma omp parallel
    {
        #pragma omp for
        for (label k = 0; k < outer.size(); ++k)
        {
            gradients(outer[k]);
        }

        #pragma omp for
        for (label k = 0; k < faces_.owners().size(); ++k)
        {
            addFaceGradients(k);
        }

        if (limitByParticle_)
        {
            #pragma omp for
            for (label slice = 0; slice < pairs_.nSlices(); ++slice)
            {
                limitGradients(slice);
            }
        }

        #pragma omp for
        for (label k = 0; k < firstOrders_.size(); ++k)
        {
            for (label c = 0; c < G_.nComponents(); ++c)
            {
                G_[c][firstOrders_[k]] = 0;
            }
        }
    }

    halo_.start(G_);
}


template<class Flux, class Limiter, bool Viscous>
void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::setRates
(
    const labelUList& slices
)
{
    label nFallbacks = 0;

    #pragma omp parallel for reduction(+:nFallbacks)
    for (label k = 0; k < slices.size(); ++k)
    {
        nFallbacks += pairFluxes(slices[k]);
    }

    nFallbacks_ += nFallbacks;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class Flux, class Limiter, bool Viscous>
Foam::SPH::pairOperator<Flux, Limiter, Viscous>::pairOperator
(
    const Flux& flux,
    const dictionary& schemes,
    faceStates& faces
)
:
    conservationLaw(faces, nVars),
    flux_(flux),
    limitByParticle_
    (
        Limiter::linear
     && schemes.getOrDefault<word>("limiter", "none") == "BarthJespersen"
    ),
    quadraticWall_
    (
        Limiter::linear
     && schemes.getOrDefault<word>("wallGradient", "quadratic") == "quadratic"
    ),
    G_
    (
        Limiter::linear ? nVars*nDims : 0, haloExchange::nSlices(particles_)
    ),
    gradientWeights_(Limiter::linear ? new gradientWeights(faces) : nullptr)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Flux, class Limiter, bool Viscous>
void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::info(Ostream& os) const
{
    conservationLaw::info(os);

    if (Limiter::linear)
    {
        os  << "    particles with an unresolved gradient direction: "
            << gradientWeights_->nDeficient() << nl;
    }
}


template<class Flux, class Limiter, bool Viscous>
void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::setPrimitive
(
    const UList<scalarField>& W
)
{
    for (label i = 0; i < Q_.size(); ++i)
    {
        vars values;
        for (int v = 0; v < nVars; ++v)
        {
            values[v] = W[v][min(i, W[v].size() - 1)];
        }
        save(values, W_, i);
        save(flux_.conserved(values), Q_, i);
    }
}


template<class Flux, class Limiter, bool Viscous>
void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::setConserved
(
    const UList<scalarField>& Q
)
{
    for (label i = 0; i < Q_.size(); ++i)
    {
        vars values;
        for (int v = 0; v < nVars; ++v)
        {
            values[v] = Q[v][min(i, Q[v].size() - 1)];
        }
        save(values, Q_, i);
        save(flux_.primitive(values), W_, i);
    }
}


template<class Flux, class Limiter, bool Viscous>
void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::restore()
{
    Q_ = Q0_;
    for (label i = 0; i < Q_.size(); ++i)
    {
        save(flux_.primitive(load(Q_, i)), W_, i);
    }
}


template<class Flux, class Limiter, bool Viscous>
void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::evaluate()
{
    halo_.start(W_);
    if constexpr (Limiter::linear)
    {
        setGradients();
    }
    setRates(pairs_.innerSlices());
    halo_.finish(Limiter::linear ? G_ : W_);
    setRates(pairs_.outerSlices());

    const label nOwners = faces_.owners().size();

    #pragma omp parallel for
    for (label k = 0; k < nOwners; ++k)
    {
        addFaceFluxes(k);
    }
}


template<class Flux, class Limiter, bool Viscous>
template<class SetConserved>
bool Foam::SPH::pairOperator<Flux, Limiter, Viscous>::setState
(
    const SetConserved& setConserved
)
{
    const Flux flux(flux_);
    const label n = particles_.nParticles();
    bool admissible = true;

    #pragma omp parallel for reduction(&&:admissible)
    for (label i = 0; i < n; ++i)
    {
        setConserved(i);

        const vars W(flux.primitive(load(Q_, i)));
        save(W, W_, i);
        failed_[i] = !flux.admissible(W);
        admissible = admissible && !failed_[i];
    }

    return returnReduce(admissible, andOp<bool>());
}


template<class Flux, class Limiter, bool Viscous>
bool Foam::SPH::pairOperator<Flux, Limiter, Viscous>::update
(
    const scalar a,
    const scalar bDt,
    const label first,
    const label last
)
{
    return setState
    (
        [&](const label i)
        {
            const scalar rate = bDt/V_[0][i];

            for (label v = first; v < last; ++v)
            {
                Q_[v][i] =
                    (1 - a)*Q_[v][i] + a*Q0_[v][i] + rate*R_[v][i];
            }
        }
    );
}


template<class Flux, class Limiter, bool Viscous>
bool Foam::SPH::pairOperator<Flux, Limiter, Viscous>::superStep
(
    const scalar mu,
    const scalar nu,
    const scalar bDt,
    const scalar gDt
)
{
    return setState
    (
        [&](const label i)
        {
            const scalar rV = 1/V_[0][i];

            for (label v = 0; v < nVariables(); ++v)
            {
                const scalar Q = Q_[v][i];
                Q_[v][i] =
                    mu*Q + nu*Qp_[v][i] + (1 - mu - nu)*Q0_[v][i]
                  + rV*(bDt*R_[v][i] + gDt*R0_[v][i]);
                Qp_[v][i] = Q;
            }
        }
    );
}


template<class Flux, class Limiter, bool Viscous>
Foam::label
Foam::SPH::pairOperator<Flux, Limiter, Viscous>::dropReconstruction()
{
    return Limiter::linear ? conservationLaw::dropReconstruction() : 0;
}


template<class Flux, class Limiter, bool Viscous>
Foam::scalar Foam::SPH::pairOperator<Flux, Limiter, Viscous>::waveSpeed
(
    const label i
) const
{
    return flux_.waveSpeed(load(W_, i));
}


template<class Flux, class Limiter, bool Viscous>
Foam::scalar Foam::SPH::pairOperator<Flux, Limiter, Viscous>::stableRate
(
    const scalar maxCo,
    const scalar maxDiffusion
) const
{
    // Fluxes that damp all differences by the speed of sound reduce those of a
    // checkerboard at the rate c sum |A|/V, 4 c/dx in square cells, and the
    // stream adds 2 |u|/dx. Explicit schemes bear 2.5 per step, those of two
    // stages 2; their Courant numbers for gases are .2 of this
    constexpr scalar share = 0.21;

    const label n = particles_.nParticles();
    scalar largest = 0;

    #pragma omp parallel for reduction(max:largest)
    for (label i = 0; i < n; ++i)
    {
        const vars W(load(W_, i));
        const scalar speed = flux_.waveSpeed(W);
        const scalar c = flux_.soundSpeed(W);
        const scalar damped =
            flux_.damping()*c*areaByVolume_[0][i]
          + 2*(speed - c)*rSpacing_[0][i];
        scalar rate = max(speed*rSpacing_[0][i], share*damped)/maxCo;
        if (Viscous)
        {
            rate +=
                flux_.diffusivity(W)*diffusionWeight_[0][i]
               /(V_[0][i]*maxDiffusion);
        }
        largest = max(largest, rate);
    }

    return returnReduce(largest, maxOp<scalar>());
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

template<class Flux>
Foam::autoPtr<Foam::SPH::conservationLaw> Foam::SPH::selectOperator
(
    const Flux& flux,
    const word& defaultLimiter,
    const bool viscous,
    const dictionary& schemes,
    faceStates& faces
)
{
    const auto select = [&](auto limiter)
    {
        using Limiter = decltype(limiter);

        return autoPtr<conservationLaw>
        (
            viscous
          ? static_cast<conservationLaw*>
            (
                new pairOperator<Flux, Limiter, true>(flux, schemes, faces)
            )
          : new pairOperator<Flux, Limiter, false>(flux, schemes, faces)
        );
    };

    const word reconstruction
    (
        checkedWord(schemes, "reconstruction", "linear", {"linear", "none"})
    );
    const word limiter
    (
        checkedWord
        (
            schemes,
            "limiter",
            defaultLimiter,
            {
                "BarthJespersen", "Minmod", "MUSCL", "none", "vanAlbada",
                "vanLeer"
            }
        )
    );
    checkedWord(schemes, "wallGradient", "quadratic", {"linear", "quadratic"});

    if (reconstruction == "none")
    {
        return select(limiters::firstOrder());
    }
    if (limiter == "Minmod")
    {
        return select(limiters::Minmod());
    }
    if (limiter == "MUSCL")
    {
        return select(limiters::MUSCL());
    }
    if (limiter == "vanAlbada")
    {
        return select(limiters::vanAlbada());
    }
    if (limiter == "vanLeer")
    {
        return select(limiters::vanLeer());
    }
    return select(limiters::none());
}


// ************************************************************************* //
