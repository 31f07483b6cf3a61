/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "pointTree.H"
#include "boundBox.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Points a leaf may hold
    static constexpr label leafSize = 8;

    static bool isLeaf(const label begin, const label end)
    {
        return end - begin <= leafSize;
    }

    static label middle(const label begin, const label end)
    {
        return begin + (end - begin)/2;
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::pointTree::build
(
    const label node,
    const label begin,
    const label end
)
{
    if (isLeaf(begin, end))
    {
        return;
    }

    boundBox bb;
    for (label k = begin; k < end; ++k)
    {
        bb.min() = min(bb.min(), points_[order_[k]]);
        bb.max() = max(bb.max(), points_[order_[k]]);
    }

    const vector span(bb.span());
    const direction axis =
        span.x() >= span.y()
      ? (span.x() >= span.z() ? 0 : 2)
      : (span.y() >= span.z() ? 1 : 2);

    const label mid = middle(begin, end);
    std::nth_element
    (
        order_.begin() + begin,
        order_.begin() + mid,
        order_.begin() + end,
        [&](const label a, const label b)
        {
            return points_[a][axis] < points_[b][axis];
        }
    );

    splitAxis_[node] = axis;
    split_[node] = points_[order_[mid]][axis];

    build(2*node + 1, begin, mid);
    build(2*node + 2, mid, end);
}


void Foam::SPH::pointTree::searchNearest
(
    const label node,
    const label begin,
    const label end,
    const point& x,
    label& nearest,
    scalar& rSqr
) const
{
    if (isLeaf(begin, end))
    {
        for (label k = begin; k < end; ++k)
        {
            const scalar dSqr = magSqr(points_[order_[k]] - x);
            if (nearest < 0 || dSqr < rSqr)
            {
                nearest = order_[k];
                rSqr = dSqr;
            }
        }
        return;
    }

    const label mid = middle(begin, end);
    const scalar d = x[splitAxis_[node]] - split_[node];

    const auto lower = [&]()
    {
        searchNearest(2*node + 1, begin, mid, x, nearest, rSqr);
    };
    const auto upper = [&]()
    {
        searchNearest(2*node + 2, mid, end, x, nearest, rSqr);
    };

    // The nearer half first: it usually rules the other one out
    if (d < 0)
    {
        lower();
        if (sqr(d) < rSqr) upper();
    }
    else
    {
        upper();
        if (sqr(d) < rSqr) lower();
    }
}


void Foam::SPH::pointTree::searchSphere
(
    const label node,
    const label begin,
    const label end,
    const point& x,
    const scalar rSqr,
    DynamicList<label>& found
) const
{
    if (isLeaf(begin, end))
    {
        for (label k = begin; k < end; ++k)
        {
            if (magSqr(points_[order_[k]] - x) <= rSqr)
            {
                found.append(order_[k]);
            }
        }
        return;
    }

    const label mid = middle(begin, end);
    const scalar d = x[splitAxis_[node]] - split_[node];

    if (d <= 0 || sqr(d) <= rSqr)
    {
        searchSphere(2*node + 1, begin, mid, x, rSqr, found);
    }
    if (d >= 0 || sqr(d) <= rSqr)
    {
        searchSphere(2*node + 2, mid, end, x, rSqr, found);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::pointTree::pointTree(const pointField& points)
:
    points_(points),
    order_(identity(points.size()))
{
    // A node of level l holds at most ceil(n/2^l) points
    label nNodes = 1;
    for (label held = points.size(); held > leafSize; held = (held + 1)/2)
    {
        nNodes = 2*nNodes + 1;
    }
    splitAxis_.setSize(nNodes, 0);
    split_.setSize(nNodes, 0);

    build(0, 0, order_.size());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::SPH::pointTree::nearest(const point& x) const
{
    label found = -1;
    scalar rSqr = 0;
    searchNearest(0, 0, order_.size(), x, found, rSqr);

    return found;
}


void Foam::SPH::pointTree::sphere
(
    const point& x,
    const scalar r,
    DynamicList<label>& found
) const
{
    found.clear();
    searchSphere(0, 0, order_.size(), x, sqr(r), found);

    std::sort(found.begin(), found.end());
}


// ************************************************************************* //
