/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    The central-upwind flux under its name in system/sphSchemes.

\*---------------------------------------------------------------------------*/

#include "KurganovFlux.H"
#include "pairOperator.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    struct KurganovLaw
    {
        static autoPtr<conservationLaw> New
        (
            const dictionary& schemes,
            const perfectGasFluid& fluid,
            faceStates& faces
        )
        {
            const auto select = [&](const auto& flux)
            {
                return selectOperator
                (
                    flux, "vanLeer", fluid.mu > 0, schemes, faces
                );
            };

            if (loopDims(faces.particles()) == 2)
            {
                return select(KurganovFlux<2>(fluid));
            }
            return select(KurganovFlux<3>(fluid));
        }
    };

    static conservationLaw::addcompressibleConstructorToTable
    <
        KurganovLaw
    > addKurganov("Kurganov");
}
}


// ************************************************************************* //
