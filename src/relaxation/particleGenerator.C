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
#include "periodicImages.H"
#include "particleRepair.H"
#include "relaxation.H"
#include "separateNoBooleanRelaxation.H"
#include "spaceFillingCurve.H"
#include "volFields.H"
#include "OSspecific.H"
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

void Foam::SPH::particleGenerator::readLattice()
{
    word type("square");

    if (dict_.isDict("lattice"))
    {
        const dictionary& dict = dict_.subDict("lattice");
        type = dict.getOrDefault<word>("type", type);
        jitter_ = dict.getOrDefault<scalar>("jitter", 0);
        seed_ = dict.getOrDefault<label>("seed", 1);

        if (jitter_ < 0 || jitter_ > 0.5)
        {
            FatalIOErrorInFunction(dict)
                << "jitter " << jitter_ << " is outside the range 0 to 0.5"
                << exit(FatalIOError);
        }
    }
    else
    {
        type = dict_.getOrDefault<word>("lattice", type);
    }

    if (!latticePattern::patternTypeNames.found(type))
    {
        FatalIOErrorInFunction(dict_)
            << "Unknown lattice '" << type << "'. Valid lattices: "
            << latticePattern::patternTypeNames.sortedToc()
            << exit(FatalIOError);
    }

    pattern_.reset
    (
        new latticePattern
        (
            latticePattern::patternTypeNames[type],
            space_.nDims()
        )
    );
}


void Foam::SPH::particleGenerator::setDomain()
{
    const boundBox box(mesh_.bounds());
    domain_.low = space_.toLocal(box.min());
    domain_.high = space_.toLocal(box.max());
    domain_.fluidVolume = gSum(mesh_.V())/space_.thickness();
    domain_.minSpacing = spacing_->min();
    domain_.wallDistance = pattern_->wallDistance();

    for (label d = 0; d < space_.nDims(); ++d)
    {
        const scalar width = domain_.high[d] - domain_.low[d];
        if (spacing_->min() > width)
        {
            FatalIOErrorInFunction(dict_)
                << "The spacing " << spacing_->min()
                << " is larger than the width " << width
                << " of the fluid: reduce the entry spacing"
                << exit(FatalIOError);
        }
    }

    for (const vector& period : periodicTranslations(mesh_))
    {
        // From the low side to the high one, whichever patch comes first
        const vector T(space_.toLocal(period));
        const bool falls = (T & (domain_.high - domain_.low)) < 0;
        domain_.translations.append(falls ? -T : T);
    }
    if (!spacing_->uniform())
    {
        domain_.spacing = [this](const point& p) { return (*spacing_)(p); };
    }

    region_.reset
    (
        new fluidRegion
        (
            surface_,
            bodies_,
            4*kernel_->support(spacing_->max())
        )
    );
    const scalar overlap = region_->overlap(spacing_->min());
    domain_.fluidVolume -= overlap;
    filesCutMesh_ = overlap > 0;

    const scalar ratio = kernel_->smoothingRatio();
    domain_.bodies.append
    ({
        "fluid",
        region_->bounded() ? &region_->distance() : nullptr,
        ratio
    });
    for (const solidBody& body : bodies_)
    {
        domain_.bodies.append
        ({
            body.name(), &body.distance(), body.smoothingRatio()
        });
    }

    const dictionary relaxation(dict_.subOrEmptyDict("relaxation"));
    if
    (
        relaxationMethod::typeOf(relaxation)
     == separateNoBooleanRelaxation::typeName
    )
    {
        for (relaxationDomain::body& body : domain_.bodies)
        {
            if (body.surface)
            {
                grids_.append
                (
                    new levelSetGrid
                    (
                        *body.surface,
                        space_,
                        spacing_->min(),
                        2*kernel_->support(spacing_->min())
                    )
                );
                body.surface = &grids_.last();
            }
        }
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
            points.append(space_.position(particles.position(i)));
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
    mesh_(mesh),
    dict_(dict),
    space_(mesh),
    kernel_(kernel::New(dict.subOrEmptyDict("kernel"), space_.nDims())),
    surface_(mesh, space_),
    spacing_(spacingFunction::New(surface_, dict_)),
    bodies_(surface_, dict_, kernel_->smoothingRatio()),
    domain_{space_, *kernel_, Zero, Zero, {}, 0, {}, 0, 0.5, {}}
{
    readLattice();
    bodies_.checkSize(*spacing_);
    setDomain();
    method_ = relaxationMethod::New
    (
        dict_.subOrEmptyDict("relaxation"),
        domain_
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::SPH::particleGenerator::particleBytes() const
{
    // Measured: positions, lists of some 20 or 70 neighbours, areas
    return space_.nDims() == 3 ? 6200 : 3000;
}


void Foam::SPH::particleGenerator::checkMemory() const
{
    const scalar least =
        domain_.fluidVolume/domain_.volume(spacing_->max())*particleBytes();
    const scalar memory =
        scalar(sysconf(_SC_PHYS_PAGES))*sysconf(_SC_PAGE_SIZE);

    if (least > memory)
    {
        FatalIOErrorInFunction(dict_)
            << "The spacing " << spacing_->max() << " m gives "
            << least/particleBytes() << " particles, which need "
            << label(least/1073741824) << " GiB of memory; this machine has "
            << label(memory/1073741824) << ". Is the mesh, of bounds "
            << mesh_.bounds() << ", in metres?" << exit(FatalIOError);
    }
}


void Foam::SPH::particleGenerator::estimate(Ostream& os) const
{
    scalar n = 0;
    scalar nMoving = 0;
    label nCells = 0;
    scalar dp = spacing_->min();

    if (domain_.uniform())
    {
        const latticeStart lattice(domain_, *pattern_);
        dp = lattice.spacing();
        nCells = lattice.nNearCells();
        n = domain_.fluidVolume/domain_.volume(dp);

        // A lattice comes to rest far from surfaces
        nMoving = min(n, scalar(nCells));
    }
    else
    {
        const gradedStart cells(domain_, spacing_->max());
        nCells = cells.nCells();
        n = nMoving = cells.nFluidParticles();
    }

    const bool is3D = space_.nDims() == 3;

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
        *pattern_,
        method_->sharedInterfaces()
    );

    particleStart start;
    if (domain_.uniform())
    {
        const latticeStart lattice(domain_, *pattern_);
        lattice.generate(support, start);
        domain_.minSpacing = lattice.spacing();
    }
    else
    {
        gradedStart(domain_, spacing_->max()).generate(support, start);
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
    if (jitter_ > 0)
    {
        Random random(seed_);
        forAll(points, i)
        {
            vector shift(Zero);
            for (label d = 0; d < space_.nDims(); ++d)
            {
                shift[d] =
                    jitter_*start.spacing[order[i]]
                   *(2*random.sample01<scalar>() - 1);
            }
            points[i] += shift;
            phi[i] += mag(shift);
        }
    }

    particleSystem particles
    (
        space_.nDims(),
        domain_.bodies.size(),
        domain_.translations
    );
    particles.setParticles
    (
        points,
        reordered(start.spacing, order),
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
        << "  least spacing: " << min(start.spacing) << nl << nl
        << "Relaxation, " << method_->type() << endl;

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

    const fileName directory
    (
        mesh_.time().path()/"postProcessing"/"sphMesh"
    );
    mkDir(directory);
    monitor_->write(directory/"convergence.csv");

    fluid_ = extract(particles, 0);
    fluid_.density = fluidDensity(domain_, *method_, particles);
    Info<< "Densities from " << min(fluid_.density) << " to "
        << max(fluid_.density) << endl;
    if (filesCutMesh_)
    {
        fluid_.volume = domain_.fluidVolume*space_.thickness();
    }
    solids_.setSize(domain_.bodies.size() - 1);
    forAll(solids_, solidi)
    {
        solids_[solidi] = extract(particles, solidi + 1);
    }
    Info<< endl;
}


// ************************************************************************* //
