/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleGenerator.H"
#include "fluidDensity.H"
#include "gradedStart.H"
#include "latticeStart.H"
#include "particleRepair.H"
#include "relaxation.H"
#include "spaceFillingCurve.H"
#include "Random.H"
#include "UIndirectList.H"
#include "cpuTime.H"

#include <unistd.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    template<class Type>
    static List<Type> reordered(const UList<Type>& list, const labelList& order)
    {
        return List<Type>(UIndirectList<Type>(list, order));
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::particleGenerator::readJitter(const dictionary& dict)
{
    if (!dict.isDict("lattice"))
    {
        return;
    }

    const dictionary& lattice = dict.subDict("lattice");
    jitter_ = lattice.getOrDefault<scalar>("jitter", 0);
    seed_ = lattice.getOrDefault<label>("seed", 1);

    if (jitter_ < 0 || jitter_ > 0.5)
    {
        FatalIOErrorInFunction(lattice)
            << "jitter " << jitter_ << " is outside the range 0 to 0.5"
            << exit(FatalIOError);
    }
}


void Foam::SPH::particleGenerator::displace
(
    List<vector>& points,
    scalarField& phi,
    const scalarList& spacing
) const
{
    Random random(seed_);

    forAll(points, i)
    {
        vector shift(Zero);
        for (label d = 0; d < domain_.nDims(); ++d)
        {
            shift[d] = jitter_*spacing[i]*(2*random.sample01<scalar>() - 1);
        }
        points[i] += shift;
        phi[i] += mag(shift);
    }
}


Foam::SPH::particleSet Foam::SPH::particleGenerator::extract
(
    const particleSystem& particles,
    const label bodyi
) const
{
    DynamicList<point> points;
    DynamicList<scalar> spacing;
    for (label i = 0; i < particles.nParticles(); ++i)
    {
        if (particles.role[i] == bodyi)
        {
            points.append(domain_.space.position(particles.position(i)));
            spacing.append(particles.spacing[i]);
        }
    }

    particleSet set;
    set.name = domain_.bodies[bodyi].name;
    set.smoothingRatio = domain_.bodies[bodyi].smoothingRatio;
    set.points.transfer(points);
    set.spacing.transfer(spacing);

    return set;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::particleGenerator::particleGenerator
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    dict_(dict),
    domain_(mesh, dict),
    method_
    (
        relaxationMethod::New(dict.subOrEmptyDict("relaxation"), domain_)
    )
{
    readJitter(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::SPH::particleGenerator::particleBytes() const
{
    // Measured: positions, lists of some 20 or 70 neighbours, areas
    return domain_.nDims() == 3 ? 6200 : 3000;
}


void Foam::SPH::particleGenerator::checkMemory() const
{
    const scalar dp = domain_.maxSpacing();
    const scalar least =
        domain_.fluidVolume/domain_.volume(dp)*particleBytes();
    const scalar memory =
        scalar(sysconf(_SC_PHYS_PAGES))*sysconf(_SC_PAGE_SIZE);

    if (least > memory)
    {
        FatalIOErrorInFunction(dict_)
            << "The spacing " << dp << " m gives "
            << least/particleBytes() << " particles, which need "
            << label(least/1073741824) << " GiB of memory; this machine has "
            << label(memory/1073741824) << ". Is the mesh, of span "
            << domain_.high - domain_.low << ", in metres?"
            << exit(FatalIOError);
    }
}


void Foam::SPH::particleGenerator::estimate(Ostream& os) const
{
    scalar n = 0;
    scalar nMoving = 0;
    label nCells = 0;
    scalar dp = domain_.minSpacing;

    if (domain_.uniform())
    {
        const latticeStart lattice(domain_, domain_.pattern);
        dp = lattice.spacing();
        nCells = lattice.nNearCells();
        n = domain_.fluidVolume/domain_.volume(dp);

        // A lattice comes to rest far from surfaces
        nMoving = min(n, scalar(nCells));
    }
    else
    {
        const gradedStart cells(domain_, domain_.maxSpacing());
        nCells = cells.nCells();
        n = nMoving = cells.nFluidParticles();
    }

    const bool is3D = domain_.nDims() == 3;

    // Per particle, measured: closing and writing, and the whole relaxation
    const scalar seconds =
        n*(is3D ? 4e-4 : 1e-4) + nMoving*(is3D ? 1.5e-3 : 4e-4);

    os  << "Particles, about: " << label(round(n)) << nl
        << "Least spacing: " << dp << " m" << nl
        << "Cells of the background grid: " << nCells << nl
        << "Memory, about: " << label(n*particleBytes()/1048576) + 1 << " MiB"
        << nl
        << "Time on one core, about: " << label(seconds) + 1 << " s" << nl
        << endl;
}


Foam::SPH::particleStart Foam::SPH::particleGenerator::makeStart()
{
    const staticSupport support
    (
        domain_,
        domain_.pattern,
        method_->sharedInterfaces()
    );

    particleStart start;
    if (domain_.uniform())
    {
        const latticeStart lattice(domain_, domain_.pattern);
        lattice.generate(support, start);
        domain_.minSpacing = lattice.spacing();
    }
    else
    {
        gradedStart(domain_, domain_.maxSpacing()).generate(support, start);
    }

    return start;
}


void Foam::SPH::particleGenerator::relaxAndRepair(particleSystem& particles)
{
    const label maxRepairs = 5;

    particleRepair repair(domain_, particles);

    for (label round = 0; ; ++round)
    {
        relaxation relaxed(domain_, *method_, particles);
        relaxed.run(*monitor_);
        nParticleIterations_ += relaxed.nParticleIterations();

        if (repair.check())
        {
            return;
        }
        if (!method_->repair())
        {
            Info<< "Left as relaxed: ";
            repair.report(Info);
            return;
        }
        // Repairs are for a few particles of a set that comes to rest
        if (round == maxRepairs || monitor_->disturbed())
        {
            repair.fail();
        }
        Info<< "Repaired: ";
        repair.report(Info);
        repair.repair();
    }
}


void Foam::SPH::particleGenerator::generate()
{
    Info<< "Particles before relaxation" << endl;
    const particleStart start(makeStart());

    const labelList order
    (
        spaceFillingOrder(start.points, domain_.minSpacing)
    );
    List<vector> points(reordered(start.points, order));
    scalarField phi(reordered(start.phi, order));
    const scalarList spacing(reordered(start.spacing, order));
    if (jitter_ > 0)
    {
        displace(points, phi, spacing);
    }

    particleSystem particles
    (
        domain_.nDims(),
        domain_.bodies.size(),
        domain_.translations
    );
    particles.setParticles
    (
        points,
        spacing,
        reordered(start.body, order),
        phi,
        jitter_ > 0
      ? boolList(order.size(), false)
      : boolList(reordered(start.regular, order))
    );
    particles.setFixedPoints
    (
        start.fixedPoints,
        start.fixedSpacing,
        start.fixedVolume,
        start.fixedBody
    );

    Info<< "    particles: " << particles.nParticles()
        << "  least spacing: " << min(spacing) << nl << nl
        << "Relaxation, "
        << relaxationMethod::typeOf(dict_.subOrEmptyDict("relaxation"))
        << endl;

    monitor_.reset
    (
        new convergenceMonitor
        (
            method_->tolerance(),
            method_->rmsTolerance(),
            method_->logInterval()
        )
    );
    const cpuTime clock;
    relaxAndRepair(particles);
    const scalar seconds = clock.elapsedCpuTime();
    Info<< "Kinetic energy of the first layer at first: "
        << monitor_->firstEnergy() << nl
        << "Relaxed in " << monitor_->history().size() << " iterations, "
        << nParticleIterations_ << " particle iterations, "
        << seconds << " s CPU, "
        << 1e6*seconds/max(nParticleIterations_, scalar(1))
        << " us per particle iteration" << endl;
    const auto& history = monitor_->history();
    if
    (
        history.size() && history.size() >= method_->maxIterations()
     && !monitor_->converged()
    )
    {
        WarningInFunction
            << "The particles are not at rest after maxIterations "
            << method_->maxIterations() << ": largest residual "
            << history.last().maxResidual << ", rms "
            << history.last().rmsResidual << ". See what checkSphMesh says of"
            << " them" << endl;
    }

    fluid_ = extract(particles, 0);
    fluid_.density = fluidDensity(domain_, *method_, particles);
    Info<< "Densities from " << min(fluid_.density) << " to "
        << max(fluid_.density) << endl;
    if (filesCutMesh())
    {
        fluid_.volume = domain_.fluidVolume*domain_.space.thickness();
    }
    solids_.setSize(domain_.bodies.size() - 1);
    forAll(solids_, solidi)
    {
        solids_[solidi] = extract(particles, solidi + 1);
    }
    Info<< endl;
}


// ************************************************************************* //
