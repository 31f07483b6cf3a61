/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "flowSolver.H"

// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

template<class GeoField>
Foam::tmp<GeoField> Foam::SPH::flowSolver::readField
(
    const word& name,
    const dimensionSet& dimensions
) const
{
    const fvMesh& mesh = particles_.mesh();

    for (const word& file : {word(name + ".sph"), name})
    {
        IOobject io(file, runTime_.timeName(), mesh, IOobject::MUST_READ);

        if (io.typeHeaderOk<GeoField>(true))
        {
            io.registerObject() = false;
            const GeoField stored(io, mesh);

            if (stored.dimensions() != dimensions)
            {
                FatalErrorInFunction
                    << "Field " << name << " in " << io.objectPath()
                    << " has dimensions " << stored.dimensions() << ", but "
                    << dimensions << " are required" << exit(FatalError);
            }

            return tmp<GeoField>::New
            (
                IOobject(name, runTime_.timeName(), mesh),
                stored
            );
        }
    }

    FatalErrorInFunction
        << "No field " << name << " of type " << GeoField::typeName
        << " in " << runTime_.timePath() << ": neither file " << name
        << ".sph nor file " << name << " is there" << exit(FatalError);

    return nullptr;
}


template<class Type>
void Foam::SPH::flowSolver::writeMapped
(
    const GeometricField<Type, fvPatchField, volMesh>& field
) const
{
    const GeometricField<Type, fvPatchField, volMesh> mapped
    (
        IOobject
        (
            field.name() + ".sph",
            runTime_.timeName(),
            particles_.mesh(),
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        field
    );

    if (!mapped.write())
    {
        FatalErrorInFunction
            << "Cannot write " << mapped.objectPath() << exit(FatalError);
    }
}


// ************************************************************************* //
