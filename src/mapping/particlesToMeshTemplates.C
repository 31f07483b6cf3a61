/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particlesToMesh.H"
#include "calculatedFvPatchFields.H"
#include "particleFiles.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
bool Foam::SPH::particlesToMesh::mapType(const IOobject& io) const
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;

    if (io.headerClassName() != fieldType::typeName)
    {
        return false;
    }

    const tmp<fieldType> tmapped(map(particles_.read<Type>(io)()));
    particleFiles::checkWritten(tmapped().write(), tmapped());

    Info<< "    " << io.name() << " -> " << tmapped().name() << nl;
    return true;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::tmp<Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>>
Foam::SPH::particlesToMesh::map
(
    const GeometricField<Type, fvPatchField, volMesh>& field
) const
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;

    auto tmapped = tmp<fieldType>::New
    (
        IOobject
        (
            particleResults::volName(field.name()),
            mesh_.time().timeName(),
            mesh_,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh_,
        dimensioned<Type>(field.dimensions(), Zero)
    );
    fieldType& mapped = tmapped.ref();
    cells_.map(field.primitiveField(), mapped.primitiveFieldRef());
    forAll(particles_.cellMap(), i)
    {
        if (particles_.cellMap()[i] >= 0)
        {
            mapped.primitiveFieldRef()[particles_.cellMap()[i]] = field[i];
        }
    }
    for (const label celli : particles_.solidCells())
    {
        mapped.primitiveFieldRef()[celli] = Zero;
    }

    const label nInternal = particles_.mesh().nInternalFaces();
    for (fvPatchField<Type>& patchField : mapped.boundaryFieldRef())
    {
        if (!isA<calculatedFvPatchField<Type>>(patchField))
        {
            continue;
        }

        const label patchi = patchField.patch().index();
        const fvPatchField<Type>& from = field.boundaryField()[patchi];
        const labelList& face = particles_.boundaryFace();
        const label start = from.patch().start() - nInternal;

        Field<Type> sum(patchField.size(), Zero);
        scalarField area(patchField.size(), Zero);
        forAll(from, k)
        {
            const label facei = face[start + k];
            sum[facei] += from.patch().magSf()[k]*from[k];
            area[facei] += from.patch().magSf()[k];
        }

        // Faces of which no particle has a part take the cell's value
        const Field<Type> inner(patchField.patchInternalField());
        forAll(sum, facei)
        {
            sum[facei] =
                area[facei] > 0 ? Type(sum[facei]/area[facei]) : inner[facei];
        }
        patchField == sum;
    }
    mapped.correctBoundaryConditions();

    return tmapped;
}


// ************************************************************************* //
