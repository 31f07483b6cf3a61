/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "pairGraph.H"
#include "blockVectors.H"
#include "DynamicList.H"
#include "messageStream.H"

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

void Foam::SPH::pairGraph::performance::log
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


Foam::labelList Foam::SPH::pairGraph::connectedSets() const
{
    labelList sets(nParticles_, -1);
    label nSets = 0;
    DynamicList<label> reached;
    forAll(sets, first)
    {
        if (sets[first] >= 0)
        {
            continue;
        }
        sets[first] = nSets;
        reached.append(first);
        while (reached.size())
        {
            forLinks
            (
                reached.remove(),
                [&](const label j, const label)
                {
                    if (sets[j] < 0)
                    {
                        sets[j] = nSets;
                        reached.append(j);
                    }
                }
            );
        }
        ++nSets;
    }
    return sets;
}


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
    scalarField zAp(nSides);
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
        addScaled(alpha, p, x, nSides, blockSize);
        alpha.negate();
        addScaled(alpha, Ap, r, nSides, blockSize);
        if (singular)
        {
            // Round-off that A does not see
            removeMean(r, width);
        }

        precondition(r, z);
        if (singular)
        {
            removeMean(z, width);
        }

        // Of the change of the residual, -alpha A p, instead of the residual:
        // flexible, for a preconditioner that is not linear
        rzOld = rz;
        dots(r, z, nSides, blockSize, rz);
        dots(Ap, z, nSides, blockSize, zAp);
        forAll(alpha, s)
        {
            alpha[s] = rzOld[s] > VSMALL ? alpha[s]*zAp[s]/rzOld[s] : 0;
        }
        scaleAndAdd(alpha, z, p, nSides, blockSize);

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
