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
void Foam::SPH::pairOperator<Flux, Limiter, Viscous>::setPresent()
{
    const Flux flux(flux_);

    if (present_.size() != W_.size())
    {
        present_ = W_;
    }

    #pragma omp parallel for
    for (label slice = 0; slice < pairs_.nSlices(); ++slice)
    {
        if (!levels_.isTouched(slice))
        {
            continue;
        }

        #pragma omp simd
        for (label lane = 0; lane < nLanes; ++lane)
        {
            const label i = slice*nLanes + lane;
            const scalar share = 2*levels_.passed(i);
            const vars start(load(W_, i));
            vars state;
            for (int v = 0; v < nVars; ++v)
            {
                state[v] = start[v] + share*change_[v][i];
            }
            const bool physical = flux.physical(state);
            for (int v = 0; v < nVars; ++v)
            {
                present_[v][i] = physical ? state[v] : start[v];
            }
        }
    }
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
        if (sleeping_.rests(slice) || !levels_.anyEnds(slice))
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

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
            const scalar rate = levels_.ends(i) ? bDt/V_[0][i] : 0;

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


// ************************************************************************* //
