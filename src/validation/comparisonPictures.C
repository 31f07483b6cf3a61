/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "comparisonPictures.H"
#include "particleDiscs.H"
#include "unitText.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Widen lowest and highest by the values whose points are in the box
    static void addRange
    (
        const pointField& points,
        const scalarField& values,
        const boundBox& box,
        scalar& lowest,
        scalar& highest
    )
    {
        forAll(points, i)
        {
            const point& p = points[i];
            if
            (
                p.x() >= box.min().x() && p.x() <= box.max().x()
             && p.y() >= box.min().y() && p.y() <= box.max().y()
            )
            {
                lowest = min(lowest, values[i]);
                highest = max(highest, values[i]);
            }
        }
    }

    static std::string axisLabel(const word& name)
    {
        return name + " [m]";
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::comparisonPictures::addView
(
    const word& name,
    const point& origin,
    const vector& normal,
    const dictionary& dict
)
{
    if (mag(normal) < VSMALL)
    {
        FatalIOErrorInFunction(dict)
            << "Entry normal of view " << name << " is " << normal
            << ". Valid choices: a vector that is not zero"
            << exit(FatalIOError);
    }

    views_.append(new view{name, meshSlice(mesh_, origin, normal), boundBox()});
    view& v = views_.last();

    if (v.slice.polygons().empty())
    {
        FatalIOErrorInFunction(dict)
            << "The plane of view " << name << ", origin " << origin
            << " and normal " << normal << ", does not cut the mesh, whose"
            << " bounds are " << mesh_.bounds() << exit(FatalIOError);
    }

    v.box = v.slice.bounds();
    if (dict.found("min") || dict.found("max"))
    {
        const point a(v.slice.toPlane(dict.get<point>("min")));
        const point b(v.slice.toPlane(dict.get<point>("max")));
        const boundBox box(min(a, b), max(a, b));

        if (!v.box.overlaps(box) || box.span().x()*box.span().y() < VSMALL)
        {
            FatalIOErrorInFunction(dict)
                << "Entries min and max of view " << name << " give the"
                << " rectangle " << box << ", which is empty or outside the"
                << " mesh in that plane " << v.box << exit(FatalIOError);
        }
        v.box = box;
    }
}


Foam::SPH::fieldPicture Foam::SPH::comparisonPictures::emptyPicture
(
    const view& v,
    const std::string& label,
    const std::vector<fieldPicture::colourScale>& scales
) const
{
    return fieldPicture
    (
        label + "  at  t = " + mesh_.time().timeName() + " s",
        v.box,
        axisLabel(v.slice.rightName()),
        axisLabel(v.slice.upName()),
        scales
    );
}


void Foam::SPH::comparisonPictures::writePanels
(
    const comparedQuantity& quantity,
    const view& v,
    const particleDiscs* discs,
    const fileName& folder,
    DynamicList<fileName>& files
) const
{
    const meshSlice& slice = v.slice;
    const scalarField fvm(slice.interpolate(quantity.fvm));
    const scalarField sph(slice.interpolate(quantity.sph));
    const scalarField difference(slice.interpolate(quantity.difference));

    scalar lowest = GREAT;
    scalar highest = -GREAT;
    addRange(slice.points(), fvm, v.box, lowest, highest);
    addRange(slice.points(), sph, v.box, lowest, highest);
    controls_.limit(quantity.name, lowest, highest);

    scalar below = 0;
    scalar above = 0;
    addRange(slice.points(), difference, v.box, below, above);
    const bool isSigned = quantity.label == quantity.name;
    above = max(above, -below);

    const std::string unit(" [" + unitText(quantity.fvm.dimensions()) + "]");
    const std::vector<fieldPicture::colourScale> scales
    {
        {quantity.label + unit, lowest, highest, colourMap::sequential},
        {
            (isSigned ? "SPH - FVM" : "|SPH - FVM|") + unit,
            isSigned ? -above : 0,
            above,
            isSigned ? colourMap::diverging : colourMap::sequential
        }
    };

    const auto addPanel = [&]
    (
        fieldPicture& picture,
        const std::string& title,
        const scalarField& values,
        const label scale
    )
    {
        picture.add
        (
            {
                title, slice.points(), slice.polygons(), values, scale,
                scale == 0 ? controls_.nContours() : 0, true
            }
        );
    };

    const std::string suffix(v.name.empty() ? "" : "_" + v.name);

    fieldPicture picture(emptyPicture(v, quantity.label, scales));
    addPanel(picture, "FVM", fvm, 0);
    addPanel(picture, "SPH", sph, 0);
    addPanel(picture, "Difference", difference, 1);
    files.append(folder/quantity.name + suffix + ".png");
    picture.write(files.last());

    const scalarField discValues
    (
        discs && quantity.name == quantity.field
      ? discs->values(quantity.field, instant(mesh_.time().value()))
      : scalarField()
    );
    if (discValues.size())
    {
        fieldPicture particles(emptyPicture(v, quantity.label, scales));
        addPanel(particles, "FVM", fvm, 0);
        particles.add
        (
            {
                "SPH particles", discs->points(), discs->polygons(),
                discValues, 0, 0, false
            }
        );
        files.append(folder/quantity.name + suffix + "_particles.png");
        particles.write(files.last());
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::comparisonPictures::comparisonPictures
(
    const fvMesh& mesh,
    const solutionSpace& space,
    const comparisonControls& controls,
    const particleResults* particles
)
:
    mesh_(mesh),
    controls_(controls),
    particles_(particles),
    views_()
{
    const auto normal = [](const direction d)
    {
        vector n(Zero);
        n[d] = 1;
        return n;
    };
    const point middle(mesh.bounds().midpoint());

    // A 1-D case is seen in the plane of its direction and another one
    const vector defaultNormal(normal(space.nDims() == 3 ? 2 : space.axis(2)));
    const dictionary views(controls.views());

    for (const entry& e : views)
    {
        const dictionary& dict = e.dict();
        const bool free = space.nDims() == 3;
        addView
        (
            e.keyword(),
            free ? dict.getOrDefault("origin", middle) : middle,
            free ? dict.getOrDefault("normal", defaultNormal) : defaultNormal,
            dict
        );
    }

    if (views.empty() && space.nDims() == 3)
    {
        for (direction d = 0; d < 3; ++d)
        {
            addView
            (
                word("normal") + char('X' + d), middle, normal(d), views
            );
        }
    }
    else if (views.empty())
    {
        addView(word::null, middle, defaultNormal, views);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::DynamicList<Foam::fileName> Foam::SPH::comparisonPictures::write
(
    const fieldComparison& comparison,
    const fileName& folder
) const
{
    DynamicList<fileName> files;

    for (const view& v : views_)
    {
        autoPtr<particleDiscs> discs;
        if (controls_.particles() && particles_)
        {
            discs.reset(new particleDiscs(*particles_, v.slice, v.box));
        }

        for (const comparedQuantity& quantity : comparison.quantities())
        {
            if (quantity.pictured || controls_.components())
            {
                writePanels(quantity, v, discs.get(), folder, files);
            }
        }
    }

    return files;
}

// ************************************************************************* //
