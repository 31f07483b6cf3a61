/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "surfaceDistance.H"
#include "mergePoints.H"
#include "ListOps.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
namespace
{

//- All translations up to a distance in each direction, without none
List<vector> combinations
(
    const solutionSpace& space,
    const List<vector>& periods,
    const scalar distance
)
{
    DynamicList<vector> shifts;
    shifts.append(vector::zero);

    for (const vector& period : periods)
    {
        const vector shift(space.toLocal(period));
        const label n = max(label(1), label(ceil(distance/mag(shift))));
        const label nOld = shifts.size();

        for (label k = -n; k <= n; ++k)
        {
            for (label i = 0; k != 0 && i < nOld; ++i)
            {
                shifts.append(vector(shifts[i] + k*shift));
            }
        }
    }

    return List<vector>(SubList<vector>(shifts, shifts.size() - 1, 1));
}


//- Do the triangles of a vertex form one closed fan
bool isFan
(
    const UList<FixedList<label, 3>>& triangles,
    const labelUList& around,
    const label vertexi
)
{
    // Edge opposite to the vertex
    const auto opposite = [&](const label trianglei)
    {
        const FixedList<label, 3>& v = triangles[trianglei];
        const label k = v.find(vertexi);

        return labelPair(v[(k + 1) % 3], v[(k + 2) % 3]);
    };

    const label first = opposite(around[0]).first();
    label next = opposite(around[0]).second();
    label n = 1;

    while (next != first && n < around.size())
    {
        label after = -1;
        for (const label trianglei : around)
        {
            const labelPair e(opposite(trianglei));
            if (e.first() == next)
            {
                after = e.second();
                break;
            }
        }

        if (after < 0)
        {
            return false;
        }
        next = after;
        ++n;
    }

    return next == first && n == around.size();
}

} // End anonymous namespace
} // End namespace SPH
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::surfaceDistance::setElements
(
    const orientedSurface& surface,
    const scalar band
)
{
    const label nDims = space_.nDims();
    const bool periodic = surface.periods().size();

    pointField local(surface.points());
    for (point& p : local)
    {
        p = space_.toLocal(p);
    }

    boundBox wanted(local, false);
    wanted.inflate(SMALL);
    wanted.min() -= band*vector::one;
    wanted.max() += band*vector::one;

    if (periodic)
    {
        shifts_ = combinations(space_, surface.periods(), band);
    }

    List<vector> copies(shifts_.size() + 1, Zero);
    SubList<vector>(copies, shifts_.size(), 1) = shifts_;

    DynamicList<point> points(local.size());
    DynamicList<FixedList<label, 3>> elements(surface.size());
    DynamicList<label> patches(surface.size());
    DynamicList<label> faces(surface.size());
    DynamicList<vector> normals(surface.size());

    for (const vector& shift : copies)
    {
        labelList newPoint(local.size(), -1);

        forAll(surface.elements(), elementi)
        {
            const orientedSurface::element& e = surface.elements()[elementi];

            boundBox box;
            for (label k = 0; k < nDims; ++k)
            {
                box.add(local[e.vertices[k]] + shift);
            }

            if ((periodic && e.coupled) || !box.overlaps(wanted))
            {
                continue;
            }

            FixedList<label, 3> v(e.vertices);
            for (label k = 0; k < nDims; ++k)
            {
                label& newi = newPoint[v[k]];
                if (newi < 0)
                {
                    newi = points.size();
                    points.append(local[v[k]] + shift);
                }
                v[k] = newi;
            }

            elements.append(v);
            patches.append(e.patchi);
            faces.append(e.facei);

            const vector S(space_.toLocal(surface.areaVector(elementi)));
            normals.append(S/max(mag(S), VSMALL));
        }
    }

    points_.transfer(points);
    elements_.transfer(elements);
    patches_.transfer(patches);
    faces_.transfer(faces);
    normals_.transfer(normals);

    // Images join their neighbours at the coupled patches
    if (periodic && points_.size())
    {
        labelList map;
        pointField merged;
        const scalar tolerance = 1e-9*boundBox(points_, false).mag();

        if (mergePoints(points_, tolerance, false, map, merged))
        {
            points_.transfer(merged);
            for (FixedList<label, 3>& v : elements_)
            {
                for (label k = 0; k < nDims; ++k)
                {
                    v[k] = map[v[k]];
                }
            }
        }
    }
}


void Foam::SPH::surfaceDistance::setNormals()
{
    vertexNormals_.setSize(points_.size(), Zero);
    edgeNormals_.setSize(space_.nDims() == 3 ? 3*elements_.size() : 0, Zero);

    List<orientedSurface::element> elements(elements_.size());
    forAll(elements, elementi)
    {
        elements[elementi].vertices = elements_[elementi];
    }

    const orientedSurface surface
    (
        space_,
        pointField(points_),
        std::move(elements)
    );

    if (space_.nDims() > 1)
    {
        setVertexNormals(surface);
    }
    if (space_.nDims() == 3)
    {
        setEdgeNormals(surface);
    }
}


void Foam::SPH::surfaceDistance::setVertexNormals
(
    const orientedSurface& surface
)
{
    const label nDims = space_.nDims();

    labelListList around(points_.size());
    forAll(elements_, elementi)
    {
        for (label k = 0; k < nDims; ++k)
        {
            around[elements_[elementi][k]].append(elementi);
        }
    }

    forAll(points_, vertexi)
    {
        const labelList& elementis = around[vertexi];

        const bool manifold =
            nDims == 2
          ? elementis.size() == 2
          : elementis.size() && isFan(elements_, elementis, vertexi);

        if (!manifold)
        {
            continue;
        }

        vector sum(Zero);
        for (const label elementi : elementis)
        {
            scalar angle = 1;
            if (nDims == 3)
            {
                const FixedList<label, 3>& v = elements_[elementi];
                const label k = v.find(vertexi);
                const vector a(points_[v[(k + 1) % 3]] - points_[vertexi]);
                const vector b(points_[v[(k + 2) % 3]] - points_[vertexi]);

                angle = atan2(mag(a ^ b), a & b);
            }
            sum += angle*normals_[elementi];
        }

        vertexNormals_[vertexi] = sum/max(mag(sum), SMALL);
    }
}


void Foam::SPH::surfaceDistance::setEdgeNormals(const orientedSurface& surface)
{
    const List<orientedSurface::side> sides(surface.sides());
    const labelList starts(orientedSurface::groups(sides));

    for (label g = 0; g + 1 < starts.size(); ++g)
    {
        if (starts[g+1] - starts[g] != 2)
        {
            continue;
        }

        vector sum(Zero);
        for (label s = starts[g]; s < starts[g+1]; ++s)
        {
            sum += normals_[sides[s].elementi];
        }
        sum /= max(mag(sum), SMALL);

        for (label s = starts[g]; s < starts[g+1]; ++s)
        {
            const FixedList<label, 3>& v = elements_[sides[s].elementi];
            const labelPair& edge = sides[s].vertices;

            const label k =
                v.find(sides[s].forward ? edge.first() : edge.second());

            edgeNormals_[3*sides[s].elementi + k] = sum;
        }
    }
}


// ************************************************************************* //
