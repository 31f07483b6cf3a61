/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "bandGrid.H"
#include "checkedLabel.H"
#include "DynamicList.H"
#include "error.H"
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::SPH::bandGrid::blockIndex(const labelVector& block) const
{
    return
        block.x() + nBlocks_.x()*(block.y() + nBlocks_.y()*block.z());
}


Foam::labelVector Foam::SPH::bandGrid::blockCoordinates(const label i) const
{
    return labelVector
    (
        i % nBlocks_.x(),
        (i/nBlocks_.x()) % nBlocks_.y(),
        i/(nBlocks_.x()*nBlocks_.y())
    );
}


Foam::label Foam::SPH::bandGrid::localNode
(
    const label active,
    const labelVector& ijk
) const
{
    return
        active*blockNodes_
      + ijk.x() + edgeNodes_*(ijk.y() + edgeNodes_*ijk.z());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::bandGrid::bandGrid
(
    const label nDims,
    const boundBox& box,
    const scalar spacing,
    const criterion& active
)
:
    nDims_(nDims),
    origin_(box.min()),
    spacing_(spacing),
    nBlocks_(1, 1, 1),
    edgeNodes_(blockSize + 1),
    blockNodes_(1)
{
    scalar n = 1;
    for (label d = 0; d < nDims_; ++d)
    {
        const scalar nd =
            std::floor(box.span()[d]/(blockSize*spacing_)) + 1;
        n *= nd;
        nBlocks_[d] = label(min(nd, scalar(labelMax)));
        blockNodes_ *= edgeNodes_;
    }

    if (n > 5e8)
    {
        FatalErrorInFunction
            << "A background grid of spacing " << spacing_ << " m over a box"
            << " of " << box.span() << " m needs " << n*pow(8.0, nDims_)
            << " cells. Increase the entry spacing of sphMeshDict"
            << exit(FatalError);
    }

    activeBlock_.setSize(label(n), -1);

    const scalar halfDiagonal = blockHalfDiagonal();

    #pragma omp parallel for schedule(dynamic, 64)
    for (label i = 0; i < activeBlock_.size(); ++i)
    {
        activeBlock_[i] = active(blockCentre(i), halfDiagonal) ? 0 : -1;
    }

    DynamicList<labelVector> blocks;
    forAll(activeBlock_, i)
    {
        if (activeBlock_[i] == 0)
        {
            activeBlock_[i] = blocks.size();
            blocks.append(blockCoordinates(i));
        }
    }
    blocks_.transfer(blocks);

    checkedLabel
    (
        scalar(blocks_.size())*blockNodes_, "nodes of a background grid"
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::point Foam::SPH::bandGrid::blockCentre(const label block) const
{
    const labelVector coordinates(blockCoordinates(block));

    point centre(origin_);
    for (label d = 0; d < nDims_; ++d)
    {
        centre[d] += (coordinates[d] + 0.5)*blockSize*spacing_;
    }

    return centre;
}


Foam::scalar Foam::SPH::bandGrid::blockHalfDiagonal() const
{
    return 0.5*blockSize*spacing_*Foam::sqrt(scalar(nDims_));
}


Foam::labelVector Foam::SPH::bandGrid::coordinates(const label node) const
{
    const labelVector& block = blocks_[node/blockNodes_];

    label i = node % blockNodes_;
    labelVector ijk(Zero);
    for (label d = 0; d < nDims_; ++d)
    {
        ijk[d] = block[d]*blockSize + i % edgeNodes_;
        i /= edgeNodes_;
    }

    return ijk;
}


Foam::point Foam::SPH::bandGrid::position(const labelVector& ijk) const
{
    point x(origin_);
    for (label d = 0; d < nDims_; ++d)
    {
        x[d] += spacing_*ijk[d];
    }

    return x;
}


// ************************************************************************* //
