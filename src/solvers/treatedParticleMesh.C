/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "treatedParticleMesh.H"
#include "checkEntries.H"
#include "contactBoundary.H"
#include "sphSchemes.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::autoPtr<Foam::SPH::particleMesh> Foam::SPH::treatedParticleMesh
(
    const fvMesh& mesh
)
{
    const sphSchemes schemes(mesh.time());
    const word treatment
    (
        checkedWord
        (
            schemes,
            "boundaryTreatment",
            "surfaceVector",
            {"contact", "surfaceVector"}
        )
    );

    if (treatment == "contact" && Pstream::parRun())
    {
        FatalErrorInFunction
            << schemes.objectPath() << ": boundaryTreatment contact runs on"
            << " one rank, with threads (OMP_NUM_THREADS), because a particle"
            << " may take its wall values from a face of another rank. In"
            << " parallel, choose surfaceVector"
            << exit(FatalError);
    }

    autoPtr<particleMesh> particles(new particleMesh(mesh));
    if (treatment == "surfaceVector")
    {
        return particles;
    }

    boundaryFaces contact(readContactBoundary(particleFiles(mesh.time())));
    if (contact.owner.empty())
    {
        FatalIOErrorInFunction(schemes)
            << "boundaryTreatment contact needs particles of solid bodies with"
            << " pair areas without correction: set 'closure {type"
            << " surfaceVector;}' in system/sphMeshDict and run sphMesh."
            << " Bodies are closed wall patches, or those of the entry"
            << " 'bodies' there" << exit(FatalIOError);
    }

    // Patches beyond those of the FVM mesh are cyclic
    const label nFaces = contact.start.last();
    contact.start.setSize(mesh.boundary().size() + 1, nFaces);

    particleMeshData data(particles->data());
    data.boundary = std::move(contact);

    return autoPtr<particleMesh>
    (
        new particleMesh(mesh, particles->properties(), std::move(data))
    );
}


// ************************************************************************* //
