/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particlePairs.H"
#include "cellGrid.H"
#include "checkedLabel.H"
#include "boundBox.H"
#include "error.H"

#include <algorithm>
#include <vector>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::particlePairs::particlePairs
(
    const UList<vector>& points,
    const UList<scalar>& radius,
    const UList<vector>& offsets
)
{
    struct entry
    {
        label neighbour;
        vector delta;
    };

    const label n = points.size();
    if (n == 0)
    {
        return;
    }

    const cellGrid grid(points, min(radius));
    const boundBox box(points, false);

    std::vector<std::vector<entry>> found(n);

    // A pair is found from its particle of larger radius, so that a small
    // particle need not look as far as the largest one reaches
    const auto search = [&](const label i, const vector& offset)
    {
        const vector& p = points[i];
        const scalar R = radius[i];
        const bool image = (offset != vector::zero);

        grid.forNear
        (
            p - offset,
            R,
            [&](const label j)
            {
                const vector d(points[j] + offset - p);

                if (magSqr(d) >= R*R || (j == i && !image))
                {
                    return;
                }
                if (radius[j] < R || (radius[j] == R && j > i))
                {
                    found[i].push_back({j, d});
                }
                else if (j == i)
                {
                    FatalErrorInFunction
                        << "The cyclic patches are closer together than the"
                        << " cut-off radius " << R << " of the kernel:"
                        << " refine the spacing in sphMeshDict"
                        << exit(FatalError);
                }
            }
        );
    };

    #pragma omp parallel for schedule(dynamic, 512)
    for (label i = 0; i < n; ++i)
    {
        search(i, vector::zero);
    }

    for (const vector& offset : offsets)
    {
        for (label i = 0; i < n; ++i)
        {
            // Images of the point set as a whole are near few particles
            const vector q(points[i] - offset);
            const vector R(vector::one*radius[i]);
            if (boundBox(q - R, q + R).overlaps(box))
            {
                search(i, offset);
            }
        }
    }

    scalar nFound = 0;
    for (const std::vector<entry>& row : found)
    {
        nFound += row.size();
    }
    checkedLabel(nFound, "pairs of particles");

    // Hand pairs found from the higher index to the lower one
    labelList nPairs(n + 1, Zero);
    for (label i = 0; i < n; ++i)
    {
        for (const entry& e : found[i])
        {
            ++nPairs[min(i, e.neighbour) + 1];
        }
    }
    for (label i = 0; i < n; ++i)
    {
        nPairs[i + 1] += nPairs[i];
    }

    std::vector<entry> sorted(nPairs[n]);
    labelList next(nPairs);
    for (label i = 0; i < n; ++i)
    {
        for (const entry& e : found[i])
        {
            const bool up = i < e.neighbour;
            sorted[next[up ? i : e.neighbour]++] =
                up ? e : entry{i, -e.delta};
        }
        std::vector<entry>().swap(found[i]);
    }

    owner.setSize(sorted.size());
    neighbour.setSize(sorted.size());
    delta.setSize(sorted.size());
    for (label i = 0; i < n; ++i)
    {
        std::sort
        (
            sorted.begin() + nPairs[i],
            sorted.begin() + nPairs[i + 1],
            [](const entry& a, const entry& b)
            {
                return
                    a.neighbour != b.neighbour
                  ? a.neighbour < b.neighbour
                  : magSqr(a.delta) < magSqr(b.delta);
            }
        );
        for (label s = nPairs[i]; s < nPairs[i + 1]; ++s)
        {
            owner[s] = i;
            neighbour[s] = sorted[s].neighbour;
            delta[s] = sorted[s].delta;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::particlePairs::subset(const UList<bool>& keep)
{
    label n = 0;
    forAll(owner, pairi)
    {
        if (keep[pairi])
        {
            owner[n] = owner[pairi];
            neighbour[n] = neighbour[pairi];
            delta[n] = delta[pairi];
            ++n;
        }
    }
    owner.setSize(n);
    neighbour.setSize(n);
    delta.setSize(n);
}


// ************************************************************************* //
