/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "cellGrid.H"
#include "boundBox.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::cellGrid::cellGrid(const UList<vector>& points, const scalar size)
:
    min_(Zero),
    inverseSize_(1/size),
    n_(1),
    start_(),
    sorted_(points.size()),
    positions_(points.size())
{
    if (points.empty())
    {
        start_ = labelList(2, Zero);
        return;
    }

    const boundBox box(points, false);
    min_ = box.min();

    const scalar maxCells = 4.0*points.size() + 64;
    for (;;)
    {
        scalar nCells = 1;
        for (direction d = 0; d < 3; ++d)
        {
            nCells *= 1 + floor(box.span()[d]*inverseSize_);
        }
        if (nCells <= maxCells)
        {
            break;
        }
        inverseSize_ *= 0.8;
    }

    for (direction d = 0; d < 3; ++d)
    {
        n_[d] = 1 + label(floor(box.span()[d]*inverseSize_));
    }

    labelList cell(points.size());
    start_ = labelList(n_[0]*n_[1]*n_[2] + 1, Zero);
    forAll(points, i)
    {
        cell[i] = index(points[i]);
        ++start_[cell[i] + 1];
    }
    for (label c = 1; c < start_.size(); ++c)
    {
        start_[c] += start_[c - 1];
    }

    labelList next(SubList<label>(start_, start_.size() - 1));
    forAll(points, i)
    {
        const label s = next[cell[i]]++;
        sorted_[s] = i;
        positions_[s] = points[i];
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::SPH::cellGrid::nearest
(
    const UList<vector>& points,
    const vector& p,
    scalar radius
) const
{
    label best = -1;
    for (; best < 0 && points.size(); radius *= 2)
    {
        forNear
        (
            p,
            radius,
            [&](const label j)
            {
                if
                (
                    best < 0
                 || magSqr(points[j] - p) < magSqr(points[best] - p)
                )
                {
                    best = j;
                }
            }
        );
    }
    return best;
}


// ************************************************************************* //
