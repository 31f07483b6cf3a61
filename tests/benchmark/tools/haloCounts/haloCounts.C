/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Application
    haloCounts

Description
    What ranks would have to tell each other if a mesh were divided among them
    by the method of system/decomposeParDict, without dividing it: for each
    number of ranks a line

        ranks,cellsMin,cellsMax,neighboursMean,neighboursMax,
            facesMean,facesMax,haloMean,haloMax

    of a rank's cells, neighbour ranks, faces that become processor faces, and
    values that it receives in an exchange: each cell on the other side of
    these faces once.

Usage
    \b haloCounts [-case \<case\>] \<ranks\> ..

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "cyclicPolyPatch.H"
#include "decompositionMethod.H"
#include "HashSet.H"
#include "IOdictionary.H"
#include "labelPair.H"
#include "polyMesh.H"
#include "Time.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The two cells of each internal face and of each pair of cyclic faces
List<labelPair> cellPairs(const polyMesh& mesh)
{
    DynamicList<labelPair> pairs;

    forAll(mesh.faceNeighbour(), facei)
    {
        pairs.append
        (
            labelPair(mesh.faceOwner()[facei], mesh.faceNeighbour()[facei])
        );
    }
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const auto* cyclic = isA<cyclicPolyPatch>(patch);
        if (cyclic && cyclic->owner())
        {
            const labelUList& others = cyclic->neighbPatch().faceCells();
            forAll(others, k)
            {
                pairs.append(labelPair(patch.faceCells()[k], others[k]));
            }
        }
    }

    return List<labelPair>(std::move(pairs));
}


scalar mean(const labelUList& values)
{
    return scalar(sum(values))/values.size();
}


void print
(
    const labelUList& rankOf,
    const List<labelPair>& pairs,
    const label nRanks
)
{
    labelList nCells(nRanks, Zero);
    for (const label rank : rankOf)
    {
        ++nCells[rank];
    }

    labelList nFaces(nRanks, Zero);
    List<labelHashSet> neighbours(nRanks);
    List<labelHashSet> halo(nRanks);

    for (const labelPair& pair : pairs)
    {
        const labelPair ranks(rankOf[pair.first()], rankOf[pair.second()]);
        if (ranks.first() != ranks.second())
        {
            for (const label side : {0, 1})
            {
                const label rank = ranks[side];
                ++nFaces[rank];
                neighbours[rank].insert(ranks[1 - side]);
                halo[rank].insert(pair[1 - side]);
            }
        }
    }

    labelList nNeighbours(nRanks);
    labelList nHalo(nRanks);
    for (label rank = 0; rank < nRanks; ++rank)
    {
        nNeighbours[rank] = neighbours[rank].size();
        nHalo[rank] = halo[rank].size();
    }

    Info<< nRanks << ',' << min(nCells) << ',' << max(nCells)
        << ',' << mean(nNeighbours) << ',' << max(nNeighbours)
        << ',' << mean(nFaces) << ',' << max(nFaces)
        << ',' << mean(nHalo) << ',' << max(nHalo) << endl;
}

} // End anonymous namespace

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::noParallel();
    argList::addNote("Count what ranks would have to tell each other");
    argList::noMandatoryArgs();
    argList::addArgument("ranks ..", "Numbers of ranks");
    argList::noCheckProcessorDirectories();

    #include "setRootCase.H"
    #include "createTime.H"

    const polyMesh mesh
    (
        IOobject
        (
            polyMesh::defaultRegion,
            runTime.timeName(),
            runTime,
            IOobject::MUST_READ
        )
    );
    const List<labelPair> pairs(cellPairs(mesh));

    IOdictionary dict
    (
        IOobject
        (
            "decomposeParDict",
            runTime.system(),
            runTime,
            IOobject::MUST_READ
        )
    );

    for (label argi = 1; argi < args.size(); ++argi)
    {
        const label nRanks = args.get<label>(argi);
        dict.set("numberOfSubdomains", nRanks);

        const labelList rankOf
        (
            decompositionMethod::New(dict)->decompose
            (
                mesh, mesh.cellCentres()
            )
        );
        print(rankOf, pairs, nRanks);
    }

    return 0;
}


// ************************************************************************* //
