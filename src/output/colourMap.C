/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "colourMap.H"

#include <cmath>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::SPH::colourMap::operator()(const scalar value) const
{
    // Equidistant colours, linear in between
    static const vector dark[] =
    {
        {0.13, 0.05, 0.32}, {0.20, 0.17, 0.52}, {0.18, 0.34, 0.62},
        {0.13, 0.50, 0.62}, {0.16, 0.64, 0.55}, {0.42, 0.76, 0.39},
        {0.75, 0.83, 0.25}, {0.99, 0.91, 0.36}
    };
    static const vector blueRed[] =
    {
        {0.10, 0.22, 0.50}, {0.20, 0.45, 0.72}, {0.52, 0.72, 0.87},
        {0.96, 0.96, 0.96}, {0.95, 0.69, 0.56}, {0.80, 0.33, 0.28},
        {0.50, 0.06, 0.15}
    };

    const vector* colours = type_ == sequential ? dark : blueRed;
    const label n = type_ == sequential ? 8 : 7;

    const scalar x = max(scalar(0), min(scalar(1), value))*(n - 1);
    const label i = min(label(std::floor(x)), n - 2);

    return colours[i] + (x - i)*(colours[i + 1] - colours[i]);
}

// ************************************************************************* //
