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

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Pairs of more than a share of the largest area of either particle. The
    //- areas of lattice sites that are not nearest neighbours are zero
    static bitSet strongPairs
    (
        const scalar leastArea,
        const particleMeshData& data
    )
    {
        const scalarField area(mag(data.Sf));

        scalarField largest(data.points.size(), Zero);
        forAll(area, pairi)
        {
            for (const label i : {data.owner[pairi], data.neighbour[pairi]})
            {
                largest[i] = max(largest[i], area[pairi]);
            }
        }

        bitSet strong(area.size());
        forAll(area, pairi)
        {
            const scalar least = leastArea*min
            (
                largest[data.owner[pairi]], largest[data.neighbour[pairi]]
            );
            strong.set(pairi, area[pairi] > max(least, VSMALL));
        }
        return strong;
    }


    //- First moments of the particles' pair areas, of some pairs; in
    //- directions that are not solved one
    static tmp<symmTensorField> pairMoments
    (
        const solutionSpace& space,
        const particleMeshData& data,
        const bitSet& pairs
    )
    {
        symmTensor unused(Zero);
        for (direction d = space.nDims(); d < vector::nComponents; ++d)
        {
            vector axis(Zero);
            axis[d] = 1;
            unused += sqr(axis);
        }

        auto tmoments =
            tmp<symmTensorField>::New(data.points.size(), unused);
        for (const label pairi : pairs)
        {
            const symmTensor moment
            (
                symm
                (
                    space.toLocal(data.Sf[pairi])
                   *space.toLocal(data.delta[pairi])
                )
            );
            tmoments.ref()[data.owner[pairi]] += moment;
            tmoments.ref()[data.neighbour[pairi]] += moment;
        }
        return tmoments;
    }


    //- Add the weak pairs of particles that would be left with too few in some
    //- direction
    static void addNeededPairs
    (
        const solutionSpace& space,
        const particleMeshData& data,
        bitSet& keep
    )
    {
        // Of the determinant of the first moments
        constexpr scalar leastShare = 0.6;

        bitSet all(keep.size());
        forAll(data.Sf, pairi)
        {
            all.set(pairi, mag(data.Sf[pairi]) > VSMALL);
        }

        const scalarField whole(det(pairMoments(space, data, all)));
        const scalarField kept(det(pairMoments(space, data, keep)));
        for (const label pairi : all)
        {
            for (const label i : {data.owner[pairi], data.neighbour[pairi]})
            {
                if (kept[i] < leastShare*whole[i])
                {
                    keep.set(pairi);
                }
            }
        }
    }


    //- Traces of the first moments of the particles' pair areas
    static scalarField momentTraces(const particleMeshData& data)
    {
        scalarField traces(data.points.size(), Zero);
        forAll(data.Sf, pairi)
        {
            const scalar moment = data.Sf[pairi] & data.delta[pairi];
            traces[data.owner[pairi]] += moment;
            traces[data.neighbour[pairi]] += moment;
        }
        return traces;
    }
}
}


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
    const scalarField whole(momentTraces(data));
    bitSet keep(strongPairs(leastArea, data));
    addNeededPairs(space, data, keep);

    inplaceSubset(keep, data.owner);
    inplaceSubset(keep, data.neighbour);
    inplaceSubset(keep, data.delta);
    inplaceSubset(keep, data.Sf);

    // A pair of the largest area is kept, so that no sum is zero
    const scalarField kept(momentTraces(data));
    forAll(data.Sf, pairi)
    {
        const label i = data.owner[pairi];
        const label j = data.neighbour[pairi];

        data.Sf[pairi] *= 0.5*(whole[i]/kept[i] + whole[j]/kept[j]);
    }
}


// ************************************************************************* //
