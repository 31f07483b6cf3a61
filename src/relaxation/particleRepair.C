/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleRepair.H"
#include "mathematicalConstants.H"
#include "StringStream.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<Foam::vector> Foam::SPH::particleRepair::directions() const
{
    using constant::mathematical::twoPi;

    DynamicList<vector> e;

    if (domain_.nDims() == 1)
    {
        e.append(vector(1, 0, 0));
        e.append(vector(-1, 0, 0));
    }
    else if (domain_.nDims() == 2)
    {
        const label n = 12;
        for (label k = 0; k < n; ++k)
        {
            e.append(vector(cos(twoPi*k/n), sin(twoPi*k/n), 0));
        }
    }
    else
    {
        for (label c = 0; c < 27; ++c)
        {
            const vector v(c % 3 - 1, (c/3) % 3 - 1, c/9 - 1);
            if (c != 13)
            {
                e.append(v/mag(v));
            }
        }
    }

    return List<vector>(e);
}


void Foam::SPH::particleRepair::removeOutside()
{
    const label n = particles_.nParticles();

    #pragma omp parallel for schedule(dynamic, 256)
    for (label i = 0; i < n; ++i)
    {
        const scalar limit = leastDepth_*particles_.spacing[i];
        if
        (
            !particles_.regular[i]
         && -particles_.phi[i] - particles_.drift[i] < limit
        )
        {
            removed_[i] =
                domain_.distance(particles_.role[i], points_[i]) > -limit;
        }
    }

    for (label i = 0; i < n; ++i)
    {
        if (removed_[i])
        {
            ++nOutside_;
            example_ = domain_.space.position(points_[i]);
        }
    }
}


void Foam::SPH::particleRepair::removeClose()
{
    for (label i = 0; i < particles_.nParticles(); ++i)
    {
        if (removed_[i] || particles_.regular[i])
        {
            continue;
        }

        // Of a pair, the solid's particle goes, else the second one
        const scalar R = closest_*particles_.spacing[i];
        gridPtr_->forNear
        (
            points_[i],
            [R](const scalar) { return R; },
            [&](const label j)
            {
                const label k = particles_.origin(j);
                if
                (
                    k < particles_.nParticles()
                 && k != i
                 && !removed_[k]
                 && !removed_[i]
                 && magSqr(points_[j] - points_[i]) < R*R
                 && (
                        particles_.role[i] != particles_.role[k]
                      ? particles_.role[i] > particles_.role[k]
                      : i > k
                    )
                )
                {
                    removed_[i] = true;
                    ++nClose_;
                    example_ = domain_.space.position(points_[i]);
                }
            }
        );
    }
}


void Foam::SPH::particleRepair::fillVoids()
{
    const List<vector> e(directions());
    const label nParticles = particles_.nParticles();

    List<DynamicList<vector>> candidates(nParticles);

    #pragma omp parallel for schedule(dynamic, 256)
    for (label i = 0; i < nParticles; ++i)
    {
        if
        (
            particles_.role[i] != 0
         || removed_[i]
         || (particles_.regular[i] && !particles_.active[i])
        )
        {
            continue;
        }

        const scalar R = voidRadius_*particles_.spacing[i];
        const bool deep =
            -particles_.phi[i] - particles_.drift[i]
          > 2*particles_.spacing[i];

        for (const vector& direction : e)
        {
            const vector p(points_[i] + 1.001*R*direction);

            bool empty = true;
            gridPtr_->forNear
            (
                p,
                [R](const scalar) { return R; },
                [&](const label j)
                {
                    // Fixed points are no particles; near a surface the
                    // distance says what is outside
                    const label k = particles_.origin(j);
                    empty =
                        empty
                     && (
                            k >= nParticles
                         || removed_[k]
                         || magSqr(points_[j] - p) > R*R
                        );
                }
            );

            if
            (
                empty
             && (
                    deep
                 || domain_.distance(0, p) < -0.4*particles_.spacing[i]
                )
            )
            {
                candidates[i].append(p);
            }
        }
    }

    forAll(candidates, i)
    {
        for (const vector& p : candidates[i])
        {
            bool empty = true;
            for (const vector& q : added_)
            {
                empty =
                    empty
                 && magSqr(p - q) > sqr(voidRadius_*particles_.spacing[i]);
            }
            if (empty)
            {
                added_.append(p);
                ++nVoids_;
                example_ = domain_.space.position(p);
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::SPH::particleRepair::check()
{
    points_ = particles_.positions();
    gridPtr_.reset(new cellGridLevels(points_, particles_.spacing, 1));
    removed_.setSize(particles_.nParticles());
    removed_ = false;
    added_.clear();
    nOutside_ = nClose_ = nVoids_ = 0;

    removeOutside();
    removeClose();
    fillVoids();

    return nOutside_ + nClose_ + nVoids_ == 0;
}


void Foam::SPH::particleRepair::repair()
{
    DynamicList<vector> points;
    DynamicList<scalar> spacing;
    DynamicList<label> body;
    DynamicList<scalar> phi;
    DynamicList<bool> regular;

    for (label i = 0; i < particles_.nParticles(); ++i)
    {
        if (!removed_[i])
        {
            points.append(points_[i]);
            spacing.append(particles_.spacing[i]);
            body.append(particles_.role[i]);
            phi.append
            (
                min(particles_.phi[i] + particles_.drift[i], scalar(0))
            );
            regular.append(particles_.regular[i]);
        }
    }
    for (const vector& p : added_)
    {
        points.append(p);
        spacing.append(domain_.spacingAt(p));
        body.append(0);
        phi.append(domain_.distance(0, p));
        regular.append(false);
    }

    particles_.setParticles(points, spacing, body, phi, regular);
}


void Foam::SPH::particleRepair::report(Ostream& os) const
{
    os  << nOutside_ << " particles on or outside the surface, " << nClose_
        << " pairs closer than " << closest_ << " dp, " << nVoids_
        << " voids, one of them at " << example_ << endl;
}


void Foam::SPH::particleRepair::fail() const
{
    OStringStream found;
    report(found);

    FatalErrorInFunction
        << "No valid particle set was found: " << found.str().c_str()
        << "Refine the entry spacing of sphMeshDict there: sheets and gaps"
        << " thinner than dp do not hold particles. Or allow more iterations"
        << " in its dictionary relaxation" << exit(FatalError);
}


// ************************************************************************* //
