/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "pairMultigrid.H"
#include "blockVectors.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Damping of the Jacobi smoother, whose largest eigenvalue is at most 2
    static const scalar damping = 0.7;

    //- Reduction of a coarse residual that one iteration must reach to be
    //- enough
    static const scalar enough = 0.25;

    //- y += M x for a block of a right-hand side
    static inline void addProduct
    (
        const label b,
        const scalar* M,
        const scalar* x,
        scalar* y
    )
    {
        for (label r = 0; r < b; ++r)
        {
            for (label c = 0; c < b; ++c)
            {
                y[r] += M[r*b + c]*x[c];
            }
        }
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::pairMultigrid::multiply
(
    const level& l,
    const scalarField& u,
    scalarField& v,
    const label nSides
) const
{
    const label b = blockSize_;
    const label width = nSides*b;
    const label n = l.size();

    #pragma omp parallel for schedule(static) if (n > 1000)
    for (label i = 0; i < n; ++i)
    {
        // Diagonal and links as differences would cost as much again
        scalar sum[9] = {};
        for (label k = l.start[i]; k < l.start[i + 1]; ++k)
        {
            const scalar* block = &l.blocks[k*b*b];
            const scalar* uj = &u[l.other[k]*width];
            for (label s = 0; s < nSides; ++s)
            {
                addProduct(b, block, uj + s*b, sum + s*b);
            }
        }

        scalar own[9] = {};
        for (label s = 0; s < nSides; ++s)
        {
            addProduct
            (
                b, &l.diagonal[i*b*b], &u[i*width + s*b], own + s*b
            );
        }
        for (label e = 0; e < width; ++e)
        {
            v[i*width + e] = own[e] - sum[e];
        }
    }
}


void Foam::SPH::pairMultigrid::jacobi
(
    const level& l,
    const scalarField& r,
    scalarField& z,
    const label nSides
) const
{
    const label b = blockSize_;
    const label width = nSides*b;
    const label n = l.size();

    #pragma omp parallel for schedule(static) if (n > 1000)
    for (label i = 0; i < n; ++i)
    {
        scalar product[9] = {};
        for (label s = 0; s < nSides; ++s)
        {
            addProduct
            (
                b, &l.inverse[i*b*b], &r[i*width + s*b], product + s*b
            );
        }
        std::copy(product, product + width, &z[i*width]);
    }
}


void Foam::SPH::pairMultigrid::cycle
(
    const label coarse,
    const pairGraph::linearMap& A,
    const pairGraph::linearMap& jacobi,
    const scalarField& r,
    scalarField& x,
    const label nSides
) const
{
    const label width = nSides*blockSize_;
    const level& l = levels_[coarse];
    const label n = r.size()/width;

    scalarField product(r.size());

    // Smooth from zero
    jacobi(r, x);
    x *= damping;

    // Correct
    A(x, product);
    scalarField coarseR(l.size()*width, Zero);
    for (label i = 0; i < n; ++i)
    {
        const label a = l.aggregate[i]*width;
        for (label e = 0; e < width; ++e)
        {
            coarseR[a + e] += r[i*width + e] - product[i*width + e];
        }
    }

    scalarField coarseX(coarseR.size());
    solve(coarse, coarseR, coarseX, nSides);

    #pragma omp parallel for schedule(static) if (n > 2000)
    for (label i = 0; i < n; ++i)
    {
        const label a = l.aggregate[i]*width;
        for (label e = 0; e < width; ++e)
        {
            x[i*width + e] += coarseX[a + e];
        }
    }

    // Smooth
    A(x, product);
    product = r - product;
    scalarField change(r.size());
    jacobi(product, change);
    x += damping*change;
}


void Foam::SPH::pairMultigrid::solve
(
    const label leveli,
    const scalarField& r,
    scalarField& x,
    const label nSides
) const
{
    const level& l = levels_[leveli];
    const label b = blockSize_;

    const auto smooth = [&](const scalarField& u, scalarField& v)
    {
        jacobi(l, u, v, nSides);
    };
    const auto A = [&](const scalarField& u, scalarField& v)
    {
        multiply(l, u, v, nSides);
    };

    if (leveli + 1 == label(levels_.size()))
    {
        if (coarsest_.empty())
        {
            smooth(r, x);
            return;
        }

        const label n = l.size()*b;
        x = 0;
        for (label i = 0; i < n; ++i)
        {
            for (label j = 0; j < n; ++j)
            {
                for (label s = 0; s < nSides; ++s)
                {
                    x[(i/b*nSides + s)*b + i % b] +=
                        coarsest_[i*n + j]*r[(j/b*nSides + s)*b + j % b];
                }
            }
        }
        return;
    }

    // First iteration of flexible conjugate gradients
    scalarField first(r.size());
    scalarField Afirst(r.size());
    cycle(leveli + 1, A, smooth, r, first, nSides);
    A(first, Afirst);

    scalarField rr(nSides);
    scalarField alpha(nSides);
    scalarField curvature(nSides);
    dots(r, r, nSides, b, rr);
    dots(first, r, nSides, b, alpha);
    dots(first, Afirst, nSides, b, curvature);
    forAll(alpha, s)
    {
        alpha[s] = curvature[s] > VSMALL ? alpha[s]/curvature[s] : 0;
    }

    scalarField rest(r);
    addScaled(scalarField(-alpha), Afirst, rest, nSides, b);

    x = 0;
    addScaled(alpha, first, x, nSides, b);

    scalarField restRest(nSides);
    dots(rest, rest, nSides, b, restRest);
    if (max(restRest - sqr(enough)*rr) <= 0)
    {
        return;
    }

    // Second iteration, orthogonal to the first
    scalarField second(r.size());
    scalarField Asecond(r.size());
    cycle(leveli + 1, A, smooth, rest, second, nSides);
    A(second, Asecond);

    scalarField overlap(nSides);
    scalarField secondCurvature(nSides);
    scalarField beta(nSides);
    dots(second, Afirst, nSides, b, overlap);
    dots(second, Asecond, nSides, b, secondCurvature);
    dots(second, rest, nSides, b, beta);
    forAll(beta, s)
    {
        overlap[s] = curvature[s] > VSMALL ? overlap[s]/curvature[s] : 0;

        const scalar rest = secondCurvature[s] - sqr(overlap[s])*curvature[s];
        beta[s] = rest > 1e-6*secondCurvature[s] + VSMALL ? beta[s]/rest : 0;
    }
    addScaled(beta, second, x, nSides, b);
    addScaled(scalarField(-beta*overlap), first, x, nSides, b);
}

// ************************************************************************* //
