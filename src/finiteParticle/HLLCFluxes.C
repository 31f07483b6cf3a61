/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    The HLLC fluxes under their names in system/sphSchemes.

\*---------------------------------------------------------------------------*/

#include "HLLCFlux.H"
#include "pairOperator.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Limiter of the dissipation, [B] eq. 16
    constexpr scalar etaHLLC = 1;

    template<bool Limited, int Dim>
    static HLLCFlux<Dim> makeFlux(const perfectGasFluid& fluid)
    {
        if constexpr (Limited)
        {
            return HLLCFlux<Dim>(fluid, etaHLLC);
        }
        else
        {
            return HLLCFlux<Dim>(fluid);
        }
    }

    template<bool Limited>
    struct HLLCLaw
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
                return select(makeFlux<Limited, 2>(fluid));
            }
            return select(makeFlux<Limited, 3>(fluid));
        }
    };

    static conservationLaw::addcompressibleConstructorToTable
    <
        HLLCLaw<false>
    > addHLLC("HLLC");

    static conservationLaw::addcompressibleConstructorToTable
    <
        HLLCLaw<true>
    > addHLLCLimited("HLLCLimited");
}
}


// ************************************************************************* //
