/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "fieldNorms.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
void Foam::SPH::fieldNorms::add
(
    const word& name,
    const labelUList& components,
    const scalarField& V,
    const Field<Type>& field,
    const Field<Type>& reference
)
{
    const Field<Type> difference(field - reference);
    const scalarField magReference(mag(reference));
    const scalar size = gMax(magReference);

    for (const label d : components)
    {
        addComponent
        (
            name,
            pTraits<Type>::componentNames[d],
            V,
            difference.component(d)(),
            reference.component(d)(),
            size
        );
    }

    addComponent
    (
        name,
        pTraits<Type>::rank == 0 ? "value" : "mag",
        V,
        mag(difference)(),
        pTraits<Type>::rank == 0 ? reference.component(0)() : magReference,
        size
    );
}

// ************************************************************************* //
