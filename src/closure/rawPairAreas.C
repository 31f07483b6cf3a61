/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "rawPairAreas.H"
#include "bitSet.H"
#include "ListOps.H"
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


Foam::boolList Foam::SPH::latticeSites
(
    const solutionSpace& space,
    const kernel& W,
    const particleMeshData& data
)
{
    // Nearest neighbours and diagonals: of more, those would not be enough
    boolList sites(data.spacing.size(), W.support(1) < 2);

    forAll(data.owner, pairi)
    {
        const label i = data.owner[pairi];
        const label j = data.neighbour[pairi];
        const scalar dp = data.spacing[i];
        const vector x(space.toLocal(data.delta[pairi])/dp);

        bool onLattice = mag(data.spacing[j] - dp) < 1e-6*dp;
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            onLattice = onLattice && mag(x[d] - round(x[d])) < 1e-6;
        }
        if (!onLattice)
        {
            sites[i] = false;
            sites[j] = false;
        }
    }

    return sites;
}


Foam::scalar Foam::SPH::normalisedSlope
(
    const kernel& W,
    const scalar r,
    const scalar spacing,
    const bool site
)
{
    // The support that has the nearest neighbours of a lattice alone
    const scalar ratio = site ? 1.4/W.cutOff() : W.smoothingRatio();
    const scalar moment = site ? -2*W.dWdr(1, ratio) : W.latticeMoment();

    return W.dWdr(r, ratio*spacing)/moment;
}


Foam::vector Foam::SPH::rawPairArea
(
    const solutionSpace& space,
    const kernel& W,
    const scalar Vi,
    const scalar Vj,
    const scalar spacingi,
    const scalar spacingj,
    const vector& delta,
    const bool sitei,
    const bool sitej
)
{
    const scalar r = mag(delta);
    const scalar slope =
        normalisedSlope(W, r, spacingi, sitei)
      + normalisedSlope(W, r, spacingj, sitej);

    return -Vi*Vj/space.thickness()*slope/r*delta;
}


Foam::tmp<Foam::vectorField> Foam::SPH::rawPairAreas
(
    const solutionSpace& space,
    const kernel& W,
    const scalarField& V,
    const particleMeshData& data,
    const boolList& sites
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
            data.delta[pairi],
            sites[i],
            sites[j]
        );
    }

    return tSf;
}


void Foam::SPH::dropWeakPairs
(
    const scalar leastArea,
    particleMeshData& data
)
{
    const label n = data.points.size();
    const scalarField area(mag(data.Sf));

    scalarField largest(n, Zero);
    forAll(area, pairi)
    {
        for (const label i : {data.owner[pairi], data.neighbour[pairi]})
        {
            largest[i] = max(largest[i], area[pairi]);
        }
    }

    bitSet keep(area.size());
    scalarField whole(n, Zero);
    scalarField kept(n, Zero);
    forAll(area, pairi)
    {
        const label i = data.owner[pairi];
        const label j = data.neighbour[pairi];
        const scalar moment = data.Sf[pairi] & data.delta[pairi];

        // Not either those of lattice sites that are not nearest neighbours
        keep.set
        (
            pairi,
            area[pairi] > max(leastArea*min(largest[i], largest[j]), VSMALL)
        );
        for (const label k : {i, j})
        {
            whole[k] += moment;
            kept[k] += keep.test(pairi) ? moment : 0;
        }
    }

    forAll(data.Sf, pairi)
    {
        const label i = data.owner[pairi];
        const label j = data.neighbour[pairi];

        // A pair of the largest area is kept, so that no sum is zero
        if (keep.test(pairi))
        {
            data.Sf[pairi] *= 0.5*(whole[i]/kept[i] + whole[j]/kept[j]);
        }
    }

    inplaceSubset(keep, data.owner);
    inplaceSubset(keep, data.neighbour);
    inplaceSubset(keep, data.delta);
    inplaceSubset(keep, data.Sf);
}


// ************************************************************************* //
