/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "treatedParticleMesh.H"
#include "contactFaces.H"
#include "flowSolver.H"
#include "patchSurface.H"
#include "solidParticles.H"
#include "surfaceDistance.H"
#include "surfaceVectorClosure.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    static autoPtr<sphMesh> contactParticleMesh
    (
        const autoPtr<sphMesh>& stored,
        const dictionary& schemes
    )
    {
        const fvMesh& mesh = stored->mesh();

        const dictionary closure
        (
            stored->properties().subOrEmptyDict("closure")
        );
        if
        (
            closure.getOrDefault<word>("type", "consistent")
         != surfaceVectorClosure::typeName
        )
        {
            FatalIOErrorInFunction(schemes)
                << "boundaryTreatment contact needs pair areas without"
                << " correction: set 'closure {type surfaceVector;}' in"
                << " system/sphMeshDict and run sphMesh"
                << exit(FatalIOError);
        }

        const List<particleSet> solids(readSolidParticles(mesh));
        if (solids.empty())
        {
            FatalIOErrorInFunction(schemes)
                << "boundaryTreatment contact needs particles of solid"
                << " bodies, and there are none in "
                << sphMesh::directory(mesh) << ". Bodies are closed wall"
                << " patches, or those of the entry 'bodies' in"
                << " system/sphMeshDict" << exit(FatalIOError);
        }

        const scalar reach = stored->W().support(max(stored->spacing()));
        const surfaceDistance fluid
        (
            patchSurface(mesh, stored->space()), reach
        );

        particleMeshData data(stored->data());
        data.boundary = contactFaces(*stored, solids, fluid);

        return autoPtr<sphMesh>
        (
            new sphMesh(mesh, stored->properties(), std::move(data))
        );
    }
}
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::autoPtr<Foam::SPH::sphMesh> Foam::SPH::treatedParticleMesh
(
    const fvMesh& mesh
)
{
    const IOdictionary schemes(flowSolver::schemesIO(mesh.time()));
    const word treatment
    (
        schemes.getOrDefault<word>("boundaryTreatment", "surfaceVector")
    );
    const wordList choices({"contact", "surfaceVector"});

    if (!choices.found(treatment))
    {
        FatalIOErrorInFunction(schemes)
            << "Unknown boundaryTreatment " << treatment << nl << nl
            << "Valid choices:" << nl << choices << exit(FatalIOError);
    }

    autoPtr<sphMesh> stored(new sphMesh(mesh));

    return
        treatment == "contact"
      ? contactParticleMesh(stored, schemes)
      : std::move(stored);
}


// ************************************************************************* //
