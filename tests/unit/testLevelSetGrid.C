/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    Level sets on grids against the exact signed distance.

\*---------------------------------------------------------------------------*/

#include "levelSetGrid.H"
#include "surfaceDistance.H"
#include "surfaceShapes.H"

#include <gtest/gtest.h>
#include <random>

using namespace Foam;
using namespace Foam::SPH;

TEST(LevelSetGrid, approximatesTheDistanceOfASmoothBody)
{
    const surfaceDistance exact(polygon({circle(0.5, 500)}));

    scalar lastError = GREAT;
    for (const scalar spacing : {0.04, 0.02, 0.01})
    {
        const levelSetGrid grid(exact, planeSpace(), spacing, 0.1);
        std::mt19937 random(1);
        std::uniform_real_distribution<scalar> coordinate(-1, 1);

        scalar error = 0;
        for (label i = 0; i < 5000; ++i)
        {
            const point p(coordinate(random), coordinate(random), 0);
            const auto found = grid.find(p);
            const auto expected = exact.find(p);

            if (mag(expected.distance) < 0.1)
            {
                error = max(error, mag(found.distance - expected.distance));
                EXPECT_GT(found.normal & expected.normal, 0.99);
            }
            else
            {
                EXPECT_EQ(found.distance < 0, expected.distance < 0);
            }
            EXPECT_NEAR(mag(found.normal), 1, 1e-12);
        }

        EXPECT_LT(error, 0.3*lastError);
        lastError = error;
    }
}


TEST(LevelSetGrid, losesWhatIsThinnerThanItsSpacing)
{
    const surfaceDistance plate
    (
        polygon({{{0, 0, 0}, {1, 0, 0}, {1, 1e-3, 0}, {0, 0.2, 0}}})
    );
    const levelSetGrid grid(plate, planeSpace(), 0.05, 0.1);

    const point inPlate(0.995, 5e-4, 0);
    EXPECT_LT(plate.distance(inPlate), 0);
    EXPECT_GT(grid.distance(inPlate), 0);
    EXPECT_LT(grid.distance(point(0.1, 0.1, 0)), 0);
}


// ************************************************************************* //
