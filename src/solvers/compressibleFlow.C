/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "compressibleFlow.H"
#include "compressibleStates.H"
#include "linear.H"
#include "unsupportedModels.H"

// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::List<Foam::scalarField>
Foam::SPH::compressibleFlow::conservedStart() const
{
    List<scalarField> Q;
    if
    (
        hasField(rho_.name())
     && hasField(rhoU_.name())
     && hasField(rhoE_.name())
    )
    {
        Q.append(storedRho_);
        appendComponents(rhoU_, Q);
        Q.append(rhoE_.primitiveField());
    }
    return Q;
}


Foam::List<Foam::scalarField>
Foam::SPH::compressibleFlow::primitiveStart() const
{
    for (const volScalarField* field : {&T_, &p_})
    {
        if (min(field->primitiveField()) <= 0)
        {
            FatalErrorInFunction
                << "Field " << field->name() << " in " << runTime_.timePath()
                << " has values that are not positive: it is absolute, in "
                << (field == &T_ ? "K" : "Pa") << exit(FatalError);
        }
    }

    List<scalarField> W;
    W.append(T_.primitiveField());
    appendComponents(U_, W);
    W.append(p_.primitiveField());
    return W;
}


void Foam::SPH::compressibleFlow::updateFields()
{
    const label nDims = loopDims(particles_);

    getVelocity(U_);
    getMomentum(rhoU_);
    T_.primitiveFieldRef() = law_->primitive(0);
    p_.primitiveFieldRef() = law_->primitive(1 + nDims);
    rhoE_.primitiveFieldRef() = law_->conserved(1 + nDims);

    boundaryStates::evaluateVelocity(U_);
    T_.correctBoundaryConditions();
    p_.correctBoundaryConditions();
    static_cast<compressibleStates&>(*faces_).correctDensity();
    rho_.primitiveFieldRef() = law_->conserved(0);

    if (runTime_.writeTime() || runTime_.functionObjects().size())
    {
        phi_ =
            linearInterpolate(rho_)
           *(linearInterpolate(U_) & particles_.mesh().Sf());
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::compressibleFlow::compressibleFlow
(
    Time& runTime,
    const particleMesh& particles
)
:
    // Shocks and waves that move need steps of half what is stable
    flowSolver(runTime, particles, 0.5),
    U_(fieldIO<vector>("U"), particles.mesh()),
    T_(fieldIO<scalar>("T"), particles.mesh()),
    p_(fieldIO<scalar>("p"), particles.mesh()),
    rho_(stateField<scalar>("rho", dimDensity)),
    rhoU_(stateField<vector>("rhoU", dimDensity*dimVelocity)),
    rhoE_(stateField<scalar>("rhoE", dimPressure)),
    storedRho_(rho_.primitiveField()),
    phi_
    (
        IOobject("phi", runTime.timeName(), particles.mesh()),
        particles.mesh(),
        dimensionedScalar(dimMass/dimTime, Zero)
    ),
    fluid_(readFluid())
{
    // Those of kinematic pressure find a viscosity in transportProperties
    leaveOutFunctionObjects
    (
        runTime,
        {"forces", "forceCoeffs"},
        ": sphForces and sphForceCoeffs write the same"
    );

    checkDimensions(U_, dimVelocity);
    checkDimensions(T_, dimTemperature);
    checkDimensions(p_, dimPressure);

    Info<< "Perfect gas: gamma " << fluid_.gamma << ", R " << fluid_.R
        << " J/(kg K), " << (fluid_.viscous() ? "viscous" : "inviscid")
        << nl << endl;

    faces_.reset
    (
        new compressibleStates(particles, U_, T_, p_, rho_, phi_, fluid_)
    );
    law_ = conservationLaw::New(schemes_, fluid_, *faces_);

    setStart(U_);
    storedRho_.clear();
}


// ************************************************************************* //
