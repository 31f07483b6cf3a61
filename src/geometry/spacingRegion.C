/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "spacingRegion.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::SPH::spacingRegion::shape>
Foam::SPH::spacingRegion::shapeNames
({
    {shape::box, "box"},
    {shape::sphere, "sphere"},
    {shape::cylinder, "cylinder"}
});


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::spacingRegion::spacingRegion
(
    const solutionSpace& space,
    const dictionary& dict
)
:
    shape_(shapeNames.get("type", dict)),
    radius_(0)
{
    const auto readPoint = [&](const char* key)
    {
        return space.toLocal(dict.get<point>(key));
    };

    switch (shape_)
    {
        case shape::box:
            first_ = readPoint("min");
            second_ = readPoint("max");
            break;

        case shape::sphere:
            first_ = second_ = readPoint("centre");
            break;

        case shape::cylinder:
            first_ = readPoint("point1");
            second_ = readPoint("point2");
            break;
    }

    bool valid = true;

    if (shape_ == shape::box)
    {
        for (label d = 0; d < space.nDims(); ++d)
        {
            valid = valid && first_[d] < second_[d];
        }
    }
    else
    {
        radius_ = dict.get<scalar>("radius");
        valid =
            radius_ > 0
         && (shape_ == shape::sphere || mag(second_ - first_) > VSMALL);
    }

    if (!valid)
    {
        FatalIOErrorInFunction(dict)
            << "Region " << dict.dictName() << " of type "
            << shapeNames[shape_] << " has no extent in the solved directions"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::SPH::spacingRegion::distance(const point& x) const
{
    if (shape_ == shape::box)
    {
        return mag(x - min(max(x, first_), second_));
    }

    if (shape_ == shape::sphere)
    {
        return max(mag(x - first_) - radius_, scalar(0));
    }

    const scalar length = mag(second_ - first_);
    const vector axis((second_ - first_)/length);
    const scalar along = (x - first_) & axis;
    const scalar across = mag(x - first_ - along*axis);

    return Foam::hypot
    (
        max(max(-along, along - length), scalar(0)),
        max(across - radius_, scalar(0))
    );
}


// ************************************************************************* //
