/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleStart.H"
#include "List.H"

#include <omp.h>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::particleStart::addFixedByThreads
(
    const label n,
    const std::function<void(const label, particleStart&)>& add
)
{
    const label nShares = max(1, omp_get_max_threads());
    List<particleStart> shares(nShares);

    #pragma omp parallel for schedule(static, 1)
    for (label share = 0; share < nShares; ++share)
    {
        const label first = share*int64_t(n)/nShares;
        const label last = (share + 1)*int64_t(n)/nShares;
        for (label i = first; i < last; ++i)
        {
            add(i, shares[share]);
        }
    }

    for (const particleStart& share : shares)
    {
        fixedPoints.append(share.fixedPoints);
        fixedSpacing.append(share.fixedSpacing);
        fixedVolume.append(share.fixedVolume);
        fixedBody.append(share.fixedBody);
    }
}


// ************************************************************************* //
