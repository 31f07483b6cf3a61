/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleFaces.H"
#include "cellGrid.H"
#include "periodicImages.H"
#include "cyclicPolyPatch.H"
#include "emptyPolyPatch.H"
#include "StringStream.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Areas below this over dp^(d-1) are round-off
    static const scalar leastArea = 1e-12;

    //- Edges below this over the largest coordinate would lose their direction
    static const scalar leastEdge = 2e-15;
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Entries of a patch in the file boundary
    static dictionary entries(const polyPatch& pp)
    {
        OStringStream os;
        os.precision(17);
        pp.write(os);
        dictionary dict(IStringStream(os.str())());

        if (isA<cyclicPolyPatch>(pp))
        {
            // Found from the faces: those given have the digits of a file
            dict.set("transform", "unknown");
        }
        return dict;
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::particleFaces::addPatches()
{
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        patches_.push_back({pp.name(), entries(pp), {}, {}, {}, {}});

        const vectorField n(pp.faceNormals());
        for (label d = space_.nDims(); isA<emptyPolyPatch>(pp) && d < 3; ++d)
        {
            for (const scalar sign : {-1, 1})
            {
                vector side(Zero);
                side[space_.axis(d)] = sign;

                const bool here = n.size() && max(n & side) > 0.5;
                if (here && !emptySides_.found(side))
                {
                    emptySides_.append(side);
                    emptyEdges_.append((mesh_.bounds().span() & side)*side);
                    emptyPatches_.append(pp.index());
                }
            }
        }
    }
}


Foam::label Foam::SPH::particleFaces::cyclicPatch(const labelList& periods)
{
    // Names of this side and of the other
    word name;
    word otherName;
    label nCrossed = 0;

    label k = 0;
    for (const label patchi : periodicPatches_)
    {
        const auto& cyclic =
            refCast<const cyclicPolyPatch>(mesh_.boundaryMesh()[patchi]);

        if (periods[k] != 0)
        {
            const bool ownerSide = periods[k] < 0;
            const word separator(nCrossed ? "_" : "");
            const word& nbr = cyclic.neighbPatchName();

            name += separator + (ownerSide ? cyclic.name() : nbr);
            otherName += separator + (ownerSide ? nbr : cyclic.name());
            ++nCrossed;
        }
        ++k;
    }

    for (label patchi = 0; patchi < label(patches_.size()); ++patchi)
    {
        if (patches_[patchi].name == name)
        {
            return patchi;
        }
    }

    // A pair of patches for pairs across several periods
    for (const bool first : {true, false})
    {
        dictionary dict;
        dict.add("type", "cyclic");
        dict.add("inGroups", wordList({"cyclic", cornerGroup}));
        dict.add("nFaces", 0);
        dict.add("startFace", 0);
        dict.add("transform", "unknown");
        dict.add("neighbourPatch", first ? otherName : name);
        patches_.push_back({first ? name : otherName, dict, {}, {}, {}, {}});
    }

    return patches_.size() - 2;
}


bool Foam::SPH::particleFaces::kept
(
    const label particlei,
    const vector& area
) const
{
    const label d = space_.nDims();
    const scalar size = mag(area)/space_.thickness();
    const scalar edge = d == 3 ? sqrt(size) : size;

    return
        size
      > leastArea*data_.V[particlei]
       /(space_.thickness()*data_.spacing[particlei])
     && (d == 1 || edge > leastEdge*extent_);
}


void Foam::SPH::particleFaces::addPairs()
{
    const List<labelList> combinations(imagePeriods(translations_.size()));

    const auto append = [&]
    (
        const labelList& periods,
        const label i,
        const vector& A,
        const point& x
    )
    {
        patchFaces& faces = patches_[cyclicPatch(periods)];
        faces.owner.append(i);
        faces.face.append(-1);
        faces.Sf.append(A);
        faces.Cf.append(x);
    };

    DynamicList<label> owner(data_.owner.size());
    DynamicList<label> neighbour(data_.owner.size());
    DynamicList<vector> Sf(data_.owner.size());
    DynamicList<point> Cf(data_.owner.size());

    forAll(data_.owner, pairi)
    {
        const label i = data_.owner[pairi];
        const label j = data_.neighbour[pairi];
        const vector& A = data_.Sf[pairi];

        if (!kept(i, A))
        {
            continue;
        }

        vector toFace(0.5*data_.delta[pairi]);
        vector fromFace(toFace);
        if (data_.skew.size())
        {
            toFace += data_.skew[pairi];
            fromFace -= data_.skew[pairi];
        }
        const point atI(data_.points[i] + toFace);
        const point atJ(data_.points[j] - fromFace);

        if (mag(atI - atJ) < 1e-3*data_.spacing[i])
        {
            owner.append(i);
            neighbour.append(j);
            Sf.append(A);
            Cf.append(atI);
            continue;
        }

        bool found = false;
        for (const labelList& periods : combinations)
        {
            vector offset(Zero);
            labelList opposite(periods);
            label first = 0;
            forAll(periods, k)
            {
                offset += scalar(periods[k])*translations_[k];
                opposite[k] = -periods[k];
                first = first ? first : periods[k];
            }

            if (mag(atI - atJ - offset) < 1e-3*data_.spacing[i])
            {
                // The patch first made is that of the owner side
                if (first < 0)
                {
                    append(periods, i, A, atI);
                    append(opposite, j, -A, atJ);
                }
                else
                {
                    append(opposite, j, -A, atJ);
                    append(periods, i, A, atI);
                }
                found = true;
                break;
            }
        }

        if (!found)
        {
            FatalErrorInFunction
                << "The particles at " << data_.points[i] << " and "
                << data_.points[j] << " are " << atI - atJ
                << " apart at their face, which no period of the mesh is: "
                << translations_ << exit(FatalError);
        }
    }

    owner_.transfer(owner);
    neighbour_.transfer(neighbour);
    Sf_.transfer(Sf);
    Cf_.transfer(Cf);
}


void Foam::SPH::particleFaces::addBoundaryFaces()
{
    const boundaryFaces& faces = data_.boundary;

    for (label patchi = 0; patchi + 1 < faces.start.size(); ++patchi)
    {
        patchFaces& patch = patches_[patchi];
        for (label s = faces.start[patchi]; s < faces.start[patchi + 1]; ++s)
        {
            const label i = faces.owner[s];
            if (kept(i, faces.Sf[s]))
            {
                patch.owner.append(i);
                patch.face.append(faces.face[s]);
                patch.Sf.append(faces.Sf[s]);
                patch.Cf.append(faces.Cf[s]);
            }
        }
    }

    // Faces of cyclic patches come from the nearest one
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        patchFaces& patch = patches_[pp.index()];
        if (pp.coupled() && pp.size())
        {
            patch.face = nearestFaces(pp, patch.Cf);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::particleFaces::particleFaces
(
    const fvMesh& mesh,
    const solutionSpace& space,
    const particleMeshData& data
)
:
    mesh_(mesh),
    space_(space),
    data_(data),
    extent_
    (
        max
        (
            cmptMax(cmptMag(mesh.bounds().min())),
            cmptMax(cmptMag(mesh.bounds().max()))
        )
    ),
    periodicPatches_(periodicPatches(mesh)),
    translations_(periodicTranslations(mesh))
{
    addPatches();
    addPairs();
    addBoundaryFaces();
    addEmptyFaces();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::SPH::particleFaces::nearestFaces
(
    const polyPatch& pp,
    const UList<point>& points
)
{
    const scalar size = sqrt(average(mag(pp.faceAreas())()));
    const cellGrid grid(pp.faceCentres(), 2*size);

    labelList faces(points.size());
    forAll(faces, k)
    {
        faces[k] = grid.nearest(pp.faceCentres(), points[k], size);
    }
    return faces;
}


// ************************************************************************* //
