/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "staticConfinement.H"
#include "outsideFraction.H"
#include "surfaceIntegral.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::SPH::staticConfinement::methodType>
Foam::SPH::staticConfinement::methodNames
({
    {methodType::levelSet, "levelSet"},
    {methodType::surface, "surface"}
});


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::SPH::bandGrid Foam::SPH::staticConfinement::makeGrid
(
    const signedDistance& body,
    const solutionSpace& space,
    const kernel& k,
    const spacingFunction& spacing,
    const scalar gridRatio,
    const scalar leastSpacing
)
{
    // The kernels of particles on the surface stay within the box
    const scalar largestSpacing = 2*leastSpacing;
    const scalar band = k.support(min(largestSpacing, spacing.max()));

    const boundBox bounds(body.bounds());
    const boundBox box
    (
        space.toLocal(bounds.min() - 2*band*vector::one),
        space.toLocal(bounds.max() + 2*band*vector::one)
    );

    return bandGrid
    (
        space.nDims(),
        box,
        gridRatio*leastSpacing,
        [&](const point& centre, const scalar halfDiagonal)
        {
            const point p(space.position(centre));
            const scalar dp = spacing(p);
            const scalar change = spacing.slope()*halfDiagonal;

            return
                dp + change >= leastSpacing
             && dp - change < largestSpacing
             && body.within(p, band + halfDiagonal);
        }
    );
}


void Foam::SPH::staticConfinement::sumOutside
(
    level& l,
    const signedDistance& body,
    const kernel& k,
    const spacingFunction& spacing
) const
{
    const outsideFraction outside(l.grid, body, space_);
    const label nDims = space_.nDims();
    const scalar lf = l.grid.spacing();
    const scalar volume = kernel::integerPow(lf, nDims);

    #pragma omp parallel for schedule(dynamic, 64)
    for (label node = 0; node < l.grid.size(); ++node)
    {
        const labelVector centre(l.grid.coordinates(node));
        const scalar dp = spacing(space_.position(l.grid.position(centre)));
        const scalar h = k.smoothingRatio()*dp;
        const scalar reach = k.support(dp);

        // Further away g is zero or never asked for
        if (mag(outside.distance(node)) > reach + lf)
        {
            continue;
        }

        const label n = label(reach/lf);
        const label nz = nDims > 2 ? n : 0;
        const label ny = nDims > 1 ? n : 0;
        vector g(Zero);

        for (label z = -nz; z <= nz; ++z)
        {
            for (label y = -ny; y <= ny; ++y)
            {
                // Runs along x from block to block
                label neighbour = -1;

                for (label x = -n; x <= n; ++x)
                {
                    const labelVector s(x, y, z);
                    const labelVector ijk(centre + s);

                    if (x == -n || ijk.x() % bandGrid::blockSize == 0)
                    {
                        neighbour = l.grid.find(ijk);
                    }
                    else if (neighbour >= 0)
                    {
                        ++neighbour;
                    }

                    const scalar r = lf*Foam::sqrt(scalar(x*x + y*y + z*z));

                    if (r > 0 && r < reach)
                    {
                        const scalar H = outside(neighbour, ijk);
                        if (H > 0)
                        {
                            // grad_i W is along x_i - x_k
                            g -= H*k.dWdr(r, h)/r*vector(x, y, z);
                        }
                    }
                }
            }
        }

        l.g[node] = volume*lf*g;
    }
}


void Foam::SPH::staticConfinement::integrateSurface
(
    level& l,
    const surfaceDistance& surface,
    const kernel& k,
    const spacingFunction& spacing
) const
{
    const surfaceIntegral integral(surface, k);

    #pragma omp parallel for schedule(dynamic, 64)
    for (label node = 0; node < l.grid.size(); ++node)
    {
        const point p
        (
            space_.position(l.grid.position(l.grid.coordinates(node)))
        );

        l.g[node] = integral(p, k.smoothingRatio()*spacing(p));
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::staticConfinement::staticConfinement
(
    const signedDistance& body,
    const solutionSpace& space,
    const kernel& k,
    const spacingFunction& spacing,
    const dictionary& dict
)
:
    space_(space),
    spacing0_(spacing.min())
{
    const methodType method
    (
        methodNames.getOrDefault("method", dict, methodType::levelSet)
    );
    const scalar gridRatio
    (
        dict.getOrDefault<scalar>("gridRatio", space.nDims() == 3 ? 0.5 : 0.25)
    );

    if (gridRatio < 0.05 || gridRatio > 1)
    {
        FatalIOErrorInFunction(dict)
            << "Entry gridRatio of " << dict.dictName() << " is " << gridRatio
            << ". Valid are grid spacings from 0.05 to 1 particle spacing"
            << exit(FatalIOError);
    }

    const surfaceDistance* surface =
        dynamic_cast<const surfaceDistance*>(&body);

    if (method == methodType::surface && !surface)
    {
        FatalIOErrorInFunction(dict)
            << "Method " << methodNames[method] << " needs a body with a"
            << " surface, not one on a grid or combined of others. Use "
            << methodNames[methodType::levelSet] << exit(FatalIOError);
    }

    for
    (
        scalar least = spacing0_;
        levels_.empty() || least < spacing.max();
        least *= 2
    )
    {
        levels_.append
        (
            new level
            {
                makeGrid(body, space, k, spacing, gridRatio, least),
                vectorField()
            }
        );

        level& l = levels_.last();
        l.g.setSize(l.grid.size(), Zero);

        if (method == methodType::surface)
        {
            integrateSurface(l, *surface, k, spacing);
        }
        else
        {
            sumOutside(l, body, k, spacing);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::SPH::staticConfinement::operator()
(
    const point& p,
    const scalar dp
) const
{
    const point x(space_.toLocal(p));
    const label nLevels = levels_.size();
    const label leveli = min
    (
        max(label(Foam::log(dp/spacing0_)/Foam::log(2.0)), label(0)),
        nLevels - 1
    );

    // A particle's spacing may lag behind that of the place it has moved to
    for (const label i : {leveli, leveli - 1, leveli + 1})
    {
        if (i >= 0 && i < nLevels)
        {
            const level& l = levels_[i];
            const bandGrid::location where(l.grid.locate(x));

            if (where.node >= 0)
            {
                return space_.toGlobal
                (
                    l.grid.interpolate<vector>(l.g, where)
                );
            }
        }
    }

    return Zero;
}


Foam::label Foam::SPH::staticConfinement::nNodes() const
{
    label n = 0;
    for (const level& l : levels_)
    {
        n += l.grid.size();
    }

    return n;
}


// ************************************************************************* //
