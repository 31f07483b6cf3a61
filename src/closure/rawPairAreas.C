/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "rawPairAreas.H"
#include "compensatedSum.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::SPH::rawVolumes
(
    const solutionSpace& space,
    const scalarField& spacing,
    const scalarField& density,
    const scalar total
)
{
    auto tV = tmp<scalarField>::New(spacing.size());
    scalarField& V = tV.ref();

    forAll(V, i)
    {
        V[i] = space.volume(spacing[i])/density[i];
    }
    V *= total/compensatedSum(V);

    return tV;
}


Foam::vector Foam::SPH::rawPairArea
(
    const solutionSpace& space,
    const kernel& W,
    const scalar Vi,
    const scalar Vj,
    const scalar spacingi,
    const scalar spacingj,
    const vector& delta
)
{
    const scalar r = mag(delta);
    const scalar hi = W.smoothingRatio()*spacingi;
    const scalar hj = W.smoothingRatio()*spacingj;
    const scalar slope =
        hi == hj ? W.dWdr(r, hi) : 0.5*(W.dWdr(r, hi) + W.dWdr(r, hj));

    return
        -2*Vi*Vj/space.thickness()*slope/(r*W.latticeMoment())*delta;
}


Foam::tmp<Foam::vectorField> Foam::SPH::rawPairAreas
(
    const solutionSpace& space,
    const kernel& W,
    const scalarField& V,
    const particleMeshData& data
)
{
    auto tSf = tmp<vectorField>::New(data.owner.size());
    vectorField& Sf = tSf.ref();

    forAll(Sf, pairi)
    {
        const label i = data.owner[pairi];
        const label j = data.neighbour[pairi];

        Sf[pairi] = rawPairArea
        (
            space,
            W,
            V[i],
            V[j],
            data.spacing[i],
            data.spacing[j],
            data.delta[pairi]
        );
    }

    return tSf;
}


// ************************************************************************* //
