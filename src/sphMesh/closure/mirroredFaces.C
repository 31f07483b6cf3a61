/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "mirroredFaces.H"
#include "cellGrid.H"
#include "kernelShapes.H"
#include "emptyFvPatch.H"

#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Elements per spacing: fine enough for the shares to be smooth
    static const scalar elementsPerSpacing = 4;

    //- Shares below this fraction of an element are not worth a face
    static const scalar smallestShare = 0.02;

    //- A small piece of an FVM face
    struct element
    {
        vector Sf;
        point centre;
    };

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
        std::vector<element>& elements
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
        std::vector<element>& elements
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

    //- All elements of one FVM face
    static void cutFace
    (
        const fvMesh& mesh,
        const solutionSpace& space,
        const label facei,
        const scalar spacing,
        std::vector<element>& elements
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

    //- The part of an FVM face that belongs to one particle
    struct part
    {
        label particle;
        vector Sf;
        scalar area;
        vector moment;
    };
}
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::SPH::boundaryFaces Foam::SPH::mirroredFaces
(
    const fvMesh& mesh,
    const solutionSpace& space,
    const kernel& W,
    const particleMeshData& data
)
{
    const label nParticles = data.points.size();
    const scalar finest = min(data.spacing);

    vectorField points(nParticles);
    forAll(points, i)
    {
        points[i] = space.toLocal(data.points[i]);
    }
    const cellGrid particles(points, W.support(finest));

    const auto nearestParticle = [&](const vector& p)
    {
        label best = -1;
        for (scalar R = W.support(finest); best < 0; R *= 2)
        {
            particles.forNear
            (
                p,
                R,
                [&](const label j)
                {
                    if
                    (
                        best < 0
                     || magSqr(points[j] - p) < magSqr(points[best] - p)
                    )
                    {
                        best = j;
                    }
                }
            );
        }
        return best;
    };

    // Elements of all faces, in the order of the patches
    std::vector<element> elements;
    DynamicList<label> faceStart;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (!pp.coupled() && !isA<emptyFvPatch>(mesh.boundary()[pp.index()]))
        {
            forAll(pp, facei)
            {
                faceStart.append(elements.size());
                const vector centre(space.toLocal(pp.faceCentres()[facei]));
                cutFace
                (
                    mesh,
                    space,
                    pp.start() + facei,
                    data.spacing[nearestParticle(centre)],
                    elements
                );
            }
        }
    }
    faceStart.append(elements.size());

    // Shares of the elements
    const label nElements = elements.size();
    vectorField centres(nElements);
    forAll(centres, e)
    {
        centres[e] = space.toLocal(elements[e].centre);
    }

    struct share
    {
        label particle;
        scalar weight;
    };
    std::vector<std::vector<share>> shares(nElements);

    const cellGrid grid(centres, W.support(finest));
    for (label i = 0; i < nParticles; ++i)
    {
        const scalar radius = W.support(data.spacing[i]);
        const vector& x = points[i];

        grid.forNear
        (
            x,
            radius,
            [&](const label e)
            {
                const vector r(centres[e] - x);
                if
                (
                    magSqr(r) < radius*radius
                 && (space.toGlobal(r) & elements[e].Sf) > 0
                )
                {
                    // Positive for every kernel, Laguerre-Gauss included
                    const scalar w = data.V[i]*WendlandC2Shape::w
                    (
                        WendlandC2Shape::cutOff*mag(r)/radius
                    );
                    shares[e].push_back({i, w});
                }
            }
        );
    }

    // Elements that no support reaches go to the nearest particle
    for (label e = 0; e < nElements; ++e)
    {
        if (shares[e].empty())
        {
            shares[e].push_back({nearestParticle(centres[e]), 1});
        }
    }

    // Parts of each face
    boundaryFaces boundary;
    DynamicList<label> owner, local;
    DynamicList<vector> Sf, Cf;
    DynamicList<scalar> distance;
    std::vector<part> parts;

    boundary.start = labelList(mesh.boundary().size() + 1, Zero);
    label counter = 0;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        const label patchi = pp.index();
        if (!pp.coupled() && !isA<emptyFvPatch>(mesh.boundary()[patchi]))
        {
            forAll(pp, facei)
            {
                parts.clear();
                for
                (
                    label e = faceStart[counter];
                    e < faceStart[counter + 1];
                    ++e
                )
                {
                    scalar largest = 0;
                    for (const share& s : shares[e])
                    {
                        largest = max(largest, s.weight);
                    }
                    scalar sum = 0;
                    for (const share& s : shares[e])
                    {
                        sum += s.weight > smallestShare*largest ? s.weight : 0;
                    }
                    for (const share& s : shares[e])
                    {
                        if (s.weight <= smallestShare*largest)
                        {
                            continue;
                        }
                        auto found = std::find_if
                        (
                            parts.begin(),
                            parts.end(),
                            [&](const part& p)
                            {
                                return p.particle == s.particle;
                            }
                        );
                        if (found == parts.end())
                        {
                            parts.push_back({s.particle, Zero, 0, Zero});
                            found = parts.end() - 1;
                        }
                        const vector S(s.weight/sum*elements[e].Sf);
                        found->Sf += S;
                        found->area += mag(S);
                        found->moment += mag(S)*elements[e].centre;
                    }
                }

                // Round-off of the sum goes to the largest part
                const vector& faceSf = mesh.faceAreas()[pp.start() + facei];
                vector sum(Zero);
                label largest = 0;
                for (label p = 0; p < label(parts.size()); ++p)
                {
                    sum += parts[p].Sf;
                    largest = parts[p].area > parts[largest].area ? p : largest;
                }
                parts[largest].Sf += faceSf - sum;

                for (const part& p : parts)
                {
                    const point centre(p.moment/p.area);
                    owner.append(p.particle);
                    Sf.append(p.Sf);
                    Cf.append(centre);
                    distance.append
                    (
                        max
                        (
                            (centre - data.points[p.particle]) & p.Sf/p.area,
                            0.05*data.spacing[p.particle]
                        )
                    );
                    local.append(facei);
                }
                ++counter;
            }
        }
        boundary.start[patchi + 1] = owner.size();
    }

    boundary.owner.transfer(owner);
    boundary.Sf.transfer(Sf);
    boundary.Cf.transfer(Cf);
    boundary.distance.transfer(distance);
    boundary.face.transfer(local);

    return boundary;
}


// ************************************************************************* //
