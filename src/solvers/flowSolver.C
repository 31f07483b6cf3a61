/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "flowSolver.H"
#include "OSspecific.H"
#include "linear.H"
#include "subCycleTime.H"

#include <omp.h>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    defineTypeNameAndDebug(flowSolver, 0);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::SPH::flowSolver::stableDeltaT() const
{
    return 1/law_->stableRate(maxCo_, timeScheme_->maxDiffusion());
}


void Foam::SPH::flowSolver::step
(
    const scalar dt,
    const scalar timeLeft,
    const label nHalvings
)
{
    constexpr label maxHalvings = 8;

    label nDropped = 0;
    do
    {
        if (timeScheme_->advance(*law_, *faces_, dt, timeLeft))
        {
            faces_->follow(law_->W(), dt);
            law_->resumeReconstruction();
            return;
        }
        nDropped = law_->dropReconstruction();
        nDropped_ += nDropped;
    }
    while (nDropped);

    if (nHalvings == maxHalvings)
    {
        FatalErrorInFunction
            << "The flow diverges at time " << runTime_.timeName()
            << ": the state of a particle is not physical even with a time"
            << " step of " << dt << " s. Lower maxCo or choose a more"
            << " dissipative fluxScheme or limiter in "
            << schemes_.objectPath() << exit(FatalError);
    }

    ++nHalved_;
    step(0.5*dt, timeLeft + 0.5*dt, nHalvings + 1);
    step(0.5*dt, timeLeft, nHalvings + 1);
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::SPH::flowSolver::setStart()
{
    const wordList names(stateNames());
    const solutionSpace& space = particles_.space();

    bool stored = true;
    for (const word& name : names)
    {
        stored = stored && store_.found(name);
    }

    if (stored)
    {
        Info<< "Continuing from the particle fields of time "
            << runTime_.timeName() << nl << endl;

        List<scalarField> Q(law_->nVariables());
        Q[0] = store_.read<scalar>(names[0]);
        const vectorField momentum(store_.read<vector>(names[1]));
        for (label d = 0; d < loopDims(particles_); ++d)
        {
            Q[1 + d] = momentum.component(space.axis(d));
        }
        for (label k = 2; k < names.size(); ++k)
        {
            Q[loopDims(particles_) + k - 1] = store_.read<scalar>(names[k]);
        }
        law_->setConserved(Q);
    }
    else
    {
        Info<< "Starting from the cell fields of time "
            << runTime_.timeName() << nl << endl;

        law_->setPrimitive(initialState());
    }

    Info<< "Boundary conditions" << nl;
    faces_->info(Info);
    Info<< nl << "Schemes" << nl
        << "    threads " << omp_get_max_threads() << nl;
    law_->info(Info);
    Info<< endl;
}


Foam::tmp<Foam::vectorField> Foam::SPH::flowSolver::velocity() const
{
    auto tU = tmp<vectorField>::New(particles_.nParticles(), Zero);
    for (label d = 0; d < loopDims(particles_); ++d)
    {
        tU.ref().replace(particles_.space().axis(d), law_->primitive(1 + d));
    }
    return tU;
}


Foam::tmp<Foam::vectorField> Foam::SPH::flowSolver::momentum() const
{
    auto tmomentum = tmp<vectorField>::New(particles_.nParticles(), Zero);
    for (label d = 0; d < loopDims(particles_); ++d)
    {
        tmomentum.ref().replace
        (
            particles_.space().axis(d), law_->conserved(1 + d)
        );
    }
    return tmomentum;
}


const Foam::SPH::particlesToMesh& Foam::SPH::flowSolver::toMesh()
{
    if (!toMesh_.valid())
    {
        toMesh_.reset(new particlesToMesh(particles_));
    }
    return *toMesh_;
}


Foam::tmp<Foam::surfaceScalarField> Foam::SPH::flowSolver::volumeFlux
(
    const volVectorField& U
)
{
    return linearInterpolate(U) & U.mesh().Sf();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::flowSolver::flowSolver
(
    sphTime& runTime,
    const sphMesh& particles
)
:
    regIOobject
    (
        IOobject
        (
            typeName,
            runTime.timeName(),
            particles.mesh(),
            IOobject::NO_READ,
            IOobject::NO_WRITE
        )
    ),
    runTime_(runTime),
    particles_(particles),
    schemes_(schemesIO(runTime)),
    store_(particles),
    timeScheme_(timeScheme::New(schemes_)),
    maxCo_
    (
        schemes_.getCheckOrDefault<scalar>
        (
            "maxCo",
            timeScheme_->defaultCo(),
            [](const scalar maxCo) { return maxCo > 0; }
        )
    ),
    nDropped_(0),
    nHalved_(0)
{
    if (Pstream::parRun())
    {
        FatalErrorInFunction
            << "Parallel runs are not available yet: run without -parallel,"
            << " with one thread per core" << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::IOobject Foam::SPH::flowSolver::schemesIO(const Time& runTime)
{
    return IOobject
    (
        "sphSchemes",
        runTime.system(),
        runTime,
        IOobject::READ_IF_PRESENT,
        IOobject::NO_WRITE,
        false
    );
}


void Foam::SPH::flowSolver::setDeltaT()
{
    if (runTime_.adjusted())
    {
        runTime_.setStableDeltaT(stableDeltaT());
    }
}


void Foam::SPH::flowSolver::advance()
{
    const scalar deltaT = runTime_.deltaTValue();

    // An adjusted time step is the stable one
    const label nSteps =
        runTime_.adjusted()
      ? 1
      : max(label(1), label(std::ceil(deltaT/stableDeltaT() - 1e-6)));

    scalar largest;
    scalar mean;
    law_->acousticRate(largest, mean);

    Info<< "Courant Number mean: " << mean*deltaT/nSteps
        << " max: " << largest*deltaT/nSteps;

    if (nSteps == 1)
    {
        Info<< endl;
        step(deltaT);
    }
    else
    {
        Info<< " in " << nSteps << " steps" << endl;
        for (subCycleTime cycle(runTime_, nSteps); !(++cycle).end(); )
        {
            step(runTime_.deltaTValue());
        }
    }

    const label nFallbacks = law_->nFallbacks();
    if (nFallbacks || nDropped_ || nHalved_)
    {
        Info<< "Positivity: " << nFallbacks << " reconstructions of first"
            << " order, " << nDropped_ << " particles of first order, "
            << nHalved_ << " steps halved" << endl;
        nDropped_ = 0;
        nHalved_ = 0;
    }

    runTime_.alignWriteTime();

    // Once, where both function objects and writeTime() need it
    if (runTime_.otherFunctions() || runTime_.writeTime())
    {
        mapFields();
    }
}


void Foam::SPH::flowSolver::writeTime()
{
    store_.writePositions();
    writeFields();
    store_.purge();
}


// ************************************************************************* //
