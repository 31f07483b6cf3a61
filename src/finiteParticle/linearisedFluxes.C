/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    The linearised fluxes under their names in system/sphSchemes.

\*---------------------------------------------------------------------------*/

#include "linearisedFlux.H"
#include "pairOperator.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Limiter of the dissipation, [B] eq. 18
    constexpr int etaLinearised = 15;

    static conservationLaw::addweaklyCompressibleConstructorToTable
    <
        fluxLaw<linearisedFlux>
    > addLinearised("linearised");

    static conservationLaw::addweaklyCompressibleConstructorToTable
    <
        fluxLaw<linearisedFlux, etaLinearised>
    > addLinearisedLimited("linearisedLimited");
}
}


// ************************************************************************* //
