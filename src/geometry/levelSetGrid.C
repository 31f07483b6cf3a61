/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "levelSetGrid.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::boundBox wideBox
(
    const Foam::SPH::solutionSpace& space,
    const Foam::boundBox& bounds,
    const Foam::scalar band
)
{
    return Foam::boundBox
    (
        space.toLocal(bounds.min() - band*Foam::vector::one),
        space.toLocal(bounds.max() + band*Foam::vector::one)
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::levelSetGrid::levelSetGrid
(
    const signedDistance& body,
    const solutionSpace& space,
    const scalar spacing,
    const scalar band
)
:
    space_(space),
    bounds_(body.bounds()),
    grid_
    (
        space.nDims(),
        wideBox(space, body.bounds(), band),
        spacing,
        [&](const point& centre, const scalar halfDiagonal)
        {
            return body.within(space.position(centre), band + halfDiagonal);
        }
    ),
    phi_(grid_.size()),
    normal_(grid_.size()),
    blockPhi_(grid_.nBlocks()),
    blockNormal_(grid_.nBlocks())
{
    #pragma omp parallel for schedule(static, 64)
    for (label node = 0; node < grid_.size(); ++node)
    {
        const point x(grid_.position(grid_.coordinates(node)));
        const nearest found(body.find(space_.position(x)));
        phi_[node] = found.distance;
        normal_[node] = space_.toLocal(found.normal);
    }

    #pragma omp parallel for schedule(static, 64)
    for (label block = 0; block < grid_.nBlocks(); ++block)
    {
        const point x(grid_.blockCentre(block));
        const nearest found(body.find(space_.position(x)));
        blockPhi_[block] = found.distance;
        blockNormal_[block] = space_.toLocal(found.normal);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::SPH::signedDistance::nearest Foam::SPH::levelSetGrid::find
(
    const point& p
) const
{
    const point x(space_.toLocal(p));
    const bandGrid::location where(grid_.locate(x));

    nearest result;
    vector normal(Zero);

    if (where.node >= 0)
    {
        result.distance = grid_.interpolate<scalar>(phi_, where);
        normal = grid_.interpolate<vector>(normal_, where);
    }
    else if (where.block >= 0)
    {
        normal = blockNormal_[where.block];
        result.distance =
            blockPhi_[where.block]
          + (normal & (x - grid_.blockCentre(where.block)));
    }
    else
    {
        // Outside the box there is nothing of the body
        const point nearestInBox
        (
            min
            (
                max(x, space_.toLocal(bounds_.min())),
                space_.toLocal(bounds_.max())
            )
        );
        result.distance = mag(x - nearestInBox);
        normal = x - nearestInBox;
    }

    // On the medial axis the mean of the normals may vanish
    const scalar magNormal = mag(normal);
    normal = magNormal > SMALL ? normal/magNormal : vector(1, 0, 0);

    result.normal = space_.toGlobal(normal);
    result.hit = space_.position(x - result.distance*normal);

    return result;
}


// ************************************************************************* //
