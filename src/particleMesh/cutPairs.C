/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "cutPairs.H"
#include "globalIndex.H"
#include "processorCyclicPolyPatch.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- What the other side of each coupled boundary face has
    template<class List>
    static List otherSide(const fvMesh& mesh, List values)
    {
        syncTools::swapBoundaryFaceList(mesh, values);
        return values;
    }

    static labelList otherCells(const fvMesh& mesh, const labelUList& values)
    {
        labelList other;
        syncTools::swapBoundaryCellList(mesh, values, other);
        return other;
    }
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::cutPairs::cutPairs
(
    const fvMesh& mesh,
    const pointField& C,
    const particleDecomposition& division
)
{
    const label nInternal = mesh.nInternalFaces();
    const label nBoundary = mesh.nFaces() - nInternal;
    const SubField<vector> Sf(mesh.faceAreas(), nBoundary, nInternal);
    const SubField<vector> Cf(mesh.faceCentres(), nBoundary, nInternal);

    const globalIndex particles(mesh.nCells());
    labelList ids(mesh.nCells());
    forAll(ids, i)
    {
        ids[i] = particles.toGlobal(i);
    }
    const labelList otherId(otherCells(mesh, ids));
    const labelList otherNumber(otherCells(mesh, division.particle()));

    labelList face(nBoundary);
    forAll(face, b)
    {
        face[b] = division.face(nInternal + b);
    }

    const vectorField otherSf(otherSide(mesh, vectorField(Sf)));
    const vectorField otherCf(otherSide(mesh, vectorField(Cf)));
    const labelList otherFace(otherSide(mesh, face));

    vectorField relative(nBoundary, Zero);
    DynamicList<label> boundaryFace(nBoundary);
    DynamicList<pair> pairs(nBoundary);
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (!isA<processorPolyPatch>(pp))
        {
            continue;
        }

        const auto* cyclic = isA<processorCyclicPolyPatch>(pp);
        forAll(pp, k)
        {
            const label b = pp.start() + k - nInternal;

            pair cut;
            cut.i = pp.faceCells()[k];
            cut.j = -1;
            cut.reversed = division.particle()[cut.i] > otherNumber[b];

            const bool own = cyclic ? cyclic->owner() : !cut.reversed;
            cut.Sf = own ? Sf[b] : -otherSf[b];
            cut.face = own ? face[b] : otherFace[b];
            cut.fromI = (own || cyclic ? Cf[b] : otherCf[b]) - C[cut.i];

            relative[b] = cut.fromI;
            boundaryFace.append(b);
            pairs.append(cut);
        }
    }

    const vectorField otherRelative(otherSide(mesh, relative));
    const labelList cutIds(labelUIndList(otherId, boundaryFace));
    labelList elements(labelHashSet(cutIds).sortedToc());
    const labelList haloIds(elements);
    List<Map<label>> compact;
    halo_ = mapDistribute(particles, elements, compact);

    Map<label> slot(2*elements.size());
    forAll(elements, k)
    {
        slot.insert(haloIds[k], elements[k]);
    }
    forAll(pairs, k)
    {
        pairs[k].j = slot[cutIds[k]];
        pairs[k].fromJ = otherRelative[boundaryFace[k]];
    }
    pairs_.transfer(pairs);
}


// ************************************************************************* //
