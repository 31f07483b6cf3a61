/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particlePolyMesh.H"
#include "bandCompression.H"
#include "cellSpacing.H"

#include <algorithm>
#include <tuple>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::SPH::particleFaces::patchFaces&
Foam::SPH::particlePolyMesh::borderFaces() const
{
    static const particleFaces::patchFaces none{};
    return
        zone_.everywhere() ? none : particles_.patches()[zone_.borderPatch()];
}


void Foam::SPH::particlePolyMesh::number
(
    const labelUList& outer,
    const labelUList& order
)
{
    cellMap_ = labelList(order.size(), -1);
    ofFvm_ = labelList(fvm_.nCells(), -1);
    ofParticle_.setSize(data_.points.size());
    forAll(order, celli)
    {
        const label k = order[celli];
        if (k < outer.size())
        {
            cellMap_[celli] = outer[k];
            ofFvm_[outer[k]] = celli;
        }
        else
        {
            ofParticle_[k - outer.size()] = celli;
        }
    }
}


void Foam::SPH::particlePolyMesh::order()
{
    DynamicList<label> outer(fvm_.nCells());
    forAll(zone_.inside(), celli)
    {
        if (!zone_.inside()[celli])
        {
            outer.append(celli);
        }
    }

    number(outer, identity(outer.size() + data_.points.size()));
    if (zone_.everywhere())
    {
        // Particles have an order of their own
        return;
    }

    List<DynamicList<label>> neighbours(cellMap_.size());
    for (const innerFace& f : innerFaces())
    {
        neighbours[f.owner].append(f.neighbour);
        neighbours[f.neighbour].append(f.owner);
    }
    labelListList cellCells(neighbours.size());
    forAll(cellCells, celli)
    {
        cellCells[celli].transfer(neighbours[celli]);
    }
    number(outer, bandCompression(cellCells));
}


std::vector<Foam::SPH::particlePolyMesh::innerFace>
Foam::SPH::particlePolyMesh::innerFaces() const
{
    std::vector<innerFace> inner;

    const auto append =
        [&](const label a, const label b, const label face, const label source)
        {
            inner.push_back({min(a, b), max(a, b), a > b, face, source});
        };

    for (label facei = 0; facei < fvm_.nInternalFaces(); ++facei)
    {
        const label a = ofFvm_[fvm_.faceOwner()[facei]];
        const label b = ofFvm_[fvm_.faceNeighbour()[facei]];
        if (a >= 0 && b >= 0)
        {
            append(a, b, facei, -1);
        }
    }

    forAll(particles_.owner(), pairi)
    {
        append
        (
            ofParticle_[particles_.owner()[pairi]],
            ofParticle_[particles_.neighbour()[pairi]],
            -1,
            pairi
        );
    }

    // The area vectors of the border's parts leave the particles
    const particleFaces::patchFaces& border = borderFaces();
    forAll(border.owner, k)
    {
        const label facei = zone_.fvmFace(zone_.borderPatch(), border.face[k]);
        const label a = ofFvm_[fvm_.faceOwner()[facei]];
        const label b = ofFvm_[fvm_.faceNeighbour()[facei]];
        append(ofParticle_[border.owner[k]], max(a, b), facei, k);
    }

    std::sort
    (
        inner.begin(),
        inner.end(),
        [](const innerFace& a, const innerFace& b)
        {
            return
                std::tie(a.owner, a.neighbour, a.fvmFace, a.source)
              < std::tie(b.owner, b.neighbour, b.fvmFace, b.source);
        }
    );

    return inner;
}


void Foam::SPH::particlePolyMesh::addFvmFace
(
    const label facei,
    const bool turned
)
{
    face f(fvm_.faces()[facei]);
    for (label& pointi : f)
    {
        label& mapped = pointMap_[pointi];
        if (mapped < 0)
        {
            mapped = polygons_.addPoint(fvm_.points()[pointi]);
        }
        pointi = mapped;
    }
    polygons_.add(turned ? f.reverseFace() : f);
}


void Foam::SPH::particlePolyMesh::addInnerFaces()
{
    const particleFaces::patchFaces& border = borderFaces();

    for (const innerFace& f : innerFaces())
    {
        const scalar sign = f.turned ? -1 : 1;
        if (f.source < 0)
        {
            addFvmFace(f.fvmFace, f.turned);
        }
        else if (f.fvmFace < 0)
        {
            polygons_.add
            (
                particles_.Cf()[f.source],
                sign*particles_.Sf()[f.source]
            );
        }
        else
        {
            border_.append(owner_.size());
            fromParticle_.append(cellMap_[f.owner] < 0);
            polygons_.add(border.Cf[f.source], sign*border.Sf[f.source]);
        }
        owner_.append(f.owner);
        neighbour_.append(f.neighbour);
        faceMap_.append(f.fvmFace);
    }
}


void Foam::SPH::particlePolyMesh::addPatches()
{
    const label nFvm = fvm_.boundaryMesh().size();
    const label nPatches = particles_.patches().size();

    for (label patchi = 0; patchi < nPatches; ++patchi)
    {
        const particleFaces::patchFaces& patch = particles_.patches()[patchi];
        if (&patch == &borderFaces())
        {
            continue;
        }

        const label start = polygons_.size();
        const label fvmStart =
            patchi < nFvm ? fvm_.boundaryMesh()[patchi].start() : 0;
        const label nFvmFaces =
            patchi < nFvm ? fvm_.boundaryMesh()[patchi].size() : 0;

        const auto append = [&](const label celli, const label local)
        {
            owner_.append(celli);
            boundaryFace_.append(local);
            faceMap_.append(local < 0 ? -1 : fvmStart + local);
        };

        for (label k = 0; k < nFvmFaces; ++k)
        {
            const label celli = ofFvm_[fvm_.faceOwner()[fvmStart + k]];
            if (celli >= 0)
            {
                addFvmFace(fvmStart + k, false);
                append(celli, k);
            }
        }
        forAll(patch.owner, k)
        {
            const label facei = patch.face[k];
            polygons_.add(patch.Cf[k], patch.Sf[k]);
            append
            (
                ofParticle_[patch.owner[k]],
                facei < 0 ? -1 : zone_.fvmFace(patchi, facei)
            );
        }
        patches_.append
        (
            namedPatch
            {
                patch.name, patch.dict, start, polygons_.size() - start
            }
        );
    }
}


void Foam::SPH::particlePolyMesh::addZones(polyMesh& mesh) const
{
    DynamicList<label> cells[2];
    forAll(cellMap_, celli)
    {
        cells[cellMap_[celli] < 0].append(celli);
    }

    List<cellZone*> cellZones(2);
    for (const label k : {0, 1})
    {
        cellZones[k] =
            new cellZone(k ? "sph" : "fvm", cells[k], k, mesh.cellZones());
    }
    const List<faceZone*> faceZones
    (
        1,
        new faceZone
        (
            "interface",
            border_,
            boolList(fromParticle_),
            0,
            mesh.faceZones()
        )
    );
    mesh.addZones(List<pointZone*>(), faceZones, cellZones);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::particlePolyMesh::particlePolyMesh
(
    const particleZone& zone,
    const solutionSpace& space,
    const particleMeshData& data
)
:
    fvm_(zone.fvm()),
    zone_(zone),
    space_(space),
    data_(data),
    particles_(zone.mesh(), space, data),
    polygons_(particles_.emptyEdges()),
    pointMap_(fvm_.nPoints(), -1)
{
    order();
    addInnerFaces();
    addPatches();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::autoPtr<Foam::polyMesh> Foam::SPH::particlePolyMesh::makeMesh
(
    const Time& time,
    const word& region
)
{
    autoPtr<polyMesh> meshPtr
    (
        polygons_.makeMesh
        (
            time,
            region,
            labelList(std::move(owner_)),
            labelList(std::move(neighbour_)),
            patches_
        )
    );
    if (!zone_.everywhere())
    {
        addZones(*meshPtr);
    }

    return meshPtr;
}


Foam::pointField Foam::SPH::particlePolyMesh::points() const
{
    return combine(fvm_.cellCentres(), data_.points);
}


Foam::scalarField Foam::SPH::particlePolyMesh::V() const
{
    return combine(fvm_.cellVolumes(), data_.V);
}


Foam::scalarField Foam::SPH::particlePolyMesh::spacing() const
{
    return combine(cellSpacing(space_, fvm_), data_.spacing);
}


// ************************************************************************* //
