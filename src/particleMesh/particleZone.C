/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleZone.H"
#include "borderPatch.H"
#include "cyclicPolyPatch.H"
#include "zoneCells.H"

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

void Foam::SPH::particleZone::checkCyclic(const dictionary& dict) const
{
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        const auto* cyclic = isA<cyclicPolyPatch>(pp);
        for (label k = 0; cyclic && k < pp.size(); ++k)
        {
            const bool here = inside_[pp.faceCells()[k]];
            if (here != inside_[cyclic->neighbPatch().faceCells()[k]])
            {
                FatalIOErrorInFunction(dict)
                    << "zone: of the pair of cyclic faces at "
                    << pp.faceCentres()[k] << " on patch " << pp.name()
                    << " and at "
                    << cyclic->neighbPatch().faceCentres()[k] << " on patch "
                    << cyclic->neighbPatchName() << " only the cell at "
                    << (here ? pp.name() : cyclic->neighbPatchName())
                    << " is in the zone. Put both in or leave both out"
                    << exit(FatalIOError);
            }
        }
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

    const label nPatches = mesh_.boundaryMesh().size();
    labelList start(nPatches + 2, faces.size());
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        forAll(pp, k)
        {
            if (inside_[pp.faceCells()[k]])
            {
                faces.append(pp.start() + k);
            }
        }
        start[pp.index() + 1] = faces.size();
    }
    faces.append(border);
    start[nPatches + 1] = faces.size();
    faceMap_.transfer(faces);

    // Points in their order, and faces that leave the zone
    labelList pointMap(mesh_.nPoints(), -1);
    for (const label facei : faceMap_)
    {
        UIndirectList<label>(pointMap, mesh_.faces()[facei]) = 0;
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
    labelList newOwner(faceMap_.size());
    faceList newFaces(faceMap_.size());
    forAll(faceMap_, k)
    {
        const label facei = faceMap_[k];
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

    List<polyPatch*> patches(nPatches + 1);
    for (label patchi = 0; patchi < nPatches; ++patchi)
    {
        patches[patchi] = mesh_.boundaryMesh()[patchi].clone
        (
            zoneMeshPtr_->boundaryMesh(),
            patchi,
            start[patchi + 1] - start[patchi],
            start[patchi]
        ).ptr();
    }
    patches[nPatches] = new polyPatch
    (
        unusedPatchName(mesh_.boundaryMesh()),
        border.size(),
        start[nPatches],
        nPatches,
        zoneMeshPtr_->boundaryMesh(),
        polyPatch::typeName
    );
    patches[nPatches]->inGroups().append(borderGroup);
    zoneMeshPtr_->addFvPatches(patches);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::particleZone::particleZone
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    mesh_(mesh),
    inside_(zoneCells(mesh, dict))
{
    if (inside_.found(false))
    {
        checkCyclic(dict);
        makeMesh();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::SPH::particleZone::fvmFace
(
    const label patchi,
    const label facei
) const
{
    if (everywhere())
    {
        return facei;
    }

    const label fvmFacei =
        faceMap_[mesh().boundaryMesh()[patchi].start() + facei];

    return
        patchi == borderPatch()
      ? fvmFacei
      : fvmFacei - mesh_.boundaryMesh()[patchi].start();
}


// ************************************************************************* //
