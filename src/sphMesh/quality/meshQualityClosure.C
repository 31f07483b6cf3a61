/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    Measures of the closure.

\*---------------------------------------------------------------------------*/

#include "meshQuality.H"
#include "particleMoments.H"
#include "rawPairAreas.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::meshQuality::addClosure()
{
    const solutionSpace& space = particles_.space();
    const vectorField residual(areaSums(particles_.data()));
    const tensorField moment(firstMoments(particles_.data()));

    scalar closure = 0;
    scalar largest = 0;
    scalar squares = 0;
    forAll(residual, i)
    {
        const scalar V = particles_.V()[i];
        const scalar linear = mag(moment[i] - V*space.identity())/V;

        closure = max(closure, mag(residual[i])*space.spacing(V)/V);
        largest = max(largest, linear);
        squares += sqr(linear);
    }

    add("closureResidual", "fluid", closure);
    add("linearResidualMax", "fluid", largest);
    add("linearResidualRms", "fluid", sqrt(squares/residual.size()));
}


void Foam::SPH::meshQuality::addPatchAreas()
{
    for (const sphPatch& patch : particles_.boundary())
    {
        const polyPatch& pp = patch.patch().patch();
        if (pp.empty() || pp.coupled() || patch.patch().size() == 0)
        {
            continue;
        }

        const vectorField Sf(patch.Sf());
        const vectorField::subField faceSf(pp.faceAreas());
        add
        (
            "patchArea",
            patch.name(),
            mag(sum(Sf) - sum(faceSf))/sum(mag(faceSf))
        );
    }
}


void Foam::SPH::meshQuality::addPairAreas()
{
    const particleMeshData& data = particles_.data();
    const solutionSpace& space = particles_.space();
    const vectorField raw
    (
        rawPairAreas
        (
            space,
            particles_.W(),
            data.V,
            data
        )
    );

    label nFlipped = 0;
    scalar change = 0;
    scalar shift = 0;
    forAll(raw, pairi)
    {
        const vector& A = data.Sf[pairi];
        const vector& delta = data.delta[pairi];

        if ((A & delta)*(raw[pairi] & delta) < 0)
        {
            ++nFlipped;
        }
        change = max
        (
            change,
            mag(A - raw[pairi])/max(mag(raw[pairi]), VSMALL)
        );
        if (data.skew.size())
        {
            shift = max(shift, mag(data.skew[pairi])/mag(delta));
        }
    }

    add("flippedAreas", "pairs", nFlipped);
    add
    (
        "flippedAreasFraction",
        "pairs",
        scalar(nFlipped)/max(raw.size(), label(1))
    );
    add("areaChangeMax", "pairs", change);
    add("faceShiftMax", "pairs", shift);
}


// ************************************************************************* //
