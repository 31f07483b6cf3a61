/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "givenStates.H"
#include "testCase.H"
#include "conservationLaw.H"
#include "gradientWeights.H"
#include "HLLCFlux.H"
#include "KurganovFlux.H"
#include "limiters.H"
#include "linearisedFlux.H"
#include "Random.H"
#include "timeScheme.H"

#include <cmath>
#include <gtest/gtest.h>
#include <omp.h>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const perfectGasFluid air{1.4, 287, 0, 0, 0, 1005/0.7};
const perfectGasFluid viscousAir{1.4, 287, 1.8e-5, 0, 0, 1005/0.7};
const weaklyCompressibleFluid water{10, 0.01, 0.01, 0.25};
const weaklyCompressibleFluid honey{10, 10, 0.01, 0.25};

constexpr label nSide = 12;


//- Square particles of a unit square, 0.1 thick. Pairs over the sides have the
//- areas of the sides. To these, every triangle of three neighbours adds a
//- random vector that runs around it, which leaves all particles closed; and
//- the particles move off the centres of their squares.
particleMeshData irregularSquares()
{
    Random random(7);
    const scalar h = 1.0/nSide;
    const scalar thickness = 0.1;

    const auto index = [](const label i, const label j)
    {
        return i + nSide*j;
    };

    particleMeshData data;
    data.points.setSize(nSide*nSide);
    data.V.setSize(nSide*nSide, h*h*thickness);
    data.spacing.setSize(nSide*nSide, h);

    DynamicList<label> owner;
    DynamicList<label> neighbour;
    DynamicList<vector> Sf;
    DynamicList<label> faceOwner;
    DynamicList<vector> faceSf;
    DynamicList<point> faceCf;
    List<DynamicList<label>> patchFaces(4);

    const auto addPair = [&](const label i, const label j, const vector& A)
    {
        owner.append(min(i, j));
        neighbour.append(max(i, j));
        Sf.append(i < j ? A : -A);
    };

    for (label j = 0; j < nSide; ++j)
    {
        for (label i = 0; i < nSide; ++i)
        {
            const label me = index(i, j);
            const auto shift = [&]()
            {
                return 0.2*h*(random.sample01<scalar>() - 0.5);
            };
            data.points[me] =
                point((i + 0.5)*h + shift(), (j + 0.5)*h + shift(), 0.05);

            const scalar area = h*thickness;
            if (i + 1 < nSide)
            {
                addPair(me, index(i + 1, j), vector(area, 0, 0));
            }
            if (j + 1 < nSide)
            {
                addPair(me, index(i, j + 1), vector(0, area, 0));
            }
            if (i + 1 < nSide && j + 1 < nSide)
            {
                const vector A
                (
                    0.2*area*(random.sample01<scalar>() - 0.5),
                    0.2*area*(random.sample01<scalar>() - 0.5),
                    0
                );
                const label corner[] =
                    {me, index(i + 1, j), index(i + 1, j + 1)};
                for (int k = 0; k < 3; ++k)
                {
                    addPair(corner[k], corner[(k + 1) % 3], A);
                }
            }
        }
    }

    // left, right, bottom, top: the patches of testCase, in its order
    data.boundary.start.setSize(1, 0);
    for (int side = 0; side < 4; ++side)
    {
        for (label k = 0; k < nSide; ++k)
        {
            const label i = side == 0 ? 0 : side == 1 ? nSide - 1 : k;
            const label j = side == 2 ? 0 : side == 3 ? nSide - 1 : k;
            const vector n
            (
                side == 0 ? -1 : side == 1 ? 1 : 0,
                side == 2 ? -1 : side == 3 ? 1 : 0,
                0
            );
            faceOwner.append(index(i, j));
            faceSf.append(h*thickness*n);
            faceCf.append
            (
                point((i + 0.5)*h, (j + 0.5)*h, 0.05) + 0.5*h*n
            );
            data.boundary.face.append(0);
            data.boundary.distance.append
            (
                (faceCf.last() - data.points[faceOwner.last()]) & n
            );
        }
        data.boundary.start.append(faceOwner.size());
    }
    data.boundary.start.append(faceOwner.size());
    data.boundary.owner = faceOwner;
    data.boundary.Sf = faceSf;
    data.boundary.Cf = faceCf;

    data.owner = owner;
    data.neighbour = neighbour;
    data.Sf = Sf;
    data.delta.setSize(owner.size());
    forAll(owner, pairi)
    {
        data.delta[pairi] =
            data.points[neighbour[pairi]] - data.points[owner[pairi]];
    }

    return data;
}


testCase& square()
{
    static testCase box{testCase::layout()};
    return box;
}


const particleMesh& particles()
{
    static const particleMesh mesh
    (
        square().mesh(), dictionary(), irregularSquares()
    );
    return mesh;
}


//- The law of a fluid with the scheme and limiter of the names
template<class Fluid>
autoPtr<conservationLaw> makeLaw
(
    const Fluid& fluid,
    const word& flux,
    const word& limiter,
    faceStates& faces
)
{
    dictionary schemes;
    schemes.add("fluxScheme", flux);
    if (limiter == "firstOrder")
    {
        schemes.add("reconstruction", word("none"));
    }
    else
    {
        schemes.add("limiter", limiter);
    }
    return conservationLaw::New(schemes, fluid, faces);
}


//- Fields that differ everywhere, near the values of a base state
List<scalarField> disturbed(const scalarList& base)
{
    Random random(3);
    List<scalarField> W(base.size());
    forAll(W, v)
    {
        W[v].setSize(particles().nParticles());
        for (scalar& value : W[v])
        {
            value = base[v]*(1 + 0.1*(random.sample01<scalar>() - 0.5));
        }
    }
    return W;
}


template<class Flux>
typename Flux::vars randomState(Random& random)
{
    typename Flux::vars W;
    for (int v = 0; v < Flux::nVars; ++v)
    {
        W[v] = random.sample01<scalar>() - 0.5;
    }
    return W;
}


template<>
HLLCFlux<2>::vars randomState<HLLCFlux<2>>(Random& random)
{
    HLLCFlux<2>::vars W;
    W[0] = 200 + 200*random.sample01<scalar>();
    W[1] = 600*(random.sample01<scalar>() - 0.5);
    W[2] = 600*(random.sample01<scalar>() - 0.5);
    W[3] = 1e4 + 1e5*random.sample01<scalar>();
    return W;
}


template<>
KurganovFlux<2>::vars randomState<KurganovFlux<2>>(Random& random)
{
    return randomState<HLLCFlux<2>>(random);
}


//- F(U, U) = F(U), exactly relative to U; F(L, R, n) = -F(R, L, -n)
template<class Flux>
void checkConsistency(const Flux& flux)
{
    Random random(1);

    for (int sample = 0; sample < 200; ++sample)
    {
        const auto L = randomState<Flux>(random);
        const auto R = randomState<Flux>(random);
        const scalar angle = 6.28*random.sample01<scalar>();
        const typename Flux::vec n{{std::cos(angle), std::sin(angle)}};
        const typename Flux::vec back{{-n[0], -n[1]}};

        const auto same = pairFlux(flux, L, L, L, n);
        const auto other = pairFlux(flux, L, L, R, n);
        const auto forth = pairFlux(flux, L, R, L, n);
        const auto opposite = pairFlux(flux, R, L, L, back);
        const auto FL = flux.flux(L, n);
        const auto FR = flux.flux(R, n);

        for (int v = 0; v < Flux::nVars; ++v)
        {
            const scalar scale = mag(FL[v]) + mag(FR[v]) + 1;
            EXPECT_EQ(same[v], 0);
            EXPECT_NEAR(other[v], FL[v] - FR[v], 1e-13*scale);
            EXPECT_NEAR
            (
                forth[v] + FL[v], -(opposite[v] - FL[v]), 1e-12*scale
            );
        }
    }
}


//- A uniform state with equal boundary states has no rate of change at all
template<class Fluid>
void checkFreeStream
(
    const Fluid& fluid,
    const word& flux,
    const word& limiter,
    const scalarList& state
)
{
    givenStates faces(particles(), state.size());
    List<scalarField> W(state.size());
    forAll(state, v)
    {
        faces.set(v, state[v]);
        W[v].setSize(particles().nParticles(), state[v]);
    }

    autoPtr<conservationLaw> law(makeLaw(fluid, flux, limiter, faces));
    law->setPrimitive(W);
    law->store();
    law->evaluate(0);
    ASSERT_TRUE(law->update(1, 1e-4, 0, law->nVariables()));

    for (label v = 0; v < law->nVariables(); ++v)
    {
        const scalarField Q(law->conserved(v));
        EXPECT_EQ(min(Q), max(Q)) << flux << " " << limiter << " " << v;
    }
}


//- Change of the totals in one Euler step of length 1 between slip walls
template<class Fluid>
scalarField totalChange
(
    const Fluid& fluid,
    const word& flux,
    const word& limiter,
    const scalarList& base,
    vector& wallForce
)
{
    givenStates faces(particles(), base.size());
    faces.setTreatment(faceStates::slip);

    autoPtr<conservationLaw> law(makeLaw(fluid, flux, limiter, faces));
    law->setPrimitive(disturbed(base));

    scalarField change(law->nVariables());
    for (label v = 0; v < law->nVariables(); ++v)
    {
        change[v] = -sum(particles().V()*law->conserved(v));
    }
    law->store();
    law->evaluate(0);
    law->update(1, 1e-6, 0, law->nVariables());
    for (label v = 0; v < law->nVariables(); ++v)
    {
        change[v] += sum(particles().V()*law->conserved(v));
    }

    wallForce = sum(faces.pressureForce());
    return change;
}


//- Conserved variables after an Euler step from the primitive ones between slip
//- walls
template<class Fluid>
List<scalarField> stepped
(
    const Fluid& fluid,
    const word& flux,
    const word& limiter,
    const List<scalarField>& W
)
{
    givenStates faces(particles(), W.size());
    faces.setTreatment(faceStates::slip);

    autoPtr<conservationLaw> law(makeLaw(fluid, flux, limiter, faces));
    law->setPrimitive(W);
    law->store();
    law->evaluate(0);
    EXPECT_TRUE(law->update(1, 1e-5, 0, law->nVariables()));

    List<scalarField> Q(W.size());
    forAll(Q, v)
    {
        Q[v] = law->conserved(v);
    }
    return Q;
}


void expectEqualSteps
(
    const List<scalarField>& a,
    const List<scalarField>& b
)
{
    ASSERT_EQ(a.size(), b.size());
    forAll(a, v)
    {
        EXPECT_GT(max(a[v]), min(a[v]));
        EXPECT_LT(max(mag(a[v] - b[v])), 1e-14*max(mag(a[v]))) << v;
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * //

TEST(RiemannSolvers, AreConsistentAndSymmetric)
{
    checkConsistency(linearisedFlux<2>(water));
    checkConsistency(linearisedFlux<2>(water, 15));
    checkConsistency(HLLCFlux<2>(air));
    checkConsistency(HLLCFlux<2>(air, 1));
    checkConsistency(KurganovFlux<2>(air));
}


TEST(RiemannSolvers, LimitedFluxesKeepAPartOfTheDissipationOfPressure)
{
    // [B] eq. 14 and 17: (pL - pR)/(2 rho c), times beta^2 = 0 at rest
    const linearisedFlux<2>::vars L{{3, 0, 0}};
    const linearisedFlux<2>::vars R{{1, 0, 0}};
    weaklyCompressibleFluid fluid{10, 0, 0, 0};

    for (const scalar kept : {0.0, 0.25, 1.0})
    {
        fluid.keptDissipation = kept;
        const linearisedFlux<2> limited(fluid, 15);
        EXPECT_DOUBLE_EQ(limited.crossing(L, R, {{1, 0}}).u, kept*0.1);
        EXPECT_DOUBLE_EQ
        (
            linearisedFlux<2>(fluid).crossing(L, R, {{1, 0}}).u, 0.1
        );
    }
}


TEST(RiemannSolvers, HLLCKeepsAContactAtRest)
{
    const HLLCFlux<2> flux(air);
    const HLLCFlux<2>::vars L{{300, 0, 0, 1e5}};
    const HLLCFlux<2>::vars R{{600, 0, 5, 1e5}};
    const auto dF = pairFlux(flux, L, R, L, {{1, 0}});

    for (int v = 0; v < 4; ++v)
    {
        EXPECT_NEAR(dF[v], 0, 1e-9);
    }
}


TEST(RiemannSolvers, AreUpwindInSupersonicFlow)
{
    // Mach 2 and 1.9 to the right
    const HLLCFlux<2>::vars L{{300, 694, 10, 1e5}};
    const HLLCFlux<2>::vars R{{310, 670, -10, 9e4}};

    const auto HLLC = pairFlux(HLLCFlux<2>(air), L, R, R, {{1, 0}});
    const auto Kurganov = pairFlux(KurganovFlux<2>(air), L, R, R, {{1, 0}});
    const auto FL = HLLCFlux<2>(air).flux(L, {{1, 0}});
    const auto FR = HLLCFlux<2>(air).flux(R, {{1, 0}});

    for (int v = 0; v < 4; ++v)
    {
        EXPECT_NEAR(HLLC[v], FL[v] - FR[v], 1e-10*mag(FL[v]));
        EXPECT_NEAR(Kurganov[v], FL[v] - FR[v], 1e-10*mag(FL[v]));
    }
}


TEST(RiemannSolvers, StopAGasWithTheShockRelations)
{
    // A gas that a wall stops from Mach number M: the reflected shock obeys
    // the Rankine-Hugoniot relation of p2/p1 and the piston's speed,
    // M = (r - 1)/gamma sqrt(2 gamma/((gamma + 1) r + gamma - 1))
    const HLLCFlux<2> flux(air);
    const scalar gamma = air.gamma;

    for (const scalar r : {1.001, 1.5, 4.0, 30.0})
    {
        const scalar M =
            (r - 1)/gamma*std::sqrt(2*gamma/((gamma + 1)*r + gamma - 1));
        const scalar c = std::sqrt(gamma*air.R*300);
        const HLLCFlux<2>::vars gas{{300, M*c, 7, 1e5}};
        const HLLCFlux<2>::vars wall{{300, 0, 0, 1e5}};

        const auto F = flux.wallFlux(gas, wall, gas, {{1, 0}});
        EXPECT_NEAR(F.momentum[0], r*1e5, 1e-6*r*1e5);
        EXPECT_EQ(F.mass, 0);
    }
}


TEST(RiemannSolvers, MeetThePressureOrTheVelocityOfAnOpenFace)
{
    // Behind the wave that the face sends into the gas: the jump conditions of
    // a shock, or entropy and Riemann invariant of an expansion
    const KurganovFlux<2> flux(air);
    const scalar gamma = air.gamma;
    const scalar c = std::sqrt(gamma*air.R*300);
    const scalar rho = 1e5/(air.R*300);

    const auto checkWave = [&](const auto& F, const scalar u, const scalar p)
    {
        const scalar uStar = (F.momentum[0] - p)/F.mass;
        const scalar rhoStar = F.mass/uStar;
        const scalar step = p - 1e5;
        if (step > 0)
        {
            EXPECT_NEAR(sqr(u - uStar)/(step*(1/rho - 1/rhoStar)), 1, 1e-9);
            EXPECT_NEAR
            (
                (p/rhoStar - 1e5/rho)
               /((gamma - 1)*0.5*(p + 1e5)*(1/rho - 1/rhoStar)),
                1,
                1e-9
            );
        }
        else
        {
            EXPECT_NEAR(p/1e5/std::pow(rhoStar/rho, gamma), 1, 1e-9);
            EXPECT_NEAR
            (
                uStar + 2*std::sqrt(gamma*p/rhoStar)/(gamma - 1),
                u + 2*c/(gamma - 1),
                1e-7*c
            );
        }
    };

    for (const scalar u : {100.0, 200.0})
    {
        const KurganovFlux<2>::vars gas{{300, u, 7, 1e5}};
        for (const scalar p : {0.8e5, 1.2e5})
        {
            const KurganovFlux<2>::vars outer{{350, u, 9, p}};
            const auto F =
                flux.openFlux(gas, outer, gas, {{1, 0}}, prescribed::pressure);
            EXPECT_GT(F.mass, 0);
            EXPECT_NEAR(F.momentum[1], 7*F.mass, 1e-9*F.mass);
            checkWave(F, u, p);
        }
        for (const scalar uStar : {80.0, 240.0})
        {
            const KurganovFlux<2>::vars outer{{350, uStar, 9, 1e5}};
            const auto F =
                flux.openFlux(gas, outer, gas, {{1, 0}}, prescribed::velocity);
            checkWave(F, u, F.momentum[0] - F.mass*uStar);
        }
    }

    // What flows in is gas of the patch; what flows out at Mach 2 does not
    // feel the pressure there; at equal states nothing changes
    const KurganovFlux<2>::vars still{{300, 0, 7, 1e5}};
    const KurganovFlux<2>::vars above{{350, 0, 9, 1.1e5}};
    const auto in =
        flux.openFlux(still, above, still, {{1, 0}}, prescribed::pressure);
    const scalar uIn = (in.momentum[0] - 1.1e5)/in.mass;
    EXPECT_NEAR(in.mass/uIn, 1.1e5/(air.R*350), 1e-9);
    EXPECT_NEAR(in.momentum[1], 9*in.mass, 1e-9*mag(in.mass));

    const KurganovFlux<2>::vars fast{{300, 2*c, 7, 1e5}};
    for (const auto gives : {prescribed::pressure, prescribed::velocity})
    {
        const auto out = flux.openFlux(fast, above, fast, {{1, 0}}, gives);
        const auto none = flux.openFlux(still, still, still, {{1, 0}}, gives);
        for (int v = 0; v < 4; ++v)
        {
            EXPECT_EQ(none.difference[v], 0);
            if (gives == prescribed::pressure)
            {
                EXPECT_EQ(out.difference[v], 0);
            }
        }
    }
}


TEST(Limiters, KeepEqualSlopesAndStopAtExtrema)
{
    // A line: increment half the difference
    EXPECT_DOUBLE_EQ(limiters::vanLeer::increment(0.5, 1), 0.5);
    EXPECT_DOUBLE_EQ(limiters::vanAlbada::increment(0.5, 1), 0.5);
    EXPECT_DOUBLE_EQ(limiters::Minmod::increment(0.5, 1), 0.5);
    EXPECT_DOUBLE_EQ(limiters::MUSCL::increment(0.5, 1), 0.5);

    // Slope of the other sign
    EXPECT_EQ(limiters::vanLeer::increment(-0.5, 1), 0);
    EXPECT_EQ(limiters::vanAlbada::increment(-0.5, 1), 0);
    EXPECT_EQ(limiters::Minmod::increment(-0.5, 1), 0);
    EXPECT_EQ(limiters::MUSCL::increment(-0.5, 1), 0);

    // No difference at all
    EXPECT_EQ(limiters::vanLeer::increment(0, 0), 0);
    EXPECT_EQ(limiters::vanAlbada::increment(0, 0), 0);
    EXPECT_EQ(limiters::Minmod::increment(0, 0), 0);
    EXPECT_EQ(limiters::MUSCL::increment(0, 0), 0);

    // r = a/b = 3: psi = 2r/(1 + r), r(r + 1)/(r^2 + 1), min(r, 1),
    // min(2r, (1 + r)/2, 2)
    EXPECT_DOUBLE_EQ(limiters::vanLeer::increment(1, 1), 0.5*1.5);
    EXPECT_DOUBLE_EQ(limiters::vanAlbada::increment(1, 1), 0.5*1.2);
    EXPECT_DOUBLE_EQ(limiters::Minmod::increment(1, 1), 0.5);
    EXPECT_DOUBLE_EQ(limiters::MUSCL::increment(1, 1), 0.5*2);
}


TEST(GradientWeights, AreExactForLinearFields)
{
    const vector slope(3, -2, 0);

    // Pairs alone, with faces of given value, with faces that mirror: those
    // differ from their particle along the normal alone
    for (const int withFaces : {0, 1, 2})
    {
        const bool mirrored = withFaces == 2;
        givenStates faces(particles(), 1);
        if (withFaces)
        {
            faces.set(0, 0);
            faces.setTreatment(mirrored ? faceStates::slip : faceStates::open);
        }
        const gradientWeights weights(faces);
        EXPECT_EQ(weights.nDeficient(), 0);

        vectorField S(particles().nParticles(), Zero);
        forAll(particles().owner(), pairi)
        {
            const vector contribution
            (
                0.5*(slope & particles().delta()[pairi])
               *particles().Sf()[pairi]
            );
            S[particles().owner()[pairi]] += contribution;
            S[particles().neighbour()[pairi]] += contribution;
        }
        if (withFaces)
        {
            const boundaryFaces& b = particles().boundary().faces();
            forAll(b.owner, facei)
            {
                const label i = b.owner[facei];
                const vector n(b.Sf[facei]/mag(b.Sf[facei]));
                const vector r(b.Cf[facei] - particles().C()[i]);
                S[i] += (slope & (mirrored ? n*(n & r) : r))*b.Sf[facei];
            }
        }

        forAll(S, i)
        {
            for (label a = 0; a < 2; ++a)
            {
                scalar g = 0;
                for (label b = 0; b < 2; ++b)
                {
                    g += weights[0][2*a + b][i]*S[i][b];
                }
                EXPECT_NEAR(g, slope[a], 1e-11);
            }
        }
    }
}


TEST(GradientWeights, LeaveOutDirectionsWithHardlyAnyMoment)
{
    const auto inverse = [](const scalar least)
    {
        tensor inv;
        gradientWeights::invert(tensor(1, 0, 0, 0, least, 0, 0, 0, 0), 2, inv);
        return inv;
    };

    // Neighbours on one side only leave a third
    EXPECT_NEAR(inverse(0.3).yy(), 1/0.3, 1e-12);
    EXPECT_NEAR(inverse(0.06).yy(), 1/0.06, 1e-12);
    EXPECT_NEAR(inverse(0.04).yy(), 0, 1e-12);
    EXPECT_NEAR(inverse(0.04).xx(), 1, 1e-12);
}


TEST(ConservationLaw, KeepsAFreeStreamBitwise)
{
    for (const word limiter : {"firstOrder", "none", "vanLeer"})
    {
        checkFreeStream(water, "linearisedLimited", limiter, {0.3, 0.8, 0.6});
        checkFreeStream(water, "linearised", limiter, {0.3, 0.8, 0.6});
        checkFreeStream(air, "HLLC", limiter, {300, 600, 200, 1e5});
        checkFreeStream(air, "HLLCLimited", limiter, {300, 60, 20, 1e5});
        checkFreeStream(viscousAir, "Kurganov", limiter, {300, 60, 20, 1e5});
    }
    checkFreeStream(air, "HLLC", "BarthJespersen", {300, 600, 200, 1e5});
}


TEST(ConservationLaw, ConservesBetweenSlipWalls)
{
    for (const word limiter : {"firstOrder", "vanLeer", "BarthJespersen"})
    {
        vector force;

        // Mass; momentum changes by the force on the walls; energy
        scalarField change
        (
            totalChange(water, "linearisedLimited", limiter, {1, 1, 1}, force)
        );
        EXPECT_NEAR(change[0], 0, 1e-15);
        EXPECT_NEAR(change[1], -1e-6*force.x(), 1e-15);
        EXPECT_NEAR(change[2], -1e-6*force.y(), 1e-15);

        change =
            totalChange
            (
                viscousAir, "HLLC", limiter, {300, 100, 100, 1e5}, force
            );
        EXPECT_NEAR(change[0], 0, 1e-13);
        EXPECT_NEAR(change[1], -1e-6*force.x(), 1e-11);
        EXPECT_NEAR(change[2], -1e-6*force.y(), 1e-11);
        EXPECT_NEAR(change[3], 0, 1e-8);
        EXPECT_GT(mag(force), 1);
    }
}


TEST(ConservationLaw, KeepsUniformPressureAndVelocityAcrossContacts)
{
    // A jump of temperature and density by 1000 that moves over the particles,
    // and another one from the sides where hot gas flows in
    const scalarField x(particles().C().component(0));
    scalarField T(x.size(), 300);
    forAll(T, i)
    {
        T[i] *= x[i] < 0.5 ? 1 : 1e-3;
    }

    for (const word flux : {"Kurganov", "HLLC", "HLLCLimited"})
    {
        for
        (
            const word limiter
          : {
                "firstOrder", "none", "vanLeer", "vanAlbada", "Minmod",
                "MUSCL", "BarthJespersen"
            }
        )
        {
            SCOPED_TRACE(flux + ' ' + limiter);
            givenStates faces(particles(), 4);
            faces.set(0, 300);
            faces.set(1, 300);
            faces.set(2, 100);
            faces.set(3, 1e5);
            autoPtr<conservationLaw> law(makeLaw(air, flux, limiter, faces));
            law->setPrimitive
            (
                List<scalarField>
                ({
                    T,
                    scalarField(1, 300),
                    scalarField(1, 100),
                    scalarField(1, 1e5)
                })
            );

            dictionary schemes;
            autoPtr<timeScheme> time(timeScheme::New(schemes));
            const scalarField before(law->conserved(0));
            for (label step = 0; step < 200; ++step)
            {
                const scalar dt = 1/law->stableRate(0.5, 1);
                while (!time->advance(*law, faces, dt))
                {
                    ASSERT_GT(law->dropReconstruction(), 0);
                }
                law->resumeReconstruction();
            }

            // The contact has moved
            EXPECT_GT
            (
                max(mag(law->conserved(0)() - before)), 0.1*min(before)
            );
            EXPECT_LT(max(mag(law->primitive(1)() - 300)), 1e-8);
            EXPECT_LT(max(mag(law->primitive(2)() - 100)), 1e-8);
            EXPECT_LT(max(mag(law->primitive(3)()/1e5 - 1)), 1e-10);
        }
    }
}


TEST(ConservationLaw, IsBitwiseTheSameForAnyNumberOfThreads)
{
    const int nThreads = omp_get_max_threads();
    scalarField results[2];

    for (const int n : {1, 2})
    {
        omp_set_num_threads(n);
        givenStates faces(particles(), 3);
        autoPtr<conservationLaw> law
        (
            makeLaw(water, "linearisedLimited", "none", faces)
        );
        law->setPrimitive(disturbed({1, 1, 1}));
        law->store();
        law->evaluate(0);
        law->update(0, 1e-4, 0, 3);
        results[n - 1] = law->conserved(1);
    }
    omp_set_num_threads(nThreads);

    EXPECT_EQ(results[0], results[1]);
}


TEST(ConservationLaw, ZeroViscosityIsWhatASmallOneTendsTo)
{
    // Loops without viscous terms against those with terms below round-off
    weaklyCompressibleFluid thinWater(water);
    weaklyCompressibleFluid inviscidWater(water);
    thinWater.nu = 1e-100;
    inviscidWater.nu = 0;
    perfectGasFluid thinAir(air);
    thinAir.mu = 1e-100;
    ASSERT_TRUE(thinAir.viscous());
    ASSERT_FALSE(air.viscous());

    const List<scalarField> waterStates(disturbed({1, 1, 1}));
    const List<scalarField> airStates(disturbed({300, 60, 20, 1e5}));

    for (const word limiter : {"firstOrder", "none", "vanLeer"})
    {
        SCOPED_TRACE(limiter);
        expectEqualSteps
        (
            stepped(thinWater, "linearisedLimited", limiter, waterStates),
            stepped(inviscidWater, "linearisedLimited", limiter, waterStates)
        );
        expectEqualSteps
        (
            stepped(thinAir, "HLLC", limiter, airStates),
            stepped(air, "HLLC", limiter, airStates)
        );
    }
}


TEST(ConservationLaw, FirstOrderIsReconstructionWithZeroGradients)
{
    // One particle apart from all others: its limited gradient is zero, and
    // so are those of its neighbours, as no value may leave their range
    const label middle = particles().nParticles()/2 + nSide/2;
    const scalarList base({300, 60, 20, 1e5});
    List<scalarField> W(base.size());
    forAll(base, v)
    {
        W[v].setSize(particles().nParticles(), base[v]);
        W[v][middle] *= 1.1;
    }

    expectEqualSteps
    (
        stepped(air, "HLLC", "firstOrder", W),
        stepped(air, "HLLC", "BarthJespersen", W)
    );
}


TEST(ConservationLaw, IsConvergentInTime)
{
    // Order of the schemes from the change of the result with the step
    const auto run = []
    (
        const weaklyCompressibleFluid& fluid,
        const word& scheme,
        const label nSteps,
        const scalar duration
    )
    {
        dictionary schemes;
        schemes.add("timeScheme", scheme);
        autoPtr<timeScheme> time(timeScheme::New(schemes));

        givenStates faces(particles(), 3);
        faces.setTreatment(faceStates::slip);
        autoPtr<conservationLaw> law
        (
            makeLaw(fluid, "linearised", "none", faces)
        );

        const scalarField x(particles().C().component(0));
        const scalarField y(particles().C().component(1));
        law->setPrimitive
        (
            List<scalarField>
            ({
                cos(3.14159*x), 0.1*sin(3.14159*x), 0.1*sin(3.14159*y)
            })
        );

        const scalar dt = duration/nSteps;
        for (label step = 0; step < nSteps; ++step)
        {
            EXPECT_GT(time->stableDeltaT(*law, 0.9), dt);
            EXPECT_TRUE(time->advance(*law, faces, dt));
        }
        return scalarField(law->conserved(0));
    };

    const auto order = [&]
    (
        const word& scheme,
        const weaklyCompressibleFluid& fluid = water,
        const scalar duration = 0.02
    )
    {
        const scalarField coarse(run(fluid, scheme, 8, duration));
        const scalarField middle(run(fluid, scheme, 16, duration));
        const scalarField fine(run(fluid, scheme, 32, duration));
        return std::log2
        (
            std::sqrt(sumSqr(coarse - middle)/sumSqr(middle - fine))
        );
    };

    EXPECT_NEAR(order("symplecticEuler"), 1, 0.3);
    EXPECT_NEAR(order("SSPRK2"), 2, 0.3);
    EXPECT_NEAR(order("SSPRK3"), 3, 0.3);
    EXPECT_NEAR(order("automatic"), 3, 0.3);

    // Super time steps
    EXPECT_NEAR(order("automatic", honey, 0.05), 2, 0.3);
}


TEST(ConservationLaw, SuperTimeStepsAreStable)
{
    dictionary schemes;
    autoPtr<timeScheme> time(timeScheme::New(schemes));
    schemes.add("timeScheme", "SSPRK3");
    autoPtr<timeScheme> plain(timeScheme::New(schemes));

    givenStates faces(particles(), 3);
    faces.setTreatment(faceStates::noSlip);
    autoPtr<conservationLaw> law(makeLaw(honey, "linearised", "none", faces));
    law->setPrimitive(disturbed({1, 1, 1}));

    const auto speed = [&]()
    {
        return std::sqrt
        (
            sumSqr(law->primitive(1)()) + sumSqr(law->primitive(2)())
        );
    };
    const scalar before = speed();

    // Three evaluations a step: worth it where steps are much longer
    const scalar Co = time->defaultCo(*law);
    EXPECT_GT(time->stableDeltaT(*law, Co), 5*plain->stableDeltaT(*law, Co));

    for (label step = 0; step < 300; ++step)
    {
        const scalar dt = time->stableDeltaT(*law, Co);
        ASSERT_TRUE(time->advance(*law, faces, dt));
    }
    EXPECT_LT(speed(), 0.01*before);
}


TEST(ConservationLaw, DampsNoiseInAGasAtRest)
{
    // Nothing is damped faster than what differs from each neighbour, in
    // squares and in cubes, by fluxes that are not limited
    testCase::layout cubes;
    cubes.nCells = labelVector(6, 6, 6);
    cubes.box = boundBox(point(0, 0, 0), point(1, 1, 1));
    cubes.twoD = false;

    for (const testCase::layout& layout : {testCase::layout(), cubes})
    {
        testCase box(layout);
        const particleMesh cells(box.mesh());
        const label nVariables = layout.twoD ? 4 : 5;

        for (const word flux : {"Kurganov", "HLLC"})
        {
            for (const word scheme : {"Hancock", "SSPRK2", "SSPRK3"})
            {
                SCOPED_TRACE
                (
                    flux + ' ' + scheme + ' ' + Foam::name(nVariables)
                );
                dictionary schemes;
                schemes.add("timeScheme", scheme);
                autoPtr<timeScheme> time(timeScheme::New(schemes));

                givenStates faces(cells, nVariables);
                faces.setTreatment(faceStates::slip);
                autoPtr<conservationLaw> law
                (
                    makeLaw(air, flux, "vanLeer", faces)
                );
                const scalar Co = min(0.5, time->defaultCo(*law));

                Random random(3);
                List<scalarField> W
                (
                    nVariables, scalarField(cells.nParticles(), Zero)
                );
                for (label i = 0; i < cells.nParticles(); ++i)
                {
                    const scalar p = 1 + 1e-4*(random.sample01<scalar>() - 0.5);
                    W.first()[i] = 300*std::pow(p, 0.4/1.4);
                    W.last()[i] = 1e5*p;
                }
                law->setPrimitive(W);

                for (label step = 0; step < 60; ++step)
                {
                    const scalar dt = time->stableDeltaT(*law, Co);
                    ASSERT_TRUE(time->advance(*law, faces, dt));
                }
                const scalarField p(law->primitive(nVariables - 1));
                EXPECT_LT(max(p) - min(p), 1e5*5e-5);
            }
        }
    }
}


TEST(ConservationLaw, StatesAheadLeaveNothingBehind)
{
    const auto rates = [](const scalarList& times)
    {
        givenStates faces(particles(), 4);
        faces.setTreatment(faceStates::slip);
        autoPtr<conservationLaw> law(makeLaw(air, "HLLC", "vanLeer", faces));
        law->setPrimitive(disturbed({300, 300, 300, 1e5}));
        const scalarField before(law->primitive(3));

        law->store();
        for (const scalar ahead : times)
        {
            law->evaluate(ahead);
            EXPECT_EQ(scalarField(law->primitive(3)), before);
        }
        EXPECT_TRUE(law->update(0, 1e-6, 0, 4));
        return scalarField(law->conserved(3));
    };

    const scalarField present(rates({0}));
    EXPECT_NE(rates({1e-5}), present);
    EXPECT_EQ(rates({1e-5, 0}), present);
}


TEST(ConservationLaw, RejectsStatesThatAreNotPhysical)
{
    givenStates faces(particles(), 4);
    faces.setTreatment(faceStates::slip);
    autoPtr<conservationLaw> law(makeLaw(air, "HLLC", "vanLeer", faces));
    law->setPrimitive(disturbed({300, 300, 300, 1e5}));
    const scalarField before(law->conserved(3));

    dictionary schemes;
    autoPtr<timeScheme> time(timeScheme::New(schemes));

    // Far beyond the stable step
    EXPECT_FALSE(time->advance(*law, faces, 1));
    EXPECT_EQ(before, scalarField(law->conserved(3)));
}


TEST(SphSchemes, ListTheValidWords)
{
    givenStates faces(particles(), 3);

    const auto message = [&](const word& entry, const word& value)
    {
        return errorMessage([&]()
        {
            dictionary schemes;
            schemes.add(entry, value);
            conservationLaw::New(schemes, water, faces);
            timeScheme::New(schemes);
        });
    };

    const auto contains = [](const std::string& text, const char* part)
    {
        return text.find(part) != std::string::npos;
    };

    const char* const choices[][3] =
    {
        {"fluxScheme", "HLLC", "linearisedLimited"},
        {"reconstruction", "quadratic", "linear"},
        {"limiter", "superbee", "vanAlbada"},
        {"wallGradient", "cubic", "quadratic"},
        {"timeScheme", "Euler", "SSPRK3"}
    };
    for (const auto& c : choices)
    {
        const std::string text(message(c[0], c[1]));
        const std::string unknown
        (
            std::string("Unknown ") + c[0] + ' ' + c[1]
        );
        EXPECT_TRUE(contains(text, unknown.c_str())) << text;
        EXPECT_TRUE(contains(text, c[2])) << text;
    }
}


// ************************************************************************* //
