/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "blockVectors.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Call f(e, s) for every entry e of every side s
    template<class Function>
    static void forEntries
    (
        const label size,
        const label nSides,
        const label blockSize,
        Function&& f
    )
    {
        const label width = nSides*blockSize;
        const label n = size/width;

        #pragma omp parallel for schedule(static) if (n > 2000)
        for (label i = 0; i < n; ++i)
        {
            for (label s = 0; s < nSides; ++s)
            {
                for (label k = 0; k < blockSize; ++k)
                {
                    f(i*width + s*blockSize + k, s);
                }
            }
        }
    }
}
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::SPH::dots
(
    const scalarField& a,
    const scalarField& b,
    const label nSides,
    const label blockSize,
    scalarField& result
)
{
    // Chunks of fixed size, summed in their order
    const label chunk = 4096;
    const label n = a.size()/(nSides*blockSize);
    const label nChunks = (n + chunk - 1)/chunk;

    scalarField partial(nChunks*nSides, Zero);

    #pragma omp parallel for schedule(static) if (nChunks > 1)
    for (label c = 0; c < nChunks; ++c)
    {
        const label end = min((c + 1)*chunk, n);
        label e = c*chunk*nSides*blockSize;
        for (label i = c*chunk; i < end; ++i)
        {
            for (label s = 0; s < nSides; ++s)
            {
                for (label k = 0; k < blockSize; ++k)
                {
                    partial[c*nSides + s] += a[e]*b[e];
                    ++e;
                }
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


void Foam::SPH::addScaled
(
    const scalarField& alpha,
    const scalarField& x,
    scalarField& y,
    const label nSides,
    const label blockSize
)
{
    forEntries
    (
        x.size(),
        nSides,
        blockSize,
        [&](const label e, const label s) { y[e] += alpha[s]*x[e]; }
    );
}


void Foam::SPH::scaleAndAdd
(
    const scalarField& alpha,
    const scalarField& x,
    scalarField& y,
    const label nSides,
    const label blockSize
)
{
    forEntries
    (
        x.size(),
        nSides,
        blockSize,
        [&](const label e, const label s) { y[e] = x[e] + alpha[s]*y[e]; }
    );
}


void Foam::SPH::removeMean(scalarField& x, const label width)
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

// ************************************************************************* //
