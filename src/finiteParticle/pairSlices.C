/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "pairSlices.H"
#include "haloExchange.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::pairSlices::pairSlices(const particleMesh& particles)
:
    start_(slicedField::slices(particles.nParticles()) + 1)
{
    const label nParticles = particles.nParticles();
    const label nDims = loopDims(particles);
    const labelList& owner = particles.owner();
    const labelList& neighbour = particles.neighbour();

    labelList nNeighbours(nParticles, Zero);
    forAll(owner, pairi)
    {
        ++nNeighbours[owner[pairi]];
        if (neighbour[pairi] < nParticles)
        {
            ++nNeighbours[neighbour[pairi]];
        }
    }

    start_[0] = 0;
    for (label slice = 0; slice < nSlices(); ++slice)
    {
        label nRows = 0;
        for
        (
            label i = slice*nLanes;
            i < min((slice + 1)*nLanes, nParticles);
            ++i
        )
        {
            nRows = max(nRows, nNeighbours[i]);
        }
        start_[slice + 1] = start_[slice] + nRows;
    }

    const label nRows = start_.last();
    const std::size_t size = std::size_t(nRows)*nLanes;

    // Padding: the particle itself, any normal, no area
    neighbour_.resize(size);
    for (label slice = 0; slice < nSlices(); ++slice)
    {
        for (label row = start_[slice]; row < start_[slice + 1]; ++row)
        {
            for (label lane = 0; lane < nLanes; ++lane)
            {
                neighbour_[std::size_t(row)*nLanes + lane] =
                    slice*nLanes + lane;
            }
        }
    }
    area_.assign(size, 0);
    gradWeight_.assign(size, 0);
    for (label d = 0; d < nDims; ++d)
    {
        n_[d].assign(size, d == 0 ? 1 : 0);
        delta_[d].assign(size, d == 0 ? 1 : 0);
        skew_[d].assign(size, 0);
    }

    labelList row(nParticles);
    forAll(row, i)
    {
        row[i] = start_[i/nLanes];
    }

    bitSet isOuter(nSlices());
    forAll(owner, pairi)
    {
        const bool reversed = particles.reversed(pairi);
        const scalar direction = reversed ? -1 : 1;
        const vector A
        (
            direction*particles.space().toLocal(particles.Sf()[pairi])
        );
        const vector delta
        (
            direction*particles.space().toLocal(particles.delta()[pairi])
        );
        const scalar magA = mag(A);

        for (const bool atOwner : {true, false})
        {
            const label i = atOwner ? owner[pairi] : neighbour[pairi];
            const label j = atOwner ? neighbour[pairi] : owner[pairi];
            if (i >= nParticles)
            {
                continue;
            }
            if (j >= nParticles)
            {
                isOuter.set(i/nLanes);
            }
            const std::size_t e = std::size_t(row[i]++)*nLanes + i % nLanes;

            neighbour_[e] = haloExchange::index(particles, j);
            area_[e] = atOwner != reversed ? magA : -magA;
            gradWeight_[e] = (A & delta)/magSqr(delta);
            for (label d = 0; d < nDims; ++d)
            {
                if (magA > 0)
                {
                    n_[d][e] = A[d]/magA;
                }
                delta_[d][e] = delta[d];
                if (particles.skew().size())
                {
                    skew_[d][e] =
                        particles.space()
                       .toLocal(particles.skew()[pairi])[d];
                }
            }
        }
    }

    outerSlices_ = isOuter.sortedToc();
    isOuter.flip();
    innerSlices_ = isOuter.sortedToc();
}


// ************************************************************************* //
