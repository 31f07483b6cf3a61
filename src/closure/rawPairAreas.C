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
    const solutionSpace& space,
    const scalar leastArea,
    particleMeshData& data
)
{
    // Of the determinant of the first moments: a particle that would lose more
    // has too few pairs left in some direction, and keeps all
    constexpr scalar leastShare = 0.6;

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

    symmTensor unused(Zero);
    for (direction d = space.nDims(); d < vector::nComponents; ++d)
    {
        vector axis(Zero);
        axis[d] = 1;
        unused += sqr(axis);
    }

    bitSet keep(area.size());
    symmTensorField whole(n, unused);
    symmTensorField kept(n, unused);
    symmTensorField moment(area.size());
    forAll(area, pairi)
    {
        const label i = data.owner[pairi];
        const label j = data.neighbour[pairi];

        // A raw area lies along its pair
        const vector delta(space.toLocal(data.delta[pairi]));
        moment[pairi] = area[pairi]/mag(delta)*sqr(delta);

        // Not either those of lattice sites that are not nearest neighbours
        keep.set
        (
            pairi,
            area[pairi] > max(leastArea*min(largest[i], largest[j]), VSMALL)
        );
        for (const label k : {i, j})
        {
            whole[k] += moment[pairi];
            kept[k] += scalar(keep.test(pairi))*moment[pairi];
        }
    }

    // With those that particles need that would be left flat
    boolList flat(n);
    forAll(flat, i)
    {
        flat[i] = det(kept[i]) < leastShare*det(whole[i]);
    }

    forAll(area, pairi)
    {
        const label i = data.owner[pairi];
        const label j = data.neighbour[pairi];
        const bool needed = (flat[i] || flat[j]) && area[pairi] > VSMALL;

        if (needed && !keep.test(pairi))
        {
            keep.set(pairi);
            kept[i] += moment[pairi];
            kept[j] += moment[pairi];
        }
    }
    scalarField scale(n);
    forAll(scale, i)
    {
        scale[i] =
            tr(whole[i] - unused)/max(tr(kept[i] - unused), ROOTVSMALL);
    }
    forAll(data.Sf, pairi)
    {
        data.Sf[pairi] *=
            0.5*(scale[data.owner[pairi]] + scale[data.neighbour[pairi]]);
    }

    inplaceSubset(keep, data.owner);
    inplaceSubset(keep, data.neighbour);
    inplaceSubset(keep, data.delta);
    inplaceSubset(keep, data.Sf);
}


// ************************************************************************* //
