/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "mirroredFaces.H"
#include "borderPatch.H"
#include "boundaryElements.H"
#include "boundaryFaceList.H"
#include "cellGrid.H"
#include "kernelShapes.H"
#include "emptyPolyPatch.H"
#include "mathematicalConstants.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Shares below this fraction of an element's largest are not worth a face
    static const scalar smallestShare = 0.3;

    //- Parts of a border face below this fraction of it go to its other parts
    static const scalar smallestPart = 1e-3;

    //- Least distance of a particle to its boundary face over the spacing
    static const scalar smallestDistance = 0.05;

    //- A particle and its weight at an element
    struct share
    {
        label particle;
        scalar weight;
    };

    typedef std::vector<share> shareList;

    //- The part of an FVM face that belongs to one particle
    struct part
    {
        label particle;
        vector Sf;
        scalar area;
        vector moment;
    };

    //- Does a particle lie in front of an element, 0 to 1: beyond an edge of
    //- the body it is nearer to the plane of the element than to the surface
    static scalar facing(const scalar height, const scalar nearest)
    {
        constexpr scalar none = 0.75;
        constexpr scalar all = 0.9;
        const scalar part = (height/nearest - none)/(all - none);
        return min(max(part, scalar(0)), scalar(1));
    }

    //- Keep the large shares, sharpened towards the nearest particle: the
    //- nearer the centre of a face is to the foot of its particle, the less
    //- does a value differ between both
    static void sharpen(const boolList& sites, shareList& shares)
    {
        bool lattice = true;
        for (const share& s : shares)
        {
            lattice = lattice && sites[s.particle];
        }

        // Sites of a lattice at a wall have what is nearest to them
        const scalar smallest = lattice ? 0.99 : smallestShare;

        scalar largest = 0;
        for (share& s : shares)
        {
            s.weight = pow4(s.weight);
            largest = max(largest, s.weight);
        }
        shares.erase
        (
            std::remove_if
            (
                shares.begin(),
                shares.end(),
                [&](const share& s) { return s.weight <= smallest*largest; }
            ),
            shares.end()
        );

        scalar sum = 0;
        for (const share& s : shares)
        {
            sum += s.weight;
        }
        for (share& s : shares)
        {
            s.weight /= sum;
        }
    }

    static bool mirrored(const polyPatch& pp)
    {
        return !pp.coupled() && !isA<emptyPolyPatch>(pp);
    }

    //- Distance from an element, a disc of its area, whose centre lies at r
    //- and at a height along its normal
    static scalar discDistance
    (
        const solutionSpace& space,
        const scalar area,
        const vector& r,
        const scalar height
    )
    {
        const scalar a = area/space.thickness();
        const scalar radius =
            space.nDims() == 1 ? 0
          : space.nDims() == 2 ? 0.5*a
          : sqrt(a/constant::mathematical::pi);
        const scalar aside =
            sqrt(max(magSqr(r) - sqr(height), scalar(0))) - radius;

        return aside > 0 ? hypot(aside, height) : mag(height);
    }

    //- The particles that share each element
    static std::vector<shareList> elementShares
    (
        const solutionSpace& space,
        const kernel& W,
        const particleMeshData& data,
        const vectorField& points,
        const std::vector<boundaryElement>& elements
    )
    {
        vectorField centres(elements.size());
        forAll(centres, e)
        {
            centres[e] = space.toLocal(elements[e].centre);
        }

        std::vector<shareList> shares(elements.size());
        const cellGrid grid(centres, W.support(min(data.spacing)));
        DynamicList<label> near;
        const auto heightAt = [&](const vector& r, const label e)
        {
            return (space.toGlobal(r) & elements[e].Sf)/mag(elements[e].Sf);
        };

        forAll(points, i)
        {
            const scalar radius = W.support(data.spacing[i]);

            scalar nearest = radius;
            near.clear();
            grid.forNear
            (
                points[i],
                radius,
                [&](const label e)
                {
                    const vector r(centres[e] - points[i]);
                    nearest = min
                    (
                        nearest,
                        discDistance
                        (
                            space, mag(elements[e].Sf), r, heightAt(r, e)
                        )
                    );
                    near.append(e);
                }
            );

            for (const label e : near)
            {
                const vector r(centres[e] - points[i]);
                const scalar front =
                    facing(heightAt(r, e), max(nearest, VSMALL));

                if (front > 0 && magSqr(r) < radius*radius)
                {
                    // A positive shape, whatever the kernel is
                    const scalar q = WendlandC2Shape::cutOff*mag(r)/radius;
                    shares[e].push_back({i, front*WendlandC2Shape::w(q)});
                }
            }
        }

        for (shareList& s : shares)
        {
            sharpen(data.sites, s);
        }

        return shares;
    }

    //- Add an element's shares to the parts of its face
    static void addParts
    (
        const boundaryElement& element,
        const shareList& shares,
        std::vector<part>& parts
    )
    {
        for (const share& s : shares)
        {
            auto found = std::find_if
            (
                parts.begin(),
                parts.end(),
                [&](const part& p) { return p.particle == s.particle; }
            );
            if (found == parts.end())
            {
                found = parts.insert(found, {s.particle, Zero, 0, Zero});
            }

            const vector Sf(s.weight*element.Sf);
            found->Sf += Sf;
            found->area += mag(Sf);
            found->moment += mag(Sf)*element.centre;
        }
    }

    //- Give the parts with less than a share of the area to their neighbours
    static void mergeSlivers
    (
        const scalar leastArea,
        std::vector<part>& parts
    )
    {
        const auto smaller =
            [](const part& a, const part& b) { return a.area < b.area; };

        while (parts.size() > 1)
        {
            const auto sliver =
                std::min_element(parts.begin(), parts.end(), smaller);
            if (sliver->area >= leastArea)
            {
                break;
            }
            const part lost(*sliver);
            parts.erase(sliver);

            const point centre(lost.moment/lost.area);
            part& next = *std::min_element
            (
                parts.begin(),
                parts.end(),
                [&](const part& a, const part& b)
                {
                    return
                        magSqr(a.moment/a.area - centre)
                      < magSqr(b.moment/b.area - centre);
                }
            );
            next.Sf += lost.Sf;
            next.area += lost.area;
            next.moment += lost.moment;
        }
    }

    //- Parts along the area vector of their face, in its plane, with its first
    //- moment: all of the face that the cell beyond the border knows
    static void fitToFace
    (
        const vector& Sf,
        const point& Cf,
        std::vector<part>& parts
    )
    {
        const scalar area = mag(Sf);
        const vector n(Sf/area);

        point mean(Zero);
        for (part& p : parts)
        {
            const vector r(p.moment/p.area - Cf);
            p.area = p.Sf & n;
            p.Sf = p.area*n;
            p.moment = Cf + r - (r & n)*n;
            mean += p.area/area*p.moment;
        }
        for (part& p : parts)
        {
            p.moment = p.area*(p.moment + Cf - mean);
        }
    }
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
    vectorField points(data.points.size());
    forAll(points, i)
    {
        points[i] = space.toLocal(data.points[i]);
    }
    const scalar finest = W.support(min(data.spacing));
    const cellGrid particles(points, finest);

    // Elements of all faces, in the order of the patches
    std::vector<boundaryElement> elements;
    DynamicList<label> start;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (mirrored(pp))
        {
            forAll(pp, facei)
            {
                const vector centre(space.toLocal(pp.faceCentres()[facei]));
                const label nearest =
                    particles.nearest(points, centre, finest);

                start.append(elements.size());
                cutFace
                (
                    mesh,
                    space,
                    pp.start() + facei,
                    data.spacing[nearest],
                    elements
                );
            }
        }
    }
    start.append(elements.size());

    std::vector<shareList> shares
    (
        elementShares(space, W, data, points, elements)
    );
    for (label e = 0; e < label(elements.size()); ++e)
    {
        if (shares[e].empty())
        {
            const vector centre(space.toLocal(elements[e].centre));
            shares[e].push_back
            ({
                particles.nearest(points, centre, finest), 1
            });
        }
    }

    boundaryFaceList faces;
    label counter = 0;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        const label nFaces = mirrored(pp) ? pp.size() : 0;
        for (label facei = 0; facei < nFaces; ++facei, ++counter)
        {
            std::vector<part> parts;
            for (label e = start[counter]; e < start[counter + 1]; ++e)
            {
                addParts(elements[e], shares[e], parts);
            }

            const vector& faceArea = mesh.faceAreas()[pp.start() + facei];
            if (isBorder(pp))
            {
                mergeSlivers(smallestPart*mag(faceArea), parts);
                fitToFace(faceArea, pp.faceCentres()[facei], parts);
            }

            // Round-off of the sum goes to the largest part
            vector missing(faceArea);
            auto largest = parts.begin();
            for (auto p = parts.begin(); p != parts.end(); ++p)
            {
                missing -= p->Sf;
                largest = p->area > largest->area ? p : largest;
            }
            largest->Sf += missing;

            for (const part& p : parts)
            {
                const point centre(p.moment/p.area);
                const vector r(centre - data.points[p.particle]);

                faces.append
                (
                    p.particle,
                    p.Sf,
                    centre,
                    max
                    (
                        (r & p.Sf)/p.area,
                        smallestDistance*data.spacing[p.particle]
                    ),
                    facei
                );
            }
        }
        faces.endPatch();
    }

    return faces.faces();
}


// ************************************************************************* //
