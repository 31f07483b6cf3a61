/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "stepLevels.H"
#include "PstreamCombineReduceOps.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::SPH::stepLevels::aligned(const label part) const
{
    label k = 0;
    while ((1 << (k + 1)) <= nParts_ && part % (1 << (k + 1)) == 0)
    {
        ++k;
    }
    return k;
}


Foam::labelList Foam::SPH::stepLevels::count
(
    const sleepingSlices& sleeping
) const
{
    labelList n(highest_ + 1, Zero);
    for (label i = 0; i < particles_.nParticles(); ++i)
    {
        if (!sleeping.on() || !sleeping.isAsleep(i))
        {
            ++n[label(level_[0][i])];
        }
    }
    Pstream::listCombineGather(n, plusEqOp<label>());
    Pstream::listCombineScatter(n);
    return n;
}


Foam::label Foam::SPH::stepLevels::worthwhile(const labelUList& n)
{
    // Least part of the work that a level must save, and all together: there is
    // more to do for each evaluation
    constexpr scalar leastOfLevel = 0.02;
    constexpr scalar least = 0.3;

    const scalar all = sum(n);
    scalar above = all;
    scalar saved = 0;
    label k = 0;
    for (label level = 1; level < n.size(); ++level)
    {
        // Those of this level and above take half the steps
        above -= n[level - 1];
        const scalar more = above/(1 << level);
        if (more >= leastOfLevel*all)
        {
            saved += more;
            k = level;
        }
    }
    return saved >= least*all ? k : 0;
}


void Foam::SPH::stepLevels::lower(const label rise)
{
    halo_.start(level_.components());
    halo_.finish(level_.components());

    const scalar* level = level_[0];
    slicedField lowered(level_);

    #pragma omp parallel for
    for (label slice = 0; slice < pairs_.nSlices(); ++slice)
    {
        scalar* least = lowered[0] + slice*nLanes;
        for (const pairSlices::rows& rows : pairs_.all(slice))
        {
            for (label row = rows.begin; row < rows.end; ++row)
            {
                #pragma omp simd
                for (label lane = 0; lane < nLanes; ++lane)
                {
                    const scalar allowed =
                        level[rows.neighbour[row*nLanes + lane]] + rise;
                    least[lane] =
                        allowed < least[lane] ? allowed : least[lane];
                }
            }
        }
    }
    level_ = lowered;
}


void Foam::SPH::stepLevels::setSlices()
{
    const scalar* level = level_[0];

    #pragma omp parallel for
    for (label slice = 0; slice < pairs_.nSlices(); ++slice)
    {
        scalar lowest = highest_;
        scalar highest = 0;
        for (label lane = 0; lane < nLanes; ++lane)
        {
            lowest = min(lowest, level[slice*nLanes + lane]);
            highest = max(highest, level[slice*nLanes + lane]);
        }
        lowest_[slice] = lowest;

        for (const pairSlices::rows& rows : pairs_.all(slice))
        {
            for (label e = rows.begin*nLanes; e < rows.end*nLanes; ++e)
            {
                lowest = min(lowest, level[rows.neighbour[e]]);
                highest = max(highest, level[rows.neighbour[e]]);
            }
        }
        lowestAround_[slice] = lowest;
        mixed_[slice] = lowest < highest;
    }
}


const Foam::labelUList& Foam::SPH::stepLevels::filter
(
    const labelUList& slices,
    const labelList& level
)
{
    if (!on() || beginning_ == nLevels_)
    {
        return slices;
    }

    filtered_.clear();
    for (const label slice : slices)
    {
        if (level[slice] <= beginning_)
        {
            filtered_.append(slice);
        }
    }
    return filtered_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::stepLevels::stepLevels
(
    const particleMesh& particles,
    const pairSlices& pairs,
    haloExchange& halo
)
:
    particles_(particles),
    pairs_(pairs),
    halo_(halo),
    highest_(0),
    rate_(0, 0),
    level_(0, 0),
    step_(0, 0),
    nLevels_(0),
    nParts_(1),
    part_(0),
    beginning_(0),
    ending_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::stepLevels::allow(const label highest)
{
    highest_ = highest;
    rate_ = slicedField(1, pairs_.nSlices());
    level_ = slicedField(1, haloExchange::nSlices(particles_));
    step_ = level_;
    lowest_.setSize(pairs_.nSlices());
    lowestAround_.setSize(pairs_.nSlices());
    mixed_.setSize(pairs_.nSlices());
}


void Foam::SPH::stepLevels::setRates(const label slice, const scalar* rate)
{
    if (allowed())
    {
        std::copy_n(rate, nLanes, rate_[0] + slice*nLanes);
    }
}


void Foam::SPH::stepLevels::set
(
    const scalar largest,
    const sleepingSlices& sleeping
)
{
    const scalar* rate = rate_[0];

    // Particles that are not there limit nothing
    std::fill_n(level_[0], level_.size(), scalar(highest_));
    for (label i = 0; i < particles_.nParticles(); ++i)
    {
        label level = 0;
        while (level < highest_ && rate[i]*(2 << level) <= largest)
        {
            ++level;
        }
        level_[0][i] = level;
    }

    nLevels_ = worthwhile(count(sleeping));
    if (nLevels_)
    {
        lower(0);
        for (label level = 1; level < highest_; ++level)
        {
            lower(1);
        }
        nLevels_ = worthwhile(count(sleeping));
    }
}


void Foam::SPH::stepLevels::start(const label nParts)
{
    nParts_ = nParts;
    if (on())
    {
        nLevels_ = aligned(0);
        for (label i = 0; i < level_.size(); ++i)
        {
            level_[0][i] = min(level_[0][i], scalar(nLevels_));
        }
        halo_.start(level_.components());
        halo_.finish(level_.components());
        setSlices();
    }
}


void Foam::SPH::stepLevels::begin(const label part, const scalar dt)
{
    part_ = part;
    beginning_ = aligned(part);
    ending_ = aligned(part + 1);

    for (label i = 0; i < level_.size(); ++i)
    {
        const label level(level_[0][i]);
        const scalar step = dt/nParts_*(1 << level);
        step_[0][i] = level <= beginning_ ? step : -step;
    }
}


// ************************************************************************* //
