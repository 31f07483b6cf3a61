/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "orientedSurface.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
namespace
{

//- Disjoint sets of elements
class disjointSets
{
    labelList parent_;

public:

    explicit disjointSets(const label n)
    :
        parent_(identity(n))
    {}

    label root(label i)
    {
        while (parent_[i] != i)
        {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }

    void join(const label i, const label j)
    {
        parent_[root(i)] = root(j);
    }

    //- Number the sets from zero
    labelList number(label& nSets)
    {
        labelList setOfRoot(parent_.size(), -1);
        labelList sets(parent_.size());
        nSets = 0;

        forAll(sets, i)
        {
            label& s = setOfRoot[root(i)];
            if (s < 0)
            {
                s = nSets++;
            }
            sets[i] = s;
        }
        return sets;
    }
};


//- Is each part closed by itself, at the sides where the whole is closed
bool partsClosed
(
    const UList<orientedSurface::side>& sides,
    const labelUList& starts,
    const labelUList& part,
    const label nParts
)
{
    labelList balance(nParts, Zero);

    for (label g = 0; g + 1 < starts.size(); ++g)
    {
        label total = 0;
        for (label k = starts[g]; k < starts[g+1]; ++k)
        {
            const label sign = sides[k].forward ? 1 : -1;
            balance[part[sides[k].elementi]] += sign;
            total += sign;
        }

        bool closed = true;
        for (label k = starts[g]; k < starts[g+1]; ++k)
        {
            label& b = balance[part[sides[k].elementi]];
            closed = closed && b == 0;
            b = 0;
        }

        if (total == 0 && !closed)
        {
            return false;
        }
    }

    return true;
}

} // End anonymous namespace
} // End namespace SPH
} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::SPH::orientedSurface::side>
Foam::SPH::orientedSurface::sides() const
{
    const label nDims = space_.nDims();

    DynamicList<side> sides(nDims*elements_.size());

    forAll(elements_, elementi)
    {
        const FixedList<label, 3>& v = elements_[elementi].vertices;

        if (nDims == 2)
        {
            sides.append({labelPair(-1, v[0]), elementi, false});
            sides.append({labelPair(-1, v[1]), elementi, true});
        }
        else if (nDims == 3)
        {
            for (label k = 0; k < 3; ++k)
            {
                const label a = v[k];
                const label b = v[(k + 1) % 3];

                sides.append
                (
                    {labelPair(min(a, b), max(a, b)), elementi, a < b}
                );
            }
        }
    }

    std::stable_sort(sides.begin(), sides.end());

    return List<side>(std::move(sides));
}


Foam::labelList Foam::SPH::orientedSurface::groups(const UList<side>& sides)
{
    DynamicList<label> starts(sides.size()/2 + 1);

    forAll(sides, i)
    {
        if (i == 0 || sides[i].vertices != sides[i-1].vertices)
        {
            starts.append(i);
        }
    }
    starts.append(sides.size());

    return labelList(std::move(starts));
}


Foam::labelList Foam::SPH::orientedSurface::openElements() const
{
    const List<side> allSides(sides());
    const labelList starts(groups(allSides));

    DynamicList<label> open;

    for (label g = 0; g + 1 < starts.size(); ++g)
    {
        label balance = 0;
        for (label k = starts[g]; k < starts[g+1]; ++k)
        {
            balance += allSides[k].forward ? 1 : -1;
        }

        for (label k = starts[g]; balance != 0 && k < starts[g+1]; ++k)
        {
            open.append(allSides[k].elementi);
        }
    }

    // In 1-D the directions must alternate, starting with the lowest point
    if (space_.nDims() == 1)
    {
        labelList order(identity(size()));
        std::sort
        (
            order.begin(),
            order.end(),
            [&](const label a, const label b)
            {
                const label d = space_.axis(0);
                return centre(a)[d] < centre(b)[d];
            }
        );

        forAll(order, i)
        {
            const bool lower = (i % 2 == 0);
            const bool last = (i == size() - 1);

            if (elements_[order[i]].reversed != lower || (last && lower))
            {
                open.append(order[i]);
            }
        }
    }

    return labelList(std::move(open));
}


Foam::labelList Foam::SPH::orientedSurface::parts(label& nParts) const
{
    const List<side> allSides(sides());
    const labelList starts(groups(allSides));

    // First without the sides where several parts may touch
    disjointSets sets(size());

    for (const bool manifoldOnly : {true, false})
    {
        for (label g = 0; g + 1 < starts.size(); ++g)
        {
            const label n = starts[g+1] - starts[g];

            for (label k = 1; k < n && (n == 2 || !manifoldOnly); ++k)
            {
                sets.join
                (
                    allSides[starts[g]].elementi,
                    allSides[starts[g] + k].elementi
                );
            }
        }

        const labelList part(sets.number(nParts));

        if (!manifoldOnly || partsClosed(allSides, starts, part, nParts))
        {
            return part;
        }
    }

    return labelList();
}


// ************************************************************************* //
