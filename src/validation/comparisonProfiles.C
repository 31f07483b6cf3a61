/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "comparisonProfiles.H"
#include "linePlot.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "unitText.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::comparisonProfiles::comparisonProfiles
(
    const fvMesh& mesh,
    const solutionSpace& space,
    const comparisonControls& controls
)
:
    lines_()
{
    const dictionary lines(controls.lines());

    if (lines.empty())
    {
        lines_ = lineProfile::centreLines(mesh, space);
    }
    for (const entry& e : lines)
    {
        lines_.append(new lineProfile(e.keyword(), mesh, space, e.dict()));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::vector<std::string> Foam::SPH::comparisonProfiles::write
(
    const fieldComparison& comparison,
    const fileName& folder
) const
{
    std::vector<std::string> plots;

    mkDir(folder);
    for (const lineProfile& line : lines_)
    {
        std::string header("coordinate,x,y,z");
        DynamicList<scalarField> columns;

        for (const comparedQuantity& quantity : comparison.quantities())
        {
            if (!quantity.profiled)
            {
                continue;
            }

            const scalarField fvm(line.sample(quantity.fvm));
            const scalarField sph(line.sample(quantity.sph));

            header += "," + quantity.name + "_FVM," + quantity.name + "_SPH";
            columns.append(fvm);
            columns.append(sph);

            linePlot plot
            (
                quantity.label + " along " + line.name(),
                line.coordinateName() + " [m]",
                quantity.label
              + " [" + unitText(quantity.fvm.dimensions()) + "]",
                1.5*line.step()
            );
            plot.add
            (
                {
                    "FVM", line.coordinate(), fvm,
                    "stroke=\"#8fb4dc\" stroke-width=\"5\""
                }
            );
            plot.add
            (
                {
                    "SPH", line.coordinate(), sph,
                    "stroke=\"#a3162a\" stroke-width=\"1.6\""
                }
            );
            plots.push_back(plot.svg());
        }

        OFstream os(folder/line.name() + ".csv");
        os.precision(8);
        os  << header.c_str() << nl;
        forAll(line.points(), i)
        {
            const point& p = line.points()[i];
            os  << line.coordinate()[i] << ',' << p.x() << ',' << p.y() << ','
                << p.z();
            for (const scalarField& column : columns)
            {
                os  << ',' << column[i];
            }
            os  << nl;
        }
    }

    return plots;
}

// ************************************************************************* //
