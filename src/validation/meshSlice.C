/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "meshSlice.H"
#include "SortableList.H"
#include "pointFields.H"
#include "volPointInterpolation.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Unit vector of a coordinate direction
    static vector axis(const direction d)
    {
        vector v(Zero);
        v[d] = 1;
        return v;
    }

    //- Name of a unit vector
    static word axisName(const vector& v)
    {
        for (direction d = 0; d < 3; ++d)
        {
            if (mag(v - axis(d)) < SMALL)
            {
                return vector::componentNames[d];
            }
        }
        return "distance";
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::meshSlice::orient()
{
    for (direction d = 0; d < 3; ++d)
    {
        if (mag(mag(normal_[d]) - 1) < SMALL)
        {
            right_ = axis(d == 0 ? 1 : 0);
            up_ = axis(d == 2 ? 1 : 2);
            return;
        }
    }

    direction steepest = 2;
    for (direction d = 0; d < 3; ++d)
    {
        if (mag(normal_[d]) < mag(normal_[steepest]))
        {
            steepest = d;
        }
    }
    up_ = normalised(axis(steepest) - normal_[steepest]*normal_);
    right_ = up_ ^ normal_;
}


void Foam::SPH::meshSlice::cut(const polyMesh& mesh)
{
    // A mesh point on the plane counts as on its positive side: every piece
    // of the plane then belongs to exactly one cell
    const scalarField distance((mesh.points() - origin_) & normal_);

    labelList slicePoint(mesh.nEdges(), -1);
    DynamicList<point> points;
    DynamicList<Foam::edge> edges;
    DynamicList<scalar> positions;

    forAll(slicePoint, edgei)
    {
        const Foam::edge& e = mesh.edges()[edgei];
        const scalar da = distance[e.start()];
        const scalar db = distance[e.end()];

        if ((da >= 0) != (db >= 0))
        {
            const point& a = mesh.points()[e.start()];
            const point& b = mesh.points()[e.end()];
            const scalar s = da/(da - db);

            slicePoint[edgei] = points.size();
            points.append(toPlane(a + s*(b - a)));
            edges.append(e);
            positions.append(s);
        }
    }
    points_.transfer(points);
    edges_.transfer(edges);
    positions_.transfer(positions);

    DynamicList<face> polygons;
    DynamicList<label> corners;
    for (const labelList& cellEdges : mesh.cellEdges())
    {
        corners.clear();
        for (const label edgei : cellEdges)
        {
            if (slicePoint[edgei] != -1)
            {
                corners.append(slicePoint[edgei]);
            }
        }

        if (corners.size() >= 3)
        {
            point middle(Zero);
            for (const label pointi : corners)
            {
                middle += points_[pointi]/corners.size();
            }

            scalarList angles(corners.size());
            forAll(angles, i)
            {
                const vector d(points_[corners[i]] - middle);
                angles[i] = Foam::atan2(d.y(), d.x());
            }

            labelList order;
            sortedOrder(angles, order);
            polygons.append(face(labelList(corners, order)));
        }
    }
    polygons_.transfer(polygons);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::meshSlice::meshSlice
(
    const polyMesh& mesh,
    const point& origin,
    const vector& normal
)
:
    origin_(origin),
    normal_(normalised(normal)),
    right_(Zero),
    up_(Zero),
    points_(),
    edges_(),
    positions_(),
    polygons_()
{
    orient();
    cut(mesh);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::word Foam::SPH::meshSlice::rightName() const
{
    return axisName(right_);
}


Foam::word Foam::SPH::meshSlice::upName() const
{
    return axisName(up_);
}


Foam::scalarField Foam::SPH::meshSlice::interpolate
(
    const volScalarField& field
) const
{
    const tmp<pointScalarField> tvalues
    (
        volPointInterpolation::New(field.mesh()).interpolate(field)
    );
    const pointScalarField& values = tvalues();

    scalarField result(points_.size());
    forAll(result, i)
    {
        const scalar a = values[edges_[i].start()];
        const scalar b = values[edges_[i].end()];
        result[i] = a + positions_[i]*(b - a);
    }
    return result;
}

// ************************************************************************* //
