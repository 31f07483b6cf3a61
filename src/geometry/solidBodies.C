/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "solidBodies.H"
#include "borderPatch.H"
#include "fileSurface.H"
#include "spacingFunction.H"
#include "emptyPolyPatch.H"
#include "wallPolyPatch.H"
#include "Time.H"
#include "HashSet.H"
#include "wordRes.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
namespace
{

//- Least mean thickness of a cut body over the spacing: particles on both sides
//- of a thinner one push each other out of place
const scalar leastThickness = 0.5;


//- Names of the patches that may bound a body
wordList boundingPatches(const polyMesh& mesh)
{
    DynamicList<word> names;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (!isA<emptyPolyPatch>(pp) && !pp.coupled())
        {
            names.append(pp.name());
        }
    }

    return wordList(std::move(names));
}


//- Patch with most of the elements
label mainPatch(const orientedSurface& surface, const labelUList& elementis)
{
    Map<label> count;
    label main = -1;
    for (const label elementi : elementis)
    {
        const label patchi = surface.elements()[elementi].patchi;
        const label n = ++count(patchi, 0);

        if (main < 0 || n > count[main])
        {
            main = patchi;
        }
    }

    return main;
}

} // End anonymous namespace
} // End namespace SPH
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::SPH::solidBodies::isCut(const word& name) const
{
    const polyBoundaryMesh& patches = surface_.mesh().boundaryMesh();
    const label patchi = patches.findPatchID(name);
    return patchi >= 0 && isCutBody(patches[patchi]);
}


Foam::autoPtr<Foam::SPH::solidBody> Foam::SPH::solidBodies::makeBody
(
    const word& name,
    const labelUList& elementis,
    const scalar smoothingRatio
) const
{
    labelHashSet patches;
    for (const label elementi : elementis)
    {
        patches.insert(surface_.elements()[elementi].patchi);
    }

    return autoPtr<solidBody>::New
    (
        name,
        surface_.subset(elementis, true),
        patches.sortedToc(),
        smoothingRatio
    );
}


void Foam::SPH::solidBodies::findBodies()
{
    const polyBoundaryMesh& patches = surface_.mesh().boundaryMesh();

    labelHashSet walls;
    for (const polyPatch& pp : patches)
    {
        if (isA<wallPolyPatch>(pp))
        {
            walls.insert(pp.index());
        }
    }

    const labelList elementis(surface_.patchElements(walls.toc()));
    const orientedSurface all(surface_.subset(elementis));

    label nParts;
    const labelList part(all.parts(nParts));
    List<DynamicList<label>> partElements(nParts);
    forAll(part, i)
    {
        partElements[part[i]].append(elementis[i]);
    }

    // A part with positive volume encloses the fluid
    DynamicList<label> bodies;
    labelList mainPatches(nParts);
    labelList count(patches.size(), Zero);

    forAll(partElements, parti)
    {
        const orientedSurface s(surface_.subset(partElements[parti]));
        if (s.openElements().empty() && s.volume() < 0)
        {
            bodies.append(parti);
            mainPatches[parti] = mainPatch(surface_, partElements[parti]);
            ++count[mainPatches[parti]];
        }
    }

    labelList number(patches.size(), Zero);
    for (const label parti : bodies)
    {
        const label patchi = mainPatches[parti];
        const word& patchName = patches[patchi].name();

        append
        (
            makeBody
            (
                count[patchi] == 1
              ? patchName
              : word(patchName + Foam::name(++number[patchi])),
                partElements[parti],
                smoothingRatio_
            )
        );
    }
}


Foam::labelList Foam::SPH::solidBodies::readElements
(
    const dictionary& dict
) const
{
    const polyBoundaryMesh& patches = surface_.mesh().boundaryMesh();
    const wordList valid(boundingPatches(surface_.mesh()));
    const wordRes names(dict.get<wordRes>("patches"));

    labelHashSet chosen;
    for (const wordRe& name : names)
    {
        const labelList matches(findStrings(name, valid));

        if (matches.empty())
        {
            FatalIOErrorInFunction(dict)
                << "Body " << dict.dictName() << ": no patch is called "
                << name << ". Valid patches: " << valid << exit(FatalIOError);
        }

        for (const label i : matches)
        {
            chosen.insert(patches.findPatchID(valid[i]));
        }
    }

    const labelList elementis(surface_.patchElements(chosen.sortedToc()));
    const orientedSurface s(surface_.subset(elementis));
    const labelList open(s.openElements());

    // The body may lie outside the zone that is filled
    if (s.size() == 0 && isBorder(patches.last()))
    {
        return elementis;
    }
    if (s.size() == 0 || open.size())
    {
        wordHashSet openPatches;
        for (const label elementi : open)
        {
            openPatches.insert(patches[s.elements()[elementi].patchi].name());
        }

        FatalIOErrorInFunction(dict)
            << "Body " << dict.dictName() << ": the patches " << names
            << " are not a closed surface; open ends are on "
            << openPatches.sortedToc() << ". Valid patches: " << valid
            << exit(FatalIOError);
    }

    label nParts;
    const labelList part(s.parts(nParts));
    for (label parti = 0; parti < nParts; ++parti)
    {
        DynamicList<label> partElements;
        forAll(part, i)
        {
            if (part[i] == parti)
            {
                partElements.append(i);
            }
        }

        const orientedSurface partSurface(s.subset(partElements));

        if (partSurface.volume() > 0)
        {
            FatalIOErrorInFunction(dict)
                << "Body " << dict.dictName() << ": patch "
                << patches[partSurface.elements()[0].patchi].name()
                << " encloses the fluid, not a solid" << exit(FatalIOError);
        }
    }

    return elementis;
}


Foam::autoPtr<Foam::SPH::solidBody> Foam::SPH::solidBodies::readBody
(
    const dictionary& dict
) const
{
    const scalar smoothingRatio
    (
        dict.getOrDefault<scalar>("smoothingRatio", smoothingRatio_)
    );

    if (smoothingRatio <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "Body " << dict.dictName() << ": smoothingRatio "
            << smoothingRatio << " is not positive. Valid ratios: 0.7 to 4"
            << exit(FatalIOError);
    }

    if (dict.found("patches") == dict.found("surface"))
    {
        FatalIOErrorInFunction(dict)
            << "Body " << dict.dictName() << " must have one of the entries "
            << "'patches' and 'surface'. Valid patches: "
            << boundingPatches(surface_.mesh()) << exit(FatalIOError);
    }

    if (dict.found("surface") && isCut(dict.dictName()))
    {
        const label patchi =
            surface_.mesh().boundaryMesh().findPatchID(dict.dictName());
        return makeBody
        (
            dict.dictName(),
            surface_.patchElements(labelList(1, patchi)),
            smoothingRatio
        );
    }

    if (dict.found("patches"))
    {
        const labelList elementis(readElements(dict));
        return
            elementis.empty()
          ? nullptr
          : makeBody(dict.dictName(), elementis, smoothingRatio);
    }

    return autoPtr<solidBody>::New
    (
        dict.dictName(),
        fileSurface(surface_.mesh().time(), surface_.space(), dict),
        labelList(),
        smoothingRatio
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::solidBodies::solidBodies
(
    const patchSurface& surface,
    const dictionary& dict,
    const scalar smoothingRatio
)
:
    surface_(surface),
    smoothingRatio_(smoothingRatio)
{
    if (!dict.found("bodies"))
    {
        findBodies();
        return;
    }

    const dictionary& bodies = dict.subDict("bodies");

    for (const entry& e : bodies)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(bodies)
                << "Entry " << e.keyword() << " of bodies is not a dictionary"
                << " with an entry 'patches' or 'surface'. Valid patches: "
                << boundingPatches(surface_.mesh()) << exit(FatalIOError);
        }
        autoPtr<solidBody> body(readBody(e.dict()));
        if (body.valid())
        {
            append(std::move(body));
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::solidBodies::checkSize(const spacingFunction& spacing) const
{
    for (const solidBody& body : *this)
    {
        const scalar size = cmptMax(body.surface().bounds().span());

        scalar dp = GREAT;
        for (const point& p : body.surface().points())
        {
            dp = min(dp, spacing(p));
        }

        if (size < dp)
        {
            FatalErrorInFunction
                << "Body " << body.name() << " has a size of " << size
                << " m, less than the particle spacing " << dp
                << " m there. Reduce the entry spacing of sphMeshDict, or"
                << " leave the body out"
                << exit(FatalError);
        }

        scalar area = 0;
        for (label elementi = 0; elementi < body.surface().size(); ++elementi)
        {
            area += mag(body.surface().areaVector(elementi));
        }
        const scalar thickness = 2*body.surface().volume()/area;

        if (isCut(body.name()) && thickness < leastThickness*dp)
        {
            FatalErrorInFunction
                << "Body " << body.name() << " has a mean thickness of "
                << thickness << " m, too thin for the particle spacing " << dp
                << " m there. Set a spacing below "
                << thickness/leastThickness << " m, as spacing {type refined;"
                << " base " << spacing.max() << "; near {" << body.name()
                << " {spacing " << thickness << ";}}}" << exit(FatalError);
        }
    }
}


// ************************************************************************* //
