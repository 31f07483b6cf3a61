/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "comparisonControls.H"
#include "checkEntries.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::comparisonControls::comparisonControls(const dictionary& dict)
:
    dict_(dict),
    fields_(dict.getOrDefault<wordRes>("fields", wordRes())),
    nContours_(dict.getOrDefault<label>("contours", 12)),
    components_(dict.getOrDefault("components", false)),
    particles_(dict.getOrDefault("particles", false))
{
    checkEntries
    (
        dict,
        {
            "fields", "lines", "views", "ranges", "contours", "components",
            "particles"
        }
    );

    for (const entry& e : lines())
    {
        checkEntries(e.dict(), {"start", "end", "nPoints"});
    }
    for (const entry& e : views())
    {
        checkEntries(e.dict(), {"min", "max", "normal", "origin"});
    }

    if (nContours_ < 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry contours is " << nContours_
            << ". Valid choices: 0 or more" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::comparisonControls::limit
(
    const word& quantity,
    scalar& lowest,
    scalar& highest
) const
{
    const dictionary ranges(dict_.subOrEmptyDict("ranges"));

    if (!ranges.found(quantity))
    {
        return;
    }

    const auto range = ranges.get<Tuple2<scalar, scalar>>(quantity);
    lowest = range.first();
    highest = range.second();

    if (lowest >= highest)
    {
        FatalIOErrorInFunction(dict_)
            << "Entry " << quantity << " in ranges is (" << lowest << ' '
            << highest << "). Valid choices: (lowest highest)"
            << exit(FatalIOError);
    }
}

// ************************************************************************* //
