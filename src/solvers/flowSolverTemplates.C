/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "flowSolver.H"

// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

template<class Type>
Foam::IOobject Foam::SPH::flowSolver::fieldIO(const word& name) const
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;

    IOobject io
    (
        name,
        runTime_.timeName(),
        particles_.mesh(),
        IOobject::MUST_READ,
        IOobject::AUTO_WRITE
    );

    if (!io.typeHeaderOk<fieldType>(true))
    {
        FatalErrorInFunction
            << "No field " << name << " of type " << fieldType::typeName
            << " in " << runTime_.timePath() << ". Give it there; for"
            << " particles, in the FVM case before sphMesh" << exit(FatalError);
    }

    return io;
}


template<class Type>
void Foam::SPH::flowSolver::checkDimensions
(
    const GeometricField<Type, fvPatchField, volMesh>& field,
    const dimensionSet& dimensions
)
{
    if (field.dimensions() != dimensions)
    {
        FatalErrorInFunction
            << "Field " << field.name() << " in " << field.objectPath()
            << " has dimensions " << field.dimensions() << ", but "
            << dimensions << " are required" << exit(FatalError);
    }
}


template<class Type>
Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>
Foam::SPH::flowSolver::stateField
(
    const word& name,
    const dimensionSet& dimensions
) const
{
    return GeometricField<Type, fvPatchField, volMesh>
    (
        IOobject
        (
            name,
            runTime_.timeName(),
            particles_.mesh(),
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        particles_.mesh(),
        dimensioned<Type>(dimensions, Zero)
    );
}


// ************************************************************************* //
