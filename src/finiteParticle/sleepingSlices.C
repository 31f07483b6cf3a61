/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sleepingSlices.H"
#include "haloExchange.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::sleepingSlices::setNeighbours()
{
    DynamicList<label> found;
    labelList lastSeen(flags_.size(), -1);

    for (label slice = 0; slice < pairs_.nSlices(); ++slice)
    {
        start_[slice] = found.size();
        lastSeen[slice] = slice;

        for (const pairSlices::rows& rows : pairs_.all(slice))
        {
            forwardEnd_[slice] = found.size();
            for (label e = rows.begin*nLanes; e < rows.end*nLanes; ++e)
            {
                const label other = rows.neighbour[e]/nLanes;
                if (lastSeen[other] != slice)
                {
                    lastSeen[other] = slice;
                    found.append(other);
                }
            }
        }
    }
    start_.last() = found.size();
    neighbours_.transfer(found);
}


Foam::label Foam::SPH::sleepingSlices::nParticles(const label slice) const
{
    const bool halo = slice >= pairs_.nSlices();
    return min
    (
        nLanes,
        halo
      ? particles_.nHalo() - (slice - pairs_.nSlices())*nLanes
      : particles_.nParticles() - slice*nLanes
    );
}


void Foam::SPH::sleepingSlices::setFlags(const label slice)
{
    const scalar* code = code_[0] + slice*nLanes;
    const label n = nParticles(slice);

    particleFlags flags{false, true, false, true};
    for (label lane = 0; lane < n; ++lane)
    {
        const bool asleep = isAsleep(code[lane]);
        flags.anyAsleep = flags.anyAsleep || asleep;
        flags.allAsleep = flags.allAsleep && asleep;
        const bool calm = code[lane] > 0.5;
        flags.anyCalm = flags.anyCalm || calm;
        flags.allCalm = flags.allCalm && calm;
    }
    flags_[slice] = flags;
}


template<class Property>
inline bool Foam::SPH::sleepingSlices::allAround
(
    const label slice,
    const Property& property
) const
{
    if (!property(flags_[slice]))
    {
        return false;
    }
    for (label k = start_[slice]; k < start_[slice + 1]; ++k)
    {
        if (!property(flags_[neighbours_[k]]))
        {
            return false;
        }
    }
    return true;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::sleepingSlices::sleepingSlices
(
    const faceStates& faces,
    const pairSlices& pairs,
    const bool on
)
:
    particles_(faces.particles()),
    pairs_(pairs),
    on_(on),
    anywhere_(false),
    code_(on ? 1 : 0, haloExchange::nSlices(particles_)),
    start_(pairs.nSlices() + 1, Zero),
    forwardEnd_(pairs.nSlices(), Zero),
    boundary_(pairs.nSlices(), false),
    flags_(code_.nSlices(), {false, false, false, false}),
    state_(pairs.nSlices(), awake),
    still_(pairs.nSlices(), false)
{
    if (on)
    {
        setNeighbours();
        for (const label i : faces.owners())
        {
            boundary_[i/nLanes] = true;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::labelUList& Foam::SPH::sleepingSlices::gradients
(
    const labelUList& slices
)
{
    if (asleep_.empty())
    {
        return slices;
    }

    gradients_.clear();
    for (const label slice : slices)
    {
        if (!isUniform(slice))
        {
            gradients_.append(slice);
        }
    }
    return gradients_;
}


const Foam::labelUList& Foam::SPH::sleepingSlices::fluxes
(
    const labelUList& slices,
    slicedField& R
)
{
    const label nSlices = pairs_.nSlices();
    if (asleep_.empty() || slices.empty() || slices[0] >= nSlices)
    {
        return slices;
    }

    const auto calm = [](const particleFlags& flags)
    {
        return flags.allCalm;
    };

    #pragma omp parallel for
    for (label k = 0; k < slices.size(); ++k)
    {
        const label slice = slices[k];
        still_[slice] =
            state_[slice] != awake
         && flags_[slice].allAsleep
         && allAround(slice, calm);

        // By boundary faces they may not have been zero
        if (still_[slice] && boundary_[slice])
        {
            for (label v = 0; v < R.nComponents(); ++v)
            {
                std::fill_n(R[v] + slice*nLanes, nLanes, scalar(0));
            }
        }
    }

    // Those with pairs forward to a slice whose rates are computed have fluxes
    // for it
    fluxes_.clear();
    for (const label slice : slices)
    {
        bool needed = !still_[slice];
        for
        (
            label k = start_[slice];
            !needed && k < forwardEnd_[slice];
            ++k
        )
        {
            needed = neighbours_[k] < nSlices && !still_[neighbours_[k]];
        }
        if (needed)
        {
            fluxes_.append(slice);
        }
    }
    return fluxes_;
}


void Foam::SPH::sleepingSlices::start(const slicedField& W)
{
    boolList asleep(particles_.nParticles(), true);

    for (label slice = 0; slice < pairs_.nSlices(); ++slice)
    {
        const label n = nParticles(slice);
        for (const pairSlices::rows& rows : pairs_.all(slice))
        {
            for (label e = rows.begin*nLanes; e < rows.end*nLanes; ++e)
            {
                const label lane = e % nLanes;
                const label i = slice*nLanes + lane;
                const label j = rows.neighbour[e];
                for (label v = 0; lane < n && v < W.nComponents(); ++v)
                {
                    asleep[i] = asleep[i] && W[v][j] == W[v][i];
                }
            }
        }
    }

    start(asleep);
}


void Foam::SPH::sleepingSlices::start(const UList<bool>& asleep)
{
    // Padding takes part in the loops, but not in the flags
    std::fill_n(code_[0], code_.size(), scalar(2));
    forAll(asleep, i)
    {
        code_[0][i] = asleep[i] ? 2 : 0;
    }

    // Of the halo nothing is known before its codes are exchanged
    forAll(flags_, slice)
    {
        setFlags(slice);
        if (slice >= pairs_.nSlices())
        {
            flags_[slice] = {true, false, false, false};
        }
    }

    forAll(state_, slice)
    {
        state_[slice] = boundary_[slice] ? waking : sleeping;
    }
    still_ = false;
    anywhere_ = true;
    asleep_ = identity(pairs_.nSlices());
}


void Foam::SPH::sleepingSlices::update()
{
    if (asleep_.empty())
    {
        return;
    }

    #pragma omp parallel for
    for (label k = 0; k < asleep_.size(); ++k)
    {
        const label slice = asleep_[k];

        const auto allAsleep = [](const particleFlags& flags)
        {
            return flags.allAsleep;
        };
        const auto noneAsleep = [](const particleFlags& flags)
        {
            return !flags.anyAsleep;
        };

        if (state_[slice] == sleeping && !allAround(slice, allAsleep))
        {
            state_[slice] = waking;
        }
        if (state_[slice] == waking && allAround(slice, noneAsleep))
        {
            state_[slice] = awake;
            still_[slice] = false;
        }
    }

    DynamicList<label> left(asleep_.size());
    for (const label slice : asleep_)
    {
        if (state_[slice] == awake)
        {
            std::fill_n(code_[0] + slice*nLanes, nLanes, scalar(0));
            setFlags(slice);
        }
        else
        {
            left.append(slice);
        }
    }
    asleep_.transfer(left);
}


void Foam::SPH::sleepingSlices::updateCalm()
{
    #pragma omp parallel for
    for (label k = 0; k < asleep_.size(); ++k)
    {
        const label slice = asleep_[k];
        if (state_[slice] == waking)
        {
            setFlags(slice);
        }

        // Not known before the halo is
        still_[slice] = false;
    }
}


void Foam::SPH::sleepingSlices::updateHalo()
{
    for
    (
        label slice = pairs_.nSlices();
        anywhere_ && slice < flags_.size();
        ++slice
    )
    {
        setFlags(slice);
    }
}


void Foam::SPH::sleepingSlices::wake(const slicedField& R)
{
    #pragma omp parallel for
    for (label k = 0; k < asleep_.size(); ++k)
    {
        const label slice = asleep_[k];
        if (!flags_[slice].anyAsleep || (still_[slice] && !boundary_[slice]))
        {
            continue;
        }

        const label end = slice*nLanes + nParticles(slice);
        for (label i = slice*nLanes; i < end; ++i)
        {
            scalar& code = code_[0][i];
            for (label v = 0; v < R.nComponents(); ++v)
            {
                if (isAsleep(code) && R[v][i] != 0)
                {
                    code = code > 0 ? 1 : 0;
                }
            }
        }
        setFlags(slice);
    }
}


// ************************************************************************* //
