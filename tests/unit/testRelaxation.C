/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    Particle generation on meshes: what the relaxed particles must fulfil, by
    measures computed here from pairs found by another search.

\*---------------------------------------------------------------------------*/

#include "volFields.H"
#include "mathematicalConstants.H"
#include "testCase.H"
#include "particleGenerator.H"
#include "particlePairs.H"
#include "periodicImages.H"

#include <gtest/gtest.h>
#include <omp.h>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

dictionary sphMeshDict(const std::string& content)
{
    IStringStream is(content);
    return dictionary(is);
}


//- A square of side 4 with a circular hole of radius 1
testCase::layout cylinder()
{
    testCase::layout l;
    l.nCells = labelVector(40, 40, 1);
    l.box = boundBox(point(-2, -2, 0), point(2, 2, 0.1));
    l.hole = boundBox(point(-1.01, -1.01, -1), point(1.01, 1.01, 1));
    l.transform = [](const point& p)
    {
        const scalar m = max(mag(p.x()), mag(p.y()));
        const scalar r = std::sqrt(sqr(p.x()) + sqr(p.y()));
        const scalar s = m < 1 ? 1 : 2 - m;
        const scalar f = r < VSMALL ? 1 : s*m/r + 1 - s;
        return point(f*p.x(), f*p.y(), p.z());
    };
    return l;
}


//- Kernel gradient sums |S_i| dp_i of the fluid with the solids as contact
//- particles ([R] eq. 13), and distances, of generated particles
struct measures
{
    scalarField residual;
    scalarField depth;
    scalar minDistance = GREAT;

    measures(const fvMesh& mesh, const particleGenerator& generator)
    {
        const solutionSpace space(mesh);
        const kernel& W = generator.W();
        const label nFluid = generator.fluid().points.size();

        vectorField points;
        scalarField spacing;
        const auto append = [&](const particleSet& set)
        {
            for (label i = 0; i < set.points.size(); ++i)
            {
                points.append(space.toLocal(set.points[i]));
                spacing.append(set.spacing[i]);
            }
        };
        append(generator.fluid());
        for (const particleSet& set : generator.solids())
        {
            append(set);
        }

        List<vector> translations;
        for (const vector& T : periodicTranslations(mesh))
        {
            translations.append(space.toLocal(T));
        }

        scalarField radius(W.support(1)*spacing);
        const particlePairs pairs
        (
            points, radius, imageOffsets(translations)
        );

        vectorField sums(points.size(), Zero);
        for (label k = 0; k < pairs.size(); ++k)
        {
            const label i = pairs.owner[k];
            const label j = pairs.neighbour[k];
            const scalar r = mag(pairs.delta[k]);
            const scalar ratio = W.smoothingRatio();
            const vector g
            (
                -0.5*pairs.delta[k]/r
               *(W.dWdr(r, ratio*spacing[i]) + W.dWdr(r, ratio*spacing[j]))
            );
            sums[i] += kernel::integerPow(spacing[j], W.nDims())*g;
            sums[j] -= kernel::integerPow(spacing[i], W.nDims())*g;

            if (i < nFluid || j < nFluid)
            {
                minDistance =
                    min(minDistance, 2*r/(spacing[i] + spacing[j]));
            }
        }

        residual.setSize(nFluid);
        depth.setSize(nFluid);
        for (label i = 0; i < nFluid; ++i)
        {
            residual[i] = mag(sums[i])*spacing[i];
            depth[i] =
               -generator.fluidDistance().distance
                (
                    generator.fluid().points[i]
                )/spacing[i];
        }
    }
};


scalar volumeOf(const fvMesh& mesh, const particleSet& set)
{
    const solutionSpace space(mesh);
    scalar V = 0;
    for (const scalar dp : set.spacing)
    {
        V += space.volume(dp);
    }
    return V;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST(Relaxation, boxOfWholeCellsIsLeftAsItIs)
{
    testCase box(testCase::layout{});
    particleGenerator generator(box.mesh(), sphMeshDict("spacing 0.05;"));
    generator.generate();

    const pointField& points = generator.fluid().points;
    ASSERT_EQ(points.size(), 400);
    for (const point& p : points)
    {
        for (direction d = 0; d < 2; ++d)
        {
            const scalar site = p[d]/0.05 - 0.5;
            EXPECT_NEAR(site, round(site), 1e-9);
        }
    }
}


TEST(Relaxation, boxThatCellsDoNotFitIsFilledExactly)
{
    for (const char* lattice : {"square", "hexagonal"})
    {
        testCase::layout l;
        l.box = boundBox(point(0, 0, 0), point(1.03, 0.52, 0.1));
        testCase box(l);
        particleGenerator generator
        (
            box.mesh(),
            sphMeshDict("spacing 0.05; lattice " + std::string(lattice) + ";")
        );
        generator.generate();

        EXPECT_NEAR
        (
            volumeOf(box.mesh(), generator.fluid())/gSum(box.mesh().V()),
            1,
            1e-12
        );
        const measures m(box.mesh(), generator);
        EXPECT_GT(min(m.depth), 0.4);
        EXPECT_GT(m.minDistance, 0.85);
    }
}


TEST(Relaxation, cylinderIsBodyFittedAndInEquilibrium)
{
    testCase square(cylinder());
    particleGenerator generator
    (
        square.mesh(),
        sphMeshDict("spacing 0.1; relaxation { tolerance 1e-3; }")
    );
    generator.generate();

    ASSERT_EQ(generator.solids().size(), 1);
    EXPECT_NEAR
    (
        volumeOf(square.mesh(), generator.fluid())/gSum(square.mesh().V()),
        1,
        0.01
    );

    const measures m(square.mesh(), generator);
    EXPECT_GT(m.minDistance, 0.8);
    EXPECT_GT(min(m.depth), 0.3);

    label n = 0;
    scalar sum = 0;
    scalar largest = 0;
    scalar sumDepth = 0;
    forAll(m.depth, i)
    {
        if (mag(generator.fluid().points[i]) < 1.1)
        {
            ++n;
            sum += m.residual[i];
            sumDepth += m.depth[i];
            largest = max(largest, m.residual[i]);
        }
    }

    // The circle of the first layer holds 2 pi (1 + dp/2)/dp = 66 particles
    EXPECT_NEAR(n, 66, 8);
    EXPECT_LT(sum/n, 1e-3);
    EXPECT_LT(largest, 5e-3);
    EXPECT_NEAR(sumDepth/n, 0.5, 0.1);

    // No void next to the circle
    for (label k = 0; k < 720; ++k)
    {
        const scalar angle = k*constant::mathematical::pi/360;
        const point p(1.05*std::cos(angle), 1.05*std::sin(angle), 0.05);
        scalar nearest = GREAT;
        for (const point& q : generator.fluid().points)
        {
            nearest = min(nearest, mag(p - q));
        }
        EXPECT_LT(nearest, 0.092);
    }

    const auto& history = generator.monitor().history();
    EXPECT_LE(history.last().maxResidual, 0.02);
    EXPECT_LT(history.last().kineticEnergy, 1e-3);
    EXPECT_NEAR(history.first().kineticEnergy, 1, 1e-12);
}


TEST(Relaxation, stopsWhenItsMeanResidualIsLow)
{
    testCase square(cylinder());
    particleGenerator generator(square.mesh(), sphMeshDict("spacing 0.1;"));
    generator.generate();

    const auto& history = generator.monitor().history();
    EXPECT_LE(history.last().rmsResidual, 2e-3);
    EXPECT_GT(history.last().relativeResidual, 1);
    EXPECT_LT(history.size(), 500);

    const measures m(square.mesh(), generator);
    EXPECT_GT(m.minDistance, 0.7);
    EXPECT_GT(min(m.depth), 0.25);
}


TEST(Relaxation, complexBeatsSeparateAtTheInterface)
{
    testCase square(cylinder());

    const auto interfaceResidual = [&](const word& type)
    {
        particleGenerator generator
        (
            square.mesh(),
            sphMeshDict("spacing 0.1; relaxation { type " + type + "; }")
        );
        generator.generate();
        const measures m(square.mesh(), generator);

        label n = 0;
        scalar sum = 0;
        forAll(m.depth, i)
        {
            if (mag(generator.fluid().points[i]) < 1.1)
            {
                ++n;
                sum += m.residual[i];
            }
        }
        return sum/n;
    };

    EXPECT_LT(10*interfaceResidual("complex"), interfaceResidual("separate"));
}


TEST(Relaxation, irregularPeriodicBoxComesToRest)
{
    testCase box(testCase::layout{});
    box.write
    (
        "constant/polyMesh/boundary",
        "5 (left { type cyclic; neighbourPatch right; nFaces 8;"
        "startFace 112; }"
        "right { type cyclic; neighbourPatch left; nFaces 8; startFace 120; }"
        "bottom { type cyclic; neighbourPatch top; nFaces 8; startFace 128; }"
        "top { type cyclic; neighbourPatch bottom; nFaces 8; startFace 136; }"
        "frontAndBack { type empty; nFaces 128; startFace 144; })",
        "polyBoundaryMesh"
    );
    const fileName caseName(box.path().name());
    Time time(Time::controlDictName, box.path().path(), caseName);
    const fvMesh mesh
    (
        IOobject
        (
            fvMesh::defaultRegion,
            time.constant(),
            time,
            IOobject::MUST_READ
        )
    );

    particleGenerator generator
    (
        mesh,
        sphMeshDict
        (
            "spacing 0.05; kernel { smoothingRatio 1.3; }"
            "lattice { type square; jitter 0.3; seed 3; }"
            "relaxation { tolerance 1e-3; }"
        )
    );
    generator.generate();

    const measures m(mesh, generator);
    EXPECT_EQ(m.residual.size(), 400);
    EXPECT_LT(max(m.residual), 1.5e-3);
    EXPECT_GT(m.minDistance, 0.8);

    // The start was irregular: few particles are on sites of the lattice
    label nSites = 0;
    for (const point& p : generator.fluid().points)
    {
        const scalar x = p.x()/0.05 - 0.5;
        nSites += mag(x - round(x)) < 0.02;
    }
    EXPECT_LT(nSites, 200);
}


TEST(Relaxation, periodsMayPointDownwards)
{
    // Rotated, so that the first patch of each pair is on the high side
    testCase::layout turned;
    turned.periodic = {true, true, false};
    turned.transform = [](const point& p)
    {
        return point(-p.x(), -p.y(), p.z());
    };
    testCase box(turned);
    particleGenerator generator(box.mesh(), sphMeshDict("spacing 0.125;"));
    generator.generate();

    const particleSet& fluid = generator.fluid();
    ASSERT_EQ(fluid.points.size(), 64);
    EXPECT_NEAR(max(fluid.density)/min(fluid.density), 1, 1e-12);
    for (const point& p : fluid.points)
    {
        EXPECT_TRUE(box.mesh().bounds().contains(p)) << p.x() << " " << p.y();
    }
}


TEST(Relaxation, variableSpacingIsAchieved)
{
    testCase square(cylinder());
    particleGenerator generator
    (
        square.mesh(),
        sphMeshDict
        (
            "spacing { type refined; base 0.3;"
            "near { hole { spacing 0.08; growth 1.08; } } }"
            "kernel { smoothingRatio 1.3; }"
            "relaxation { tolerance 1e-3; }"
        )
    );
    generator.generate();

    const measures m(square.mesh(), generator);

    // Out of reach of the outer boundary, where the measure has no support
    forAll(m.residual, i)
    {
        if (mag(generator.fluid().points[i]) < 1.3)
        {
            EXPECT_LT(m.residual[i], 5e-3);
        }
    }
    EXPECT_GT(m.minDistance, 0.7);
    EXPECT_GT(min(m.depth), 0.3);
    EXPECT_NEAR
    (
        volumeOf(square.mesh(), generator.fluid())/gSum(square.mesh().V()),
        1,
        0.01
    );
    EXPECT_LT(min(generator.fluid().spacing), 0.085);
    EXPECT_GT(max(generator.fluid().spacing), 0.15);
}


TEST(Relaxation, resultDoesNotDependOnTheThreads)
{
    testCase square(cylinder());
    const int nThreads = omp_get_max_threads();

    List<pointField> results;
    for (const int n : {1, 2})
    {
        omp_set_num_threads(n);
        particleGenerator generator(square.mesh(), sphMeshDict("spacing 0.1;"));
        generator.generate();
        results.append(generator.fluid().points);
    }
    omp_set_num_threads(nThreads);

    EXPECT_EQ(results[0], results[1]);
}


TEST(Relaxation, skinAndFreezingDoNotChangeTheEquilibrium)
{
    testCase square(cylinder());

    const auto relaxed = [&](const std::string& control)
    {
        particleGenerator generator
        (
            square.mesh(),
            sphMeshDict
            (
                "spacing 0.1; lattice hexagonal;"
                "relaxation { tolerance 1e-4; disturbance 1e-4;" + control + "}"
            )
        );
        generator.generate();
        return generator.fluid().points;
    };

    const pointField reference(relaxed("freeze no; skin 0.3;"));
    const pointField skin(relaxed("freeze no; skin 0.8;"));
    const pointField freeze(relaxed("freeze yes; skin 0.3;"));

    ASSERT_EQ(skin.size(), reference.size());
    ASSERT_EQ(freeze.size(), reference.size());

    // Round-off may turn a step at a surface, after which the ways differ: what
    // is the same is the equilibrium, within the tolerance
    EXPECT_LT(max(mag(skin - reference))/0.1, 1e-4);
    EXPECT_LT(max(mag(freeze - reference))/0.1, 0.05);
}


TEST(ConvergenceMonitor, saysWhatIsLeftAtMost)
{
    convergenceMonitor monitor(1e-3, 0, 50);
    EXPECT_TRUE(monitor.logs(150));
    EXPECT_FALSE(monitor.logs(140));

    convergenceMonitor::record state;
    state.iteration = 150;
    state.kineticEnergy = 3;
    state.maxResidual = 0.01;
    state.relativeResidual = 10;
    monitor.add(state);
    EXPECT_FALSE(monitor.converged());

    // Ever fewer iterations, at whatever rate
    OStringStream os;
    monitor.log(os, 7, 2000);
    const std::string line(os.str());
    EXPECT_NE(line.find("Iteration = 150 "), std::string::npos) << line;
    EXPECT_NE(line.find("left at most = 1850 it"), std::string::npos) << line;

    state.relativeResidual = 0.9;
    state.kineticEnergy = 2e-3;
    monitor.add(state);
    EXPECT_TRUE(monitor.converged());

    // The energy does not matter where it was low from the start
    state.kineticEnergy = 1;
    monitor.add(state);
    EXPECT_FALSE(monitor.converged());
    state.relativeResidual = 0.09;
    monitor.add(state);
    EXPECT_TRUE(monitor.converged());
}


TEST(ConvergenceMonitor, estimatesWhatIsLeftOfAPowerLaw)
{
    // 0.1/iteration gets to 2e-4 at 500, whatever jumps there are
    convergenceMonitor monitor(1e-3, 2e-4, 50);
    for (label iteration = 1; iteration <= 200; ++iteration)
    {
        convergenceMonitor::record state;
        state.iteration = iteration;
        state.kineticEnergy = 1;
        state.relativeResidual = 10;
        state.rmsResidual = iteration % 7 == 3 ? 0.2 : 0.1/iteration;
        monitor.add(state);
    }

    const auto line = [&](const label last)
    {
        OStringStream os;
        monitor.log(os, 7, last);
        return os.str();
    };
    EXPECT_NE(line(2000).find("left about = 300 it"), std::string::npos)
        << line(2000);
    EXPECT_NE(line(400).find("left at most = 200 it"), std::string::npos)
        << line(400);
}


TEST(ConvergenceMonitor, doesNotDivideByRoundOff)
{
    convergenceMonitor monitor(1e-3, 0, 50);
    convergenceMonitor::record state;
    state.kineticEnergy = 5e-29;
    state.maxResidual = 5e-14;
    monitor.add(state);
    EXPECT_EQ(monitor.history().last().kineticEnergy, 0);

    state.kineticEnergy = 9e-8;
    state.maxResidual = 4e-4;
    monitor.add(state);
    EXPECT_EQ(monitor.history().last().kineticEnergy, 1);
}


TEST(Relaxation, badInputIsNamed)
{
    testCase square(cylinder());

    const auto message = [&](const std::string& content)
    {
        return errorMessage
        (
            [&]
            {
                particleGenerator(square.mesh(), sphMeshDict(content))
               .generate();
            }
        );
    };
    const auto contains = [](const std::string& text, const char* word)
    {
        return text.find(word) != std::string::npos;
    };

    EXPECT_TRUE(contains(message("kernel {}"), "'spacing' is missing"));
    EXPECT_TRUE(contains(message("spacing -0.1;"), "is -0.1 but must be"));
    EXPECT_TRUE(contains(message("spacing 5;"), "Body hole has a size"));

    const std::string lattice(message("spacing 0.1; lattice cubes;"));
    EXPECT_TRUE(contains(lattice, "cubes"));
    EXPECT_TRUE(contains(lattice, "hexagonal"));

    const std::string type
    (
        message("spacing 0.1; relaxation { type simple; }")
    );
    EXPECT_TRUE(contains(type, "simple"));
    EXPECT_TRUE(contains(type, "complex"));
    EXPECT_TRUE(contains(type, "gradientDescent"));

    EXPECT_TRUE
    (
        contains
        (
            message("spacing 0.1; relaxation { tolerance -1; }"),
            "Entry tolerance is -1, but must be positive"
        )
    );
    EXPECT_TRUE
    (
        contains
        (
            message("spacing 0.1; lattice { type square; jitter 2; }"),
            "jitter 2 is outside the range 0 to 0.5"
        )
    );
    EXPECT_TRUE
    (
        contains
        (
            message("spacing 0.1; relaxation { momentum 1; }"),
            "momentum is 1, which is outside the range 0 to 0.99"
        )
    );
    EXPECT_TRUE
    (
        contains
        (
            message
            (
                "spacing 0.1; relaxation { type viscousInertial; viscosity 0; }"
            ),
            "viscosity is 0, but must be positive"
        )
    );
}


TEST(Relaxation, spacingLargerThanTheFluidIsRefused)
{
    testCase square(testCase::layout{});
    const std::string message
    (
        errorMessage
        (
            [&]{ particleGenerator(square.mesh(), sphMeshDict("spacing 2;")); }
        )
    );
    EXPECT_NE
    (
        message.find("spacing 2 is larger than the width 1 of the fluid"),
        std::string::npos
    )   << message;
}


TEST(Relaxation, withoutIterationsIsRepairedOnly)
{
    testCase square(cylinder());
    const std::string message
    (
        errorMessage
        (
            [&]
            {
                particleGenerator generator
                (
                    square.mesh(),
                    sphMeshDict
                    (
                        "spacing 0.2; lattice { type square; jitter 0.5; }"
                        "relaxation { maxIterations 0; }"
                    )
                );
                generator.generate();
            }
        )
    );
    EXPECT_EQ(message, "");
}


// ************************************************************************* //
