/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleMoments.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::vectorField> Foam::SPH::areaSums(const particleMeshData& data)
{
    auto tsum = tmp<vectorField>::New(data.points.size(), Zero);
    vectorField& sum = tsum.ref();

    forAll(data.owner, pairi)
    {
        sum[data.owner[pairi]] += data.Sf[pairi];
        sum[data.neighbour[pairi]] -= data.Sf[pairi];
    }

    forAll(data.boundary.owner, s)
    {
        sum[data.boundary.owner[s]] += data.boundary.Sf[s];
    }

    return tsum;
}


Foam::tmp<Foam::tensorField> Foam::SPH::firstMoments
(
    const particleMeshData& data
)
{
    auto tsum = tmp<tensorField>::New(data.points.size(), Zero);
    tensorField& sum = tsum.ref();

    forAll(data.owner, pairi)
    {
        const vector half(0.5*data.delta[pairi]);
        const vector skew
        (
            data.skew.empty() ? vector::zero : data.skew[pairi]
        );
        sum[data.owner[pairi]] += (half + skew)*data.Sf[pairi];
        sum[data.neighbour[pairi]] += (half - skew)*data.Sf[pairi];
    }

    forAll(data.boundary.owner, s)
    {
        const label i = data.boundary.owner[s];
        sum[i] +=
            (data.boundary.Cf[s] - data.points[i])*data.boundary.Sf[s];
    }

    return tsum;
}


Foam::scalar Foam::SPH::largestDefect
(
    const solutionSpace& space,
    const particleMeshData& data
)
{
    const tensorField moments(firstMoments(data));
    return max(mag(moments/data.V - space.identity())());
}


// ************************************************************************* //
