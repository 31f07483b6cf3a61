/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sphSchemes.H"
#include "checkEntries.H"
#include "Time.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::sphSchemes::sphSchemes(const Time& runTime)
:
    IOdictionary
    (
        IOobject
        (
            "sphSchemes",
            runTime.system(),
            runTime,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    )
{
    foundDictionary(*this);
    checkEntries
    (
        *this,
        wordList
        ({
            "scheme", "fluxScheme", "reconstruction", "limiter", "timeScheme",
            "maxCo", "wallGradient", "boundaryTreatment", "soundSpeed",
            "soundSpeedRatio", "absorptionTime", "density", "soundDamping",
            "projectStart", "sleeping", "stepLevels"
        }),
        objectPath()
    );

    if (checkedWord(*this, "scheme", "none", {"none", "papers"}) == "papers")
    {
        const auto setDefault = [&](const word& entry, const word& value)
        {
            if (!found(entry))
            {
                add(entry, value);
            }
        };
        setDefault("reconstruction", "none");
        setDefault("timeScheme", "symplecticEuler");
        setDefault("density", "variable");
        setDefault("projectStart", "no");
        if (!found("maxCo"))
        {
            add("maxCo", 0.5);
        }
    }
}


// ************************************************************************* //
