/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    Neighbour search against the comparison of every point with every other.

\*---------------------------------------------------------------------------*/

#include "testCase.H"
#include "cellGrid.H"
#include "checkedLabel.H"
#include "particlePairs.H"
#include "periodicImages.H"
#include "Random.H"
#include "spaceFillingCurve.H"

#include <gtest/gtest.h>
#include <map>
#include <set>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Random points of the unit cube in nDims directions
vectorField randomPoints(const label nDims, const label n, const label seed)
{
    Random random(seed);
    vectorField points(n, Zero);
    for (vector& p : points)
    {
        for (direction d = 0; d < nDims; ++d)
        {
            p[d] = random.sample01<scalar>();
        }
    }
    return points;
}


//- Pair of points and the image of the second, in steps along each direction
typedef std::tuple<label, label, label, label, label> imagePair;

imagePair makePair
(
    const vectorField& points,
    const label i,
    const label j,
    const vector& delta
)
{
    const vector shift(delta - (points[j] - points[i]));
    return imagePair
    (
        i,
        j,
        std::lround(shift.x()),
        std::lround(shift.y()),
        std::lround(shift.z())
    );
}


//- Compare with all images of all points within one period of 1 along the
//- first nPeriodic directions
void compare
(
    const vectorField& points,
    const scalarField& radius,
    const label nPeriodic
)
{
    List<vector> translations(nPeriodic, Zero);
    forAll(translations, d)
    {
        translations[d][d] = 1;
    }

    std::set<imagePair> expected;
    const label reach[3] =
        {label(nPeriodic > 0), label(nPeriodic > 1), label(nPeriodic > 2)};
    forAll(points, i)
    {
        for (label j = i + 1; j < points.size(); ++j)
        {
            for (label x = -reach[0]; x <= reach[0]; ++x)
            {
                for (label y = -reach[1]; y <= reach[1]; ++y)
                {
                    for (label z = -reach[2]; z <= reach[2]; ++z)
                    {
                        const vector d(points[j] + vector(x, y, z) - points[i]);
                        if (mag(d) < max(radius[i], radius[j]))
                        {
                            expected.emplace(i, j, x, y, z);
                        }
                    }
                }
            }
        }
    }

    const particlePairs pairs(points, radius, imageOffsets(translations));

    std::set<imagePair> found;
    for (label k = 0; k < pairs.size(); ++k)
    {
        const label i = pairs.owner[k];
        const label j = pairs.neighbour[k];
        EXPECT_LT(i, j);
        EXPECT_TRUE(found.insert(makePair(points, i, j, pairs.delta[k])).second)
            << "pair " << i << ' ' << j << " twice";
        EXPECT_LT(mag(pairs.delta[k]), max(radius[i], radius[j]));

        if (k > 0)
        {
            EXPECT_LE
            (
                std::make_pair(pairs.owner[k - 1], pairs.neighbour[k - 1]),
                std::make_pair(i, j)
            );
        }
    }

    EXPECT_GT(expected.size(), size_t(points.size()));
    EXPECT_EQ(found, expected);
}


//- Number of dimensions
class ParticlePairs
:
    public testing::TestWithParam<label>
{
protected:

    const label nDims = GetParam();

    //- Radius that reaches a few points
    const scalar reach = nDims == 1 ? 0.02 : nDims == 2 ? 0.1 : 0.25;
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_P(ParticlePairs, uniformRadiusFindsWhatBruteForceFinds)
{
    compare(randomPoints(nDims, 300, 1), scalarField(300, reach), 0);
}


TEST_P(ParticlePairs, variableRadiusFindsWhatBruteForceFinds)
{
    Random random(7);
    scalarField radius(300);
    for (scalar& r : radius)
    {
        r = reach*(0.5 + 2*sqr(random.sample01<scalar>()));
    }
    compare(randomPoints(nDims, 300, 2), radius, 0);
}


TEST_P(ParticlePairs, periodicImagesFindWhatBruteForceFinds)
{
    for (label nPeriodic = 1; nPeriodic <= nDims; ++nPeriodic)
    {
        Random random(7);
        scalarField radius(200);
        for (scalar& r : radius)
        {
            r = reach*(0.8 + 0.4*random.sample01<scalar>());
        }
        compare(randomPoints(nDims, 200, 3), radius, nPeriodic);
    }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, ParticlePairs, testing::Values(1, 2, 3));


TEST(ParticlePairs, periodShorterThanTheRadiusIsRefused)
{
    const vectorField points(randomPoints(2, 20, 4));
    const List<vector> translation(1, vector(0.3, 0, 0));
    const std::string message
    (
        errorMessage
        (
            [&]
            {
                particlePairs
                (
                    points, scalarField(20, 0.4), imageOffsets(translation)
                );
            }
        )
    );

    EXPECT_NE(message.find("cyclic"), std::string::npos) << message;
    EXPECT_NE(message.find("spacing"), std::string::npos) << message;
}


TEST(ParticlePairs, moreThanLabelsCountAreRefused)
{
    EXPECT_EQ(checkedLabel(labelMax, "pairs"), labelMax);

    const std::string message
    (
        errorMessage([]{ checkedLabel(2.0*labelMax, "pairs"); })
    );
    EXPECT_NE(message.find("pairs"), std::string::npos) << message;
    EXPECT_NE(message.find("WM_LABEL_SIZE"), std::string::npos) << message;
}


TEST(ParticlePairs, subsetKeepsWhatIsAskedFor)
{
    const vectorField points(randomPoints(2, 100, 5));
    const particlePairs all(points, scalarField(100, 0.2), List<vector>());
    particlePairs some(all);

    boolList keep(all.size());
    forAll(keep, k)
    {
        keep[k] = k % 3 == 1;
    }
    some.subset(keep);

    ASSERT_EQ(some.size(), (all.size() + 1)/3);
    for (label k = 0; k < some.size(); ++k)
    {
        EXPECT_EQ(some.owner[k], all.owner[3*k + 1]);
        EXPECT_EQ(some.neighbour[k], all.neighbour[3*k + 1]);
        EXPECT_EQ(some.delta[k], all.delta[3*k + 1]);
    }
}


TEST(CellGrid, visitsEveryPointInReachOnce)
{
    for (const label nDims : {1, 2, 3})
    {
        const vectorField points(randomPoints(nDims, 500, 6));
        const cellGrid grid(points, 0.07);

        // Queries outside the points' box as well
        for (const vector& q : vectorField(3*randomPoints(nDims, 50, 8)))
        {
            const vector p(q - vector::one);
            std::map<label, label> visits;
            grid.forNear(p, 0.2, [&](const label j) { ++visits[j]; });

            forAll(points, j)
            {
                if (mag(points[j] - p) < 0.2)
                {
                    EXPECT_EQ(visits.count(j), 1u);
                }
            }
            for (const auto& v : visits)
            {
                EXPECT_EQ(v.second, 1);
            }
        }
    }
}


TEST(SpaceFillingCurve, isAPermutationThatKeepsNeighboursTogether)
{
    const vectorField points(randomPoints(2, 4096, 9));
    const labelList order(spaceFillingOrder(points, 1.0/64));

    EXPECT_EQ
    (
        std::set<label>(order.begin(), order.end()).size(),
        size_t(points.size())
    );

    // Random points are half the box apart; along a curve through boxes of a
    // 64th they are about a box apart, and a few jumps
    scalar sum = 0;
    for (label i = 1; i < order.size(); ++i)
    {
        sum += mag(points[order[i]] - points[order[i - 1]]);
    }
    EXPECT_LT(sum/order.size(), 3.0/64);
}

// ************************************************************************* //
