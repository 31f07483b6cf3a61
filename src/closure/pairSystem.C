/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "pairSystem.H"
#include "blockVectors.H"

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

    multiply(x, Ap, nSides);
    r = b - Ap;
    if (singular)
    {
        removeMean(r, width);
    }

    precondition(M, r, z, nSides);
    if (singular)
    {
        removeMean(z, width);
    }
    scalarField p(z);
    scalarField best(x);

    scalarField rz(nSides);
    scalarField rzOld(nSides);
    scalarField pAp(nSides);
    scalarField zAp(nSides);
    scalarField alpha(nSides);
    dots(r, z, nSides, blockSize_, rz);

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
        dots(p, Ap, nSides, blockSize_, pAp);

        forAll(alpha, s)
        {
            alpha[s] = pAp[s] > VSMALL ? rz[s]/pAp[s] : 0;
        }
        addScaled(alpha, p, x, nSides, blockSize_);
        alpha.negate();
        addScaled(alpha, Ap, r, nSides, blockSize_);
        if (singular)
        {
            // Round-off that A does not see
            removeMean(r, width);
        }

        precondition(M, r, z, nSides);
        if (singular)
        {
            removeMean(z, width);
        }

        // Of the change of the residual, -alpha A p, instead of the residual:
        // flexible, for a preconditioner that is not linear
        rzOld = rz;
        dots(r, z, nSides, blockSize_, rz);
        dots(Ap, z, nSides, blockSize_, zAp);
        forAll(alpha, s)
        {
            alpha[s] = rzOld[s] > VSMALL ? alpha[s]*zAp[s]/rzOld[s] : 0;
        }
        scaleAndAdd(alpha, z, p, nSides, blockSize_);

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
