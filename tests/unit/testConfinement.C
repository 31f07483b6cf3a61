/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    Level sets on grids and the kernel support beyond a surface, against
    quadrature of the kernel that does not use them.

\*---------------------------------------------------------------------------*/

#include "levelSetGrid.H"
#include "staticConfinement.H"
#include "surfaceIntegral.H"
#include "surfaceShapes.H"
#include "testCase.H"
#include "mathematicalConstants.H"

#include <gtest/gtest.h>
#include <random>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar pi = constant::mathematical::pi;


//- A spacing that grows linearly in x, or is uniform
class linearSpacing
:
    public spacingFunction
{
    const scalar slope_;

public:

    linearSpacing(const scalar least, const scalar largest, const scalar slope)
    :
        slope_(slope)
    {
        setRange(least, largest);
    }

    virtual scalar operator()(const point& p) const
    {
        return Foam::min(max(), min() + slope_*mag(p.x()));
    }

    virtual scalar slope() const
    {
        return slope_;
    }
};


autoPtr<kernel> makeKernel(const word& type, const label nDims)
{
    dictionary dict;
    dict.add("type", type);
    dict.add("smoothingRatio", 1.3);
    return kernel::New(dict, nDims);
}


//- Midpoint rule with many points
template<class Function>
scalar quadrature(const Function& f, const scalar from, const scalar to)
{
    const label n = 20000;
    scalar sum = 0;
    for (label i = 0; i < n; ++i)
    {
        sum += f(from + (to - from)*(i + 0.5)/n);
    }
    return sum*(to - from)/n;
}


dictionary confinementDict(const word& method, const scalar gridRatio)
{
    dictionary dict;
    dict.add("method", method);
    dict.add("gridRatio", gridRatio);
    return dict;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Level set * * * * * * * * * * * * * * * //

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


// * * * * * * * * * * * * * * * Surface integral  * * * * * * * * * * * * * //

TEST(SurfaceIntegral, flatWallHasItsLineOrPlaneIntegral)
{
    const scalar h = 0.13;

    const surfaceDistance square
    (
        polygon({{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}})
    );
    const surfaceDistance box(boxSurface(-point::one, point::one, 5));

    for (const char* type : {"WendlandC2", "cubicSpline", "quinticSpline"})
    {
        const autoPtr<kernel> plane(makeKernel(type, 2));
        const autoPtr<kernel> space(makeKernel(type, 3));
        const surfaceIntegral line(square, *plane);
        const surfaceIntegral area(box, *space);
        const scalar reach = plane->cutOff()*h;

        // The pieces of splines are not smooth where they meet
        const scalar tolerance =
            (word(type) == "WendlandC2" ? 2e-5 : 3e-4)*plane->lineW(0, h);

        for (const scalar d : {0.0, 1e-9, 0.3*h, 1.1*h, 1.9*h})
        {
            const scalar overLine = quadrature
            (
                [&](const scalar s){ return plane->W(std::hypot(s, d), h); },
                -reach,
                reach
            );
            const scalar overPlane = quadrature
            (
                [&](const scalar r){ return 2*pi*r*space->W(r, h); },
                d,
                reach
            );

            const vector g2(line(point(1 - d, 0.1, 0), h));
            const vector g3(area(point(0.1, -0.07, 1 - d), h));

            EXPECT_NEAR(g2.x(), overLine, tolerance);
            EXPECT_NEAR(mag(g2 - vector(g2.x(), 0, 0)), 0, 1e-12);
            EXPECT_NEAR(g3.z(), overPlane, tolerance);
            EXPECT_NEAR(mag(g3 - vector(0, 0, g3.z())), 0, 1e-9/h);
        }
    }
}


TEST(SurfaceIntegral, cornersAddTheirSides)
{
    // In the corner of a quarter space the sides see half of their line each
    const scalar h = 0.1;
    const autoPtr<kernel> k(makeKernel("WendlandC2", 2));
    const surfaceDistance square
    (
        polygon({{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}})
    );
    const scalar half = quadrature
    (
        [&](const scalar s){ return k->W(s, h); },
        0,
        k->cutOff()*h
    );

    const vector g(surfaceIntegral(square, *k)(point(1, 1, 0), h));
    EXPECT_NEAR(g.x(), half, 1e-6*half);
    EXPECT_NEAR(g.y(), half, 1e-6*half);
}


// * * * * * * * * * * * * * * Static confinement  * * * * * * * * * * * * * //

TEST(StaticConfinement, tablesApproachTheSurfaceIntegral)
{
    const scalar dp = 0.05;
    const autoPtr<kernel> k(makeKernel("WendlandC2", 2));
    const surfaceDistance body(polygon({circle(0.5, 200)}));
    const surfaceIntegral exact(body, *k);
    const linearSpacing spacing(dp, dp, 0);
    const scalar scale = k->lineW(0, 1.3*dp);

    for (const char* method : {"levelSet", "surface"})
    {
        scalar lastError = GREAT;
        for (const scalar ratio : {0.5, 0.25, 0.125})
        {
            const staticConfinement table
            (
                body,
                planeSpace(),
                *k,
                spacing,
                confinementDict(method, ratio)
            );

            std::mt19937 random(1);
            std::uniform_real_distribution<scalar> coordinate(-0.6, 0.6);
            scalar error = 0;
            for (label i = 0; i < 2000; ++i)
            {
                const point p(coordinate(random), coordinate(random), 0);
                if (mag(p) < 0.52)
                {
                    const vector g(exact(p, 1.3*dp));
                    error = max(error, mag(table(p, dp) - g)/scale);
                }
            }

            EXPECT_LT(error, 0.4*lastError) << method << ' ' << ratio;
            lastError = error;
        }
        EXPECT_LT(lastError, 0.01) << method;
    }
}


TEST(StaticConfinement, completesTheSupportOfALattice)
{
    // A square lattice in a box, half a spacing from its sides: the sum over
    // the lattice alone is large, with g it is as small as the quadrature
    const scalar dp = 0.1;
    const linearSpacing spacing(dp, dp, 0);

    for (const label nDims : {2, 3})
    {
        const autoPtr<kernel> k(makeKernel("WendlandC2", nDims));
        const solutionSpace space(nDims == 2 ? planeSpace() : fullSpace());
        const surfaceDistance body
        (
            nDims == 2
          ? polygon({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}})
          : boxSurface(point::zero, point::one, 2)
        );

        for (const char* method : {"levelSet", "surface"})
        {
            const staticConfinement table
            (
                body,
                space,
                *k,
                spacing,
                confinementDict(method, nDims == 2 ? 0.25 : 0.5)
            );

            const point p(dp/2, 0.45, nDims == 2 ? 0 : 0.45);
            vector sum(Zero);
            for (label n = 0; n < 1000; ++n)
            {
                const point q
                (
                    (n % 10 + 0.5)*dp,
                    ((n/10) % 10 + 0.5)*dp,
                    nDims == 2 ? 0 : (n/100 + 0.5)*dp
                );
                const scalar r = mag(p - q);

                if (r > SMALL && (nDims == 3 || n < 100))
                {
                    sum +=
                        kernel::integerPow(dp, nDims)
                       *k->dWdr(r, 1.3*dp)/r*(p - q);
                }
            }

            EXPECT_GT(mag(sum)*dp, 0.4);
            EXPECT_LT(mag(sum + table(p, dp))*dp, 0.03) << method << nDims;
        }
    }
}


TEST(StaticConfinement, followsAVariableSpacing)
{
    const autoPtr<kernel> k(makeKernel("WendlandC2", 2));
    const surfaceDistance body(polygon({circle(0.5, 200)}));
    const surfaceIntegral exact(body, *k);
    const linearSpacing spacing(0.02, 0.1, 0.1);

    for (const char* method : {"levelSet", "surface"})
    {
        const staticConfinement table
        (
            body,
            planeSpace(),
            *k,
            spacing,
            confinementDict(method, 0.25)
        );

        for (label i = 0; i < 500; ++i)
        {
            const scalar r = 0.5 - 0.05*(i % 7)/7;
            const point p(r*std::cos(0.1*i), r*std::sin(0.1*i), 0);
            const scalar dp = spacing(p);
            const vector g(exact(p, 1.3*dp));

            EXPECT_LT(mag(table(p, dp) - g), 0.05*k->lineW(0, 1.3*dp))
                << method << ' ' << p.x() << ' ' << p.y();
        }
    }
}


TEST(StaticConfinement, errorsSayWhatIsValid)
{
    const autoPtr<kernel> k(makeKernel("WendlandC2", 2));
    const surfaceDistance body(polygon({circle(0.5, 50)}));
    const levelSetGrid grid(body, planeSpace(), 0.1, 0.2);
    const linearSpacing spacing(0.1, 0.1, 0);

    const auto message = [&](const signedDistance& d, const dictionary& dict)
    {
        return errorMessage
        (
            [&]{ staticConfinement(d, planeSpace(), *k, spacing, dict); }
        );
    };

    EXPECT_EQ(message(body, confinementDict("surface", 0.5)), "");
    EXPECT_EQ(message(grid, confinementDict("levelSet", 0.5)), "");
    EXPECT_NE
    (
        message(grid, confinementDict("surface", 0.5)).find("levelSet"),
        std::string::npos
    );
    EXPECT_NE
    (
        message(body, confinementDict("plane", 0.5)).find("levelSet surface"),
        std::string::npos
    );
    EXPECT_NE
    (
        message(body, confinementDict("surface", 5)).find("gridRatio"),
        std::string::npos
    );
}


// ************************************************************************* //
