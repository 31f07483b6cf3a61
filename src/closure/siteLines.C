/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "siteLines.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::siteLines::siteLines
(
    const label nDims,
    const particleMeshData& data,
    const scalarField& stiffness,
    const vectorField& normal,
    const List<tensor>& diagonal
)
:
    nDims_(nDims)
{
    const label n = data.points.size();

    for (direction c = 0; c < nDims; ++c)
    {
        labelList next(n, -1);
        scalarField toNext(n, Zero);
        boolList first(n, true);
        forAll(data.owner, pairi)
        {
            label from = data.owner[pairi];
            label to = data.neighbour[pairi];
            const scalar along = normal[pairi][c];
            if (data.sites[from] && data.sites[to] && mag(along) > 0.99)
            {
                if (along < 0)
                {
                    std::swap(from, to);
                }
                next[from] = to;
                toNext[from] = stiffness[pairi]*sqr(along);
                first[to] = false;
            }
        }

        boolList inLine(n, false);
        const auto addLine = [&](const label firstSite)
        {
            direction_.append(c);
            start_.append(site_.size());
            scalar link = 0;
            scalar rPivot = 0;
            for (label i = firstSite; i >= 0 && !inLine[i]; i = next[i])
            {
                inLine[i] = true;
                // Lines between fixed faces are not held at all
                const scalar own = (1 + 1e-6)*diagonal[i](c, c);
                rPivot = 1/(own - sqr(link)*rPivot);
                site_.append(i);
                link_.append(link);
                rPivot_.append(rPivot);
                link = toNext[i];
            }
        };

        forAll(next, i)
        {
            if (data.sites[i] && first[i])
            {
                addLine(i);
            }
        }

        // Rings across periodic planes
        forAll(next, i)
        {
            if (data.sites[i] && !inLine[i])
            {
                addLine(i);
            }
        }
    }
    start_.append(site_.size());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::siteLines::solve(const scalarField& r, scalarField& z) const
{
    const label width = nDims_*nDims_;
    const label nLines = direction_.size();

    #pragma omp parallel for schedule(static)
    for (label linei = 0; linei < nLines; ++linei)
    {
        const label begin = start_[linei];
        const label end = start_[linei + 1];

        for (label p = 0; p < nDims_; ++p)
        {
            const label offset = p*nDims_ + direction_[linei];

            scalar last = 0;
            for (label k = begin; k < end; ++k)
            {
                const label e = site_[k]*width + offset;
                last = (r[e] + link_[k]*last)*rPivot_[k];
                z[e] = last;
            }
            for (label k = end - 2; k >= begin; --k)
            {
                const label e = site_[k]*width + offset;
                last = z[e] + rPivot_[k]*link_[k + 1]*last;
                z[e] = last;
            }
        }
    }
}


// ************************************************************************* //
