/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "testCase.H"
#include "commonFields.H"
#include "comparisonControls.H"
#include "comparisonPictures.H"
#include "fieldComparison.H"
#include "fieldNorms.H"
#include "lineProfile.H"
#include "meshSlice.H"
#include "OSspecific.H"
#include "particleVtp.H"
#include "StringStream.H"
#include "virtualDisplay.H"

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

std::string content(const fileName& file)
{
    std::ifstream is(file, std::ios::binary);
    return std::string
    (
        std::istreambuf_iterator<char>(is),
        std::istreambuf_iterator<char>()
    );
}


bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}


//- The absolute or relative value of a norm, -1 if it is not listed
scalar value
(
    const fieldNorms& norms,
    const word& component,
    const word& name,
    const bool relative = false
)
{
    for (const fieldNorms::norm& n : norms.norms())
    {
        if (n.component == component && n.name == name)
        {
            return relative ? n.relative : n.absolute;
        }
    }
    return -1;
}


volScalarField linearField(const fvMesh& mesh, const vector& gradient)
{
    volScalarField field
    (
        IOobject("f", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("f", dimless, 0)
    );
    field = mesh.C() & dimensionedVector("g", dimless/dimLength, gradient);
    return field;
}


//- A volField file of the default 2-D test case
std::string fieldFile
(
    const std::string& dimensions,
    const std::string& value,
    const std::string& patch
)
{
    return
        "dimensions [" + dimensions + "]; internalField uniform " + value
      + "; boundaryField { \"(left|right|bottom|top)\" { " + patch
      + " } frontAndBack { type empty; } }";
}


//- Area of the polygons of a slice
scalar area(const meshSlice& slice)
{
    scalar sum = 0;
    for (const face& f : slice.polygons())
    {
        sum += f.mag(slice.points());
    }
    return sum;
}


dictionary dictionaryOf(const std::string& text)
{
    IStringStream is(text);
    return dictionary(is);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST(FieldNorms, areTheIntegralsOfTheDifference)
{
    // Difference x on [0, 1] in n cells that grow geometrically
    const label n = 200;
    scalarField V(n);
    scalarField x(n);
    scalar start = 0;
    forAll(V, i)
    {
        V[i] = std::pow(1.01, i);
    }
    V /= sum(V);
    forAll(x, i)
    {
        x[i] = start + 0.5*V[i];
        start += V[i];
    }

    fieldNorms norms;
    norms.add<scalar>("p", labelList(), V, 3 - 3*x, 3 - 2*x);

    // The midpoint rule is exact for x, and misses sum V^3/12 of x^2
    EXPECT_NEAR(value(norms, "value", "L1"), 0.5, 1e-14);
    EXPECT_NEAR
    (
        value(norms, "value", "L2"),
        std::sqrt(1.0/3 - sum(pow3(V))/12),
        1e-14
    );
    EXPECT_NEAR(value(norms, "value", "Linf"), 1 - 0.5*V.last(), 1e-14);

    const scalar range = 2*(x.last() - x.first());
    EXPECT_NEAR(norms.norms()[0].range, range, 1e-14);
    EXPECT_NEAR(value(norms, "value", "L1", true), 0.5/range, 1e-14);
}


TEST(FieldNorms, ofVectorsListComponentsAndTheMagnitudeOfTheDifference)
{
    const scalarField V(2, 1);
    vectorField reference(2, vector(1, 0, 0));
    reference[1] = vector(0, 3, 0);
    vectorField field(reference);
    field[0] += vector(3, -4, 0);

    fieldNorms norms;
    norms.add<vector>("U", labelList({0, 1}), V, field, reference);

    EXPECT_EQ(value(norms, "x", "Linf"), 3);
    EXPECT_EQ(value(norms, "y", "L1"), 2);
    EXPECT_EQ(value(norms, "mag", "Linf"), 5);
    EXPECT_EQ(value(norms, "mag", "Linf", true), 2.5);
    EXPECT_EQ(value(norms, "z", "Linf"), -1);
}


TEST(FieldNorms, neverDivideByTheRangeOfAUniformReference)
{
    const scalarField V(3, 1);

    fieldNorms uniform;
    uniform.add<scalar>
    (
        "p", labelList(), V, scalarField(3, 4.5), scalarField(3, 5)
    );
    EXPECT_NEAR(value(uniform, "value", "L2", true), 0.1, 1e-14);

    fieldNorms zero;
    zero.add<scalar>("p", labelList(), V, scalarField(3, 0), scalarField(3, 0));
    EXPECT_EQ(value(zero, "value", "L2", true), 0);

    fieldNorms fromZero;
    fromZero.add<scalar>
    (
        "p", labelList(), V, scalarField(3, 1), scalarField(3, 0)
    );
    EXPECT_TRUE(std::isinf(value(fromZero, "value", "L2", true)));

    // A component that is zero but for round-off
    vectorField reference(3, vector(2, 0, 0));
    reference[1].z() = 1e-17;
    fieldNorms thin;
    thin.add<vector>
    (
        "U", labelList({2}), V, vectorField(3, vector(2, 0, 0.1)), reference
    );
    EXPECT_NEAR(value(thin, "z", "L1", true), 0.05, 1e-14);
}


TEST(FieldNorms, areWrittenAsFixedColumns)
{
    testCase box(testCase::layout{});
    fieldNorms norms;
    norms.add<scalar>
    (
        "p", labelList(), scalarField(2, 1), scalarField(List<scalar>({1, 2})),
        scalarField(List<scalar>({0, 2}))
    );

    const fileName file(box.path()/"postProcessing"/"norms.csv");
    norms.write(file);

    EXPECT_EQ
    (
        content(file),
        "field,component,norm,absolute,relative,reference_range,relative_l2\n"
        "p,value,L1,0.5,0.25,2,0.35355339\n"
        "p,value,L2,0.70710678,0.35355339,2,0.5\n"
        "p,value,Linf,1,0.5,2,0.70710678\n"
    );
}


TEST(MeshSlice, hasTheAreaOfThePlaneInTheMesh)
{
    testCase::layout layout;
    layout.nCells = labelVector(6, 4, 5);
    layout.box = boundBox(point(0, 0, 0), point(3, 2, 1));
    layout.twoD = false;
    layout.hole = boundBox(point(1, 0.4, 0.25), point(2, 1.6, 0.75));
    testCase box(layout);
    const fvMesh& mesh = box.mesh();

    // Between mesh points, and on them through the hole of 2 x 2 x 3 cells
    // of 0.5 x 0.5 x 0.2
    const meshSlice between(mesh, point(0, 0, 0.05), vector(0, 0, 1));
    EXPECT_NEAR(area(between), 6, 1e-12);
    EXPECT_EQ(between.polygons().size(), 24);

    const meshSlice on(mesh, point(0, 1, 0), vector(0, 1, 0));
    EXPECT_NEAR(area(on), 3 - 1*0.6, 1e-12);
    EXPECT_EQ(on.rightName(), "x");
    EXPECT_EQ(on.upName(), "z");

    // A corner cut off: an equilateral triangle of edge sqrt(2)/2
    const meshSlice corner(mesh, point(0.5, 0, 0), vector(1, 1, 1));
    EXPECT_NEAR(area(corner), std::sqrt(3.0)/8, 1e-12);
    EXPECT_EQ(corner.rightName(), "distance");
}


TEST(MeshSlice, seesXToTheRightAndYUpwards)
{
    testCase::layout layout;
    layout.box = boundBox(point(-1, 2, 0), point(1, 3, 0.1));
    testCase box(layout);

    for (const scalar side : {1, -1})
    {
        const meshSlice slice
        (
            box.mesh(), point(0, 0, 0.05), vector(0, 0, side)
        );
        EXPECT_LT(mag(slice.bounds().min() - point(-1, 2, 0)), 1e-14);
        EXPECT_LT(mag(slice.bounds().max() - point(1, 3, 0)), 1e-14);
    }
}


TEST(MeshSlice, interpolatesLinearFieldsExactlyInside)
{
    testCase::layout layout;
    layout.nCells = labelVector(10, 10, 10);
    layout.box = boundBox(point(0, 0, 0), point(1, 1, 1));
    layout.twoD = false;
    testCase box(layout);

    const vector gradient(1, -2, 3);
    const vector normal(1, 2, 2);
    const meshSlice slice(box.mesh(), point(0.5, 0.5, 0.5), normal);
    const scalarField values
    (
        slice.interpolate(linearField(box.mesh(), gradient))
    );

    // Inside the outermost cells, on whose boundary faces the field has
    // values of its own
    label nInside = 0;
    const vector n(normal/3);
    const vector u(normalised(vector(1, 0, 0) - n.x()*n));
    const vector r(u ^ n);
    forAll(values, i)
    {
        // Back to space
        const point p
        (
            slice.points()[i].x()*r + slice.points()[i].y()*u
          + (n & point(0.5, 0.5, 0.5))*n
        );

        if (cmptMin(p) > 0.1 && cmptMax(p) < 0.9)
        {
            EXPECT_NEAR(values[i], gradient & p, 1e-12);
            ++nInside;
        }
    }
    EXPECT_GT(nInside, 20);
}


TEST(LineProfile, samplesLinearFieldsAndLeavesHolesOut)
{
    testCase::layout layout;
    layout.nCells = labelVector(16, 16, 1);
    layout.hole = boundBox(point(0.4, 0.4, -1), point(0.6, 0.6, 1));
    testCase box(layout);
    const fvMesh& mesh = box.mesh();

    // 4 x 4 cells around the middle are cut out
    const PtrList<lineProfile> lines
    (
        lineProfile::centreLines(mesh, solutionSpace(mesh))
    );
    ASSERT_EQ(lines.size(), 2);
    EXPECT_EQ(lines[0].coordinateName(), "x");
    EXPECT_EQ(lines[1].coordinateName(), "y");

    const scalarField x(lines[0].coordinate());
    EXPECT_EQ(x.size(), 150);
    for (const scalar v : x)
    {
        EXPECT_TRUE(v < 0.375 || v > 0.625);
    }

    const vector gradient(2, 7, 0);
    const scalarField values(lines[0].sample(linearField(mesh, gradient)));
    forAll(values, i)
    {
        if (x[i] > 0.1 && x[i] < 0.25)
        {
            EXPECT_NEAR(values[i], gradient & lines[0].points()[i], 1e-12);
        }
    }
}


TEST(LineProfile, withoutPointsInTheMeshIsAnError)
{
    testCase box(testCase::layout{});
    const std::string message
    (
        errorMessage
        (
            [&]
            {
                lineProfile
                (
                    "far", box.mesh(), solutionSpace(box.mesh()),
                    dictionaryOf("start (5 5 0); end (6 6 0);")
                );
            }
        )
    );
    EXPECT_TRUE(contains(message, "Line far")) << message;
    EXPECT_TRUE(contains(message, "no point inside the mesh")) << message;

    const std::string onePoint
    (
        errorMessage
        (
            [&]
            {
                lineProfile
                (
                    "short", box.mesh(), solutionSpace(box.mesh()),
                    dictionaryOf("start (0 0 0); end (1 1 0); nPoints 1;")
                );
            }
        )
    );
    EXPECT_TRUE(contains(onePoint, "nPoints of line short is 1")) << onePoint;
    EXPECT_TRUE(contains(onePoint, "2 or more")) << onePoint;
}


TEST(CommonFields, namesTheTimesOfBothMethodsWhereNoneIsCommon)
{
    testCase box(testCase::layout{});
    const std::string p(fieldFile("0 2 -2 0 0 0 0", "1", "type zeroGradient;"));
    box.write("1/p", p, "volScalarField");
    box.write("2/p", p, "volScalarField");
    box.write("3/p.sph", p, "volScalarField");

    const referenceCase reference(box.mesh());
    const std::string message
    (
        errorMessage([&] { commonFields(box.mesh(), reference, wordRes()); })
    );
    EXPECT_TRUE(contains(message, "at times: 1 2")) << message;
    EXPECT_TRUE(contains(message, "at times: 3")) << message;

    // Fields of a phase have a group of their own
    box.write("2/p.sph", p, "volScalarField");
    box.write("2/T.air", p, "volScalarField");
    box.write("2/T.air.sph", p, "volScalarField");
    const commonFields common(box.mesh(), reference, wordRes());
    EXPECT_EQ(commonFields::names(common.times()), "2");
    EXPECT_EQ(commonFields::names(common.fvmOnly()), "1");
    EXPECT_EQ(commonFields::names(common.sphOnly()), "3");
    EXPECT_EQ(common.fields(common.times()[0]), wordList({"T.air", "p"}));

    const std::string noMatch
    (
        errorMessage
        (
            [&]
            {
                commonFields
                (
                    box.mesh(), reference, wordRes(List<wordRe>({wordRe("T")}))
                );
            }
        )
    );
    EXPECT_TRUE(contains(noMatch, "that match")) << noMatch;
}


TEST(CommonFields, areThoseOfTimesThatDifferByRoundOffOnly)
{
    const std::string p(fieldFile("0 2 -2 0 0 0 0", "1", "type zeroGradient;"));
    testCase box(testCase::layout{});
    box.write("1/p.sph", p, "volScalarField");

    // Nearly all steps of a run end some units of round-off beside a time
    testCase equal(testCase::layout{});
    equal.write("1.0000000001/p", p, "volScalarField");
    const referenceCase same(box.mesh(), equal.path());
    const commonFields common(box.mesh(), same, wordRes());
    EXPECT_EQ(commonFields::names(common.times()), "1");

    testCase next(testCase::layout{});
    next.write("1.0001/p", p, "volScalarField");
    const referenceCase other(box.mesh(), next.path());
    EXPECT_TRUE
    (
        contains
        (
            errorMessage([&] { commonFields(box.mesh(), other, wordRes()); }),
            "No time has fields to compare"
        )
    );
}


TEST(CommonFields, ofDifferentTypesAreAnError)
{
    testCase box(testCase::layout{});
    box.write("1/p", fieldFile("0 0 0 0 0 0 0", "1", ""), "volScalarField");
    box.write
    (
        "1/p.sph", fieldFile("0 0 0 0 0 0 0", "(1 0 0)", ""), "volVectorField"
    );

    const referenceCase reference(box.mesh());
    const std::string message
    (
        errorMessage([&] { commonFields(box.mesh(), reference, wordRes()); })
    );
    EXPECT_TRUE(contains(message, "p is a volScalarField")) << message;
    EXPECT_TRUE(contains(message, "p.sph is a volVectorField")) << message;
}


TEST(FieldComparison, removesTheLevelOfAPressureThatNothingFixes)
{
    testCase box(testCase::layout{});
    const std::string dimensions("0 2 -2 0 0 0 0");
    const std::string free("type zeroGradient;");
    const std::string fixed("type fixedValue; value uniform 0;");

    const auto error = [&](const std::string& patches)
    {
        box.write("1/p", fieldFile(dimensions, "1", patches), "volScalarField");
        box.write
        (
            "1/p.sph", fieldFile(dimensions, "4", patches), "volScalarField"
        );

        const referenceCase reference(box.mesh());
        const fieldComparison comparison
        (
            box.mesh(), reference, instant(1, "1"), wordList({"p"})
        );
        EXPECT_EQ(comparison.remarks().empty(), patches == fixed);
        EXPECT_EQ(comparison.quantities().size(), 1);
        return value(comparison.norms(), "value", "Linf");
    };

    EXPECT_EQ(error(fixed), 3);
    EXPECT_NEAR(error(free), 0, 1e-14);
}


TEST(FieldComparison, ofDifferentDimensionsIsAnError)
{
    testCase box(testCase::layout{});
    const std::string patch("type zeroGradient;");
    box.write
    (
        "1/p", fieldFile("0 2 -2 0 0 0 0", "1", patch), "volScalarField"
    );
    box.write
    (
        "1/p.sph", fieldFile("1 -1 -2 0 0 0 0", "1", patch), "volScalarField"
    );

    const referenceCase reference(box.mesh());
    const std::string message
    (
        errorMessage
        (
            [&]
            {
                fieldComparison
                (
                    box.mesh(), reference, instant(1, "1"), wordList({"p"})
                );
            }
        )
    );
    EXPECT_TRUE(contains(message, "the dimensions of p")) << message;
}


TEST(ReferenceCase, onAnotherMeshGivesLinearFieldsExactly)
{
    testCase box(testCase::layout{});

    testCase::layout layout;
    layout.nCells = labelVector(21, 5, 1);
    testCase other(layout);
    other.write
    (
        "system/controlDict",
        "deltaT 1; endTime 1; writeInterval 1; writeControl timeStep;"
        " startTime 0; stopAt endTime; startFrom startTime;"
    );
    volScalarField f(linearField(other.mesh(), vector(2, 3, 0)));
    f.rename("p");
    other.time().setTime(instant(1, "1"), 1);
    f.instance() = "1";
    ASSERT_TRUE(f.write());

    const referenceCase reference(box.mesh(), other.path());
    const tmp<volScalarField> tp
    (
        reference.read
        (
            "p", instant(1, "1"), linearField(box.mesh(), vector(0, 0, 0))
        )
    );

    // Written with six digits
    const scalarField expected
    (
        linearField(box.mesh(), vector(2, 3, 0)).primitiveField()
    );
    EXPECT_LT(max(mag(tp().primitiveField() - expected)), 1e-5);
}


TEST(ReferenceCase, thatIsNoCaseIsAnError)
{
    testCase box(testCase::layout{});
    const std::string message
    (
        errorMessage([&] { referenceCase(box.mesh(), "/nowhere/at/all"); })
    );
    EXPECT_TRUE(contains(message, "/at/all\" is not a case")) << message;

    testCase::layout layout;
    layout.twoD = false;
    testCase cube(layout);
    const std::string dimensions
    (
        errorMessage([&] { referenceCase(box.mesh(), cube.path()); })
    );
    EXPECT_TRUE(contains(dimensions, cube.path() + "\" has 3")) << dimensions;
    EXPECT_TRUE(contains(dimensions, "the case 2")) << dimensions;
}


TEST(ComparisonControls, nameWrongEntriesAndValidChoices)
{
    const auto message = [](const std::string& text)
    {
        return errorMessage
        (
            [&]
            {
                const comparisonControls controls(dictionaryOf(text));
                scalar lowest = 0;
                scalar highest = 1;
                controls.limit("p", lowest, highest);
            }
        );
    };

    EXPECT_EQ(message(""), "");
    EXPECT_EQ(message("fields (U p); ranges { p (-1 2); }"), "");
    EXPECT_TRUE(contains(message("contour 3;"), "contour"));
    EXPECT_TRUE(contains(message("contour 3;"), "contours"));
    EXPECT_TRUE(contains(message("contours -1;"), "0 or more"));
    EXPECT_TRUE
    (
        contains(message("lines { a { begin (0 0 0); } }"), "end nPoints")
    );
    EXPECT_TRUE
    (
        contains(message("views { a { center (0 0 0); } }"), "max normal")
    );
    EXPECT_TRUE(contains(message("ranges { p (2 2); }"), "lowest highest"));
}


TEST(ComparisonPictures, showEveryFieldAndNameAPlaneOutsideTheMesh)
{
    testCase box(testCase::layout{});
    box.write
    (
        "1/U", fieldFile("0 1 -1 0 0 0 0", "(1 0 0)", "type zeroGradient;"),
        "volVectorField"
    );
    box.write
    (
        "1/U.sph", fieldFile("0 1 -1 0 0 0 0", "(1 0 0)", "type zeroGradient;"),
        "volVectorField"
    );

    const solutionSpace space(box.mesh());
    const auto message = [&](const std::string& views)
    {
        const comparisonControls controls(dictionaryOf(views));
        return errorMessage
        (
            [&] { comparisonPictures(box.mesh(), space, controls, nullptr); }
        );
    };
    EXPECT_EQ(message("views { all {} }"), "");
    EXPECT_TRUE
    (
        contains
        (
            message("views { far { min (7 7 0); max (8 8 0); } }"),
            "min and max of view far"
        )
    );
    const virtualDisplay display;
    if (!virtualDisplay::available())
    {
        GTEST_SKIP() << "no X server, Xvfb is not installed";
    }

    const comparisonControls controls(dictionaryOf(""));
    const comparisonPictures pictures(box.mesh(), space, controls, nullptr);
    const referenceCase reference(box.mesh());
    const fieldComparison comparison
    (
        box.mesh(), reference, instant(1, "1"), wordList({"U"})
    );
    const DynamicList<fileName> files(pictures.write(comparison, box.path()));

    ASSERT_EQ(files.size(), 1);
    EXPECT_EQ(files[0], box.path()/"U.png");
    const std::string png(content(files[0]));
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");

    // More than an empty white picture has
    EXPECT_GT(png.size(), 10000u);
}


TEST(ComparisonPictures, planesThatAreNoneAreNamed)
{
    testCase::layout layout;
    layout.twoD = false;
    testCase cube(layout);
    const solutionSpace space(cube.mesh());
    const auto message = [&](const std::string& view)
    {
        const comparisonControls controls
        (
            dictionaryOf("views { side {" + view + "} }")
        );
        return errorMessage
        (
            [&] { comparisonPictures(cube.mesh(), space, controls, nullptr); }
        );
    };

    const std::string flat(message("origin (0 0 0); normal (0 0 0);"));
    EXPECT_TRUE(contains(flat, "normal of view side is (0 0 0)")) << flat;
    const std::string off(message("origin (9 0 0); normal (1 0 0);"));
    EXPECT_TRUE(contains(off, "plane of view side, origin (9 0 0)")) << off;
}


TEST(ParticleVtp, refusesFieldsOfAnotherSize)
{
    testCase box(testCase::layout{});
    const fileName file(box.path()/"particles.vtp");

    particleVtp wrong(file);
    wrong.add("V", scalarField(3, 1.0));
    const std::string message
    (
        errorMessage([&] { wrong.write(pointField(2, point(Zero))); })
    );
    EXPECT_TRUE(contains(message, "Field V has 3 values")) << message;
    EXPECT_FALSE(isFile(file));

    particleVtp right(file);
    right.add("V", scalarField(2, 1.0));
    right.add("U", vectorField(2, vector(1, 2, 3)));
    right.add("body", labelList(2, 7));
    right.write(pointField(2, point(Zero)));
    const std::string xml(content(file));
    EXPECT_TRUE(contains(xml, "NumberOfPoints=\"2\""));
    EXPECT_TRUE(contains(xml, "Name=\"U\" NumberOfComponents=\"3\""));
}

// ************************************************************************* //
