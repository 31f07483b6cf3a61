/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "relaxationDomain.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::SPH::relaxationDomain::distance
(
    const label bodyi,
    const vector& x
) const
{
    const signedDistance* surface = bodies[bodyi].surface;

    return surface ? surface->distance(space.position(x)) : -GREAT;
}


Foam::SPH::signedDistance::nearest Foam::SPH::relaxationDomain::find
(
    const label bodyi,
    const vector& x
) const
{
    const signedDistance* surface = bodies[bodyi].surface;

    signedDistance::nearest n;
    if (surface)
    {
        n = surface->find(space.position(x));
        n.hit = space.toLocal(n.hit);
        n.normal = space.toLocal(n.normal);
    }
    else
    {
        n.distance = -GREAT;
    }

    return n;
}


bool Foam::SPH::relaxationDomain::nearSolid
(
    const vector& x,
    const scalar distance
) const
{
    for (label bodyi = 1; bodyi < bodies.size(); ++bodyi)
    {
        boundBox box(bodies[bodyi].surface->bounds());
        box.min() -= vector::one*distance;
        box.max() += vector::one*distance;

        const point p(space.position(x));
        if (box.contains(p) && bodies[bodyi].surface->distance(p) <= distance)
        {
            return true;
        }
    }

    return false;
}


// ************************************************************************* //
