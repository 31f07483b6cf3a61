/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "staticSupport.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::SPH::staticSupport::outside
(
    const label bodyi,
    const UList<scalar>& phi,
    const scalar l
) const
{
    const scalar epsilon = 0.75*l;

    scalar fraction = heaviside(phi[bodyi], epsilon);

    if (bodyi == 0 && sharedInterfaces_)
    {
        // Both sides of an interface have complementary fractions, so that
        // their filled parts add up to one there
        for (label s = 1; s < phi.size(); ++s)
        {
            fraction += heaviside(phi[s], epsilon) - 1;
        }
    }

    return max(fraction, scalar(0));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::staticSupport::staticSupport
(
    const relaxationDomain& domain,
    const latticePattern& pattern,
    const bool sharedInterfaces
)
:
    domain_(domain),
    pattern_(pattern),
    sharedInterfaces_(sharedInterfaces)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::SPH::staticSupport::heaviside
(
    const scalar phi,
    const scalar epsilon
)
{
    using constant::mathematical::pi;

    const scalar s = phi/epsilon;

    return
        s <= -1 ? 0
      : s >= 1 ? 1
      : 0.5*(1 + s + sin(pi*s)/pi);
}


void Foam::SPH::staticSupport::addCell
(
    const vector& corner,
    const vector& edges,
    const scalar dp,
    particleStart& start
) const
{
    const label nDims = domain_.nDims();
    const vector centre(corner + 0.5*edges);

    scalar volume = 1;
    scalar shortest = GREAT;
    for (label d = 0; d < nDims; ++d)
    {
        volume *= edges[d];
        shortest = min(shortest, edges[d]);
    }

    // A surface on a face of the cell does not cut it
    const scalar cutTolerance = 1e-3*shortest;

    bool cut = false;
    scalarField phi(domain_.bodies.size());
    forAll(phi, bodyi)
    {
        phi[bodyi] = domain_.distance(bodyi, centre);

        if (mag(phi[bodyi]) < 0.5*shortest - cutTolerance)
        {
            cut = true;
        }
        else if (mag(phi[bodyi]) < mag(edges))
        {
            const vector inner(0.5*edges - cutTolerance*vector::one);
            for (label c = 0; c < (1 << nDims) && !cut; ++c)
            {
                vector p(centre);
                for (label d = 0; d < nDims; ++d)
                {
                    p[d] += (c >> d) & 1 ? inner[d] : -inner[d];
                }
                cut = domain_.distance(bodyi, p)*phi[bodyi] < 0;
            }
        }
    }

    const label nParts = !cut ? 1 : nDims == 1 ? 8 : nDims == 2 ? 4 : 3;
    const List<vector> whole(1, vector(0.5, 0.5, 0.5));
    const List<vector>& sites = cut ? whole : pattern_.sites();
    const scalar V = volume/(pow(scalar(nParts), nDims)*sites.size());

    label n[3] = {1, 1, 1};
    for (label d = 0; d < nDims; ++d)
    {
        n[d] = nParts;
    }

    DynamicList<vector> points;
    for (label k = 0; k < n[2]; ++k)
    {
        for (label j = 0; j < n[1]; ++j)
        {
            for (label i = 0; i < n[0]; ++i)
            {
                for (const vector& site : sites)
                {
                    vector p(corner);
                    const label part[3] = {i, j, k};
                    for (label d = 0; d < nDims; ++d)
                    {
                        p[d] += edges[d]*(part[d] + site[d])/n[d];
                    }
                    points.append(p);
                }
            }
        }
    }

    // Distances of the bodies at the points; those of the centre serve where
    // no surface cuts the cell
    List<scalarField> distances(points.size(), phi);
    for (label q = 0; q < points.size() && cut; ++q)
    {
        forAll(phi, bodyi)
        {
            if (mag(phi[bodyi]) < mag(edges))
            {
                distances[q][bodyi] = domain_.distance(bodyi, points[q]);
            }
        }
    }

    const scalar width = cut ? shortest/nParts : cutTolerance;
    forAll(phi, bodyi)
    {
        if (phi[bodyi] > domain_.support(bodyi, dp) + mag(edges))
        {
            continue;
        }

        forAll(points, q)
        {
            const scalar fraction = outside(bodyi, distances[q], width);

            if (fraction > SMALL)
            {
                start.addFixed(points[q], dp, fraction*V, bodyi);
            }
        }
    }
}


// ************************************************************************* //
