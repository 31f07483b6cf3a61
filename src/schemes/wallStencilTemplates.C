/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "wallStencil.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::SPH::wallStencil::gradient
(
    const GeometricField<Type, fvPatchField, volMesh>& vf,
    const bool tangential
) const
{
    const auto& boundary = vf.boundaryField();
    PtrList<Field<Type>> farValues(boundary.size());
    forAll(boundary, patchi)
    {
        if (boundary[patchi].coupled())
        {
            farValues.set(patchi, boundary[patchi].patchNeighbourField());
        }
    }

    const labelUList& cells = patch_.faceCells();

    tmp<Field<Type>> tresult(new Field<Type>(patch_.size(), Zero));
    Field<Type>& result = tresult.ref();

    forAll(result, facei)
    {
        const scalar perTangential =
            tangential ? 2*deltaCoeffs_[facei] : scalar(0);

        for (label i = start_[facei]; i < start_[facei + 1]; ++i)
        {
            const neighbour& n = neighbours_[i];

            const Type& value =
                n.patchi < 0 ? vf[n.index]
              : farValues.set(n.patchi) ? farValues[n.patchi][n.index]
              : boundary[n.patchi][n.index];

            result[facei] +=
                (n.normal + perTangential*n.tangential)
               *(value - vf[cells[facei]]);
        }
    }

    return tresult;
}


// ************************************************************************* //
