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

    virtual label nearest
    (
        const point& p,
        const label hint,
        const point& hintPoint
    ) const = 0;

    virtual bool within(const point& p, const scalar distance) const = 0;
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

    //- Shape of each element, -1 if left out
    std::vector<label> shapeOfElement_;

    treeType tree_;

public:

    boxTree(Container&& shapes)
    {
        // Bounding box arithmetic of the library may raise exceptions
        const sigFpe::ignore noTrapping;

        shapes_.reserve(shapes.size());
        for (const auto& shape : shapes)
        {
            const bool keep = !shape.is_degenerate();
            shapeOfElement_.push_back(keep ? label(shapes_.size()) : -1);
            if (keep)
            {
                elements_.push_back(shapeOfElement_.size() - 1);
                shapes_.push_back(shape);
            }
        }

        tree_.rebuild(shapes_.begin(), shapes_.end());
        tree_.accelerate_distance_queries();
        tree_.build();
    }

    virtual label nearest
    (
        const point& p,
        const label hint,
        const point& hintPoint
    ) const
    {
        if (elements_.empty())
        {
            return -1;
        }

        const label start = hint < 0 ? -1 : shapeOfElement_[hint];

        const auto found =
            start < 0
          ? tree_.closest_point_and_primitive(toPoint(p))
          : tree_.closest_point_and_primitive
            (
                toPoint(p),
                typename treeType::Point_and_primitive_id
                (
                    toPoint(hintPoint),
                    shapes_.begin() + start
                )
            );

        return elements_[found.second - shapes_.begin()];
    }

    virtual bool within(const point& p, const scalar distance) const
    {
        const kernel::Sphere_3 sphere(toPoint(p), distance*distance);

        return !elements_.empty() && tree_.do_intersect(sphere);
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

    virtual label nearest(const point& p, const label, const point&) const
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

    virtual bool within(const point& p, const scalar distance) const
    {
        const label i = nearest(p, -1, p);

        return i >= 0 && mag(p.x() - points_[i].x()) < distance;
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

Foam::label Foam::SPH::elementTree::nearest
(
    const point& p,
    const label hint,
    const point& hintPoint
) const
{
    return tree_->nearest(p, hint, hintPoint);
}


bool Foam::SPH::elementTree::within
(
    const point& p,
    const scalar distance
) const
{
    return tree_->within(p, distance);
}


// ************************************************************************* //
