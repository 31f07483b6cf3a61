/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "testCase.H"
#include "colourMap.H"
#include "htmlReport.H"
#include "linePlot.H"
#include "tickMarks.H"
#include "unitText.H"

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST(TickMarks, areRoundNumbersInTheRange)
{
    const scalar ranges[][2] =
    {
        {0, 1}, {-3, 7}, {0.01, 0.012}, {-2e6, 5e7}, {1e-9, 3e-9},
        {101325, 101326}, {-0.73, -0.11}
    };

    for (const auto& range : ranges)
    {
        for (const label n : {3, 6, 10})
        {
            const tickMarks ticks(range[0], range[1], n);
            const scalarList& v = ticks.values();
            const scalar slack = 1e-6*(range[1] - range[0]);

            ASSERT_GE(v.size(), 1) << range[0] << ' ' << range[1];
            EXPECT_LE(v.size(), n + 1);
            EXPECT_GE(v.first(), range[0] - slack);
            EXPECT_LE(v.last(), range[1] + slack);

            for (label i = 1; i < v.size(); ++i)
            {
                const scalar step = v[i] - v[i - 1];
                const scalar mantissa =
                    step/std::pow(10, std::floor(std::log10(step*1.0001)));
                EXPECT_TRUE
                (
                    mag(mantissa - 1) < 1e-3
                 || mag(mantissa - 2) < 1e-3
                 || mag(mantissa - 5) < 1e-3
                ) << mantissa;
                EXPECT_NE(ticks.label(v[i]), ticks.label(v[i - 1]));
                EXPECT_NEAR(std::stod(ticks.label(v[i])), v[i], 1e-3*step);
            }
        }
    }
}


TEST(TickMarks, includeTheEndsWhateverRoundOffThereIs)
{
    // In doubles 3*0.1 is above 0.3
    const tickMarks ticks(0, 0.3, 3);
    ASSERT_EQ(ticks.values().size(), 4);
    EXPECT_EQ(ticks.label(ticks.values()[3]), "0.3");
}


TEST(TickMarks, ofOneValueIsThatValue)
{
    EXPECT_EQ(tickMarks(3, 3, 5).values(), scalarList(1, scalar(3)));
    EXPECT_EQ(tickMarks(0, 0, 5).values(), scalarList(1, scalar(0)));
}


TEST(TickMarks, labelZeroAloneInARangeOfRoundOff)
{
    EXPECT_EQ(tickMarks(-7e-21, 8e-21, 2).label(0), "0e+00");
}


TEST(TickMarks, haveNoNegativeZero)
{
    const tickMarks ticks(-1e-12, 1, 5);
    EXPECT_EQ(ticks.label(ticks.values().first()), "0.0");
}


TEST(ColourMap, endsAreDistinctAndValuesOutsideAreTheEnds)
{
    for (const auto t : {colourMap::sequential, colourMap::diverging})
    {
        const colourMap colours(t);
        EXPECT_EQ(colours(-1), colours(0));
        EXPECT_EQ(colours(2), colours(1));
        EXPECT_GT(mag(colours(0) - colours(1)), 0.3);

        for (label i = 0; i <= 100; ++i)
        {
            const vector c(colours(i/100.0));
            EXPECT_GE(cmptMin(c), 0);
            EXPECT_LE(cmptMax(c), 1);
        }
    }

    // Lightness grows along the sequential colours
    const colourMap sequential(colourMap::sequential);
    const vector luminance(0.2126, 0.7152, 0.0722);
    for (label i = 0; i < 20; ++i)
    {
        EXPECT_LT
        (
            luminance & sequential(i/20.0), luminance & sequential((i + 1)/20.0)
        );
    }
}


TEST(UnitText, readsAsUnitsAreWritten)
{
    EXPECT_EQ(unitText(dimless), "-");
    EXPECT_EQ(unitText(dimVelocity), "m/s");
    EXPECT_EQ(unitText(dimPressure), "Pa");
    EXPECT_EQ(unitText(dimPressure*dimTime), "kg/(m s)");
    EXPECT_EQ(unitText(dimPressure/dimDensity), "m\u00b2/s\u00b2");
    EXPECT_EQ(unitText(dimDensity), "kg/m\u00b3");
    EXPECT_EQ(unitText(dimTemperature), "K");
    EXPECT_EQ(unitText(dimless/dimTime), "1/s");
}


TEST(LinePlot, breaksLinesAtGapsAndEscapesText)
{
    linePlot plot("a < b & c", "x", "y", 1.5);
    plot.add
    (
        {"one", List<scalar>({0, 1, 5, 6}), scalarField(4, 2.0), ""}
    );
    const std::string svg(plot.svg());

    EXPECT_NE(svg.find("a &lt; b &amp; c"), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos);

    // Two pieces of the curve and its sample in the legend
    const std::size_t start = svg.find("<path fill");
    const std::string path(svg.substr(start, svg.find("/>", start) - start));
    EXPECT_EQ(std::count(path.begin(), path.end(), 'M'), 3);
    EXPECT_EQ(std::count(path.begin(), path.end(), 'L'), 2);
}


TEST(HtmlReport, isOneFileWithThePicturesInIt)
{
    testCase box(testCase::layout{});
    const fileName picture(box.path()/"a.png");
    std::ofstream(picture) << "Man";

    htmlReport report("x < y");
    report.heading("numbers");
    report.table({"name", "value"}, {{"a", "1"}, {"b", "2"}}, 1);
    report.picture(picture, "a");
    const fileName file(box.path()/"deep"/"report.html");
    report.write(file);

    std::ifstream is(file);
    const std::string html
    (
        (std::istreambuf_iterator<char>(is)), std::istreambuf_iterator<char>()
    );

    // RFC 4648: Man is TWFu
    EXPECT_NE(html.find("data:image/png;base64,TWFu\""), std::string::npos);
    EXPECT_NE(html.find("<title>x &lt; y</title>"), std::string::npos);
    EXPECT_NE
    (
        html.find("<td>b</td><td class=\"number\">2</td>"), std::string::npos
    );
    EXPECT_EQ(html.find("src=\"http"), std::string::npos);
}

// ************************************************************************* //
