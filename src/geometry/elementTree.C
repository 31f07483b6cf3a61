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
#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <vector>

#include "elementTree.H"
#include "sigFpe.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    typedef CGAL::Simple_cartesian<double> kernel;
    typedef kernel::Point_3 point3;
    typedef std::vector<kernel::Segment_3> segments;
    typedef std::vector<kernel::Triangle_3> triangles;

    inline point3 toPoint(const Foam::point& p)
    {
        return point3(p.x(), p.y(), p.z());
    }
}


// * * * * * * * * * * * * * * * * * Classes * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{

class elementTree::implementation
{
public:

    virtual ~implementation() = default;

    virtual label nearest(const point& p) const = 0;
};


//- A CGAL tree over segments or triangles
template<class Container, class Primitive>
class boxTree
:
    public elementTree::implementation
{
    typedef CGAL::AABB_tree<CGAL::AABB_traits<kernel, Primitive>> treeType;

    //- Shapes that have an extent, with their element indices
    Container shapes_;
    std::vector<label> elements_;

    treeType tree_;

public:

    boxTree(Container&& shapes)
    {
        // Bounding box arithmetic of the library may raise exceptions
        const sigFpe::ignore noTrapping;

        shapes_.reserve(shapes.size());
        for (size_t i = 0; i < shapes.size(); ++i)
        {
            if (!shapes[i].is_degenerate())
            {
                elements_.push_back(i);
                shapes_.push_back(shapes[i]);
            }
        }
        tree_.rebuild(shapes_.begin(), shapes_.end());
        tree_.accelerate_distance_queries();
        tree_.build();
    }

    virtual label nearest(const point& p) const
    {
        return
            elements_.empty()
          ? -1
          : elements_
            [
                tree_.closest_point_and_primitive(toPoint(p)).second
              - shapes_.begin()
            ];
    }
};


//- Few points in one dimension
class pointSearch
:
    public elementTree::implementation
{
    std::vector<point> points_;

public:

    pointSearch(std::vector<point>&& points)
    :
        points_(std::move(points))
    {}

    virtual label nearest(const point& p) const
    {
        label found = -1;
        for (size_t i = 0; i < points_.size(); ++i)
        {
            if
            (
                found < 0
             || mag(p.x() - points_[i].x()) < mag(p.x() - points_[found].x())
            )
            {
                found = i;
            }
        }

        return found;
    }
};

} // End namespace SPH
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::elementTree::elementTree
(
    const label nDims,
    const UList<point>& points,
    const UList<FixedList<label, 3>>& elements
)
{
    if (nDims == 1)
    {
        std::vector<point> all;
        for (const FixedList<label, 3>& e : elements)
        {
            all.push_back(points[e[0]]);
        }
        tree_.reset(new pointSearch(std::move(all)));
    }
    else if (nDims == 2)
    {
        segments all;
        for (const FixedList<label, 3>& e : elements)
        {
            all.emplace_back(toPoint(points[e[0]]), toPoint(points[e[1]]));
        }

        typedef CGAL::AABB_segment_primitive
        <
            kernel,
            segments::const_iterator
        > primitive;
        tree_.reset(new boxTree<segments, primitive>(std::move(all)));
    }
    else
    {
        triangles all;
        for (const FixedList<label, 3>& e : elements)
        {
            all.emplace_back
            (
                toPoint(points[e[0]]),
                toPoint(points[e[1]]),
                toPoint(points[e[2]])
            );
        }

        typedef CGAL::AABB_triangle_primitive
        <
            kernel,
            triangles::const_iterator
        > primitive;
        tree_.reset(new boxTree<triangles, primitive>(std::move(all)));
    }
}


Foam::SPH::elementTree::~elementTree()
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::SPH::elementTree::nearest(const point& p) const
{
    return tree_->nearest(p);
}


// ************************************************************************* //
