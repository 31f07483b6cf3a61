/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "latticePattern.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::SPH::latticePattern::patternType>
Foam::SPH::latticePattern::patternTypeNames
({
    {patternType::SQUARE, "square"},
    {patternType::HEXAGONAL, "hexagonal"}
});


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::SPH::latticePattern::patternType Foam::SPH::latticePattern::readType
(
    const dictionary& dict
)
{
    const word type
    (
        dict.isDict("lattice")
      ? dict.subDict("lattice").getOrDefault<word>("type", "square")
      : dict.getOrDefault<word>("lattice", "square")
    );

    if (!patternTypeNames.found(type))
    {
        FatalIOErrorInFunction(dict)
            << "Unknown lattice '" << type << "'. Valid lattices: "
            << patternTypeNames.sortedToc() << exit(FatalIOError);
    }

    return patternTypeNames[type];
}


template<class Function>
void Foam::SPH::latticePattern::forNeighbours
(
    const scalar radius,
    Function&& f
) const
{
    label n[3] = {0, 0, 0};
    for (label d = 0; d < nDims_; ++d)
    {
        n[d] = label(radius/cell_[d]) + 1;
    }

    for (label i = -n[0]; i <= n[0]; ++i)
    {
        for (label j = -n[1]; j <= n[1]; ++j)
        {
            for (label k = -n[2]; k <= n[2]; ++k)
            {
                for (const vector& site : sites_)
                {
                    const vector r
                    (
                        cmptMultiply
                        (
                            vector(i, j, k) + site - sites_[0],
                            cell_
                        )
                    );
                    if (magSqr(r) > SMALL && magSqr(r) < sqr(radius))
                    {
                        f(r);
                    }
                }
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::latticePattern::latticePattern
(
    const patternType type,
    const label nDims
)
:
    nDims_(nDims),
    cell_(vector::one),
    sites_(1, vector::zero),
    wallDistance_(0.5)
{
    for (label d = 0; d < nDims; ++d)
    {
        sites_[0][d] = 0.5;
    }

    if (type == HEXAGONAL && nDims == 2)
    {
        const scalar a = sqrt(2/sqrt(3.0));
        cell_ = vector(a, sqrt(3.0)*a, 1);
        sites_ = List<vector>({vector(.25, .25, 0), vector(.75, .75, 0)});
        wallDistance_ = 0.25*cell_.y();
    }
    else if (type == HEXAGONAL && nDims == 3)
    {
        cell_ = cbrt(4.0)*vector::one;
        sites_ = List<vector>
        ({
            vector(.25, .25, .25),
            vector(.75, .75, .25),
            vector(.75, .25, .75),
            vector(.25, .75, .75)
        });
        wallDistance_ = 0.25*cell_.x();
    }
}


Foam::SPH::latticePattern::latticePattern
(
    const dictionary& dict,
    const label nDims
)
:
    latticePattern(readType(dict), nDims)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::SPH::latticePattern::characteristicVolume
(
    const kernel& W,
    const scalar h
) const
{
    scalar sum = W.W(0, h);

    forNeighbours
    (
        W.cutOff()*h,
        [&](const vector& r) { sum += W.W(mag(r), h); }
    );

    return 1/sum;
}


Foam::scalar Foam::SPH::latticePattern::largestVolume
(
    const kernel& W,
    const scalar h
)
{
    return max
    (
        latticePattern(SQUARE, W.nDims()).characteristicVolume(W, h),
        latticePattern(HEXAGONAL, W.nDims()).characteristicVolume(W, h)
    );
}


Foam::scalar Foam::SPH::latticePattern::stiffness
(
    const kernel& W,
    const scalar h
) const
{
    // Plane waves of relative displacement along their own direction, on the
    // axes and the diagonals of the Brillouin zone
    const label nWaves = 16;
    const scalar kMax = constant::mathematical::pi;
    const scalar dr = 1e-4*h;

    scalar largest = 0;
    for (label direction = 1; direction < (1 << nDims_); ++direction)
    {
        vector e(Zero);
        for (label d = 0; d < nDims_; ++d)
        {
            e[d] = (direction >> d) & 1;
        }
        const vector n(e/mag(e));

        for (label wave = 1; wave <= nWaves; ++wave)
        {
            const vector k(1.2*kMax*wave/nWaves*e);

            for (label polarisation = 0; polarisation < nDims_; ++polarisation)
            {
                vector u(Zero);
                u[polarisation] = 1;
                u = (polarisation == 0 ? n : u);

                scalar lambda = 0;
                forNeighbours
                (
                    W.cutOff()*h,
                    [&](const vector& r)
                    {
                        const scalar R = mag(r);
                        const scalar d1 = W.dWdr(R, h);
                        const scalar d2 =
                            (W.dWdr(R + dr, h) - W.dWdr(R - dr, h))/(2*dr);
                        const scalar un = (u & r)/R;
                        lambda +=
                            (d2*sqr(un) + d1/R*(1 - sqr(un)))
                           *(1 - cos(k & r));
                    }
                );
                largest = max(largest, mag(lambda));
            }
        }
    }

    return largest;
}


// ************************************************************************* //
