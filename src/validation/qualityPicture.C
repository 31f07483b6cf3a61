/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "qualityPicture.H"
#include "fieldPicture.H"
#include "meshSlice.H"
#include "polygonList.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::SPH::writeQualityPicture
(
    const fvMesh& mesh,
    const particleMesh& particles,
    const meshQuality& quality,
    const boundBox& view,
    const fileName& file
)
{
    const solutionSpace& space = particles.space();
    vector normal(Zero);
    normal[space.nDims() == 3 ? 2 : space.axis(2)] = 1;
    const meshSlice slice(mesh, view.midpoint(), normal);

    const point a(slice.toPlane(view.min()));
    const point b(slice.toPlane(view.max()));
    const boundBox box(min(a, b), max(a, b));

    const particleSurroundings& all = quality.surroundings();
    const scalarField gradientSum(quality.kernelGradientSum());

    polygonList shapes;
    DynamicList<scalar> values;
    forAll(gradientSum, i)
    {
        const scalar dp = all.spacing()[i];
        const point p(space.position(all.points()[i]));
        const point centre(slice.toPlane(p));
        if
        (
            (space.nDims() == 3 && mag(slice.distance(p)) > 0.5*dp)
         || !box.contains(centre)
        )
        {
            continue;
        }

        const bool solid = all.body()[i] > 0;
        shapes.add(solid ? 4 : 12, centre, 0.95*dp);
        values.append(Foam::log10(max(gradientSum[i], VSMALL)));
    }

    fieldPicture picture
    (
        "Particles of fluid (discs) and solids (squares)",
        box,
        slice.rightName() + " [m]",
        slice.upName() + " [m]",
        {{"log10 |sum V gradW| dp", -5, 0, colourMap::sequential}}
    );
    picture.add
    ({
        "", shapes.points(), shapes.polygons(), scalarField(values), 0, 0, false
    });
    picture.write(file);
}


// ************************************************************************* //
