/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "levelSetGrid.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::levelSetGrid::levelSetGrid
(
    const signedDistance& body,
    const solutionSpace& space,
    const scalar spacing,
    const scalar band
)
:
    body_(body),
    space_(space),
    origin_(space.toLocal(body.bounds().min() - band*vector::one)),
    spacing_(spacing)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::SPH::signedDistance::nearest Foam::SPH::levelSetGrid::find
(
    const point& p
) const
{
    const label nDims = space_.nDims();
    const point x(space_.toLocal(p));

    point lower(Zero);
    vector weight(Zero);
    for (label d = 0; d < nDims; ++d)
    {
        const scalar s = (x[d] - origin_[d])/spacing_;
        lower[d] = origin_[d] + spacing_*floor(s);
        weight[d] = s - floor(s);
    }

    nearest result;
    for (label corner = 0; corner < (1 << nDims); ++corner)
    {
        point node(lower);
        scalar w = 1;
        for (label d = 0; d < nDims; ++d)
        {
            const bool upper = corner & (1 << d);
            node[d] += upper ? spacing_ : 0;
            w *= upper ? weight[d] : 1 - weight[d];
        }

        const nearest found(body_.find(space_.position(node)));
        result.distance += w*found.distance;
        result.normal += w*found.normal;
    }

    // On the medial axis the mean of the normals may vanish
    const scalar magNormal = mag(result.normal);
    result.normal =
        magNormal > SMALL
      ? vector(result.normal/magNormal)
      : space_.toGlobal(vector(1, 0, 0));
    result.hit =
        space_.position(x - result.distance*space_.toLocal(result.normal));

    return result;
}


// ************************************************************************* //
