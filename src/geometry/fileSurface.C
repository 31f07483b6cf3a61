/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "fileSurface.H"
#include "surfaceRepair.H"
#include "surfaceDistance.H"
#include "PtrList.H"
#include "triSurface.H"
#include "EdgeMap.H"
#include "mergePoints.H"
#include "OSspecific.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::SPH::orientedSurface Foam::SPH::fileSurface::convert
(
    const triSurface& triangles,
    const solutionSpace& space
)
{
    const pointField& triPoints = triangles.points();

    DynamicList<point> points;
    DynamicList<element> elements(triangles.size());

    if (space.nDims() == 3)
    {
        for (const labelledTri& t : triangles)
        {
            if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
            {
                elements.append(element(t[0], t[1], t[2]));
            }
        }

        return orientedSurface
        (
            space,
            pointField(triPoints),
            List<element>(std::move(elements))
        );
    }

    const direction dz = space.axis(2);
    const scalar zMid = space.position(Zero)[dz];
    EdgeMap<label> vertexOfEdge;

    for (const labelledTri& t : triangles)
    {
        DynamicList<label> cut(2);

        for (label k = 0; k < 3; ++k)
        {
            // In ascending order, so that both triangles of an edge agree
            const label next = t[t.fcIndex(k)];
            const edge e(min(t[k], next), max(t[k], next));
            const point& a = triPoints[e.start()];
            const point& b = triPoints[e.end()];

            // A vertex on the plane counts as above it
            if ((a[dz] < zMid) != (b[dz] < zMid))
            {
                if (vertexOfEdge.insert(e, points.size()))
                {
                    const scalar s = (zMid - a[dz])/(b[dz] - a[dz]);
                    points.append
                    (
                        space.position(space.toLocal(a + s*(b - a)))
                    );
                }
                cut.append(vertexOfEdge[e]);
            }
        }

        if (cut.size() == 2)
        {
            const vector n(space.toLocal(t.areaNormal(triPoints)));
            const vector s(space.toLocal(points[cut[1]] - points[cut[0]]));

            if (s.y()*n.x() - s.x()*n.y() < 0)
            {
                std::swap(cut[0], cut[1]);
            }
            elements.append(element(cut[0], cut[1]));
        }
    }

    // Edges that meet in the plane leave segments of no length
    const scalar span = mag(boundBox(points, false).span());
    labelList unique;
    pointField merged(mergePoints(points, 1e-9*span, false, unique));
    UIndirectList<point>(merged, unique) = points;

    DynamicList<element> segments(elements.size());
    for (const element& e : elements)
    {
        const element s(unique[e.vertices[0]], unique[e.vertices[1]]);
        if (s.vertices[0] != s.vertices[1])
        {
            segments.append(s);
        }
    }

    return orientedSurface
    (
        space,
        std::move(merged),
        List<element>(std::move(segments))
    );
}


Foam::triSurface Foam::SPH::fileSurface::readTriangles
(
    const dictionary& dict,
    const fileName& file,
    const scalar scale
)
{
    // OpenFOAM's readers do not name the file
    std::string reason("it has no triangles");
    const bool throwing = FatalError.throwExceptions();
    const bool throwingIO = FatalIOError.throwExceptions();
    triSurface triangles;
    try
    {
        triangles = triSurface(file, scale);
    }
    catch (const error& e)
    {
        reason = e.message();
    }
    FatalError.throwExceptions(throwing);
    FatalIOError.throwExceptions(throwingIO);

    if (triangles.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Surface " << file << " cannot be read: " << reason.c_str()
            << exit(FatalIOError);
    }
    return triangles;
}


Foam::SPH::orientedSurface Foam::SPH::fileSurface::read
(
    const Time& time,
    const solutionSpace& space,
    const dictionary& dict
)
{
    const fileName name(dict.get<fileName>("surface"));
    const scalar scale(dict.getOrDefault<scalar>("scale", 1));
    const scalar maxHoleSize(dict.getOrDefault<scalar>("maxHoleSize", 0.1));
    const fileName directory(time.globalPath()/time.constant()/"triSurface");
    const fileName file(directory/name);

    if (!isFile(file))
    {
        FatalIOErrorInFunction(dict)
            << "There is no surface " << name << " in " << directory
            << ". Valid surfaces: " << readDir(directory) << exit(FatalIOError);
    }

    if (space.nDims() == 1)
    {
        FatalIOErrorInFunction(dict)
            << "Body " << dict.dictName() << ", surface " << name
            << ": a one-dimensional case cannot have bodies read from files."
            << " Valid: the entry patches instead" << exit(FatalIOError);
    }

    triSurface triangles(readTriangles(dict, file, scale));

    const direction dz = space.axis(2);
    const scalar zMid = space.position(Zero)[dz];
    const boundBox box(triangles.localPoints(), false);
    if
    (
        space.nDims() == 2
     && (box.min()[dz] > zMid || box.max()[dz] < zMid)
    )
    {
        FatalIOErrorInFunction(dict)
            << "Surface " << file << ", of bounding box " << box
            << ", does not cross the mid-plane of this 2-D case, "
            << vector::componentNames[dz] << " = " << zMid << " m"
            << exit(FatalIOError);
    }

    const auto valid = [](const orientedSurface& s)
    {
        return s.size() && s.openElements().empty() && mag(s.volume()) > VSMALL;
    };

    orientedSurface surface(convert(triangles, space));

    if (!valid(surface))
    {
        const string repairs(repairSurface(triangles, maxHoleSize));
        Info<< "Surface " << name << " was repaired: " << repairs.c_str()
            << endl;
        surface = convert(triangles, space);
    }

    if (!valid(surface))
    {
        const labelList open(surface.openElements());

        FatalIOErrorInFunction(dict)
            << "Surface " << file << " is not a closed surface"
            << (space.nDims() == 2 ? " where the mid-plane cuts it" : "")
            << " and could not be repaired: " << open.size() << " of "
            << surface.size() << " elements are open. Holes up to maxHoleSize "
            << maxHoleSize << " times the size of the surface are filled";

        if (open.size())
        {
            FatalIOError << ". One is at " << surface.centre(open[0]);
        }
        FatalIOError << exit(FatalIOError);
    }

    return orient(surface.subset(identity(surface.size())));
}


Foam::SPH::orientedSurface Foam::SPH::fileSurface::orient
(
    const orientedSurface& surface
)
{
    label nParts;
    const labelList part(surface.parts(nParts));

    List<DynamicList<label>> partElements(nParts);
    forAll(part, elementi)
    {
        partElements[part[elementi]].append(elementi);
    }

    // Every part by itself, outward
    PtrList<orientedSurface> parts(nParts);
    boolList reverse(nParts);
    forAll(parts, parti)
    {
        reverse[parti] = surface.subset(partElements[parti]).volume() < 0;
        parts.set
        (
            parti,
            new orientedSurface
            (
                surface.subset(partElements[parti], reverse[parti])
            )
        );
    }

    // A part within an odd number of others bounds a cavity
    forAll(parts, parti)
    {
        autoPtr<surfaceDistance> distance;

        forAll(parts, otheri)
        {
            const boundBox other(parts[otheri].bounds());

            if (otheri == parti || !parts[parti].bounds().contains(other))
            {
                continue;
            }

            if (!distance.valid())
            {
                distance.reset(new surfaceDistance(parts[parti]));
            }

            if (distance->distance(parts[otheri].points()[0]) < 0)
            {
                reverse[otheri] = !reverse[otheri];
            }
        }
    }

    List<element> elements(surface.elements());
    label nReversed = 0;
    forAll(elements, elementi)
    {
        if (reverse[part[elementi]])
        {
            FixedList<label, 3>& v = elements[elementi].vertices;
            std::swap(v[0], v[1]);
            ++nReversed;
        }
    }

    if (nReversed)
    {
        Info<< "    " << nReversed << " of " << surface.size()
            << " elements turned to point out of the solid" << endl;
    }

    return orientedSurface
    (
        surface.space(),
        pointField(surface.points()),
        std::move(elements)
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::fileSurface::fileSurface
(
    const Time& time,
    const solutionSpace& space,
    const dictionary& dict
)
:
    orientedSurface(read(time, space, dict))
{}


// ************************************************************************* //
