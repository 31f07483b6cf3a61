/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "IOField.H"
#include "storedFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
Foam::label Foam::SPH::storedFields::mapType
(
    const IOobjectList& objects
) const
{
    typedef GeometricField<Type, fvPatchField, volMesh> volFieldType;

    const fvMesh& mesh = particles_.mesh();
    label nMapped = 0;

    for (const word& name : objects.sortedNames(IOField<Type>::typeName))
    {
        IOobject templateIO(boundaryConditions(name, volFieldType::typeName));

        if (templateIO.name().empty())
        {
            Info<< "    " << name << ": not mapped, no " << name << " or "
                << volName(name) << " gives its boundary conditions" << nl;
            continue;
        }

        const IOField<Type> values(*objects.findObject(name));

        if (values.size() != particles_.nParticles())
        {
            FatalErrorInFunction
                << "Field " << values.objectPath() << " has "
                << values.size() << " values, but the particle mesh in "
                << sphMesh::directory(mesh) << " has "
                << particles_.nParticles() << " particles"
                << exit(FatalError);
        }

        const volFieldType conditions(templateIO, mesh);
        volFieldType result
        (
            IOobject(volName(name), mesh.time().timeName(), mesh),
            conditions
        );

        mapper_.mapInternal(values, result);

        auto& boundary = result.boundaryFieldRef();
        forAll(boundary, patchi)
        {
            if (!selfContained(boundary[patchi].type()))
            {
                boundary[patchi] == mapper_.mapToPatch(values, patchi);
            }
        }

        // Coupled patches exchange values in two steps
        forAll(boundary, patchi)
        {
            if (selfContained(boundary[patchi].type()))
            {
                boundary[patchi].initEvaluate(Pstream::commsTypes::blocking);
            }
        }
        forAll(boundary, patchi)
        {
            if (selfContained(boundary[patchi].type()))
            {
                boundary[patchi].evaluate(Pstream::commsTypes::blocking);
            }
        }

        if (!result.write())
        {
            FatalErrorInFunction
                << "Cannot write " << result.objectPath()
                << exit(FatalError);
        }

        Info<< "    " << name << " -> " << result.name() << nl;
        ++nMapped;
    }

    return nMapped;
}


// ************************************************************************* //
