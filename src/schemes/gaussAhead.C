/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "gaussAhead.H"
#include "fvMatrices.H"
#include "lastStep.H"
#include "surfaceFields.H"
#include "volFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
bool Foam::SPH::gaussAhead<Type>::lags
(
    const surfaceScalarField& flux,
    const GeometricField<Type, fvPatchField, volMesh>& vf
)
{
    return
        vf.nOldTimes() > 1
     && flux.dimensions() == dimVelocity*dimArea
     && isOfLastStep(flux);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::tmp<Foam::fvMatrix<Type>> Foam::SPH::gaussAhead<Type>::fvmDiv
(
    const surfaceScalarField& flux,
    const GeometricField<Type, fvPatchField, volMesh>& vf
) const
{
    if (!lags(flux, vf))
    {
        return fv::gaussConvectionScheme<Type>::fvmDiv(flux, vf);
    }

    const surfaceScalarField ahead
    (
        flux
      + stepRatio(this->mesh().time())
       *(flux.oldTime() - flux.oldTime().oldTime())
    );
    return fv::gaussConvectionScheme<Type>::fvmDiv(ahead, vf);
}


// * * * * * * * * * * * * * * * Registration  * * * * * * * * * * * * * * * //

// OpenFOAM's macro looks for schemes in its own namespace
namespace Foam
{
namespace fv
{
    using SPH::gaussAhead;
}
}

makeFvConvectionScheme(gaussAhead)

// ************************************************************************* //
