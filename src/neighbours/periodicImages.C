/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "periodicImages.H"
#include "cyclicPolyPatch.H"
#include "SubField.H"
#include "Time.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    const word cornerGroup("cornerPairs");

    //- From the owner side to the neighbour side [m]
    static vector translation(const cyclicPolyPatch& pp)
    {
        const vectorField jump
        (
            pp.neighbPatch().faceCentres() - pp.faceCentres()
        );
        const vector T(average(jump));

        if (max(mag(jump - T)) > 1e-6*mag(T))
        {
            const polyMesh& mesh = pp.boundaryMesh().mesh();
            FatalErrorInFunction
                << "The cyclic patches " << pp.name() << " and "
                << pp.neighbPatchName() << " of "
                << mesh.boundaryMesh().objectPath()
                << " are not a translation of one another. Valid cyclic"
                << " transforms: translational" << exit(FatalError);
        }

        return T;
    }
}
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::SPH::periodicPatches(const polyMesh& mesh)
{
    DynamicList<label> patches;
    DynamicList<vector> translations;

    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (!pp.coupled() || pp.empty() || pp.inGroups().found(cornerGroup))
        {
            continue;
        }

        const cyclicPolyPatch* cyclic = isA<cyclicPolyPatch>(pp);

        if (!cyclic)
        {
            FatalErrorInFunction
                << "Patch " << pp.name() << " of "
                << mesh.boundaryMesh().objectPath()
                << " has type " << pp.type() << ", which is not supported."
                << " Valid coupled patch types: cyclic" << exit(FatalError);
        }

        if (cyclic->owner())
        {
            const vector T(translation(*cyclic));

            // Two pairs of patches may have the same period
            bool known = false;
            for (const vector& other : translations)
            {
                known = known || mag(T - other) < 1e-6*mag(T);
            }
            if (!known)
            {
                patches.append(pp.index());
                translations.append(T);
            }
        }
    }

    return labelList(std::move(patches));
}


Foam::List<Foam::vector> Foam::SPH::periodicTranslations(const polyMesh& mesh)
{
    DynamicList<vector> translations;
    for (const label patchi : periodicPatches(mesh))
    {
        translations.append
        (
            translation
            (
                refCast<const cyclicPolyPatch>(mesh.boundaryMesh()[patchi])
            )
        );
    }

    return List<vector>(std::move(translations));
}


Foam::List<Foam::labelList> Foam::SPH::imagePeriods(const label nTranslations)
{
    // The first of the list is no period
    DynamicList<labelList> periods(1, labelList(nTranslations, Zero));

    for (label k = 0; k < nTranslations; ++k)
    {
        const label n = periods.size();
        for (label i = 0; i < n; ++i)
        {
            for (const label sign : {1, -1})
            {
                labelList image(periods[i]);
                image[k] = sign;
                periods.append(image);
            }
        }
    }

    return List<labelList>
    (
        SubList<labelList>(periods, periods.size() - 1, 1)
    );
}


Foam::List<Foam::vector> Foam::SPH::imageOffsets
(
    const UList<vector>& translations
)
{
    const List<labelList> periods(imagePeriods(translations.size()));

    List<vector> offsets(periods.size(), Zero);
    forAll(offsets, imagei)
    {
        forAll(translations, k)
        {
            offsets[imagei] += scalar(periods[imagei][k])*translations[k];
        }
    }

    return offsets;
}


// ************************************************************************* //
