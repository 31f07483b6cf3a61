/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "growthTree.H"
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::SPH::growthTree::build
(
    labelList& order,
    const label start,
    const label end
)
{
    const label nodei = nodes_.size();
    node n{point::max, point::min, GREAT, start, end, -1};

    for (label i = start; i < end; ++i)
    {
        n.min = min(n.min, points_[order[i]]);
        n.max = max(n.max, points_[order[i]]);
        n.value = min(n.value, values_[order[i]]);
    }
    nodes_.append(n);

    if (end - start > 8)
    {
        const vector span(n.max - n.min);
        direction d = 0;
        for (direction k = 1; k < 3; ++k)
        {
            d = span[k] > span[d] ? k : d;
        }

        const label middle = (start + end)/2;
        std::nth_element
        (
            order.begin() + start,
            order.begin() + middle,
            order.begin() + end,
            [&](const label a, const label b)
            {
                return points_[a][d] < points_[b][d];
            }
        );

        build(order, start, middle);
        nodes_[nodei].second = build(order, middle, end);
    }

    return nodei;
}


Foam::scalar Foam::SPH::growthTree::bound(const node& n, const point& x) const
{
    return n.value + slope_*mag(x - min(max(x, n.min), n.max));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::growthTree::growthTree
(
    const pointField& points,
    const scalarField& values,
    const scalar slope
)
:
    points_(points),
    values_(values),
    slope_(slope),
    nodes_(points.size()/2 + 1)
{
    labelList order(identity(points.size()));
    build(order, 0, order.size());

    points_ = pointField(points, order);
    values_ = scalarField(values, order);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::SPH::growthTree::evaluate
(
    const point& x,
    const scalar limit
) const
{
    scalar best = limit;

    // Depth of a median tree of 2^31 points
    label stack[64];
    label nStack = 0;
    stack[nStack++] = 0;

    while (nStack)
    {
        const label nodei = stack[--nStack];
        const node& n = nodes_[nodei];

        if (bound(n, x) >= best)
        {
            continue;
        }

        if (n.second < 0)
        {
            for (label i = n.start; i < n.end; ++i)
            {
                best = min(best, values_[i] + slope_*mag(x - points_[i]));
            }
            continue;
        }

        // The more promising child is taken from the stack first
        const label first = nodei + 1;
        const bool swapped =
            bound(nodes_[first], x) < bound(nodes_[n.second], x);

        stack[nStack++] = swapped ? n.second : first;
        stack[nStack++] = swapped ? first : n.second;
    }

    return best;
}


// ************************************************************************* //
