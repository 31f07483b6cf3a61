/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "lineProfile.H"
#include "interpolationCellPoint.H"
#include "meshSearch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    static constexpr label defaultPoints = 200;

    //- Coordinate direction of a vector, -1 if it is not parallel to one
    static label parallelAxis(const vector& v)
    {
        for (direction d = 0; d < 3; ++d)
        {
            if (mag(mag(v[d]) - mag(v)) <= SMALL*mag(v))
            {
                return d;
            }
        }
        return -1;
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::lineProfile::findCells
(
    const fvMesh& mesh,
    const solutionSpace& space
)
{
    const point end(space.position(space.toLocal(start_ + extent_)));
    start_ = space.position(space.toLocal(start_));
    extent_ = end - start_;

    const meshSearch search(mesh, polyMesh::FACE_PLANES);
    const label axis = parallelAxis(extent_);

    DynamicList<point> points(nPoints_);
    DynamicList<scalar> distance(nPoints_);
    DynamicList<label> cells(nPoints_);

    for (label i = 0; i < nPoints_; ++i)
    {
        const point p(start_ + (i + 0.5)/nPoints_*extent_);
        const label celli = search.findCell(p);
        if (celli >= 0)
        {
            points.append(p);
            distance.append(axis >= 0 ? p[axis] : mag(p - start_));
            cells.append(celli);
        }
    }

    points_.transfer(points);
    distance_.transfer(distance);
    cells_.transfer(cells);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::lineProfile::lineProfile
(
    const word& name,
    const fvMesh& mesh,
    const solutionSpace& space,
    const point& start,
    const point& end
)
:
    name_(name),
    start_(start),
    extent_(end - start),
    nPoints_(defaultPoints),
    points_(),
    distance_(),
    cells_()
{
    findCells(mesh, space);
}


Foam::SPH::lineProfile::lineProfile
(
    const word& name,
    const fvMesh& mesh,
    const solutionSpace& space,
    const dictionary& dict
)
:
    name_(name),
    start_(dict.get<point>("start")),
    extent_(dict.get<point>("end") - start_),
    nPoints_(dict.getOrDefault<label>("nPoints", defaultPoints)),
    points_(),
    distance_(),
    cells_()
{
    if (nPoints_ < 2)
    {
        FatalIOErrorInFunction(dict)
            << "Entry nPoints of line " << name << " is " << nPoints_
            << ". Valid choices: 2 or more" << exit(FatalIOError);
    }

    findCells(mesh, space);

    if (returnReduce(points_.size(), sumOp<label>()) == 0)
    {
        FatalIOErrorInFunction(dict)
            << "Line " << name << " from " << start_ << " to "
            << start_ + extent_ << " has no point inside the mesh, whose"
            << " bounds are " << mesh.bounds() << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::PtrList<Foam::SPH::lineProfile> Foam::SPH::lineProfile::centreLines
(
    const fvMesh& mesh,
    const solutionSpace& space
)
{
    PtrList<lineProfile> lines(space.nDims());

    forAll(lines, d)
    {
        const direction axis = space.axis(d);
        point start(mesh.bounds().midpoint());
        point end(start);
        start[axis] = mesh.bounds().min()[axis];
        end[axis] = mesh.bounds().max()[axis];

        lines.set
        (
            d,
            new lineProfile
            (
                word("centre") + char('X' + axis), mesh, space, start, end
            )
        );
    }

    return lines;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::word Foam::SPH::lineProfile::coordinateName() const
{
    const label axis = parallelAxis(extent_);

    return axis >= 0 ? vector::componentNames[axis] : "distance";
}


Foam::scalarField Foam::SPH::lineProfile::sample
(
    const volScalarField& field
) const
{
    const interpolationCellPoint<scalar> interpolation(field);

    scalarField values(points_.size());
    forAll(values, i)
    {
        values[i] = interpolation.interpolate(points_[i], cells_[i]);
    }
    return values;
}

// ************************************************************************* //
