/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "comparisonReport.H"

#include <cstdio>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    static std::string number(const scalar value)
    {
        char text[32];
        std::snprintf(text, sizeof(text), "%.4g", value);
        return text;
    }

    static std::string percent(const scalar value)
    {
        char text[32];
        std::snprintf(text, sizeof(text), "%.3g %%", 100*value);
        return text;
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::comparisonReport::addCase
(
    const fvMesh& mesh,
    const referenceCase& reference
)
{
    page_.heading("Case");
    page_.paragraph
    (
        mesh.time().globalCaseName() + ", " + std::to_string(mesh.nCells())
      + " cells, " + std::to_string(mesh.nGeometricD()) + "-D. "
      + (
            reference.path() == mesh.time().path()
          ? std::string("The FVM reference is the same case.")
          : "The FVM reference is " + reference.path() + "."
        )
    );

    std::vector<htmlReport::row> rows;
    for (const fvPatch& patch : mesh.boundary())
    {
        rows.push_back
        (
            {
                patch.name(), patch.type(),
                std::to_string(patch.patch().size())
            }
        );
    }
    page_.table({"Patch", "Type", "Faces"}, rows, 2);
}


void Foam::SPH::comparisonReport::addParticles
(
    const particleResults& particles
)
{
    page_.heading("Particles");
    page_.paragraph
    (
        std::to_string(particles.mesh().nCells()) + " particles, "
      + std::to_string(particles.mesh().nInternalFaces()) + " pairs."
    );
}


void Foam::SPH::comparisonReport::addTimes(const commonFields& common)
{
    page_.heading("Times");
    page_.table
    (
        {"Fields of", "At times"},
        {
            {"both methods", commonFields::names(common.times())},
            {"FVM only", commonFields::names(common.fvmOnly())},
            {"SPH only", commonFields::names(common.sphOnly())}
        },
        2
    );
}


void Foam::SPH::comparisonReport::addNorms(const fieldComparison& comparison)
{
    page_.heading("Norms of SPH - FVM");

    // The three norms of a component follow each other
    std::vector<htmlReport::row> rows;
    for (const fieldNorms::norm& n : comparison.norms().norms())
    {
        if (n.name == "L1")
        {
            rows.push_back({n.field, n.component, number(n.range)});
        }
        rows.back().push_back(number(n.absolute));
        rows.back().push_back(percent(n.relative));
    }

    page_.table
    (
        {
            "Field", "Component", "FVM range",
            "L1", "relative", "L2", "relative", "Linf", "relative"
        },
        rows,
        2
    );
    page_.paragraph
    (
        "Volume-weighted over the cells of the mesh; relative to the range"
        " of the FVM field."
    );

    for (const std::string& remark : comparison.remarks())
    {
        page_.paragraph(remark);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::comparisonReport::comparisonReport
(
    const fvMesh& mesh,
    const particleResults* particles,
    const referenceCase& reference,
    const commonFields& common,
    const fieldComparison& comparison,
    const UList<fileName>& pictures,
    const std::vector<std::string>& plots
)
:
    page_
    (
        "SPH and FVM: " + mesh.time().globalCaseName() + " at t = "
      + mesh.time().timeName() + " s"
    )
{
    addNorms(comparison);

    if (pictures.size())
    {
        page_.heading("Fields");
    }
    for (const fileName& picture : pictures)
    {
        page_.picture(picture, picture.nameLessExt());
    }

    page_.heading("Profiles");
    page_.drawings(plots);

    addCase(mesh, reference);
    if (particles)
    {
        addParticles(*particles);
    }
    addTimes(common);
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

void Foam::SPH::comparisonReport::print(const fieldComparison& comparison)
{
    char line[128];
    std::snprintf
    (
        line, sizeof(line), "    %-12s %-10s %-5s %12s %12s",
        "field", "component", "norm", "absolute", "relative"
    );
    Info<< line << nl;

    for (const fieldNorms::norm& n : comparison.norms().norms())
    {
        std::snprintf
        (
            line, sizeof(line), "    %-12s %-10s %-5s %12.4e %12s",
            n.field.c_str(), n.component.c_str(), n.name.c_str(), n.absolute,
            percent(n.relative).c_str()
        );
        Info<< line << nl;
    }

    for (const std::string& remark : comparison.remarks())
    {
        Info<< "    " << remark.c_str() << nl;
    }
}


// ************************************************************************* //
