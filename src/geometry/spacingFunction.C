/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "uniformSpacing.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    defineTypeNameAndDebug(spacingFunction, 0);
    defineRunTimeSelectionTable(spacingFunction, dictionary);
}
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::List<Foam::vector> Foam::SPH::spacingFunction::shifts
(
    const orientedSurface& surface
)
{
    DynamicList<vector> shifts;
    shifts.append(vector::zero);

    for (const vector& period : surface.periods())
    {
        const vector shift(surface.space().toLocal(period));
        const label n = shifts.size();

        for (label i = 0; i < n; ++i)
        {
            const vector start(shifts[i]);
            shifts.append(start + shift);
            shifts.append(start - shift);
        }
    }

    return List<vector>(std::move(shifts));
}


Foam::scalar Foam::SPH::spacingFunction::positive
(
    const dictionary& dict,
    const word& key
)
{
    const scalar value(dict.get<scalar>(key));

    if (!(value > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << key << " of " << dict.dictName() << " is " << value
            << " but must be positive" << exit(FatalIOError);
    }

    return value;
}


Foam::scalar Foam::SPH::spacingFunction::readGrowth
(
    const dictionary& dict,
    const scalar defaultGrowth
)
{
    const scalar growth(dict.getOrDefault<scalar>("growth", defaultGrowth));

    if (growth < 1 || growth > 1.25)
    {
        FatalIOErrorInFunction(dict)
            << "Entry growth of " << dict.dictName() << " is " << growth
            << ". Valid are factors per particle from 1 to 1.25"
            << exit(FatalIOError);
    }

    return growth;
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::SPH::spacingFunction> Foam::SPH::spacingFunction::New
(
    const patchSurface& surface,
    const dictionary& dict
)
{
    if (!dict.found("spacing"))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'spacing' is missing. Valid are the particle spacing in"
            << " metres, fromMesh, or a dictionary with 'type' of "
            << dictionaryConstructorTablePtr_->sortedToc()
            << exit(FatalIOError);
    }

    const entry& e = *dict.findEntry("spacing");

    // A number or a type alone stand for a dictionary
    dictionary selected(dict, dictionary(fileName("spacing")));
    if (e.isDict())
    {
        selected = e.dict();
    }
    else
    {
        const token t(e.stream());
        if (t.isNumber())
        {
            selected.set("type", word("uniform"));
            selected.set("value", t.number());
        }
        else if (t.isWord())
        {
            selected.set("type", t.wordToken());
        }
    }

    const word type(selected.getOrDefault<word>("type", "none"));
    const auto cstrIter = dictionaryConstructorTablePtr_->cfind(type);

    if (!cstrIter.found())
    {
        FatalIOErrorInFunction(dict)
            << "Unknown type " << type << " of spacing. Valid are the particle"
            << " spacing in metres, or the types "
            << dictionaryConstructorTablePtr_->sortedToc()
            << exit(FatalIOError);
    }

    return cstrIter()(surface, selected);
}


// ************************************************************************* //
