/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "meshQuality.H"
#include "cellGrid.H"
#include "compensatedSum.H"
#include "volFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::meshQuality::findNearest()
{
    const solutionSpace& space = particles_.space();
    const vectorField& points = surroundings_.points();

    nearest_.setSize(points.size());

    #pragma omp parallel for schedule(dynamic, 256)
    for (label i = 0; i < points.size(); ++i)
    {
        nearest_[i] = fluid_.find(space.position(points[i]));
    }
}


void Foam::SPH::meshQuality::findSupported()
{
    // Probes on a sphere within the kernel, and how near a particle must be:
    // a little more than half the diagonal of a cubic lattice
    const scalar probeRadius = 0.8;
    const scalar reach = 1.2;

    const solutionSpace& space = particles_.space();
    const vectorField& points = surroundings_.points();
    const labelList& body = surroundings_.body();
    const label nFluid = surroundings_.nFluid();
    const label nSolid = points.size() - nFluid;

    const SubList<vector> solidPoints(points, nSolid, nFluid);
    autoPtr<cellGrid> grid;
    if (nSolid)
    {
        grid.reset(new cellGrid(solidPoints, min(surroundings_.spacing())));
    }

    DynamicList<vector> directions;
    for (const label i : {-1, 0, 1})
    {
        for (const label j : {-1, 0, 1})
        {
            for (const label k : {-1, 0, 1})
            {
                const vector d(i, j, k);
                if (magSqr(d) > 0 && space.toLocal(space.toGlobal(d)) == d)
                {
                    directions.append(d/mag(d));
                }
            }
        }
    }

    supported_.setSize(points.size());
    supported_ = true;

    #pragma omp parallel for schedule(dynamic, 256)
    for (label i = 0; i < points.size(); ++i)
    {
        const scalar dp = surroundings_.spacing()[i];
        const scalar radius = surroundings_.support(i);
        const bool fluid = body[i] == 0;

        if (fluid && -nearest_[i].distance > radius)
        {
            continue;
        }

        for (const vector& direction : directions)
        {
            const vector probe(points[i] + probeRadius*radius*direction);
            bool found = fluid && fluid_.inside(space.position(probe));
            if (!found && nSolid)
            {
                grid->forNear
                (
                    probe,
                    reach*dp,
                    [&](const label j)
                    {
                        found =
                            found
                         || (
                                (fluid || body[nFluid + j] == body[i])
                             && mag(solidPoints[j] - probe) < reach*dp
                            );
                    }
                );
            }
            supported_[i] = supported_[i] && found;
        }
    }
}


void Foam::SPH::meshQuality::addMeanMax
(
    const word& measure,
    const word& set,
    const UList<scalar>& values
)
{
    if (values.size())
    {
        add(measure + "Mean", set, sum(values)/values.size());
        add(measure + "Max", set, max(values));
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::meshQuality::meshQuality
(
    const fvMesh& mesh,
    const particleMesh& particles,
    const UList<particleSet>& solids,
    const signedDistance& fluid
)
:
    mesh_(mesh),
    particles_(particles),
    solids_(solids),
    fluid_(fluid),
    surroundings_(particles, solids)
{
    findNearest();
    findSupported();

    addKernelGradientSums();
    addTotalError();
    add
    (
        "volume",
        "fluid",
        compensatedSum(particles.V())
       /particles.properties().lookupOrDefault<scalar>
        (
            "fluidVolume", gSum(mesh.V())
        )
      - 1
    );
    addClosure();
    addPatchAreas();
    addSpacing();
    addOffSurface();
    addPairAreas();
    addBoundaryFaces();

    scalar kineticEnergy;
    if (particles.properties().readIfPresent("kineticEnergy", kineticEnergy))
    {
        add("kineticEnergy", "fluid", kineticEnergy);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::SPH::meshQuality::value
(
    const word& measure,
    const word& set
) const
{
    for (const row& r : rows_)
    {
        if (r.measure == measure && r.set == set)
        {
            return r.value;
        }
    }

    FatalErrorInFunction
        << "There is no quality measure " << measure << " of the set " << set
        << exit(FatalError);

    return 0;
}


Foam::tmp<Foam::scalarField>
Foam::SPH::meshQuality::kernelGradientSum() const
{
    return mag(surroundings_.gradientSum())*surroundings_.spacing();
}


// ************************************************************************* //
