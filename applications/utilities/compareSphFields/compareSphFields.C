/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Application
    compareSphFields

Description
    Compares SPH fields \<field\>.sph with the FVM fields \<field\> of the same
    case and time, or of another case: norms, pictures, profiles and a report
    in postProcessing/compareSphFields/\<time\>. First maps the fields of the
    particle case sph/ that are newer than what was mapped from them.

Usage
    \b compareSphFields [-time RANGES | -latestTime | -withZero]
    [-fields '(U p)'] [-reference CASE] [-dict FILE] [-noPictures]

    What is shown can be chosen in system/compareSphFieldsDict, see
    comparisonControls.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "checkEntries.H"
#include "comparisonPictures.H"
#include "comparisonProfiles.H"
#include "comparisonReport.H"
#include "IOdictionary.H"
#include "particleCase.H"
#include "particlesToMesh.H"
#include "timeSelector.H"
#include "version.H"
#include "virtualDisplay.H"

using namespace Foam;

//- The last time with a field that is not of SPH: mapSphFields makes folders
//- of its own where the particles have other times
instant lastOfFvm(const SPH::referenceCase& reference)
{
    const instantList times(reference.times());
    forAllReverse(times, timei)
    {
        for (const word& field : reference.objects(times[timei]).names())
        {
            if (IOobject::group(field) != "sph")
            {
                return times[timei];
            }
        }
    }
    return instant();
}


//- Map what is new in the particle case and has an FVM field to compare with;
//- at time 0 only if that is selected
void mapNewFields
(
    const argList& args,
    Time& runTime,
    const fvMesh& mesh,
    const SPH::particleResults& particles,
    const SPH::referenceCase& reference
)
{
    const SPH::particlesToMesh mapper(mesh, particles);
    const instant now(runTime.value(), runTime.timeName());

    const auto mapTo = [&](const instant& time, const instant& from)
    {
        const wordList fields(reference.objects(time).sortedNames());
        if (fields.size() && time.name() != runTime.constant())
        {
            wordRes names(fields.size());
            forAll(fields, i)
            {
                names[i] = wordRe(fields[i], wordRe::LITERAL);
            }
            runTime.setTime(time, 0);
            mapper.write(names, from, true);
        }
    };

    const instantList times(particles.times());
    const instantList selected(timeSelector::select(times, args));
    for (const instant& time : times)
    {
        if (time.value() != 0 || selected.found(time))
        {
            mapTo(time, time);
        }
    }

    // Steady runs end when they have converged, each after its own iterations
    const instant last(lastOfFvm(reference));
    const dictionary& ddt = mesh.schemesDict().subDict("ddtSchemes");
    if
    (
        times.size() > 2
     && ddt.found("default")
     && word(ddt.lookup("default")) == "steadyState"
     && !SPH::particleResults::equal(last, times.last())
    )
    {
        Info<< "Steady: particles at time " << times.last().name()
            << " are compared with cells at time " << last.name() << nl;
        mapTo(last, times.last());
    }
    runTime.setTime(now, 0);
    Info<< endl;
}


int main(int argc, char *argv[])
{
    argList::addNote("Compare SPH fields with FVM fields");
    timeSelector::addOptions(false, true);
    #include "addDictOption.H"
    #include "addRegionOption.H"
    argList::addOption
    (
        "fields",
        "wordRes",
        "Compare only the fields that match, eg '(U p)'; default: all"
    );
    argList::addOption
    (
        "reference",
        "case",
        "Compare with the FVM fields of another case, mapped to this mesh"
    );
    argList::addBoolOption("noPictures", "Norms and profiles only");

    #include "setRootCase.H"
    SPH::printVersion();
    #include "createTime.H"
    SPH::particleCase::requireFvm(runTime);
    #include "createNamedMesh.H"

    const word dictName("compareSphFieldsDict");
    #include "setSystemMeshDictionaryIO.H"
    dictIO.readOpt() =
        args.found("dict") ? IOobject::MUST_READ : IOobject::READ_IF_PRESENT;

    SPH::foundDictionary(dictIO);
    IOdictionary dict(dictIO);
    if (args.found("fields"))
    {
        dict.set("fields", args.getList<wordRe>("fields"));
    }

    const SPH::comparisonControls controls(dict);
    const SPH::referenceCase reference
    (
        args.found("reference")
      ? SPH::referenceCase(mesh, args.get<fileName>("reference"))
      : SPH::referenceCase(mesh)
    );

    autoPtr<SPH::particleResults> particles;
    if (isDir(runTime.path()/SPH::particleCase::folder))
    {
        particles.reset(new SPH::particleResults(runTime));
        particles->requireWhole();
        if (!Pstream::parRun() && !args.found("reference"))
        {
            SPH::particleResults::requireWhole(runTime, "reconstructPar");
        }
        mapNewFields(args, runTime, mesh, *particles, reference);
    }

    const SPH::commonFields common
    (
        mesh, reference, controls.fields(), particles.get()
    );
    common.print();

    const instantList times(common.select(args));

    const SPH::solutionSpace space(mesh);
    const SPH::comparisonProfiles profiles(mesh, space, controls);

    // Pictures, profiles and report need the whole mesh
    const bool serial = !Pstream::parRun();

    autoPtr<SPH::virtualDisplay> display;
    autoPtr<SPH::comparisonPictures> pictures;
    if (serial && !args.found("noPictures"))
    {
        display.reset(new SPH::virtualDisplay);
        if (SPH::virtualDisplay::available())
        {
            pictures.reset
            (
                new SPH::comparisonPictures
                (
                    mesh, space, controls, particles.get()
                )
            );
        }
        else
        {
            WarningInFunction
                << "No X server for pictures: install xvfb. Going on without"
                << " pictures" << endl;
        }
    }

    forAll(times, timei)
    {
        runTime.setTime(times[timei], timei);
        Info<< "Time = " << runTime.timeName() << nl << endl;

        const fileName folder
        (
            runTime.globalPath()/"postProcessing"/"compareSphFields"
           /runTime.timeName()
        );

        const SPH::fieldComparison comparison
        (
            mesh,
            reference,
            times[timei],
            common.fields(times[timei]),
            particles.valid() ? particles->solidCells() : labelList()
        );
        comparison.norms().write(folder/"norms.csv");
        SPH::comparisonReport::print(comparison);

        if (serial)
        {
            const SPH::comparisonReport report
            (
                mesh,
                particles.get(),
                reference,
                common,
                comparison,
                pictures.valid()
              ? pictures->write(comparison, folder)
              : DynamicList<fileName>(),
                profiles.write(comparison, folder)
            );
            report.write(folder/"report.html");
        }

        Info<< nl << "    Written to " << folder << nl << nl;
    }

    Info<< "ExecutionTime = " << runTime.elapsedCpuTime() << " s" << nl << nl
        << "End" << nl << endl;

    return 0;
}

// ************************************************************************* //
