/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particlePolyMesh.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::autoPtr<Foam::polyMesh> Foam::SPH::particlePolyMesh::makeMesh
(
    const Time& time,
    const word& region
) const
{
    label nFaces = faces_.owner().size();
    for (const particleFaces::patchFaces& patch : faces_.patches())
    {
        nFaces += patch.owner.size();
    }
    particlePolygons polygons(faces_.emptyEdges());
    polygons.reserve(nFaces);

    DynamicList<label> owner(nFaces);
    owner.append(faces_.owner());
    forAll(faces_.owner(), facei)
    {
        polygons.add(faces_.Cf()[facei], faces_.Sf()[facei]);
    }

    List<namedPatch> patches(faces_.patches().size());
    forAll(patches, patchi)
    {
        const particleFaces::patchFaces& patch = faces_.patches()[patchi];
        patches[patchi] =
            {patch.name, patch.dict, polygons.size(), patch.owner.size()};

        owner.append(patch.owner);
        forAll(patch.owner, k)
        {
            polygons.add(patch.Cf[k], patch.Sf[k]);
        }
    }

    return polygons.makeMesh
    (
        time,
        region,
        labelList(std::move(owner)),
        labelList(faces_.neighbour()),
        patches
    );
}


Foam::labelList Foam::SPH::particlePolyMesh::boundaryFace() const
{
    DynamicList<label> faces;
    for (const particleFaces::patchFaces& patch : faces_.patches())
    {
        faces.append(patch.face);
    }
    return labelList(std::move(faces));
}


// ************************************************************************* //
