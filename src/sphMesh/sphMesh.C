/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sphMesh.H"
#include "meshSearch.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    defineTypeNameAndDebug(sphMesh, 0);

    const word sphMesh::folder("sphMesh");
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::sphMesh::check() const
{
    const label n = nParticles();
    const label nP = nPairs();
    const boundaryFaces& faces = boundary().faces();

    const bool sized =
        data_.V.size() == n
     && data_.spacing.size() == n
     && data_.neighbour.size() == nP
     && data_.Sf.size() == nP
     && data_.delta.size() == nP
     && (data_.skew.empty() || data_.skew.size() == nP)
     && faces.start.size() == mesh_.boundary().size() + 1
     && faces.start.last() == faces.owner.size()
     && faces.Sf.size() == faces.owner.size()
     && faces.Cf.size() == faces.owner.size()
     && faces.distance.size() == faces.owner.size()
     && faces.face.size() == faces.owner.size()
     && (
            faces.wallNormal.empty()
         || faces.wallNormal.size() == faces.owner.size()
        );

    const bool inRange =
        (nP == 0 || (min(data_.owner) >= 0 && max(data_.neighbour) < n))
     && (faces.owner.empty()
      || (min(faces.owner) >= 0 && max(faces.owner) < n));

    bool valid = n > 0 && sized && inRange;

    for (label pairi = 0; valid && pairi < nP; ++pairi)
    {
        valid =
            data_.owner[pairi] < data_.neighbour[pairi]
         && magSqr(data_.delta[pairi]) > 0
         && mag(data_.Sf[pairi]) < GREAT;
    }
    for (label i = 0; valid && i < n; ++i)
    {
        valid =
            data_.V[i] > 0
         && data_.spacing[i] > 0
         && mag(data_.points[i]) < GREAT;
    }
    for (const sphPatch& patch : boundary())
    {
        const labelUList faces(patch.face());
        valid =
            valid
         && (
                faces.empty()
             || (min(faces) >= 0 && max(faces) < patch.patch().patch().size())
            );
    }

    if (!valid)
    {
        FatalErrorInFunction
            << "The particle mesh in " << directory(mesh_)
            << " is inconsistent: sizes, addressing or values of its arrays"
            << " do not agree. Regenerate it with sphMesh -overwrite"
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::sphMesh::sphMesh
(
    const fvMesh& mesh,
    const dictionary& properties,
    particleMeshData&& data
)
:
    regIOobject(IOobject(typeName, mesh.facesInstance(), mesh)),
    mesh_(mesh),
    space_(mesh),
    properties_(properties),
    kernel_(kernel::New(properties.subOrEmptyDict("kernel"), space_.nDims())),
    data_(std::move(data)),
    boundary_(new sphBoundaryMesh(mesh, data_.boundary))
{
    check();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::labelList& Foam::SPH::sphMesh::cells() const
{
    if (!cellsPtr_.valid())
    {
        meshSearch search(mesh_, polyMesh::FACE_PLANES);

        cellsPtr_.reset(new labelList(nParticles(), -1));
        labelList& cells = *cellsPtr_;

        label seed = -1;
        forAll(cells, i)
        {
            label celli = search.findCell(C()[i], seed, true);
            if (celli < 0)
            {
                celli = search.findNearestCell(C()[i], seed, true);
            }
            cells[i] = seed = celli;
        }
    }

    return *cellsPtr_;
}


// ************************************************************************* //
