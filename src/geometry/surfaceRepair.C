/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <sstream>
#include <vector>

#include "surfaceRepair.H"
#include "sigFpe.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Simple_cartesian<double> kernel;
typedef CGAL::Surface_mesh<kernel::Point_3> surfaceMesh;


//- Fill the holes whose box is small with triangles around the mean of their
//- vertices. \return number of filled ones.
//  CGAL's triangulate_hole takes 27 s instead of .04 s for two wavy rims of
//  8000 edges, and its lids, of least area, miss the volume by a tenth
size_t fillHoles(surfaceMesh& mesh, const double maxSize)
{
    std::vector<surfaceMesh::Halfedge_index> holes;
    PMP::extract_boundary_cycles(mesh, std::back_inserter(holes));

    size_t nFilled = 0;
    for (const surfaceMesh::Halfedge_index hole : holes)
    {
        CGAL::Bbox_3 box;
        kernel::Vector_3 sum(CGAL::NULL_VECTOR);
        size_t n = 0;
        for (const auto h : CGAL::halfedges_around_face(hole, mesh))
        {
            const kernel::Point_3& p = mesh.point(mesh.target(h));
            box += p.bbox();
            sum += p - CGAL::ORIGIN;
            ++n;
        }

        const double size = std::max
        ({
            box.xmax() - box.xmin(),
            box.ymax() - box.ymin(),
            box.zmax() - box.zmin()
        });

        if (size <= maxSize)
        {
            CGAL::Euler::fill_hole(hole, mesh);
            if (n > 3)
            {
                const auto h = CGAL::Euler::add_center_vertex(hole, mesh);
                mesh.point(mesh.target(h)) = CGAL::ORIGIN + sum/double(n);
            }
            ++nFilled;
        }
    }

    return nFilled;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::string Foam::SPH::repairSurface
(
    triSurface& surface,
    const scalar maxHoleSize
)
{
    // Degenerate triangles may raise exceptions
    const sigFpe::ignore noTrapping;

    std::vector<kernel::Point_3> points;
    for (const point& p : surface.points())
    {
        points.emplace_back(p.x(), p.y(), p.z());
    }

    std::vector<std::vector<std::size_t>> triangles;
    for (const labelledTri& t : surface)
    {
        triangles.push_back({size_t(t[0]), size_t(t[1]), size_t(t[2])});
    }

    std::ostringstream done;

    const size_t nPoints = points.size();
    const size_t nTriangles = triangles.size();
    PMP::repair_polygon_soup(points, triangles);
    if (points.size() != nPoints || triangles.size() != nTriangles)
    {
        done<< nPoints - points.size() << " duplicate points and "
            << nTriangles - triangles.size()
            << " degenerate or duplicate triangles removed, ";
    }

    if (!PMP::orient_polygon_soup(points, triangles))
    {
        done<< "points or edges that are not manifold duplicated, ";
    }

    surfaceMesh mesh;
    PMP::polygon_soup_to_polygon_mesh(points, triangles, mesh);

    const size_t nStitched = PMP::stitch_borders(mesh);
    if (nStitched)
    {
        done<< nStitched << " border edges stitched, ";
    }

    const size_t nFilled =
        fillHoles(mesh, maxHoleSize*boundBox(surface.points(), false).mag());
    if (nFilled)
    {
        done<< nFilled << " holes filled, ";
    }

    done<< "triangles oriented alike";

    mesh.collect_garbage();

    pointField newPoints(mesh.number_of_vertices());
    for (const surfaceMesh::Vertex_index v : mesh.vertices())
    {
        const kernel::Point_3& p = mesh.point(v);
        newPoints[label(v)] = point(p.x(), p.y(), p.z());
    }

    DynamicList<labelledTri> newTriangles(mesh.number_of_faces());
    for (const surfaceMesh::Face_index f : mesh.faces())
    {
        FixedList<label, 3> v;
        label k = 0;
        for (const auto vi : mesh.vertices_around_face(mesh.halfedge(f)))
        {
            v[k++] = label(vi);
        }
        newTriangles.append(labelledTri(v[0], v[1], v[2], 0));
    }

    surface = triSurface(List<labelledTri>(std::move(newTriangles)), newPoints);

    return done.str();
}


// ************************************************************************* //
