/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    Lattices against the analytic values of [A] and against their definition.

\*---------------------------------------------------------------------------*/

#include "kernel.H"
#include "latticePattern.H"
#include "staticSupport.H"
#include "mathematicalConstants.H"

#include <gtest/gtest.h>

using namespace Foam;
using SPH::kernel;
using SPH::latticePattern;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A row of [A] Table 2: cut-off radius over the spacing and characteristic
//- volumes of the hexagonal and the square lattice
struct tableRow
{
    scalar cutOff;
    scalar hexagon;
    scalar square;
};

const tableRow table2[] =
{
    {1.5, 0.878, 0.8548},
    {1.55, 0.8982, 0.8779},
    {1.6, 0.9138, 0.8975},
    {1.65, 0.9257, 0.9137},
    {1.7, 0.9346, 0.9269},
    {1.75, 0.9413, 0.9373},
    {1.8, 0.9465, 0.9455},
    {1.85, 0.9508, 0.9519},
    {1.9, 0.9546, 0.9568},
    {1.95, 0.9582, 0.9606},
    {2.0, 0.9616, 0.9638},
    {2.05, 0.965, 0.9664},
    {2.1, 0.9684, 0.9688},
    {2.15, 0.9716, 0.9711},
    {2.2, 0.9747, 0.9734},
    {2.25, 0.9777, 0.9756},
    {2.3, 0.9805, 0.9779},
    {2.35, 0.9831, 0.9801},
    {2.4, 0.9854, 0.9824},
    {2.45, 0.9873, 0.9845},
    {2.5, 0.9889, 0.9864},
    {2.55, 0.9902, 0.9881},
    {2.6, 0.9912, 0.9896},
    {2.65, 0.992, 0.9909},
    {2.7, 0.9926, 0.9919},
    {2.75, 0.993, 0.9927},
    {2.8, 0.9934, 0.9934},
    {2.85, 0.9937, 0.9939},
    {2.9, 0.994, 0.9943},
    {2.95, 0.9943, 0.9946},
    {3.0, 0.9946, 0.9949},
    {3.05, 0.995, 0.9951},
    {3.1, 0.9954, 0.9954},
    {3.15, 0.9958, 0.9956},
    {3.2, 0.9962, 0.9959},
    {3.25, 0.9965, 0.9961},
    {3.3, 0.9969, 0.9964},
    {3.35, 0.9972, 0.9967},
    {3.4, 0.9975, 0.997},
    {3.45, 0.9977, 0.9972},
    {3.50, 0.9979, 0.9975}
};


autoPtr<kernel> wendland(const label nDims)
{
    return kernel::New(dictionary(), nDims);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST(LatticePattern, characteristicVolumesOfTable2)
{
    const autoPtr<kernel> W(wendland(2));
    const latticePattern hexagon(latticePattern::HEXAGONAL, 2);
    const latticePattern square(latticePattern::SQUARE, 2);

    // Half a unit of the fourth printed digit, and round-off
    const scalar printed = 0.5001e-4;

    label nRows = 0;
    for (const tableRow& row : table2)
    {
        const scalar h = row.cutOff/W->cutOff();

        EXPECT_NEAR
        (
            hexagon.characteristicVolume(*W, h), row.hexagon, printed
        ) << "cut-off " << row.cutOff;
        EXPECT_NEAR
        (
            square.characteristicVolume(*W, h), row.square, printed
        ) << "cut-off " << row.cutOff;
        ++nRows;
    }
    EXPECT_EQ(nRows, 41);
}


TEST(LatticePattern, sitesHaveUnitVolume)
{
    for (label nDims = 1; nDims <= 3; ++nDims)
    {
        for
        (
            const auto type
          : {latticePattern::SQUARE, latticePattern::HEXAGONAL}
        )
        {
            const latticePattern pattern(type, nDims);
            const vector& cell = pattern.cell();

            EXPECT_NEAR
            (
                cell.x()*cell.y()*cell.z(), pattern.sites().size(), 1e-12
            );
        }
    }
}


TEST(LatticePattern, neighboursOfClosestPackings)
{
    // Distances of the nearest sites for unit volume per site, counted in a
    // block of cells: 6 at (4/3)^(1/4), 12 at 2^(1/6)
    const struct
    {
        label nDims;
        label nNearest;
        scalar distance;
    } packings[] =
    {
        {2, 6, std::pow(4.0/3, 0.25)}, {3, 12, std::pow(2.0, 1.0/6)}
    };

    for (const auto& packing : packings)
    {
        const latticePattern pattern(latticePattern::HEXAGONAL, packing.nDims);
        const vector& cell = pattern.cell();
        const label nz = packing.nDims == 3 ? 2 : 0;

        label nNearest = 0;
        for (label i = -2; i <= 2; ++i)
        {
            for (label j = -2; j <= 2; ++j)
            {
                for (label k = -nz; k <= nz; ++k)
                {
                    for (const vector& site : pattern.sites())
                    {
                        const vector r
                        (
                            cmptMultiply
                            (
                                vector(i, j, k) + site - pattern.sites()[0],
                                cell
                            )
                        );
                        if (mag(r) > 1e-9)
                        {
                            EXPECT_GT(mag(r), packing.distance - 1e-9);
                            nNearest += mag(r) < packing.distance + 1e-9;
                        }
                    }
                }
            }
        }
        EXPECT_EQ(nNearest, packing.nNearest);
    }
}


TEST(LatticePattern, stiffnessIsThatOfTheStiffestWave)
{
    // In one dimension with h < 1 only next neighbours count, and the
    // stiffest wave is the alternating one: 2*2*W''(1)
    const autoPtr<kernel> W(wendland(1));
    const latticePattern line(latticePattern::SQUARE, 1);
    const scalar h = 0.9;
    const scalar dr = 1e-5;
    const scalar curvature =
        (W->dWdr(1 + dr, h) - W->dWdr(1 - dr, h))/(2*dr);

    EXPECT_NEAR(line.stiffness(*W, h), 4*curvature, 1e-2*4*curvature);
}


TEST(StaticSupport, smoothedHeavisideFunction)
{
    using SPH::staticSupport;

    EXPECT_EQ(staticSupport::heaviside(-2, 1), 0);
    EXPECT_EQ(staticSupport::heaviside(2, 1), 1);
    EXPECT_NEAR(staticSupport::heaviside(0, 1), 0.5, 1e-15);

    // [R] eq. 9 at half the width
    const scalar pi = constant::mathematical::pi;
    EXPECT_NEAR
    (
        staticSupport::heaviside(0.05, 0.1), 0.75 + 1/(2*pi), 1e-14
    );
}


// ************************************************************************* //
