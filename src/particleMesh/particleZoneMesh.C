/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    The mesh of a zone of particles.

\*---------------------------------------------------------------------------*/

#include "particleZone.H"
#include "borderPatch.H"
#include "emptyPolyPatch.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- A name that no patch has
    static word unusedPatchName(const polyBoundaryMesh& patches)
    {
        word name("border");
        while (patches.findPatchID(name) >= 0)
        {
            name += '_';
        }
        return name;
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::SPH::particleZone::emptyPatch(const vector& direction) const
{
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if
        (
            isA<emptyPolyPatch>(pp)
         && pp.size()
         && max(pp.faceNormals() & direction) > 0.5
        )
        {
            return pp.index();
        }
    }

    return -1;
}


void Foam::SPH::particleZone::appendBody
(
    const label bodyi,
    DynamicList<point>& points,
    DynamicList<bodyFace>& faces
) const
{
    const orientedSurface& surface = bodies_.surface(bodyi);
    const solutionSpace& space = surface.space();
    const label wall = mesh_.boundaryMesh().size() + bodyi;
    const label start = points.size();
    const label n = surface.points().size();

    if (space.nDims() == 3)
    {
        points.append(surface.points());
        for (const orientedSurface::element& e : surface.elements())
        {
            face f(e.vertices);
            for (label& v : f)
            {
                v += start;
            }
            faces.append({f.reverseFace(), bodyi, wall});
        }
        return;
    }

    // Sides through the thickness of the mesh, from the first plane to the
    // second
    vector across(Zero);
    across[space.axis(2)] = space.thickness();
    points.append(surface.points() - 0.5*across);
    points.append(surface.points() + 0.5*across);

    List<DynamicList<label>> next(n);
    forAll(surface.elements(), elementi)
    {
        const orientedSurface::element& e = surface.elements()[elementi];
        const label a = start + e.vertices[0];
        const label b = start + e.vertices[1];
        const face f(labelList({a, b, b + n, a + n}));
        const bool outward =
            (f.areaNormal(points) & surface.areaVector(elementi)) > 0;

        faces.append({outward ? f.reverseFace() : f, bodyi, wall});
        next[e.vertices[0]].append(e.vertices[1]);
    }

    // The cut through the solid in both planes, a polygon for each closed loop.
    // Normals point into the solid: it is not part of the mesh
    const vector side(normalised(across));
    const label patches[2] = {emptyPatch(side), emptyPatch(-side)};
    for (label first = 0; first < n; ++first)
    {
        DynamicList<label> loop;
        for (label v = first; next[v].size(); v = next[v].remove())
        {
            loop.append(start + v);
        }
        if (loop.empty())
        {
            continue;
        }

        const face lower(loop);
        face upper(loop);
        for (label& v : upper)
        {
            v += n;
        }

        // Loops of segments have the solid on their left
        const bool leftHanded =
            ((space.toGlobal(vector(1, 0, 0)) ^ space.toGlobal(vector(0, 1, 0)))
          & side) < 0;
        faces.append
        ({
            leftHanded ? lower.reverseFace() : lower, bodyi, patches[0]
        });
        faces.append
        ({
            leftHanded ? upper : upper.reverseFace(), bodyi, patches[1]
        });
    }
}


void Foam::SPH::particleZone::makeMesh()
{
    labelList cellMap(mesh_.nCells(), -1);
    label nCells = 0;
    forAll(inside_, celli)
    {
        if (inside_[celli])
        {
            cellMap[celli] = nCells++;
        }
    }

    DynamicList<point> bodyPoints;
    DynamicList<bodyFace> bodyFaces;
    for (label bodyi = 0; bodyi < bodies_.size(); ++bodyi)
    {
        appendBody(bodyi, bodyPoints, bodyFaces);
    }

    const labelList& owner = mesh_.faceOwner();
    const labelList& neighbour = mesh_.faceNeighbour();

    // Internal faces, those of the patches, and the border
    DynamicList<label> faces;
    DynamicList<label> newNeighbour;
    DynamicList<label> border;
    for (label facei = 0; facei < mesh_.nInternalFaces(); ++facei)
    {
        const label nInside = inside_[owner[facei]] + inside_[neighbour[facei]];
        if (nInside == 2)
        {
            faces.append(facei);
            newNeighbour.append(cellMap[neighbour[facei]]);
        }
        else if (nInside == 1)
        {
            border.append(facei);
        }
    }

    labelList start(borderPatch() + 2, faces.size());
    for (label patchi = 0; patchi < borderPatch(); ++patchi)
    {
        if (patchi < mesh_.boundaryMesh().size())
        {
            const polyPatch& pp = mesh_.boundaryMesh()[patchi];
            forAll(pp, k)
            {
                if (inside_[pp.faceCells()[k]])
                {
                    faces.append(pp.start() + k);
                }
            }
        }
        forAll(bodyFaces, k)
        {
            if (bodyFaces[k].patchi == patchi)
            {
                faces.append(-1 - k);
            }
        }
        start[patchi + 1] = faces.size();
    }
    faces.append(border);
    start[borderPatch() + 1] = faces.size();
    faceMap_.transfer(faces);

    // Points in their order, and faces that leave the zone
    labelList pointMap(mesh_.nPoints(), -1);
    for (const label facei : faceMap_)
    {
        if (facei >= 0)
        {
            UIndirectList<label>(pointMap, mesh_.faces()[facei]) = 0;
        }
    }
    DynamicList<point> newPoints;
    forAll(pointMap, pointi)
    {
        if (pointMap[pointi] == 0)
        {
            pointMap[pointi] = newPoints.size();
            newPoints.append(mesh_.points()[pointi]);
        }
    }
    const label nFvmPoints = newPoints.size();
    newPoints.append(bodyPoints);

    labelList newOwner(faceMap_.size());
    faceList newFaces(faceMap_.size());
    forAll(faceMap_, k)
    {
        const label facei = faceMap_[k];
        if (facei < 0)
        {
            const bodyFace& f = bodyFaces[-1 - facei];
            newOwner[k] = nCells + f.bodyi;
            newFaces[k] = f.vertices;
            for (label& v : newFaces[k])
            {
                v += nFvmPoints;
            }
            continue;
        }

        const bool leaves = inside_[owner[facei]];
        const face& f = mesh_.faces()[facei];

        newOwner[k] = cellMap[leaves ? owner[facei] : neighbour[facei]];
        newFaces[k] = leaves ? f : f.reverseFace();
        inplaceRenumber(pointMap, newFaces[k]);
    }

    zoneMeshPtr_.reset
    (
        new fvMesh
        (
            IOobject
            (
                "zone",
                mesh_.time().timeName(),
                mesh_.time(),
                IOobject::NO_READ,
                IOobject::NO_WRITE
            ),
            pointField(std::move(newPoints)),
            std::move(newFaces),
            std::move(newOwner),
            labelList(std::move(newNeighbour))
        )
    );
    addPatches(start);
}


void Foam::SPH::particleZone::addPatches(const labelUList& start)
{
    const polyBoundaryMesh& boundary = zoneMeshPtr_->boundaryMesh();
    const label nFvm = mesh_.boundaryMesh().size();
    const auto size = [&](const label patchi)
    {
        return start[patchi + 1] - start[patchi];
    };

    DynamicList<polyPatch*> patches(borderPatch() + 1);
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        const label patchi = pp.index();
        patches.append
        (
            pp.clone(boundary, patchi, size(patchi), start[patchi]).ptr()
        );
    }
    for (label bodyi = 0; bodyi < bodies_.size(); ++bodyi)
    {
        const label patchi = nFvm + bodyi;
        patches.append
        (
            new wallPolyPatch
            (
                bodies_.name(bodyi),
                size(patchi),
                start[patchi],
                patchi,
                boundary,
                wallPolyPatch::typeName
            )
        );
        patches.last()->inGroups().append(bodyGroup);
    }
    if (!everywhere())
    {
        patches.append
        (
            new polyPatch
            (
                unusedPatchName(mesh_.boundaryMesh()),
                size(borderPatch()),
                start[borderPatch()],
                borderPatch(),
                boundary,
                polyPatch::typeName
            )
        );
        patches.last()->inGroups().append(borderGroup);
    }

    List<polyPatch*> all(std::move(patches));
    zoneMeshPtr_->addFvPatches(all);
}


// ************************************************************************* //
