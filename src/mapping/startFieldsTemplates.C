/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "startFields.H"
#include "borderPatch.H"
#include "directFvPatchFieldMapper.H"
#include "fixedValueFvPatchFields.H"
#include "localIOdictionary.H"
#include "noSlipFvPatchVectorField.H"
#include "particleFiles.H"
#include "wallFvPatch.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
bool Foam::SPH::startFields::refines
(
    const word& field,
    const fvPatchField<Type>& patchField
) const
{
    return
        newtonian_
     && (field == "U" || field == "T")
     && isA<wallFvPatch>(patchField.patch())
     && (
            patchField.type() == fixedValueFvPatchField<Type>::typeName
         || patchField.type() == noSlipFvPatchVectorField::typeName
        );
}


template<class Type>
Foam::tmp<Foam::fvPatchField<Type>> Foam::SPH::startFields::bodyPatch
(
    const GeometricField<Type, fvPatchField, volMesh>& field,
    const fvPatch& patch,
    const DimensionedField<Type, volMesh>& internal
) const
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;

    const localIOdictionary file
    (
        IOobject
        (
            field.name(),
            field.instance(),
            mesh_,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        ),
        fieldType::typeName
    );
    const dictionary& conditions = file.subDict("boundaryField");

    // In OpenFOAM's order: name, groups, patterns
    const entry* found = conditions.findEntry(patch.name(), keyType::LITERAL);
    for (const word& group : patch.patch().inGroups())
    {
        found =
            found ? found : conditions.findEntry(group, keyType::LITERAL);
    }
    found =
        found ? found : conditions.findEntry(patch.name(), keyType::REGEX);

    if (found && found->isDict())
    {
        return fvPatchField<Type>::New(patch, internal, found->dict());
    }

    const word type
    (
        field.name() == "U"
      ? noSlipFvPatchVectorField::typeName
      : zeroGradientFvPatchField<Type>::typeName
    );
    Info<< "Body " << patch.name() << ": " << field.name() << ' ' << type
        << ", as " << file.objectPath() << " has no entry for it" << endl;

    return fvPatchField<Type>::New(type, patch, internal);
}


template<class Type>
Foam::tmp<Foam::fvPatchField<Type>> Foam::SPH::startFields::refined
(
    const word& field,
    const tmp<fvPatchField<Type>>& patchField
) const
{
    if
    (
        !hasParticles(patchField().patch())
     || !refines(field, patchField())
    )
    {
        return patchField;
    }

    auto trefined = fvPatchField<Type>::New
    (
        "quadraticFixedValue",
        patchField().patch(),
        patchField().internalField()
    );
    trefined.ref() == patchField();
    return trefined;
}


template<class Type>
Foam::tmp<Foam::fvPatchField<Type>> Foam::SPH::startFields::mapPatch
(
    const GeometricField<Type, fvPatchField, volMesh>& field,
    const label patchi,
    const DimensionedField<Type, volMesh>& internal
) const
{
    const fvPatch& patch = particles_.mesh().boundary()[patchi];

    if (isCutBody(patch.patch()))
    {
        return refined(field.name(), bodyPatch(field, patch, internal));
    }

    // Pairs across several periods have a patch that FVM does not have
    if (patchi >= mesh_.boundary().size())
    {
        return fvPatchField<Type>::New(patch.type(), patch, internal);
    }

    const label start =
        patch.patch().start() - particles_.mesh().nInternalFaces();
    labelList addressing
    (
        SubList<label>(particles_.boundaryFace(), patch.patch().size(), start)
    );
    if (isA<emptyPolyPatch>(patch.patch()))
    {
        addressing.clear();
    }

    const fvPatchField<Type>& from = field.boundaryField()[patchi];
    const directFvPatchFieldMapper mapper(addressing);

    return refined
    (
        field.name(), fvPatchField<Type>::New(from, patch, internal, mapper)
    );
}


template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::SPH::startFields::mapped
(
    const GeometricField<Type, fvPatchField, volMesh>& field
) const
{
    auto tvalues = tmp<Field<Type>>::New(toParticles_.size());
    toParticles_.map(field.primitiveField(), tvalues.ref(), true);
    return tvalues;
}


template<class Type>
void Foam::SPH::startFields::mapField
(
    const GeometricField<Type, fvPatchField, volMesh>& field
)
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;

    const fileName file(field.instance()/field.name());
    if (!case_.files().mayWrite(file))
    {
        return;
    }

    Field<Type> values(mapped(field));
    forAll(values, i)
    {
        if (beside_[i])
        {
            values[i] = field[cells_[i]];
        }
    }

    fieldType particleField
    (
        IOobject
        (
            field.name(),
            field.instance(),
            particles_.mesh(),
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        particles_.mesh(),
        dimensioned<Type>(field.dimensions(), Zero)
    );
    particleField.primitiveFieldRef() = values;

    forAll(particleField.boundaryField(), patchi)
    {
        particleField.boundaryFieldRef().set
        (
            patchi, mapPatch(field, patchi, particleField.internalField())
        );
    }

    const unsigned precision = IOstream::defaultPrecision(12);
    particleFiles::checkWritten(particleField.write(), particleField);
    IOstream::defaultPrecision(precision);
    case_.files().add(file);
}


template<class Type>
void Foam::SPH::startFields::mapType()
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;

    for (const word& name : objects_.sortedNames(fieldType::typeName))
    {
        if (IOobject::group(name) != "sph")
        {
            IOobject io(*objects_[name]);
            io.readOpt() = IOobject::MUST_READ;
            mapField(fieldType(io, mesh_));
        }
    }
}


// ************************************************************************* //
