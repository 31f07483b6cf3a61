/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    Sleeping particles at the start and in the files of a run.

\*---------------------------------------------------------------------------*/

#include "flowSolver.H"
#include "volFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::IOobject Foam::SPH::flowSolver::awakeIO() const
{
    return IOobject
    (
        "awake",
        runTime_.timeName(),
        particles_.mesh(),
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
}


void Foam::SPH::flowSolver::startSleeping(const bool continues)
{
    if (!continues)
    {
        law_->startSleeping();
    }
    else if (awakeIO().typeHeaderOk<volScalarField>(true))
    {
        law_->startSleeping
        (
            volScalarField(awakeIO(), particles_.mesh()).primitiveField()
        );
    }
}


void Foam::SPH::flowSolver::writeAwake() const
{
    if (!law_->anyAsleep())
    {
        return;
    }

    IOobject io(awakeIO());
    io.readOpt() = IOobject::NO_READ;

    volScalarField field
    (
        io, particles_.mesh(), dimensionedScalar(dimless, Zero)
    );
    field.primitiveFieldRef() = law_->awake();
    field.write();
}


// ************************************************************************* //
