/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Application
    gradientError

Description
    Errors of the solvers' gradients on a 2-D particle mesh, for a linear and a
    quadratic field. Prints, for each field and for walls with a given value
    and without: L2 and largest error over all particles, and over those at
    the boundary, relative to the largest gradient.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "faceStates.H"
#include "gradientWeights.H"
#include "particleMesh.H"

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

//- Faces with the values of a field
class fieldStates
:
    public faceStates
{
public:

    fieldStates(const SPH::particleMesh& particles, const bool given)
    :
        faceStates(particles, 1)
    {
        fixed_[0] = given;
        own_[0] = !given;
    }
};


struct testField
{
    word name;
    scalar (*value)(const vector&);
    vector (*gradient)(const vector&);
};


static const testField fields[] =
{
    {
        "linear",
        [](const vector& x) { return 1 + 2*x.x() - 3*x.y(); },
        [](const vector&) { return vector(2, -3, 0); }
    },
    {
        "quadratic",
        [](const vector& x)
        {
            return sqr(x.x()) + x.x()*x.y() - 2*sqr(x.y());
        },
        [](const vector& x)
        {
            return vector(2*x.x() + x.y(), x.x() - 4*x.y(), 0);
        }
    }
};


static vectorField gradients
(
    const SPH::particleMesh& particles,
    const testField& field,
    const bool given
)
{
    const fieldStates faces(particles, given);
    const gradientWeights weights(faces);
    const vectorField& x = particles.C();

    vectorField sums(particles.nParticles(), Zero);
    forAll(particles.owner(), pairi)
    {
        const label i = particles.owner()[pairi];
        const label j = particles.neighbour()[pairi];
        const vector s
        (
            0.5*(field.value(x[j]) - field.value(x[i]))*particles.Sf()[pairi]
        );
        sums[i] += s;
        sums[j] += s;
    }
    const boundaryFaces& boundary = particles.boundary().faces();
    forAll(boundary.owner, facei)
    {
        if (given)
        {
            const label i = boundary.owner[facei];
            sums[i] +=
                (field.value(boundary.Cf[facei]) - field.value(x[i]))
               *boundary.Sf[facei];
        }
    }

    vectorField gradient(sums.size(), Zero);
    forAll(gradient, i)
    {
        for (direction a = 0; a < 2; ++a)
        {
            for (direction b = 0; b < 2; ++b)
            {
                gradient[i][a] += weights[0][2*a + b][i]*sums[i][b];
            }
        }
    }

    return gradient;
}


int main(int argc, char *argv[])
{
    argList::noParallel();

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    const SPH::particleMesh particles(mesh);
    boolList atBoundary(particles.nParticles(), false);
    for (const label i : particles.boundary().faces().owner)
    {
        atBoundary[i] = true;
    }

    for (const testField& field : fields)
    {
        for (const bool given : {true, false})
        {
            const vectorField gradient(gradients(particles, field, given));

            scalar largest = 0;
            scalar sumSqr = 0, sumSqrAt = 0, maxAll = 0, maxAt = 0;
            label nAt = 0;
            forAll(gradient, i)
            {
                const vector exact(field.gradient(particles.C()[i]));
                const scalar e = mag(gradient[i] - exact);
                largest = max(largest, mag(exact));
                sumSqr += sqr(e);
                maxAll = max(maxAll, e);
                if (atBoundary[i])
                {
                    sumSqrAt += sqr(e);
                    maxAt = max(maxAt, e);
                    ++nAt;
                }
            }

            Info<< "gradient " << field.name << ' '
                << (given ? "given" : "free") << ' '
                << Foam::sqrt(sumSqr/gradient.size())/largest << ' '
                << maxAll/largest << ' '
                << Foam::sqrt(sumSqrAt/max(nAt, label(1)))/largest << ' '
                << maxAt/largest << nl;
        }
    }

    Info<< nl << "End" << nl << endl;

    return 0;
}


// ************************************************************************* //
