/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "torqueClosure.H"
#include "pairSystem.H"
#include "particleMoments.H"
#include "scalarMatrices.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- A component p of x and an axis q of its torque
    struct torqueMode
    {
        label p;
        label q;
    };

    static List<torqueMode> torqueModes(const label nDims)
    {
        DynamicList<torqueMode> modes;
        for (label p = 0; nDims > 1 && p < nDims; ++p)
        {
            for (label q = nDims == 2 ? 2 : 0; q < 3; ++q)
            {
                modes.append(torqueMode{p, q});
            }
        }
        return modes;
    }

    //- Torque of the defects of each connected set, for each mode
    static List<scalarField> torques
    (
        const solutionSpace& space,
        const List<torqueMode>& modes,
        const labelList& sets,
        const vectorField& points,
        const label nSets,
        const particleMeshData& data
    )
    {
        const tensorField moments(firstMoments(data));

        List<scalarField> sums(nSets, scalarField(modes.size(), Zero));
        forAll(points, i)
        {
            forAll(modes, a)
            {
                vector defect(Zero);
                defect[modes[a].p] = data.V[i];
                for (label c = 0; c < space.nDims(); ++c)
                {
                    defect[c] -=
                        moments[i](space.axis(modes[a].p), space.axis(c));
                }
                sums[sets[i]][a] += (points[i] ^ defect)[modes[a].q];
            }
        }
        return sums;
    }

    //- Closed pair areas nearest to those that exert the torque of a mode
    static vectorField closedAreas
    (
        const solutionSpace& space,
        const pairGraph& graph,
        const torqueMode& mode,
        const vectorField& points,
        const scalarField& w,
        const scalar tolerance,
        const label maxIterations,
        const particleMeshData& data
    )
    {
        const label d = space.nDims();
        vector axis(Zero);
        axis[mode.q] = 1;

        // Of order w
        const scalar scale =
            1/(max(mag(points))*min(data.spacing) + VSMALL);

        vectorField areas(w.size());
        scalarField b(points.size()*d, Zero);
        forAll(areas, pairi)
        {
            const vector delta(space.toLocal(data.delta[pairi]));
            const vector middle(points[data.owner[pairi]] + 0.5*delta);
            areas[pairi] = -scale*w[pairi]*delta[mode.p]*(axis ^ middle);
            for (label c = 0; c < d; ++c)
            {
                b[data.owner[pairi]*d + c] += areas[pairi][c];
                b[data.neighbour[pairi]*d + c] -= areas[pairi][c];
            }
        }

        scalarField chi(b.size(), Zero);
        pairSystem(graph, w).solve
        (
            b, chi, d, true, tolerance, maxIterations
        ).log("closing torques", tolerance);

        forAll(areas, pairi)
        {
            for (label c = 0; c < d; ++c)
            {
                areas[pairi][c] -=
                    w[pairi]
                   *(
                        chi[data.owner[pairi]*d + c]
                      - chi[data.neighbour[pairi]*d + c]
                    );
            }
            areas[pairi] /= scale;
        }
        return areas;
    }
}
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::SPH::closeTorques
(
    const solutionSpace& space,
    const pairGraph& graph,
    const scalar tolerance,
    const label maxIterations,
    particleMeshData& data
)
{
    const List<torqueMode> modes(torqueModes(space.nDims()));
    const labelList sets(graph.connectedSets());
    const label nSets = max(sets) + 1;

    // Positions from the centre of each set
    vectorField points(data.points.size());
    vectorField centres(nSets, Zero);
    scalarField number(nSets, Zero);
    forAll(points, i)
    {
        points[i] = space.toLocal(data.points[i]);
        centres[sets[i]] += points[i];
        number[sets[i]] += 1;
    }
    forAll(points, i)
    {
        points[i] -= centres[sets[i]]/number[sets[i]];
    }

    const scalarField w(mag(data.Sf));
    List<vectorField> areas(modes.size());
    forAll(modes, a)
    {
        areas[a] = closedAreas
        (
            space, graph, modes[a], points, w, tolerance, maxIterations, data
        );
    }

    // The change of torque a by a unit of areas b. A set without loops has no
    // closed areas but round-off
    constexpr scalar roundOff = 1e-12;
    List<scalarSquareMatrix> change
    (
        nSets, scalarSquareMatrix(modes.size(), Zero)
    );
    forAll(w, pairi)
    {
        const label i = data.owner[pairi];
        scalarSquareMatrix& m = change[sets[i]];
        forAll(modes, a)
        {
            m(a, a) +=
                roundOff*w[pairi]*magSqr(data.delta[pairi])*magSqr(points[i]);
            forAll(modes, b)
            {
                m(a, b) +=
                    (areas[a][pairi] & areas[b][pairi])/max(w[pairi], VSMALL);
            }
        }
    }

    List<scalarField> amplitude
    (
        torques(space, modes, sets, points, nSets, data)
    );
    forAll(amplitude, seti)
    {
        if (number[seti] > 2)
        {
            LUsolve(change[seti], amplitude[seti]);
        }
    }

    forAll(w, pairi)
    {
        forAll(modes, a)
        {
            data.Sf[pairi] -=
                amplitude[sets[data.owner[pairi]]][a]
               *space.toGlobal(areas[a][pairi]);
        }
    }
}


// ************************************************************************* //
