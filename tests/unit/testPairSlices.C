/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleScene.H"
#include "haloExchange.H"
#include "pairSlices.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Part of the particles as a rank has them, with its halo behind
struct part
{
    particleMeshData data;

    //- Particle of the whole case of each particle, halo included
    labelList whole;

    part(const particleMesh& all, const boolList& isMine)
    {
        labelList local(all.nParticles(), -1);
        DynamicList<label> numbers;
        forAll(local, i)
        {
            if (isMine[i])
            {
                local[i] = numbers.size();
                numbers.append(i);
            }
        }
        const label n = numbers.size();

        DynamicList<label> pairs;
        DynamicList<label> owner;
        DynamicList<label> neighbour;
        DynamicList<vector> Sf;
        DynamicList<vector> delta;
        forAll(all.owner(), pairi)
        {
            const label i = all.owner()[pairi];
            const label j = all.neighbour()[pairi];
            if (!isMine[i] && !isMine[j])
            {
                continue;
            }
            for (const label k : {i, j})
            {
                if (local[k] < 0)
                {
                    local[k] = numbers.size();
                    numbers.append(k);
                }
            }

            const bool reversed = !isMine[i];
            const scalar sign = reversed ? -1 : 1;
            data.reversed.set(pairs.size(), reversed);
            pairs.append(pairi);
            owner.append(min(local[i], local[j]));
            neighbour.append(max(local[i], local[j]));
            Sf.append(sign*all.Sf()[pairi]);
            delta.append(sign*all.delta()[pairi]);
        }
        whole = numbers;

        const labelUList mine(labelList::subList(whole, n));
        data.points = pointField(all.C(), mine);
        data.V = scalarField(all.V(), mine);
        data.spacing = scalarField(all.spacing(), mine);
        data.owner = owner;
        data.neighbour = neighbour;
        data.Sf = Sf;
        data.delta = delta;
        data.skew = vectorField(all.skew(), pairs);
        data.boundary.start.setSize(all.mesh().boundary().size() + 1, 0);
        data.halo = mapDistribute
        (
            whole.size(), labelListList(1), labelListList(1)
        );
    }
};

//- Of each row of the particle's slice, forward or backward, its entry, as
//- long as it has pairs
labelList pairsOf
(
    const pairSlices& slices,
    const label i,
    const bool forward
)
{
    const pairSlices::rows rows =
        forward ? slices.forward(i/nLanes) : slices.backward(i/nLanes);

    DynamicList<label> entries;
    for (label row = rows.begin; row < rows.end; ++row)
    {
        const label e = row*nLanes + i % nLanes;
        if (rows.neighbour[e] != i)
        {
            entries.append(e);
        }
    }
    return labelList(std::move(entries));
}


label neighbourOf
(
    const pairSlices& slices,
    const label entry,
    const bool forward
)
{
    return
        (forward ? slices.forward(0) : slices.backward(0)).neighbour[entry];
}

} // End namespace


// * * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * //

TEST(PairSlices, OfAPartHoldWhatThoseOfTheWholeCaseHold)
{
    const auto scene = particleScene::New("periodic", 0.3);
    const auto all = scene->assemble("type consistent; order 1;");
    const pairSlices wholeSlices(*all, GREAT);

    for (const bool left : {true, false})
    {
        const scalar middle = average(all->C().component(vector::X)());
        boolList isMine(all->nParticles());
        forAll(isMine, i)
        {
            isMine[i] = (all->C()[i].x() < middle) == left;
        }
        part mine(*all, isMine);
        const labelList numbers(mine.whole);
        ASSERT_TRUE(mine.data.reversed.any());

        const particleMesh particles
        (
            all->mesh(), all->properties(), std::move(mine.data)
        );
        const pairSlices slices(particles, GREAT);
        const label n = particles.nParticles();
        ASSERT_GT(particles.nHalo(), 0);

        Map<label> haloOf;
        for (label k = n; k < numbers.size(); ++k)
        {
            haloOf.insert(haloExchange::index(particles, k), numbers[k]);
        }

        // Forward pairs from the halo are those of the particles that are
        // not here, but for pairs that do not lead here
        const auto wholeOf = [&](const label j)
        {
            return j < n ? numbers[j] : haloOf[j];
        };
        const label nGeometry = 3*all->nDims() + 1;
        const auto expectSame = [&]
        (
            const label e,
            const label wholeE
        )
        {
            for (label c = 0; c < nGeometry; ++c)
            {
                EXPECT_EQ
                (
                    slices.geometry()(e, c), wholeSlices.geometry()(wholeE, c)
                );
            }
        };

        labelHashSet outer;
        for (label i = 0; i < n; ++i)
        {
            for (const bool forward : {true, false})
            {
                const auto entries = pairsOf(slices, i, forward);
                const auto wholeEntries =
                    pairsOf(wholeSlices, numbers[i], forward);
                ASSERT_EQ(entries.size(), wholeEntries.size());

                forAll(entries, k)
                {
                    const label j = neighbourOf(slices, entries[k], forward);
                    EXPECT_EQ
                    (
                        wholeOf(j),
                        neighbourOf(wholeSlices, wholeEntries[k], forward)
                    );
                    if (j >= n)
                    {
                        outer.insert(i/nLanes);
                    }

                    if (forward)
                    {
                        expectSame(entries[k], wholeEntries[k]);
                        continue;
                    }
                    const label e = slices.entry()[entries[k]];
                    expectSame(e, wholeSlices.entry()[wholeEntries[k]]);
                    EXPECT_EQ(neighbourOf(slices, e, true), i);
                    for (label d = 0; d < all->nDims(); ++d)
                    {
                        EXPECT_EQ
                        (
                            slices.backwardArea()(entries[k], d),
                            wholeSlices.backwardArea()(wholeEntries[k], d)
                        );
                    }
                }
            }
        }

        EXPECT_EQ(slices.outerSlices(), outer.sortedToc());
        EXPECT_EQ
        (
            slices.innerSlices().size() + slices.outerSlices().size(),
            slices.nSlices()
        );
        for (const label slice : slices.innerSlices())
        {
            EXPECT_FALSE(outer.found(slice));
        }
    }
}


// ************************************************************************* //
