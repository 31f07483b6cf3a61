/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleDecomposition.H"
#include "globalIndex.H"
#include "labelIOList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Addressing of a processor directory, empty if it has none
    static labelList readAddressing(const fvMesh& mesh, const word& name)
    {
        return labelIOList
        (
            IOobject
            (
                name,
                mesh.facesInstance(),
                polyMesh::meshSubDir,
                mesh,
                IOobject::READ_IF_PRESENT,
                IOobject::NO_WRITE,
                false
            )
        );
    }
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::particleDecomposition::particleDecomposition(const fvMesh& mesh)
:
    particle_(identity(mesh.nCells())),
    nParticles_(returnReduce(mesh.nCells(), sumOp<label>()))
{
    if (!Pstream::parRun())
    {
        return;
    }

    const labelList cells(readAddressing(mesh, "cellProcAddressing"));
    const labelList faces(readAddressing(mesh, "faceProcAddressing"));
    const bool fits =
        cells.size() == mesh.nCells() && faces.size() == mesh.nFaces();

    if (!returnReduce(fits, andOp<bool>()))
    {
        const globalIndex numbers(mesh.nCells());
        for (label& i : particle_)
        {
            i = numbers.toGlobal(i);
        }
        return;
    }

    particle_ = cells;
    face_ = faces;

    const globalIndex onMaster(Pstream::master() ? nParticles_ : 0);
    List<Map<label>> compact;
    slot_ = particle_;
    map_.reset(new mapDistribute(onMaster, slot_, compact));
}


// ************************************************************************* //
