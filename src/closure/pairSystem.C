/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include <Eigen/Core>

#include "pairSystem.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- A row for each particle: the unknowns of each side one after the other
    typedef Eigen::Array
    <
        scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor
    > blockRows;
    typedef Eigen::Array<scalar, 1, Eigen::Dynamic> blockRow;

    static Eigen::Map<blockRows> rows(scalarField& x, const label width)
    {
        return Eigen::Map<blockRows>(x.data(), x.size()/width, width);
    }

    //- Dot product of each side, for each of its unknowns
    static blockRow dots
    (
        scalarField& a,
        scalarField& b,
        const label width,
        const label blockSize
    )
    {
        blockRow sums((rows(a, width)*rows(b, width)).colwise().sum());
        for (label first = 0; first < width; first += blockSize)
        {
            scalar sum = 0;
            for (label k = 0; k < blockSize; ++k)
            {
                sum += sums[first + k];
            }
            sums.segment(first, blockSize) = sum;
        }
        return sums;
    }

    //- a/b, zero where b is
    static blockRow ratio(const blockRow& a, const blockRow& b)
    {
        return a.binaryExpr
        (
            b,
            [](const scalar x, const scalar y) { return y > VSMALL ? x/y : 0; }
        );
    }
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::pairSystem::pairSystem
(
    const pairGraph& graph,
    const scalarField& weights
)
:
    graph_(graph),
    blockSize_(1),
    k_(sqrt(weights)*vector(1, 0, 0)),
    anchors_(graph.nParticles(), Zero),
    x_()
{}


Foam::SPH::pairSystem::pairSystem
(
    const pairGraph& graph,
    const label nDims,
    const vectorField& k,
    const tensorField& anchors,
    const vectorField& x
)
:
    graph_(graph),
    blockSize_(nDims),
    k_(k),
    anchors_(anchors),
    x_(x)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::pairSystem::multiply
(
    const scalarField& u,
    scalarField& v,
    const label nSides
) const
{
    const label b = blockSize_;
    const label width = nSides*b;

    #pragma omp parallel for schedule(static)
    for (label i = 0; i < graph_.nParticles(); ++i)
    {
        scalar sum[9] = {};
        const scalar* ui = &u[i*width];
        for (label e = 0; e < width; ++e)
        {
            for (label c = 0; c < b; ++c)
            {
                sum[e] += anchors_[i](e % b, c)*ui[e - e % b + c];
            }
        }
        graph_.forLinks
        (
            i,
            [&](const label j, const label pairi)
            {
                const scalar* uj = &u[j*width];
                const vector& k = k_[pairi];
                for (label first = 0; first < width; first += b)
                {
                    scalar stretch = 0;
                    for (label c = 0; c < b; ++c)
                    {
                        stretch += k[c]*(ui[first + c] - uj[first + c]);
                    }
                    for (label c = 0; c < b; ++c)
                    {
                        sum[first + c] += stretch*k[c];
                    }
                }
            }
        );
        std::copy(sum, sum + width, &v[i*width]);
    }
}


Foam::PtrList<Foam::SPH::componentPreconditioner>
Foam::SPH::pairSystem::preconditioners() const
{
    // Of its trace: keeps the block of a particle with parallel faces regular
    constexpr scalar parallelFaces = 1e-6;

    // GAMG refuses matrices that it cannot coarsen
    constexpr label leastCoarsened = 10;

    scalarField least(tr(anchors_));
    forAll(least, i)
    {
        graph_.forLinks
        (
            i,
            [&](const label, const label pairi)
            {
                least[i] += magSqr(k_[pairi]);
            }
        );
        least[i] = least[i] > VSMALL ? parallelFaces*least[i] : GREAT;
    }

    PtrList<componentPreconditioner> result(blockSize_);
    forAll(result, c)
    {
        result.set
        (
            c,
            new componentPreconditioner
            (
                graph_,
                sqr(k_.component(c)),
                anchors_.component(4*c),
                least,
                x_.empty()
              ? identity(graph_.nParticles())
              : sortedOrder(x_.component(c)()),
                x_.empty() && graph_.nParticles() > leastCoarsened
              ? "GAMG"
              : "DIC"
            )
        );
    }
    return result;
}


void Foam::SPH::pairSystem::precondition
(
    const PtrList<componentPreconditioner>& preconditioners,
    const scalarField& r,
    scalarField& z,
    const label nSides
) const
{
    const label width = nSides*blockSize_;
    for (label e = 0; e < width; ++e)
    {
        preconditioners[e % blockSize_].precondition(z, r, width, e);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::pairSystem::performance::log
(
    const char* what,
    const scalar tolerance
) const
{
    Info<< "    " << what << ": " << nIterations
        << " iterations, residual/tolerance " << residual/tolerance << endl;

    if (!(residual <= 10*tolerance))
    {
        WarningInFunction
            << what << " did not converge: see the residuals of checkSphMesh"
            << endl;
    }
}


Foam::SPH::pairSystem::performance Foam::SPH::pairSystem::solve
(
    const scalarField& b,
    scalarField& x,
    const label nSides,
    const bool singular,
    const scalar tolerance,
    const label maxIterations
) const
{
    // Round-off that no further iteration removes
    const label patience = 300;

    const PtrList<componentPreconditioner> M(preconditioners());
    const label width = nSides*blockSize_;
    scalarField r(b.size());
    scalarField z(b.size());
    scalarField Ap(b.size());

    // Of the residual it is round-off that A does not see
    const auto removeMean = [&](scalarField& values)
    {
        if (singular)
        {
            const blockRow mean(rows(values, width).colwise().mean());
            rows(values, width).rowwise() -= mean;
        }
    };

    multiply(x, Ap, nSides);
    r = b - Ap;
    removeMean(r);
    precondition(M, r, z, nSides);
    removeMean(z);
    scalarField p(z);
    scalarField best(x);
    blockRow rz(dots(r, z, width, blockSize_));

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
        multiply(p, Ap, nSides);

        const blockRow alpha(ratio(rz, dots(p, Ap, width, blockSize_)));
        rows(x, width) += rows(p, width).rowwise()*alpha;
        rows(r, width) -= rows(Ap, width).rowwise()*alpha;
        removeMean(r);
        precondition(M, r, z, nSides);
        removeMean(z);

        // Of the change of the residual, -alpha A p, instead of the residual:
        // flexible, for a preconditioner that is not linear
        const blockRow beta
        (
           -ratio(alpha*dots(Ap, z, width, blockSize_), rz)
        );
        rows(p, width) = rows(p, width).rowwise()*beta + rows(z, width);
        rz = dots(r, z, width, blockSize_);

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
