/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    What the ranks tell each other of a state, once for each step.

\*---------------------------------------------------------------------------*/

#include "conservationLaw.H"
#include "FixedList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Limits of the time step that may be asked for
    constexpr label maxLimits = 7;

    //- What all ranks have to know of a state: of failure and limits the
    //- largest, of the acoustic rate, of particles, first-order pairs and
    //- slices asleep the sum
    typedef FixedList<scalar, 1 + maxLimits + 4> stateTotals;

    struct combineTotals
    {
        stateTotals operator()(stateTotals a, const stateTotals& b) const
        {
            forAll(a, k)
            {
                a[k] = k <= maxLimits ? max(a[k], b[k]) : a[k] + b[k];
            }
            return a;
        }
    };
}
}


// * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * * //

void Foam::SPH::conservationLaw::setSliceRates
(
    const label slice,
    const scalar* acoustic,
    const scalar* diffusive
)
{
    forAll(limits_, k)
    {
        scalar largest = 0;
        for (label lane = 0; lane < nLanes; ++lane)
        {
            const scalar rate =
                limits_[k].rMaxCo*acoustic[lane]
              + limits_[k].rMaxDiffusion*diffusive[lane];
            largest = rate > largest ? rate : largest;
        }
        sliceRates_[k][slice] = largest;
    }

    levels_.setRates(slice, acoustic);

    sliceSums_[slice] = 0;
    for (label lane = 0; lane < nLanes; ++lane)
    {
        sliceSums_[slice] += acoustic[lane];
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::conservationLaw::reduceState()
{
    setSliceRates();
    slicesCurrent_ = true;

    stateTotals totals(Zero);
    scalar* sums = totals.begin() + 1 + maxLimits;
    totals[0] = failed() >= 0;
    forAll(limits_, k)
    {
        for (const scalar rate : sliceRates_[k])
        {
            totals[1 + k] = max(totals[1 + k], rate);
        }
    }
    for (const scalar sum : sliceSums_)
    {
        sums[0] += sum;
    }
    sums[1] = particles_.nParticles();
    sums[2] = nFallbacks_;
    sums[3] = sleeping_.nAsleep();
    reduce(totals, combineTotals());

    physical_ = totals[0] < 0.5;
    forAll(limits_, k)
    {
        limits_[k].rate = totals[1 + k];
    }
    meanAcoustic_ = sums[0]/sums[1];
    nReduced_ += label(sums[2]);
    nFallbacks_ = 0;
    sleeping_.setAnywhere(sums[3] > 0.5);
    limitsCurrent_ = true;

    if (levels_.allowed())
    {
        levels_.set(limits_[0].rate, sleeping_);
    }
}


Foam::SPH::stepLevels& Foam::SPH::conservationLaw::levels()
{
    if (levels_.allowed() && !limitsCurrent_)
    {
        reduceState();
    }
    return levels_;
}


void Foam::SPH::conservationLaw::acousticRate
(
    scalar& largest,
    scalar& mean
)
{
    largest = stableRate(1, GREAT);
    mean = meanAcoustic_;
}


Foam::label Foam::SPH::conservationLaw::fastest()
{
    scalar largest;
    scalar mean;
    acousticRate(largest, mean);

    const label slice = sliceRates_[0].find(largest);
    if (slice < 0)
    {
        return -1;
    }

    label fastest = slice*nLanes;
    for (label lane = 1; lane < nLanes; ++lane)
    {
        const label i = slice*nLanes + lane;
        if
        (
            rSpacing_[0][i] > 0
         && waveSpeed(i)*rSpacing_[0][i]
          > waveSpeed(fastest)*rSpacing_[0][fastest]
        )
        {
            fastest = i;
        }
    }
    return fastest;
}


Foam::scalar Foam::SPH::conservationLaw::stableRate
(
    const scalar maxCo,
    const scalar maxDiffusion
)
{
    // What is as large as that limits nothing
    const scalar rMaxCo = maxCo < GREAT ? 1/maxCo : 0;
    const scalar rMaxDiffusion = maxDiffusion < GREAT ? 1/maxDiffusion : 0;

    label k = 0;
    while
    (
        k < limits_.size()
     && (
            limits_[k].rMaxCo != rMaxCo
         || limits_[k].rMaxDiffusion != rMaxDiffusion
        )
    )
    {
        ++k;
    }

    if (k == limits_.size())
    {
        if (k == maxLimits)
        {
            FatalErrorInFunction
                << "More than " << maxLimits << " limits of the time step"
                << abort(FatalError);
        }
        limits_.append(stepLimit{rMaxCo, rMaxDiffusion, 0});
        sliceRates_.append(scalarList(pairs_.nSlices(), Zero));
        slicesCurrent_ = false;
        limitsCurrent_ = false;
    }

    if (!limitsCurrent_)
    {
        reduceState();
    }
    return limits_[k].rate;
}


// ************************************************************************* //
