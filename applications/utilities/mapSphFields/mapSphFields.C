/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Application
    mapSphFields

Description
    Maps the fields of the particle case, sph/\<time\>/\<field\> of whatever
    solver, to volFields \<time\>/\<field\>.sph on the case's mesh. The FVM
    fields stay as they are.

Usage
    \b mapSphFields [-time RANGES | -latestTime] [-fields '(U p)']

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "particlesToMesh.H"
#include "timeSelector.H"
#include "version.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Map fields of the particle case to volFields <time>/<field>.sph"
    );
    argList::noParallel();
    timeSelector::addOptions(false, true);
    argList::addOption
    (
        "fields",
        "wordRes",
        "Map only the fields that match, eg '(U p)'; default: all"
    );

    #include "setRootCase.H"
    SPH::printVersion();
    #include "createTime.H"
    #include "createMesh.H"

    wordRes names;
    args.readListIfPresent("fields", names);

    const SPH::particleResults particles(runTime);
    particles.requireWhole();
    const SPH::particlesToMesh mapper(mesh, particles);
    const instantList times(timeSelector::select(particles.times(), args));

    label nMapped = 0;
    forAll(times, timei)
    {
        runTime.setTime(times[timei], timei);
        Info<< "Time = " << runTime.timeName() << nl;

        nMapped += mapper.write(names);
    }

    if (nMapped == 0)
    {
        FatalErrorInFunction
            << "Nothing to map: none of the selected times of "
            << particles.mesh().time().path() << " has matching fields"
            << exit(FatalError);
    }

    Info<< nl << "Mapped " << nMapped << " fields" << nl
        << "ExecutionTime = " << runTime.elapsedCpuTime() << " s" << nl << nl
        << "End" << nl << endl;

    return 0;
}


// ************************************************************************* //
