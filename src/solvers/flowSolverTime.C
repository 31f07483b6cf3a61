/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    Steps in time.

\*---------------------------------------------------------------------------*/

#include "flowSolver.H"
#include "vector2D.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- The time that an adjusted step must not pass: the end or the next write
    static scalar nextTarget(const Time& runTime)
    {
        const dictionary& controls = runTime.controlDict();
        const word control
        (
            controls.getOrDefault<word>("writeControl", "timeStep")
        );

        scalar target = runTime.endTime().value();
        if (control == "adjustableRunTime" || control == "adjustable")
        {
            // From the name of the time, not from sums of time steps: the
            // same number in a run that restarted
            const scalar interval = controls.get<scalar>("writeInterval");
            const scalar start = runTime.startTime().value();
            const scalar n =
                std::floor((runTime.value() - start)/interval + 1e-6) + 1;

            target = min
            (
                target, readScalar(Time::timeName(start + n*interval))
            );
        }
        return target;
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::SPH::flowSolver::stableDeltaT()
{
    // A strong shock may shorten steps by some thousand times
    constexpr scalar collapse = 1e-6;

    const scalar dt = timeScheme_->stableDeltaT(*law_, maxCo_);

    longest_ = max(longest_, dt);
    if (dt < collapse*longest_)
    {
        stop(law_->fastest(), dt);
    }
    return dt;
}


void Foam::SPH::flowSolver::stop(const label i, const scalar dt) const
{
    // The rank that has the particle ends the others
    if (i == -1)
    {
        return;
    }

    scalar magSqrU = 0;
    for (label d = 1; d <= loopDims(particles_); ++d)
    {
        magSqrU += sqr(law_->W()[d][i]);
    }
    const scalar speed = Foam::sqrt(magSqrU);
    const scalar wave = law_->waveSpeed(i);

    wordHashSet patches;
    for (const particlePatch& patch : particles_.boundary())
    {
        if (patch.owner().found(i))
        {
            patches.insert(patch.name());
        }
    }

    FatalErrorInFunction
        << "The flow diverges at time " << runTime_.timeName()
        << ": time steps of " << dt << " s, after " << longest_
        << " s, do not keep the state physical" << nl
        << "    particle " << i << " at " << particles_.C()[i];
    if (patches.size())
    {
        FatalError<< " on " << flatOutput(patches.sortedToc());
    }
    FatalError
        << nl << "    speed " << speed << " m/s, Mach number "
        << speed/(wave - speed) << ", Courant number "
        << wave*dt/particles_.spacing()[i] << nl
        << "Does a patch leave p, T or U free where the flow enters?"
        << " Otherwise lower maxCo (" << maxCo_
        << "), or choose limiter Minmod or reconstruction none in "
        << schemes_.objectPath() << exit(FatalError);
}


void Foam::SPH::flowSolver::step
(
    const scalar dt,
    const scalar timeLeft,
    const label nHalvings
)
{
    constexpr label maxHalvings = 8;

    label failed = -1;
    label nDropped = 0;
    do
    {
        if (timeScheme_->advance(*law_, *faces_, dt, timeLeft))
        {
            faces_->follow(dt);
            law_->resumeReconstruction();
            return;
        }
        failed = law_->failed();
        nDropped = law_->dropReconstruction();
        nDropped_ += nDropped;
    }
    while (nDropped);

    if (nHalvings == maxHalvings)
    {
        stop(failed, dt);
    }

    ++nHalved_;
    step(0.5*dt, timeLeft + 0.5*dt, nHalvings + 1);
    step(0.5*dt, timeLeft, nHalvings + 1);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::flowSolver::setDeltaT()
{
    const dictionary& controls = runTime_.controlDict();
    if (!controls.getOrDefault<Switch>("adjustTimeStep", false))
    {
        return;
    }

    scalar dt = stableDeltaT();
    dt = min(dt, controls.getOrDefault<scalar>("maxDeltaT", GREAT));

    // The last few steps before a write time are equal ones
    const scalar rest = nextTarget(runTime_) - runTime_.value();
    const scalar nSteps = std::ceil(rest/dt - 1e-6);
    if (rest > 0 && nSteps < 4)
    {
        dt = rest/max(nSteps, scalar(1));
    }

    runTime_.setDeltaT(dt, false);
}


void Foam::SPH::flowSolver::advance()
{
    const scalar end = runTime_.value();
    const scalar deltaT = runTime_.deltaTValue();
    const label index = runTime_.timeIndex();

    scalar largest;
    scalar mean;
    law_->acousticRate(largest, mean);

    // Boundary conditions see the time and the length of each step
    label nSteps = 0;
    label nParts = 1;
    scalar longest = 0;
    for (scalar left = deltaT; left > 0; ++nSteps)
    {
        const scalar n = std::ceil(left/stableDeltaT() - 1e-6);
        const scalar dt = n > 1 ? left/n : left;
        left = n > 1 ? left - dt : 0;
        nParts = timeScheme_->nParts(*law_, dt);
        longest = max(longest, dt/nParts);

        if (dt < deltaT)
        {
            runTime_.setDeltaT(dt, false);
            runTime_.setTime(end - left, --subIndex_);
        }
        if (sources_)
        {
            sources_->set(dt);
        }
        step(dt);
        if (sources_)
        {
            // What they write belongs to the time of the run
            runTime_.setTime(end, runTime_.timeIndex());
            sources_->correct();
        }
    }
    if (nSteps > 1)
    {
        runTime_.setDeltaT(deltaT, false);
        runTime_.setTime(end, index);
    }

    Info<< "Courant Number mean: " << mean*longest
        << " max: " << largest*longest;
    if (nSteps > 1)
    {
        Info<< " in " << nSteps << " steps";
    }
    if (nParts > 1)
    {
        Info<< ", longest steps of " << nParts;
    }
    Info<< endl;

    const label nFallbacks = law_->nFallbacks();
    if (nFallbacks || nDropped_ || nHalved_)
    {
        Info<< "Positivity: " << nFallbacks << " reconstructions of first"
            << " order, " << nDropped_ << " particles of first order, "
            << nHalved_ << " steps halved" << endl;
        nDropped_ = 0;
        nHalved_ = 0;
    }
}


void Foam::SPH::flowSolver::printDrift() const
{
    const vector2D sums
    (
        returnReduce(vector2D(sqrU_, sqrChange_), sumOp<vector2D>())
    );
    const scalar sqrU = sums.x();
    const scalar sqrChange = sums.y();

    if (sqrU > 0)
    {
        const scalar change = Foam::sqrt(sqrChange/sqrU);
        const scalar passage = longestSide()/Foam::sqrt(sqrU/volume_);

        Info<< "Drift of U: " << change*passage/runTime_.deltaTValue() << endl;
    }
}


void Foam::SPH::flowSolver::write()
{
    // A restart needs every bit, whatever the case's writePrecision is
    const unsigned precision = IOstream::defaultPrecision(17);
    runTime_.write();
    if (runTime_.writeTime())
    {
        writeAwake();
    }
    IOstream::defaultPrecision(precision);

    const scalar done = runTime_.value() - runTime_.startTime().value();
    const scalar rest = runTime_.endTime().value() - runTime_.value();

    Info<< "ExecutionTime = " << runTime_.elapsedCpuTime() << " s"
        << "  ClockTime = " << runTime_.elapsedClockTime() << " s";
    if (done > 0)
    {
        Info<< "  left about "
            << label
               (
                   runTime_.elapsedClockTime()*max(rest, scalar(0))/done + 0.5
               )
            << " s";
    }
    Info<< nl << endl;
}


// ************************************************************************* //
