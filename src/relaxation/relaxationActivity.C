/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    Which particles a relaxation works on.

\*---------------------------------------------------------------------------*/

#include "relaxation.H"
#include "kernelSums.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::relaxation::collectTargets()
{
    for (DynamicList<label>& targets : targets_)
    {
        targets.clear();
    }

    nTouched_ = 0;
    for (label i = 0; i < particles_.nParticles(); ++i)
    {
        if (particles_.active[i])
        {
            targets_[particles_.role[i]].append(i);
            touched_[i] = true;
        }
        nTouched_ += touched_[i];
    }
}


void Foam::SPH::relaxation::markMovers()
{
    const label nParticles = particles_.nParticles();
    marked_.setSize(nParticles);
    marked_ = 0;

    const auto mark = [&](const label j)
    {
        const label i = particles_.origin(j);
        if (i < nParticles)
        {
            #pragma omp atomic write
            marked_[i] = 1;
        }
    };

    for (const DynamicList<label>& targets : targets_)
    {
        #pragma omp parallel for schedule(dynamic, 256) \
            if (targets.size() > 2048)
        for (label t = 0; t < targets.size(); ++t)
        {
            const label i = targets[t];
            if (residual_[i] <= restFraction_*tolerance(i))
            {
                continue;
            }

            mark(i);
            for (const label* s = list_.begin(i); s < list_.end(i); ++s)
            {
                mark(*s);
            }
        }
    }
}


void Foam::SPH::relaxation::dropUndisturbed()
{
    List<DynamicList<label>> untouched(particles_.nBodies());
    forAll(marked_, i)
    {
        if (marked_[i] && !touched_[i])
        {
            untouched[particles_.role[i]].append(i);
        }
    }

    forAll(untouched, bodyi)
    {
        const DynamicList<label>& targets = untouched[bodyi];

        sumGradients(bodyi, targets);
        forAll(targets, t)
        {
            const label i = targets[t];
            force_[i] = mag(sums_[t])*particles_.spacing[i];
            marked_[i] = force_[i] > tolerance(i);
        }
    }
}


void Foam::SPH::relaxation::updateActivity()
{
    markMovers();
    dropUndisturbed();

    forAll(marked_, i)
    {
        if (!marked_[i])
        {
            lastStep_[i] = Zero;
        }
        particles_.active[i] = marked_[i];
    }

    collectTargets();
}


void Foam::SPH::relaxation::wakeTouched()
{
    particles_.active = touched_;
    collectTargets();
}


Foam::label Foam::SPH::relaxation::nActive() const
{
    label n = 0;
    for (const DynamicList<label>& targets : targets_)
    {
        n += targets.size();
    }
    return n;
}


// ************************************************************************* //
