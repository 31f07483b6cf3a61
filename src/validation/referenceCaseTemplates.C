/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "referenceCase.H"
#include "wallFvPatch.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::tmp<Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>>
Foam::SPH::referenceCase::read
(
    const word& name,
    const instant& time,
    const GeometricField<Type, fvPatchField, volMesh>& like
) const
{
    typedef GeometricField<Type, fvPatchField, volMesh> volFieldType;

    tmp<volFieldType> tsource
    (
        new volFieldType
        (
            IOobject
            (
                name,
                timeName(time),
                sourceMesh(),
                IOobject::MUST_READ,
                IOobject::NO_WRITE,
                false
            ),
            sourceMesh()
        )
    );

    if (!mapping_.valid())
    {
        return tsource;
    }

    tmp<volFieldType> tresult
    (
        new volFieldType
        (
            IOobject
            (
                name,
                mesh_.time().timeName(),
                mesh_,
                IOobject::NO_READ,
                IOobject::NO_WRITE,
                false
            ),
            mesh_,
            tsource().dimensions()
        )
    );
    volFieldType& result = tresult.ref();

    mapping_->map(tsource().primitiveField(), result.primitiveFieldRef());

    // Walls have the value of the compared field, others that of the cells
    auto& boundary = result.boundaryFieldRef();
    forAll(boundary, patchi)
    {
        boundary[patchi] ==
        (
            isA<wallFvPatch>(boundary[patchi].patch())
          ? tmp<Field<Type>>(new Field<Type>(like.boundaryField()[patchi]))
          : boundary[patchi].patchInternalField()
        );
    }

    return tresult;
}

// ************************************************************************* //
