/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "unitText.H"

#include <cmath>
#include <cstdio>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::string Foam::SPH::unitText(const dimensionSet& dimensions)
{
    if (dimensions == dimPressure)
    {
        return "Pa";
    }

    static const char* const units[] = {"kg", "m", "s", "K", "mol", "A", "cd"};

    std::string over;
    std::string under;
    label nUnder = 0;

    for (int d = 0; d < dimensionSet::nDimensions; ++d)
    {
        const scalar power =
            std::abs(dimensions[dimensionSet::dimensionType(d)]);
        if (power < dimensionSet::smallExponent)
        {
            continue;
        }

        std::string unit(units[d]);
        if (std::abs(power - 2) < dimensionSet::smallExponent)
        {
            unit += "\u00b2";
        }
        else if (std::abs(power - 3) < dimensionSet::smallExponent)
        {
            unit += "\u00b3";
        }
        else if (std::abs(power - 1) > dimensionSet::smallExponent)
        {
            char exponent[32];
            std::snprintf(exponent, sizeof(exponent), "^%g", double(power));
            unit += exponent;
        }

        const bool isUnder = dimensions[dimensionSet::dimensionType(d)] < 0;
        std::string& side = isUnder ? under : over;
        side += (side.empty() ? "" : " ") + unit;
        nUnder += isUnder;
    }

    if (nUnder)
    {
        return
            (over.empty() ? "1" : over)
          + "/" + (nUnder > 1 ? "(" + under + ")" : under);
    }

    return over.empty() ? "-" : over;
}

// ************************************************************************* //
