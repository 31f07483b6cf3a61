/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    Tests of the boundary faces of particles: whose they are and where.

\*---------------------------------------------------------------------------*/

#include "particleScene.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

namespace
{

//- Name of a scene
class WallFaces
:
    public testing::TestWithParam<const char*>
{
protected:

    std::unique_ptr<particleScene> scene =
        particleScene::New(GetParam(), 0.3);
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_P(WallFaces, belongToTheFirstLayer)
{
    const auto m = scene->assemble("type consistent; order 0;");
    const boundaryFaces& faces = m->data().boundary;

    forAll(faces.owner, s)
    {
        const label i = faces.owner[s];
        const scalar height =
            ((faces.Cf[s] - m->C()[i]) & faces.Sf[s])/mag(faces.Sf[s]);

        // Particles of a lattice that begins half a spacing from the wall,
        // moved by less than half a spacing
        EXPECT_GT(height, 0);
        EXPECT_LT(height, m->spacing()[i]);
    }
}


INSTANTIATE_TEST_SUITE_P
(
    Scenes,
    WallFaces,
    testing::Values("box", "hole", "channel", "cube")
);


// ************************************************************************* //
