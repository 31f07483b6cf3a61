/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

// The exact predicates change the rounding mode
#pragma GCC optimize ("rounding-math")

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include "largestVoid.H"
#include "trapsOff.H"

#include <algorithm>
#include <utility>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
namespace
{
    typedef CGAL::Exact_predicates_inexact_constructions_kernel geometry;

    typedef CGAL::Delaunay_triangulation_2
    <
        geometry,
        CGAL::Triangulation_data_structure_2
        <
            CGAL::Triangulation_vertex_base_with_info_2<label, geometry>
        >
    > triangulation;

    typedef CGAL::Delaunay_triangulation_3
    <
        geometry,
        CGAL::Triangulation_data_structure_3
        <
            CGAL::Triangulation_vertex_base_with_info_3<label, geometry>,
            CGAL::Delaunay_triangulation_cell_base_3<geometry>
        >
    > tetrahedralisation;

    geometry::Point_2 toCgal(const vector& p, const triangulation&)
    {
        return geometry::Point_2(p.x(), p.y());
    }

    geometry::Point_3 toCgal(const vector& p, const tetrahedralisation&)
    {
        return geometry::Point_3(p.x(), p.y(), p.z());
    }

    vector toLocal(const geometry::Point_2& p)
    {
        return vector(p.x(), p.y(), 0);
    }

    vector toLocal(const geometry::Point_3& p)
    {
        return vector(p.x(), p.y(), p.z());
    }

    //- Call f(centre) for the circumcentre of each triangle
    template<class Function>
    void forCentres(const triangulation& t, Function&& f)
    {
        for
        (
            auto face = t.finite_faces_begin();
            face != t.finite_faces_end();
            ++face
        )
        {
            f(t.circumcenter(face), face->vertex(0));
        }
    }

    //- Has a tetrahedron no volume but round-off: no sphere is its own, and
    //- CGAL would divide by zero
    bool flat(const tetrahedralisation::Cell& cell)
    {
        const vector origin(toLocal(cell.vertex(0)->point()));
        const vector a(toLocal(cell.vertex(1)->point()) - origin);
        const vector b(toLocal(cell.vertex(2)->point()) - origin);
        const vector c(toLocal(cell.vertex(3)->point()) - origin);

        return mag((a ^ b) & c) <= 1e-9*mag(a)*mag(b)*mag(c);
    }

    //- Call f(centre) for the circumcentre of each tetrahedron
    template<class Function>
    void forCentres(const tetrahedralisation& t, Function&& f)
    {
        for
        (
            auto cell = t.finite_cells_begin();
            cell != t.finite_cells_end();
            ++cell
        )
        {
            if (flat(*cell))
            {
                continue;
            }
            f
            (
                t.geom_traits().construct_circumcenter_3_object()
                (
                    cell->vertex(0)->point(),
                    cell->vertex(1)->point(),
                    cell->vertex(2)->point(),
                    cell->vertex(3)->point()
                ),
                cell->vertex(0)
            );
        }
    }

    template<class Triangulation>
    scalar largestVoidOf
    (
        const UList<vector>& points,
        const UList<scalar>& spacing,
        const std::function<bool(const vector&)>& inRegion
    )
    {
        Triangulation t;
        {
            std::vector
            <
                std::pair<typename Triangulation::Point, label>
            > vertices(points.size());
            forAll(points, i)
            {
                vertices[i] = {toCgal(points[i], t), i};
            }
            t.insert(vertices.begin(), vertices.end());
        }

        // The centre of a nearly flat simplex is far off by round-off: only
        // the distance to its nearest particle counts
        scalar largest = 0;
        forCentres
        (
            t,
            [&](const auto& centre, const auto& vertex)
            {
                const vector c(toLocal(centre));
                const scalar circle = mag(c - points[vertex->info()]);
                if
                (
                    circle > largest*spacing[vertex->info()]
                 && circle < GREAT
                 && inRegion(c)
                )
                {
                    const label i = t.nearest_vertex(centre)->info();
                    largest = max(largest, mag(c - points[i])/spacing[i]);
                }
            }
        );

        return largest;
    }

    //- Half of the largest gap between points on a line
    scalar largestGap
    (
        const UList<vector>& points,
        const UList<scalar>& spacing,
        const std::function<bool(const vector&)>& inRegion
    )
    {
        std::vector<std::pair<scalar, scalar>> sorted(points.size());
        forAll(points, i)
        {
            sorted[i] = {points[i].x(), spacing[i]};
        }
        std::sort(sorted.begin(), sorted.end());

        scalar largest = 0;
        for (size_t i = 1; i < sorted.size(); ++i)
        {
            const auto& a = sorted[i - 1];
            const auto& b = sorted[i];
            if (inRegion(vector(0.5*(a.first + b.first), 0, 0)))
            {
                largest = max
                (
                    largest,
                    0.5*(b.first - a.first)/min(a.second, b.second)
                );
            }
        }

        return largest;
    }
}
}
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::SPH::largestVoid
(
    const label nDims,
    const UList<vector>& points,
    const UList<scalar>& spacing,
    const std::function<bool(const vector&)>& inRegion
)
{
    if (nDims == 1)
    {
        return largestGap(points, spacing, inRegion);
    }

    const trapsOff untrapped;

    return
        nDims == 2
      ? largestVoidOf<triangulation>(points, spacing, inRegion)
      : largestVoidOf<tetrahedralisation>(points, spacing, inRegion);
}


// ************************************************************************* //
