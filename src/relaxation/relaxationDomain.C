/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "relaxationDomain.H"
#include "periodicImages.H"
#include "relaxationMethod.H"
#include "volFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::relaxationDomain::checkWidth(const dictionary& dict) const
{
    for (label d = 0; d < nDims(); ++d)
    {
        const scalar width = high[d] - low[d];
        if (minSpacing > width)
        {
            FatalIOErrorInFunction(dict)
                << "The spacing " << minSpacing
                << " is larger than the width " << width
                << " of the fluid: reduce the entry spacing"
                << exit(FatalIOError);
        }
    }
}


void Foam::SPH::relaxationDomain::setPeriods(const fvMesh& mesh)
{
    for (const vector& period : periodicTranslations(mesh))
    {
        // From the low side to the high one, whichever patch comes first
        const vector T(space.toLocal(period));
        const bool falls = (T & (high - low)) < 0;
        translations.append(falls ? -T : T);
    }
}


void Foam::SPH::relaxationDomain::setBodies(const bool onGrids)
{
    bodies.append
    ({
        "fluid",
        region_.bounded() ? &region_ : nullptr,
        W.smoothingRatio()
    });
    for (const solidBody& solid : solids_)
    {
        bodies.append
        ({
            solid.name(), &solid.distance(), solid.smoothingRatio()
        });
    }

    for (body& b : bodies)
    {
        if (onGrids && b.surface)
        {
            grids_.append
            (
                new levelSetGrid
                (
                    *b.surface, space, minSpacing, 2*W.support(minSpacing)
                )
            );
            b.surface = &grids_.last();
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::relaxationDomain::relaxationDomain
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    space(mesh),
    kernel_(kernel::New(dict.subOrEmptyDict("kernel"), space.nDims())),
    surface_(mesh, space),
    spacing_(spacingFunction::New(surface_, dict)),
    solids_(surface_, dict, kernel_->smoothingRatio()),
    region_(surface_, solids_, 4*kernel_->support(spacing_->max())),
    W(*kernel_),
    pattern(dict, space.nDims()),
    overlap(region_.overlap(spacing_->min())),
    fluidVolume(gSum(mesh.V())/space.thickness() - overlap),
    low(space.toLocal(mesh.bounds().min())),
    high(space.toLocal(mesh.bounds().max())),
    minSpacing(spacing_->min())
{
    solids_.checkSize(*spacing_);
    checkWidth(dict);
    setPeriods(mesh);
    setBodies
    (
        relaxationMethod::typeOf(dict.subOrEmptyDict("relaxation"))
     == "separateNoBoolean"
    );
}


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
