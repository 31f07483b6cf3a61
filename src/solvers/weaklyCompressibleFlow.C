/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "weaklyCompressibleFlow.H"
#include "findRefCell.H"
#include "meshToParticles.H"
#include "compat.H"
#include "scalarIOField.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::SPH::weaklyCompressibleFlow::viscosity() const
{
    // Kept in the registry, where function objects look for it
    const IOdictionary& properties = regIOobject::store
    (
        new IOdictionary
        (
            IOobject
            (
                "transportProperties",
                runTime_.constant(),
                particles_.mesh(),
                IOobject::MUST_READ,
                IOobject::NO_WRITE
            )
        )
    );

    const word model
    (
        properties.getOrDefault<word>("transportModel", "Newtonian")
    );

    if (model != "Newtonian")
    {
        FatalIOErrorInFunction(properties)
            << "transportModel " << model << " is not supported" << nl << nl
            << "Valid choices:" << nl << wordList({"Newtonian"})
            << exit(FatalIOError);
    }

    const dimensionedScalar nu("nu", dimViscosity, properties);

    if (nu.value() < 0)
    {
        FatalIOErrorInFunction(properties)
            << "nu is negative: " << nu.value() << exit(FatalIOError);
    }

    return nu.value();
}


Foam::scalar Foam::SPH::weaklyCompressibleFlow::largestVelocity() const
{
    scalar largest = gMax(mag(U_.primitiveField())());

    for (const fvPatchVectorField& Up : U_.boundaryField())
    {
        if (Up.fixesValue() && returnReduce(Up.size(), sumOp<label>()))
        {
            largest = max(largest, gMax(mag(Up)()));
        }
    }

    return largest;
}


Foam::IOobject Foam::SPH::weaklyCompressibleFlow::propertiesIO() const
{
    return IOobject
    (
        "flowProperties",
        runTime_.timeName(),
        "uniform/lagrangian/sph",
        particles_.mesh(),
        IOobject::READ_IF_PRESENT,
        IOobject::NO_WRITE,
        false
    );
}


Foam::scalar Foam::SPH::weaklyCompressibleFlow::soundSpeed() const
{
    const auto positive = [](const scalar value) { return value > 0; };

    if (schemes_.found("soundSpeed"))
    {
        return schemes_.getCheck<scalar>("soundSpeed", positive);
    }

    const IOdictionary stored(propertiesIO());
    if (stored.found("soundSpeed"))
    {
        return stored.get<scalar>("soundSpeed");
    }

    const scalar ratio =
        schemes_.getCheckOrDefault<scalar>("soundSpeedRatio", 10, positive);

    const scalar largest = largestVelocity();

    if (largest <= 0)
    {
        FatalIOErrorInFunction(schemes_)
            << "Initial and boundary velocities are all zero: give the entry"
            << " soundSpeed, ten times the largest velocity expected"
            << exit(FatalIOError);
    }

    return ratio*largest;
}


Foam::IOobject Foam::SPH::weaklyCompressibleFlow::outerStateIO() const
{
    IOobject io(propertiesIO());
    io.rename("outerState");
    return io;
}


void Foam::SPH::weaklyCompressibleFlow::setAbsorption()
{
    const scalar tau = schemes_.getCheckOrDefault<scalar>
    (
        "absorptionTime",
        cmptMax(particles_.space().toLocal(particles_.mesh().bounds().span()))
       /fluid_.c,
        [](const scalar value) { return value >= 0; }
    );

    faces_->correct(law_->W(), 0);
    faces_->startFollowing(tau, law_->W());

    const scalarIOField stored(outerStateIO());
    if (stored.size() == faces_->followed().size())
    {
        faces_->followed() = stored;
    }
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::wordList Foam::SPH::weaklyCompressibleFlow::stateNames() const
{
    return {"p", "rhoU"};
}


Foam::List<Foam::scalarField>
Foam::SPH::weaklyCompressibleFlow::initialState() const
{
    const meshToParticles toParticles(particles_);
    const vectorField U(toParticles.map(U_));

    List<scalarField> W(1 + loopDims(particles_));
    W[0] = toParticles.map(p_);
    for (label d = 0; d < loopDims(particles_); ++d)
    {
        W[1 + d] = U.component(particles_.space().axis(d));
    }
    return W;
}


void Foam::SPH::weaklyCompressibleFlow::mapFields()
{
    toMesh().map(velocity()(), U_);
    toMesh().map(law_->primitive(0)(), p_);
    phi_ = volumeFlux(U_);

    // In a closed domain the pressure level is that of FVM's reference cell
    for (const word algorithm : {"PISO", "PIMPLE", "SIMPLE"})
    {
        const dictionary controls
        (
            particles_.mesh().solutionDict().subOrEmptyDict(algorithm)
        );

        if (controls.found("pRefCell") || controls.found("pRefPoint"))
        {
            label celli = 0;
            scalar value = 0;
            if (setRefCell(p_, controls, celli, value))
            {
                p_ +=
                    dimensionedScalar
                    (
                        "shift",
                        p_.dimensions(),
                        value - getRefCellValue(p_, celli)
                    );
            }
            break;
        }
    }
}


void Foam::SPH::weaklyCompressibleFlow::writeFields()
{
    const scalarField p(law_->primitive(0));
    const vectorField U(velocity());
    const scalarField rho(1 + p/sqr(fluid_.c));

    store_.write<scalar>("p", p);
    store_.write<vector>("U", U);
    store_.write<scalar>("rho", rho);
    store_.write<vector>("rhoU", momentum());

    // A restart needs every bit, whatever the case's writePrecision is
    const unsigned precision = IOstream::defaultPrecision(17);
    IOdictionary properties(propertiesIO());
    properties.set("soundSpeed", fluid_.c);
    properties.regIOobject::write();
    IOstream::defaultPrecision(precision);

    const scalarIOField outerState(outerStateIO(), faces_->followed());
    writeAs(outerState, IOstream::BINARY);

    writeMapped(U_);
    writeMapped(p_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::weaklyCompressibleFlow::weaklyCompressibleFlow
(
    sphTime& runTime,
    const sphMesh& particles
)
:
    flowSolver(runTime, particles),
    tU_(readField<volVectorField>("U", dimVelocity)),
    tp_(readField<volScalarField>("p", sqr(dimVelocity))),
    U_(tU_.ref()),
    p_(tp_.ref()),
    phi_
    (
        IOobject("phi", runTime.timeName(), particles.mesh()),
        particles.mesh(),
        dimensionedScalar(dimVolume/dimTime, Zero)
    ),
    fluid_{soundSpeed(), viscosity()}
{
    Info<< "Sound speed " << fluid_.c << " m/s, kinematic viscosity "
        << fluid_.nu << " m^2/s" << nl << endl;

    faces_.reset
    (
        new boundaryStates(particles, U_, {{p_, 0}}, phi_, fluid_.nu > 0)
    );
    law_ = conservationLaw::New(schemes_, fluid_, *faces_);

    setStart();
    setAbsorption();
}


// ************************************************************************* //
