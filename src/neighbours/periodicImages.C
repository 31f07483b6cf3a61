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

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::List<Foam::vector> Foam::SPH::periodicTranslations(const polyMesh& mesh)
{
    DynamicList<vector> translations;

    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (!pp.coupled() || pp.empty())
        {
            continue;
        }

        const cyclicPolyPatch* cyclic = isA<cyclicPolyPatch>(pp);

        if (!cyclic)
        {
            FatalErrorInFunction
                << "Patch " << pp.name() << " of "
                << mesh.time().path()/mesh.meshDir()/"boundary"
                << " has type " << pp.type() << ", which is not supported."
                << " Valid coupled patch types: cyclic" << exit(FatalError);
        }

        if (cyclic->owner())
        {
            const vectorField jump
            (
                cyclic->neighbPatch().faceCentres() - pp.faceCentres()
            );
            const vector T(average(jump));

            if (max(mag(jump - T)) > 1e-6*mag(T))
            {
                FatalErrorInFunction
                    << "The cyclic patches " << pp.name() << " and "
                    << cyclic->neighbPatchName() << " of "
                    << mesh.time().path()/mesh.meshDir()/"boundary"
                    << " are not a translation of one another. Valid cyclic"
                    << " transforms: translational" << exit(FatalError);
            }

            translations.append(T);
        }
    }

    return List<vector>(std::move(translations));
}


Foam::List<Foam::vector> Foam::SPH::imageOffsets
(
    const UList<vector>& translations
)
{
    DynamicList<vector> offsets;
    offsets.append(vector::zero);

    for (const vector& T : translations)
    {
        const label n = offsets.size();
        for (label i = 0; i < n; ++i)
        {
            offsets.append(offsets[i] + T);
            offsets.append(offsets[i] - T);
        }
    }

    return List<vector>(SubList<vector>(offsets, offsets.size() - 1, 1));
}


// ************************************************************************* //
