/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleDiscs.H"
#include "IOField.H"
#include "mathematicalConstants.H"
#include "sphMesh.H"
#include "storedFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Corners of a disc
    static constexpr label nCorners = 12;

    template<class Type>
    static IOField<Type> readArray
    (
        const word& name,
        const word& instance,
        const fileName& local,
        const fvMesh& mesh
    )
    {
        return IOField<Type>
        (
            IOobject
            (
                name,
                instance,
                local,
                mesh,
                IOobject::READ_IF_PRESENT,
                IOobject::NO_WRITE,
                false
            )
        );
    }
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::particleDiscs::particleDiscs
(
    const fvMesh& mesh,
    const meshSlice& slice,
    const boundBox& box
)
:
    mesh_(mesh),
    particles_(),
    points_(),
    polygons_()
{
    const word instance(mesh.time().constant());
    const word local(sphMesh::typeName);
    const auto centres = readArray<vector>("points", instance, local, mesh);
    const auto spacing = readArray<scalar>("spacing", instance, local, mesh);

    DynamicList<label> particles;
    DynamicList<point> points;
    DynamicList<face> polygons;

    forAll(centres, i)
    {
        const point centre(slice.toPlane(centres[i]));
        if
        (
            mag(slice.distance(centres[i])) > 0.5*spacing[i]
         || centre.x() < box.min().x() || centre.x() > box.max().x()
         || centre.y() < box.min().y() || centre.y() > box.max().y()
        )
        {
            continue;
        }

        particles.append(i);
        polygons.append(face(identity(nCorners, points.size())));
        for (label corner = 0; corner < nCorners; ++corner)
        {
            const scalar angle =
                Foam::constant::mathematical::twoPi*corner/nCorners;
            points.append
            (
                centre
              + 0.5*spacing[i]*vector(Foam::cos(angle), Foam::sin(angle), 0)
            );
        }
    }

    particles_.transfer(particles);
    points_.transfer(points);
    polygons_.transfer(polygons);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::SPH::particleDiscs::values(const word& field) const
{
    const IOobjectList objects(storedFields::find(mesh_));
    const word instance(mesh_.time().timeName());

    scalarField values;
    if (objects.findObject(field))
    {
        const word& className = objects.findObject(field)->headerClassName();
        const fileName local(storedFields::folder());

        if (className == IOField<scalar>::typeName)
        {
            values = readArray<scalar>(field, instance, local, mesh_);
        }
        else if (className == IOField<vector>::typeName)
        {
            values = mag(readArray<vector>(field, instance, local, mesh_));
        }
    }

    return
        values.empty()
      ? values
      : scalarField(UIndirectList<scalar>(values, particles_));
}

// ************************************************************************* //
