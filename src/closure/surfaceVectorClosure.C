/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "surfaceVectorClosure.H"
#include "boundaryFaceList.H"
#include "particleMoments.H"
#include "addToRunTimeSelectionTable.H"
#include "ListOps.H"
#include "symmetryPlanePolyPatch.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    defineTypeNameAndDebug(surfaceVectorClosure, 0);
    addToRunTimeSelectionTable(closure, surfaceVectorClosure, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::DynamicList<Foam::SPH::surfaceVectorClosure::part>
Foam::SPH::surfaceVectorClosure::split
(
    const label particlei,
    const point& p,
    const vector& A,
    const scalar radius,
    const signedDistance& fluid
) const
{
    // Sides whose normals are nearer to each other are one wall
    const scalar sameSide = 0.7;

    // Least part of a vector for a side of its own
    const scalar leastPart = 0.05;

    DynamicList<part> parts;
    parts.append({particlei, fluid.find(p), A});
    if (!splitCorners_)
    {
        return parts;
    }

    const vector n(parts[0].face.normal);
    const vector across(A - (A & n)*n);
    const scalar magAcross = mag(across);
    if (magAcross < leastPart*mag(A))
    {
        return parts;
    }

    // The nearest face from a point that far towards the other side
    const vector e(across/magAcross);
    const signedDistance::nearest other(fluid.find(p + radius*e));
    const scalar along = other.normal & n;
    const scalar outwards = other.normal & e;
    if (other.patchi < 0 || along > sameSide || outwards < sameSide)
    {
        return parts;
    }

    const vector Sf((magAcross/outwards)*other.normal);
    parts[0].Sf -= Sf;
    parts.append({particlei, other, Sf});

    return parts;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::surfaceVectorClosure::surfaceVectorClosure(const dictionary& dict)
:
    threshold_(dict.lookupOrDefault<scalar>("threshold", 0.75)),
    splitCorners_(dict.lookupOrDefault<bool>("splitCorners", false))
{
    if (threshold_ <= 0 || threshold_ >= 1)
    {
        FatalIOErrorInFunction(dict)
            << "threshold " << threshold_ << " is outside the range 0 to 1"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::surfaceVectorClosure::close
(
    const fvMesh& mesh,
    const solutionSpace& space,
    const kernel& W,
    const signedDistance& fluid,
    particleMeshData& data
) const
{
    const vectorField residual(areaSums(data));
    const scalarField divergence(tr(firstMoments(data))/data.V);

    List<DynamicList<part>> patchFaces(mesh.boundary().size());
    forAll(data.points, i)
    {
        if (divergence[i] < threshold_*space.nDims())
        {
            const DynamicList<part> parts
            (
                split
                (
                    i,
                    data.points[i],
                    -residual[i],
                    W.support(data.spacing[i]),
                    fluid
                )
            );
            for (const part& side : parts)
            {
                if (side.face.patchi >= 0)
                {
                    patchFaces[side.face.patchi].append(side);
                }
            }
        }
    }

    boundaryFaceList faces;
    forAll(patchFaces, patchi)
    {
        // OpenFOAM's symmetry planes have one normal
        const auto* plane =
            isA<symmetryPlanePolyPatch>(mesh.boundaryMesh()[patchi]);
        for (const part& side : patchFaces[patchi])
        {
            const vector r(side.face.hit - data.points[side.owner]);
            const vector n(plane ? plane->n() : side.face.normal);
            faces.append
            (
                side.owner,
                plane ? vector((side.Sf & n)*n) : side.Sf,
                side.face.hit,
                mag(r & n),
                side.face.facei
            );
        }
        faces.endPatch();
    }

    data.boundary = faces.faces();
}


// ************************************************************************* //
