/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleResults.H"
#include "particleCase.H"
#include "particleFiles.H"
#include "labelIOList.H"
#include "scalarIOField.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::particleResults::particleResults(autoPtr<Time>&& time)
:
    time_(std::move(time)),
    mesh_
    (
        IOobject
        (
            polyMesh::defaultRegion,
            time_->timeName(),
            *time_,
            IOobject::MUST_READ
        )
    ),
    spacing_(particleFiles(*time_).array<scalarIOField>("spacing")),
    boundaryFace_(particleFiles(*time_).array<labelIOList>("boundaryFace")),
    cellMap_(particleFiles(*time_).cellMap()),
    solidCells_(particleFiles(*time_).solidCells())
{}


Foam::SPH::particleResults::particleResults(const Time& runTime)
:
    particleResults(particleCase::openTime(runTime))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::word Foam::SPH::particleResults::timeName
(
    const instantList& times,
    const instant& time
)
{
    for (const instant& t : times)
    {
        // 'constant' has the value of time 0
        if (equal(t, time) && t.name() != "constant")
        {
            return t.name();
        }
    }
    return word::null;
}


void Foam::SPH::particleResults::requireWhole
(
    const Time& runTime,
    const char* command
)
{
    const fileName path(runTime.path());
    const scalar latest = runTime.times().last().value();

    for (const fileName& name : readDir(path, fileName::DIRECTORY))
    {
        if (!name.starts_with("processor"))
        {
            continue;
        }

        DynamicList<instant> parts;
        for (const instant& t : Time::findTimes(path/name))
        {
            if (t.name() != runTime.constant())
            {
                parts.append(t);
            }
        }
        if (parts.empty() || parts.last().value() <= latest)
        {
            continue;
        }

        OStringStream os;
        os  << "Time " << parts.last().name() << " is in " << path/name
            << ", but not in " << path << ". Put the results of the parallel"
            << " run together with '" << command << "'";
        if (latest <= parts.first().value())
        {
            FatalErrorInFunction << os.str().c_str() << exit(FatalError);
        }
        WarningInFunction << os.str().c_str() << endl;
        return;
    }
}


Foam::IOobjectList Foam::SPH::particleResults::fields
(
    const instant& time
) const
{
    const word name(timeName(time));
    IOobjectList objects;

    if (name.size())
    {
        const IOobjectList all(mesh_, name);
        forAllConstIters(all, iter)
        {
            const word& className = iter()->headerClassName();
            if (className.starts_with("vol") && className.ends_with("Field"))
            {
                autoPtr<IOobject> io(new IOobject(*iter()));
                objects.add(io);
            }
        }
    }
    return objects;
}


// ************************************************************************* //
