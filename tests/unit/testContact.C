/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "boundaryStates.H"
#include "conservationLaw.H"
#include "contactBoundary.H"
#include "givenStates.H"
#include "particleFiles.H"
#include "particleScene.H"
#include "Random.H"
#include "treatedParticleMesh.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const perfectGasFluid viscousAir{1.4, 287, 1.8e-5, 0, 0, 1005/0.7};
const perfectGasFluid inviscidAir{1.4, 287, 0, 0, 0, 1005/0.7};
const weaklyCompressibleFluid water{10, 0.01, 0.01, 0};
const weaklyCompressibleFluid inviscidWater{10, 0, 0.01, 0};

constexpr scalar dp = 0.05;


//- A channel whose walls are at y = -margin and 1 + margin, periodic in x
std::unique_ptr<particleScene> channel
(
    const scalar margin = 0,
    const scalar jitter = 0,
    const bool periodic = true
)
{
    testCase::layout layout;
    layout.periodic[0] = periodic;
    layout.box = boundBox(point(0, -margin, 0), point(1, 1 + margin, 0.1));
    return std::make_unique<particleScene>(layout, dp, jitter);
}


//- Three layers of solid particles behind both walls of the channel
List<particleSet> wallParticles()
{
    List<particleSet> solids(2);
    forAll(solids, side)
    {
        DynamicList<point> points;
        for (scalar depth = 0.5*dp; depth < 3*dp; depth += dp)
        {
            for (scalar x = 0.5*dp; x < 1; x += dp)
            {
                points.append(point(x, side ? 1 + depth : -depth, 0.05));
            }
        }
        solids[side].name = side ? "above" : "below";
        solids[side].spacing = scalarField(points.size(), dp);
        solids[side].points.transfer(points);
    }
    return solids;
}


//- The particles of a channel with solid particles for its walls
class contactChannel
{
    std::unique_ptr<particleScene> scene_;

    std::unique_ptr<sceneParticles> surfaceVectors_;

    autoPtr<particleMesh> pairs_;

public:

    explicit contactChannel(const scalar jitter, const bool periodic = true)
    :
        scene_(channel(0, jitter, periodic)),
        surfaceVectors_
        (
            scene_->assemble("type surfaceVector;", wallParticles())
        )
    {
        scene_->files().write
        (
            "sph/system/sphSchemes", "boundaryTreatment contact;"
        );
        pairs_ = treatedParticleMesh(surfaceVectors_->mesh());
    }

    const particleMesh& operator()() const
    {
        return *pairs_;
    }
};


vectorField areaSums(const particleMesh& particles)
{
    vectorField sum(particles.nParticles(), Zero);
    forAll(particles.owner(), pairi)
    {
        sum[particles.owner()[pairi]] += particles.Sf()[pairi];
        sum[particles.neighbour()[pairi]] -= particles.Sf()[pairi];
    }
    const boundaryFaces& faces = particles.boundary().faces();
    forAll(faces.owner, facei)
    {
        sum[faces.owner[facei]] += faces.Sf[facei];
    }
    return sum;
}


dictionary schemes(const word& flux, const word& reconstruction)
{
    dictionary dict;
    dict.add("fluxScheme", flux);
    dict.add("reconstruction", reconstruction);
    return dict;
}


//- Conserved variables, each as a field, after an Euler step from W
List<scalarField> afterStep
(
    conservationLaw& law,
    const List<scalarField>& W,
    const scalar dt
)
{
    law.setPrimitive(W);
    law.store();
    law.evaluate(0);
    law.update(1, dt, 0, law.nVariables());

    List<scalarField> Q(law.nVariables());
    forAll(Q, v)
    {
        Q[v] = law.conserved(v);
    }
    return Q;
}


List<scalarField> uniform
(
    const particleMesh& particles,
    const scalarList& state
)
{
    List<scalarField> W(state.size());
    forAll(W, v)
    {
        W[v] = scalarField(particles.nParticles(), state[v]);
    }
    return W;
}


//- Walls of a velocity along x, all else the fluid's own
void setWalls
(
    givenStates& faces,
    const faceStates::treatment type,
    const scalar velocity
)
{
    faces.setTreatment(type);
    for (label v = 0; v < faces.nVariables(); ++v)
    {
        if (v == 1 || v == 2)
        {
            faces.set(v, v == 1 ? velocity : 0);
        }
        else
        {
            faces.setOwn(v);
        }
    }
}


//- Momentum that the fluid gains and the walls give agree
template<class Fluid>
void checkMomentum
(
    const Fluid& fluid,
    const dictionary& dict,
    const faceStates::treatment type,
    const scalarList& base,
    const scalarList& range
)
{
    const contactChannel particles(0.3);
    givenStates faces(particles(), base.size());
    setWalls(faces, type, 0.3);

    Random random(5);
    List<scalarField> W(uniform(particles(), base));
    forAll(W, v)
    {
        for (scalar& value : W[v])
        {
            value += range[v]*(random.sample01<scalar>() - 0.5);
        }
    }

    autoPtr<conservationLaw> law(conservationLaw::New(dict, fluid, faces));
    law->setPrimitive(W);
    vector before(Zero);
    for (const label d : {0, 1})
    {
        before[d] = sum(particles().V()*law->conserved(1 + d));
    }

    const scalar dt = 1e-4;
    const List<scalarField> Q(afterStep(*law, W, dt));

    const vectorField& pressure = faces.pressureForce();
    const vectorField& viscous = faces.viscousForce();
    const scalar size = sum(mag(pressure) + mag(viscous));
    EXPECT_GT(mag(sum(viscous)), type == faceStates::slip ? -1 : 0);

    for (const label d : {0, 1})
    {
        const scalar gain =
            (sum(particles().V()*Q[1 + d]) - before[d])/dt;
        EXPECT_NEAR(gain, -sum(pressure + viscous)[d], 1e-9*size);
    }
}


//- A uniform flow towards solid particles that mirror it is that of a channel
//- whose outer particles carry the mirrored velocities
template<class Fluid>
void checkMirror
(
    const Fluid& fluid,
    const word& flux,
    const scalarList& state,
    const faceStates::treatment type
)
{
    const dictionary dict(schemes(flux, "none"));
    const scalar dt = 1e-4;

    const contactChannel particles(0);
    givenStates walls(particles(), state.size());
    setWalls(walls, type, 0);
    autoPtr<conservationLaw> law(conservationLaw::New(dict, fluid, walls));
    const List<scalarField> Q
    (
        afterStep(*law, uniform(particles(), state), dt)
    );

    const std::unique_ptr<particleScene> wide(channel(4*dp));
    const auto all = wide->assemble("type surfaceVector;");
    List<scalarField> W(uniform(*all, state));
    forAll(all->C(), i)
    {
        if (all->C()[i].y() < 0 || all->C()[i].y() > 1)
        {
            W[1][i] *= type == faceStates::noSlip ? -1 : 1;
            W[2][i] *= -1;
        }
    }
    givenStates outer(*all, state.size());
    setWalls(outer, type, 0);
    autoPtr<conservationLaw> wideLaw
    (
        conservationLaw::New(dict, fluid, outer)
    );
    const List<scalarField> wideQ(afterStep(*wideLaw, W, dt));

    const List<scalarField> undisturbed
    (
        afterStep(*law, uniform(particles(), state), 0)
    );
    label nMatched = 0;
    label nNearWall = 0;
    forAll(particles().C(), i)
    {
        forAll(all->C(), j)
        {
            if (mag(particles().C()[i] - all->C()[j]) < 1e-6*dp)
            {
                ++nMatched;
                forAll(Q, v)
                {
                    EXPECT_NEAR
                    (
                        Q[v][i],
                        wideQ[v][j],
                        1e-10*mag(undisturbed[v][i])
                    ) << flux << " " << v << " at y = " << all->C()[j].y();
                }
                if (mag(Q[0][i] - undisturbed[0][i]) > 1e-8*mag(Q[0][i]))
                {
                    ++nNearWall;
                }
            }
        }
    }
    EXPECT_EQ(nMatched, particles().nParticles());
    EXPECT_GT(nNearWall, 0);
}


//- The error of treatedParticleMesh for sphSchemes and closure; empty if none
std::string treatmentError(const word& treatment, const std::string& closure)
{
    const std::unique_ptr<particleScene> scene(channel());
    const auto particles = scene->assemble(closure);
    scene->files().write
    (
        "sph/system/sphSchemes",
        "boundaryTreatment " + treatment + ";"
    );
    return errorMessage([&] { treatedParticleMesh(particles->mesh()); });
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * //

TEST(Contact, ClosesTheParticlesOfALatticeAtAWall)
{
    const contactChannel particles(0);

    EXPECT_LT(max(mag(areaSums(particles()))), 1e-12*dp);
}


TEST(Contact, HasTheAreaOfTheWall)
{
    const contactChannel particles(0);

    for (const word& name : {word("bottom"), word("top")})
    {
        const particlePatch& patch = particles().boundary()
        [
            particles().mesh().boundaryMesh().findPatchID(name)
        ];
        const vector area(sum(patch.Sf()));
        EXPECT_NEAR(mag(area), 0.1, 1e-12);
        EXPECT_NEAR(area.y(), name == "top" ? mag(area) : -mag(area), 1e-12);
    }
}


TEST(Contact, LeavesOtherPatchesTheirSurfaceVectors)
{
    const contactChannel particles(0.3, false);
    const vectorField residual(areaSums(particles()));
    const boundaryFaces& faces = particles().boundary().faces();

    labelList nPairs(particles().nParticles(), Zero);
    forAll(faces.owner, facei)
    {
        nPairs[faces.owner[facei]] += mag(faces.wallNormal[facei]) > 0;
    }

    for (const word& name : {word("left"), word("right")})
    {
        const particlePatch& patch = particles().boundary()
        [
            particles().mesh().boundaryMesh().findPatchID(name)
        ];
        label nAtCorners = 0;
        forAll(patch.owner(), k)
        {
            EXPECT_EQ(mag(faces.wallNormal[patch.start() + k]), 0);
            EXPECT_LT(mag(residual[patch.owner()[k]]), 1e-12*dp);
            nAtCorners += nPairs[patch.owner()[k]] > 0;
        }
        EXPECT_GT(nAtCorners, 0);
    }
}


TEST(Contact, LeavesAFluidAtRestToTheErrorOfTheClosure)
{
    for (const scalar jitter : {0.0, 0.3})
    {
        const contactChannel particles(jitter);
        const vectorField residual(areaSums(particles()));
        EXPECT_EQ(max(mag(residual)) > 1e-6*dp, jitter > 0);

        const scalar p = 7;
        givenStates faces(particles(), 3);
        setWalls(faces, faceStates::noSlip, 0);
        autoPtr<conservationLaw> law
        (
            conservationLaw::New
            (
                schemes("linearisedLimited", "linear"), water, faces
            )
        );
        const scalar dt = 1e-4;
        const List<scalarField> Q
        (
            afterStep(*law, uniform(particles(), {p, 0, 0}), dt)
        );

        forAll(residual, i)
        {
            const scalar impulse = dt*p/particles().V()[i];
            EXPECT_NEAR(Q[0][i], p, 1e-12*p);
            EXPECT_NEAR(Q[1][i], -impulse*residual[i].x(), 1e-13);
            EXPECT_NEAR(Q[2][i], -impulse*residual[i].y(), 1e-13);
        }
    }
}


TEST(Contact, GivesTheWallTheMomentumOfTheFluid)
{
    for (const word& reconstruction : {word("none"), word("linear")})
    {
        for (const auto type : {faceStates::noSlip, faceStates::slip})
        {
            checkMomentum
            (
                water,
                schemes("linearisedLimited", reconstruction),
                type,
                {1, 0.5, 0.1},
                {1, 1, 1}
            );
            checkMomentum
            (
                viscousAir,
                schemes("HLLC", reconstruction),
                type,
                {300, 50, 10, 1e5},
                {10, 20, 20, 1e3}
            );
        }
    }
}


TEST(Contact, MirrorsTheStateOfTheFluid)
{
    for (const word& flux : {word("linearised"), word("linearisedLimited")})
    {
        const scalarList state({1, 0.5, 0.2});
        checkMirror(water, flux, state, faceStates::noSlip);
        checkMirror(inviscidWater, flux, state, faceStates::slip);
    }
    for (const word& flux : {word("HLLC"), word("HLLCLimited")})
    {
        const scalarList state({300, 50, 20, 1e5});
        checkMirror(viscousAir, flux, state, faceStates::noSlip);
        checkMirror(inviscidAir, flux, state, faceStates::slip);
    }
}


TEST(Contact, SaysWhatItNeeds)
{
    for (const char* closure : {"type surfaceVector;", "type consistent;"})
    {
        const std::string message(treatmentError("contact", closure));
        EXPECT_NE
        (
            message.find("needs particles of solid bodies"), std::string::npos
        )   << message;
        EXPECT_NE
        (
            message.find("set 'closure {type surfaceVector;}'"),
            std::string::npos
        )   << message;
    }
    EXPECT_NE
    (
        treatmentError("mirror", "type surfaceVector;").find
        (
            "Unknown boundaryTreatment mirror"
        ),
        std::string::npos
    );
    EXPECT_EQ(treatmentError("surfaceVector", "type consistent;"), "");
}


TEST(Contact, NeedsAWall)
{
    const contactChannel particles(0);
    const fvMesh& mesh = particles().mesh();
    const auto io = [&](const word& name)
    {
        return IOobject(name, mesh.time().timeName(), mesh);
    };

    volVectorField U
    (
        io("U"), mesh, dimensionedVector(dimVelocity, Zero), "zeroGradient"
    );
    volScalarField p
    (
        io("p"), mesh, dimensionedScalar(sqr(dimVelocity), Zero),
        "zeroGradient"
    );
    surfaceScalarField phi
    (
        io("phi"), mesh, dimensionedScalar(dimVolume/dimTime, Zero)
    );

    EXPECT_NE
    (
        errorMessage
        (
            [&] { boundaryStates(particles(), U, {{p, 0}}, phi, true); }
        ).find("U has a boundary condition of type zeroGradient there"),
        std::string::npos
    );
}


TEST(Contact, needsParticlesAtTheWall)
{
    // The cells at the left are cut out
    testCase::layout layout;
    layout.hole = boundBox(point(-1, -1, -1), point(0.1, 2, 1));
    testCase c(layout);

    boundaryFaces faces;
    faces.start = labelList({0, 1});
    faces.owner = labelList({0});
    faces.Cf = pointField(1, point::zero);
    const std::string message
    (
        errorMessage
        (
            [&]
            {
                writeContactBoundary(particleFiles(c.time()), c.mesh(), faces);
            }
        )
    );
    EXPECT_NE
    (
        message.find("Patch left has solid particles behind it, but no"),
        std::string::npos
    )   << message;
    EXPECT_NE(message.find("entry spacing"), std::string::npos) << message;
}


// ************************************************************************* //
