/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "weaklyCompressibleFlow.H"
#include "checkEntries.H"
#include "incompressibleStart.H"
#include "linear.H"
#include "basicSymmetryFvPatchFields.H"
#include "wallFvPatch.H"

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

    // OpenFOAM aborts on wrong dimensions, and does not name the entry if there
    // is no number
    scalar nu = -1;
    const bool throwing = FatalIOError.throwExceptions();
    try
    {
        nu = dimensionedScalar("nu", dimViscosity, properties).value();
    }
    catch (const IOerror&)
    {}
    FatalIOError.throwExceptions(throwing);

    if (nu < 0)
    {
        FatalIOErrorInFunction(properties)
            << "Entry nu must be a number that is not negative, with the"
            << " dimensions " << dimViscosity << " or none"
            << exit(FatalIOError);
    }

    return nu;
}


Foam::scalar Foam::SPH::weaklyCompressibleFlow::velocityScale
(
    const scalar nu
) const
{
    const scalar U = drive_.velocity(longestSide());

    scalar wallArea = 0;
    for (const fvPatch& patch : particles_.mesh().boundary())
    {
        if
        (
            isA<wallFvPatch>(patch)
         && boundaryStates::givesVelocity(U_.boundaryField()[patch.index()])
        )
        {
            wallArea += gSum(patch.magSf());
        }
    }

    // Loss of pressure along a channel of two walls with gap h = 2 V/A:
    // 12 nu U L/h^2
    const scalar wallPerVolume = wallArea/gSum(particles_.mesh().V());
    const scalar loss = 3*nu*U*longestSide()*sqr(wallPerVolume);

    return max(U, sqrt(loss));
}


Foam::scalar Foam::SPH::weaklyCompressibleFlow::soundSpeed
(
    const scalar nu
) const
{
    const auto positive = [](const scalar value) { return value > 0; };

    if (schemes_.found("soundSpeed"))
    {
        return schemes_.getCheck<scalar>("soundSpeed", positive);
    }

    const scalar ratio =
        schemes_.getCheckOrDefault<scalar>("soundSpeedRatio", 10, positive);

    if (state_.found("velocityScale"))
    {
        return ratio*state_.get<scalar>("velocityScale");
    }

    const scalar scale = velocityScale(nu);

    if (scale <= 0)
    {
        FatalIOErrorInFunction(schemes_)
            << "Initial and boundary values have neither a velocity nor a"
            << " difference of pressures: give the entry soundSpeed, ten times"
            << " the largest velocity expected" << exit(FatalIOError);
    }

    return ratio*scale;
}


void Foam::SPH::weaklyCompressibleFlow::remember
(
    const word& name,
    const scalar value
)
{
    // A dictionary keeps no more digits than it would write
    const unsigned precision = IOstream::defaultPrecision(17);
    state_.set(name, value);
    IOstream::defaultPrecision(precision);
}


Foam::SPH::weaklyCompressibleFluid
Foam::SPH::weaklyCompressibleFlow::readFluid()
{
    const scalar nu = viscosity();
    const scalar c = soundSpeed(nu);
    const scalar ratio = schemes_.getOrDefault<scalar>("soundSpeedRatio", 10);
    remember("velocityScale", c/ratio);

    const bool constant =
        checkedWord(schemes_, "density", "constant", {"constant", "variable"})
     == "constant";
    const scalar damping = schemes_.getCheckOrDefault<scalar>
    (
        "soundDamping", 0.25, [](const scalar value) { return value >= 0; }
    );

    // First order is [B]'s as it is
    const bool linear =
        schemes_.getOrDefault<word>("reconstruction", "linear") == "linear";

    return {c, nu, constant ? 0 : 1/sqr(c), damping, linear ? 0.25 : 0};
}


void Foam::SPH::weaklyCompressibleFlow::startBoundaries()
{
    for (fvPatchVectorField& Up : U_.boundaryFieldRef())
    {
        if (boundaryStates::givesVelocity(Up))
        {
            Up.evaluate();
        }
    }

    // Those of a free stream divide by the velocity: by that of the file, as
    // for FVM, since the fluid may be at rest
    boundaryStates::evaluatePressure(p_);
    boundaryStates::evaluateVelocity(U_);
}


void Foam::SPH::weaklyCompressibleFlow::checkFluxes() const
{
    scalar net = 0;
    scalar total = 0;
    scalar scale = 0;
    for (const fvPatchVectorField& Up : U_.boundaryField())
    {
        const label patchi = Up.patch().index();
        const bool coupledOrEmpty =
            Up.coupled() || !returnReduce(Up.size(), sumOp<label>());
        if (coupledOrEmpty || isA<basicSymmetryFvPatchField<vector>>(Up))
        {
            continue;
        }
        if (p_.boundaryField()[patchi].fixesValue() || !Up.fixesValue())
        {
            return;
        }
        const scalarField flux(Up & Up.patch().Sf());
        net += gSum(flux);
        total += gSum(mag(flux)());

        // Along walls fluxes are round-off themselves
        scale += gSum((mag(Up)*Up.patch().magSf())());
    }

    constexpr scalar roundOff = 1e-6;
    if (mag(net) > roundOff*scale)
    {
        FatalErrorInFunction
            << "Velocities are given on all boundaries, but " << net
            << " m^3/s flow out in all, of " << total << " m^3/s through them,"
            << " and no patch fixes " << p_.name() << ". Check " << U_.name()
            << " in " << runTime_.timePath() << exit(FatalError);
    }
}


void Foam::SPH::weaklyCompressibleFlow::checkOpen() const
{
    for (const particlePatch& patch : particles_.boundary())
    {
        const fvPatchVectorField& Up = U_.boundaryField()[patch.index()];
        const fvPatchScalarField& pp = p_.boundaryField()[patch.index()];
        if
        (
            !patch.size() || faces_->reflects(patch.start())
         || pp.fixesValue() || boundaryStates::givesVelocity(Up)
        )
        {
            continue;
        }
        if (boundaryStates::isStream(Up))
        {
            WarningInFunction
                << "Patch " << patch.name() << " gives no " << p_.name()
                << " where the flow leaves: there it leaves with the velocity"
                << " of the free stream. With " << p_.name()
                << " of the type freestreamPressure it is free" << nl << endl;
        }
        else
        {
            FatalErrorInFunction
                << "Patch " << patch.name() << " gives neither " << U_.name()
                << " (" << Up.type() << ") nor " << p_.name() << " ("
                << pp.type() << ") where the flow leaves, in "
                << runTime_.timePath() << ": nothing would hold the flow."
                << " Valid choices: a condition of " << p_.name()
                << " that gives values, as fixedValue, or one of "
                << U_.name() << ", as fixedValue or freestream"
                << exit(FatalError);
        }
    }
}


void Foam::SPH::weaklyCompressibleFlow::warnOfCompression()
{
    constexpr scalar largestMach = 0.3;
    constexpr scalar largestVariation = 0.05;

    if (warned_)
    {
        return;
    }

    const scalar Mach = gMax(mag(U_.primitiveField())())/fluid_.c;
    const scalar variation =
    (
        fluid_.densitySlope > 0
      ? gMax(mag(p_.primitiveField())())
      : gMinMax(p_.primitiveField()).span()
    )/sqr(fluid_.c);

    if (Mach > largestMach || variation > largestVariation)
    {
        warned_ = true;
        WarningInFunction
            << "The flow is compressed: Mach number " << Mach
            << ", density off by " << variation << " at time "
            << runTime_.timeName() << ". Raise soundSpeedRatio in "
            << schemes_.objectPath() << nl << endl;
    }
}


void Foam::SPH::weaklyCompressibleFlow::exchangeOuterStates
(
    const bool toFields
)
{
    scalarField& followed = faces_->followed();
    const label nFaces = faces_->size();

    for (const particlePatch& patch : particles_.boundary())
    {
        if (patch.size() == 0 || faces_->reflects(patch.start()))
        {
            continue;
        }

        vectorField& U = outerU_.boundaryFieldRef()[patch.index()];
        scalarField& p = outerP_.boundaryFieldRef()[patch.index()];
        const labelUList face(patch.face());

        forAll(face, k)
        {
            const auto exchange = [&](const label variable, scalar& value)
            {
                scalar& own =
                    followed[variable*nFaces + patch.start() + k];
                (toFields ? value : own) = (toFields ? own : value);
            };

            exchange(0, p[face[k]]);
            for (label d = 0; d < loopDims(particles_); ++d)
            {
                exchange(1 + d, U[face[k]][particles_.space().axis(d)]);
            }
        }
    }
}


void Foam::SPH::weaklyCompressibleFlow::setAbsorption()
{
    // What follows slowly has inertia, as if the domain were longer, which
    // keeps pressures from driving the flow, 12 % in a channel started so, and
    // lags behind velocities that change: pressures are off by what
    // accelerates the domain
    constexpr scalar largestLag = 0.1;

    const scalar passage = longestSide()/fluid_.c;
    const bool absorbs =
        drive_.through() > 0
     && passage*drive_.frequency() < largestLag
     && longestSide()*drive_.acceleration() < largestLag*sqr(drive_.through());

    const scalar tau = schemes_.getCheckOrDefault<scalar>
    (
        "absorptionTime",
        state_.getOrDefault<scalar>("absorptionTime", absorbs ? passage : 0),
        [](const scalar value) { return value >= 0; }
    );
    remember("absorptionTime", tau);

    faces_->correct(law_->W(), 0);
    faces_->startFollowing(tau, fluid_.c, law_->W());

    exchangeOuterStates(!hasField(outerP_.name()) || !hasField(outerU_.name()));
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::List<Foam::scalarField>
Foam::SPH::weaklyCompressibleFlow::conservedStart() const
{
    List<scalarField> Q;
    if (hasField(rhoU_.name()))
    {
        Q.append(p_.primitiveField());
        appendComponents(rhoU_, Q);
    }
    return Q;
}


Foam::List<Foam::scalarField>
Foam::SPH::weaklyCompressibleFlow::primitiveStart() const
{
    List<scalarField> W;
    W.append(p_.primitiveField());
    appendComponents(U_, W);
    return W;
}


void Foam::SPH::weaklyCompressibleFlow::updateFields()
{
    getVelocity(U_);
    getMomentum(rhoU_);
    p_.primitiveFieldRef() = law_->primitive(0);
    boundaryStates::evaluateVelocity(U_);
    boundaryStates::evaluatePressure(p_);
    warnOfCompression();

    if (runTime_.writeTime() || runTime_.functionObjects().size())
    {
        phi_ = linearInterpolate(U_) & particles_.mesh().Sf();
    }
    exchangeOuterStates(true);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::weaklyCompressibleFlow::weaklyCompressibleFlow
(
    Time& runTime,
    const particleMesh& particles
)
:
    flowSolver(runTime, particles, 1),
    U_(fieldIO<vector>("U"), particles.mesh()),
    p_(fieldIO<scalar>("p"), particles.mesh()),
    rhoU_(stateField<vector>("rhoU", dimVelocity)),
    outerU_(stateField<vector>("outerU", dimVelocity)),
    outerP_(stateField<scalar>("outerP", sqr(dimVelocity))),
    phi_
    (
        IOobject("phi", runTime.timeName(), particles.mesh()),
        linearInterpolate(U_) & particles.mesh().Sf()
    ),
    state_
    (
        IOobject
        (
            "flowProperties",
            runTime.timeName(),
            "uniform",
            particles.mesh(),
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    ),
    drive_(U_, p_),
    fluid_(readFluid()),
    warned_(false)
{
    checkDimensions(U_, dimVelocity);
    checkDimensions(p_, sqr(dimVelocity));

    const bool starts = conservedStart().empty();
    if (starts)
    {
        startBoundaries();
    }
    checkFluxes();

    Info<< "Sound speed " << fluid_.c << " m/s, kinematic viscosity "
        << fluid_.nu << " m^2/s" << nl << endl;

    faces_.reset
    (
        new boundaryStates(particles, U_, {{p_, 0}}, phi_, fluid_.nu > 0)
    );
    checkOpen();
    law_ = conservationLaw::New(schemes_, fluid_, *faces_);

    if (starts && schemes_.getOrDefault<Switch>("projectStart", true))
    {
        incompressibleStart(U_, p_);
    }
    setStart(U_);
    setAbsorption();
}


// ************************************************************************* //
