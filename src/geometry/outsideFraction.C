/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "outsideFraction.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::SPH::outsideFraction::phi(const point& x) const
{
    return body_.distance(space_.position(x));
}


Foam::scalar Foam::SPH::outsideFraction::heaviside(const scalar phi) const
{
    const scalar pi = constant::mathematical::pi;
    const scalar s = phi/eps_;

    return
        s <= -1 ? 0
      : s >= 1 ? 1
      : 0.5 + 0.5*s + 0.5/pi*Foam::sin(pi*s);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::outsideFraction::outsideFraction
(
    const bandGrid& grid,
    const signedDistance& body,
    const solutionSpace& space
)
:
    grid_(grid),
    body_(body),
    space_(space),
    eps_(0.75*grid.spacing()),
    phi_(grid.size()),
    fraction_(grid.size()),
    blockPhi_(grid.nBlocks(), Zero)
{
    #pragma omp parallel for schedule(static, 64)
    for (label node = 0; node < grid_.size(); ++node)
    {
        phi_[node] = phi(grid_.position(grid_.coordinates(node)));
        fraction_[node] = heaviside(phi_[node]);
    }

    #pragma omp parallel for schedule(static, 64)
    for (label block = 0; block < grid_.nBlocks(); ++block)
    {
        if (!grid_.active(block))
        {
            blockPhi_[block] = phi(grid_.blockCentre(block));
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::SPH::outsideFraction::notStored
(
    const labelVector& ijk
) const
{
    const label block = grid_.block(ijk);

    // All of a block far from the surface is on one side of it
    if
    (
        block >= 0
     && mag(blockPhi_[block]) > grid_.blockHalfDiagonal() + eps_
    )
    {
        return blockPhi_[block] > 0 ? 1 : 0;
    }

    return heaviside(phi(grid_.position(ijk)));
}


// ************************************************************************* //
