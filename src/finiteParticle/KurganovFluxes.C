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
    static conservationLaw::addcompressibleConstructorToTable
    <
        fluxLaw<KurganovFlux>
    > addKurganov("Kurganov");
}
}


// ************************************************************************* //
