/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "wallStencils.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    defineTypeNameAndDebug(wallStencils, 0);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::wallStencils::wallStencils(const fvMesh& mesh)
:
    MeshObject<fvMesh, UpdateableMeshObject, wallStencils>(mesh)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::SPH::wallStencil& Foam::SPH::wallStencils::stencil
(
    const fvPatch& patch,
    const boolUList& known
) const
{
    word key(Foam::name(patch.index()) + ':');
    for (const bool k : known)
    {
        key += k ? '1' : '0';
    }

    if (!stencils_.found(key))
    {
        stencils_.set(key, new wallStencil(patch, known));
    }

    return *stencils_[key];
}


bool Foam::SPH::wallStencils::movePoints()
{
    stencils_.clear();
    return true;
}


void Foam::SPH::wallStencils::updateMesh(const mapPolyMesh&)
{
    stencils_.clear();
}


// ************************************************************************* //
