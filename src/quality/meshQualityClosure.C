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
#include "emptyPolyPatch.H"
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
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (pp.empty() || pp.coupled() || isA<emptyPolyPatch>(pp))
        {
            continue;
        }

        const vectorField Sf(particles_.boundary()[pp.index()].Sf());
        const vectorField::subField faceSf(pp.faceAreas());
        add
        (
            "patchArea",
            pp.name(),
            mag(sum(Sf) - sum(faceSf))/sum(mag(faceSf))
        );
    }
}


void Foam::SPH::meshQuality::addPairAreas()
{
    const particleMeshData& data = particles_.data();
    const solutionSpace& space = particles_.space();

    // Sites of a lattice that kept their diagonals have the whole support
    boolList sites(latticeSites(space, particles_.W(), data));
    forAll(data.owner, pairi)
    {
        const label i = data.owner[pairi];
        if
        (
            sites[i] && sites[data.neighbour[pairi]]
         && mag(data.delta[pairi]) > 1.2*data.spacing[i]
        )
        {
            sites = false;
            break;
        }
    }
    const vectorField raw
    (
        rawPairAreas(space, particles_.W(), data.V, data, sites)
    );

    label nFlipped = 0;
    scalar change = 0;
    scalar shift = 0;
    scalar moved = 0;
    scalar moment = 0;
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

        // Small areas far out in the kernel change much and matter little
        const label i = data.owner[pairi];
        const label j = data.neighbour[pairi];
        const scalar V = min(data.V[i], data.V[j]);
        moved = max(moved, mag(A - raw[pairi])*space.spacing(V)/V);

        if (data.skew.size())
        {
            shift = max(shift, mag(data.skew[pairi])/mag(delta));
            moment = max(moment, mag(data.skew[pairi])*mag(A)/V);
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
    add("areaErrorMax", "pairs", moved);
    add("momentErrorMax", "pairs", moment);
}


void Foam::SPH::meshQuality::addBoundaryFaces()
{
    const particleMeshData& data = particles_.data();
    const boundaryFaces& boundary = data.boundary;

    scalar distance = GREAT;
    scalar offset = 0;
    scalar area = 0;

    forAll(boundary.owner, s)
    {
        const label i = boundary.owner[s];
        const scalar dp = data.spacing[i];
        const vector& Sf = boundary.Sf[s];
        const vector r(boundary.Cf[s] - data.points[i]);

        distance = min(distance, (r & Sf)/(mag(Sf)*dp));
        const scalar off = mag(fluid_.find(boundary.Cf[s]).distance)/dp;
        offset += mag(Sf)*sqr(off);
        area += mag(Sf);
    }

    if (area > 0)
    {
        add("faceDistanceMin", "boundary", distance);
        add("faceOffsetRms", "boundary", sqrt(offset/area));
    }
}


// ************************************************************************* //
