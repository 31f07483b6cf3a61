/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "quadraticFixedValueFvPatchField.H"
#include "volFields.H"
#include "wallStencils.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
Foam::tmp<Foam::Field<Type>>
Foam::SPH::quadraticFixedValueFvPatchField<Type>::explicitPart() const
{
    typedef GeometricField<Type, fvPatchField, volMesh> volFieldType;

    if (!isA<volFieldType>(this->internalField()))
    {
        // No values but those of the cells: the two-point gradient
        return deltaCoeffs()*(*this - this->patchInternalField());
    }

    const auto& vf = refCast<const volFieldType>(this->internalField());
    boolList known(vf.boundaryField().size());
    forAll(known, patchi)
    {
        const fvPatchField<Type>& values = vf.boundaryField()[patchi];
        known[patchi] = values.fixesValue() && !values.coupled();
    }

    return
        wallStencils::New(vf.mesh()).stencil(this->patch(), known).gradient
        (
            vf,
            varies_
        );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
void Foam::SPH::quadraticFixedValueFvPatchField<Type>::updateCoeffs()
{
    if (this->updated())
    {
        return;
    }

    varies_ = gMin(*this) != gMax(*this);

    fixedValueFvPatchField<Type>::updateCoeffs();
}


template<class Type>
Foam::tmp<Foam::Field<Type>>
Foam::SPH::quadraticFixedValueFvPatchField<Type>::snGrad() const
{
    return
        2*deltaCoeffs()*(*this - this->patchInternalField())
      - explicitPart();
}


template<class Type>
Foam::tmp<Foam::Field<Type>>
Foam::SPH::quadraticFixedValueFvPatchField<Type>::gradientInternalCoeffs() const
{
    return -2*pTraits<Type>::one*deltaCoeffs();
}


template<class Type>
Foam::tmp<Foam::Field<Type>>
Foam::SPH::quadraticFixedValueFvPatchField<Type>::gradientBoundaryCoeffs() const
{
    return 2*deltaCoeffs()*(*this) - explicitPart();
}


// ************************************************************************* //
