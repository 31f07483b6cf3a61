/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "fluidRegion.H"
#include "overlapVolume.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- A region without any boundary: everything is deep inside
    class unbounded
    :
        public signedDistance
    {
    public:

        virtual nearest find(const point& p) const
        {
            nearest n;
            n.distance = -GREAT;
            n.hit = p;
            return n;
        }

        virtual boundBox bounds() const
        {
            return boundBox::greatBox;
        }
    };

    static const unbounded everywhere;
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::fluidRegion::fluidRegion
(
    const patchSurface& surface,
    const PtrList<solidBody>& bodies,
    const scalar band
)
:
    space_(surface.space())
{
    for (const orientedSurface::element& e : surface.elements())
    {
        if (!e.coupled)
        {
            patches_.reset(new surfaceDistance(surface, band));
            break;
        }
    }

    for (const solidBody& body : bodies)
    {
        if (body.patches().empty())
        {
            fileBodies_.append(&body);
        }
    }

    if (fileBodies_.size())
    {
        List<const signedDistance*> operands(1, &distance());
        for (const solidBody* body : fileBodies_)
        {
            operands.append(&body->distance());
        }
        subtracted_.reset
        (
            new booleanDistance(booleanDistance::operation::subtract, operands)
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::SPH::signedDistance& Foam::SPH::fluidRegion::distance() const
{
    if (subtracted_.valid())
    {
        return *subtracted_;
    }
    if (patches_.valid())
    {
        return *patches_;
    }
    return everywhere;
}


Foam::scalar Foam::SPH::fluidRegion::overlap(const scalar spacing) const
{
    scalar volume = 0;
    for (const solidBody* body : fileBodies_)
    {
        volume +=
            patches_.valid()
          ? overlapVolume(space_, *patches_, *body, spacing)
          : body->surface().volume();
    }

    return volume;
}


// ************************************************************************* //
