/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "fluidRegion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- No point of the body's surface lies outside the region
    static bool whollyInside
    (
        const signedDistance& region,
        const orientedSurface& surface,
        const scalar tolerance
    )
    {
        for (const point& p : surface.points())
        {
            if (region.distance(p) > tolerance)
            {
                return false;
            }
        }
        return true;
    }

    //- Volume of the common part of a body and a region, in local units
    static scalar overlapVolume
    (
        const solutionSpace& space,
        const signedDistance& region,
        const solidBody& body,
        const scalar spacing
    )
    {
        const scalar tolerance = 1e-6*spacing;

        if (whollyInside(region, body.surface(), tolerance))
        {
            return body.surface().volume();
        }

        // The common part of both boxes, in cells of a quarter of the spacing
        // or as many as are done in seconds
        const scalar mostCells = 4e6;
        const label nDims = space.nDims();
        const boundBox regionBox(region.bounds());
        const boundBox bodyBox(body.surface().bounds());
        const vector low
        (
            space.toLocal(max(regionBox.min(), bodyBox.min()))
        );
        const vector span
        (
            space.toLocal(min(regionBox.max(), bodyBox.max())) - low
        );

        scalar boxVolume = 1;
        for (label d = 0; d < nDims; ++d)
        {
            boxVolume *= max(span[d], scalar(0));
        }
        if (boxVolume <= 0)
        {
            return 0;
        }

        const scalar edge = max
        (
            0.25*spacing, pow(boxVolume/mostCells, 1.0/nDims)
        );
        label n[3] = {1, 1, 1};
        for (label d = 0; d < nDims; ++d)
        {
            n[d] = label(span[d]/edge) + 1;
        }

        label count = 0;
        #pragma omp parallel for reduction(+: count) schedule(dynamic, 16)
        for (label jk = 0; jk < n[1]*n[2]; ++jk)
        {
            for (label i = 0; i < n[0]; ++i)
            {
                const vector fraction
                (
                    (i + 0.5)/n[0], (jk % n[1] + 0.5)/n[1], (jk/n[1] + 0.5)/n[2]
                );
                vector x(low);
                for (label d = 0; d < nDims; ++d)
                {
                    x[d] += fraction[d]*span[d];
                }
                const point p(space.position(x));

                // A common surface does not count
                if
                (
                    body.distance().distance(p) < -tolerance
                 && region.distance(p) < -tolerance
                )
                {
                    ++count;
                }
            }
        }

        return boxVolume*count/(scalar(n[0])*n[1]*n[2]);
    }
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
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::SPH::signedDistance::nearest Foam::SPH::fluidRegion::find
(
    const point& p
) const
{
    nearest result;
    if (patches_.valid())
    {
        result = patches_->find(p);
    }
    else
    {
        result.distance = -GREAT;
        result.hit = p;
    }

    for (const solidBody* body : fileBodies_)
    {
        // Outside its box the body is at least as far as the box
        const boundBox box(body->distance().bounds());
        if (-mag(p - min(max(p, box.min()), box.max())) < result.distance)
        {
            continue;
        }

        nearest other(body->distance().find(p));
        if (-other.distance > result.distance)
        {
            other.distance = -other.distance;
            other.normal = -other.normal;
            result = other;
        }
    }

    return result;
}


bool Foam::SPH::fluidRegion::inside(const point& p) const
{
    for (const solidBody* body : fileBodies_)
    {
        if (body->distance().inside(p))
        {
            return false;
        }
    }

    return !patches_.valid() || patches_->inside(p);
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
