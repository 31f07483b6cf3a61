/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "areaVectorPicture.H"
#include "emptyPolyPatch.H"
#include "fieldPicture.H"
#include "meshSlice.H"
#include "polygonList.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
namespace
{
    //- Area vectors per thickness in the plane of the picture
    struct arrows
    {
        DynamicList<point> tails;
        DynamicList<vector> lengths;

        void add
        (
            const boundBox& box,
            const point& tail,
            const vector& length
        )
        {
            if (box.contains(tail))
            {
                tails.append(tail);
                lengths.append(length);
            }
        }
    };

    //- A shaft and a head for each arrow, with lengths times scale
    struct arrowShapes
    {
        polygonList polygons;
        DynamicList<scalar> values;

        arrowShapes(const arrows& a, const scalar scale)
        {
            const scalar shaft = 0.03;
            const scalar head = 0.12;

            forAll(a.tails, i)
            {
                const point& tail = a.tails[i];
                const vector along(scale*a.lengths[i]);
                const vector across(-along.y(), along.x(), 0);

                polygons.add
                (
                    List<point>
                    ({
                        tail - shaft*across,
                        tail + 0.7*along - shaft*across,
                        tail + 0.7*along + shaft*across,
                        tail + shaft*across
                    })
                );
                polygons.add
                (
                    List<point>
                    ({
                        tail + 0.7*along - head*across,
                        tail + along,
                        tail + 0.7*along + head*across
                    })
                );
                values.append(scalarList(2, mag(a.lengths[i])));
            }
        }
    };
}
}
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::SPH::writeAreaVectorPicture
(
    const fvMesh& mesh,
    const particleMesh& particles,
    const boundBox& view,
    const fileName& file
)
{
    const solutionSpace& space = particles.space();
    vector normal(Zero);
    normal[space.axis(2)] = 1;
    const meshSlice slice(mesh, view.midpoint(), normal);

    const point a(slice.toPlane(view.min()));
    const point b(slice.toPlane(view.max()));
    const boundBox box(min(a, b), max(a, b));
    const scalar rThickness = 1/space.thickness();

    arrows fvm;
    for (const fvPatch& patch : mesh.boundary())
    {
        if (!patch.coupled() && !isA<emptyPolyPatch>(patch.patch()))
        {
            forAll(patch, facei)
            {
                fvm.add
                (
                    box,
                    slice.toPlane(patch.Cf()[facei]),
                    rThickness*slice.toPlane(patch.Sf()[facei])
                );
            }
        }
    }

    arrows sph;
    const boundaryFaces& faces = particles.boundary().faces();
    forAll(faces.owner, facei)
    {
        sph.add
        (
            box,
            slice.toPlane(faces.Cf[facei]),
            rThickness*slice.toPlane(faces.Sf[facei])
        );
    }

    scalar longest = VSMALL;
    for (const arrows* each : {&fvm, &sph})
    {
        for (const vector& length : each->lengths)
        {
            longest = max(longest, mag(length));
        }
    }
    const scalar scale =
        0.12*min(box.span().x(), box.span().y())/longest;

    const arrowShapes left(fvm, scale);
    const arrowShapes right(sph, scale);
    fieldPicture picture
    (
        "Area vectors of the boundary over the thickness",
        box,
        slice.rightName() + " [m]",
        slice.upName() + " [m]",
        {{"|A| [m]", 0, longest, colourMap::sequential}}
    );
    const auto addPanel = [&](const std::string& title, const arrowShapes& a)
    {
        picture.add
        ({
            title, a.polygons.points(), a.polygons.polygons(),
            scalarField(a.values), 0, 0, false
        });
    };
    addPanel("FVM faces", left);
    addPanel("Particles", right);
    picture.write(file);
}


// ************************************************************************* //
