/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "pairSlices.H"
#include "haloExchange.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Pairs lead forward along this direction
    static const vector forwards(0.8, 0.5, 0.3);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::SPH::pairSlices::firstRows(const labelUList& nPairs)
{
    labelList first(slicedField::slices(nPairs.size()) + 1, Zero);
    forAll(nPairs, i)
    {
        label& nRows = first[i/nLanes + 1];
        nRows = max(nRows, nPairs[i]);
    }
    for (label slice = 1; slice < first.size(); ++slice)
    {
        first[slice] += first[slice - 1];
    }
    return first;
}


Foam::SPH::alignedList<int> Foam::SPH::pairSlices::padding
(
    const labelUList& firstRows
)
{
    alignedList<int> neighbour(std::size_t(firstRows.last())*nLanes);
    for (label slice = 0; slice < firstRows.size() - 1; ++slice)
    {
        for (label row = firstRows[slice]; row < firstRows[slice + 1]; ++row)
        {
            for (label lane = 0; lane < nLanes; ++lane)
            {
                neighbour[std::size_t(row)*nLanes + lane] =
                    slice*nLanes + lane;
            }
        }
    }
    return neighbour;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::pairSlices::pairSlices
(
    const particleMesh& particles,
    const scalar maxSkew
)
:
    nSlices_(slicedField::slices(particles.nParticles())),
    geometry_(0, 0),
    backwardArea_(0, 0)
{
    const label nParticles = particles.nParticles();
    const label nIndices = haloExchange::nSlices(particles)*nLanes;
    const label nDims = loopDims(particles);
    const solutionSpace& space = particles.space();

    // Of each pair the particle that it leads from, and whether that is the
    // owner
    const auto leads = [&](const label pairi)
    {
        // Both ranks of a pair decide on the same vector
        const scalar direction = particles.reversed(pairi) ? -1 : 1;
        const vector delta
        (
            direction*space.toLocal(particles.delta()[pairi])
        );
        return ((delta & forwards) >= 0) != particles.reversed(pairi);
    };
    const auto index = [&](const label i)
    {
        return haloExchange::index(particles, i);
    };

    labelList nForward(nIndices, Zero);
    labelList nBackward(nSlices_*nLanes, Zero);
    bitSet isOuter(nSlices_);
    forAll(particles.owner(), pairi)
    {
        label i = particles.owner()[pairi];
        label j = particles.neighbour()[pairi];
        if (j >= nParticles)
        {
            isOuter.set(i/nLanes);
        }
        if (!leads(pairi))
        {
            Swap(i, j);
        }
        ++nForward[index(i)];
        if (j < nParticles)
        {
            ++nBackward[j];
        }
    }

    outerSlices_ = isOuter.sortedToc();
    isOuter.flip();
    innerSlices_ = isOuter.sortedToc();
    haloSlices_ = identity(nIndices/nLanes - nSlices_, nSlices_);

    forward_ = firstRows(nForward);
    backward_ = firstRows(nBackward);
    forwardNeighbour_ = padding(forward_);
    backwardNeighbour_ = padding(backward_);

    // Padding: any normal and distance, no area
    geometry_ = rowField(3*nDims + 1, nRows());
    backwardArea_ = rowField(nDims, backward_.last());
    for (label e = 0; e < nRows()*nLanes; ++e)
    {
        geometry_(e, 0) = 1;
        geometry_(e, nDims + 1) = 1;
    }
    entry_.assign(backwardNeighbour_.size(), forward_.last()*nLanes);

    // Next entry of a particle
    const auto entryOf = []
    (
        const labelList& firstRows,
        labelList& nPairs,
        const label i
    )
    {
        const label row = firstRows[i/nLanes] + nPairs[i]++;
        return row*nLanes + i % nLanes;
    };

    nForward = 0;
    nBackward = 0;
    forAll(particles.owner(), pairi)
    {
        const bool fromOwner = leads(pairi);
        const label owner = index(particles.owner()[pairi]);
        const label neighbour = index(particles.neighbour()[pairi]);
        const label i = fromOwner ? owner : neighbour;
        const label j = fromOwner ? neighbour : owner;
        const scalar direction = fromOwner ? 1 : -1;

        const vector A(direction*space.toLocal(particles.Sf()[pairi]));

        const label e = entryOf(forward_, nForward, i);
        forwardNeighbour_[e] = j;
        if (j < nParticles)
        {
            const label b = entryOf(backward_, nBackward, j);
            backwardNeighbour_[b] = i;
            entry_[b] = e;
            for (label d = 0; d < nDims; ++d)
            {
                backwardArea_(b, d) = -A[d];
            }
        }

        const vector delta(direction*space.toLocal(particles.delta()[pairi]));
        vector skew
        (
            particles.skew().size()
          ? space.toLocal(particles.skew()[pairi])
          : Zero
        );
        const scalar skewLimit = maxSkew*mag(delta);
        if (mag(skew) > skewLimit)
        {
            skew *= skewLimit/mag(skew);
        }
        const scalar area = mag(A);
        geometry_(e, nDims) = area;
        for (label d = 0; d < nDims; ++d)
        {
            if (area > 0)
            {
                geometry_(e, d) = A[d]/area;
            }
            geometry_(e, nDims + 1 + d) = delta[d];
            geometry_(e, 2*nDims + 1 + d) = skew[d];
        }
    }
}


// ************************************************************************* //
