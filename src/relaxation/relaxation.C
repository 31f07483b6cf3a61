/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "relaxation.H"
#include "kernelSums.H"
#include "latticePattern.H"
#include "IOstreams.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::relaxation::resetList()
{
    if (!domain_.uniform())
    {
        for (const DynamicList<label>& targets : targets_)
        {
            #pragma omp parallel for schedule(dynamic, 256)
            for (label t = 0; t < targets.size(); ++t)
            {
                const label i = targets[t];
                particles_.setSpacing
                (
                    i, domain_.spacingAt(particles_.position(i))
                );
            }
        }
    }

    const scalar maxSpacing = max(particles_.spacing);

    particles_.makeImages
    (
        domain_.low,
        domain_.high,
        domain_.support(0, maxSpacing) + method_.skin()*maxSpacing
    );

    // Roles of fixed points are those of their body plus the number of bodies
    const label nBodies = particles_.nBodies();
    scalarField radius(particles_.size());
    forAll(radius, i)
    {
        radius[i] = domain_.support
        (
            particles_.role[i] % nBodies, particles_.spacing[i]
        );
    }

    // Radii of neighbours differ by bodies' smoothing ratios, and by the
    // growth of the spacing over the support
    scalar smallest = GREAT;
    scalar largest = 0;
    for (const relaxationDomain::body& b : domain_.bodies)
    {
        smallest = min(smallest, b.smoothingRatio);
        largest = max(largest, b.smoothingRatio);
    }
    const scalar ratio = largest/smallest*(domain_.uniform() ? 1 : 1.4);

    list_.reset
    (
        particles_.positions(),
        std::move(radius),
        ratio,
        method_.skin()/domain_.W.cutOff()/largest,
        // Whole radii would have six times the volume of the sphere in 3-D
        domain_.nDims() == 3 ? 0.5 : 1
    );
}


bool Foam::SPH::relaxation::outOfSkin() const
{
    // Largest way since the reset over the skin
    scalar largest = 0;

    for (const DynamicList<label>& targets : targets_)
    {
        #pragma omp parallel for reduction(max: largest) \
            if (targets.size() > 2048)
        for (label t = 0; t < targets.size(); ++t)
        {
            const label i = targets[t];
            largest = max
            (
                largest,
                magSqr
                (
                    (particles_.position(i) - list_.resetPoint(i))/list_.skin(i)
                )
            );
        }
    }

    return largest > sqr(scalar(0.5));
}


void Foam::SPH::relaxation::findFirstLayer()
{
    DynamicList<label> layer;
    for (label i = 0; i < particles_.nParticles(); ++i)
    {
        const scalar dp = particles_.spacing[i];
        if
        (
            particles_.role[i] == 0
         && -particles_.phi[i] - particles_.drift[i] < dp
        )
        {
            const vector p(particles_.position(i));
            const bool near =
                domain_.bodies.size() == 1
              ? domain_.distance(0, p) > -dp
              : domain_.nearSolid(p, dp);
            if (near)
            {
                layer.append(i);
            }
        }
    }
    firstLayer_.transfer(layer);
}


void Foam::SPH::relaxation::addRows
(
    const label bodyi,
    const labelUList& targets
)
{
    list_.addRows
    (
        targets,
        [&](const label, const label j)
        {
            return method_.sees(bodyi, particles_.role[j]);
        }
    );
}


void Foam::SPH::relaxation::sumGradients
(
    const label bodyi,
    const labelUList& targets
)
{
    addRows(bodyi, targets);

    gradientSums
    (
        particles_,
        list_,
        domain_.W,
        domain_.bodies[bodyi].smoothingRatio,
        domain_.uniform(),
        targets,
        sums_
    );
}


Foam::scalar Foam::SPH::relaxation::moveBody(const label bodyi)
{
    const DynamicList<label>& targets = targets_[bodyi];

    if (targets.empty())
    {
        return 0;
    }

    sumGradients(bodyi, targets);
    method_.addBoundaryTerm(bodyi, particles_, targets, sums_);

    const scalar step =
        method_.displacements
        (
            bodyi, particles_, list_, targets, sums_, steps_
        );

    // A part of the last displacement is kept while that leads downhill
    scalar uphill = 0;
    for (label t = 0; t < targets.size(); ++t)
    {
        uphill += sums_[t] & lastStep_[targets[t]];
    }

    // Nearer than this to the surface (over dp) a particle is held: it is not
    // free to go where it is drawn to
    const scalar holding =
        method_.boundingDistance(bodyi, false) < 0 ? method_.band(bodyi)
      : (1 - 1e-6)*min
        (
            method_.boundingDistance(bodyi, false),
            bodyi == 0
          ? method_.solidDistance()
          : method_.boundingDistance(bodyi, false)
        );
    const scalar momentum = uphill > 0 ? 0 : method_.momentum();

    #pragma omp parallel for schedule(dynamic, 256) if (targets.size() > 2048)
    for (label t = 0; t < targets.size(); ++t)
    {
        const label i = targets[t];
        const scalar dp = particles_.spacing[i];

        vector dr(damping_[i]*(steps_[t] + momentum*lastStep_[i]));
        dr *= min(scalar(1), maxStep_*dp/max(mag(dr), VSMALL));

        const vector moved(bounding_.move(bodyi, i, dr, particles_));

        // A particle held at a surface may go to and fro between two surface
        // elements: its steps are damped, and what counts for the residual is
        // the way of two iterations
        force_[i] = mag(sums_[t])*dp;
        const bool held =
            mag(moved - dr) > 1e-9*dp
         || -particles_.phi[i] - particles_.drift[i]
          < holding*dp;
        residual_[i] =
            held
          ? min(force_[i], 0.5*mag(moved + lastStep_[i])/(step*dp))
          : force_[i];
        damping_[i] =
            held && (moved & lastStep_[i]) < 0
          ? max(0.7*damping_[i], minDamping_)
          : min(1.02*damping_[i], scalar(1));
        lastStep_[i] = moved;
    }

    particles_.updateImages();
    nParticleIterations_ += targets.size();

    return step;
}


Foam::scalar Foam::SPH::relaxation::kineticEnergy(const scalar step) const
{
    // v = 2 S dt, dt^2 = alpha
    scalar energy = 0;
    for (const label i : firstLayer_)
    {
        energy += 2*step*particles_.V[i]*sqr(force_[i]);
    }
    return energy;
}


void Foam::SPH::relaxation::findResiduals
(
    convergenceMonitor::record& state
) const
{
    scalar absolute = 0;
    scalar relative = 0;
    scalar sumSqr = 0;

    for (const DynamicList<label>& targets : targets_)
    {
        #pragma omp parallel for reduction(max: absolute, relative) \
            reduction(+: sumSqr) if (targets.size() > 2048)
        for (label t = 0; t < targets.size(); ++t)
        {
            const label i = targets[t];
            absolute = max(absolute, residual_[i]);
            relative = max(relative, residual_[i]/tolerance(i));
            sumSqr += sqr(residual_[i]);
        }
    }

    state.maxResidual = absolute;
    state.relativeResidual = relative;

    scalar layerSqr = 0;
    for (const label i : firstLayer_)
    {
        layerSqr += sqr(residual_[i]);
    }
    state.rmsResidual = sqrt
    (
        max
        (
            sumSqr/max(label(1), nTouched_),
            layerSqr/max(label(1), firstLayer_.size())
        )
    );
}


Foam::scalar Foam::SPH::relaxation::totalError()
{
    const kernel& W = domain_.W;
    const scalar ratio = domain_.bodies[0].smoothingRatio;

    // Undisturbed lattice sites are all alike: one stands for them
    DynamicList<label> fluid(particles_.nParticles());
    DynamicList<scalar> count(particles_.nParticles());
    label example = -1;
    for (label i = 0; i < particles_.nParticles(); ++i)
    {
        if (particles_.role[i] != 0)
        {
            continue;
        }
        if (touched_[i])
        {
            fluid.append(i);
            count.append(1);
        }
        else if (example < 0)
        {
            example = fluid.size();
            fluid.append(i);
            count.append(1);
        }
        else
        {
            count[example] += 1;
        }
    }

    addRows(0, fluid);

    // Solids do not contribute: the sum is over the fluid's particles
    scalarField fractions;
    volumeFractions(particles_, list_, W, ratio, 1, fluid, fractions);

    // Largest average volume of a particle: that of the better lattice
    const scalar vSup = latticePattern::largestVolume(W, ratio);

    scalar error = 0;
    scalar volume = 0;
    #pragma omp parallel for reduction(+: error, volume) schedule(static, 4096)
    for (label t = 0; t < fluid.size(); ++t)
    {
        const label i = fluid[t];
        const scalar h = ratio*particles_.spacing[i];
        const scalar V = count[t]*particles_.V[i];

        scalar missing = 0;
        if (-particles_.phi[i] - particles_.drift[i] < W.cutOff()*h)
        {
            const scalar phi = domain_.distance(0, particles_.position(i));
            missing = 2*W.lineTail(max(-phi, scalar(0)), h);
        }

        error += V*vSup*(fractions[t] + missing);
        volume += V;
    }

    return mag(error/volume - 1);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::relaxation::relaxation
(
    const relaxationDomain& domain,
    relaxationMethod& method,
    particleSystem& particles
)
:
    domain_(domain),
    method_(method),
    particles_(particles),
    bounding_(domain, method),
    targets_(domain.bodies.size()),
    touched_(particles.nParticles(), false),
    force_(particles.nParticles(), Zero),
    residual_(particles.nParticles(), Zero),
    lastStep_(particles.nParticles(), Zero),
    damping_(particles.nParticles(), scalar(1))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::relaxation::run(convergenceMonitor& monitor)
{
    if (!method_.freeze())
    {
        particles_.active = true;
    }
    collectTargets();
    resetList();
    findFirstLayer();

    label iteration =
        monitor.history().empty() ? 0 : monitor.history().last().iteration;
    const label last = iteration + method_.maxIterations();
    bool verified = false;

    while (iteration < last && nActive())
    {
        ++iteration;

        for (label bodyi = 1; bodyi < domain_.bodies.size(); ++bodyi)
        {
            moveBody(bodyi);
        }
        const scalar step = moveBody(0);

        convergenceMonitor::record state;
        state.iteration = iteration;
        state.kineticEnergy = kineticEnergy(step);
        findResiduals(state);
        if (monitor.logs(iteration) || iteration == 1)
        {
            state.totalError = totalError();
        }
        monitor.add(state);

        const bool converged = monitor.converged();
        if (converged && verified)
        {
            break;
        }

        if
        (
            method_.freeze()
         && (converged || iteration % activityInterval_ == 0)
        )
        {
            updateActivity();
        }
        verified = converged || !nActive();
        if (verified)
        {
            wakeTouched();
        }

        if (monitor.logs(iteration))
        {
            monitor.log(Info(), nActive(), last);
        }
        if (outOfSkin())
        {
            resetList();
            findFirstLayer();
        }
    }
}


// ************************************************************************* //
