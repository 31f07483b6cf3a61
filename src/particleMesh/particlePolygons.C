/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particlePolygons.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- A unit vector normal to n
    static vector tangent(const vector& n)
    {
        // The axis that n is farthest from
        direction axis = 0;
        for (direction d = 1; d < 3; ++d)
        {
            if (mag(n[d]) < mag(n[axis]))
            {
                axis = d;
            }
        }
        vector e(Zero);
        e[axis] = 1;
        e -= (e & n)*n;

        return e/mag(e);
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::particlePolygons::addTriangle
(
    const point& centre,
    const vector& area
)
{
    const scalar magArea = mag(area);
    const vector n(area/magArea);

    // Circumradius and half the side
    const scalar radius = sqrt(4*magArea/(3*sqrt(3.0)));
    const scalar half = 0.5*sqrt(3.0)*radius;
    const vector x(tangent(n));
    const vector y(n ^ x);

    const label start = points_.size();
    points_.append(centre + radius*x);
    points_.append(centre - 0.5*radius*x + half*y);
    points_.append(centre - 0.5*radius*x - half*y);

    faces_.append(face(identity(3, start)));
}


void Foam::SPH::particlePolygons::addRectangle
(
    const point& centre,
    const vector& area,
    const vector& edge
)
{
    const vector a(0.5*edge);
    const vector b((area ^ a)/(4*magSqr(a)));

    // a ^ b has the direction of the area as (area ^ a) is b's
    const label start = points_.size();
    points_.append(centre - a - b);
    points_.append(centre + a - b);
    points_.append(centre + a + b);
    points_.append(centre - a + b);

    faces_.append(face(identity(4, start)));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::particlePolygons::add(const point& centre, const vector& area)
{
    for (const vector& edge : emptyEdges_)
    {
        // Along an empty direction, but not that of an empty face
        if (mag(area & edge) < 0.5*mag(area)*mag(edge))
        {
            addRectangle(centre, area, edge);
            return;
        }
    }
    addTriangle(centre, area);
}


Foam::autoPtr<Foam::polyMesh> Foam::SPH::particlePolygons::makeMesh
(
    const Time& time,
    const word& region,
    labelList&& owner,
    labelList&& neighbour,
    const UList<namedPatch>& patches
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
            pointField(std::move(points_)),
            faceList(std::move(faces_)),
            std::move(owner),
            std::move(neighbour)
        )
    );

    List<polyPatch*> polyPatches(patches.size());
    forAll(patches, patchi)
    {
        dictionary dict(patches[patchi].dict);
        dict.set("startFace", patches[patchi].start);
        dict.set("nFaces", patches[patchi].size);
        polyPatches[patchi] = polyPatch::New
        (
            patches[patchi].name, dict, patchi, meshPtr->boundaryMesh()
        ).ptr();
    }
    meshPtr->addPatches(polyPatches);

    return meshPtr;
}


// ************************************************************************* //
