/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleBoundary.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::particleBoundary::particleBoundary
(
    const fvMesh& mesh,
    const boundaryFaces& faces
)
:
    PtrList<particlePatch>(mesh.boundary().size()),
    faces_(faces)
{
    forAll(mesh.boundary(), patchi)
    {
        set(patchi, new particlePatch(mesh.boundary()[patchi], faces_));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::SPH::particleBoundary::patchIDs() const
{
    labelList ids(nFaces());

    for (const particlePatch& patch : *this)
    {
        SubList<label>(ids, patch.size(), patch.start()) = patch.index();
    }

    return ids;
}


// ************************************************************************* //
