/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "contactBoundary.H"
#include "particleFaces.H"
#include "labelIOList.H"
#include "scalarIOField.H"
#include "vectorIOField.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::SPH::writeContactBoundary
(
    const particleFiles& files,
    const polyMesh& particles,
    const boundaryFaces& faces
)
{
    // Patches of the particle mesh beyond those of the FVM mesh are cyclic
    labelList face(faces.owner.size(), -1);
    for (label patchi = 0; patchi + 1 < faces.start.size(); ++patchi)
    {
        const polyPatch& pp = particles.boundaryMesh()[patchi];
        const label start = faces.start[patchi];
        const label size = faces.start[patchi + 1] - start;
        if (size == 0)
        {
            continue;
        }
        if (pp.empty())
        {
            FatalErrorInFunction
                << "Patch " << pp.name() << " has solid particles behind it,"
                << " but no particle at it: reduce the entry spacing of"
                << " sphMeshDict" << exit(FatalError);
        }

        SubList<label>(face, size, start) = particleFaces::nearestFaces
        (
            pp, SubList<point>(faces.Cf, size, start)
        );
    }

    files.writeArray<labelIOList>("contactStart", faces.start);
    files.writeArray<labelIOList>("contactOwner", faces.owner);
    files.writeArray<vectorIOField>("contactSf", faces.Sf);
    files.writeArray<vectorIOField>("contactCf", faces.Cf);
    files.writeArray<scalarIOField>("contactDistance", faces.distance);
    files.writeArray<labelIOList>("contactFace", face);
    files.writeArray<vectorIOField>("contactNormal", faces.wallNormal);
}


Foam::SPH::boundaryFaces Foam::SPH::readContactBoundary
(
    const particleFiles& files
)
{
    boundaryFaces faces;

    if (files.arrayIO("contactOwner").typeHeaderOk<labelIOList>(true))
    {
        faces.start = labelIOList(files.arrayIO("contactStart"));
        faces.owner = labelIOList(files.arrayIO("contactOwner"));
        faces.Sf = vectorIOField(files.arrayIO("contactSf"));
        faces.Cf = vectorIOField(files.arrayIO("contactCf"));
        faces.distance = scalarIOField(files.arrayIO("contactDistance"));
        faces.face = labelIOList(files.arrayIO("contactFace"));
        faces.wallNormal = vectorIOField(files.arrayIO("contactNormal"));
    }

    return faces;
}


// ************************************************************************* //
