/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "periodicImages.H"
#include "SubField.H"
#include "Time.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

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
