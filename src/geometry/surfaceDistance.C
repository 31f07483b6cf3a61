/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "surfaceDistance.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    //- Distance over element size below which p counts as on the surface
    constexpr Foam::scalar onSurface = 1e-10;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::SPH::surfaceDistance::nearestOnElement
(
    const label elementi,
    const point& x,
    point& hit,
    vector& normal
) const
{
    const FixedList<label, 3>& v = elements_[elementi];
    const point& a = points_[v[0]];

    normal = normals_[elementi];
    hit = a;

    if (space_.nDims() == 1)
    {
        return true;
    }

    // Nearest point on the segment from vertex i to vertex j
    const auto onSegment = [&](const label i, const label j, bool& interior)
    {
        const point& from = points_[i];
        const vector t(points_[j] - from);
        const scalar s = ((x - from) & t)/max(magSqr(t), VSMALL);

        interior = s > 0 && s < 1;
        if (interior)
        {
            hit = from + s*t;
        }
        else
        {
            hit = points_[s <= 0 ? i : j];
            normal = vertexNormals_[s <= 0 ? i : j];
        }
    };

    bool interior;

    if (space_.nDims() == 2)
    {
        onSegment(v[0], v[1], interior);
        return interior;
    }

    const vector& n = normals_[elementi];
    scalar minDistance = GREAT;
    point nearestHit(a);
    vector nearestNormal(n);
    bool over = true;

    for (label k = 0; k < 3; ++k)
    {
        const label i = v[k];
        const label j = v[(k + 1) % 3];

        if ((((points_[j] - points_[i])^(x - points_[i])) & n) < 0)
        {
            over = false;
            normal = edgeNormals_[3*elementi + k];
            onSegment(i, j, interior);

            const scalar d = magSqr(x - hit);
            if (d < minDistance)
            {
                minDistance = d;
                nearestHit = hit;
                nearestNormal = normal;
            }
        }
    }

    if (over)
    {
        normal = n;
        hit = x - ((x - a) & n)*n;
    }
    else
    {
        hit = nearestHit;
        normal = nearestNormal;
    }

    return over;
}


Foam::scalar Foam::SPH::surfaceDistance::winding(const point& x) const
{
    scalar sum = 0;

    for (const FixedList<label, 3>& e : elements_)
    {
        if (space_.nDims() == 3)
        {
            // Solid angle of a triangle, A. van Oosterom and J. Strackee,
            // IEEE Trans. Biomed. Eng. 30 (1983) 125
            const vector a(points_[e[0]] - x);
            const vector b(points_[e[1]] - x);
            const vector c(points_[e[2]] - x);
            const scalar magA = mag(a), magB = mag(b), magC = mag(c);

            sum += 2*atan2
            (
                a & (b^c),
                magA*magB*magC + (a & b)*magC + (b & c)*magA + (c & a)*magB
            );
        }
        else if (space_.nDims() == 2)
        {
            // Crossings of the ray from x in the first direction
            const point& a = points_[e[0]];
            const point& b = points_[e[1]];

            if ((a.y() <= x.y()) != (b.y() <= x.y()))
            {
                const scalar left =
                    (b.x() - a.x())*(x.y() - a.y())
                  - (b.y() - a.y())*(x.x() - a.x());

                if ((b.y() > a.y()) == (left > 0))
                {
                    sum += b.y() > a.y() ? 1 : -1;
                }
            }
        }
    }

    return space_.nDims() == 3 ? sum/(4*constant::mathematical::pi) : sum;
}


bool Foam::SPH::surfaceDistance::enclosed(const point& x) const
{
    if (!closed_.valid())
    {
        return winding(x) > 0.5;
    }

    for (const vector& shift : shifts_)
    {
        if (closed_->winding(x - shift) > 0.5)
        {
            return true;
        }
    }

    return closed_->winding(x) > 0.5;
}


Foam::SPH::signedDistance::nearest Foam::SPH::surfaceDistance::findLocal
(
    const point& x
) const
{
    nearest result;
    point hit;
    vector normal;

    const label elementi = tree_->nearest(x);

    if (elementi < 0)
    {
        result.distance = -GREAT;
        result.hit = x;
        return result;
    }

    const bool interior = nearestOnElement(elementi, x, hit, normal);
    const vector d(x - hit);

    if (interior)
    {
        result.distance = d & normal;
    }
    else
    {
        const scalar r = mag(d);
        const FixedList<label, 3>& v = elements_[elementi];

        const bool known = magSqr(normal) > 0.5;
        const bool inside = known ? (d & normal) < 0 : r > 0 && enclosed(x);

        result.distance = inside ? -r : r;

        if (r > onSurface*mag(points_[v[1]] - points_[v[0]]))
        {
            normal = d/result.distance;
        }
        else if (!known)
        {
            normal = normals_[elementi];
        }
    }

    result.hit = hit;
    result.normal = normal;
    result.patchi = patches_[elementi];
    result.facei = faces_[elementi];

    return result;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::surfaceDistance::surfaceDistance
(
    const orientedSurface& surface,
    const scalar band
)
:
    space_(surface.space()),
    bounds_(surface.bounds())
{
    setElements(surface, band);

    if (surface.periods().size())
    {
        closed_.reset
        (
            new surfaceDistance
            (
                orientedSurface
                (
                    space_,
                    pointField(surface.points()),
                    List<orientedSurface::element>(surface.elements())
                )
            )
        );
    }

    setNormals();

    tree_.reset(new elementTree(space_.nDims(), points_, elements_));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::SPH::signedDistance::nearest Foam::SPH::surfaceDistance::find
(
    const point& p
) const
{
    nearest result(findLocal(space_.toLocal(p)));

    result.hit = space_.position(result.hit);
    result.normal = space_.toGlobal(result.normal);

    return result;
}


Foam::scalar Foam::SPH::surfaceDistance::magDistance(const point& p) const
{
    const point x(space_.toLocal(p));
    const label elementi = tree_->nearest(x);

    if (elementi < 0)
    {
        return GREAT;
    }

    point hit;
    vector normal;
    nearestOnElement(elementi, x, hit, normal);

    return space_.nDims() == 1 ? mag(x.x() - hit.x()) : mag(x - hit);
}


bool Foam::SPH::surfaceDistance::inside(const point& p) const
{
    if (closed_.valid())
    {
        return closed_->inside(p);
    }

    // Far away all elements are equally near in round-off
    const point x(space_.toLocal(p));
    const point low(space_.toLocal(bounds_.min()));
    const point high(space_.toLocal(bounds_.max()));

    return x == min(max(x, low), high) && find(p).distance < 0;
}


// ************************************************************************* //
