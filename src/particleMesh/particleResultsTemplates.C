/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleResults.H"
#include "localIOdictionary.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::tmp<Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>>
Foam::SPH::particleResults::read(const IOobject& io) const
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;

    const localIOdictionary dict
    (
        IOobject
        (
            io.name(),
            io.instance(),
            io.local(),
            mesh_,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        ),
        fieldType::typeName
    );

    auto tfield = tmp<fieldType>::New
    (
        IOobject
        (
            io.name(),
            io.instance(),
            mesh_,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh_,
        dimensioned<Type>(dict.get<dimensionSet>("dimensions"), Zero)
    );
    fieldType& field = tfield.ref();
    field.primitiveFieldRef() =
        Field<Type>("internalField", dict, mesh_.nCells());

    const dictionary& patches = dict.subDict("boundaryField");
    for (fvPatchField<Type>& patchField : field.boundaryFieldRef())
    {
        const fvPatch& patch = patchField.patch();
        const dictionary& entries = patches.subDict(patch.name());

        if (patch.coupled() || patchField.size() == 0)
        {
            continue;
        }
        if (entries.found("value"))
        {
            patchField == Field<Type>("value", entries, patch.size());
        }
        else
        {
            // Conditions without a value give it themselves
            patchField == fvPatchField<Type>::New
            (
                patch, field.internalField(), entries
            )();
        }
    }

    return tfield;
}


// ************************************************************************* //
