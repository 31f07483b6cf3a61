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
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>

#include "trianglePrisms.H"
#include "trapsOff.H"
#include "cellModel.H"
#include "IFstream.H"
#include "Time.H"
#include "vector2D.H"

#include <list>
#include <map>
#include <set>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

typedef CGAL::Exact_predicates_inexact_constructions_kernel kernel;
typedef CGAL::Triangulation_data_structure_2
<
    CGAL::Delaunay_mesh_vertex_base_2<kernel>,
    CGAL::Delaunay_mesh_face_base_2<kernel>
> dataStructure;
typedef CGAL::Constrained_Delaunay_triangulation_2<kernel, dataStructure>
    triangulation;
typedef CGAL::Delaunay_mesh_size_criteria_2<triangulation> criteria;

//- Segments of a patch
typedef DynamicList<Pair<vector2D>> outline;


//- A positive number, 1 by default, or FatalIOError
scalar positive(const dictionary& dict, const word& key)
{
    const scalar value(dict.getOrDefault<scalar>(key, 1));
    if (value <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << key << " is " << value << ", but must be positive"
            << exit(FatalIOError);
    }
    return value;
}


//- Points of an entry: a list, or the name of a file
List<vector2D> readPoints
(
    const dictionary& dict,
    const word& key,
    const fileName& directory
)
{
    ITstream& is = dict.lookup(key);

    if (is.empty() || !is[0].isString())
    {
        return List<vector2D>(is);
    }

    const fileName file(dict.get<fileName>(key));
    IFstream points(file.isAbsolute() ? file : directory/file);

    if (!points.good())
    {
        FatalIOErrorInFunction(dict)
            << "Patch " << dict.dictName() << ": cannot read the file "
            << points.name() << " of the entry " << key << exit(FatalIOError);
    }

    DynamicList<vector2D> values;
    string line;
    while (points.getLine(line))
    {
        std::istringstream numbers(line.substr(0, line.find('#')));
        if ((numbers >> std::ws).eof())
        {
            continue;
        }

        vector2D p;
        if (!(numbers >> p.x() >> p.y()))
        {
            FatalIOErrorInFunction(points)
                << "Patch " << dict.dictName() << ": '" << line.c_str()
                << "' is not a point 'x y'" << exit(FatalIOError);
        }
        values.append(p);
    }

    return List<vector2D>(std::move(values));
}


outline readOutline(const dictionary& dict, const fileName& directory)
{
    if (dict.found("loop") == dict.found("line"))
    {
        FatalIOErrorInFunction(dict)
            << "Patch " << dict.dictName() << " must have one of the entries"
            << " 'loop', a closed polygon, and 'line', an open one"
            << exit(FatalIOError);
    }

    const bool closed = dict.found("loop");
    const List<vector2D> points
    (
        readPoints(dict, closed ? "loop" : "line", directory)
    );

    if (points.size() < (closed ? 3 : 2))
    {
        FatalIOErrorInFunction(dict)
            << "Patch " << dict.dictName() << " has " << points.size()
            << " points. Valid: 3 or more of a loop, 2 or more of a line"
            << exit(FatalIOError);
    }

    outline segments(points.size());
    for (label i = 0; i < points.size() - (closed ? 0 : 1); ++i)
    {
        const vector2D& next = points[points.fcIndex(i)];

        // A loop's file may repeat its first point at the end
        if (mag(next - points[i]) > VSMALL)
        {
            segments.append(Pair<vector2D>(points[i], next));
        }
    }

    return segments;
}


//- Distance of a point from the nearest segment
scalar distance(const outline& segments, const vector2D& p)
{
    scalar nearest = GREAT;

    for (const Pair<vector2D>& s : segments)
    {
        const vector2D d(s.second() - s.first());
        const scalar along =
            max(scalar(0), min(scalar(1), ((p - s.first()) & d)/magSqr(d)));
        nearest = min(nearest, mag(s.first() + along*d - p));
    }

    return nearest;
}


//- Mark the triangles that an odd number of lines encloses
void markDomain(const triangulation& t)
{
    // All of a region comes before what lies across its lines
    std::set<triangulation::Face_handle> marked;
    std::list<std::pair<triangulation::Face_handle, bool>> front;
    front.push_back({t.infinite_face(), false});

    while (!front.empty())
    {
        const auto [f, inside] = front.front();
        front.pop_front();
        if (!marked.insert(f).second)
        {
            continue;
        }

        f->set_in_domain(inside);
        for (int k = 0; k < 3; ++k)
        {
            const bool line = t.is_constrained({f, k});
            front.insert
            (
                line ? front.end() : front.begin(),
                {f->neighbor(k), inside != line}
            );
        }
    }
}


//- Triangles of at most the size within the outlines
void triangulate
(
    const UList<outline>& outlines,
    const scalar size,
    triangulation& t
)
{
    const SPH::trapsOff noTraps;

    for (const outline& segments : outlines)
    {
        for (const Pair<vector2D>& s : segments)
        {
            t.insert_constraint
            (
                kernel::Point_2(s.first().x(), s.first().y()),
                kernel::Point_2(s.second().x(), s.second().y())
            );
        }
    }

    if (t.dimension() < 2)
    {
        return;
    }
    markDomain(t);

    // The default bound of the angles, for which CGAL's refinement ends
    CGAL::Delaunay_mesher_2<triangulation, criteria> mesher
    (
        t, criteria(0.125, size)
    );
    mesher.init(true);
    mesher.refine_mesh();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::autoPtr<Foam::polyMesh> Foam::SPH::newPolygonMesh
(
    const IOobject& io,
    const dictionary& dict
)
{
    dict.get<scalar>("size");
    const scalar size = positive(dict, "size");
    const scalar thickness = positive(dict, "thickness");

    DynamicList<word> names;
    DynamicList<word> types;
    DynamicList<outline> outlines;
    for (const entry& e : dict.subDict("patches"))
    {
        names.append(e.keyword());
        types.append(e.dict().getOrDefault<word>("type", "wall"));
        outlines.append(readOutline(e.dict(), io.time().path()));
    }

    triangulation t;
    triangulate(outlines, size, t);

    // The points of a vertex: 2i at z = 0 and 2i + 1 above it
    DynamicList<point> points;
    DynamicList<cellShape> prisms;
    List<DynamicList<face>> sides(names.size());
    std::map<triangulation::Vertex_handle, label> index;

    for (auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f)
    {
        if (!f->is_in_domain())
        {
            continue;
        }

        labelList corners(6);
        for (int k = 0; k < 3; ++k)
        {
            const auto inserted = index.emplace(f->vertex(k), points.size());
            if (inserted.second)
            {
                const kernel::Point_2& p = f->vertex(k)->point();
                points.append(point(p.x(), p.y(), 0));
                points.append(point(p.x(), p.y(), thickness));
            }
            corners[k] = inserted.first->second;
            corners[k + 3] = corners[k] + 1;
        }
        prisms.append(cellShape(cellModel::ref(cellModel::PRISM), corners));

        for (int k = 0; k < 3; ++k)
        {
            if (f->neighbor(k)->is_in_domain())
            {
                continue;
            }

            const label a = corners[(k + 1) % 3];
            const label b = corners[(k + 2) % 3];
            const point middle(0.5*(points[a] + points[b]));
            scalarList distances(outlines.size());
            forAll(outlines, i)
            {
                distances[i] =
                    distance(outlines[i], vector2D(middle.x(), middle.y()));
            }
            sides[findMin(distances)].append
            (
                face(labelList({a, b, b + 1, a + 1}))
            );
        }
    }

    if (prisms.empty())
    {
        FatalErrorInFunction
            << "The patches enclose nothing: their lines must make closed"
            << " polygons, with equal coordinates where they meet"
            << exit(FatalError);
    }

    faceListList boundary(sides.size());
    forAll(boundary, i)
    {
        boundary[i] = sides[i];
    }

    return autoPtr<polyMesh>::New
    (
        io,
        pointField(std::move(points)),
        prisms,
        boundary,
        names,
        types,
        "frontAndBack",
        "empty",
        wordList()
    );
}


// ************************************************************************* //
