/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "unsupportedModels.H"
#include "momentumSources.H"
#include "stressModels.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    static void refuse
    (
        const dictionary& dict,
        const word& entry,
        const word& value,
        const wordList& choices,
        const char* instead
    )
    {
        if (!choices.found(value))
        {
            FatalIOErrorInFunction(dict)
                << "Entry " << entry << " " << value << " is not supported by"
                << " this solver. " << instead << nl << nl << "Valid choices:"
                << nl << choices << exit(FatalIOError);
        }
    }

    //- Refuse all active models of a dictionary that lists them
    static void refuseActive(const dictionary& dict, const char* what)
    {
        for (const entry& e : dict)
        {
            if (e.isDict() && e.dict().getOrDefault<Switch>("active", true))
            {
                FatalIOErrorInFunction(dict)
                    << "Entry " << e.keyword() << ": " << what << " are not"
                    << " supported by this solver. OpenFOAM's own solvers run"
                    << " on the particles: start them with -case sph, or set"
                    << " the entry's 'active' to no" << exit(FatalIOError);
            }
        }
    }
}
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::SPH::refuseUnsupportedModels(const Time& runTime)
{
    const word constant(runTime.constant());

    const IOdictionary turbulence
    (
        readDictIfPresent(runTime, "turbulenceProperties", constant)
    );
    for (const modelEntry& e : stressModels(turbulence))
    {
        refuse
        (
            turbulence,
            e.name,
            e.value,
            e.newtonian,
            "OpenFOAM's own solvers of such flow, for example pimpleFoam, run"
            " on the particles: start them with -case sph"
        );
    }

    momentumSources::refuseOthers(runTime);
    refuseActive
    (
        readDictIfPresent(runTime, "MRFProperties", constant), "rotating frames"
    );
    refuseActive
    (
        readDictIfPresent(runTime, "porosityProperties", constant),
        "porous zones"
    );

    const IOdictionary motion
    (
        readDictIfPresent(runTime, "dynamicMeshDict", constant)
    );
    refuse
    (
        motion,
        "dynamicFvMesh",
        motion.getOrDefault<word>("dynamicFvMesh", "staticFvMesh"),
        {"staticFvMesh"},
        "Particles do not move"
    );
}


void Foam::SPH::leaveOutFunctionObjects
(
    const Time& runTime,
    const wordHashSet& types,
    const char* instead
)
{
    dictionary* functions =
        const_cast<dictionary&>(runTime.controlDict())
       .findDict("functions", keyType::LITERAL);

    if (!functions)
    {
        return;
    }
    for (entry& e : *functions)
    {
        const word type
        (
            e.isDict()
          ? e.dict().getOrDefault<word>("type", word::null)
          : word::null
        );
        if (types.found(type) && e.dict().getOrDefault("enabled", true))
        {
            Info<< "Leaving out the function object " << e.keyword() << ": "
                << type << " needs a turbulence model, which this solver does"
                << " not have" << instead << nl << endl;
            e.dict().set("enabled", false);
        }
    }
}


// ************************************************************************* //
