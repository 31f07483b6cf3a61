/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "latticeStart.H"
#include "error.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::SPH::latticeStart::corner(const cellIndex& cell) const
{
    vector p(domain_.low);
    for (label d = 0; d < domain_.nDims(); ++d)
    {
        p[d] += cell[d]*edges_[d];
    }
    return p;
}


void Foam::SPH::latticeStart::locate(block& b) const
{
    vector half(Zero);
    for (label d = 0; d < domain_.nDims(); ++d)
    {
        half[d] = 0.5*b.size[d]*edges_[d];
    }
    const vector centre(corner(b.low) + half);
    const scalar radius = mag(half);
    const scalar reach = domain_.support(0, spacing_);

    b.where = location::outside;
    forAll(domain_.bodies, bodyi)
    {
        const scalar phi = domain_.distance(bodyi, centre);

        // Solids are filled as deep as the fluid sees, and held from behind
        const scalar depth = (bodyi > 0 && phi < 0 ? 2*reach : reach);
        if (mag(phi) < radius + depth + mag(edges_))
        {
            b.where =
                b.size[0]*b.size[1]*b.size[2] == 1
              ? location::near
              : location::undecided;
            return;
        }
        if (bodyi == 0 && phi < 0)
        {
            b.where = location::inside;
            b.distance = mag(phi) - radius;
        }
    }
}


void Foam::SPH::latticeStart::divide
(
    const block& b,
    DynamicList<block>& parts
)
{
    label n[3];
    for (label d = 0; d < 3; ++d)
    {
        n[d] = b.size[d] > 1 ? 2 : 1;
    }
    for (label k = 0; k < n[2]; ++k)
    {
        for (label j = 0; j < n[1]; ++j)
        {
            for (label i = 0; i < n[0]; ++i)
            {
                const label index[3] = {i, j, k};
                block part;
                for (label d = 0; d < 3; ++d)
                {
                    const label first = b.size[d]/n[d];
                    part.low[d] = b.low[d] + index[d]*first;
                    part.size[d] = index[d] == 0 ? first : b.size[d] - first;
                }
                parts.append(part);
            }
        }
    }
}


void Foam::SPH::latticeStart::classify(const block& all)
{
    DynamicList<block> blocks;
    blocks.append(all);

    for (bool undecided = true; undecided;)
    {
        #pragma omp parallel for schedule(dynamic, 64)
        for (label i = 0; i < blocks.size(); ++i)
        {
            if (blocks[i].where == location::undecided)
            {
                locate(blocks[i]);
            }
        }

        // Parts take the place of the whole, which keeps neighbours near
        // each other in the list
        undecided = false;
        DynamicList<block> next(blocks.size());
        for (const block& b : blocks)
        {
            if (b.where == location::undecided)
            {
                undecided = true;
                divide(b, next);
            }
            else if (b.where != location::outside)
            {
                next.append(b);
            }
        }
        blocks.transfer(next);
    }

    for (const block& b : blocks)
    {
        if (b.where == location::inside)
        {
            blocks_.append(b);
        }
        else
        {
            nearCells_.append(b.low);
        }
    }
}


void Foam::SPH::latticeStart::addNearSites(particleStart& start) const
{
    const label nSites = pattern_.sites().size();
    const label nNear = nearCells_.size()*nSites;
    const label nBodies = domain_.bodies.size();

    scalarField phi(nNear);

    #pragma omp parallel for schedule(dynamic, 64)
    for (label s = 0; s < nNear; ++s)
    {
        phi[s] = domain_.distance(0, site(nearCells_[s/nSites], s % nSites));
    }

    // Deep sites are inside whatever the count is
    const scalar tie = 0.5*spacing_;

    // Distances equal to round-off are ties
    const scalar tieWidth = 1e-9*spacing_;

    label nInside = start.points.size();
    DynamicList<label> boundary;
    forAll(phi, s)
    {
        if (phi[s] < -tie)
        {
            ++nInside;
        }
        else if (phi[s] < tie)
        {
            boundary.append(s);
        }
    }

    std::stable_sort
    (
        boundary.begin(),
        boundary.end(),
        [&](const label a, const label b)
        {
            return phi[a] < phi[b] - tieWidth;
        }
    );

    const label wanted =
        label(round(domain_.fluidVolume/domain_.volume(spacing_)));
    const label nTaken =
        max(label(0), min(wanted - nInside, boundary.size()));

    boolList taken(phi.size());
    forAll(phi, s)
    {
        taken[s] = phi[s] < -tie;
    }
    scalar threshold = 0;
    for (label b = 0; b < nTaken; ++b)
    {
        taken[boundary[b]] = true;
        threshold = phi[boundary[b]];
    }
    threshold = min(threshold, scalar(0));

    // A site on the interface that the fluid did not take is the solid's
    labelList solid(nNear, -1);
    #pragma omp parallel for schedule(dynamic, 64)
    for (label s = 0; s < nNear; ++s)
    {
        const vector p(site(nearCells_[s/nSites], s % nSites));

        for (label b = 1; b < nBodies && !taken[s] && solid[s] < 0; ++b)
        {
            const scalar phis = domain_.distance(b, p);
            if (phis < -threshold + tieWidth)
            {
                solid[s] = b;
                phi[s] = phis;
            }
        }
    }

    const scalar fluidReach = domain_.support(0, spacing_) + spacing_;

    for (label s = 0; s < nNear; ++s)
    {
        const vector p(site(nearCells_[s/nSites], s % nSites));

        if (taken[s])
        {
            start.add(p, spacing_, 0, phi[s], false);
        }
        else if (solid[s] > 0 && phi[s] > -fluidReach)
        {
            start.add(p, spacing_, solid[s], phi[s], false);
        }
        else if (solid[s] > 0)
        {
            // The fluid does not see it: it only holds the others
            start.addFixed
            (
                p,
                spacing_,
                domain_.volume(spacing_),
                solid[s]
            );
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::latticeStart::latticeStart
(
    const relaxationDomain& domain,
    const latticePattern& pattern
)
:
    domain_(domain),
    pattern_(pattern),
    n_(1),
    edges_(vector::one),
    spacing_(0),
    margin_(Zero)
{
    const vector span(domain.high - domain.low);
    const scalar reach = 2*domain.support(0, domain.minSpacing);

    scalar volume = 1;
    for (label d = 0; d < domain.nDims(); ++d)
    {
        n_[d] = max
        (
            label(1),
            label(round(span[d]/(pattern.cell()[d]*domain.minSpacing)))
        );
        edges_[d] = span[d]/n_[d];
        volume *= edges_[d];
    }
    for (label d = domain.nDims(); d < 3; ++d)
    {
        edges_[d] = 0;
    }
    spacing_ = pow(volume/pattern.sites().size(), 1.0/domain.nDims());

    for (label d = 0; d < domain.nDims(); ++d)
    {
        bool periodic = false;
        for (const vector& T : domain.translations)
        {
            periodic = periodic || mag(T[d]) > 0.5*mag(T);
        }
        margin_[d] = periodic ? 0 : 1 + label(reach/edges_[d]);
    }

    block all;
    for (label d = 0; d < 3; ++d)
    {
        all.low[d] = -margin_[d];
        all.size[d] = n_[d] + 2*margin_[d];
    }
    classify(all);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::latticeStart::generate
(
    const staticSupport& support,
    particleStart& start
) const
{
    const label nSites = pattern_.sites().size();

    for (const block& b : blocks_)
    {
        for (label k = 0; k < b.size[2]; ++k)
        {
            for (label j = 0; j < b.size[1]; ++j)
            {
                for (label i = 0; i < b.size[0]; ++i)
                {
                    const cellIndex cell
                    ({b.low[0] + i, b.low[1] + j, b.low[2] + k});

                    for (label s = 0; s < nSites; ++s)
                    {
                        start.add
                        (
                            site(cell, s), spacing_, 0, -b.distance, true
                        );
                    }
                }
            }
        }
    }

    addNearSites(start);

    start.addFixedByThreads
    (
        nearCells_.size(),
        [&](const label celli, particleStart& cell)
        {
            support.addCell(corner(nearCells_[celli]), edges_, spacing_, cell);
        }
    );
}


// ************************************************************************* //
