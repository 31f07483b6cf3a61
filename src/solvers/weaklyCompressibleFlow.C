/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "weaklyCompressibleFlow.H"
#include "linear.H"

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


Foam::scalar Foam::SPH::weaklyCompressibleFlow::soundSpeed() const
{
    const auto positive = [](const scalar value) { return value > 0; };

    if (schemes_.found("soundSpeed"))
    {
        return schemes_.getCheck<scalar>("soundSpeed", positive);
    }

    if (state_.found("soundSpeed"))
    {
        return state_.get<scalar>("soundSpeed");
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
    const scalar tau = schemes_.getCheckOrDefault<scalar>
    (
        "absorptionTime",
        cmptMax(particles_.space().toLocal(particles_.mesh().bounds().span()))
       /fluid_.c,
        [](const scalar value) { return value >= 0; }
    );

    faces_->correct(law_->W(), 0);
    faces_->startFollowing(tau, law_->W());

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
    U_.correctBoundaryConditions();
    p_.correctBoundaryConditions();

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
    flowSolver(runTime, particles),
    U_(fieldIO<vector>("U"), particles.mesh()),
    p_(fieldIO<scalar>("p"), particles.mesh()),
    rhoU_(stateField<vector>("rhoU", dimVelocity)),
    outerU_(stateField<vector>("outerU", dimVelocity)),
    outerP_(stateField<scalar>("outerP", sqr(dimVelocity))),
    phi_
    (
        IOobject("phi", runTime.timeName(), particles.mesh()),
        particles.mesh(),
        dimensionedScalar(dimVolume/dimTime, Zero)
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
    fluid_{soundSpeed(), viscosity()}
{
    checkDimensions(U_, dimVelocity);
    checkDimensions(p_, sqr(dimVelocity));
    state_.set("soundSpeed", fluid_.c);


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
