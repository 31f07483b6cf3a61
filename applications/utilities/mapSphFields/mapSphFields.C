/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Application
    mapSphFields

Description
    Maps the particle fields stored in \<time\>/lagrangian/sph to volFields
    \<time\>/\<field\>.sph on the case's mesh. The FVM fields stay as they are.

Usage
    \b mapSphFields [-time RANGES | -latestTime] [-fields '(U p)']

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "storedFields.H"
#include "timeSelector.H"

using namespace Foam;

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Map stored particle fields to volFields <time>/<field>.sph"
    );
    timeSelector::addOptions(false, true);
    argList::addOption
    (
        "fields",
        "wordRes",
        "Map only the fields that match, eg '(U p)'; default: all"
    );

    #include "addRegionOption.H"
    #include "setRootCase.H"
    #include "createTime.H"

    const instantList times(timeSelector::select0(runTime, args));

    #include "createNamedMesh.H"

    wordRes names;
    args.readListIfPresent("fields", names);

    const SPH::sphMesh particles(mesh);
    const SPH::particlesToMesh mapper(particles);
    const SPH::storedFields fields(particles, mapper);

    label nMapped = 0;
    forAll(times, timei)
    {
        runTime.setTime(times[timei], timei);
        Info<< "Time = " << runTime.timeName() << nl;

        nMapped += fields.map(names);
    }

    if (nMapped == 0)
    {
        FatalErrorInFunction
            << "Nothing to map: none of the selected times of "
            << runTime.path() << " has matching particle fields in "
            << SPH::storedFields::folder()
            << " and a volField that gives their boundary conditions"
            << exit(FatalError);
    }

    Info<< nl << "Mapped " << nMapped << " fields" << nl
        << "ExecutionTime = " << runTime.elapsedCpuTime() << " s" << nl << nl
        << "End" << nl << endl;

    return 0;
}


// ************************************************************************* //
