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
void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::setGradients()
{
    sleeping_.update();
    setGradients(levels_.beginning(pairs_.innerSlices()));
    halo_.finish(present().components());
    setGradients(levels_.beginning(pairs_.outerSlices()));

    if constexpr (Limiter::linear)
    {
        #pragma omp parallel for
        for (label k = 0; k < faces_.owners().size(); ++k)
        {
            addFaceGradients(k);
        }

        if (limitByParticle_)
        {
            #pragma omp parallel for
            for (label slice = 0; slice < pairs_.nSlices(); ++slice)
            {
                if (!sleeping_.isUniform(slice) && levels_.anyBegins(slice))
                {
                    limitGradients(slice);
                }
            }
        }

        #pragma omp parallel for
        for (label k = 0; k < firstOrders_.size(); ++k)
        {
            for (label c = 0; c < G_.nComponents(); ++c)
            {
                G_[c][firstOrders_[k]] = 0;
            }
        }
    }

    sleeping_.updateCalm();
    halo_.start(gradientsSent());
}


template<class Flux, class Limiter, bool Viscous>
void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::setGradients
(
    const labelUList& all
)
{
    const labelUList& slices = sleeping_.gradients(all);

    #pragma omp parallel for
    for (label k = 0; k < slices.size(); ++k)
    {
        if constexpr (Limiter::linear)
        {
            gradients(slices[k]);
        }
        if (!sleeping_.isAwake(slices[k]))
        {
            findCalm(slices[k]);
        }
    }
}


template<class Flux, class Limiter, bool Viscous>
std::vector<Foam::scalar*>
Foam::SPH::pairOperator<Flux, Limiter, Viscous>::gradientsSent()
{
    std::vector<scalar*> arrays(G_.components());
    if (sleeping_.anywhere())
    {
        arrays.push_back(sleeping_.codes()[0]);
    }
    return arrays;
}


template<class Flux, class Limiter, bool Viscous>
void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::setFluxes
(
    const labelUList& all
)
{
    const labelUList& slices = sleeping_.fluxes(all, R_);
    label nFallbacks = 0;

    const auto fluxes = [&](const label slice, auto parts)
    {
        constexpr bool Parts = decltype(parts)::value;
        const scalar step = duration(slice*nLanes);
        return
            sleeping_.mayBeStill(slice)
          ? pairFluxes<true, Parts>(slice, step)
          : pairFluxes<false, Parts>(slice, step);
    };

    #pragma omp parallel for reduction(+:nFallbacks)
    for (label k = 0; k < slices.size(); ++k)
    {
        nFallbacks +=
            predictable && levels_.mixed(slices[k])
          ? fluxes(slices[k], std::bool_constant<predictable>())
          : fluxes(slices[k], std::false_type());
    }

    nFallbacks_ += nFallbacks;
}


template<class Flux, class Limiter, bool Viscous>
void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::addForces()
{
    #pragma omp parallel for
    for (label i = 0; i < force_.size(); ++i)
    {
        vec force;
        for (int d = 0; d < nDims; ++d)
        {
            force[d] = duration(i)*force_[d][i];
        }
        const vars rate(flux_.forced(stateAhead(i), force));
        for (int v = 0; v < nVars; ++v)
        {
            R_[v][i] += rate[v];
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class Flux, class Limiter, bool Viscous>
Foam::SPH::pairOperator<Flux, Limiter, Viscous>::pairOperator
(
    const Flux& flux,
    const bool limitByParticle,
    const bool quadraticWall,
    const dictionary& schemes,
    faceStates& faces
)
:
    conservationLaw
    (
        schemes,
        faces,
        nVars,
        Limiter::limitsPairs || limitByParticle ? limiters::maxSkew : GREAT
    ),
    flux_(flux),
    limitByParticle_(limitByParticle),
    quadraticWall_(quadraticWall),
    G_(0, 0),
    change_(0, 0),
    gradientWeights_(Limiter::linear ? new gradientWeights(faces) : nullptr),
    fluxes_(0, 0)
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
void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::evaluate
(
    const scalar ahead
)
{
    const label nSlices = pairs_.nSlices();
    const bool twoExchanges = Limiter::linear || sleeping_.anywhere();

    if (fluxes_.empty())
    {
        if (Limiter::linear)
        {
            G_ = slicedField(nVars*nDims, haloExchange::nSlices(particles_));
        }
        if (predictable)
        {
            change_ = slicedField(nVars, haloExchange::nSlices(particles_));
        }
        fluxes_ = rowField(nVars, pairs_.nRows());
    }

    // Changes of the last evaluation do not stay
    const bool predicts =
        predictable && (levels_.on() || ahead > 0 || ahead_ > 0);
    ahead_ = ahead;

    if (levels_.on())
    {
        setPresent();
    }
    halo_.start(present().components());
    if (twoExchanges)
    {
        setGradients();
    }
    if constexpr (predictable)
    {
        if (predicts)
        {
            predict(levels_.beginning(pairs_.innerSlices()));
            predict(levels_.beginning(pairs_.outerSlices()));
        }
    }
    setFluxes(levels_.touched(pairs_.innerSlices()));
    halo_.finish(twoExchanges ? gradientsSent() : present().components());
    sleeping_.updateHalo();
    if constexpr (predictable)
    {
        if (predicts)
        {
            predict(pairs_.haloSlices());
        }
    }
    setFluxes(levels_.touched(pairs_.outerSlices()));
    setFluxes(pairs_.haloSlices());

    #pragma omp parallel for
    for (label slice = 0; slice < nSlices; ++slice)
    {
        if (levels_.isTouched(slice) && !sleeping_.isStillSlice(slice))
        {
            if (predictable && levels_.mixed(slice))
            {
                addBackwardFluxes<predictable>(slice);
            }
            else
            {
                addBackwardFluxes<false>(slice);
            }
        }
    }

    const label nOwners = faces_.owners().size();

    #pragma omp parallel for
    for (label k = 0; k < nOwners; ++k)
    {
        addFaceFluxes(k);
    }

    addForces();

    sleeping_.wake(R_);
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
void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::setSliceRates()
{
    // Fluxes that damp all differences by the speed of sound reduce those of a
    // checkerboard at the rate c sum |A|/V, 4 c/dx in square cells, and the
    // stream adds 2 |u|/dx. Explicit schemes bear 2.5 per step, those of two
    // stages 2; their Courant numbers for gases are .2 of this
    constexpr scalar share = 0.21;

    const Flux flux(flux_);

    #pragma omp parallel for
    for (label slice = 0; slice < pairs_.nSlices(); ++slice)
    {
        if (slicesCurrent_ && sleeping_.rests(slice))
        {
            continue;
        }

        const label i0 = slice*nLanes;
        scalar acoustic[nLanes];
        scalar diffusive[nLanes];

        #pragma omp simd
        for (label lane = 0; lane < nLanes; ++lane)
        {
            const label i = i0 + lane;
            const vars W(load(W_, i));
            const scalar speed = flux.waveSpeed(W);
            const scalar c = flux.soundSpeed(W);
            const scalar damped =
                flux.damping()*c*areaByVolume_[0][i]
              + 2*(speed - c)*rSpacing_[0][i];
            const scalar crossed = speed*rSpacing_[0][i];
            acoustic[lane] = max(crossed, share*damped);
            diffusive[lane] =
                Viscous
              ? flux.diffusivity(W)*diffusionWeight_[0][i]/V_[0][i]
              : 0;
        }

        conservationLaw::setSliceRates(slice, acoustic, diffusive);
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

template<class Flux>
Foam::autoPtr<Foam::SPH::conservationLaw> Foam::SPH::selectOperator
(
    const Flux& flux,
    const bool viscous,
    const dictionary& schemes,
    faceStates& faces
)
{
    const word reconstruction
    (
        checkedWord(schemes, "reconstruction", "linear", {"linear", "none"})
    );
    const word limiterName
    (
        checkedWord
        (
            schemes,
            "limiter",
            Flux::defaultLimiter,
            {
                "BarthJespersen", "Minmod", "MUSCL", "none", "vanAlbada",
                "vanLeer"
            }
        )
    );
    const word wallGradient
    (
        checkedWord
        (
            schemes, "wallGradient", "quadratic", {"linear", "quadratic"}
        )
    );

    const auto select = [&](auto limiter)
    {
        const auto make = [&](auto isViscous)
        {
            return autoPtr<conservationLaw>
            (
                new pairOperator
                <
                    Flux, decltype(limiter), decltype(isViscous)::value
                >
                (
                    flux,
                    limiterName == "BarthJespersen",
                    wallGradient == "quadratic",
                    schemes,
                    faces
                )
            );
        };
        return viscous ? make(std::true_type()) : make(std::false_type());
    };

    if (reconstruction == "none")
    {
        return select(limiters::firstOrder());
    }
    if (limiterName == "Minmod")
    {
        return select(limiters::Minmod());
    }
    if (limiterName == "MUSCL")
    {
        return select(limiters::MUSCL());
    }
    if (limiterName == "vanAlbada")
    {
        return select(limiters::vanAlbada());
    }
    if (limiterName == "vanLeer")
    {
        return select(limiters::vanLeer());
    }
    return select(limiters::none());
}


// ************************************************************************* //
