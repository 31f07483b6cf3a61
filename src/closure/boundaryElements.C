/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "boundaryElements.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Elements per spacing: fine enough for the shares to be smooth
    static const scalar elementsPerSpacing = 4;

    static label nCuts(const scalar length, const scalar spacing)
    {
        return max(label(ceil(elementsPerSpacing*length/spacing)), label(1));
    }

    //- Elements of an edge of a 2-D case, which carries the share of Sf
    static void cutEdge
    (
        const point& a,
        const point& b,
        const vector& Sf,
        const scalar spacing,
        std::vector<boundaryElement>& elements
    )
    {
        const label n = nCuts(mag(b - a), spacing);
        for (label k = 0; k < n; ++k)
        {
            elements.push_back({Sf/n, a + (k + 0.5)/n*(b - a)});
        }
    }

    //- Elements of a triangle: n^2 similar ones
    static void cutTriangle
    (
        const point& a,
        const point& b,
        const point& c,
        const scalar spacing,
        std::vector<boundaryElement>& elements
    )
    {
        const label n =
            nCuts(max(mag(b - a), max(mag(c - b), mag(a - c))), spacing);
        const vector Sf(0.5*((b - a) ^ (c - a))/(n*n));
        const vector u((b - a)/n);
        const vector v((c - a)/n);

        for (label i = 0; i < n; ++i)
        {
            for (label j = 0; i + j < n; ++j)
            {
                elements.push_back
                ({
                    Sf, a + (i + 1.0/3)*u + (j + 1.0/3)*v
                });
                if (i + j + 1 < n)
                {
                    elements.push_back
                    ({
                        Sf, a + (i + 2.0/3)*u + (j + 2.0/3)*v
                    });
                }
            }
        }
    }
}
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::SPH::cutFace
(
    const polyMesh& mesh,
    const solutionSpace& space,
    const label facei,
    const scalar spacing,
    std::vector<boundaryElement>& elements
)
{
    const face& f = mesh.faces()[facei];
    const pointField& points = mesh.points();
    const vector& Sf = mesh.faceAreas()[facei];
    const point& Cf = mesh.faceCentres()[facei];

    if (space.nDims() == 1)
    {
        elements.push_back({Sf, Cf});
    }
    else if (space.nDims() == 2)
    {
        // The edges on one side of the mid-plane are the face seen in 2-D
        const direction normal = space.axis(2);
        scalar length = 0;
        for (const edge& e : f.edges())
        {
            if (max(points[e[0]][normal], points[e[1]][normal]) < Cf[normal])
            {
                length += e.mag(points);
            }
        }
        for (const edge& e : f.edges())
        {
            point a(points[e[0]]);
            point b(points[e[1]]);
            if (max(a[normal], b[normal]) < Cf[normal])
            {
                a[normal] = b[normal] = Cf[normal];
                cutEdge(a, b, Sf*(mag(b - a)/length), spacing, elements);
            }
        }
    }
    else if (f.size() == 3)
    {
        cutTriangle
        (
            points[f[0]], points[f[1]], points[f[2]], spacing, elements
        );
    }
    else
    {
        const point centre(f.average(points, points));
        forAll(f, fp)
        {
            cutTriangle
            (
                points[f[fp]],
                points[f.nextLabel(fp)],
                centre,
                spacing,
                elements
            );
        }
    }
}


// ************************************************************************* //
