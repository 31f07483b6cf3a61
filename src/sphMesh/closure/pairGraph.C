/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "pairGraph.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Dot product of each right-hand side, summed in an order that does not
    //- depend on the number of threads
    static void dots
    (
        const scalarField& a,
        const scalarField& b,
        const label nSides,
        const label blockSize,
        scalarField& result
    )
    {
        const label width = nSides*blockSize;
        const label n = a.size()/width;
        const label chunk = 4096;
        const label nChunks = (n + chunk - 1)/chunk;

        scalarField partial(nChunks*nSides, Zero);

        #pragma omp parallel for schedule(static)
        for (label c = 0; c < nChunks; ++c)
        {
            const label end = min((c + 1)*chunk, n);
            for (label i = c*chunk; i < end; ++i)
            {
                for (label k = 0; k < width; ++k)
                {
                    partial[c*nSides + k/blockSize] +=
                        a[i*width + k]*b[i*width + k];
                }
            }
        }

        result = 0;
        for (label c = 0; c < nChunks; ++c)
        {
            for (label s = 0; s < nSides; ++s)
            {
                result[s] += partial[c*nSides + s];
            }
        }
    }

    //- y += alpha x, or y = x + alpha y, with one alpha per side
    template<bool addToX>
    static void axpy
    (
        const scalarField& alpha,
        const scalarField& x,
        scalarField& y,
        const label nSides,
        const label blockSize
    )
    {
        const label width = nSides*blockSize;
        const label n = x.size()/width;

        #pragma omp parallel for schedule(static)
        for (label i = 0; i < n; ++i)
        {
            for (label k = 0; k < width; ++k)
            {
                const label e = i*width + k;
                y[e] =
                    addToX
                  ? x[e] + alpha[k/blockSize]*y[e]
                  : y[e] + alpha[k/blockSize]*x[e];
            }
        }
    }

    //- Remove the mean over all particles of each unknown
    static void removeMean(scalarField& x, const label width)
    {
        const label n = x.size()/width;
        for (label k = 0; k < width; ++k)
        {
            scalar mean = 0;
            for (label i = 0; i < n; ++i)
            {
                mean += x[i*width + k];
            }
            mean /= n;
            for (label i = 0; i < n; ++i)
            {
                x[i*width + k] -= mean;
            }
        }
    }
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::pairGraph::pairGraph
(
    const label nParticles,
    const labelUList& owner,
    const labelUList& neighbour
)
:
    nParticles_(nParticles),
    start_(nParticles + 1, Zero),
    other_(2*owner.size()),
    pair_(2*owner.size())
{
    forAll(owner, pairi)
    {
        ++start_[owner[pairi] + 1];
        ++start_[neighbour[pairi] + 1];
    }
    for (label i = 0; i < nParticles; ++i)
    {
        start_[i + 1] += start_[i];
    }

    labelList next(start_);
    forAll(owner, pairi)
    {
        const label i = owner[pairi];
        const label j = neighbour[pairi];
        other_[next[i]] = j;
        pair_[next[i]++] = pairi;
        other_[next[j]] = i;
        pair_[next[j]++] = pairi;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::SPH::pairGraph::performance Foam::SPH::pairGraph::solve
(
    const linearMap& A,
    const linearMap& precondition,
    const scalarField& b,
    scalarField& x,
    const label nSides,
    const label blockSize,
    const bool singular,
    const scalar tolerance,
    const label maxIterations
) const
{
    // Round-off that no further iteration removes
    const label patience = 300;

    const label width = nSides*blockSize;
    scalarField r(b.size());
    scalarField z(b.size());
    scalarField Ap(b.size());

    A(x, Ap);
    r = b - Ap;
    if (singular)
    {
        removeMean(r, width);
    }

    precondition(r, z);
    if (singular)
    {
        removeMean(z, width);
    }
    scalarField p(z);
    scalarField best(x);

    scalarField rz(nSides);
    scalarField rzOld(nSides);
    scalarField pAp(nSides);
    scalarField alpha(nSides);
    dots(r, z, nSides, blockSize, rz);

    label iteration = 0;
    label bestIteration = 0;
    scalar residual = max(mag(r));
    scalar bestResidual = residual;
    for
    (
        ;
        iteration < maxIterations
     && residual > tolerance
     && iteration < bestIteration + patience;
        ++iteration
    )
    {
        A(p, Ap);
        dots(p, Ap, nSides, blockSize, pAp);

        forAll(alpha, s)
        {
            alpha[s] = pAp[s] > VSMALL ? rz[s]/pAp[s] : 0;
        }
        axpy<false>(alpha, p, x, nSides, blockSize);
        axpy<false>(-alpha, Ap, r, nSides, blockSize);

        precondition(r, z);
        if (singular)
        {
            removeMean(z, width);
        }
        rzOld = rz;
        dots(r, z, nSides, blockSize, rz);
        forAll(alpha, s)
        {
            alpha[s] = rzOld[s] > VSMALL*VSMALL ? rz[s]/rzOld[s] : 0;
        }
        axpy<true>(alpha, z, p, nSides, blockSize);

        residual = max(mag(r));
        if (residual < 0.9*bestResidual)
        {
            best = x;
            bestResidual = residual;
            bestIteration = iteration;
        }
    }

    if (residual > tolerance)
    {
        x = best;
        residual = bestResidual;
    }

    return {iteration, residual};
}


// ************************************************************************* //
