/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "movingLeastSquares.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
void Foam::SPH::movingLeastSquares::map
(
    const UList<Type>& from,
    UList<Type>& to,
    const bool bounded
) const
{
    const label nTargets = size();

    #pragma omp parallel for schedule(static)
    for (label i = 0; i < nTargets; ++i)
    {
        const Type f0 = from[nearest_[i]];

        Type change(Zero);
        Type lowest(Zero);
        Type highest(Zero);

        for (label k = start_[i]; k < start_[i + 1]; ++k)
        {
            const Type d = from[source_[k]] - f0;
            change += weight_[k]*d;
            lowest = min(lowest, d);
            highest = max(highest, d);
        }

        to[i] = f0 + (bounded ? max(lowest, min(highest, change)) : change);
    }
}


// ************************************************************************* //
