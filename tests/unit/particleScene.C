/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleScene.H"
#include "contactFaces.H"
#include "patchSurface.H"
#include "Random.H"
#include "StringStream.H"
#include "surfaceVectorClosure.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- The papers' kernel, which has the most pairs
    static dictionary kernelDict()
    {
        dictionary dict;
        dict.add("smoothingRatio", 1.3);
        return dict;
    }
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::particleScene::particleScene
(
    const testCase::layout& layout,
    const scalar dp,
    const scalar jitter
)
:
    case_(layout)
{
    const solutionSpace space(mesh());
    kernel_.reset(kernel::New(kernelDict(), space.nDims()).ptr());
    fluid_.reset
    (
        new surfaceDistance(patchSurface(mesh(), space), kernel_->support(dp))
    );

    const vector low(space.toLocal(layout.box.min()));
    const vector span(space.toLocal(layout.box.span()));
    labelVector n(1, 1, 1);
    for (direction d = 0; d < space.nDims(); ++d)
    {
        n[d] = round(span[d]/dp);
    }

    Random random(11);
    DynamicList<point> points;
    labelVector ijk;
    for (ijk.z() = 0; ijk.z() < n.z(); ++ijk.z())
    {
        for (ijk.y() = 0; ijk.y() < n.y(); ++ijk.y())
        {
            for (ijk.x() = 0; ijk.x() < n.x(); ++ijk.x())
            {
                vector x(Zero);
                for (direction d = 0; d < space.nDims(); ++d)
                {
                    const scalar move = random.sample01<scalar>() - 0.5;
                    x[d] = low[d] + (ijk[d] + 0.5 + jitter*move)*span[d]/n[d];
                }

                const point p(space.position(x));
                if (fluid_->inside(p) && fluid_->distance(p) < -0.2*dp)
                {
                    points.append(p);
                }
            }
        }
    }

    particles_.name = "fluid";
    particles_.points.transfer(points);
    particles_.spacing = scalarField(particles_.points.size(), dp);
}


std::unique_ptr<Foam::SPH::particleScene> Foam::SPH::particleScene::New
(
    const word& name,
    const scalar jitter
)
{
    testCase::layout layout;
    scalar dp = 0.05;

    if (name == "hole")
    {
        layout.nCells = labelVector(20, 20, 1);
        layout.hole = boundBox(point(0.3, 0.4, -1), point(0.6, 0.6, 1));
    }
    else if (name == "channel")
    {
        layout.periodic[0] = true;
    }
    else if (name == "periodic")
    {
        layout.periodic[0] = layout.periodic[1] = true;
    }
    else if (name == "line")
    {
        layout.nCells = labelVector(20, 1, 1);
        layout.patchTypes.set("bottom", "empty");
        layout.patchTypes.set("top", "empty");
    }
    else if (name == "cube" || name == "pipe")
    {
        layout.twoD = false;
        layout.periodic[0] = name == "pipe";
        layout.nCells = labelVector(4, 5, 6);
        layout.box = boundBox(point(-1, 2, 0), point(0, 3, 1));
        dp = 0.1;
    }

    return std::make_unique<particleScene>(layout, dp, jitter);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::SPH::sceneParticles::fvmFaces
(
    const particlePatch& patch
) const
{
    const label start = patch.patch().start() - mesh().nInternalFaces();

    return labelList
    (
        SubList<label>
        (
            sph_->particles().boundaryFace(), patch.patch().size(), start
        )
    );
}


std::unique_ptr<Foam::SPH::sceneParticles> Foam::SPH::particleScene::assemble
(
    const std::string& closureText,
    const UList<particleSet>& solids
)
{
    IStringStream is(closureText);
    const dictionary closureDict(is);
    const autoPtr<closure> method(closure::New(closureDict));

    dictionary properties;
    properties.add("digest", word("test"));
    properties.add("closure", closureDict);
    properties.add("kernel", kernelDict());

    const particleMeshData data
    (
        assembleParticleMesh
        (
            mesh(), *kernel_, particles_, *fluid_, *method
        )
    );
    boundaryFaces contact;
    if (method->type() == surfaceVectorClosure::typeName && solids.size())
    {
        contact = contactFaces
        (
            mesh(), solutionSpace(mesh()), *kernel_, data, solids, *fluid_
        );
    }

    auto sph = std::make_unique<particleCase>(mesh());
    const particleZone everywhere(mesh(), dictionary());
    sph->writeMesh(properties, everywhere, data, solids, contact);

    return std::make_unique<sceneParticles>(std::move(sph), data);
}

// ************************************************************************* //
