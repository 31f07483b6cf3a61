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
#include "meshToParticles.H"

// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::wordList Foam::SPH::compressibleFlow::stateNames() const
{
    return {"rho", "rhoU", "rhoE"};
}


Foam::List<Foam::scalarField>
Foam::SPH::compressibleFlow::initialState() const
{
    const meshToParticles toParticles(particles_);
    const vectorField U(toParticles.map(U_));
    const label nDims = loopDims(particles_);

    List<scalarField> W(2 + nDims);
    W[0] = toParticles.map(T_);
    for (label d = 0; d < nDims; ++d)
    {
        W[1 + d] = U.component(particles_.space().axis(d));
    }
    W[1 + nDims] = toParticles.map(p_);
    keepJumps(W);

    for (const label v : {label(0), 1 + nDims})
    {
        if (min(W[v]) <= 0)
        {
            FatalErrorInFunction
                << "Field " << (v == 0 ? "T" : "p") << " in "
                << runTime_.timePath() << " has values that are not positive"
                << exit(FatalError);
        }
    }

    return W;
}


void Foam::SPH::compressibleFlow::keepJumps(List<scalarField>& W) const
{
    // Of a cell's value: more than smooth fields change over half a cell
    constexpr scalar jump = 0.1;

    const label nDims = loopDims(particles_);
    const labelList& cells = particles_.cells();

    forAll(cells, i)
    {
        const scalar T = T_[cells[i]];
        const scalar p = p_[cells[i]];

        if (mag(W[0][i] - T) > jump*T || mag(W[1 + nDims][i] - p) > jump*p)
        {
            W[0][i] = T;
            for (label d = 0; d < nDims; ++d)
            {
                W[1 + d][i] = U_[cells[i]][particles_.space().axis(d)];
            }
            W[1 + nDims][i] = p;
        }
    }
}


Foam::volScalarField& Foam::SPH::compressibleFlow::density()
{
    return particles_.mesh().lookupObjectRef<volScalarField>("rho");
}


void Foam::SPH::compressibleFlow::mapFields()
{
    toMesh().map(velocity()(), U_);
    toMesh().map(law_->primitive(0)(), T_);
    toMesh().map(law_->primitive(1 + loopDims(particles_))(), p_);

    static_cast<compressibleStates&>(*faces_).correctDensity();
    toMesh().mapInternal(law_->conserved(0)(), density());
    phi_ = linearInterpolate(density())*volumeFlux(U_);
}


void Foam::SPH::compressibleFlow::writeFields()
{
    const label nDims = loopDims(particles_);
    const scalarField T(law_->primitive(0));
    const scalarField p(law_->primitive(1 + nDims));
    const vectorField U(velocity());

    store_.write<scalar>("T", T);
    store_.write<scalar>("p", p);
    store_.write<vector>("U", U);
    store_.write<scalar>("rho", law_->conserved(0)());
    store_.write<vector>("rhoU", momentum());
    store_.write<scalar>("rhoE", law_->conserved(1 + nDims)());

    writeMapped(U_);
    writeMapped(T_);
    writeMapped(p_);
    writeMapped(density());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::compressibleFlow::compressibleFlow
(
    sphTime& runTime,
    const sphMesh& particles
)
:
    flowSolver(runTime, particles),
    tU_(readField<volVectorField>("U", dimVelocity)),
    tT_(readField<volScalarField>("T", dimTemperature)),
    tp_(readField<volScalarField>("p", dimPressure)),
    U_(tU_.ref()),
    T_(tT_.ref()),
    p_(tp_.ref()),
    phi_
    (
        IOobject("phi", runTime.timeName(), particles.mesh()),
        particles.mesh(),
        dimensionedScalar(dimMass/dimTime, Zero)
    ),
    fluid_(readFluid())
{
    Info<< "Perfect gas: gamma " << fluid_.gamma << ", R " << fluid_.R
        << " J/(kg K), " << (fluid_.viscous() ? "viscous" : "inviscid")
        << nl << endl;

    faces_.reset
    (
        new compressibleStates(particles, U_, T_, p_, phi_, fluid_)
    );
    law_ = conservationLaw::New(schemes_, fluid_, *faces_);

    setStart();
}


// ************************************************************************* //
