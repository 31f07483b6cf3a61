/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "nearestElementGrid.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    //- Cells along the longest edge in one, two and three dimensions
    constexpr Foam::label mostCells[] = {1, 1024, 160};

    //- Margin around the surface over its longest extent
    constexpr Foam::scalar margin = 0.1;

    constexpr Foam::label unknown = -2;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::nearestElementGrid::nearestElementGrid
(
    const label nDims,
    const boundBox& box
)
:
    nDims_(nDims),
    origin_(box.min()),
    edge_(0),
    n_(1, 1, 1)
{
    scalar longest = VSMALL;
    for (label d = 0; d < nDims_; ++d)
    {
        longest = max(longest, box.span()[d]);
    }
    edge_ = (1 + 2*margin)*longest/mostCells[nDims_ - 1];

    for (label d = 0; d < nDims_; ++d)
    {
        const scalar width = box.span()[d] + 2*margin*longest;
        origin_[d] -= margin*longest;
        n_[d] = label(width/edge_) + 1;
    }
    elements_.setSize(n_.x()*n_.y()*n_.z(), unknown);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::SPH::nearestElementGrid::find
(
    const elementTree& tree,
    const point& x
) const
{
    point centre(origin_);
    label cell = 0;
    for (label d = nDims_ - 1; d >= 0; --d)
    {
        const scalar offset = (x[d] - origin_[d])/edge_;
        if (!(offset >= 0 && offset < n_[d]))
        {
            return -1;
        }
        const label i = label(offset);
        cell = cell*n_[d] + i;
        centre[d] += (i + 0.5)*edge_;
    }

    label element;
    #pragma omp atomic read
    element = elements_[cell];

    if (element == unknown)
    {
        element = tree.nearest(centre);

        #pragma omp atomic write
        elements_[cell] = element;
    }

    return element;
}


// ************************************************************************* //
