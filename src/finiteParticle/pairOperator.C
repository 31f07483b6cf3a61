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
inline typename Flux::vars
Foam::SPH::pairOperator<Flux, Limiter, Viscous>::stateAhead
(
    const label i
) const
{
    vars state(load(W_, i));
    if constexpr (predictable)
    {
        for (int v = 0; v < nVars; ++v)
        {
            state[v] += change_[v][i];
        }
    }
    return state;
}


template<class Flux, class Limiter, bool Viscous>
void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::padHalo()
{
    for (label i = Q_.size(); i < W_.size(); ++i)
    {
        save(load(W_, 0), W_, i);
    }
}


template<class Flux, class Limiter, bool Viscous>
void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::setGradients()
{
    sleeping_.update();
    setGradients(pairs_.innerSlices());
    halo_.finish(W_.components());
    setGradients(pairs_.outerSlices());

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
                if (!sleeping_.isUniform(slice))
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

    #pragma omp parallel for reduction(+:nFallbacks)
    for (label k = 0; k < slices.size(); ++k)
    {
        nFallbacks +=
            sleeping_.mayBeStill(slices[k])
          ? pairFluxes<true>(slices[k])
          : pairFluxes<false>(slices[k]);
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
            force[d] = force_[d][i];
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
    padHalo();
    slicesCurrent_ = false;
    limitsCurrent_ = false;
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
    padHalo();
    slicesCurrent_ = false;
    limitsCurrent_ = false;
}


template<class Flux, class Limiter, bool Viscous>
void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::setVelocity
(
    const vectorField& U
)
{
    forAll(U, i)
    {
        vars values(load(W_, i));
        for (int d = 0; d < nDims; ++d)
        {
            values[1 + d] = U[i][particles_.space().axis(d)];
        }
        save(values, W_, i);
        save(flux_.conserved(values), Q_, i);
    }
    slicesCurrent_ = false;
    limitsCurrent_ = false;
}


template<class Flux, class Limiter, bool Viscous>
void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::restore()
{
    Q_ = Q0_;
    for (label i = 0; i < Q_.size(); ++i)
    {
        save(flux_.primitive(load(Q_, i)), W_, i);
    }
    limitsCurrent_ = false;
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
    const bool predicts = predictable && (ahead > 0 || ahead_ > 0);
    ahead_ = ahead;

    halo_.start(W_.components());
    if (twoExchanges)
    {
        setGradients();
    }
    if constexpr (predictable)
    {
        if (predicts)
        {
            predict(0, nSlices);
        }
    }
    setFluxes(pairs_.innerSlices());
    halo_.finish(twoExchanges ? gradientsSent() : W_.components());
    sleeping_.updateHalo();
    if constexpr (predictable)
    {
        if (predicts)
        {
            predict(nSlices, haloExchange::nSlices(particles_));
        }
    }
    setFluxes(pairs_.outerSlices());
    setFluxes(pairs_.haloSlices());

    #pragma omp parallel for
    for (label slice = 0; slice < nSlices; ++slice)
    {
        if (!sleeping_.isStillSlice(slice))
        {
            addBackwardFluxes(slice);
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
template<class Conserved>
bool Foam::SPH::pairOperator<Flux, Limiter, Viscous>::setState
(
    const Conserved& conserved
)
{
    const Flux flux(flux_);
    const label n = particles_.nParticles();
    bool allAdmissible = true;

    #pragma omp parallel for reduction(&&:allAdmissible)
    for (label slice = 0; slice < pairs_.nSlices(); ++slice)
    {
        if (sleeping_.rests(slice))
        {
            continue;
        }

        const label i0 = slice*nLanes;
        bool admissible[nLanes];

        #pragma omp simd
        for (label lane = 0; lane < nLanes; ++lane)
        {
            const label i = i0 + lane;
            const vars Q(conserved(i));
            const vars W(flux.primitive(Q));
            const bool ok = flux.admissible(W);
            for (int v = 0; v < nVars; ++v)
            {
                Q_[v][i] = ok ? Q[v] : Q_[v][i];
                W_[v][i] = ok ? W[v] : W_[v][i];
            }
            admissible[lane] = ok;
        }

        for (label lane = 0; lane < nLanes && i0 + lane < n; ++lane)
        {
            if (!admissible[lane])
            {
                failed_[i0 + lane] = true;
                allAdmissible = false;
            }
        }
    }

    limitsCurrent_ = false;
    return allAdmissible;
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

            // Without a rate nothing changes, to the last bit
            vars Q(load(Q_, i));
            for (label v = first; v < last; ++v)
            {
                Q[v] += a*(Q0_[v][i] - Q[v]) + rate*R_[v][i];
            }
            return Q;
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

            vars Q(load(Q_, i));
            for (label v = 0; v < nVars; ++v)
            {
                const scalar before = Q[v];
                Q[v] +=
                    nu*(Qp_[v][i] - before)
                  + (1 - mu - nu)*(Q0_[v][i] - before)
                  + rV*(bDt*R_[v][i] + gDt*R0_[v][i]);
                Qp_[v][i] = before;
            }
            return Q;
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
