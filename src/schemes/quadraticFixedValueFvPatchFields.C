/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "quadraticFixedValueFvPatchField.H"
#include "addToRunTimeSelectionTable.H"
#include "fvPatchFields.H"
#include "volMesh.H"

// * * * * * * * * * * * * * * * Registration  * * * * * * * * * * * * * * * //

// OpenFOAM's macros specialise templates of its own namespace
namespace Foam
{
    using SPH::quadraticFixedValueFvPatchField;

    makePatchTypeFieldTypedefs(quadraticFixedValue);
    makePatchFields(quadraticFixedValue);
}

// ************************************************************************* //
