/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "pairLaplacian.H"
#include "pairMultigrid.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::SPH::pairGraph::performance Foam::SPH::solveLaplacian
(
    const pairGraph& graph,
    const label nDims,
    const scalarField& w,
    const scalarField& b,
    scalarField& x,
    const label nSides,
    const scalar tolerance,
    const label maxIterations
)
{
    const label n = graph.nParticles();

    scalarField diagonal(n, Zero);
    for (label i = 0; i < n; ++i)
    {
        graph.forLinks
        (
            i,
            [&](const label, const label pairi)
            {
                diagonal[i] += w[pairi];
            }
        );
        diagonal[i] = max(diagonal[i], VSMALL);
    }

    const auto A = [&](const scalarField& u, scalarField& v)
    {
        #pragma omp parallel for schedule(static)
        for (label i = 0; i < n; ++i)
        {
            scalar sum[9] = {};
            const scalar* ui = &u[i*nSides];
            graph.forLinks
            (
                i,
                [&](const label j, const label pairi)
                {
                    const scalar* uj = &u[j*nSides];
                    for (label s = 0; s < nSides; ++s)
                    {
                        sum[s] += w[pairi]*(ui[s] - uj[s]);
                    }
                }
            );
            std::copy(sum, sum + nSides, &v[i*nSides]);
        }
    };

    const auto jacobi = [&](const scalarField& r, scalarField& z)
    {
        #pragma omp parallel for schedule(static)
        for (label i = 0; i < n; ++i)
        {
            for (label s = 0; s < nSides; ++s)
            {
                z[i*nSides + s] = r[i*nSides + s]/diagonal[i];
            }
        }
    };

    const pairMultigrid multigrid
    (
        graph,
        nDims,
        1,
        [&](const label pairi, scalar* block) { *block = w[pairi]; },
        [](const label, scalar* block) { *block = 0; }
    );

    return graph.solve
    (
        A,
        [&](const scalarField& r, scalarField& z)
        {
            multigrid.precondition(A, jacobi, r, z, nSides);
        },
        b,
        x,
        nSides,
        1,
        true,
        tolerance,
        maxIterations
    );
}

// ************************************************************************* //
