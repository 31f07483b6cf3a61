/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    Particles in a zone of an FVM mesh: which cells the zone has, and the mesh
    of particles and FVM cells together, written and read back. Whatever the
    zone looks like, an FVM cell keeps its volume and centre and a particle is
    closed.

\*---------------------------------------------------------------------------*/

#include "closure.H"
#include "particleGenerator.H"
#include "particleMeshAssembly.H"
#include "particleResults.H"
#include "particlesToMesh.H"
#include "particleScene.H"
#include "particleFiles.H"
#include "particleMoments.H"
#include "startFields.H"
#include "zoneCells.H"
#include "zoneParticles.H"
#include "labelIOList.H"
#include "StringStream.H"

#include <cmath>
#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

dictionary dictOf(const std::string& text)
{
    IStringStream is(text);
    return dictionary(is);
}


//- A case with particles in a zone, written and read back
class zoneCase
{
    static dictionary withDefaults(const std::string& text)
    {
        dictionary dict(dictOf(text));
        dict.add("spacing", "fromMesh");
        dict.add("relaxation", dictOf("maxIterations 200;"));
        return dict;
    }

public:

    testCase files;

    const dictionary dict;

    particleZone zone;

    particleCase sph;

    zoneCase(const testCase::layout& layout, const std::string& text)
    :
        files(layout),
        dict(withDefaults(text)),
        zone(files.mesh(), dict),
        sph(files.mesh())
    {
        particleGenerator generator(zone.mesh(), dict);
        generator.generate();
        const autoPtr<closure> method
        (
            closure::New(dict.subOrEmptyDict("closure"))
        );
        const particleMeshData data
        (
            assembleParticleMesh
            (
                zone.mesh(),
                generator.W(),
                generator.fluid(),
                generator.fluidDistance(),
                *method
            )
        );

        dictionary properties;
        properties.add("digest", word("test"));
        properties.add(dict.lookupEntry("zone", keyType::LITERAL));
        sph.writeMesh
        (
            properties, zone, data, List<particleSet>(), boundaryFaces()
        );
    }

    const fvMesh& fvm()
    {
        return files.mesh();
    }

    const fvMesh& mesh()
    {
        return sph.particles().mesh();
    }
};


//- The layouts: square, skewed (no right angles, graded), hole, channel
//  (periodic in x), cube
testCase::layout layoutOf(const std::string& name)
{
    testCase::layout layout;
    layout.nCells = labelVector(14, 14, 1);
    if (name == "skewed")
    {
        layout.transform = [](const point& p)
        {
            return point
            (
                p.x() + 0.3*p.y()*p.y(), p.y()*(0.7 + 0.3*p.y()), p.z()
            );
        };
    }
    else if (name == "hole")
    {
        layout.hole = boundBox(point(0.4, 0.4, -1), point(0.6, 0.6, 1));
    }
    else if (name == "channel")
    {
        layout.periodic[0] = true;
    }
    else if (name == "cube")
    {
        layout.twoD = false;
        layout.nCells = labelVector(7, 7, 7);
        layout.box = boundBox(point(0, 0, 0), point(1, 1, 1));
    }
    return layout;
}


//- Layout, zone
struct zoneParameter
{
    const char* name;
    const char* layout;
    const char* zone;
};

std::ostream& operator<<(std::ostream& os, const zoneParameter& p)
{
    return os << p.name;
}


const zoneParameter zoneParameters[] =
{
    {"box", "square", "{type boxToCell; box (0.22 0.22 -1) (0.78 0.78 2);}"},
    {
        "staircase", "square",
        "{type cylinderToCell; p1 (0.5 0.5 -1); p2 (0.5 0.5 2);"
        " radius 0.35;}"
    },
    {"skewed", "skewed", "{type boxToCell; box (0.3 0.2 -1) (0.9 0.7 2);}"},
    {"corner", "square", "{type boxToCell; box (-1 -1 -1) (0.5 0.5 2);}"},
    {
        "two", "square",
        "{a {type boxToCell; box (-1 -1 -1) (0.4 2 2);}"
        " b {type boxToCell; box (0.6 0.3 -1) (0.9 0.7 2);}}"
    },
    {
        "body", "hole",
        "{type patchDistanceToCell; patches (hole); distance 0.2;}"
    },
    {
        "ring", "hole",
        "{a {type patchDistanceToCell; patches (hole); distance 0.35;}"
        " b {type patchDistanceToCell; patches (hole); distance 0.1;"
        " action subtract;}}"
    },
    {"cells", "hole", "{type boxToCell; box (0.7 -1 -1) (2 2 2);}"},
    {
        "inChannel", "channel",
        "{type boxToCell; box (0.2 0.3 -1) (0.8 0.7 2);}"
    },
    {
        "acrossChannel", "channel",
        "{type boxToCell; box (-1 0.3 -1) (2 0.8 2);}"
    },
    {"cutBody", "hole", "{type boxToCell; box (0.5 0.1 -1) (0.9 0.9 2);}"},
    {"strip", "square", "{type boxToCell; box (0.5 -1 -1) (0.57 2 2);}"},
    {"cube", "cube", "{type boxToCell; box (0.2 0.2 0.2) (0.8 0.8 2);}"}
};


class Zone
:
    public testing::TestWithParam<zoneParameter>
{};

}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_P(Zone, fvmCellsKeepVolumeAndCentreAndParticlesAreClosed)
{
    zoneCase z
    (
        layoutOf(GetParam().layout), std::string("zone ") + GetParam().zone
    );
    const fvMesh& fvm = z.fvm();
    const fvMesh& mesh = z.mesh();
    const labelList& cellMap = z.sph.particles().cellMap();
    ASSERT_EQ(cellMap.size(), mesh.nCells());

    label nFvm = 0;
    scalar volume = 0;
    scalar centre = 0;
    forAll(cellMap, celli)
    {
        if (cellMap[celli] >= 0)
        {
            const label fvmCelli = cellMap[celli];
            EXPECT_FALSE(z.zone.inside()[fvmCelli]);
            ++nFvm;
            volume = max
            (
                volume,
                mag(mesh.V()[celli]/fvm.V()[fvmCelli] - 1)
            );
            centre = max
            (
                centre,
                mag(mesh.cellCentres()[celli] - fvm.cellCentres()[fvmCelli])
            );
        }
    }
    EXPECT_EQ(nFvm, fvm.nCells() - z.zone.mesh().nCells());
    EXPECT_GT(mesh.nCells(), nFvm);
    EXPECT_LT(volume, 1e-12);
    EXPECT_LT(centre, 1e-12);
    EXPECT_NEAR(sum(mesh.V()).value()/sum(fvm.V()).value(), 1, 1e-12);

    vectorField residual(mesh.nCells(), Zero);
    forAll(mesh.faceAreas(), facei)
    {
        residual[mesh.faceOwner()[facei]] += mesh.faceAreas()[facei];
        if (facei < mesh.nInternalFaces())
        {
            residual[mesh.faceNeighbour()[facei]] -= mesh.faceAreas()[facei];
        }
    }
    const scalar side = Foam::cbrt(min(mesh.V()).value());
    EXPECT_LT(max(mag(residual)), 1e-12*sqr(side));
}


TEST_P(Zone, partsOfABorderFaceHaveItsAreaAndFirstMoment)
{
    zoneCase z
    (
        layoutOf(GetParam().layout), std::string("zone ") + GetParam().zone
    );
    const fvMesh& fvm = z.fvm();
    const fvMesh& mesh = z.mesh();
    const labelList& cellMap = z.sph.particles().cellMap();
    const labelIOList faceMap
    (
        particleFiles(mesh.time()).arrayIO("faceMap")
    );
    ASSERT_EQ(faceMap.size(), mesh.nFaces());
    ASSERT_EQ(mesh.faceZones().size(), 1);
    ASSERT_EQ(mesh.cellZones().names(), wordList({"fvm", "sph"}));
    EXPECT_EQ
    (
        mesh.cellZones()[0].size() + mesh.cellZones()[1].size(),
        mesh.nCells()
    );

    // Towards the particles, as the flips of the zone have it
    const faceZone& interface = mesh.faceZones()[0];
    EXPECT_EQ(interface.name(), "interface");
    vectorField area(fvm.nFaces(), Zero);
    vectorField moment(fvm.nFaces(), Zero);
    boolList isBorder(fvm.nFaces(), false);
    forAll(interface, k)
    {
        const label facei = interface[k];
        const label fvmFacei = faceMap[facei];
        const vector Sf
        (
            (interface.flipMap()[k] ? -1.0 : 1.0)*mesh.faceAreas()[facei]
        );
        const label from = interface.flipMap()[k]
          ? mesh.faceNeighbour()[facei]
          : mesh.faceOwner()[facei];
        EXPECT_GE(cellMap[from], 0);

        isBorder[fvmFacei] = true;
        area[fvmFacei] += Sf;
        moment[fvmFacei] += mag(Sf)*mesh.faceCentres()[facei];
    }

    label nBorder = 0;
    forAll(isBorder, facei)
    {
        if (isBorder[facei])
        {
            ++nBorder;
            const scalar a = mag(fvm.faceAreas()[facei]);
            const bool turned = z.zone.inside()[fvm.faceOwner()[facei]];
            EXPECT_LT
            (
                mag(area[facei] - (turned ? -1.0 : 1.0)*fvm.faceAreas()[facei]),
                1e-12*a
            );
            EXPECT_LT(mag(moment[facei]/a - fvm.faceCentres()[facei]), 1e-12);
        }
    }
    const polyPatch& border =
        z.zone.mesh().boundaryMesh()[z.zone.borderPatch()];
    EXPECT_EQ(nBorder, border.size());
}


TEST_P(Zone, particlesDifferentiateLinearFields)
{
    zoneCase z
    (
        layoutOf(GetParam().layout), std::string("zone ") + GetParam().zone
    );
    const particleMesh all(z.mesh());
    const auto particles = zoneParticles(z.zone, all, z.sph.particles().cellMap());

    const tensorField moments(firstMoments(particles->data()));
    const tensor I(particles->space().identity());
    scalar largest = 0;
    forAll(moments, i)
    {
        largest = max(largest, mag(moments[i]/particles->V()[i] - I));
    }

    EXPECT_LT(largest, 1e-10);
}


INSTANTIATE_TEST_SUITE_P
(
    zones,
    Zone,
    testing::ValuesIn(zoneParameters),
    [](const testing::TestParamInfo<zoneParameter>& info)
    {
        return std::string(info.param.name);
    }
);


TEST(ZoneFields, fvmCellsKeepTheirValuesThereAndBack)
{
    zoneCase z
    (
        layoutOf("square"),
        "zone {type boxToCell; box (0.3 0.3 -1) (0.8 0.8 2);}"
    );
    const fvMesh& fvm = z.fvm();
    std::string values("nonuniform List<scalar> ");
    values += std::to_string(fvm.nCells()) + '(';
    for (const point& x : fvm.cellCentres())
    {
        values += std::to_string(std::sin(5*x.x()) + x.y()) + ' ';
    }
    z.files.write
    (
        "0/f",
        "dimensions [0 0 0 0 0 0 0]; internalField " + values + ");"
        " boundaryField { \".*\" {type zeroGradient;}"
        " frontAndBack {type empty;} }",
        "volScalarField"
    );
    startFields(fvm, z.sph).write();

    const fvMesh& mesh = z.mesh();
    const IOobject io("f", "0", mesh, IOobject::MUST_READ);
    const volScalarField f(io, mesh);
    const volScalarField fvmF
    (
        IOobject("f", "0", fvm, IOobject::MUST_READ), fvm
    );
    forAll(z.sph.particles().cellMap(), celli)
    {
        const label fvmCelli = z.sph.particles().cellMap()[celli];
        if (fvmCelli >= 0)
        {
            EXPECT_EQ(f[celli], fvmF[fvmCelli]);
        }
        else
        {
            const point& x = mesh.cellCentres()[celli];
            EXPECT_NEAR(f[celli], std::sin(5*x.x()) + x.y(), 0.03);
        }
    }
}


TEST(ZoneCells, cellsWithinADistanceOfPatches)
{
    testCase files(layoutOf("hole"));
    const boolList near
    (
        zoneCells
        (
            files.mesh(),
            dictOf
            (
                "zone {type patchDistanceToCell; patches (left right);"
                " distance 0.2;}"
            )
        )
    );
    forAll(near, celli)
    {
        const scalar x = files.mesh().cellCentres()[celli].x();
        EXPECT_EQ(near[celli], x < 0.2 || x > 0.8) << x;
    }
}


TEST(ZoneCells, sourcesOneAfterTheOther)
{
    testCase files(layoutOf("square"));
    const boolList chosen
    (
        zoneCells
        (
            files.mesh(),
            dictOf
            (
                "zone {"
                " a {type boxToCell; box (0 0 -1) (0.5 1 1);}"
                " b {type boxToCell; box (0 0 -1) (1 0.5 1); action subset;}"
                " c {type boxToCell; box (0 0 -1) (0.2 1 1);"
                " action subtract;} }"
            )
        )
    );
    forAll(chosen, celli)
    {
        const point& x = files.mesh().cellCentres()[celli];
        EXPECT_EQ(chosen[celli], x.x() > 0.2 && x.x() < 0.5 && x.y() < 0.5);
    }
}


TEST(ZoneCells, wrongZonesAreRefused)
{
    testCase files(layoutOf("square"));
    const auto message = [&](const std::string& text)
    {
        return errorMessage
        (
            [&]() { zoneCells(files.mesh(), dictOf("zone " + text)); }
        );
    };

    EXPECT_NE(message("nowhere;").find("nowhere"), std::string::npos);
    EXPECT_NE(message("nowhere;").find("boxToCell"), std::string::npos);
    EXPECT_NE(message("(a b);").find("no cellZone"), std::string::npos);
    EXPECT_NE
    (
        message("{type boxToCell; box (5 5 5) (6 6 6);}").find("no cell"),
        std::string::npos
    );
    EXPECT_NE
    (
        message("{type patchDistanceToCell; patches (roof); distance 1;}")
       .find("roof"),
        std::string::npos
    );
    EXPECT_NE
    (
        message("{a 3;}").find("Entry a of zone is no dictionary"),
        std::string::npos
    );
    EXPECT_NE
    (
        message("{a {type boxToCell; box (0 0 0) (1 1 1); action grow;}}")
       .find("subtract"),
        std::string::npos
    );
}


TEST(ZoneCells, onlyOneOfTwoCyclicFaces)
{
    testCase::layout layout(layoutOf("square"));
    layout.periodic[0] = true;
    testCase files(layout);
    EXPECT_NE
    (
        errorMessage
        (
            [&]()
            {
                particleZone
                (
                    files.mesh(),
                    dictOf("zone {type boxToCell; box (0 0 -1) (0.4 1 1);}")
                );
            }
        ).find("only the cell at left is in the zone"),
        std::string::npos
    );
}


// ************************************************************************* //
