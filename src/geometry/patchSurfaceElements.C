/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "patchSurface.H"
#include "Time.H"
#include "emptyPolyPatch.H"
#include "EdgeMap.H"
#include "triFace.H"
#include "SubField.H"
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
namespace
{

//- Stop because a mesh with empty patches is not an extrusion
void failNotExtruded(const polyMesh& mesh, const string& where)
{
    FatalErrorInFunction
        << "The mesh in " << mesh.boundaryMesh().path()
        << " has empty patches but is not one layer of cells extruded along "
        << "a coordinate axis: " << where.c_str() << exit(FatalError);
}


//- Is the face plane to round-off
bool isPlane(const face& f, const pointField& points, const vector& Sf)
{
    const vector n(Sf/(mag(Sf) + VSMALL));
    const scalar tolerance = 1e-12*(sqrt(mag(Sf)) + mag(points[f[0]]));

    for (const label pointi : f)
    {
        if (mag((points[pointi] - points[f[0]]) & n) > tolerance)
        {
            return false;
        }
    }

    return true;
}

} // End anonymous namespace
} // End namespace SPH
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::SPH::orientedSurface Foam::SPH::patchSurface::pointElements
(
    const polyMesh& mesh,
    const solutionSpace& space
)
{
    DynamicList<point> points;
    DynamicList<element> elements;

    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(pp))
        {
            continue;
        }

        forAll(pp, facei)
        {
            const vector& S = pp.faceAreas()[facei];

            if (mag(S[space.axis(0)]) < (1 - 1e-6)*mag(S))
            {
                failNotExtruded
                (
                    mesh,
                    "face " + name(facei) + " of patch " + pp.name()
                  + " is not normal to the solved direction"
                );
            }

            element e(points.size());
            e.patchi = pp.index();
            e.facei = facei;
            e.reversed = S[space.axis(0)] < 0;

            elements.append(e);
            points.append
            (
                space.position(space.toLocal(pp.faceCentres()[facei]))
            );
        }
    }

    return orientedSurface
    (
        space,
        pointField(std::move(points)),
        List<element>(std::move(elements))
    );
}


Foam::SPH::orientedSurface Foam::SPH::patchSurface::segmentElements
(
    const polyMesh& mesh,
    const solutionSpace& space
)
{
    // The direction not solved
    const direction dz = space.axis(2);
    const scalar zMid = space.position(Zero)[dz];
    const scalar tolerance = 1e-6*space.thickness();
    const pointField& meshPoints = mesh.points();

    for (const point& p : meshPoints)
    {
        if (mag(mag(p[dz] - zMid) - 0.5*space.thickness()) > tolerance)
        {
            std::ostringstream where;
            where
                << "point (" << p.x() << ' ' << p.y() << ' ' << p.z()
                << ") lies on neither of the two planes";
            failNotExtruded(mesh, where.str());
        }
    }

    DynamicList<point> points;
    DynamicList<element> elements;
    EdgeMap<label> vertexOfEdge;

    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(pp))
        {
            continue;
        }

        forAll(pp, facei)
        {
            const face& f = pp[facei];

            // Vertices at the edges that cross the mid-plane
            DynamicList<label> cut(2);

            forAll(f, k)
            {
                const edge e(f.faceEdge(k));
                const point& a = meshPoints[e.start()];
                const point& b = meshPoints[e.end()];

                if ((a[dz] > zMid) == (b[dz] > zMid))
                {
                    continue;
                }

                if (mag(space.toLocal(b - a)) > tolerance)
                {
                    failNotExtruded
                    (
                        mesh,
                        "face " + name(facei) + " of patch " + pp.name()
                      + " is not normal to the plane"
                    );
                }

                if (vertexOfEdge.insert(e, points.size()))
                {
                    points.append(space.position(space.toLocal(0.5*(a + b))));
                }
                cut.append(vertexOfEdge[e]);
            }

            if (cut.size() != 2)
            {
                failNotExtruded
                (
                    mesh,
                    "face " + name(facei) + " of patch " + pp.name()
                  + " does not extend from one plane to the other"
                );
            }

            element e(cut[0], cut[1]);
            e.patchi = pp.index();
            e.facei = facei;

            // The region on the left: outward (t_y, -t_x)
            const vector t(space.toLocal(points[cut[1]] - points[cut[0]]));
            const vector S(space.toLocal(pp.faceAreas()[facei]));

            if (t.y()*S.x() - t.x()*S.y() < 0)
            {
                std::swap(e.vertices[0], e.vertices[1]);
            }

            elements.append(e);
        }
    }

    return orientedSurface
    (
        space,
        pointField(std::move(points)),
        List<element>(std::move(elements))
    );
}


Foam::SPH::orientedSurface Foam::SPH::patchSurface::triangleElements
(
    const polyMesh& mesh,
    const solutionSpace& space
)
{
    const pointField& meshPoints = mesh.points();

    labelList newPoint(meshPoints.size(), -1);
    DynamicList<point> points;
    DynamicList<element> elements;
    DynamicList<face> triangles;

    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(pp))
        {
            continue;
        }

        forAll(pp, facei)
        {
            face f(pp[facei]);

            for (label& v : f)
            {
                if (newPoint[v] < 0)
                {
                    newPoint[v] = points.size();
                    points.append(meshPoints[v]);
                }
            }

            triangles.clear();

            if (isPlane(f, meshPoints, pp.faceAreas()[facei]))
            {
                f.triangles(meshPoints, triangles);
                for (face& t : triangles)
                {
                    inplaceRenumber(newPoint, t);
                }
            }
            else
            {
                inplaceRenumber(newPoint, f);
                forAll(f, k)
                {
                    triangles.append
                    (
                        face(triFace(f[k], f.nextLabel(k), points.size()))
                    );
                }
                points.append(pp.faceCentres()[facei]);
            }

            for (const face& t : triangles)
            {
                element e(t[0], t[1], t[2]);
                e.patchi = pp.index();
                e.facei = facei;
                elements.append(e);
            }
        }
    }

    return orientedSurface
    (
        space,
        pointField(std::move(points)),
        List<element>(std::move(elements))
    );
}


// ************************************************************************* //
