/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "stressModels.H"
#include "checkEntries.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::IOdictionary Foam::SPH::readDictIfPresent
(
    const Time& runTime,
    const word& name,
    const word& folder
)
{
    const IOobject io
    (
        name,
        folder,
        runTime,
        IOobject::READ_IF_PRESENT,
        IOobject::NO_WRITE,
        false
    );
    foundDictionary(io);
    return IOdictionary(io);
}


Foam::List<Foam::SPH::modelEntry> Foam::SPH::stressModels
(
    const dictionary& turbulenceProperties
)
{
    const word type("simulationType");
    const dictionary laminar(turbulenceProperties.subOrEmptyDict("laminar"));

    List<modelEntry> entries(3);
    entries[0] =
    {
        type,
        turbulenceProperties.getOrDefault<word>(type, "laminar"),
        {"laminar"}
    };

    // The key of the laminar model has changed with OpenFOAM's versions
    label k = 1;
    for (const word key : {"laminarModel", "model"})
    {
        entries[k++] =
        {
            key,
            laminar.getOrDefault<word>(key, "Stokes"),
            {"Stokes", "laminar"}
        };
    }

    return entries;
}


// ************************************************************************* //
