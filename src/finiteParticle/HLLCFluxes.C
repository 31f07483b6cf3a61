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
    constexpr int etaHLLC = 1;

    static conservationLaw::addcompressibleConstructorToTable
    <
        fluxLaw<HLLCFlux>
    > addHLLC("HLLC");

    static conservationLaw::addcompressibleConstructorToTable
    <
        fluxLaw<HLLCFlux, etaHLLC>
    > addHLLCLimited("HLLCLimited");
}
}


// ************************************************************************* //
