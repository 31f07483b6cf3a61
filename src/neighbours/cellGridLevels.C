/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "cellGridLevels.H"
#include "DynamicList.H"
#include "UIndirectList.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::cellGridLevels::cellGridLevels
(
    const UList<vector>& points,
    const UList<scalar>& radius,
    const scalar cellSize
)
{
    scalar least = GREAT;
    for (const scalar r : radius)
    {
        least = min(least, r);
    }

    List<DynamicList<label>> levels;
    forAll(points, i)
    {
        const label level = std::ilogb(radius[i]/least);
        if (level >= levels.size())
        {
            levels.resize(level + 1);
        }
        levels[level].append(i);
    }

    for (DynamicList<label>& level : levels)
    {
        if (level.empty())
        {
            continue;
        }

        scalar smallest = GREAT;
        scalar largest = 0;
        for (const label i : level)
        {
            smallest = min(smallest, radius[i]);
            largest = max(largest, radius[i]);
        }
        maxRadius_.append(largest);
        grids_.append
        (
            new cellGrid
            (
                List<vector>(UIndirectList<vector>(points, level)),
                cellSize*smallest
            )
        );
        points_.append(labelList());
        points_.last().transfer(level);
    }
}


// ************************************************************************* //
