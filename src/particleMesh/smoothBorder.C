/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "smoothBorder.H"
#include "emptyPolyPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Cosine of the angle between two faces below which an edge is acute:
    //- 80 degrees
    static const scalar acuteEdge = 0.17;

    //- Part of the surface of a cell that has to be border; less than that of
    //- two faces of a hexahedron in a layer, whatever their round-off
    static const scalar mostOfSurface = 0.5001;

    //- Sweeps over the mesh; borders are at rest after a few
    static const label maxSweeps = 20;

    //- Do two of the faces of a cell meet at an acute edge inside it
    static bool acute(const polyMesh& mesh, const label celli)
    {
        const cell& faces = mesh.cells()[celli];
        const auto outward = [&](const label facei)
        {
            return
                normalised(mesh.faceAreas()[facei])
               *(mesh.faceOwner()[facei] == celli ? 1 : -1);
        };

        forAll(faces, a)
        {
            for (label b = a + 1; b < faces.size(); ++b)
            {
                label nCommon = 0;
                for (const label v : mesh.faces()[faces[a]])
                {
                    nCommon += mesh.faces()[faces[b]].found(v);
                }
                if
                (
                    nCommon > 1
                 && (outward(faces[a]) & outward(faces[b])) < -acuteEdge
                )
                {
                    return true;
                }
            }
        }

        return false;
    }

    //- Does a cell stick out of its side of the border. Those at coupled
    //- patches do not, as their neighbours there would have to follow
    static bool sticksOut
    (
        const polyMesh& mesh,
        const boolList& inside,
        const label celli
    )
    {
        scalar area = 0;
        scalar surface = 0;

        for (const label facei : mesh.cells()[celli])
        {
            const scalar A = mag(mesh.faceAreas()[facei]);

            if (!mesh.isInternalFace(facei))
            {
                const polyPatch& pp = mesh.boundaryMesh()
                    [mesh.boundaryMesh().whichPatch(facei)];
                if (pp.coupled())
                {
                    return false;
                }
                surface += isA<emptyPolyPatch>(pp) ? 0 : A;
                continue;
            }

            surface += A;
            if
            (
                inside[mesh.faceOwner()[facei]]
             != inside[mesh.faceNeighbour()[facei]]
            )
            {
                area += A;
            }
        }

        return area > mostOfSurface*surface && acute(mesh, celli);
    }
}
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::SPH::smoothBorder(const polyMesh& mesh, boolList& inside)
{
    const boolList chosen(inside);

    bool changed = true;
    for (label sweep = 0; changed && sweep < maxSweeps; ++sweep)
    {
        changed = false;
        forAll(inside, celli)
        {
            if (sticksOut(mesh, inside, celli))
            {
                inside[celli] = !inside[celli];
                changed = true;
            }
        }
    }

    label nLeft = 0;
    label nJoined = 0;
    forAll(inside, celli)
    {
        nLeft += chosen[celli] && !inside[celli];
        nJoined += !chosen[celli] && inside[celli];
    }
    if (nLeft || nJoined)
    {
        Info<< "Zone: " << nLeft << " cells leave and " << nJoined
            << " cells join it, where its border had acute edges" << endl;
    }
}


// ************************************************************************* //
