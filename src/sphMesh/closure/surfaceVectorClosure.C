/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "surfaceVectorClosure.H"
#include "particleMoments.H"
#include "addToRunTimeSelectionTable.H"
#include "ListOps.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    defineTypeNameAndDebug(surfaceVectorClosure, 0);
    addToRunTimeSelectionTable(closure, surfaceVectorClosure, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::surfaceVectorClosure::surfaceVectorClosure(const dictionary& dict)
:
    threshold_(dict.lookupOrDefault<scalar>("threshold", 0.75))
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
    const kernel&,
    const signedDistance& fluid,
    particleMeshData& data
) const
{
    const vectorField residual(areaSums(data));
    const scalarField divergence(tr(firstMoments(data))/data.V);

    struct face
    {
        label owner;
        signedDistance::nearest nearest;
    };

    List<DynamicList<face>> patchFaces(mesh.boundary().size());
    forAll(data.points, i)
    {
        if (divergence[i] < threshold_*space.nDims())
        {
            const signedDistance::nearest n(fluid.find(data.points[i]));
            if (n.patchi >= 0)
            {
                patchFaces[n.patchi].append({i, n});
            }
        }
    }

    boundaryFaces& boundary = data.boundary;
    DynamicList<label> owner, local;
    DynamicList<vector> Sf, Cf;
    DynamicList<scalar> distance;

    boundary.start = labelList(patchFaces.size() + 1, Zero);
    forAll(patchFaces, patchi)
    {
        for (const face& f : patchFaces[patchi])
        {
            owner.append(f.owner);
            Sf.append(-residual[f.owner]);
            Cf.append(f.nearest.hit);
            distance.append(mag(f.nearest.distance));
            local.append(f.nearest.facei);
        }
        boundary.start[patchi + 1] = owner.size();
    }

    boundary.owner.transfer(owner);
    boundary.Sf.transfer(Sf);
    boundary.Cf.transfer(Cf);
    boundary.distance.transfer(distance);
    boundary.face.transfer(local);
}


// ************************************************************************* //
