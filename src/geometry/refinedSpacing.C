/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "refinedSpacing.H"
#include "wordRes.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    defineTypeNameAndDebug(refinedSpacing, 0);
    addToRunTimeSelectionTable(spacingFunction, refinedSpacing, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::SPH::refinedSpacing::growth Foam::SPH::refinedSpacing::readSpacing
(
    const dictionary& dict
) const
{
    growth g;
    g.spacing = positive(dict, "spacing");
    g.slope = readGrowth(dict, 1.05) - 1;
    g.constant = g.spacing*dict.getOrDefault<scalar>("layers", 0);

    if (g.spacing > base_ || g.constant < 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << dict.dictName() << ": the spacing " << g.spacing
            << " must not be larger than base " << base_
            << ", nor layers negative" << exit(FatalIOError);
    }

    return g;
}


void Foam::SPH::refinedSpacing::addPatches
(
    const patchSurface& surface,
    const keyType& name,
    const dictionary& dict
)
{
    const wordList names(surface.mesh().boundaryMesh().names());
    const labelList patches(findStrings(wordRe(name), names));
    const labelList elementis(surface.patchElements(patches));

    if (elementis.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry near: no patch with faces is called " << name
            << ". Valid patches: " << names
            << exit(FatalIOError);
    }

    const growth g(readSpacing(dict));
    const orientedSurface part(surface.subset(elementis));

    // Where the spacing still depends on the patches
    const scalar reach =
        g.slope > 0
      ? g.constant + (base_ - g.spacing)/g.slope
      : mag(surface.bounds().span());

    surfaces_.append
    (
        new surfaceDistance
        (
            orientedSurface
            (
                space_,
                pointField(part.points()),
                List<orientedSurface::element>(part.elements()),
                surface.periods()
            ),
            Foam::min(reach, mag(surface.bounds().span()))
        )
    );
    surfaceGrowth_.append(g);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::refinedSpacing::refinedSpacing
(
    const patchSurface& surface,
    const dictionary& dict
)
:
    space_(surface.space()),
    base_(positive(dict, "base")),
    shifts_(shifts(surface))
{
    const dictionary near(dict.subOrEmptyDict("near"));
    const dictionary regions(dict.subOrEmptyDict("regions"));

    for (const dictionary* group : {&near, &regions})
    {
        for (const entry& e : *group)
        {
            if (!e.isDict())
            {
                FatalIOErrorInFunction(dict)
                    << "Entry " << e.keyword() << " of " << group->dictName()
                    << " is not a dictionary with an entry 'spacing'"
                    << exit(FatalIOError);
            }
        }
    }

    scalar least = base_;

    for (const entry& e : near)
    {
        addPatches(surface, e.keyword(), e.dict());
        least = Foam::min(least, surfaceGrowth_.last().spacing);
    }

    for (const entry& e : regions)
    {
        regions_.append(new spacingRegion(space_, e.dict()));
        regionGrowth_.append(readSpacing(e.dict()));
        least = Foam::min(least, regionGrowth_.last().spacing);
    }

    setRange(least, base_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::SPH::refinedSpacing::operator()(const point& p) const
{
    scalar dp = base_;

    const point x(space_.toLocal(p));
    forAll(regions_, i)
    {
        for (const vector& shift : shifts_)
        {
            const scalar d = regions_[i].distance(x + shift);
            dp = Foam::min(dp, regionGrowth_[i](d));
        }
    }

    forAll(surfaces_, i)
    {
        dp = Foam::min(dp, surfaceGrowth_[i](surfaces_[i].magDistance(p)));
    }

    return dp;
}


Foam::scalar Foam::SPH::refinedSpacing::slope() const
{
    scalar largest = 0;

    for (const auto* all : {&surfaceGrowth_, &regionGrowth_})
    {
        for (const growth& g : *all)
        {
            largest = Foam::max(largest, g.slope);
        }
    }

    return largest;
}


// ************************************************************************* //
