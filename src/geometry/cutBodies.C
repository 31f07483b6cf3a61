/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "cutBodies.H"
#include "cellSpacing.H"
#include "fileSurface.H"
#include "fluidRegion.H"
#include "meshSearch.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
namespace
{

//- Cells between a body and the border of its zone by default: the layers that
//- closure moves on both sides, and room for a spacing that doubles
const scalar layers = 8;

//- Distances below this over the size of a body are none
const scalar tolerance = 1e-4;


//- A box, with directions that are not solved unbounded
boundBox solvedBox(const solutionSpace& space, const boundBox& box)
{
    boundBox solved(boundBox::greatBox);
    for (label d = 0; d < space.nDims(); ++d)
    {
        const direction axis = space.axis(d);
        solved.min()[axis] = box.min()[axis];
        solved.max()[axis] = box.max()[axis];
    }
    return solved;
}


//- A point of one surface that is in the other, or nearer to it than the
//- tolerance; false if there is none
bool touches
(
    const orientedSurface& surface,
    const surfaceDistance& other,
    const scalar distance,
    point& where
)
{
    boundBox box(solvedBox(other.space(), other.bounds()));
    box.min() -= mag(distance)*vector::one;
    box.max() += mag(distance)*vector::one;

    for (const point& p : surface.points())
    {
        if (box.contains(p) && other.distance(p) < distance)
        {
            where = p;
            return true;
        }
    }
    return false;
}

} // End anonymous namespace
} // End namespace SPH
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::SPH::cutBodies::amongCells
(
    const dictionary& dict,
    const orientedSurface& surface,
    const surfaceDistance& distance,
    const patchSurface& boundary
) const
{
    const boundBox box(surface.bounds());
    const boundBox meshBox(solvedBox(space_, mesh_.bounds()));
    const scalar small = tolerance*mag(box.span());
    const fluidRegion region(boundary, PtrList<solidBody>(), mag(box.span()));

    label nIn = 0;
    point in(Zero);
    point out(Zero);
    for (const point& p : surface.points())
    {
        const bool here =
            meshBox.contains(p)
         && region.inside(p)
         && region.distance(p) < -small;

        nIn += here;
        (here ? in : out) = p;
    }

    point crossing(Zero);
    const bool crossed = touches(boundary, distance, -small, crossing);

    if (nIn == 0 && (crossed || !meshBox.overlaps(box)))
    {
        FatalIOErrorInFunction(dict)
            << "Body " << dict.dictName() << ": no cell of the mesh holds it:"
            << " bounding boxes of its surface " << box << ", of the mesh "
            << mesh_.bounds() << ". Are both in metres? Otherwise give the"
            << " body a scale, as 'scale 0.001;'" << exit(FatalIOError);
    }

    if (nIn > 0 && (nIn < surface.points().size() || crossed))
    {
        const point& p = crossed ? crossing : out;
        const label patchi = region.find(p).patchi;

        FatalIOErrorInFunction(dict)
            << "Body " << dict.dictName() << " leaves the mesh at " << p;
        if (patchi >= 0)
        {
            FatalIOError
                << ", on patch " << mesh_.boundaryMesh()[patchi].name();
        }
        FatalIOError
            << ". Valid bodies lie wholly among the cells of the mesh, or"
            << " beside it" << exit(FatalIOError);
    }

    return nIn > 0;
}


void Foam::SPH::cutBodies::check(const dictionary& bodies) const
{
    for (label i = 0; i < size(); ++i)
    {
        const dictionary& dict = bodies.subDict(names_[i]);
        if (mesh_.boundaryMesh().findPatchID(names_[i]) >= 0)
        {
            FatalIOErrorInFunction(dict)
                << "Body " << names_[i] << " would be a second patch of that"
                << " name. Valid: any name but " << mesh_.boundaryMesh().names()
                << exit(FatalIOError);
        }

        for (label j = 0; j < size(); ++j)
        {
            const scalar small = tolerance*mag(surfaces_[j].bounds().span());
            point where(Zero);
            if (i != j && touches(surfaces_[i], distances_[j], small, where))
            {
                FatalIOErrorInFunction(dict)
                    << "The bodies " << names_[i] << " and " << names_[j]
                    << " touch at " << where << ". Valid bodies are apart;"
                    << " join what is one body in one surface"
                    << exit(FatalIOError);
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::cutBodies::cutBodies
(
    const polyMesh& mesh,
    const dictionary& dict
)
:
    mesh_(mesh),
    space_(mesh)
{
    const dictionary bodies(dict.subOrEmptyDict("bodies"));
    if
    (
        dict.subOrEmptyDict("closure").getOrDefault<word>("type", word::null)
     == "none"
    )
    {
        return;
    }

    autoPtr<patchSurface> boundary;
    for (const entry& e : bodies)
    {
        if (!e.isDict() || !e.dict().found("surface"))
        {
            continue;
        }

        autoPtr<orientedSurface> surface
        (
            new fileSurface(mesh.time(), space_, e.dict())
        );
        autoPtr<surfaceDistance> distance(new surfaceDistance(*surface));
        if (!boundary.valid())
        {
            boundary.reset(new patchSurface(mesh, space_));
        }
        if (amongCells(e.dict(), *surface, *distance, *boundary))
        {
            names_.append(e.keyword());
            surfaces_.append(surface.ptr());
            distances_.append(distance.ptr());
        }
    }

    check(bodies);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::SPH::cutBodies::inside(const point& p) const
{
    for (const surfaceDistance& body : distances_)
    {
        if
        (
            solvedBox(space_, body.bounds()).contains(p)
         && body.distance(p) < 0
        )
        {
            return true;
        }
    }
    return false;
}


Foam::labelList Foam::SPH::cutBodies::cells() const
{
    DynamicList<label> cells;
    forAll(mesh_.cellCentres(), celli)
    {
        if (inside(mesh_.cellCentres()[celli]))
        {
            cells.append(celli);
        }
    }
    return labelList(std::move(cells));
}


Foam::boolList Foam::SPH::cutBodies::zone() const
{
    const pointField& centres = mesh_.cellCentres();
    const scalarField spacing(cellSpacing(space_, mesh_));
    const meshSearch search(mesh_);

    boolList chosen(centres.size(), false);
    for (const orientedSurface& surface : surfaces_)
    {
        boundBox box(solvedBox(space_, surface.bounds()));

        scalar largest =
            spacing[search.findNearestCell(surface.points()[0])];
        forAll(centres, celli)
        {
            if (box.contains(centres[celli]))
            {
                largest = max(largest, spacing[celli]);
            }
        }

        box.min() -= layers*largest*vector::one;
        box.max() += layers*largest*vector::one;
        forAll(centres, celli)
        {
            chosen[celli] = chosen[celli] || box.contains(centres[celli]);
        }
    }
    return chosen;
}


void Foam::SPH::cutBodies::checkZone
(
    const boolList& inside,
    const dictionary& dict
) const
{
    if (!inside.found(false))
    {
        return;
    }

    const meshSearch search(mesh_, polyMesh::FACE_PLANES);
    forAll(surfaces_, bodyi)
    {
        label celli = -1;
        for (const point& p : surfaces_[bodyi].points())
        {
            celli = search.findCell(p, celli, true);
            if (celli >= 0 && !inside[celli])
            {
                FatalIOErrorInFunction(dict)
                    << "zone: body " << names_[bodyi] << " leaves it at " << p
                    << ". Valid zones hold the bodies cut out of the mesh, and"
                    << " a few cells around them; without an entry zone it is"
                    << " chosen around them" << exit(FatalIOError);
            }
        }
    }

    // Edges of the border that pass through a body
    for (label facei = 0; facei < mesh_.nInternalFaces(); ++facei)
    {
        const bool isBorder =
            inside[mesh_.faceOwner()[facei]]
         != inside[mesh_.faceNeighbour()[facei]];

        if (isBorder && this->inside(mesh_.faceCentres()[facei]))
        {
            FatalIOErrorInFunction(dict)
                << "zone: its border passes through a body at "
                << mesh_.faceCentres()[facei] << ". Valid zones hold bodies"
                << " with all that is in them" << exit(FatalIOError);
        }
    }
}


// ************************************************************************* //
