/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleMeshAssembly.H"
#include "cpuTime.H"
#include "particlePairs.H"
#include "periodicImages.H"
#include "rawPairAreas.H"
#include "spaceFillingCurve.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Part of the support whose pairs have areas of 1e-8 dp^(d-1) or less:
    //- their two halves in cyclic patches would differ by round-off
    static constexpr scalar kernelTail = 2e-3;

    //- Drop the pairs that a body hides from one another
    static void dropHiddenPairs
    (
        const solutionSpace& space,
        const pointField& points,
        const scalarField& radius,
        const signedDistance& fluid,
        particlePairs& pairs
    )
    {
        // Only particles within their radius of the surface can be hidden
        const label n = points.size();
        List<signedDistance::nearest> nearest(n);

        #pragma omp parallel for schedule(dynamic, 256)
        for (label i = 0; i < n; ++i)
        {
            nearest[i] = fluid.find(points[i]);
        }

        boolList keep(pairs.size(), true);
        forAll(keep, pairi)
        {
            const signedDistance::nearest& a = nearest[pairs.owner[pairi]];
            const signedDistance::nearest& b = nearest[pairs.neighbour[pairi]];
            const scalar r = mag(pairs.delta[pairi]);

            if (mag(a.distance) + mag(b.distance) < r)
            {
                const vector d(space.toGlobal(pairs.delta[pairi]));
                const vector ha(a.hit - points[pairs.owner[pairi]]);
                const vector hb(b.hit - points[pairs.neighbour[pairi]]);

                keep[pairi] =
                    !(((d - ha) & a.normal) > 0 && ((-d - hb) & b.normal) > 0);
            }
        }

        pairs.subset(keep);
    }
}
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::SPH::particleMeshData Foam::SPH::assembleParticleMesh
(
    const fvMesh& mesh,
    const kernel& W,
    const particleSet& particles,
    const signedDistance& fluid,
    const closure& method
)
{
    const solutionSpace space(mesh);
    const label n = particles.points.size();

    particleMeshData data;

    vectorField local(n);
    forAll(local, i)
    {
        local[i] = space.toLocal(particles.points[i]);
    }
    const labelList order
    (
        spaceFillingOrder(local, min(particles.spacing))
    );
    local = vectorField(local, order);
    data.points = pointField(particles.points, order);
    data.spacing = scalarField(particles.spacing, order);

    scalarField radius(n);
    forAll(radius, i)
    {
        radius[i] = (1 - kernelTail)*W.support(data.spacing[i]);
    }

    vectorField translations(periodicTranslations(mesh));
    for (vector& T : translations)
    {
        T = space.toLocal(T);
    }
    particlePairs pairs(local, radius, imageOffsets(translations));
    dropHiddenPairs(space, data.points, radius, fluid, pairs);

    data.delta.setSize(pairs.size());
    forAll(data.delta, pairi)
    {
        data.delta[pairi] = space.toGlobal(pairs.delta[pairi]);
    }
    data.owner.transfer(pairs.owner);
    data.neighbour.transfer(pairs.neighbour);
    data.V = rawVolumes
    (
        space,
        data.spacing,
        particles.density.empty() || method.uniformVolumes()
      ? scalarField(n, scalar(1))
      : scalarField(particles.density, order),
        particles.volume > 0 ? particles.volume : gSum(mesh.V())
    );
    data.sites =
        method.nearestOnLattice()
      ? latticeSites(space, W, data)
      : boolList(n, false);
    data.Sf = rawPairAreas(space, W, data.V, data, data.sites);
    dropWeakPairs(space, method.leastArea(), data);

    const cpuTime clock;
    method.close(mesh, space, W, fluid, data);
    Info<< "    closed in " << clock.elapsedCpuTime() << " s CPU" << endl;

    return data;
}


// ************************************************************************* //
