/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sphTime.H"
#include "argList.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::sphTime::separateFunctions()
{
    otherFunctions_ = false;

    // Time keeps its dictionary to itself, but reads the functions from it
    // only later
    auto& controls = const_cast<dictionary&>(controlDict());
    dictionary* functions = controls.findDict("functions");

    if (!functions)
    {
        return;
    }

    for (const word& name : functions->toc())
    {
        const dictionary* function = functions->findDict(name);

        if
        (
            function
         && !function->getOrDefault<word>("type", "").starts_with("sph")
        )
        {
            otherFunctions_ = true;
            functions->changeKeyword(name, word(name + ".sph"));
        }
    }
}


void Foam::SPH::sphTime::startAt(const instant& start)
{
    startTime_ = start.value();
    startTimeIndex_ = 0;
    writeTimeIndex_ = 0;

    controlDict().readEntry("deltaT", deltaT_);
    deltaT0_ = deltaT_;
    deltaTSave_ = deltaT_;

    setTime(startTime_, startTimeIndex_);
}


Foam::scalar Foam::SPH::sphTime::nameValue(const scalar time)
{
    return readScalar(timeName(time));
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::SPH::sphTime::readDict()
{
    Time::readDict();
    separateFunctions();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::sphTime::sphTime(const argList& args)
:
    Time(Time::controlDictName, args),
    otherFunctions_(false)
{
    separateFunctions();

    const word startFrom
    (
        controlDict().getOrDefault<word>("startFrom", "latestTime")
    );

    instant start(startTime_, timeName());

    if (startFrom == "latestTime")
    {
        const instantList instants(times());
        label last = -1;
        label first = -1;

        forAll(instants, timei)
        {
            const word& name = instants[timei].name();
            if (name != constant())
            {
                if (hasParticleFields(name))
                {
                    last = timei;
                }
                if (first < 0 && isFile(path()/name/"U"))
                {
                    first = timei;
                }
            }
        }

        if (last >= 0 || first >= 0)
        {
            start = instants[last >= 0 ? last : first];
        }
    }

    startAt(start);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::SPH::sphTime::hasParticleFields(const word& timeName) const
{
    return isFile(path()/timeName/"lagrangian"/"sph"/"positions");
}


void Foam::SPH::sphTime::setStableDeltaT(const scalar stableDeltaT)
{
    scalar target = endTime_;

    if (writeControl_ == wcAdjustableRunTime)
    {
        // From the name of the time, not from sums of time steps: the same
        // number in a run that restarted
        const label next = writeTimeIndex_ + 1;
        target = min(target, nameValue(startTime_ + next*writeInterval_));
    }

    scalar dt = stableDeltaT;
    controlDict().readIfPresent("maxDeltaT", dt);
    dt = min(dt, stableDeltaT);

    const scalar rest = target - value();
    const scalar nSteps = std::ceil(rest/dt - 1e-6);
    if (rest > 0 && nSteps < 4)
    {
        dt = rest/max(nSteps, scalar(1));
    }

    setDeltaT(dt, false);
}


void Foam::SPH::sphTime::alignWriteTime()
{
    if (writeTime())
    {
        setTime(nameValue(value()), timeIndex());
    }
}


void Foam::SPH::sphTime::printProgress() const
{
    const scalar done = value() - startTime_;
    const scalar rest = max(endTime_ - value(), scalar(0));

    Info<< "ExecutionTime = " << elapsedCpuTime() << " s"
        << "  ClockTime = " << elapsedClockTime() << " s";
    if (done > 0)
    {
        Info<< "  left about "
            << label(elapsedClockTime()*rest/done + 0.5) << " s";
    }
    Info<< nl << endl;
}


// ************************************************************************* //
