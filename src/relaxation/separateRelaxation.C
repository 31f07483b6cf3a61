/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "separateRelaxation.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    defineTypeNameAndDebug(separateRelaxation, 0);
    addToRunTimeSelectionTable
    (
        relaxationMethod,
        separateRelaxation,
        dictionary
    );
    addNamedToRunTimeSelectionTable
    (
        relaxationMethod,
        separateRelaxation,
        dictionary,
        separateNoBoolean
    );
}
}


// ************************************************************************* //
