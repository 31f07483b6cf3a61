/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "uniformSpacing.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    defineTypeNameAndDebug(uniformSpacing, 0);
    addToRunTimeSelectionTable(spacingFunction, uniformSpacing, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::uniformSpacing::uniformSpacing
(
    const patchSurface& surface,
    const dictionary& dict
)
{
    const scalar dp = positive(dict, "value");
    setRange(dp, dp);
}


// ************************************************************************* //
