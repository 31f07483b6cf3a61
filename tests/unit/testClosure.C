/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    Particle meshes: pair areas, volumes, boundary faces and the closure of
    particles on jittered lattices, with sums of their own.

\*---------------------------------------------------------------------------*/

#include "particleScene.H"
#include "momentClosure.H"
#include "pairGraph.H"
#include "particleMoments.H"
#include "particlePairs.H"
#include "Random.H"
#include "rawPairAreas.H"
#include "StringStream.H"
#include "torqueClosure.H"
#include "volFields.H"

#include <gtest/gtest.h>
#include <omp.h>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Area of a face between particles of the mesh's spacing
scalar faceArea(const particleMesh& m)
{
    return m.space().volume(m.spacing()[0])/m.spacing()[0];
}


//- Sum over the faces of each particle of values at the face's centre,
//- relative to the particle, times the area vector, over the volume.
//  The value may jump across cyclic patches: each side evaluates it at the
//  centre relative to its own particle
vectorField gradient
(
    const particleMesh& m,
    const std::function<scalar(const point&)>& f
)
{
    vectorField sum(m.nParticles(), Zero);

    for (label k = 0; k < m.nPairs(); ++k)
    {
        const label i = m.owner()[k];
        const label j = m.neighbour()[k];
        const vector skew(m.skew().empty() ? vector::zero : m.skew()[k]);

        sum[i] += m.Sf()[k]*f(m.C()[i] + 0.5*m.delta()[k] + skew);
        sum[j] -= m.Sf()[k]*f(m.C()[j] - 0.5*m.delta()[k] + skew);
    }
    for (const particlePatch& patch : m.boundary())
    {
        for (label s = 0; s < patch.size(); ++s)
        {
            sum[patch.owner()[s]] += patch.Sf()[s]*f(patch.Cf()[s]);
        }
    }

    return sum/m.V();
}


//- Largest deviation of the sums over boundary faces of each FVM face from
//- its area vector, over the largest area
scalar mirrorError(const fvMesh& mesh, const sceneParticles& m)
{
    scalar error = 0;
    for (const fvPatch& fvmPatch : mesh.boundary())
    {
        const particlePatch& patch = m.boundary()[fvmPatch.index()];
        const polyPatch& pp = fvmPatch.patch();
        if (pp.coupled() || fvmPatch.size() == 0)
        {
            EXPECT_EQ(patch.size(), 0) << patch.name();
            continue;
        }

        const labelList face(m.fvmFaces(patch));
        vectorField sum(pp.size(), Zero);
        for (label s = 0; s < patch.size(); ++s)
        {
            sum[face[s]] += patch.Sf()[s];
        }
        const vectorField Sf(pp.faceAreas());
        error = max(error, max(mag(sum - Sf))/max(mag(Sf)));
    }
    return error;
}


bool sameBytes(const vectorField& a, const vectorField& b)
{
    return
        a.size() == b.size()
     && std::equal
        (
            a.begin(),
            a.end(),
            b.begin(),
            [](const vector& u, const vector& v)
            {
                return std::memcmp(&u, &v, sizeof(vector)) == 0;
            }
        );
}


//- Rings of bricks around a hole, radii 1 to 1000. Beyond r = 100 their
//- particles are off their centres by up to jitter/2 spacings
particleMeshData bricks(const scalar jitter)
{
    constexpr label nAround = 24;
    constexpr label nRings = 26;
    const scalar half = constant::mathematical::pi/nAround;
    const scalar growth = Foam::pow(1000, 1.0/nRings);

    //- Vertex h half bricks around, inside ring k
    const auto vertex = [&](const label k, const label h)
    {
        return Foam::pow(growth, k)
           *vector(Foam::cos(h*half), Foam::sin(h*half), 0);
    };
    //- Area vector of the side from a to b of a brick that lies to its left
    const auto area = [](const point& a, const point& b)
    {
        return vector(b.y() - a.y(), a.x() - b.x(), 0);
    };

    Random random(3);
    particleMeshData data;
    DynamicList<point> points;
    DynamicList<scalar> spacing;
    DynamicList<label> owner, neighbour, wallOwner;
    DynamicList<vector> Sf, wallSf;
    DynamicList<point> wallCf;
    for (label k = 0; k < nRings; ++k)
    {
        for (label l = 0; l < nAround; ++l)
        {
            const label i = k*nAround + l;
            const label first = 2*l + k % 2;

            point centre(Zero);
            for (label h = first; h < first + 3; ++h)
            {
                centre += (vertex(k, h) + vertex(k + 1, h))/6;
            }
            spacing.append(2*half*mag(centre));
            if (mag(centre) > 100)
            {
                centre += jitter*spacing.last()*vector
                (
                    random.sample01<scalar>() - 0.5,
                    random.sample01<scalar>() - 0.5,
                    0
                );
            }
            points.append(centre);

            const label next = k*nAround + (l + 1) % nAround;
            owner.append(min(i, next));
            neighbour.append(max(i, next));
            Sf.append
            (
                (next > i ? 1 : -1)
               *area(vertex(k + 1, first + 2), vertex(k, first + 2))
            );

            for (label h = first; h < first + 2; ++h)
            {
                const point a(vertex(k + 1, h));
                const point b(vertex(k + 1, h + 1));
                if (k == 0)
                {
                    wallOwner.append(i);
                    wallSf.append(area(vertex(k, h + 1), vertex(k, h)));
                    wallCf.append(0.5*(vertex(k, h) + vertex(k, h + 1)));
                }
                if (k == nRings - 1)
                {
                    wallOwner.append(i);
                    wallSf.append(area(a, b));
                    wallCf.append(0.5*(a + b));
                }
                else
                {
                    const label beyond = (h + 2*nAround - (k + 1) % 2)/2;
                    owner.append(i);
                    neighbour.append((k + 1)*nAround + beyond % nAround);
                    Sf.append(area(a, b));
                }
            }
        }
    }

    data.points.transfer(points);
    data.spacing.transfer(spacing);
    data.owner.transfer(owner);
    data.neighbour.transfer(neighbour);
    data.Sf.transfer(Sf);
    data.delta.setSize(data.owner.size());
    forAll(data.delta, pairi)
    {
        data.delta[pairi] =
            data.points[data.neighbour[pairi]] - data.points[data.owner[pairi]];
    }
    data.boundary.owner.transfer(wallOwner);
    data.boundary.Sf.transfer(wallSf);
    data.boundary.Cf.transfer(wallCf);
    data.V = 0.5*tr(firstMoments(data));

    return data;
}


//- Name of a scene
class Closure
:
    public testing::TestWithParam<const char*>
{
protected:

    std::unique_ptr<particleScene> scene =
        particleScene::New(GetParam(), 0.3);
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * *  Assembly * * * * * * * * * * * * * * * * //

TEST_P(Closure, rawAreasAreThoseOfTheKernel)
{
    const auto m = scene->assemble("type none;");
    const scalar h = m->W().smoothingRatio()*m->spacing()[0];
    const scalar step = 1e-6*h;

    EXPECT_EQ(m->boundary().nFaces(), 0);
    for (label k = 0; k < m->nPairs(); k += 7)
    {
        const label i = m->owner()[k];
        const label j = m->neighbour()[k];
        const vector& d = m->delta()[k];

        // 2 V_i V_j dW/dr by differences over the lattice moment, from i to j
        const scalar r = mag(d);
        const scalar slope =
            (m->W().W(r + step, h) - m->W().W(r - step, h))/(2*step);
        const vector A
        (
            -2*m->V()[i]*m->V()[j]/m->space().thickness()*slope*d/r
           /m->W().latticeMoment()
        );

        EXPECT_LT(i, j);
        EXPECT_GE(m->Sf()[k] & d, 0);
        EXPECT_LT(mag(m->Sf()[k] - A), 1e-7*faceArea(*m));
    }
}


TEST_P(Closure, everyClosureHasTheVolumeOfTheMesh)
{
    for
    (
        const char* type :
        {
            "type none;",
            "type surfaceVector;",
            "type consistent; order 0;",
            "type consistent; order 1;",
            "type consistent; order 1; volumes uniform;"
        }
    )
    {
        const auto m = scene->assemble(type);
        EXPECT_NEAR(sum(m->V())/gSum(scene->mesh().V()), 1, 1e-12) << type;
        EXPECT_GT(min(m->V()), 0) << type;
    }
}


// * * * * * * * * * * * * * * * * Consistent  * * * * * * * * * * * * * * * //

TEST_P(Closure, boundaryFacesMirrorTheFacesOfTheMesh)
{
    for (const char* type : {"order 0;", "order 1;"})
    {
        EXPECT_LT(mirrorError(scene->mesh(), *scene->assemble(type)), 1e-13)
            << type;
    }

    const auto m = scene->assemble("order 0;");
    for (const particlePatch& patch : m->boundary())
    {
        for (label s = 0; s < patch.size(); ++s)
        {
            const vector r(patch.Cf()[s] - m->C()[patch.owner()[s]]);
            EXPECT_GT(r & patch.Sf()[s], 0);
            EXPECT_GT(patch.distance()[s], 0);
            EXPECT_LT(mag(r), m->W().support(m->spacing()[0]));
        }
    }
}


TEST_P(Closure, constantFieldsHaveNoGradient)
{
    for (const char* type : {"order 0;", "order 1;"})
    {
        const auto m = scene->assemble(type);
        const vectorField g
        (
            gradient(*m, [](const point&) { return 1; })*m->V()
        );
        EXPECT_LT(max(mag(g))/faceArea(*m), 1e-12) << type;
    }
}


TEST_P(Closure, linearFieldsHaveTheirGradient)
{
    const auto m = scene->assemble("order 1;");
    ASSERT_EQ(m->skew().size(), m->nPairs());

    for (const direction d : {0, 1, 2})
    {
        vector exact(Zero);
        exact[d] = 1;

        // Relative to a point of the box: round-off of the offset is that of
        // the constant field
        const vectorField g
        (
            gradient(*m, [&](const point& p) { return p[d] - 0.5; })
        );
        const bool solved = m->space().toLocal(exact) != vector::zero;

        scalar error = 0;
        forAll(g, i)
        {
            error = max(error, mag(g[i] - (solved ? exact : vector::zero)));
        }

        // Periodic coordinates differ by sums of areas, closed to 5e-14 of
        // an area, times the extent of the box in spacings
        EXPECT_LT(error, 5e-12) << "direction " << label(d);
    }
}


TEST_P(Closure, areasKeepTheirDirection)
{
    for (const char* type : {"order 0;", "order 1;"})
    {
        const auto m = scene->assemble(type);
        label nFlipped = 0;
        for (label k = 0; k < m->nPairs(); ++k)
        {
            nFlipped += (m->Sf()[k] & m->delta()[k]) < 0;
        }
        EXPECT_LT(nFlipped, 0.002*m->nPairs()) << type;
    }
}


TEST_P(Closure, resultDoesNotDependOnTheNumberOfThreads)
{
    const int nThreads = omp_get_max_threads();

    omp_set_num_threads(1);
    const auto one = scene->assemble("order 1;");

    // GAMG of OpenFOAM agglomerates forwards and backwards by turns: an even
    // number of times between the two
    scene->assemble("order 1;");
    omp_set_num_threads(2);
    const auto two = scene->assemble("order 1;");
    omp_set_num_threads(nThreads);

    EXPECT_TRUE(sameBytes(one->Sf(), two->Sf()));
    EXPECT_TRUE(sameBytes(one->skew(), two->skew()));
    EXPECT_TRUE
    (
        sameBytes(one->boundary().faces().Cf, two->boundary().faces().Cf)
    );
}

INSTANTIATE_TEST_SUITE_P
(
    Scenes,
    Closure,
    testing::Values
    (
        "box", "hole", "channel", "periodic", "cube", "pipe"
    )
);


TEST(Closure, particlesBeyondAConvexEdgeHaveNoPartOfItsFaces)
{
    const auto scene = particleScene::New("hole", 0);
    const auto m = scene->assemble("order 1;");

    // A square hole has edges of this kind alone: nobody faces two sides
    label nFaces = 0;
    for (const particlePatch& patch : m->boundary())
    {
        if (patch.patch().name() != "hole")
        {
            continue;
        }
        nFaces += patch.size();
        for (label s = 0; s < patch.size(); ++s)
        {
            for (label t = 0; t < s; ++t)
            {
                if (patch.owner()[s] == patch.owner()[t])
                {
                    EXPECT_GT(patch.Sf()[s] & patch.Sf()[t], 0);
                }
            }
        }
    }
    EXPECT_GT(nFaces, 20);
}


TEST(Closure, aParticleCloseInFrontOfAWallHasAPartOfIt)
{
    // Half-way between the centres of two elements of the wall, which are a
    // quarter of a spacing long, and nearer to it than to these
    const scalar dp = 0.05;
    testCase::layout layout;
    particleScene scene(layout, dp, 0);
    pointField& points = scene.particles().points;
    const point wanted(0.525, 0.1*dp, 0.05);
    points[findMin(scalarField(mag(points - wanted)))] = wanted;

    const auto m = scene.assemble("order 0;");
    const label moved =
        findMin(scalarField(mag(m->written().points - wanted)));
    for (const particlePatch& patch : m->boundary())
    {
        if (patch.patch().name() == "bottom")
        {
            EXPECT_TRUE(patch.owner().found(moved));
        }
    }
}


TEST(Closure, volumesFollowTheDensityOfTheParticles)
{
    const auto scene = particleScene::New("periodic", 0);
    particleSet& particles = scene->particles();
    particles.density = scalarField(particles.points.size());
    forAll(particles.density, i)
    {
        particles.density[i] = i % 2 ? 1.02 : 0.98;
    }

    // Only a closure that takes volumes from the particles asks for it
    const auto uniform = scene->assemble("type none;");
    EXPECT_NEAR(max(uniform->V())/min(uniform->V()), 1, 1e-13);

    const auto measured = scene->assemble("order 0; sweeps 0;");
    EXPECT_GT(max(measured->V())/min(measured->V()), 1.005);
    EXPECT_NEAR(sum(measured->V())/sum(uniform->V()), 1, 1e-13);
}


TEST(Closure, variableSpacingClosesToo)
{
    testCase::layout layout;
    particleScene scene(layout, 0.05, 0.3);
    Random random(5);
    for (scalar& dp : scene.particles().spacing)
    {
        dp *= 0.9 + 0.2*random.sample01<scalar>();
    }

    const auto m = scene.assemble("order 1;");
    EXPECT_NEAR(sum(m->V()), gSum(scene.mesh().V()), 1e-13);
    EXPECT_LT(mirrorError(scene.mesh(), *m), 1e-13);

    const vectorField g(gradient(*m, [](const point& p) { return p.y(); }));
    EXPECT_LT(max(mag(g - vector(0, 1, 0))), 5e-12);
}


TEST(Closure, scenesOfMicrometresCloseToo)
{
    testCase::layout layout;
    layout.box = boundBox(point(0, 0, 0), point(1e-6, 1e-6, 1e-7));
    particleScene scene(layout, 5e-8, 0.3);

    const auto m = scene.assemble("order 1;");
    const vectorField g(gradient(*m, [](const point& p) { return p.y(); }));
    EXPECT_LT(max(mag(g - vector(0, 1, 0))), 5e-12);
}


TEST(Closure, aFewParticlesCloseToo)
{
    for (const label n : {1, 2, 3, 4})
    {
        particleScene scene(testCase::layout(), 1.0/n, 0);
        const auto m = scene.assemble("order 1;");
        const auto y = [](const point& p) { return p.y(); };

        EXPECT_EQ(m->nParticles(), n*n);
        EXPECT_LT(max(mag(gradient(*m, y) - vector(0, 1, 0))), 1e-11);
    }
}


TEST(Closure, aLatticeThatClosesToTheLastBitStaysAsItIs)
{
    // Binary fractions: no round-off is left over
    testCase::layout layout;
    layout.periodic[0] = layout.periodic[1] = true;
    particleScene scene(layout, 0.0625, 0);

    const auto raw = scene.assemble("type none;");
    const auto m = scene.assemble("order 1; leastArea 0;");
    EXPECT_LT(max(mag(m->Sf() - raw->Sf()))/faceArea(*raw), 1e-13);
    EXPECT_LT(max(mag(m->V()/raw->V() - 1)), 1e-13);
}


TEST(Closure, weakPairsAreLeftOut)
{
    // The papers' kernel reaches 20 neighbours, of which those at sqrt(5) dp
    // weigh little
    testCase::layout layout;
    layout.periodic[0] = layout.periodic[1] = true;
    particleScene scene(layout, 0.0625, 0);

    const auto all = scene.assemble("order 1; leastArea 0;");
    const auto m = scene.assemble("order 1;");
    const label n = all->V().size();
    EXPECT_EQ(m->owner().size(), 6*n);
    EXPECT_GT(all->owner().size(), 6*n);
    EXPECT_LT(max(mag(m->V()/all->V() - 1)), 1e-13);

    scalar longest = 0;
    forAll(m->owner(), pairi)
    {
        longest = max(longest, mag(m->delta()[pairi]));
    }
    EXPECT_NEAR(longest, 2*0.0625, 1e-12);

    // What is left weighs as much as the whole: the sum of first moments
    EXPECT_LT
    (
        mag(sum(tr(firstMoments(m->data()) - firstMoments(all->data())))),
        1e-13
    );
}


// * * * * * * * * * * * * * * *  closeMoments * * * * * * * * * * * * * * * //

TEST(Closure, whatRemainsOfPairsKeepsTheirMoments)
{
    // The largest pair of particle 2 is small for particle 1: it stays
    particleMeshData data;
    data.points.setSize(3, Zero);
    data.owner = labelList({0, 0, 1});
    data.neighbour = labelList({1, 2, 2});
    data.delta = vectorField(3, vector(1, 0, 0));
    data.Sf = vectorField
    ({
        vector(1, 0, 0), vector(0.005, 0, 0), vector(0.08, 0, 0)
    });
    dropWeakPairs
    (
        solutionSpace(1, {0, 1, 2}, 1, vector::zero), 0.1, data
    );

    EXPECT_EQ(data.owner, labelList({0, 1}));
    EXPECT_EQ(data.neighbour, labelList({1, 2}));

    // Moments of the three before: 1.005, 1.08, 0.085, of what stays: 1, 1.08,
    // 0.08. A pair is scaled by the mean of its particles
    ASSERT_EQ(data.Sf.size(), 2);
    EXPECT_NEAR(data.Sf[0].x(), 0.5*(1.005 + 1), 1e-15);
    EXPECT_NEAR(data.Sf[1].x(), 0.08*0.5*(1 + 0.085/0.08), 1e-15);
}


TEST(MomentClosure, defectsOfCoarseParticlesDoNotMoveFacesOfFineOnes)
{
    const solutionSpace space(2, {0, 1, 2}, 1, vector::zero);
    testCase box{testCase::layout()};

    //- Face shifts over the spacing, and face centres of the boundary
    const auto closed = [&](const scalar jitter)
    {
        particleMeshData data(bricks(jitter));
        EXPECT_LT(max(mag(areaSums(data)())), 1e-11);
        const pairGraph graph
        (
            box.mesh().time(), data.points.size(), data.owner, data.neighbour
        );
        closeMoments
        (
            space,
            graph,
            boolList(data.boundary.owner.size(), false),
            1e-12,
            5000,
            data
        );
        EXPECT_LT(largestDefect(space, data), 1e-8);
        return data;
    };
    const particleMeshData regular(closed(0));
    const particleMeshData irregular(closed(0.2));

    scalar coarse = 0;
    scalar fine = 0;
    forAll(regular.skew, pairi)
    {
        const label i = regular.owner[pairi];
        const scalar moved =
            mag(irregular.skew[pairi] - regular.skew[pairi])
           /regular.spacing[i];
        const scalar r = mag(regular.points[i]);
        coarse = max(coarse, r > 200 ? moved : 0);
        fine = max(fine, r < 10 ? moved : 0);
    }
    forAll(regular.boundary.Cf, s)
    {
        const label i = regular.boundary.owner[s];
        if (mag(regular.points[i]) < 10)
        {
            fine = max
            (
                fine,
                mag(irregular.boundary.Cf[s] - regular.boundary.Cf[s])
               /regular.spacing[i]
            );
        }
    }
    EXPECT_GT(coarse, 0.02);
    EXPECT_LT(fine, 0.1*coarse);
}


// * * * * * * * * * * * * * * *  surfaceVector  * * * * * * * * * * * * * * //

TEST(SurfaceVector, closesParticlesOfTheBoundaryWithinTheirPatch)
{
    const auto scene = particleScene::New("hole", 0.1);
    const auto raw = scene->assemble("type none;");
    const auto m = scene->assemble("type surfaceVector;");

    vectorField pairSum(m->nParticles(), Zero);
    scalarField divergence(m->nParticles(), Zero);
    for (label k = 0; k < m->nPairs(); ++k)
    {
        EXPECT_EQ(m->Sf()[k], raw->Sf()[k]);

        const label i = m->owner()[k];
        const label j = m->neighbour()[k];
        pairSum[i] += m->Sf()[k];
        pairSum[j] -= m->Sf()[k];

        // V_j r_ij.gradW_ij = -r.A_ij/(2 V_i)
        const scalar rA = 0.5*(m->delta()[k] & m->Sf()[k]);
        divergence[i] += rA/m->V()[i];
        divergence[j] += rA/m->V()[j];
    }

    labelList nFaces(m->nParticles(), Zero);
    const scalarField& distance = m->written().boundary.distance;
    for (const particlePatch& patch : m->boundary())
    {
        const labelList face(m->fvmFaces(patch));
        for (label s = 0; s < patch.size(); ++s)
        {
            const label i = patch.owner()[s];
            ++nFaces[i];
            EXPECT_LT(mag(patch.Sf()[s] + pairSum[i]), 1e-14);

            const auto nearest = scene->fluid().find(m->C()[i]);
            EXPECT_EQ(nearest.patchi, patch.index());
            EXPECT_EQ(nearest.facei, face[s]);
            EXPECT_NEAR
            (
                -nearest.distance, distance[patch.start() + s], 1e-14
            );
        }
    }

    label nBoundary = 0;
    forAll(nFaces, i)
    {
        EXPECT_EQ(nFaces[i], label(divergence[i] < 0.75*2)) << i;
        nBoundary += nFaces[i];
    }

    // About the first layer: 4 + 1 sides of 20 and 20 particles
    EXPECT_GT(nBoundary, 60);
    EXPECT_LT(nBoundary, 140);
}


TEST(SurfaceVector, splitsCornersAlongBothWalls)
{
    const auto scene = particleScene::New("box", 0);
    const auto whole = scene->assemble("type surfaceVector;");
    const auto split =
        scene->assemble("type surfaceVector; splitCorners yes;");

    const auto sums = [](const particleMesh& m)
    {
        vectorField sum(m.nParticles(), Zero);
        for (const particlePatch& patch : m.boundary())
        {
            forAll(patch.owner(), s)
            {
                sum[patch.owner()[s]] += patch.Sf()[s];
            }
        }
        return sum;
    };
    EXPECT_LT(max(mag(sums(*whole) - sums(*split))), 1e-15);

    // Vectors of the box's sides are normal to them but for the particles
    // that a second side cuts off by a little
    label nOblique = 0;
    for (const particlePatch& patch : split->boundary())
    {
        forAll(patch.owner(), s)
        {
            const vector n(patch.Sf()[s]/mag(patch.Sf()[s]));
            nOblique += cmptMax(cmptMag(n)) < 0.99;
        }
    }
    EXPECT_EQ(nOblique, 0);

    label nDouble = 0;
    labelList nFaces(split->nParticles(), Zero);
    for (const label i : split->boundary().faces().owner)
    {
        nDouble += ++nFaces[i] == 2;
    }
    EXPECT_GE(nDouble, 4);
}


// * * * * * * * * * * * * * * *  Hidden pairs * * * * * * * * * * * * * * * //

TEST(HiddenPairs, thinPlateSeparatesItsSides)
{
    // A plate of one spacing with fluid all around
    testCase::layout layout;
    layout.nCells = labelVector(25, 25, 1);
    layout.hole = boundBox(point(0.2, 0.48, -1), point(0.8, 0.52, 1));
    particleScene scene(layout, 0.04, 0.05);
    const auto m = scene.assemble("type none;");

    const auto above = [&](const label i)
    {
        return m->C()[i].y() > 0.5;
    };

    label nAcross = 0;
    label nAround = 0;
    for (label k = 0; k < m->nPairs(); ++k)
    {
        const label i = m->owner()[k];
        const label j = m->neighbour()[k];
        const scalar x = 0.5*(m->C()[i].x() + m->C()[j].x());
        if (above(i) != above(j))
        {
            (mag(x - 0.5) < 0.25 ? nAcross : nAround) += 1;
        }
    }

    // Without the plate there are pairs there
    const particlePairs all
    (
        vectorField(m->C()),
        scalarField(m->nParticles(), m->W().support(0.04)),
        List<vector>()
    );
    label nWithout = 0;
    for (label k = 0; k < all.size(); ++k)
    {
        const label i = all.owner[k];
        const label j = all.neighbour[k];
        const scalar x = 0.5*(m->C()[i].x() + m->C()[j].x());
        nWithout += above(i) != above(j) && mag(x - 0.5) < 0.25;
    }

    EXPECT_GT(nWithout, 20);
    EXPECT_EQ(nAcross, 0);
    EXPECT_GT(nAround, 20);
}


// * * * * * * * * * * * * * * * * *  Errors * * * * * * * * * * * * * * * * //

TEST(ClosureErrors, unknownWordsListTheValidOnes)
{
    const auto message = [](const std::string& text)
    {
        IStringStream is(text);
        const dictionary dict(is);
        return errorMessage([&]{ closure::New(dict); });
    };

    const std::string type(message("type mirrored;"));
    for (const char* name : {"none", "surfaceVector", "consistent"})
    {
        EXPECT_NE(type.find(name), std::string::npos) << type;
    }

    const std::string order(message("type consistent; order 2;"));
    EXPECT_NE(order.find("0 or 1"), std::string::npos) << order;

    const std::string volumes(message("type consistent; volumes equal;"));
    EXPECT_NE(volumes.find("uniform"), std::string::npos) << volumes;

    const std::string threshold(message("type surfaceVector; threshold 2;"));
    EXPECT_NE(threshold.find("0 to 1"), std::string::npos) << threshold;
}

TEST(TorqueClosure, defectsOfFirstMomentsExertNoTorque)
{
    for (const char* name : {"box", "cube"})
    {
        const auto scene = particleScene::New(name, 0.3);
        const auto particles = scene->assemble("order 0;");
        const solutionSpace& space = particles->space();
        particleMeshData data(particles->written());
        const scalar volume = sum(data.V);
        forAll(data.V, i)
        {
            data.V[i] *= 1 + 0.1*data.points[i].x();
        }
        data.V *= volume/sum(data.V);
        const vectorField sums(areaSums(data));

        //- Largest torque of the components of x
        const auto torque = [&]()
        {
            const tensorField moments(firstMoments(data));
            tensor total(Zero);
            forAll(moments, i)
            {
                const tensor defect
                (
                    data.V[i]*space.identity() - moments[i]
                );
                total +=
                    tensor
                    (
                        data.points[i] ^ defect.x(),
                        data.points[i] ^ defect.y(),
                        data.points[i] ^ defect.z()
                    );
            }
            // In 2-D the axis is z
            return space.nDims() == 2
              ? max(mag(total.xz()), mag(total.yz()))
              : cmptMax(cmptMag(total));
        };

        const scalar before = torque();
        const pairGraph graph
        (
            scene->mesh().time(),
            data.points.size(),
            data.owner,
            data.neighbour
        );
        const scalar tolerance = 1e-15*space.volume(1);
        closeTorques(space, graph, tolerance, 5000, data);

        EXPECT_GT(before, 1e-5*space.volume(1)) << name;
        EXPECT_LT(torque(), 1e-8*before) << name;
        EXPECT_LT(max(mag(areaSums(data) - sums)), 1e-11*space.volume(1))
            << name;
    }
}


TEST(PairGraph, connectedSets)
{
    testCase square{testCase::layout()};
    const pairGraph graph
    (
        square.time(), 6, labelList({0, 1, 4}), labelList({2, 5, 5})
    );
    EXPECT_EQ(graph.connectedSets(), labelList({0, 1, 0, 2, 1, 1}));
}


// ************************************************************************* //
