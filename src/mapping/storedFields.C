/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "storedFields.H"
#include "cloud.H"
#include "polyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::SPH::storedFields::selfContained(const word& patchFieldType)
{
    static const wordHashSet types
    {
        "fixedValue", "noSlip", "zeroGradient", "slip", "calculated"
    };

    return
        types.found(patchFieldType)
     || polyPatch::constraintType(patchFieldType);
}


Foam::IOobject Foam::SPH::storedFields::boundaryConditions
(
    const word& field,
    const word& className
) const
{
    const fvMesh& mesh = particles_.mesh();

    const auto header = [&](const word& name, const word& instance)
    {
        return IOobject
        (
            name,
            instance,
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        );
    };

    const auto exists = [&](IOobject& io)
    {
        return
            io.typeHeaderOk<regIOobject>(false)
         && io.headerClassName() == className;
    };

    for (const word& name : {volName(field), field})
    {
        IOobject io(header(name, mesh.time().timeName()));
        if (exists(io))
        {
            return io;
        }
    }

    for (const instant& time : mesh.time().times())
    {
        IOobject io(header(field, time.name()));
        if (exists(io))
        {
            return io;
        }
    }

    return header(word::null, word::null);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::storedFields::storedFields
(
    const sphMesh& particles,
    const particlesToMesh& mapper
)
:
    particles_(particles),
    mapper_(mapper)
{}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::fileName Foam::SPH::storedFields::folder()
{
    return cloud::prefix/"sph";
}


Foam::word Foam::SPH::storedFields::volName(const word& field)
{
    return field + ".sph";
}


Foam::IOobjectList Foam::SPH::storedFields::find(const fvMesh& mesh)
{
    return IOobjectList(mesh, mesh.time().timeName(), folder());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::SPH::storedFields::map(const wordRes& names) const
{
    IOobjectList objects(find(particles_.mesh()));
    if (!names.empty())
    {
        objects.filterObjects(names);
    }

    return
        mapType<scalar>(objects)
      + mapType<vector>(objects)
      + mapType<sphericalTensor>(objects)
      + mapType<symmTensor>(objects)
      + mapType<tensor>(objects);
}


// ************************************************************************* //
