/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "latticeStart.H"
#include "error.H"

#include <omp.h>

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


void Foam::SPH::latticeStart::classify
(
    const cellIndex& low,
    const cellIndex& size
)
{
    vector half(Zero);
    for (label d = 0; d < domain_.nDims(); ++d)
    {
        half[d] = 0.5*size[d]*edges_[d];
    }
    const vector centre(corner(low) + half);
    const scalar radius = mag(half);
    const scalar reach = domain_.support(0, spacing_);

    bool near = false;
    scalar distance = GREAT;
    bool inFluid = false;
    for (label bodyi = 0; bodyi < domain_.bodies.size() && !near; ++bodyi)
    {
        const scalar phi = domain_.distance(bodyi, centre);

        // Solids are filled as deep as the fluid sees, and held from behind
        const scalar depth = (bodyi > 0 && phi < 0 ? 2*reach : reach);
        near = mag(phi) < radius + depth + mag(edges_);
        if (bodyi == 0)
        {
            inFluid = phi < 0;
            distance = mag(phi) - radius;
        }
    }

    if (!near)
    {
        if (inFluid)
        {
            blocks_.append(block({low, size, distance}));
        }
        return;
    }

    if (size[0]*size[1]*size[2] == 1)
    {
        nearCells_.append(low);
        return;
    }

    cellIndex parts;
    for (label d = 0; d < 3; ++d)
    {
        parts[d] = size[d] > 1 ? 2 : 1;
    }
    for (label k = 0; k < parts[2]; ++k)
    {
        for (label j = 0; j < parts[1]; ++j)
        {
            for (label i = 0; i < parts[0]; ++i)
            {
                const label part[3] = {i, j, k};
                cellIndex partLow;
                cellIndex partSize;
                for (label d = 0; d < 3; ++d)
                {
                    const label first = size[d]/parts[d];
                    partLow[d] = low[d] + part[d]*first;
                    partSize[d] = part[d] == 0 ? first : size[d] - first;
                }
                classify(partLow, partSize);
            }
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

    const scalar fluidReach = domain_.support(0, spacing_) + spacing_;

    for (label s = 0; s < nNear; ++s)
    {
        const vector p(site(nearCells_[s/nSites], s % nSites));

        if (taken[s])
        {
            start.add(p, spacing_, 0, phi[s], false);
            continue;
        }

        // A site on the interface that the fluid did not take is the solid's
        for (label bodyi = 1; bodyi < nBodies; ++bodyi)
        {
            const scalar phis = domain_.distance(bodyi, p);
            if (phis < -threshold + tieWidth && phis > -fluidReach)
            {
                start.add(p, spacing_, bodyi, phis, false);
                break;
            }
            else if (phis <= -fluidReach)
            {
                // The fluid does not see it: it only holds the others
                start.addFixed
                (
                    p,
                    spacing_,
                    domain_.volume(spacing_),
                    bodyi
                );
                break;
            }
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

    cellIndex low;
    cellIndex size;
    for (label d = 0; d < 3; ++d)
    {
        low[d] = -margin_[d];
        size[d] = n_[d] + 2*margin_[d];
    }
    classify(low, size);
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

    // Shares of the cells are put one after the other, so that the result
    // does not depend on the number of threads
    const label nShares = max(1, omp_get_max_threads());
    List<particleStart> shares(nShares);

    #pragma omp parallel for schedule(static, 1)
    for (label share = 0; share < nShares; ++share)
    {
        const label first = share*int64_t(nearCells_.size())/nShares;
        const label last = (share + 1)*int64_t(nearCells_.size())/nShares;
        for (label c = first; c < last; ++c)
        {
            support.addCell
            (
                corner(nearCells_[c]), edges_, spacing_, shares[share]
            );
        }
    }

    for (const particleStart& share : shares)
    {
        start.fixedPoints.append(share.fixedPoints);
        start.fixedSpacing.append(share.fixedSpacing);
        start.fixedVolume.append(share.fixedVolume);
        start.fixedBody.append(share.fixedBody);
    }
}


// ************************************************************************* //
