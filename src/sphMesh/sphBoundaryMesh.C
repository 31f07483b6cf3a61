/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sphBoundaryMesh.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::sphBoundaryMesh::sphBoundaryMesh
(
    const fvMesh& mesh,
    const boundaryFaces& faces
)
:
    PtrList<sphPatch>(mesh.boundary().size()),
    faces_(faces)
{
    forAll(mesh.boundary(), patchi)
    {
        set(patchi, new sphPatch(mesh.boundary()[patchi], faces_));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::SPH::sphBoundaryMesh::patchIDs() const
{
    labelList ids(nFaces());

    for (const sphPatch& patch : *this)
    {
        SubList<label>(ids, patch.size(), patch.start()) = patch.index();
    }

    return ids;
}


// ************************************************************************* //
