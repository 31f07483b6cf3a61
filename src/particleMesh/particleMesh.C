/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleMesh.H"
#include "particleFiles.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::particleMesh::check() const
{
    // A rank may have none
    const auto positive = [&](const scalarField& values, const char* name)
    {
        if (!(min(values) > 0) || !(max(values) < VGREAT))
        {
            FatalErrorInFunction
                << "The " << name << " of the particles in "
                << mesh_.boundaryMesh().path()
                << " are not all positive. Generate the particles anew with"
                << " sphMesh -overwrite" << exit(FatalError);
        }
    };

    positive(V(), "volumes");
    positive(spacing(), "spacings");
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::particleMesh::particleMesh(const fvMesh& mesh)
:
    particleMesh
    (
        mesh,
        particleFiles(mesh.time()).properties(),
        arrays(mesh, solutionSpace(mesh))
    )
{}


Foam::SPH::particleMesh::particleMesh
(
    const fvMesh& mesh,
    const dictionary& properties,
    particleMeshData&& data
)
:
    mesh_(mesh),
    space_(mesh),
    properties_(properties),
    kernel_(kernel::New(properties.subOrEmptyDict("kernel"), space_.nDims())),
    data_(std::move(data)),
    boundary_(new particleBoundary(mesh, data_.boundary))
{
    check();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::particleMesh::clearPairs()
{
    data_.owner.clear();
    data_.neighbour.clear();
    data_.Sf.clear();
    data_.delta.clear();
    data_.skew.clear();
}


// ************************************************************************* //
