/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "patchReconstruction.H"
#include "gradientWeights.H"
#include "limiters.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::patchReconstruction::patchReconstruction
(
    const sphPatch& patch,
    const solutionSpace& space
)
:
    patch_(patch),
    start_(patch.patch().size() + 1, Zero),
    relative_(patch.size())
{
    const vectorField& centres = patch.patch().Cf();
    const vectorField normals(patch.patch().nf());
    const labelListList& faceFaces = patch.patch().patch().faceFaces();

    DynamicList<label> neighbours;
    DynamicList<vector> halfWay, weights;

    forAll(faceFaces, facei)
    {
        const labelList& near = faceFaces[facei];

        vectorField directions(near.size());
        scalarField distance(near.size());
        tensor moments(Zero);
        forAll(near, k)
        {
            vector d(space.toLocal(centres[near[k]] - centres[facei]));
            const vector n(space.toLocal(normals[facei]));
            d -= (d & n)*n;
            distance[k] = max(mag(d), VSMALL);

            neighbours.append(near[k]);
            halfWay.append(0.5*space.toGlobal(d));
            directions[k] = d/distance[k];
            moments += directions[k]*directions[k];
        }

        tensor inverse;
        gradientWeights::invert(moments, 3, inverse);
        forAll(near, k)
        {
            weights.append
            (
                space.toGlobal(inverse & directions[k])/distance[k]
            );
        }

        start_[facei + 1] = neighbours.size();
    }

    neighbours_.transfer(neighbours);
    halfWay_.transfer(halfWay);
    weights_.transfer(weights);

    forAll(relative_, k)
    {
        relative_[k] = patch.Cf()[k] - centres[patch.face()[k]];
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::patchReconstruction::map
(
    const UList<scalar>& values,
    UList<scalar>& result
) const
{
    vectorField gradients(values.size(), Zero);

    forAll(gradients, facei)
    {
        vector& g = gradients[facei];
        scalar lowest = 0;
        scalar highest = 0;
        for (label k = start_[facei]; k < start_[facei + 1]; ++k)
        {
            const scalar difference = values[neighbours_[k]] - values[facei];
            g += difference*weights_[k];
            lowest = min(lowest, difference);
            highest = max(highest, difference);
        }

        // Round-off across the gradient must not count as an extremum
        const scalar slack = 1e-13*(highest - lowest);
        lowest -= slack;
        highest += slack;

        scalar limiter = 1;
        for (label k = start_[facei]; k < start_[facei + 1]; ++k)
        {
            limiter = min
            (
                limiter,
                limiters::barthJespersen(g & halfWay_[k], lowest, highest)
            );
        }
        g *= limiter;
    }

    forAll(result, k)
    {
        const label facei = patch_.face()[k];
        result[k] = values[facei] + (gradients[facei] & relative_[k]);
    }
}


// ************************************************************************* //
