/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "pairGraph.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::pairGraph::pairGraph
(
    const Time& time,
    const label nParticles,
    const labelUList& owner,
    const labelUList& neighbour
)
:
    time_(time),
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


// ************************************************************************* //
