/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "flowSolver.H"
#include "particleFiles.H"
#include "unsupportedModels.H"
#include "argList.H"

#include <cstdlib>
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

bool Foam::SPH::flowSolver::sameState() const
{
    // More than round-off in the primitive variables is an edited field
    constexpr scalar tolerance = 1e-8;

    const List<scalarField> given(primitiveStart());
    forAll(given, v)
    {
        const scalarField now(law_->primitive(v));
        const scalar scale = gMax(mag(given[v])()) + gMax(mag(now)());
        if (gMax(mag(now - given[v])()) > tolerance*scale)
        {
            return false;
        }
    }
    return true;
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

bool Foam::SPH::flowSolver::hasField(const word& name) const
{
    return IOobject
    (
        name,
        runTime_.timeName(),
        particles_.mesh(),
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    ).typeHeaderOk<volScalarField>(false);
}


void Foam::SPH::flowSolver::setStart(const volVectorField& U)
{
    maxCo_ = schemes_.getCheckOrDefault<scalar>
    (
        "maxCo",
        min(maxCo_, timeScheme_->defaultCo(*law_)),
        [](const scalar maxCo) { return maxCo > 0; }
    );

    if (timeScheme_->hasLevels(*law_, maxCo_))
    {
        law_->levels().allow
        (
            schemes_.getCheckOrDefault<label>
            (
                "stepLevels", 3, [](const label n) { return n >= 0 && n <= 8; }
            )
        );
    }
    else if (schemes_.found("stepLevels"))
    {
        FatalIOErrorInFunction(schemes_)
            << "Entry stepLevels is for timeScheme Hancock with"
            << " reconstruction linear: rhoSphFoam without viscosity, by"
            << " fluxScheme Kurganov or HLLC, maxCo up to 0.4"
            << exit(FatalIOError);
    }

    const List<scalarField> conserved(conservedStart());

    bool continues = conserved.size();
    if (continues)
    {
        law_->setConserved(conserved);
        continues = sameState();
    }
    if (!continues)
    {
        law_->setPrimitive(primitiveStart());
    }
    if (momentumSources::present(runTime_))
    {
        sources_.reset(new momentumSources(U, kinematic(), *law_));
    }
    else
    {
        startSleeping(continues);
    }
    Info<< (continues ? "Continuing" : "Starting") << " from the fields of"
        << " time " << runTime_.timeName() << nl << nl
        << "Boundary conditions" << nl;
    faces_->info(Info);
    Info<< nl << "Schemes" << nl
        << "    ranks " << Pstream::nProcs() << ", threads of each "
        << omp_get_max_threads() << nl;
    law_->info(Info);
    Info<< endl;
}


void Foam::SPH::flowSolver::getVelocity(volVectorField& U)
{
    vectorField& Ui = U.primitiveFieldRef();

    sqrU_ = 0;
    sqrChange_ = 0;
    for (label d = 0; d < loopDims(particles_); ++d)
    {
        const direction axis = particles_.space().axis(d);
        const scalar* now = law_->W()[1 + d];

        forAll(Ui, i)
        {
            const scalar V = particles_.V()[i];
            sqrU_ += V*sqr(now[i]);
            sqrChange_ += V*sqr(now[i] - Ui[i][axis]);
            Ui[i][axis] = now[i];
        }
    }
}


void Foam::SPH::flowSolver::getMomentum(volVectorField& rhoU) const
{
    for (label d = 0; d < loopDims(particles_); ++d)
    {
        rhoU.primitiveFieldRef().replace
        (
            particles_.space().axis(d), law_->conserved(1 + d)
        );
    }
}


Foam::scalar Foam::SPH::flowSolver::longestSide() const
{
    return
        cmptMax(particles_.space().toLocal(particles_.mesh().bounds().span()));
}


void Foam::SPH::flowSolver::appendComponents
(
    const volVectorField& field,
    List<scalarField>& variables
) const
{
    for (label d = 0; d < loopDims(particles_); ++d)
    {
        variables.append
        (
            field.primitiveField().component(particles_.space().axis(d))()
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::flowSolver::flowSolver
(
    Time& runTime,
    const particleMesh& particles,
    const scalar accurateCo
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
    schemes_(runTime),
    timeScheme_(timeScheme::New(schemes_)),
    maxCo_(accurateCo),
    nDropped_(0),
    nHalved_(0),
    subIndex_(-1),
    longest_(0),
    volume_(gSum(particles.V())),
    sqrU_(0),
    sqrChange_(0)
{
    if
    (
        runTime.deltaTValue() <= 0
     && !runTime.controlDict().getOrDefault<Switch>("adjustTimeStep", false)
    )
    {
        FatalIOErrorInFunction(runTime.controlDict())
            << "deltaT is " << runTime.deltaTValue() << ", but must be above"
            << " zero, or adjustTimeStep yes" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

void Foam::SPH::flowSolver::addOptions()
{
    argList::addBoolOption
    (
        "cells",
        "Take the cells of any mesh as particles and its faces as pairs"
    );
    argList::addBoolOption("dry-run", "Read and check the case, and stop");
}


void Foam::SPH::flowSolver::checkCase(const argList& args, const fvMesh& mesh)
{
    if (!args.found("cells"))
    {
        particleFiles(mesh.time()).requireCurrent();
    }
    refuseUnsupportedModels(mesh.time());

    // Without a turbulence model most of them end the run, yPlus writes zeros
    leaveOutFunctionObjects
    (
        mesh.time(),
        {
            "heatTransferCoeff", "turbulenceFields", "wallHeatFlux",
            "wallShearStress", "yPlus"
        }
    );

    // The cores of a machine are the ranks' unless threads are asked for, and
    // a thread with fewer particles waits for others longer than it works
    constexpr label leastParticles = 8000;
    if (!std::getenv("OMP_NUM_THREADS"))
    {
        const label useful = max(label(1), mesh.nCells()/leastParticles);
        omp_set_num_threads
        (
            Pstream::parRun() ? 1 : min(omp_get_max_threads(), int(useful))
        );
    }
}


// ************************************************************************* //
