/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "surfaceShapes.H"
#include "mathematicalConstants.H"
#include "mergePoints.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

SPH::solutionSpace SPH::planeSpace()
{
    return solutionSpace(2, {0, 1, 2}, 1, Zero);
}


SPH::solutionSpace SPH::fullSpace()
{
    return solutionSpace(3, {0, 1, 2}, 1, Zero);
}


SPH::orientedSurface SPH::polygon(const std::vector<loop>& loops)
{
    DynamicList<point> points;
    DynamicList<orientedSurface::element> elements;

    for (const loop& l : loops)
    {
        const label start = points.size();
        const label n = l.size();

        for (label i = 0; i < n; ++i)
        {
            points.append(l[i]);
            elements.append
            (
                orientedSurface::element(start + i, start + (i + 1) % n)
            );
        }
    }

    return orientedSurface
    (
        planeSpace(),
        pointField(std::move(points)),
        List<orientedSurface::element>(std::move(elements))
    );
}


SPH::loop SPH::circle(const scalar radius, const label n, const point& centre)
{
    loop l;
    for (label i = 0; i < n; ++i)
    {
        const scalar theta = constant::mathematical::twoPi*i/n;
        const vector e(Foam::cos(theta), Foam::sin(theta), 0);
        l.push_back(centre + radius*e);
    }
    return l;
}


SPH::loop SPH::reversed(const loop& l)
{
    return loop(l.rbegin(), l.rend());
}


SPH::orientedSurface SPH::mapped
(
    const std::vector<std::function<point(scalar, scalar)>>& maps,
    const label n,
    const label m
)
{
    DynamicList<point> points;
    DynamicList<orientedSurface::element> elements;

    for (const auto& map : maps)
    {
        const label start = points.size();
        for (label j = 0; j <= m; ++j)
        {
            for (label i = 0; i <= n; ++i)
            {
                points.append(map(scalar(i)/n, scalar(j)/m));
            }
        }

        for (label j = 0; j < m; ++j)
        {
            for (label i = 0; i < n; ++i)
            {
                const label a = start + i + (n + 1)*j;
                const label c = a + n + 2;
                elements.append(orientedSurface::element(a, a + 1, c));
                elements.append(orientedSurface::element(a, c, c - 1));
            }
        }
    }

    labelList newPoint;
    pointField merged;
    mergePoints(pointField(points), 1e-12, false, newPoint, merged);

    for (orientedSurface::element& e : elements)
    {
        for (label& v : e.vertices)
        {
            v = newPoint[v];
        }
    }

    return orientedSurface
    (
        fullSpace(),
        std::move(merged),
        List<orientedSurface::element>(std::move(elements))
    );
}


SPH::orientedSurface SPH::boxSurface
(
    const point& min,
    const point& max,
    const label n
)
{
    const vector span(max - min);
    std::vector<std::function<point(scalar, scalar)>> maps;

    for (direction d = 0; d < 3; ++d)
    {
        for (const bool upper : {false, true})
        {
            maps.push_back
            (
                [=](const scalar s, const scalar t)
                {
                    point p(min);
                    p[d] += upper ? span[d] : 0;
                    p[(d + 1) % 3] += (upper ? s : t)*span[(d + 1) % 3];
                    p[(d + 2) % 3] += (upper ? t : s)*span[(d + 2) % 3];
                    return p;
                }
            );
        }
    }

    return mapped(maps, n, n);
}


scalar SPH::plainDistance(const orientedSurface& surface, const point& p)
{
    scalar least = GREAT;
    for (const orientedSurface::element& e : surface.elements())
    {
        const point& a = surface.points()[e.vertices[0]];
        const vector t(surface.points()[e.vertices[1]] - a);
        const scalar foot = ((p - a) & t)/magSqr(t);
        const scalar s = min(max(foot, scalar(0)), scalar(1));
        least = min(least, mag(p - a - s*t));
    }
    return least;
}


bool SPH::plainInside(const orientedSurface& surface, const point& p)
{
    label nCrossings = 0;
    for (const orientedSurface::element& e : surface.elements())
    {
        const point& a = surface.points()[e.vertices[0]];
        const point& b = surface.points()[e.vertices[1]];

        if ((a.y() > p.y()) != (b.y() > p.y()))
        {
            const scalar s = (p.y() - a.y())/(b.y() - a.y());
            nCrossings += p.x() < a.x() + s*(b.x() - a.x());
        }
    }
    return nCrossings % 2;
}


// ************************************************************************* //
