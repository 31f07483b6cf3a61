/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    Coarse levels of the multigrid.

\*---------------------------------------------------------------------------*/

#include "pairMultigrid.H"

// The AVX-512 headers of gcc 12 leave values undefined on purpose
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <Eigen/Dense>
#pragma GCC diagnostic pop

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
namespace
{
    typedef Eigen::Matrix
    <
        scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor
    > denseMatrix;

    //- Largest coarsest system, in unknowns with their blocks
    const label maxDense = 150;

    //- Fraction of the largest eigenvalue that counts as zero
    const scalar nullSpace = 1e-10;

    //- Fraction of its trace that keeps a singular block invertible
    const scalar shift = 1e-6;

    //- The particles' own system, whose blocks are computed as needed
    struct particleSource
    {
        const pairGraph& graph;
        const pairMultigrid::blockFunction& pairBlock;
        const pairMultigrid::blockFunction& particleBlock;

        label size() const
        {
            return graph.nParticles();
        }

        template<class Function>
        void forLinks(const label i, Function&& f) const
        {
            scalar block[9];
            graph.forLinks
            (
                i,
                [&](const label j, const label pairi)
                {
                    pairBlock(pairi, block);
                    f(j, block);
                }
            );
        }

        void addAnchor(const label i, const label n, scalar* sum) const
        {
            scalar block[9];
            particleBlock(i, block);
            for (label k = 0; k < n; ++k)
            {
                sum[k] += block[k];
            }
        }
    };

    //- The traces of another source's blocks: how strong pairs are
    template<class Source>
    struct traceSource
    {
        const Source& source;
        label blockSize;

        label size() const
        {
            return source.size();
        }

        template<class Function>
        void forLinks(const label i, Function&& f) const
        {
            source.forLinks
            (
                i,
                [&](const label j, const scalar* block)
                {
                    scalar trace = 0;
                    for (label k = 0; k < blockSize; ++k)
                    {
                        trace += block[k*(blockSize + 1)];
                    }
                    f(j, &trace);
                }
            );
        }

        void addAnchor(const label, const label, scalar*) const
        {}
    };

    //- The system of a level
    template<class Level>
    struct levelSource
    {
        const Level& l;
        label n;

        label size() const
        {
            return l.size();
        }

        template<class Function>
        void forLinks(const label i, Function&& f) const
        {
            for (label k = l.start[i]; k < l.start[i + 1]; ++k)
            {
                f(l.other[k], &l.blocks[k*n]);
            }
        }

        void addAnchor(const label i, const label, scalar* sum) const
        {
            for (label k = 0; k < n; ++k)
            {
                sum[k] += l.anchor[i*n + k];
            }
        }
    };
}
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Source>
Foam::label Foam::SPH::pairMultigrid::match
(
    const Source& source,
    labelList& aggregate
) const
{
    aggregate = labelList(source.size(), label(-1));
    label nAggregates = 0;

    const auto strongest = [&](const label i, const bool matched)
    {
        label best = -1;
        scalar strength = 0;
        source.forLinks
        (
            i,
            [&](const label j, const scalar* trace)
            {
                if
                (
                    j != i
                 && *trace > strength
                 && (aggregate[j] >= 0) == matched
                )
                {
                    best = j;
                    strength = *trace;
                }
            }
        );
        return best;
    };

    for (label i = 0; i < source.size(); ++i)
    {
        if (aggregate[i] < 0)
        {
            const label partner = strongest(i, false);
            if (partner >= 0)
            {
                aggregate[i] = aggregate[partner] = nAggregates++;
            }
            else
            {
                // All neighbours are taken: join one of them
                const label host = strongest(i, true);
                aggregate[i] = host >= 0 ? aggregate[host] : nAggregates++;
            }
        }
    }

    return nAggregates;
}


template<class Source>
Foam::SPH::pairMultigrid::level Foam::SPH::pairMultigrid::coarsen
(
    const Source& source,
    const label blockSize,
    labelList&& aggregate,
    const label nCoarse
) const
{
    const label bb = blockSize*blockSize;

    labelList memberStart(nCoarse + 1, Zero);
    for (const label a : aggregate)
    {
        ++memberStart[a + 1];
    }
    for (label a = 0; a < nCoarse; ++a)
    {
        memberStart[a + 1] += memberStart[a];
    }
    labelList members(aggregate.size());
    {
        labelList next(memberStart);
        forAll(aggregate, i)
        {
            members[next[aggregate[i]]++] = i;
        }
    }

    level l;
    l.start.setSize(nCoarse + 1);
    l.start[0] = 0;
    l.anchor = scalarField(nCoarse*bb, Zero);

    DynamicList<label> other(6*nCoarse);
    DynamicList<scalar> blocks(6*nCoarse*bb);
    labelList position(nCoarse, label(-1));

    for (label a = 0; a < nCoarse; ++a)
    {
        const label first = other.size();
        for (label m = memberStart[a]; m < memberStart[a + 1]; ++m)
        {
            source.addAnchor(members[m], bb, &l.anchor[a*bb]);
            source.forLinks
            (
                members[m],
                [&](const label j, const scalar* block)
                {
                    const label b = aggregate[j];
                    if (b == a)
                    {
                        return;
                    }
                    if (position[b] < first)
                    {
                        position[b] = other.size();
                        other.append(b);
                        blocks.setSize(blocks.size() + bb, scalar(0));
                    }
                    for (label k = 0; k < bb; ++k)
                    {
                        blocks[position[b]*bb + k] += block[k];
                    }
                }
            );
        }
        l.start[a + 1] = other.size();
    }

    l.aggregate.transfer(aggregate);
    l.other.transfer(other);
    l.blocks.transfer(blocks);

    return l;
}


template<class Source>
Foam::SPH::pairMultigrid::level Foam::SPH::pairMultigrid::nextLevel
(
    const Source& source,
    const label nPasses
) const
{
    // All passes work on the traces: blocks of all pairs would be many
    const traceSource<Source> traces{source, blockSize_};

    labelList aggregate;
    label n = match(traces, aggregate);
    level pairs(coarsen(traces, 1, labelList(aggregate), n));

    for (label pass = 1; pass < nPasses; ++pass)
    {
        const levelSource<level> pairSource{pairs, 1};

        labelList next;
        n = match(pairSource, next);
        for (label& a : aggregate)
        {
            a = next[a];
        }
        if (pass + 1 < nPasses)
        {
            pairs = coarsen(pairSource, 1, std::move(next), n);
        }
    }

    level l(coarsen(source, blockSize_, std::move(aggregate), n));
    setInverse(l);

    return l;
}


void Foam::SPH::pairMultigrid::setInverse(level& l) const
{
    const label b = blockSize_;
    const label bb = b*b;

    l.diagonal = l.anchor;
    l.inverse.setSize(l.diagonal.size());
    for (label i = 0; i < l.size(); ++i)
    {
        for (label k = l.start[i]; k < l.start[i + 1]; ++k)
        {
            for (label e = 0; e < bb; ++e)
            {
                l.diagonal[i*bb + e] += l.blocks[k*bb + e];
            }
        }

        denseMatrix D(Eigen::Map<denseMatrix>(&l.diagonal[i*bb], b, b));
        D.diagonal().array() += shift*D.trace() + VSMALL;
        Eigen::Map<denseMatrix>(&l.inverse[i*bb], b, b) = D.inverse();
    }
}


void Foam::SPH::pairMultigrid::setCoarsest()
{
    const level& l = levels_.back();
    const label b = blockSize_;
    const label n = l.size()*b;

    if (n > maxDense)
    {
        return;
    }

    denseMatrix A(denseMatrix::Zero(n, n));
    for (label i = 0; i < l.size(); ++i)
    {
        for (label r = 0; r < b; ++r)
        {
            for (label c = 0; c < b; ++c)
            {
                A(i*b + r, i*b + c) += l.diagonal[(i*b + r)*b + c];
                for (label k = l.start[i]; k < l.start[i + 1]; ++k)
                {
                    A(i*b + r, l.other[k]*b + c) -=
                        l.blocks[(k*b + r)*b + c];
                }
            }
        }
    }

    // Pseudo-inverse: constant vectors of each connected part are in the null
    // space of systems without anchors
    const Eigen::SelfAdjointEigenSolver<denseMatrix> spectrum(A);
    const auto& values = spectrum.eigenvalues();
    const scalar smallest = nullSpace*max(values[n - 1], VSMALL);

    denseMatrix inverse(denseMatrix::Zero(n, n));
    for (label e = 0; e < n; ++e)
    {
        if (values[e] > smallest)
        {
            const auto v = spectrum.eigenvectors().col(e);
            inverse += v*v.transpose()/values[e];
        }
    }

    coarsest_.setSize(n*n);
    Eigen::Map<denseMatrix>(coarsest_.data(), n, n) = inverse;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::pairMultigrid::pairMultigrid
(
    const pairGraph& graph,
    const label nDims,
    const label blockSize,
    const blockFunction& pairBlock,
    const blockFunction& particleBlock
)
:
    blockSize_(blockSize)
{
    levels_.push_back
    (
        nextLevel(particleSource{graph, pairBlock, particleBlock}, nDims)
    );

    // Particles without any pair keep a system from becoming smaller
    label previous = graph.nParticles();
    while
    (
        levels_.back().size()*blockSize_ > maxDense
     && levels_.back().size() < 0.8*previous
    )
    {
        previous = levels_.back().size();
        const levelSource<level> source
        {
            levels_.back(), blockSize_*blockSize_
        };
        levels_.push_back(nextLevel(source, nDims));
    }

    setCoarsest();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::SPH::pairMultigrid::gridComplexity() const
{
    scalar sum = 0;
    for (const level& l : levels_)
    {
        sum += l.size();
    }
    return sum/max(levels_.front().aggregate.size(), label(1));
}

// ************************************************************************* //
