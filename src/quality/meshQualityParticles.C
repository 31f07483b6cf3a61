/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    Measures of the particle distribution.

\*---------------------------------------------------------------------------*/

#include "meshQuality.H"
#include "largestVoid.H"
#include "latticePattern.H"
#include "boundBox.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::meshQuality::addKernelGradientSums()
{
    const scalarField all(kernelGradientSum());
    const label nFluid = surroundings_.nFluid();

    DynamicList<scalar> fluid(nFluid);
    DynamicList<scalar> interface;
    for (label i = 0; i < nFluid; ++i)
    {
        if (supported_[i])
        {
            fluid.append(all[i]);
            if (firstLayer(i))
            {
                interface.append(all[i]);
            }
        }
    }
    addMeanMax("kernelGradientSum", "fluid", fluid);
    addMeanMax("kernelGradientSum", "interface", interface);

    forAll(solids_, solidi)
    {
        DynamicList<scalar> solid;
        for (label i = nFluid; i < all.size(); ++i)
        {
            if (surroundings_.body()[i] == solidi + 1 && supported_[i])
            {
                solid.append(all[i]);
            }
        }
        addMeanMax("kernelGradientSum", solids_[solidi].name, solid);
    }
}


void Foam::SPH::meshQuality::addTotalError()
{
    const kernel& W = particles_.W();
    const scalar ratio = W.smoothingRatio();

    // Largest average volume of a particle: that of the better lattice
    const scalar supremum = latticePattern::largestVolume(W, ratio);

    scalar error = 0;
    scalar volume = 0;
    for (label i = 0; i < surroundings_.nFluid(); ++i)
    {
        const scalar dp = surroundings_.spacing()[i];
        const scalar V = kernel::integerPow(dp, W.nDims());
        const scalar depth = max(-nearest_[i].distance, scalar(0));

        error +=
            V*supremum
           *(
                surroundings_.ownDensity()[i]
              + 2*W.lineTail(depth, ratio*dp)
            );
        volume += V;
    }

    add("totalError", "fluid", mag(error/volume - 1));
}


Foam::scalar Foam::SPH::meshQuality::voidRadius() const
{
    // Images and mirrored particles as far as empty spheres may reach
    const scalar reach = 3*max(surroundings_.spacing());

    const solutionSpace& space = particles_.space();
    const label nFluid = surroundings_.nFluid();

    DynamicList<vector> points(surroundings_.points());
    DynamicList<scalar> spacing(surroundings_.spacing());

    // Behind a patch without solid particles the fluid's own mirror image
    for (label i = 0; i < nFluid; ++i)
    {
        const scalar dp = surroundings_.spacing()[i];
        if (!supported_[i] && -nearest_[i].distance < 2*dp)
        {
            const vector image
            (
                2*space.toLocal(nearest_[i].hit) - points[i]
            );
            if (!fluid_.inside(space.position(image)))
            {
                points.append(image);
                spacing.append(dp);
            }
        }
    }

    boundBox box(points, false);
    box.min() -= reach*vector::one;
    box.max() += reach*vector::one;
    const label n = points.size();
    for (const vector& offset : surroundings_.offsets())
    {
        for (label i = 0; i < n; ++i)
        {
            // Copies: the lists may move while they grow
            const vector image(points[i] + offset);
            const scalar dp = spacing[i];
            if (box.contains(image))
            {
                points.append(image);
                spacing.append(dp);
            }
        }
    }

    // Without surface all space is inside, also beyond the images
    const boundBox& bounds = mesh_.bounds();

    return largestVoid
    (
        space.nDims(),
        points,
        spacing,
        [&](const vector& p)
        {
            const point x(space.position(p));
            return bounds.contains(x) && fluid_.inside(x);
        }
    );
}


void Foam::SPH::meshQuality::addSpacing()
{
    add("spacingMin", "fluid", surroundings_.closestFluid());
    if (solids_.size())
    {
        add("spacingMin", "interface", surroundings_.closestSolid());
    }
    add("spacingVoid", "fluid", voidRadius());

    // The density falls with the volume that each particle has really got
    const scalar ideal =
        1/latticePattern(latticePattern::SQUARE, particles_.nDims())
       .characteristicVolume
        (
            particles_.W(), particles_.W().smoothingRatio()
        );
    DynamicList<scalar> ratio(surroundings_.nFluid());
    for (label i = 0; i < surroundings_.nFluid(); ++i)
    {
        if (supported_[i])
        {
            ratio.append
            (
                pow
                (
                    ideal/surroundings_.density()[i],
                    1.0/particles_.nDims()
                )
            );
        }
    }
    addMeanMax("spacingRatio", "fluid", ratio);
    if (ratio.size())
    {
        add("spacingRatioMin", "fluid", min(ratio));
    }
}


void Foam::SPH::meshQuality::addOffSurface()
{
    DynamicList<scalar> interface;
    DynamicList<scalar> boundary;
    for (label i = 0; i < surroundings_.nFluid(); ++i)
    {
        if (firstLayer(i))
        {
            const scalar offset =
                mag(nearest_[i].distance/surroundings_.spacing()[i] + 0.5);
            (supported_[i] ? interface : boundary).append(offset);
        }
    }
    addMeanMax("offSurface", "interface", interface);
    addMeanMax("offSurface", "boundary", boundary);
}


// ************************************************************************* //
