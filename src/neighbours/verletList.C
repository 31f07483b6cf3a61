/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "verletList.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::verletList::reset
(
    vectorField&& points,
    scalarField&& radius,
    const scalar radiusRatio,
    const scalar skinRatio,
    const scalar cellRatio
)
{
    points_ = std::move(points);
    radius_ = std::move(radius);
    radiusRatio_ = radiusRatio;
    skinRatio_ = skinRatio;

    gridPtr_.reset
    (
        new cellGridLevels(points_, radius_, cellRatio*(1 + skinRatio_))
    );

    begin_.setSize(points_.size());
    end_.setSize(points_.size());
    end_ = -1;
    entries_.clear();
}


// ************************************************************************* //
