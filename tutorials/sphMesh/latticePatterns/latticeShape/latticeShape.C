/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Application
    latticeShape

Description
    Tells the pattern of a 2-D particle mesh: hexagon, square or parallelogram.

    A particle is ordered if its neighbourhood is a lattice, r and -r both
    occupied for the two shortest independent neighbour vectors a and b and
    for the shorter of a - b and a + b. Of these three vectors, the ratio of
    the longest to the shortest is 1 for hexagons and sqrt(2) for squares. Its
    median over the ordered particles tells the pattern: hexagons, which defects
    distort by some percent, up to 1.1, squares from 1.36. Bond orders
    psi_n = |mean over the n nearest of exp(i n theta)| are given beside it.

    Particles within four spacings of a boundary are left out.

Usage
    \b latticeShape

    Prints a line 'pattern' with the pattern, the fraction of ordered
    particles, the means of psi_4 and psi_6 and the ratio of the diagonals.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "emptyPolyPatch.H"
#include "periodicImages.H"
#include "solutionSpace.H"
#include "particleMesh.H"

#include <algorithm>
#include <complex>
#include <vector>

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

//- Neighbour vectors within a distance, the nearest first
static std::vector<vector> neighbours
(
    const pointField& points,
    const List<vector>& shifts,
    const label i,
    const scalar distance
)
{
    std::vector<vector> found;
    for (const vector& shift : shifts)
    {
        forAll(points, j)
        {
            const vector r(points[j] + shift - points[i]);
            if (magSqr(r) < sqr(distance) && magSqr(r) > VSMALL)
            {
                found.push_back(r);
            }
        }
    }
    std::sort
    (
        found.begin(),
        found.end(),
        [](const vector& a, const vector& b) { return magSqr(a) < magSqr(b); }
    );
    return found;
}


//- |mean of exp(i n theta)| over the n nearest
static scalar bondOrder(const std::vector<vector>& r, const label n)
{
    std::complex<scalar> sum(0);
    for (label k = 0; k < n; ++k)
    {
        sum += std::polar(scalar(1), n*std::atan2(r[k].y(), r[k].x()));
    }
    return std::abs(sum)/n;
}


//- The vector from r to halfway between neighbours near r and -r, zero if one
//- of them is missing by more than the tolerance
static vector latticeVector
(
    const std::vector<vector>& found,
    const vector& r,
    const scalar tolerance
)
{
    vector plus(vector::one*GREAT);
    vector minus(vector::one*GREAT);
    for (const vector& s : found)
    {
        plus = magSqr(s - r) < magSqr(plus - r) ? s : plus;
        minus = magSqr(s + r) < magSqr(minus + r) ? s : minus;
    }
    return
        mag(plus - r) < tolerance && mag(minus + r) < tolerance
      ? 0.5*(plus - minus)
      : vector::zero;
}


//- Longest over shortest of the three shortest lattice vectors, zero without
//- a lattice
static scalar diagonalRatio(const std::vector<vector>& found, const scalar dp)
{
    const scalar tolerance = 0.15*dp;

    const vector a(latticeVector(found, found[0], tolerance));
    vector b(Zero);
    for (const vector& r : found)
    {
        // Independent: at least 45 degrees apart
        if (mag(a ^ r) > 0.7*mag(a)*mag(r))
        {
            b = latticeVector(found, r, tolerance);
            break;
        }
    }
    const vector c
    (
        latticeVector(found, (a & b) > 0 ? a - b : a + b, tolerance)
    );

    const scalar shortest = min(mag(a), min(mag(b), mag(c)));
    return
        shortest > VSMALL ? max(mag(a), max(mag(b), mag(c)))/shortest : 0;
}


int main(int argc, char *argv[])
{
    argList::addNote("Tell the pattern of a 2-D particle mesh");
    argList::noParallel();

    #include "setRootCase.H"
    #include "createTime.H"

    const fvMesh mesh
    (
        IOobject
        (
            polyMesh::defaultRegion,
            runTime.timeName(),
            runTime,
            IOobject::MUST_READ
        )
    );
    const SPH::particleMesh particles(mesh);
    const pointField& points = particles.C();
    const scalar dp = particles.spacing()[0];

    List<vector> shifts(SPH::imageOffsets(SPH::periodicTranslations(mesh)));
    shifts.append(vector::zero);

    pointField walls;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (!pp.coupled() && !isA<emptyPolyPatch>(pp))
        {
            walls.append(pp.faceCentres());
        }
    }

    label n = 0;
    scalar psi4 = 0;
    scalar psi6 = 0;
    std::vector<scalar> ratios;
    forAll(points, i)
    {
        const auto nearWall = [&](const point& p)
        {
            return magSqr(p - points[i]) < sqr(4*dp);
        };
        if (std::any_of(walls.begin(), walls.end(), nearWall))
        {
            continue;
        }

        const std::vector<vector> found(neighbours(points, shifts, i, 2.5*dp));
        if (found.size() < 6)
        {
            continue;
        }
        ++n;
        psi4 += bondOrder(found, 4);
        psi6 += bondOrder(found, 6);
        const scalar ratio = diagonalRatio(found, dp);
        if (ratio > 0)
        {
            ratios.push_back(ratio);
        }
    }

    if (ratios.empty())
    {
        FatalErrorInFunction
            << "No particle has a regular neighbourhood" << exit(FatalError);
    }
    std::sort(ratios.begin(), ratios.end());
    const scalar ratio = ratios[ratios.size()/2];

    Info<< "pattern "
        << (ratio < 1.1 ? "hexagon" : ratio > 1.36 ? "square" : "parallelogram")
        << " ordered " << scalar(ratios.size())/n
        << " psi4 " << psi4/n
        << " psi6 " << psi6/n
        << " diagonals " << ratio
        << "\n\nEnd\n" << endl;

    return 0;
}


// ************************************************************************* //
