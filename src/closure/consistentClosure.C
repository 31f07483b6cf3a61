/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "consistentClosure.H"
#include "checkEntries.H"
#include "borderPatch.H"
#include "mirroredFaces.H"
#include "momentClosure.H"
#include "pairSystem.H"
#include "particleMoments.H"
#include "periodicImages.H"
#include "torqueClosure.H"
#include "addToRunTimeSelectionTable.H"
#include "compensatedSum.H"
#include "scalarMatrices.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    defineTypeNameAndDebug(consistentClosure, 0);
    addToRunTimeSelectionTable(closure, consistentClosure, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Largest change of a pair area in one renormalisation, relative
    static const scalar maxChange = 0.3;

    //- Reduction of the residual between renormalisations, which spoil it
    static const scalar sweepTolerance = 1e-3;

    //- Sweeps go on while a first moment is distorted more than this: particles
    //- at a sharp edge need more of them than others
    static const scalar largeDistortion = 0.2;
    static const label mostSweeps = 12;

    //- Largest deviation of a first moment from its isotropic part, which
    //- becomes the volume, over that
    static scalar largestDistortion
    (
        const solutionSpace& space,
        const particleMeshData& data
    )
    {
        const tensorField moments(firstMoments(data));
        const scalarField volumes(tr(moments)/space.nDims());

        scalar largest = 0;
        forAll(volumes, i)
        {
            largest = max
            (
                largest,
                mag(moments[i] - volumes[i]*space.identity())
               /max(volumes[i], SMALL*data.V[i])
            );
        }
        return largest;
    }

    //- Are boundary faces on the border, where the first moments of their parts
    //- are those of FVM
    static boolList fixedFaces
    (
        const fvMesh& mesh,
        const boundaryFaces& boundary
    )
    {
        boolList fixed(boundary.owner.size(), false);
        for (const polyPatch& pp : mesh.boundaryMesh())
        {
            const label start = boundary.start[pp.index()];
            const label end = boundary.start[pp.index() + 1];
            for (label s = start; isBorder(pp) && s < end; ++s)
            {
                fixed[s] = true;
            }
        }
        return fixed;
    }

    //- FatalError if a part of a zone has too few particles to be closed
    static void checkBorder
    (
        const pairGraph& graph,
        const boolList& fixed,
        const particleMeshData& data
    )
    {
        constexpr scalar farthest = 2;

        const labelList sets(graph.connectedSets());
        labelList number(data.points.size(), Zero);
        for (const label seti : sets)
        {
            ++number[seti];
        }

        // The boundary of a set is closed unless a neck too narrow for pairs
        // joins it to another
        vectorField sum(data.points.size(), Zero);
        scalarField area(data.points.size(), Zero);
        forAll(fixed, s)
        {
            const label seti = sets[data.boundary.owner[s]];
            sum[seti] += data.boundary.Sf[s];
            area[seti] += mag(data.boundary.Sf[s]);
        }

        forAll(fixed, s)
        {
            const label i = data.boundary.owner[s];
            const point& Cf = data.boundary.Cf[s];
            const bool far =
                mag(Cf - data.points[i]) > farthest*data.spacing[i];

            if (mag(sum[sets[i]]) > 1e-6*area[sets[i]])
            {
                FatalErrorInFunction
                    << "zone: a neck narrower than the particles' spacing "
                    << data.spacing[i] << " joins its part at "
                    << data.points[i] << " to the rest. Widen it, leave the"
                    << " part out, or set a smaller spacing"
                    << exit(FatalError);
            }
            if (fixed[s] && (far || number[sets[i]] < 2))
            {
                FatalErrorInFunction
                    << "zone: its part at " << Cf << " is smaller than two"
                    << " particles of spacing " << data.spacing[i]
                    << ". Make it larger or leave it out, or set a smaller"
                    << " spacing" << exit(FatalError);
            }
        }
    }
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::consistentClosure::consistentClosure(const dictionary& dict)
:
    order_(dict.lookupOrDefault<label>("order", 1)),
    nSweeps_(dict.lookupOrDefault<label>("sweeps", 2)),
    consistentVolumes_(true),
    leastArea_(dict.lookupOrDefault<scalar>("leastArea", 0.1)),
    nearestOnLattice_
    (
        checkedWord(dict, "latticePairs", "nearest", {"nearest", "all"})
     == "nearest"
    ),
    tolerance_(dict.lookupOrDefault<scalar>("tolerance", 5e-14)),
    maxIterations_(dict.lookupOrDefault<label>("maxIterations", 20000))
{
    if (order_ != 0 && order_ != 1)
    {
        FatalIOErrorInFunction(dict)
            << "order " << order_ << " is not known. Valid choices: 0 or 1"
            << exit(FatalIOError);
    }

    if (leastArea_ < 0 || leastArea_ > 0.3)
    {
        FatalIOErrorInFunction(dict)
            << "leastArea " << leastArea_ << " is outside the range 0 to 0.3"
            << exit(FatalIOError);
    }

    const word volumes
    (
        dict.lookupOrDefault<word>("volumes", "consistent")
    );
    consistentVolumes_ = volumes == "consistent";
    if (!consistentVolumes_ && volumes != "uniform")
    {
        FatalIOErrorInFunction(dict)
            << "volumes " << volumes
            << " is not known. Valid choices: consistent, uniform"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::SPH::consistentClosure::areaTolerance
(
    const solutionSpace& space,
    const particleMeshData& data
) const
{
    const scalar dp = min(data.spacing);

    return tolerance_*space.volume(dp)/dp;
}


void Foam::SPH::consistentClosure::closeAreas
(
    const solutionSpace& space,
    const pairGraph& graph,
    const scalar tolerance,
    particleMeshData& data
) const
{
    const label d = space.nDims();
    const label n = data.points.size();

    const scalarField w(mag(data.Sf));
    const vectorField residual(areaSums(data));
    scalarField b(n*d);
    forAll(residual, i)
    {
        for (label c = 0; c < d; ++c)
        {
            b[i*d + c] = -residual[i][space.axis(c)];
        }
    }

    scalarField lambda(n*d, Zero);
    pairSystem(graph, w).solve
    (
        b, lambda, d, true, tolerance, maxIterations_
    ).log("closing areas", tolerance);

    forAll(data.Sf, pairi)
    {
        const label i = data.owner[pairi];
        const label j = data.neighbour[pairi];
        for (label c = 0; c < d; ++c)
        {
            data.Sf[pairi][space.axis(c)] +=
                w[pairi]*(lambda[i*d + c] - lambda[j*d + c]);
        }
    }
}


void Foam::SPH::consistentClosure::renormalise
(
    const solutionSpace& space,
    particleMeshData& data
) const
{
    // First moments of the boundary faces alone, and of the pairs
    particleMeshData boundaryOnly;
    boundaryOnly.points = data.points;
    boundaryOnly.boundary = data.boundary;
    const tensorField boundaryMoments(firstMoments(boundaryOnly));
    const tensorField moments(firstMoments(data));

    const tensor unsolved(tensor::I - space.identity());
    tensorField correction(moments.size(), tensor::I);
    forAll(correction, i)
    {
        const tensor pairMoment
        (
            (moments[i] - boundaryMoments[i])/data.V[i] + unsolved
        );
        const tensor wanted
        (
            tensor::I - boundaryMoments[i]/data.V[i]
        );

        if (mag(det(pairMoment)) > 0.05)
        {
            const tensor change((inv(pairMoment) & wanted) - tensor::I);
            correction[i] += change*min(1.0, maxChange/(mag(change) + VSMALL));
        }
    }

    forAll(data.Sf, pairi)
    {
        data.Sf[pairi] =
            data.Sf[pairi]
          & 0.5
           *(
                correction[data.owner[pairi]]
              + correction[data.neighbour[pairi]]
            );
    }
}


void Foam::SPH::consistentClosure::closePeriodicPlanes
(
    const fvMesh& mesh,
    const solutionSpace& space,
    const pairGraph& graph,
    particleMeshData& data
) const
{
    const List<vector> translations(periodicTranslations(mesh));
    const label nT = translations.size();
    if (nT == 0)
    {
        return;
    }

    // Closed circulating areas f_k along each translation: the potential
    // flow of a unit gradient
    const label n = data.points.size();
    const scalarField w(mag(data.Sf));
    scalarField b(n*nT, Zero);
    forAll(data.owner, pairi)
    {
        for (label k = 0; k < nT; ++k)
        {
            const scalar g =
                w[pairi]*(data.delta[pairi] & translations[k])
               /mag(translations[k]);
            b[data.owner[pairi]*nT + k] -= g;
            b[data.neighbour[pairi]*nT + k] += g;
        }
    }

    scalarField chi(n*nT, Zero);
    const scalar tolerance =
        areaTolerance(space, data)*min(data.spacing);
    pairSystem(graph, w).solve
    (
        b, chi, nT, true, tolerance, maxIterations_
    ).log("closing periodic planes", tolerance);

    // What is missing of V I in the sum of all first moments
    const tensor missing
    (
        sum(data.V)*space.identity() - sum(firstMoments(data))
    );

    scalarSquareMatrix moment(nT, Zero);
    const auto circulation = [&](const label pairi, const label k)
    {
        return w[pairi]
           *(
                chi[data.owner[pairi]*nT + k]
              - chi[data.neighbour[pairi]*nT + k]
              + (data.delta[pairi] & translations[k])/mag(translations[k])
            );
    };

    forAll(data.owner, pairi)
    {
        for (label k = 0; k < nT; ++k)
        {
            const scalar along =
                (data.delta[pairi] & translations[k])/mag(translations[k]);
            for (label l = 0; l < nT; ++l)
            {
                moment(k, l) += along*circulation(pairi, l);
            }
        }
    }

    List<vector> amplitude(nT);
    for (label k = 0; k < nT; ++k)
    {
        amplitude[k] = (translations[k]/mag(translations[k])) & missing;
    }
    LUsolve(moment, amplitude);

    forAll(data.Sf, pairi)
    {
        for (label k = 0; k < nT; ++k)
        {
            data.Sf[pairi] += circulation(pairi, k)*amplitude[k];
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::consistentClosure::close
(
    const fvMesh& mesh,
    const solutionSpace& space,
    const kernel& W,
    const signedDistance&,
    particleMeshData& data
) const
{
    data.boundary = mirroredFaces(mesh, space, W, data);

    const pairGraph graph
    (
        mesh.time(), data.points.size(), data.owner, data.neighbour
    );
    const boolList fixed(fixedFaces(mesh, data.boundary));
    if (fixed.found(true))
    {
        checkBorder(graph, fixed, data);
    }

    const scalar tolerance = areaTolerance(space, data);
    const auto further = [&](const label sweep)
    {
        return
            nSweeps_ > 0
         && sweep < mostSweeps
         && largestDistortion(space, data) > largeDistortion;
    };
    for (label sweep = 0; sweep < nSweeps_ || further(sweep); ++sweep)
    {
        renormalise(space, data);
        const scalar largest = max(mag(areaSums(data)()));
        closeAreas
        (
            space, graph, max(sweepTolerance*largest, tolerance), data
        );
    }
    closeAreas(space, graph, tolerance, data);
    closePeriodicPlanes(mesh, space, graph, data);

    if (consistentVolumes_)
    {
        data.V = tr(firstMoments(data))/space.nDims();

        // Warped boundary faces enclose another volume than the cells have
        data.V *= gSum(mesh.V())/compensatedSum(data.V);
    }
    if (order_ == 1)
    {
        if (fixed.found(true) && periodicTranslations(mesh).empty())
        {
            closeTorques(space, graph, tolerance, maxIterations_, data);

            // A few particles bear torques by large areas, with their error
            closeAreas(space, graph, tolerance, data);
        }
        closeMoments
        (
            space,
            graph,
            fixed,
            tolerance*min(data.spacing),
            maxIterations_,
            data
        );
    }
}


// ************************************************************************* //
