/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particlesToMesh.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
void Foam::SPH::particlesToMesh::mapInternal
(
    const Field<Type>& particleValues,
    GeometricField<Type, fvPatchField, volMesh>& result
) const
{
    cells_.map(particleValues, result.primitiveFieldRef());
}


template<class Type>
void Foam::SPH::particlesToMesh::map
(
    const Field<Type>& particleValues,
    GeometricField<Type, fvPatchField, volMesh>& result
) const
{
    mapInternal(particleValues, result);
    result.correctBoundaryConditions();
}


template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::SPH::particlesToMesh::mapToPatch
(
    const Field<Type>& particleValues,
    const label patchi
) const
{
    const fvPatch& patch = particles_.mesh().boundary()[patchi];

    if (!patches_.set(patchi))
    {
        patches_.set
        (
            patchi,
            new movingLeastSquares
            (
                particles_.space(),
                sources(),
                {patch.Cf(), scalarField(patch.size(), Zero)}
            )
        );
    }

    tmp<Field<Type>> tvalues(new Field<Type>(patch.size()));
    patches_[patchi].map(particleValues, tvalues.ref());

    return tvalues;
}


// ************************************************************************* //
