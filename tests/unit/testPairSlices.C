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

} // End namespace


// * * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * //

TEST(PairSlices, OfAPartHoldWhatThoseOfTheWholeCaseHold)
{
    const auto scene = particleScene::New("periodic", 0.3);
    const auto all = scene->assemble("type consistent; order 1;");
    const pairSlices wholeSlices(*all);

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
        const pairSlices slices(particles);
        const label n = particles.nParticles();
        ASSERT_GT(particles.nHalo(), 0);

        Map<label> haloOf;
        for (label k = n; k < numbers.size(); ++k)
        {
            haloOf.insert(haloExchange::index(particles, k), numbers[k]);
        }

        labelHashSet outer;
        for (label i = 0; i < n; ++i)
        {
            const label a = numbers[i]/nLanes;
            const label b = i/nLanes;
            const label nRows =
                min
                (
                    wholeSlices.start(a + 1) - wholeSlices.start(a),
                    slices.start(b + 1) - slices.start(b)
                );
            for (label row = 0; row < nRows; ++row)
            {
                const label e =
                    (wholeSlices.start(a) + row)*nLanes + numbers[i] % nLanes;
                const label f = (slices.start(b) + row)*nLanes + i % nLanes;
                const label j = slices.neighbour()[f];

                EXPECT_EQ
                (
                    j < n ? numbers[j] : haloOf[j], wholeSlices.neighbour()[e]
                );
                EXPECT_EQ(slices.area()[f], wholeSlices.area()[e]);
                EXPECT_EQ(slices.gradWeight()[f], wholeSlices.gradWeight()[e]);
                for (label d = 0; d < all->nDims(); ++d)
                {
                    EXPECT_EQ(slices.n(d)[f], wholeSlices.n(d)[e]);
                    EXPECT_EQ(slices.delta(d)[f], wholeSlices.delta(d)[e]);
                    EXPECT_EQ(slices.skew(d)[f], wholeSlices.skew(d)[e]);
                }
                if (j >= n)
                {
                    outer.insert(b);
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
