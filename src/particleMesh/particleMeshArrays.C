/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    The arrays of a particle mesh from the geometry of an fvMesh.

\*---------------------------------------------------------------------------*/

#include "particleMesh.H"
#include "cellSpacing.H"
#include "cutPairs.H"
#include "particleFiles.H"
#include "periodicPatches.H"
#include "cyclicPolyPatch.H"
#include "emptyPolyPatch.H"
#include "processorPolyPatch.H"
#include "scalarIOField.H"
#include "vectorIOField.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Least distance of a particle to its boundary face over the spacing
    static const scalar smallestDistance = 0.05;

    template<class List>
    static void sortBy(List& values, const labelUList& order)
    {
        values =
            List(UIndirectList<typename List::value_type>(values, order));
    }

    //- Pairs i, j with the vectors from both centres to the face's centre
    class pairAppender
    {
        particleMeshData& data_;
        const bool twoD_[3];
        labelList face_;
        boolList reversed_;
        label nPairs_ = 0;

    public:

        pairAppender
        (
            particleMeshData& data,
            const solutionSpace& space,
            const label nMost
        )
        :
            data_(data),
            twoD_
            {
                space.identity().xx() < 0.5,
                space.identity().yy() < 0.5,
                space.identity().zz() < 0.5
            },
            face_(nMost),
            reversed_(nMost, false)
        {
            data_.owner.setSize(nMost);
            data_.neighbour.setSize(nMost);
            data_.Sf.setSize(nMost);
            data_.delta.setSize(nMost);
            data_.skew.setSize(nMost);
        }

        //- The pairs are complete
        void finish()
        {
            data_.owner.setSize(nPairs_);
            data_.neighbour.setSize(nPairs_);
            data_.Sf.setSize(nPairs_);
            data_.delta.setSize(nPairs_);
            data_.skew.setSize(nPairs_);

            if (Pstream::parRun())
            {
                // Every sum over pairs goes in the order of the whole case
                face_.setSize(nPairs_);
                reversed_.setSize(nPairs_);
                const labelList order(sortedOrder(face_));
                sortBy(data_.owner, order);
                sortBy(data_.neighbour, order);
                sortBy(data_.Sf, order);
                sortBy(data_.delta, order);
                sortBy(data_.skew, order);
                sortBy(reversed_, order);
                data_.reversed = bitSet(reversed_);
            }
        }

        //- Append a pair whose face has a number in the whole case
        void append
        (
            const label i,
            const label j,
            const label face,
            const bool reversed,
            const vector& Sf,
            const vector& fromI,
            const vector& fromJ
        )
        {
            // What leaves a cell on one side of a period enters on the other
            if (i == j)
            {
                return;
            }

            vector delta(fromI - fromJ);
            vector skew(0.5*(fromI + fromJ));
            for (direction d = 0; d < 3; ++d)
            {
                if (twoD_[d])
                {
                    delta[d] = 0;
                    skew[d] = 0;
                }
            }

            const bool ordered = i < j;
            data_.owner[nPairs_] = ordered ? i : j;
            data_.neighbour[nPairs_] = ordered ? j : i;
            data_.Sf[nPairs_] = ordered ? Sf : -Sf;
            data_.delta[nPairs_] = ordered ? delta : -delta;
            data_.skew[nPairs_] = skew;
            face_[nPairs_] = face;
            reversed_[nPairs_] = reversed;
            ++nPairs_;
        }
    };

    //- An array of constant/sphMesh, or what the mesh itself says
    template<class Container>
    static void readIfStored
    (
        const fvMesh& mesh,
        const particleDecomposition& division,
        const word& name,
        Field<typename Container::value_type>& values
    )
    {
        Field<typename Container::value_type> stored;
        const particleFiles files(mesh.time());
        const bool found =
            Pstream::master() && files.readArray<Container>(name, stored);

        if (found && stored.size() != division.nParticles())
        {
            FatalErrorInFunction
                << "File " << files.arrayPath(name) << " has "
                << stored.size() << " values for " << division.nParticles()
                << " particles. Generate the particles anew with sphMesh"
                << " -overwrite"
                << (Pstream::parRun() ? ", then decompose them" : "")
                << exit(FatalError);
        }
        if (found && !division.known())
        {
            FatalErrorInFunction
                << "There is no cellProcAddressing or faceProcAddressing of"
                << " this mesh in "
                << mesh.time().path()/mesh.facesInstance()
                  /polyMesh::meshSubDir
                << ". Divide the particles with 'decomposePar -case sph'"
                << exit(FatalError);
        }
        if (returnReduce(found, orOp<bool>()))
        {
            division.distribute(stored);
            values = stored;
        }
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::SPH::particleMeshData Foam::SPH::particleMesh::arrays
(
    const fvMesh& mesh,
    const solutionSpace& space
)
{
    const vectorField& Sf = mesh.faceAreas();
    const pointField& Cf = mesh.faceCentres();

    const particleDecomposition division(mesh);

    particleMeshData data;
    data.points = mesh.cellCentres();
    data.V = mesh.cellVolumes();
    data.spacing = cellSpacing(space, mesh);
    readIfStored<vectorIOField>(mesh, division, "points", data.points);
    readIfStored<scalarIOField>(mesh, division, "V", data.V);
    readIfStored<scalarIOField>(mesh, division, "spacing", data.spacing);

    const pointField& C = data.points;
    boundaryFaces& boundary = data.boundary;
    boundary.start = labelList(mesh.boundary().size() + 1, Zero);

    pairAppender pairs(data, space, mesh.nFaces());
    for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
    {
        const label i = mesh.faceOwner()[facei];
        const label j = mesh.faceNeighbour()[facei];
        pairs.append
        (
            i,
            j,
            division.face(facei),
            false,
            Sf[facei],
            Cf[facei] - C[i],
            Cf[facei] - C[j]
        );
    }

    DynamicList<label> faces(mesh.nFaces() - mesh.nInternalFaces());
    DynamicList<label> local(faces.capacity());
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (!(Pstream::parRun() && isA<processorPolyPatch>(pp)))
        {
            checkCoupling(pp);
        }
        if (const auto* cyclic = isA<cyclicPolyPatch>(pp))
        {
            const cyclicPolyPatch& other = cyclic->neighbPatch();
            for (label k = 0; cyclic->owner() && k < pp.size(); ++k)
            {
                const label i = pp.faceCells()[k];
                const label j = other.faceCells()[k];
                pairs.append
                (
                    i,
                    j,
                    division.face(pp.start() + k),
                    false,
                    Sf[pp.start() + k],
                    Cf[pp.start() + k] - C[i],
                    Cf[other.start() + k] - C[j]
                );
            }
        }
        else if (!pp.coupled() && !isA<emptyPolyPatch>(pp))
        {
            forAll(pp, k)
            {
                faces.append(pp.start() + k);
                local.append(k);
            }
        }
        boundary.start[pp.index() + 1] = faces.size();
    }

    if (Pstream::parRun())
    {
        const cutPairs cut(mesh, C, division);
        for (const cutPairs::pair& p : cut.pairs())
        {
            pairs.append
            (
                p.i, p.j, p.face, p.reversed, p.Sf, p.fromI, p.fromJ
            );
        }
        data.halo = cut.halo();
    }
    pairs.finish();

    boundary.face.transfer(local);
    boundary.owner = labelList(mesh.faceOwner(), faces);
    boundary.Sf = vectorField(Sf, faces);
    boundary.Cf = pointField(Cf, faces);
    boundary.distance.setSize(faces.size());
    forAll(faces, s)
    {
        const label i = boundary.owner[s];
        const vector n(boundary.Sf[s]/max(mag(boundary.Sf[s]), VSMALL));
        boundary.distance[s] = max
        (
            n & (boundary.Cf[s] - C[i]), smallestDistance*data.spacing[i]
        );
    }

    return data;
}


// ************************************************************************* //
