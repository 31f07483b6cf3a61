/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "contactFaces.H"
#include "cellGrid.H"
#include "periodicImages.H"
#include "rawPairAreas.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Particles of all solids and their periodic images
    struct solidNeighbours
    {
        //- Local coordinates [m]
        DynamicList<vector> points;

        DynamicList<scalar> spacing;

        //- Wall nearest to each
        DynamicList<signedDistance::nearest> wall;

        solidNeighbours
        (
            const fvMesh& mesh,
            const solutionSpace& space,
            const UList<particleSet>& solids,
            const signedDistance& fluid
        )
        {
            vectorField translations(periodicTranslations(mesh));
            for (vector& T : translations)
            {
                T = space.toLocal(T);
            }
            DynamicList<vector> offsets(1, Zero);
            offsets.append(imageOffsets(translations));

            for (const particleSet& solid : solids)
            {
                forAll(solid.points, j)
                {
                    const vector p(space.toLocal(solid.points[j]));
                    const auto nearest = fluid.find(solid.points[j]);

                    for (const vector& offset : offsets)
                    {
                        points.append(p + offset);
                        spacing.append(solid.spacing[j]);
                        wall.append(nearest);
                    }
                }
            }
        }
    };

    //- A boundary face before the sorting by patches
    struct unsortedFace
    {
        label owner;
        vector Sf;
        point Cf;
        scalar distance;
        label face;
        vector wallNormal;
    };

    //- Append the pairs of all fluid particles with solid ones, by patch
    static void appendPairs
    (
        const fvMesh& mesh,
        const solutionSpace& space,
        const kernel& W,
        const particleMeshData& data,
        const solidNeighbours& solids,
        List<DynamicList<unsortedFace>>& patchFaces
    )
    {
        const scalar largest = solids.spacing.empty() ? 0 : max(solids.spacing);

        PtrList<vectorField> normals(patchFaces.size());
        forAll(normals, patchi)
        {
            normals.set
            (
                patchi,
                new vectorField(mesh.boundary()[patchi].nf())
            );
        }

        const cellGrid grid(solids.points, W.support(largest));

        forAll(data.points, i)
        {
            const scalar dp = data.spacing[i];
            const vector p(space.toLocal(data.points[i]));

            grid.forNear
            (
                p,
                W.support(max(dp, largest)),
                [&](const label j)
                {
                    const vector r(solids.points[j] - p);
                    const label patchi = solids.wall[j].patchi;
                    if
                    (
                        patchi < 0
                     || mag(r) >= W.support(max(dp, solids.spacing[j]))
                    )
                    {
                        return;
                    }

                    // Solid particles fill their spacing as those of the
                    // fluid do
                    const scalar Vi = data.V[i];
                    const scalar Vj =
                        Vi*space.volume(solids.spacing[j])/space.volume(dp);

                    const vector delta(space.toGlobal(r));
                    const vector A
                    (
                        rawPairArea
                        (
                            space, W, Vi, Vj, dp, solids.spacing[j], delta
                        )
                    );
                    if (mag(A) > VSMALL)
                    {
                        const label facei = solids.wall[j].facei;
                        patchFaces[patchi].append
                        ({
                            i,
                            A,
                            data.points[i] + 0.5*delta,
                            0.5*(delta & A)/mag(A),
                            facei,
                            normals[patchi][facei]
                        });
                    }
                }
            );
        }
    }
}
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::SPH::boundaryFaces Foam::SPH::contactFaces
(
    const fvMesh& mesh,
    const solutionSpace& space,
    const kernel& W,
    const particleMeshData& data,
    const UList<particleSet>& solids,
    const signedDistance& fluid
)
{
    const label nPatches = mesh.boundary().size();
    List<DynamicList<unsortedFace>> patchFaces(nPatches);

    const solidNeighbours neighbours(mesh, space, solids, fluid);
    if (neighbours.points.size())
    {
        appendPairs(mesh, space, W, data, neighbours, patchFaces);
    }

    vectorField pairSum(data.points.size(), Zero);
    for (const auto& faces : patchFaces)
    {
        for (const unsortedFace& f : faces)
        {
            pairSum[f.owner] += f.Sf;
        }
    }

    const boundaryFaces& vectors = data.boundary;
    forAll(patchFaces, patchi)
    {
        if (patchFaces[patchi].empty())
        {
            const label end = vectors.start[patchi + 1];
            for (label k = vectors.start[patchi]; k < end; ++k)
            {
                const label i = vectors.owner[k];
                patchFaces[patchi].append
                ({
                    i,
                    vectors.Sf[k] - pairSum[i],
                    vectors.Cf[k],
                    vectors.distance[k],
                    vectors.face[k],
                    Zero
                });
            }
        }
    }

    boundaryFaces boundary;
    boundary.start = labelList(nPatches + 1, Zero);
    forAll(patchFaces, patchi)
    {
        boundary.start[patchi + 1] =
            boundary.start[patchi] + patchFaces[patchi].size();
    }

    const label n = boundary.start.last();
    boundary.owner.setSize(n);
    boundary.Sf.setSize(n);
    boundary.Cf.setSize(n);
    boundary.distance.setSize(n);
    boundary.face.setSize(n);
    boundary.wallNormal.setSize(n);

    label facei = 0;
    for (const auto& faces : patchFaces)
    {
        for (const unsortedFace& f : faces)
        {
            boundary.owner[facei] = f.owner;
            boundary.Sf[facei] = f.Sf;
            boundary.Cf[facei] = f.Cf;
            boundary.distance[facei] = f.distance;
            boundary.face[facei] = f.face;
            boundary.wallNormal[facei++] = f.wallNormal;
        }
    }

    return boundary;
}


// ************************************************************************* //
