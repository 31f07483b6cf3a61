/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particlePolyMesh.H"
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
        return dictionary(IStringStream(os.str())());
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::particlePolyMesh::addPatches()
{
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        patches_.push_back({pp.name(), entries(pp), {}, {}, {}, {}});

        if (isA<cyclicPolyPatch>(pp))
        {
            // Found from the faces: those given have the digits of a file
            patches_.back().dict.set("transform", "unknown");
        }

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
                    emptyPatches_.append(pp.index());
                }
            }
        }
    }
}


Foam::label Foam::SPH::particlePolyMesh::cyclicPatch(const labelList& periods)
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


void Foam::SPH::particlePolyMesh::addPolygon
(
    const point& centre,
    const vector& area
)
{
    // Along an empty direction, but not that of an empty face
    for (const vector& side : emptySides_)
    {
        if (mag(area & side) < 0.5*mag(area))
        {
            const vector edge((mesh_.bounds().span() & side)*side);
            polygons_.addRectangle(centre, area, edge);
            return;
        }
    }
    polygons_.addTriangle(centre, area);
}


bool Foam::SPH::particlePolyMesh::kept
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


void Foam::SPH::particlePolyMesh::addPairs()
{
    const List<labelList> combinations(imagePeriods(translations_.size()));

    const auto append = [&]
    (
        const labelList& periods,
        const label i,
        const vector& Sf,
        const point& Cf
    )
    {
        patchFaces& faces = patches_[cyclicPatch(periods)];
        faces.owner.append(i);
        faces.face.append(-1);
        faces.Sf.append(Sf);
        faces.Cf.append(Cf);
    };

    DynamicList<label> owner(data_.owner.size());
    DynamicList<label> neighbour(data_.owner.size());

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
            addPolygon(atI, A);
            continue;
        }

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
                break;
            }
        }
    }

    owner_.transfer(owner);
    neighbour_.transfer(neighbour);
}


void Foam::SPH::particlePolyMesh::addBoundaryFaces()
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


void Foam::SPH::particlePolyMesh::emptyFaces
(
    scalarField& scale,
    vectorField& shift
) const
{
    const label n = data_.points.size();
    const label nEmpty = emptySides_.size();
    const scalar m = 0.5*nEmpty;

    // Sums over the other faces of each particle
    scalarField nFaces(n, Zero);
    vectorField sumR(n, Zero);
    vectorField sumA(n, Zero);
    scalarField sumAR(n, Zero);
    vectorField sumARR(n, Zero);
    tensorField sumAoR(n, Zero);

    const auto add = [&](const label i, const vector& A, const vector& r)
    {
        nFaces[i] += 1;
        sumR[i] += r;
        sumA[i] += A;
        sumAR[i] += A & r;
        sumARR[i] += (A & r)*r;
        sumAoR[i] += A*r;
    };

    forAll(data_.owner, pairi)
    {
        const label i = data_.owner[pairi];
        if (!kept(i, data_.Sf[pairi]))
        {
            continue;
        }
        const vector half(0.5*data_.delta[pairi]);
        const vector skew
        (
            data_.skew.size() ? data_.skew[pairi] : vector::zero
        );
        add(i, data_.Sf[pairi], half + skew);
        add(data_.neighbour[pairi], -data_.Sf[pairi], skew - half);
    }
    for (const patchFaces& patch : patches_)
    {
        forAll(patch.face, k)
        {
            if (!patch.dict.found("neighbourPatch"))
            {
                const label i = patch.owner[k];
                add(i, patch.Sf[k], patch.Cf[k] - data_.points[i]);
            }
        }
    }

    // The formulae of primitiveMesh for estimated centre e, volume and centre
    constexpr label maxIterations = 200;
    scale.setSize(n);
    shift.setSize(n);
    forAll(scale, i)
    {
        const scalar V = data_.V[i];
        vector s(Zero);
        scalar f = 1;
        for (label iter = 0; iter < maxIterations; ++iter)
        {
            const vector e((sumR[i] + nEmpty*s)/(nFaces[i] + nEmpty));
            const scalar volume3 = sumAR[i] - (sumA[i] & e);
            const vector moment
            (
                0.75*(sumARR[i] - (e & sumAoR[i])) + 0.25*volume3*e
            );
            f = (3*V - volume3)/(m*V);
            const vector next(-(moment/(0.75*m*f*V) + e/3));
            const scalar change = mag(next - s);
            s = next;
            if (change < 1e-16*data_.spacing[i])
            {
                break;
            }
        }
        scale[i] = f;
        shift[i] = s;
    }
}


void Foam::SPH::particlePolyMesh::addEmptyFaces()
{
    if (emptySides_.empty())
    {
        return;
    }

    scalarField scale;
    vectorField shift;
    emptyFaces(scale, shift);

    const vector span(mesh_.bounds().span());
    forAll(emptySides_, k)
    {
        patchFaces& patch = patches_[emptyPatches_[k]];
        const vector& side = emptySides_[k];
        const scalar extent = mag(span & side);

        forAll(scale, i)
        {
            patch.owner.append(i);
            patch.face.append(-1);
            patch.Sf.append(scale[i]*data_.V[i]/extent*side);
            patch.Cf.append
            (
                data_.points[i] + shift[i] + 0.5*extent*side
            );
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::particlePolyMesh::particlePolyMesh
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

    const bool is3D = space.nDims() == 3;
    const label nFaces =
        data.owner.size() + data.boundary.owner.size()
      + emptySides_.size()*data.points.size();
    polygons_.reserve(nFaces, is3D ? 3*nFaces : 4*nFaces);

    addPairs();
    addBoundaryFaces();
    addEmptyFaces();

    // Owners of internal faces, then of the patches
    DynamicList<label> owner(nFaces);
    owner.append(owner_);
    for (patchFaces& patch : patches_)
    {
        patch.dict.set("nFaces", patch.owner.size());
        patch.dict.set("startFace", polygons_.size());
        owner.append(patch.owner);

        forAll(patch.owner, k)
        {
            addPolygon(patch.Cf[k], patch.Sf[k]);
        }
    }
    owner_.transfer(owner);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::SPH::particlePolyMesh::nearestFaces
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


Foam::autoPtr<Foam::polyMesh> Foam::SPH::particlePolyMesh::makeMesh
(
    const Time& time,
    const word& region
)
{
    autoPtr<polyMesh> meshPtr
    (
        new polyMesh
        (
            IOobject
            (
                region,
                time.constant(),
                time,
                IOobject::NO_READ,
                IOobject::AUTO_WRITE
            ),
            polygons_.movePoints(),
            polygons_.moveFaces(),
            std::move(owner_),
            std::move(neighbour_)
        )
    );

    List<polyPatch*> patches(patches_.size());
    forAll(patches, patchi)
    {
        patches[patchi] = polyPatch::New
        (
            patches_[patchi].name,
            patches_[patchi].dict,
            patchi,
            meshPtr->boundaryMesh()
        ).ptr();
    }
    meshPtr->addPatches(patches);

    return meshPtr;
}


Foam::labelList Foam::SPH::particlePolyMesh::boundaryFace() const
{
    DynamicList<label> faces;
    for (const patchFaces& patch : patches_)
    {
        faces.append(patch.face);
    }
    return labelList(std::move(faces));
}


// ************************************************************************* //
