/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "momentClosure.H"
#include "pairSystem.H"
#include "particleMoments.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Move face centres least for the first moments
    static pairSystem::performance moveFaceCentres
    (
        const solutionSpace& space,
        const pairGraph& graph,
        const boolList& fixed,
        const scalar tolerance,
        const label maxIterations,
        particleMeshData& data
    );

    //- Largest shift of a face times its area over the volume of a particle
    static scalar largestMomentShift(const particleMeshData& data)
    {
        scalar largest = 0;
        forAll(data.skew, pairi)
        {
            const scalar V =
                min(data.V[data.owner[pairi]], data.V[data.neighbour[pairi]]);
            largest =
                max(largest, mag(data.skew[pairi])*mag(data.Sf[pairi])/V);
        }
        return largest;
    }
}
}


Foam::SPH::pairSystem::performance Foam::SPH::moveFaceCentres
(
    const solutionSpace& space,
    const pairGraph& graph,
    const boolList& fixed,
    const scalar tolerance,
    const label maxIterations,
    particleMeshData& data
)
{
    const label d = space.nDims();
    const label width = d*d;
    const label n = data.points.size();
    const label nPairs = data.owner.size();

    // Springs along unit normals in local coordinates. Their stiffness is area
    // times spacing squared: without the latter the least shifts for the
    // defects of large particles would be those of small ones
    vectorField normal(nPairs);
    vectorField k(nPairs);
    scalarField spacing(nPairs);
    forAll(k, pairi)
    {
        const scalar area = mag(data.Sf[pairi]);
        normal[pairi] = space.toLocal(data.Sf[pairi])/max(area, VSMALL);
        spacing[pairi] =
            0.5
           *(
                data.spacing[data.owner[pairi]]
              + data.spacing[data.neighbour[pairi]]
            );
        k[pairi] = sqrt(area)*spacing[pairi]*normal[pairi];
    }

    // Boundary faces may move as well
    tensorField anchors(n, Zero);
    forAll(data.boundary.owner, s)
    {
        const label i = data.boundary.owner[s];
        const scalar a = mag(data.boundary.Sf[s]);
        const vector m(space.toLocal(data.boundary.Sf[s])/max(a, VSMALL));
        if (!fixed[s])
        {
            anchors[i] += a*sqr(data.spacing[i])*(m*m);
        }
    }

    vectorField x(n);
    forAll(x, i)
    {
        x[i] = space.toLocal(data.points[i]);
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

    scalarField eta(n*width, Zero);
    const pairSystem::performance taken =
        pairSystem(graph, d, k, anchors, x).solve
        (
            b, eta, d, !fixed.found(false), tolerance, maxIterations
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
        data.skew[pairi] = sqr(spacing[pairi])*space.toGlobal(shift);
    }
    forAll(data.boundary.owner, s)
    {
        if (fixed[s])
        {
            continue;
        }
        const vector& Sf = data.boundary.Sf[s];
        const vector m(space.toLocal(Sf)/max(mag(Sf), VSMALL));
        const label i = data.boundary.owner[s];
        const scalar* ei = &eta[i*width];
        vector shift(Zero);
        for (label p = 0; p < d; ++p)
        {
            for (label c = 0; c < d; ++c)
            {
                shift[p] += m[c]*ei[p*d + c];
            }
        }
        data.boundary.Cf[s] += sqr(data.spacing[i])*space.toGlobal(shift);
    }

    return taken;
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::SPH::closeMoments
(
    const solutionSpace& space,
    const pairGraph& graph,
    const boolList& fixed,
    const scalar tolerance,
    const label maxIterations,
    particleMeshData& data
)
{
    // Where a zone is one or two particles thick its pairs cannot bear what
    // its fixed faces leave
    constexpr scalar mostShift = 0.6;

    const pointField Cf(data.boundary.Cf);
    pairSystem::performance taken = moveFaceCentres
    (
        space, graph, fixed, tolerance, maxIterations, data
    );

    const bool failed = !(taken.residual <= 10*tolerance);
    const scalar shift = largestMomentShift(data);
    if (fixed.found(true) && (failed || shift > mostShift))
    {
        const vectorField fixedSkew(data.skew);
        const pointField fixedCf(data.boundary.Cf);
        const pairSystem::performance fixedTaken(taken);

        data.skew.clear();
        data.boundary.Cf = Cf;
        const boolList none(fixed.size(), false);
        taken = moveFaceCentres
        (
            space, graph, none, tolerance, maxIterations, data
        );

        // Shifts that free faces would not spare are not the border's, as those
        // of a particle around a sharp edge
        if (!failed && largestMomentShift(data) > 0.5*shift)
        {
            data.skew = fixedSkew;
            data.boundary.Cf = fixedCf;
            taken = fixedTaken;
        }
        else
        {
            forAll(fixed, s)
            {
                if (fixed[s])
                {
                    data.boundary.Cf[s] = Cf[s];
                }
            }
            Info<< "    zone too thin for exact first moments; largest defect"
                << " over a volume: " << largestDefect(space, data) << endl;
        }
    }
    taken.log("closing moments", tolerance);

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

// ************************************************************************* //
