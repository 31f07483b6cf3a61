/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    Particle spacings: their values, their growth and their messages.

\*---------------------------------------------------------------------------*/

#include "spacingFunction.H"
#include "testCase.H"

#include "IStringStream.H"
#include "volFields.H"

#include <gtest/gtest.h>
#include <random>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A 4 x 2 box whose cells grow from 0.1 to 0.3 in x, with a square hole
class SpacingFunction
:
    public testing::Test
{
protected:

    static testCase::layout graded()
    {
        testCase::layout layout;
        layout.nCells = labelVector(20, 20, 1);
        layout.box = boundBox(point::zero, point(2, 2, 0.1));
        layout.hole = boundBox(point(0.5, 0.9, -1), point(0.7, 1.1, 1));
        layout.transform = [](const point& p)
        {
            return point(p.x()*(1 + 0.5*p.x()), p.y(), p.z());
        };
        return layout;
    }

    testCase case_{graded()};
    patchSurface surface_{case_.mesh(), solutionSpace(case_.mesh())};

    autoPtr<spacingFunction> make(const std::string& content) const
    {
        return spacingFunction::New
        (
            surface_,
            dictionary(IStringStream(content)())
        );
    }

    void expectError
    (
        const std::string& content,
        const std::vector<std::string>& words
    ) const
    {
        const std::string message(errorMessage([&]{ make(content); }));
        for (const std::string& word : words)
        {
            EXPECT_NE(message.find(word), std::string::npos)
                << "no '" << word << "' in: " << message;
        }
    }

    //- No two points may differ by more than the slope allows
    void expectGrowth(const spacingFunction& spacing) const
    {
        std::mt19937 random(1);
        std::uniform_real_distribution<scalar> x(-0.5, 4.5), y(-0.5, 2.5);

        for (label i = 0; i < 5000; ++i)
        {
            const point p(x(random), y(random), 0);
            const point far(x(random), y(random), 0);
            const point q(i % 2 ? far : p + vector(1e-4, 1e-4, 0));
            const scalar dp = spacing(p);

            EXPECT_GE(dp, spacing.min());
            EXPECT_LE(dp, spacing.max());
            EXPECT_LE(mag(dp - spacing(q)), spacing.slope()*mag(p - q) + 1e-14);
        }
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_F(SpacingFunction, aNumberIsUniform)
{
    const char* contents[] =
    {
        "spacing 0.05;",
        "spacing { type uniform; value 0.05; }"
    };

    for (const char* content : contents)
    {
        const auto spacing = make(content);
        EXPECT_TRUE(spacing->uniform());
        EXPECT_DOUBLE_EQ((*spacing)(point(1, 2, 3)), 0.05);
        EXPECT_EQ(spacing->slope(), 0);
    }
}


TEST_F(SpacingFunction, refinedGrowsAwayFromPatchesAndRegions)
{
    const auto spacing = make
    (
        "spacing { type refined; base 0.2;"
        "near { hole { spacing 0.02; growth 1.1; layers 2; } }"
        "regions"
        "{"
        "    ball { type sphere; centre (3 1 7); radius 0.5; spacing 0.1; }"
        "    bar { type cylinder; point1 (0 0 0); point2 (4 0 0);"
        "          radius 0.2; spacing 0.05; growth 1.2; }"
        "    brick { type box; min (3.5 1.5 -9); max (4 2 9); spacing 0.1; }"
        "} }"
    );

    // The hole is 0.5 < x < 0.7 stretched to 0.625 < x < 0.945
    EXPECT_NEAR((*spacing)(point(0.625, 1, 0)), 0.02, 1e-14);
    EXPECT_NEAR((*spacing)(point(0.595, 1, 0)), 0.02, 1e-14);
    EXPECT_NEAR((*spacing)(point(0.325, 1, 0)), 0.02 + 0.1*(0.3 - 0.04), 1e-14);

    EXPECT_NEAR((*spacing)(point(3, 1.3, 0)), 0.1, 1e-14);
    EXPECT_NEAR((*spacing)(point(3, 1.6, 0)), 0.1 + 0.05*0.1, 1e-14);
    EXPECT_NEAR((*spacing)(point(0.2, 0.25, 0)), 0.05 + 0.2*0.05, 1e-14);
    EXPECT_NEAR((*spacing)(point(4.3, 0.2, 0)), 0.05 + 0.2*0.3, 1e-14);
    EXPECT_NEAR((*spacing)(point(4.2, 1.9, 0)), 0.1 + 0.05*0.2, 1e-14);
    EXPECT_DOUBLE_EQ(spacing->min(), 0.02);
    EXPECT_DOUBLE_EQ(spacing->max(), 0.2);

    expectGrowth(*spacing);
}


TEST(FromMeshSpacing, putsTwoParticlesAcrossOneLayerOfFlatCells)
{
    testCase::layout layout;
    layout.twoD = false;
    layout.nCells = labelVector(10, 10, 1);
    layout.box = boundBox(point::zero, point(2, 2, 0.08));
    testCase c(layout);
    const patchSurface surface(c.mesh(), solutionSpace(c.mesh()));

    const auto spacing = spacingFunction::New
    (
        surface,
        dictionary(IStringStream("spacing fromMesh;")())
    );

    // Cells of 0.2 x 0.2 x 0.08 have a size of 0.147
    EXPECT_NEAR((*spacing)(point(1, 1, 0.04)), 0.04, 1e-12);
}


TEST_F(SpacingFunction, fromMeshFollowsTheCells)
{
    const auto spacing = make("spacing fromMesh;");
    const fvMesh& mesh = case_.mesh();

    // The cells grow by 7 % or less from one to the next: nothing to limit,
    // but what a cell keeps of its smaller neighbours' size at its centre
    forAll(mesh.C(), celli)
    {
        const scalar size = std::sqrt(mesh.V()[celli]/0.1);
        EXPECT_NEAR((*spacing)(mesh.C()[celli]), size, 0.05*size);
    }
    expectGrowth(*spacing);

    const auto limited = make
    (
        "spacing { type fromMesh; growth 1.01; min 0.11; scale 0.5; max 0.12; }"
    );
    EXPECT_DOUBLE_EQ(limited->min(), 0.11);
    EXPECT_DOUBLE_EQ((*limited)(mesh.C()[0]), 0.11);
    EXPECT_LE(limited->max(), 0.12);
    expectGrowth(*limited);
}


TEST(Spacing, equalCellsGiveALattice)
{
    testCase box(testCase::layout{});
    const patchSurface surface(box.mesh(), solutionSpace(box.mesh()));
    const auto spacing = spacingFunction::New
    (
        surface,
        dictionary(IStringStream("spacing fromMesh;")())
    );
    EXPECT_TRUE(spacing->uniform());
    EXPECT_NEAR(spacing->min(), std::sqrt(box.mesh().V()[0]/0.1), 1e-10);
}


TEST_F(SpacingFunction, errorsSayWhatIsValid)
{
    expectError("", {"'spacing'", "fromMesh", "refined", "uniform"});
    expectError("spacing fromMash;", {"fromMash", "fromMesh refined uniform"});
    expectError("spacing -1;", {"-1", "positive"});
    expectError("spacing { type refined; }", {"base"});
    expectError
    (
        "spacing { type refined; base 1; near { hoel { spacing 0.1; } } }",
        {"hoel", "hole"}
    );
    expectError
    (
        "spacing { type refined; base 1; near { hole { spacing 2; } } }",
        {"hole", "2", "base 1"}
    );
    expectError
    (
        "spacing { type refined; base 1; near { hole"
        " { spacing 0.1; growth 2; } } }",
        {"hole", "growth", "1.25"}
    );
    expectError
    (
        "spacing { type refined; base 1; regions { a { type ball; } } }",
        {"ball", "box sphere cylinder"}
    );
    expectError
    (
        "spacing { type refined; base 1; regions { a { type box;"
        " min (0 0 0); max (1 0 1); spacing 0.1; } } }",
        {"Region a", "no extent"}
    );
    expectError("spacing { type fromMesh; min 2; max 1; }", {"min 2", "max 1"});
    for (const std::string group : {"near", "regions"})
    {
        expectError
        (
            "spacing { type refined; base 1; " + group + " { hole 2; } }",
            {"Entry hole of " + group, "not a dictionary", "'spacing'"}
        );
    }
}


// ************************************************************************* //
