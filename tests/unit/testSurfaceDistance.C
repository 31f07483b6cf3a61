/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    Signed distances to shapes that are known, and to random polygons against
    plain sums over all segments.

\*---------------------------------------------------------------------------*/

#include "fluidRegion.H"
#include "surfaceDistance.H"
#include "surfaceShapes.H"
#include "testCase.H"
#include "mathematicalConstants.H"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar pi = constant::mathematical::pi;


//- An L
orientedSurface angle()
{
    return polygon
    ({
        {
            {0, 0, 0}, {1, 0, 0}, {1, 0.5, 0},
            {0.5, 0.5, 0}, {0.5, 1, 0}, {0, 1, 0}
        }
    });
}


//- Queries in the box of a surface, half of them close to its vertices
std::vector<point> queries
(
    const orientedSurface& surface,
    const label n,
    std::mt19937& random
)
{
    std::uniform_real_distribution<scalar> unit(0, 1);
    boundBox box(surface.bounds());
    box.inflate(0.2);

    const auto vector01 = [&]{ return vector(unit(random), unit(random), 0); };

    std::vector<point> points;
    for (label i = 0; i < n; ++i)
    {
        const label v = label(unit(random)*surface.points().size());
        const scalar scale = std::pow(10.0, -8*unit(random));

        points.push_back
        (
            i % 2
          ? box.min() + cmptMultiply(box.span(), vector01())
          : surface.points()[v] + scale*(vector01() - vector(0.5, 0.5, 0))
        );
        points.back().z() = 0;
    }
    return points;
}


//- Compare with plain sums
void checkPolygon(const orientedSurface& surface, const label n)
{
    ASSERT_TRUE(surface.openElements().empty());

    const surfaceDistance distance(surface);
    std::mt19937 random(7);

    for (const point& p : queries(surface, n, random))
    {
        const auto found = distance.find(p);
        const scalar expected = plainDistance(surface, p);

        EXPECT_NEAR(mag(found.distance), expected, 1e-14);
        EXPECT_NEAR(mag(found.normal), 1, 1e-12);
        EXPECT_NEAR(plainDistance(surface, found.hit), 0, 1e-14);
        EXPECT_NEAR
        (
            mag(p - found.hit - found.distance*found.normal),
            0,
            1e-9*expected + 1e-14
        );

        if (expected > 1e-13)
        {
            EXPECT_EQ(found.distance < 0, plainInside(surface, p))
                << p.x() << ' ' << p.y() << ' ' << expected;
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Two dimensions  * * * * * * * * * * * * * //

TEST(SurfaceDistance, imagesOfVerticesThatTouchHaveTheirSign)
{
    // Two holes in a channel of unit period that touch in a vertex, both above
    // it: below, nothing is nearer
    const orientedSurface channel
    (
        polygon
        ({
            {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
            reversed({{0.5, 0.5, 0}, {0.45, 0.7, 0}, {0.4, 0.7, 0}}),
            reversed({{0.5, 0.5, 0}, {0.6, 0.7, 0}, {0.55, 0.7, 0}})
        })
    );
    List<orientedSurface::element> elements(channel.elements());
    for (orientedSurface::element& e : elements)
    {
        const scalar x = channel.points()[e.vertices[0]].x();
        e.coupled = channel.points()[e.vertices[1]].x() == x && x*(1 - x) == 0;
    }
    const surfaceDistance distance
    (
        orientedSurface
        (
            channel.space(),
            pointField(channel.points()),
            std::move(elements),
            {vector(1, 0, 0)}
        ),
        1
    );

    for (const scalar period : {-1, 0, 1})
    {
        const point below(0.5 + period, 0.499, 0);
        EXPECT_NEAR(distance.distance(below), -1e-3, 1e-12) << period;
    }
}


TEST(SurfaceDistance, circleIsItsRadius)
{
    const label n = 2000;
    const surfaceDistance distance(polygon({circle(0.5, n)}));

    // A polygon is at most its sagitta away from its circle
    const scalar sagitta = 0.5*(1 - std::cos(pi/n));

    for (const scalar r : {0.01, 0.3, 0.499, 0.501, 2.0})
    {
        for (const scalar theta : {0.1, 1.7, 3.9, 5.5})
        {
            const vector e(std::cos(theta), std::sin(theta), 0);
            const auto found = distance.find(r*e);
            EXPECT_NEAR(found.distance, r - 0.5, sagitta);
            EXPECT_GT(found.normal & e, 1 - 1e-4);
        }
    }
}


TEST(SurfaceDistance, squareHasFacesAndCorners)
{
    const surfaceDistance square
    (
        polygon({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}})
    );

    EXPECT_DOUBLE_EQ(square.distance(point(0.5, 0.25, 0)), -0.25);
    EXPECT_DOUBLE_EQ(square.distance(point(1.25, 0.5, 0)), 0.25);
    EXPECT_DOUBLE_EQ(square.distance(point(4, 5, 0)), 5);

    const auto corner = square.find(point(4, 5, 0));
    EXPECT_NEAR(mag(corner.normal - vector(0.6, 0.8, 0)), 0, 1e-15);
    EXPECT_NEAR(mag(corner.hit - point(1, 1, 0)), 0, 1e-15);

    // On the surface the normal is that of the face or of the corner
    const vector face(square.find(point(0.3, 0, 0)).normal);
    const vector vertex(square.find(point(1, 1, 0)).normal);
    EXPECT_NEAR(mag(face + vector(0, 1, 0)), 0, 1e-15);
    EXPECT_NEAR(mag(vertex - vector(1, 1, 0)/std::sqrt(2.0)), 0, 1e-15);
}


TEST(SurfaceDistance, nothingFarAwayIsInside)
{
    // The star's edges are nearest in turn; from afar all are in round-off
    const surfaceDistance star
    (
        polygon
        ({{
            {1, 0, 0}, {0.2, 0.2, 0}, {0, 1, 0}, {-0.2, 0.2, 0},
            {-1, 0, 0}, {-0.2, -0.2, 0}, {0, -1, 0}, {0.2, -0.2, 0}
        }})
    );

    EXPECT_TRUE(star.inside(point(0.1, 0.1, 0)));
    for (label k = 0; k < 360; ++k)
    {
        const scalar angle = k*pi/180;
        const point p(1e17*std::cos(angle), 1e17*std::sin(angle), 0);
        EXPECT_FALSE(star.inside(p)) << k;
    }
}


TEST(SurfaceDistance, cornersAndThinEdgesHaveTheRightSign)
{
    const scalar fiveDegrees = std::tan(pi/36);

    checkPolygon(angle(), 2000);
    checkPolygon(polygon({{{0, 0, 0}, {1, 0, 0}, {1, fiveDegrees, 0}}}), 2000);
    checkPolygon
    (
        polygon({{{0, 0, 0}, {1, 0, 0}, {1, 1e-4, 0}, {0, 0.1, 0}}}),
        2000
    );
    checkPolygon(polygon({{{0, 0, 0}, {1, 0, 0}, {0, 1e-8, 0}}}), 2000);
}


TEST(SurfaceDistance, partsMayBeNestedDisjointAndTouch)
{
    const loop hole(reversed(circle(0.2, 50)));

    checkPolygon
    (
        polygon
        ({
            circle(0.5, 200),
            hole,
            circle(0.1, 20),
            circle(0.1, 20, point(2, 0, 0))
        }),
        2000
    );

    // Two squares that share a vertex
    List<orientedSurface::element> elements(8);
    const label loops[2][4] = {{0, 1, 2, 3}, {0, 4, 5, 6}};
    for (label k = 0; k < 8; ++k)
    {
        const auto& l = loops[k/4];
        elements[k] = orientedSurface::element(l[k % 4], l[(k + 1) % 4]);
    }
    const orientedSurface touching
    (
        planeSpace(),
        pointField
        ({
            {0, 0, 0},
            {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
            {-1, 0, 0}, {-1, -1, 0}, {0, -1, 0}
        }),
        std::move(elements)
    );
    checkPolygon(touching, 2000);

    label nParts;
    touching.parts(nParts);
    EXPECT_EQ(nParts, 2);
}


TEST(SurfaceDistance, randomPolygonsHaveTheRightSign)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<scalar> unit(0, 1);

    for (label k = 0; k < 200; ++k)
    {
        // A star with sharp and flat corners
        const label n = 5 + label(20*unit(random));
        std::vector<scalar> angles(n);
        for (scalar& a : angles)
        {
            a = 2*pi*unit(random);
        }
        std::sort(angles.begin(), angles.end());

        loop star;
        for (const scalar a : angles)
        {
            const scalar r = 0.02 + unit(random);
            star.push_back(r*vector(std::cos(a), std::sin(a), 0));
        }

        // Around the origin only if no gap is wider than a half turn
        bool around = angles.front() + 2*pi - angles.back() < pi;
        for (label i = 1; i < n; ++i)
        {
            around = around && angles[i] - angles[i-1] < pi;
        }

        if (around)
        {
            checkPolygon(polygon({star}), 100);
        }
    }
}


// * * * * * * * * * * * * * * * * Three dimensions  * * * * * * * * * * * * //

TEST(SurfaceDistance, boxIsExactInThreeDimensions)
{
    const orientedSurface box(boxSurface(point::zero, point(1, 2, 3), 3));
    ASSERT_TRUE(box.openElements().empty());
    EXPECT_NEAR(box.volume(), 6, 1e-14);

    const surfaceDistance distance(box);
    std::mt19937 random(3);
    std::uniform_real_distribution<scalar> unit(0, 1);

    for (label i = 0; i < 5000; ++i)
    {
        const point p
        (
            3*unit(random) - 1,
            4*unit(random) - 1,
            5*unit(random) - 1
        );
        const point clipped(max(min(p, point(1, 2, 3)), point::zero));
        const scalar depth =
            min(cmptMin(p), cmptMin(point(1, 2, 3) - p));

        EXPECT_NEAR
        (
            distance.distance(p),
            depth > 0 ? -depth : mag(p - clipped),
            1e-14
        );
    }
}


TEST(SurfaceDistance, torusIsItsTube)
{
    const scalar R = 1, r = 0.25;
    const label n = 120, m = 60;

    const orientedSurface torus
    (
        mapped
        (
            {
                [&](const scalar s, const scalar t)
                {
                    const scalar a = 2*pi*s, b = 2*pi*t;
                    const scalar rho = R + r*std::cos(b);
                    const vector radial(std::cos(a), std::sin(a), 0);
                    return rho*radial + vector(0, 0, r*std::sin(b));
                }
            },
            n,
            m
        )
    );
    ASSERT_TRUE(torus.openElements().empty());

    const surfaceDistance distance(torus);
    const scalar sagitta =
        (R + r)*(1 - std::cos(pi/n)) + r*(1 - std::cos(pi/m));

    std::mt19937 random(3);
    std::uniform_real_distribution<scalar> unit(-1, 1);
    for (label i = 0; i < 2000; ++i)
    {
        const point p(1.5*unit(random), 1.5*unit(random), 0.5*unit(random));
        const scalar rho = std::hypot(p.x(), p.y());
        const scalar expected = std::hypot(rho - R, p.z()) - r;
        EXPECT_NEAR(distance.distance(p), expected, sagitta);
    }
}


TEST(SurfaceDistance, boxesThatTouchInAnEdgeKeepTheirSign)
{
    // Two unit boxes with one common edge x = y = 1
    const orientedSurface first(boxSurface(point::zero, point::one, 2));
    const orientedSurface second
    (
        boxSurface(point(1, 1, 0), point(2, 2, 1), 2)
    );

    DynamicList<point> points(first.points());
    DynamicList<orientedSurface::element> elements(first.elements());
    labelList newPoint(second.points().size(), -1);
    forAll(newPoint, i)
    {
        newPoint[i] = points.find(second.points()[i]);
        if (newPoint[i] < 0)
        {
            newPoint[i] = points.size();
            points.append(second.points()[i]);
        }
    }
    for (orientedSurface::element e : second.elements())
    {
        for (label& v : e.vertices)
        {
            v = newPoint[v];
        }
        elements.append(e);
    }

    const surfaceDistance distance
    (
        orientedSurface
        (
            fullSpace(),
            pointField(std::move(points)),
            List<orientedSurface::element>(std::move(elements))
        )
    );

    for (const scalar d : {0.2, 1e-3, 1e-8})
    {
        const std::pair<point, scalar> expected[] =
        {
            {point(1 + d, 1 - d, 0.4), d},
            {point(1 + d, 1 - 0.1*d, 0.4), 0.1*d},
            {point(1 + d, 1 + d, 0.4), -d},
            {point(1 - d, 1 - d, 0.4), -d},
            {point(1, 1, 1 + d), d},
            {point(2 + d, 2 + d, 0.4), std::sqrt(2.0)*d}
        };

        for (const auto& pd : expected)
        {
            EXPECT_NEAR(distance.distance(pd.first), pd.second, 1e-12);
        }
    }
}


// * * * * * * * * * * * * * * * * Combinations  * * * * * * * * * * * * * * //

TEST(FluidRegion, isTheMeshLessTheBodiesFromFiles)
{
    testCase square(testCase::layout{});
    const solutionSpace space(square.mesh());
    const patchSurface patches(square.mesh(), space);
    PtrList<solidBody> bodies;
    bodies.append
    (
        new solidBody
        (
            "disc",
            polygon({circle(0.5, 400, point(1, 0.5, 0))}),
            labelList(),
            1
        )
    );
    const fluidRegion fluid(patches, bodies, 1);
    EXPECT_TRUE(fluid.bounded());

    std::mt19937 random(3);
    std::uniform_real_distribution<scalar> coordinate(-0.5, 1.5);
    for (label i = 0; i < 1000; ++i)
    {
        const point p(coordinate(random), coordinate(random), 0);
        const scalar toDisc = mag(p - point(1, 0.5, 0)) - 0.5;
        const bool inSquare = boundBox(point::zero, point::one).contains(p);

        if (mag(toDisc) > 1e-4)
        {
            EXPECT_EQ(fluid.distance(p) < 0, inSquare && toDisc > 0);
            EXPECT_EQ(fluid.inside(p), inSquare && toDisc > 0);
        }
    }

    // Out of what is left means into what was taken away
    const auto cut = fluid.find(point(0.45, 0.5, 0));
    EXPECT_NEAR(cut.distance, -0.05, 1e-4);
    EXPECT_NEAR(cut.normal.x(), 1, 1e-3);

    // Half of the disc
    EXPECT_NEAR(fluid.overlap(0.01), pi/8, 2e-3);
}


// ************************************************************************* //
