/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "spaceFillingCurve.H"
#include "boundBox.H"
#include "ListOps.H"

#include <cstdint>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Spread the lowest 21 bits three places apart
    static uint64_t spread(uint64_t x)
    {
        x &= 0x1fffff;
        x = (x | x << 32) & 0x1f00000000ffff;
        x = (x | x << 16) & 0x1f0000ff0000ff;
        x = (x | x << 8) & 0x100f00f00f00f00f;
        x = (x | x << 4) & 0x10c30c30c30c30c3;
        x = (x | x << 2) & 0x1249249249249249;
        return x;
    }
}
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::SPH::spaceFillingOrder
(
    const UList<vector>& points,
    const scalar boxSize
)
{
    if (points.empty())
    {
        return labelList();
    }

    const boundBox box(points, false);
    const scalar size = max(boxSize, cmptMax(box.span())/0x1ffffe);

    List<uint64_t> key(points.size());
    forAll(points, i)
    {
        const vector r((points[i] - box.min())/size);
        key[i] =
            spread(uint64_t(r.x()))
          | spread(uint64_t(r.y())) << 1
          | spread(uint64_t(r.z())) << 2;
    }

    labelList order(identity(points.size()));
    std::stable_sort
    (
        order.begin(),
        order.end(),
        [&](const label a, const label b) { return key[a] < key[b]; }
    );

    return order;
}


// ************************************************************************* //
