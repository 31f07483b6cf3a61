/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "gradedStart.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::gradedStart::divide
(
    const vector& corner,
    const vector& edges
)
{
    const label nDims = domain_.nDims();
    const vector centre(corner + 0.5*edges);
    const scalar radius = 0.5*mag(edges);
    const scalar dp = domain_.spacingAt(centre);
    const scalar reach = domain_.support(0, dp);

    // Of the outside of the fluid and of the inside of solids, only what the
    // kernel reaches is needed
    bool needed = false;
    for (label bodyi = 0; bodyi < domain_.bodies.size() && !needed; ++bodyi)
    {
        const scalar phi = domain_.distance(bodyi, centre);
        needed =
            bodyi == 0
          ? phi < radius + reach
          : mag(phi) < radius + 2*reach;
    }
    if (!needed)
    {
        return;
    }

    scalar longest = 0;
    for (label d = 0; d < nDims; ++d)
    {
        longest = max(longest, edges[d]);
    }
    if (longest <= dp*(1 + 1e-6))
    {
        corners_.append(corner);
        edges_.append(edges);
        spacing_.append(dp);
        return;
    }

    for (label part = 0; part < (1 << nDims); ++part)
    {
        vector partCorner(corner);
        for (label d = 0; d < nDims; ++d)
        {
            partCorner[d] += (part >> d) & 1 ? 0.5*edges[d] : 0;
        }
        divide(partCorner, 0.5*edges);
    }
}


Foam::DynamicList<Foam::SPH::gradedStart::sample>
Foam::SPH::gradedStart::sampleBody
(
    const label bodyi,
    particleStart& start
) const
{
    const label nDims = domain_.nDims();
    const label nParts = nDims == 3 ? 2 : 3;

    DynamicList<sample> samples;

    forAll(corners_, celli)
    {
        const vector& edges = edges_[celli];
        const vector centre(corners_[celli] + 0.5*edges);
        const scalar dp = spacing_[celli];
        const scalar phi = domain_.distance(bodyi, centre);
        const scalar depth = domain_.support(0, dp) + dp;

        scalar volume = 1;
        scalar longest = 0;
        label n[3] = {1, 1, 1};
        for (label d = 0; d < nDims; ++d)
        {
            volume *= edges[d];
            longest = max(longest, edges[d]);
            n[d] = nParts;
        }

        if (phi > mag(edges))
        {
            continue;
        }
        if (bodyi > 0 && phi < -depth)
        {
            // The fluid does not see it: it only holds the others
            start.addFixed(centre, dp, volume, bodyi);
            continue;
        }

        const scalar V = volume/(n[0]*n[1]*n[2]);
        for (label k = 0; k < n[2]; ++k)
        {
            for (label j = 0; j < n[1]; ++j)
            {
                for (label i = 0; i < n[0]; ++i)
                {
                    const label part[3] = {i, j, k};
                    vector p(corners_[celli]);
                    for (label d = 0; d < nDims; ++d)
                    {
                        p[d] += edges[d]*(part[d] + 0.5)/n[d];
                    }

                    // Far inside, all of the cell counts
                    const scalar fraction =
                        phi < -mag(edges)
                      ? 1
                      : 1 - staticSupport::heaviside
                        (
                            domain_.distance(bodyi, p),
                            0.75*longest/nParts
                        );
                    if (fraction > 0)
                    {
                        samples.append({p, fraction*V/domain_.volume(dp)});
                    }
                }
            }
        }
    }

    return samples;
}


void Foam::SPH::gradedStart::distribute
(
    const label bodyi,
    sample* first,
    sample* last,
    const label n,
    particleStart& start
) const
{
    if (n == 0 || first == last)
    {
        return;
    }

    scalar weight = 0;
    vector moment(Zero);
    vector low(vector::one*GREAT);
    vector high(-vector::one*GREAT);
    for (const sample* s = first; s < last; ++s)
    {
        weight += s->weight;
        moment += s->weight*s->position;
        low = min(low, s->position);
        high = max(high, s->position);
    }

    if (n == 1)
    {
        const vector p(moment/weight);
        start.add
        (
            p,
            domain_.spacingAt(p),
            bodyi,
            domain_.distance(bodyi, p),
            false
        );
        return;
    }

    direction axis = 0;
    for (label d = 1; d < domain_.nDims(); ++d)
    {
        if (high[d] - low[d] > high[axis] - low[axis])
        {
            axis = d;
        }
    }

    std::sort
    (
        first,
        last,
        [axis](const sample& a, const sample& b)
        {
            return a.position[axis] < b.position[axis];
        }
    );

    const label n1 = n/2;
    const scalar wanted = weight*n1/n;
    scalar sum = 0;
    sample* middle = first;
    while (middle < last && sum + 0.5*middle->weight < wanted)
    {
        sum += (middle++)->weight;
    }

    distribute(bodyi, first, middle, n1, start);
    distribute(bodyi, middle, last, n - n1, start);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::gradedStart::gradedStart
(
    const relaxationDomain& domain,
    const scalar maxSpacing
)
:
    domain_(domain)
{
    const vector span(domain.high - domain.low);
    const scalar reach = 2*domain.support(0, maxSpacing);

    label n[3] = {1, 1, 1};
    label margin[3] = {0, 0, 0};
    vector edges(Zero);
    for (label d = 0; d < domain.nDims(); ++d)
    {
        bool periodic = false;
        for (const vector& T : domain.translations)
        {
            periodic = periodic || mag(T[d]) > 0.5*mag(T);
        }

        n[d] = max(label(1), label(ceil(span[d]/maxSpacing)));
        edges[d] = span[d]/n[d];
        margin[d] = periodic ? 0 : 1 + label(reach/edges[d]);
    }

    for (label k = -margin[2]; k < n[2] + margin[2]; ++k)
    {
        for (label j = -margin[1]; j < n[1] + margin[1]; ++j)
        {
            for (label i = -margin[0]; i < n[0] + margin[0]; ++i)
            {
                divide
                (
                    domain.low + cmptMultiply(vector(i, j, k), edges),
                    edges
                );
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::SPH::gradedStart::nFluidParticles() const
{
    particleStart unused;
    scalar n = 0;
    for (const sample& s : sampleBody(0, unused))
    {
        n += s.weight;
    }
    return n;
}


void Foam::SPH::gradedStart::generate
(
    const staticSupport& support,
    particleStart& start
) const
{
    forAll(domain_.bodies, bodyi)
    {
        DynamicList<sample> samples(sampleBody(bodyi, start));

        scalar weight = 0;
        for (const sample& s : samples)
        {
            weight += s.weight;
        }

        distribute
        (
            bodyi,
            samples.begin(),
            samples.end(),
            label(round(weight)),
            start
        );
    }

    start.addFixedByThreads
    (
        corners_.size(),
        [&](const label celli, particleStart& cell)
        {
            support.addCell
            (
                corners_[celli],
                edges_[celli],
                spacing_[celli],
                cell
            );
        }
    );
}


// ************************************************************************* //
