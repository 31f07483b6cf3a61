/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "orientedSurface.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::orientedSurface::orientedSurface
(
    const solutionSpace& space,
    pointField&& points,
    List<element>&& elements,
    const List<vector>& periods
)
:
    space_(space),
    points_(std::move(points)),
    elements_(std::move(elements)),
    periods_(periods)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::SPH::orientedSurface::areaVector(const label elementi) const
{
    const element& e = elements_[elementi];

    if (space_.nDims() == 3)
    {
        const point& a = points_[e.vertices[0]];
        const point& b = points_[e.vertices[1]];
        const point& c = points_[e.vertices[2]];

        return 0.5*((b - a)^(c - a));
    }

    if (space_.nDims() == 2)
    {
        const vector t
        (
            space_.toLocal(points_[e.vertices[1]] - points_[e.vertices[0]])
        );

        return space_.thickness()*space_.toGlobal(vector(t.y(), -t.x(), 0));
    }

    const scalar sign = e.reversed ? -1 : 1;
    return space_.thickness()*space_.toGlobal(vector(sign, 0, 0));
}


Foam::point Foam::SPH::orientedSurface::centre(const label elementi) const
{
    const element& e = elements_[elementi];

    point sum(Zero);
    for (label k = 0; k < space_.nDims(); ++k)
    {
        sum += points_[e.vertices[k]];
    }

    return sum/space_.nDims();
}


Foam::scalar Foam::SPH::orientedSurface::volume() const
{
    if (elements_.empty())
    {
        return 0;
    }

    // Gauss theorem for div(x) = nDims, about a point of the surface to keep
    // round-off small far from the origin
    const point origin(points_[elements_[0].vertices[0]]);

    scalar sum = 0;
    forAll(elements_, elementi)
    {
        const vector x(space_.toLocal(centre(elementi) - origin));
        sum += x & space_.toLocal(areaVector(elementi));
    }

    return sum/space_.nDims();
}


Foam::SPH::orientedSurface Foam::SPH::orientedSurface::subset
(
    const labelUList& elementis,
    const bool reverse
) const
{
    labelList newPoint(points_.size(), -1);
    DynamicList<point> points(elementis.size());
    List<element> elements(elementis.size());

    forAll(elementis, i)
    {
        element& e = elements[i];
        e = elements_[elementis[i]];

        for (label k = 0; k < space_.nDims(); ++k)
        {
            label& v = e.vertices[k];

            if (newPoint[v] < 0)
            {
                newPoint[v] = points.size();
                points.append(points_[v]);
            }
            v = newPoint[v];
        }

        if (reverse)
        {
            e.reversed = !e.reversed;

            if (space_.nDims() > 1)
            {
                std::swap(e.vertices[0], e.vertices[1]);
            }
        }
    }

    return orientedSurface
    (
        space_,
        pointField(std::move(points)),
        std::move(elements)
    );
}


// ************************************************************************* //
