/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "consistentClosure.H"
#include "mirroredFaces.H"
#include "pairMultigrid.H"
#include "particleMoments.H"
#include "periodicImages.H"
#include "addToRunTimeSelectionTable.H"
#include "bitSet.H"
#include "scalarMatrices.H"

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

    //- Solve sum_j w_ij (x_i - x_j) = b_i for nSides fields side by side
    static pairGraph::performance solveLaplacian
    (
        const pairGraph& graph,
        const label nDims,
        const scalarField& w,
        const scalarField& b,
        scalarField& x,
        const label nSides,
        const scalar tolerance,
        const label maxIterations
    )
    {
        const label n = graph.nParticles();

        scalarField diagonal(n, Zero);
        for (label i = 0; i < n; ++i)
        {
            graph.forLinks
            (
                i,
                [&](const label, const label pairi)
                {
                    diagonal[i] += w[pairi];
                }
            );
            diagonal[i] = max(diagonal[i], VSMALL);
        }

        const auto A = [&](const scalarField& u, scalarField& v)
        {
            #pragma omp parallel for schedule(static)
            for (label i = 0; i < n; ++i)
            {
                scalar sum[9] = {};
                const scalar* ui = &u[i*nSides];
                graph.forLinks
                (
                    i,
                    [&](const label j, const label pairi)
                    {
                        const scalar* uj = &u[j*nSides];
                        for (label s = 0; s < nSides; ++s)
                        {
                            sum[s] += w[pairi]*(ui[s] - uj[s]);
                        }
                    }
                );
                std::copy(sum, sum + nSides, &v[i*nSides]);
            }
        };

        const auto jacobi = [&](const scalarField& r, scalarField& z)
        {
            #pragma omp parallel for schedule(static)
            for (label i = 0; i < n; ++i)
            {
                for (label s = 0; s < nSides; ++s)
                {
                    z[i*nSides + s] = r[i*nSides + s]/diagonal[i];
                }
            }
        };

        const pairMultigrid multigrid
        (
            graph,
            nDims,
            1,
            [&](const label pairi, scalar* block) { *block = w[pairi]; },
            [](const label, scalar* block) { *block = 0; }
        );

        return graph.solve
        (
            A,
            [&](const scalarField& r, scalarField& z)
            {
                multigrid.precondition(A, jacobi, r, z, nSides);
            },
            b,
            x,
            nSides,
            1,
            true,
            tolerance,
            maxIterations
        );
    }

    static void report
    (
        const char* what,
        const pairGraph::performance& performance,
        const scalar tolerance
    )
    {
        Info<< "    " << what << ": " << performance.nIterations
            << " iterations, residual/tolerance "
            << performance.residual/tolerance << endl;
    }
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::consistentClosure::consistentClosure(const dictionary& dict)
:
    order_(dict.lookupOrDefault<label>("order", 1)),
    nSweeps_(dict.lookupOrDefault<label>("sweeps", 2)),
    consistentVolumes_(true),
    tolerance_(dict.lookupOrDefault<scalar>("tolerance", 5e-14)),
    maxIterations_(dict.lookupOrDefault<label>("maxIterations", 20000))
{
    if (order_ != 0 && order_ != 1)
    {
        FatalIOErrorInFunction(dict)
            << "order " << order_ << " is not known. Valid choices: 0 or 1"
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
    report
    (
        "closing areas",
        solveLaplacian
        (
            graph,
            d,
            w,
            b,
            lambda,
            d,
            tolerance,
            maxIterations_
        ),
        tolerance
    );

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
    report
    (
        "closing periodic planes",
        solveLaplacian
        (
            graph, space.nDims(), w, b, chi, nT, tolerance, maxIterations_
        ),
        tolerance
    );

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


void Foam::SPH::consistentClosure::closeMoments
(
    const solutionSpace& space,
    const pairGraph& graph,
    particleMeshData& data
) const
{
    const label d = space.nDims();
    const label width = d*d;
    const label n = data.points.size();
    const label nPairs = data.owner.size();

    // Unit normals and areas in local coordinates
    scalarField area(nPairs);
    vectorField normal(nPairs);
    forAll(area, pairi)
    {
        area[pairi] = mag(data.Sf[pairi]);
        normal[pairi] =
            space.toLocal(data.Sf[pairi])/max(area[pairi], VSMALL);
    }

    // Diagonal blocks, boundary faces included: these may move as well
    List<tensor> diagonal(n, Zero);
    List<tensor> boundaryBlock(n, Zero);
    forAll(data.boundary.owner, s)
    {
        const scalar a = mag(data.boundary.Sf[s]);
        const vector m(space.toLocal(data.boundary.Sf[s])/max(a, VSMALL));
        boundaryBlock[data.boundary.owner[s]] += a*(m*m);
    }
    diagonal = boundaryBlock;
    forAll(area, pairi)
    {
        const tensor block(area[pairi]*(normal[pairi]*normal[pairi]));
        diagonal[data.owner[pairi]] += block;
        diagonal[data.neighbour[pairi]] += block;
    }
    forAll(diagonal, i)
    {
        for (label c = d; c < 3; ++c)
        {
            diagonal[i](c, c) = 1;
        }
        // Keeps the block of a particle with parallel faces invertible
        const scalar shift = 1e-6*tr(diagonal[i]);
        diagonal[i] = inv(diagonal[i] + tensor(shift*I));
    }

    const tensorField moments(firstMoments(data));
    scalarField b(n*width);
    for (label i = 0; i < n; ++i)
    {
        for (label p = 0; p < d; ++p)
        {
            for (label c = 0; c < d; ++c)
            {
                b[i*width + p*d + c] =
                    (p == c ? data.V[i] : 0)
                  - moments[i](space.axis(p), space.axis(c));
            }
        }
    }

    const auto A = [&](const scalarField& u, scalarField& v)
    {
        #pragma omp parallel for schedule(static)
        for (label i = 0; i < n; ++i)
        {
            scalar sum[9] = {};
            const scalar* ui = &u[i*width];
            for (label p = 0; p < d; ++p)
            {
                for (label c = 0; c < d; ++c)
                {
                    for (label k = 0; k < d; ++k)
                    {
                        sum[p*d + c] += boundaryBlock[i](c, k)*ui[p*d + k];
                    }
                }
            }
            graph.forLinks
            (
                i,
                [&](const label j, const label pairi)
                {
                    const scalar* uj = &u[j*width];
                    const vector& m = normal[pairi];
                    for (label p = 0; p < d; ++p)
                    {
                        scalar stretch = 0;
                        for (label c = 0; c < d; ++c)
                        {
                            stretch += m[c]*(ui[p*d + c] - uj[p*d + c]);
                        }
                        stretch *= area[pairi];
                        for (label c = 0; c < d; ++c)
                        {
                            sum[p*d + c] += stretch*m[c];
                        }
                    }
                }
            );
            std::copy(sum, sum + width, &v[i*width]);
        }
    };

    const auto jacobi = [&](const scalarField& r, scalarField& z)
    {
        #pragma omp parallel for schedule(static)
        for (label i = 0; i < n; ++i)
        {
            for (label p = 0; p < d; ++p)
            {
                for (label c = 0; c < d; ++c)
                {
                    scalar sum = 0;
                    for (label k = 0; k < d; ++k)
                    {
                        sum += diagonal[i](c, k)*r[i*width + p*d + k];
                    }
                    z[i*width + p*d + c] = sum;
                }
            }
        }
    };

    const pairMultigrid multigrid
    (
        graph,
        d,
        d,
        [&](const label pairi, scalar* block)
        {
            for (label c = 0; c < d; ++c)
            {
                for (label k = 0; k < d; ++k)
                {
                    block[c*d + k] =
                        area[pairi]*normal[pairi][c]*normal[pairi][k];
                }
            }
        },
        [&](const label i, scalar* block)
        {
            for (label c = 0; c < d; ++c)
            {
                for (label k = 0; k < d; ++k)
                {
                    block[c*d + k] = boundaryBlock[i](c, k);
                }
            }
        }
    );

    const scalar tolerance = areaTolerance(space, data)*min(data.spacing);
    scalarField eta(n*width, Zero);
    report
    (
        "closing moments",
        graph.solve
        (
            A,
            [&](const scalarField& r, scalarField& z)
            {
                multigrid.precondition(A, jacobi, r, z, d);
            },
            b,
            eta,
            d,
            d,
            data.boundary.owner.empty(),
            tolerance,
            maxIterations_
        ),
        tolerance
    );

    data.skew.setSize(nPairs);
    forAll(data.skew, pairi)
    {
        const scalar* ei = &eta[data.owner[pairi]*width];
        const scalar* ej = &eta[data.neighbour[pairi]*width];
        vector shift(Zero);
        for (label p = 0; p < d; ++p)
        {
            for (label c = 0; c < d; ++c)
            {
                shift[p] += normal[pairi][c]*(ei[p*d + c] - ej[p*d + c]);
            }
        }
        data.skew[pairi] = space.toGlobal(shift);
    }
    forAll(data.boundary.owner, s)
    {
        const vector& Sf = data.boundary.Sf[s];
        const vector m(space.toLocal(Sf)/max(mag(Sf), VSMALL));
        const scalar* ei = &eta[data.boundary.owner[s]*width];
        vector shift(Zero);
        for (label p = 0; p < d; ++p)
        {
            for (label c = 0; c < d; ++c)
            {
                shift[p] += m[c]*ei[p*d + c];
            }
        }
        data.boundary.Cf[s] += space.toGlobal(shift);
    }

    scalar largest = 0;
    forAll(data.skew, pairi)
    {
        largest = max
        (
            largest,
            mag(data.skew[pairi])/mag(data.delta[pairi])
        );
    }
    Info<< "    largest shift of a face centre over its pair's length: "
        << largest << endl;
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

    // Lattice factor of the raw areas, the mean of what should be one
    {
        bitSet atBoundary(data.points.size());
        atBoundary.setMany
        (
            data.boundary.owner.begin(),
            data.boundary.owner.end()
        );

        const scalarField ratio(tr(firstMoments(data))/data.V);
        scalar sum = 0;
        label count = 0;
        forAll(ratio, i)
        {
            if (!atBoundary.test(i))
            {
                sum += ratio[i]/space.nDims();
                ++count;
            }
        }
        if (count)
        {
            data.Sf /= sum/count;
        }
    }

    const pairGraph graph(data.points.size(), data.owner, data.neighbour);

    const scalar tolerance = areaTolerance(space, data);
    for (label sweep = 0; sweep < nSweeps_; ++sweep)
    {
        closeAreas(space, graph, sweepTolerance*max(mag(areaSums(data)())), data);
        renormalise(space, data);
    }
    closeAreas(space, graph, tolerance, data);
    closePeriodicPlanes(mesh, space, graph, data);

    if (consistentVolumes_)
    {
        data.V = tr(firstMoments(data))/space.nDims();
    }
    if (order_ == 1)
    {
        closeMoments(space, graph, data);
    }
}


// ************************************************************************* //
