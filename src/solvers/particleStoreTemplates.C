/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleStore.H"
#include "compat.H"
#include "IOField.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::Field<Type> Foam::SPH::particleStore::read(const word& name) const
{
    const IOField<Type> field(fieldIO(name, IOobject::MUST_READ));

    if (field.size() != particles_.nParticles())
    {
        FatalErrorInFunction
            << "File " << field.objectPath() << " has " << field.size()
            << " values, but the particle mesh has "
            << particles_.nParticles() << " particles. Remove the particle"
            << " fields of this time to start from the cell fields"
            << exit(FatalError);
    }

    return Field<Type>(field);
}


template<class Type>
void Foam::SPH::particleStore::write
(
    const word& name,
    const Field<Type>& field
) const
{
    const IOField<Type> stored(fieldIO(name, IOobject::NO_READ), field);

    if (!writeAs(stored, IOstream::BINARY))
    {
        FatalErrorInFunction
            << "Cannot write " << stored.objectPath() << exit(FatalError);
    }
}


// ************************************************************************* //
