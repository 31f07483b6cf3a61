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

#include "prismMesh.H"
#include "trapsOff.H"
#include "EdgeMap.H"

#include <list>
#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

typedef CGAL::Exact_predicates_inexact_constructions_kernel kernel;
typedef CGAL::Triangulation_data_structure_2
<
    CGAL::Delaunay_mesh_vertex_base_2<kernel>,
    CGAL::Delaunay_mesh_face_base_2<kernel>
> dataStructure;
typedef CGAL::Constrained_Delaunay_triangulation_2<kernel, dataStructure>
    triangulation;
typedef CGAL::Delaunay_mesh_size_criteria_2<triangulation> criteria;


//- A point in each region that an even number of lines encloses, other than
//- the outermost one
std::list<kernel::Point_2> holes(const triangulation& t)
{
    std::list<kernel::Point_2> seeds;
    std::map<triangulation::Face_handle, int> depth;
    std::list<std::pair<triangulation::Face_handle, int>> front;
    front.push_back({t.infinite_face(), 0});

    while (!front.empty())
    {
        const auto start = front.front();
        front.pop_front();
        if (depth.count(start.first))
        {
            continue;
        }
        if (start.second > 0 && start.second % 2 == 0)
        {
            seeds.push_back(CGAL::centroid(t.triangle(start.first)));
        }

        // The region of the face, and what lies across its lines
        std::list<triangulation::Face_handle> region(1, start.first);
        while (!region.empty())
        {
            const triangulation::Face_handle f = region.front();
            region.pop_front();
            if (!depth.emplace(f, start.second).second)
            {
                continue;
            }
            for (int k = 0; k < 3; ++k)
            {
                const triangulation::Face_handle other = f->neighbor(k);
                if (depth.count(other))
                {
                    continue;
                }
                if (t.is_constrained({f, k}))
                {
                    front.push_back({other, start.second + 1});
                }
                else
                {
                    region.push_back(other);
                }
            }
        }
    }

    return seeds;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::prismMesh::triangulate
(
    const PtrList<polygonPatch>& patches,
    const scalar size
)
{
    const trapsOff noTraps;

    triangulation t;
    for (const polygonPatch& patch : patches)
    {
        for (label i = 0; i < patch.size(); ++i)
        {
            t.insert_constraint
            (
                kernel::Point_2(patch.from(i).x(), patch.from(i).y()),
                kernel::Point_2(patch.to(i).x(), patch.to(i).y())
            );
        }
    }

    const std::list<kernel::Point_2> seeds(holes(t));

    // The default bound of the angles, for which CGAL's refinement ends
    CGAL::Delaunay_mesher_2<triangulation, criteria> mesher
    (
        t, criteria(0.125, size)
    );
    mesher.set_seeds(seeds.begin(), seeds.end());
    mesher.refine_mesh();

    std::map<triangulation::Vertex_handle, label> index;
    for (auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f)
    {
        if (!f->is_in_domain())
        {
            continue;
        }

        triFace triangle;
        for (int k = 0; k < 3; ++k)
        {
            const auto inserted = index.emplace(f->vertex(k), points_.size());
            if (inserted.second)
            {
                const kernel::Point_2& p = f->vertex(k)->point();
                points_.append(vector2D(p.x(), p.y()));
            }
            triangle[k] = inserted.first->second;
        }
        triangles_.append(triangle);
    }

    if (triangles_.empty())
    {
        FatalErrorInFunction
            << "The patches enclose nothing: their lines must make closed"
            << " polygons, with equal coordinates where they meet"
            << exit(FatalError);
    }
}


void Foam::SPH::prismMesh::extrude(const PtrList<polygonPatch>& patches)
{
    const label nPoints = points_.size();
    const auto upright = [&](const label a, const label b)
    {
        return face(labelList({a, b, b + nPoints, a + nPoints}));
    };

    // Edges as seen by the first triangle, which is to their left
    EdgeMap<labelPair> cells(3*triangles_.size());
    forAll(triangles_, celli)
    {
        for (label k = 0; k < 3; ++k)
        {
            const edge e(triangles_[celli][k], triangles_[celli][(k + 1) % 3]);
            auto iter = cells.find(e);
            if (iter.found())
            {
                (*iter).second() = celli;
            }
            else
            {
                cells.insert(e, labelPair(celli, -1));
            }
        }
    }

    DynamicList<face> faces(3*triangles_.size());
    DynamicList<label> owner(3*triangles_.size());
    DynamicList<label> neighbour(3*triangles_.size()/2);
    List<DynamicList<edge>> patchEdges(patches.size());
    List<DynamicList<label>> patchOwner(patches.size());

    forAll(triangles_, celli)
    {
        std::map<label, edge> next;

        for (label k = 0; k < 3; ++k)
        {
            const label a = triangles_[celli][k];
            const label b = triangles_[celli][(k + 1) % 3];
            const labelPair& c = cells[edge(a, b)];

            if (c.second() < 0)
            {
                const vector2D middle(0.5*(points_[a] + points_[b]));
                label patchi = 0;
                scalar nearest = GREAT;
                forAll(patches, i)
                {
                    const scalar d = patches[i].distance(middle);
                    if (d < nearest)
                    {
                        nearest = d;
                        patchi = i;
                    }
                }
                patchEdges[patchi].append(edge(a, b));
                patchOwner[patchi].append(celli);
            }
            else if (c.first() == celli)
            {
                next.emplace(c.second(), edge(a, b));
            }
        }

        for (const auto& e : next)
        {
            faces.append(upright(e.second[0], e.second[1]));
            owner.append(celli);
            neighbour.append(e.first);
        }
    }

    forAll(patches, patchi)
    {
        forAll(patchEdges[patchi], i)
        {
            const edge& e = patchEdges[patchi][i];
            faces.append(upright(e[0], e[1]));
            owner.append(patchOwner[patchi][i]);
        }
        patchNames_.append(patches[patchi].name());
        patchTypes_.append(patches[patchi].type());
        patchSizes_.append(patchEdges[patchi].size());
    }

    forAll(triangles_, celli)
    {
        const triFace& t = triangles_[celli];
        faces.append(face(labelList({t[0], t[2], t[1]})));
        faces.append
        (
            face(labelList({t[0] + nPoints, t[1] + nPoints, t[2] + nPoints}))
        );
        owner.append(celli);
        owner.append(celli);
    }
    patchNames_.append("frontAndBack");
    patchTypes_.append("empty");
    patchSizes_.append(2*triangles_.size());

    faces_.transfer(faces);
    owner_.transfer(owner);
    neighbour_.transfer(neighbour);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::prismMesh::prismMesh
(
    const PtrList<polygonPatch>& patches,
    const scalar size,
    const scalar thickness
)
:
    thickness_(thickness)
{
    triangulate(patches, size);
    extrude(patches);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::pointField Foam::SPH::prismMesh::points() const
{
    const label n = points_.size();
    pointField points(2*n);
    forAll(points_, i)
    {
        points[i] = point(points_[i].x(), points_[i].y(), 0);
        points[i + n] = point(points_[i].x(), points_[i].y(), thickness_);
    }
    return points;
}


Foam::List<Foam::polyPatch*> Foam::SPH::prismMesh::newPatches
(
    const polyBoundaryMesh& boundary
) const
{
    List<polyPatch*> patches(patchNames_.size());
    label start = neighbour_.size();

    forAll(patches, patchi)
    {
        patches[patchi] = polyPatch::New
        (
            patchTypes_[patchi],
            patchNames_[patchi],
            patchSizes_[patchi],
            start,
            patchi,
            boundary
        ).ptr();
        start += patchSizes_[patchi];
    }

    return patches;
}


// ************************************************************************* //
