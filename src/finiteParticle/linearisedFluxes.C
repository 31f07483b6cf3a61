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
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Limiter of the dissipation, [B] eq. 18
    constexpr scalar etaLinearised = 15;

    template<bool Limited, int Dim>
    static linearisedFlux<Dim> makeFlux(const weaklyCompressibleFluid& fluid)
    {
        if constexpr (Limited)
        {
            return linearisedFlux<Dim>(fluid, etaLinearised);
        }
        else
        {
            return linearisedFlux<Dim>(fluid);
        }
    }

    template<bool Limited>
    struct linearisedLaw
    {
        static autoPtr<conservationLaw> New
        (
            const dictionary& schemes,
            const weaklyCompressibleFluid& fluid,
            faceStates& faces
        )
        {
            const auto select = [&](const auto& flux)
            {
                return selectOperator
                (
                    flux, "none", fluid.nu > 0, schemes, faces
                );
            };

            if (loopDims(faces.particles()) == 2)
            {
                return select(makeFlux<Limited, 2>(fluid));
            }
            return select(makeFlux<Limited, 3>(fluid));
        }
    };

    static conservationLaw::addweaklyCompressibleConstructorToTable
    <
        linearisedLaw<false>
    > addLinearised("linearised");

    static conservationLaw::addweaklyCompressibleConstructorToTable
    <
        linearisedLaw<true>
    > addLinearisedLimited("linearisedLimited");
}
}


// ************************************************************************* //
