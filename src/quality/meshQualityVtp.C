/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "meshQualityVtp.H"
#include "particleVtp.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Write particles [start, start + size) of those of fluid and solids
    static void writeParticles
    (
        const particleMesh& particles,
        const meshQuality& quality,
        const label start,
        const label size,
        particleVtp& file
    )
    {
        const particleSurroundings& all = quality.surroundings();
        const scalarField gradientSum(quality.kernelGradientSum());

        pointField points(size);
        scalarField distance(size);
        vectorField normal(size);
        forAll(points, i)
        {
            points[i] = particles.space().position(all.points()[start + i]);
            distance[i] = quality.nearest()[start + i].distance;
            normal[i] = quality.nearest()[start + i].normal;
        }

        file.add
        (
            "kernelGradientSum",
            SubList<scalar>(gradientSum, size, start)
        );
        file.add("density", SubList<scalar>(all.density(), size, start));
        file.add("body", SubList<label>(all.body(), size, start));
        file.add("signedDistance", distance);
        file.add("normal", normal);
        file.write(points);
    }

    //- Write area vectors at their face centres
    static void writeAreas
    (
        const UList<point>& centres,
        const vectorField& Sf,
        const labelUList& patches,
        particleVtp& file
    )
    {
        const vectorField normal(Sf/(mag(Sf) + VSMALL));

        file.add("Sf", Sf);
        file.add("normal", normal);
        file.add("patch", patches);
        file.write(centres);
    }
}
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::SPH::writeMeshQualityVtp
(
    const fvMesh& mesh,
    const particleMesh& particles,
    const UList<particleSet>& solids,
    const meshQuality& quality,
    const fileName& folder
)
{
    const label nFluid = particles.nParticles();
    {
        particleVtp file(folder/"fluid.vtp");
        file.add("V", particles.V());
        file.add("spacing", particles.spacing());
        writeParticles(particles, quality, 0, nFluid, file);
    }
    if (solids.size())
    {
        particleVtp file(folder/"solid.vtp");
        writeParticles
        (
            particles,
            quality,
            nFluid,
            quality.nearest().size() - nFluid,
            file
        );
    }
    {
        const boundaryFaces& faces = particles.boundary().faces();

        particleVtp file(folder/"surfaceVectors.vtp");
        file.add("owner", faces.owner);
        file.add("distance", faces.distance);
        writeAreas
        (
            faces.Cf,
            faces.Sf,
            particles.boundary().patchIDs(),
            file
        );
    }
    {
        DynamicList<point> centres;
        DynamicList<vector> Sf;
        DynamicList<label> patches;
        for (const fvPatch& patch : mesh.boundary())
        {
            if (!patch.coupled())
            {
                centres.append(patch.Cf());
                Sf.append(patch.Sf());
                patches.append(labelList(patch.size(), patch.index()));
            }
        }

        particleVtp file(folder/"faceVectors.vtp");
        writeAreas(centres, vectorField(Sf), patches, file);
    }
}


// ************************************************************************* //
