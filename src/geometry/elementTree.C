/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include <CGAL/Simple_cartesian.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>

#include <vector>

#include "elementTree.H"
#include "sigFpe.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    typedef CGAL::Simple_cartesian<double> kernel;
    typedef kernel::Point_3 point3;
    typedef std::vector<kernel::Triangle_3> triangles;

    point3 toPoint(const Foam::point& p)
    {
        return point3(p.x(), p.y(), p.z());
    }
}


// * * * * * * * * * * * * * * * * * Classes * * * * * * * * * * * * * * * * //

struct Foam::SPH::elementTree::implementation
{
    //- Elements that have an extent
    triangles shapes;
    std::vector<label> elements;

    CGAL::AABB_tree
    <
        CGAL::AABB_traits
        <
            kernel,
            CGAL::AABB_triangle_primitive<kernel, triangles::const_iterator>
        >
    > tree;
};


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::elementTree::elementTree
(
    const label nDims,
    const UList<point>& points,
    const UList<FixedList<label, 3>>& elements
)
:
    tree_(new implementation)
{
    // Bounding box arithmetic of the library may raise exceptions
    const sigFpe::ignore noTrapping;

    forAll(elements, elementi)
    {
        // Points and segments are the sides of triangles that stand upright on
        // the line or plane of all queries
        const FixedList<label, 3>& v = elements[elementi];
        const point& a = points[v[0]];
        const point b(nDims > 1 ? points[v[1]] : a + vector(0, 1, 0));
        const point c(nDims > 2 ? points[v[2]] : a + vector(0, 0, mag(b - a)));

        const kernel::Triangle_3 t(toPoint(a), toPoint(b), toPoint(c));
        if (!t.is_degenerate())
        {
            tree_->shapes.push_back(t);
            tree_->elements.push_back(elementi);
        }
    }

    tree_->tree.rebuild(tree_->shapes.begin(), tree_->shapes.end());
    tree_->tree.accelerate_distance_queries();
    tree_->tree.build();
}


Foam::SPH::elementTree::~elementTree()
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::SPH::elementTree::nearest(const point& p) const
{
    if (tree_->elements.empty())
    {
        return -1;
    }

    const auto found = tree_->tree.closest_point_and_primitive(toPoint(p));
    return tree_->elements[found.second - tree_->shapes.begin()];
}


// ************************************************************************* //
