/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "wallStencil.H"
#include "scalarMatrices.H"
#include "surfaceFields.H"
#include "SVD.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{

//- From the cell centres of a patch's faces to what gives the values there: the
//- cell centre across a coupled patch, the face centre if values are known
static vectorField toValues(const fvPatch& patch, const bool known)
{
    if (patch.coupled())
    {
        return patch.delta();
    }

    return known ? vectorField(patch.Cf() - patch.Cn()) : vectorField();
}


//- 1 in the directions that the mesh solves, 0 in those of empty patches
static vector solvedDirections(const polyMesh& mesh)
{
    vector solved(Zero);
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        solved[d] = mesh.solutionD()[d] == 1;
    }

    return solved;
}


//- Pseudo-inverse of the matrix of the given rows, as columns
static List<vector> pseudoInverse(const UList<vector>& rows)
{
    constexpr direction nCmpts = vector::nComponents;

    // Singular values below do not count: all neighbours in a plane or line
    constexpr scalar smallest = 1e-3;

    // Rows of zeros for cells with fewer neighbours than directions
    scalarRectangularMatrix matrix
    (
        max(rows.size(), label(nCmpts)),
        nCmpts,
        Zero
    );
    forAll(rows, i)
    {
        for (direction d = 0; d < nCmpts; ++d)
        {
            matrix[i][d] = rows[i][d];
        }
    }

    const scalarRectangularMatrix inverse(SVD(matrix, smallest).VSinvUt());
    List<vector> columns(rows.size());
    forAll(columns, i)
    {
        for (direction d = 0; d < nCmpts; ++d)
        {
            columns[i][d] = inverse[d][i];
        }
    }

    return columns;
}

} // End namespace SPH
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::wallStencil::append
(
    const label facei,
    const UList<vectorField>& toPatchValues
)
{
    const fvMesh& mesh = patch_.boundaryMesh().mesh();
    const vectorField& C = mesh.cellCentres();
    const label celli = patch_.faceCells()[facei];

    for (const label meshFacei : mesh.cells()[celli])
    {
        if (mesh.isInternalFace(meshFacei))
        {
            const label other =
                mesh.faceOwner()[meshFacei] == celli
              ? mesh.faceNeighbour()[meshFacei]
              : mesh.faceOwner()[meshFacei];

            neighbours_.append(neighbour{-1, other, C[other] - C[celli]});
            continue;
        }

        const label patchi = mesh.boundaryMesh().whichPatch(meshFacei);
        if (toPatchValues[patchi].size())
        {
            const label i = meshFacei - mesh.boundaryMesh()[patchi].start();
            neighbours_.append(neighbour{patchi, i, toPatchValues[patchi][i]});
        }
    }
}


void Foam::SPH::wallStencil::fit(const label facei)
{
    const label start = start_[facei];
    const label n = start_[facei + 1] - start;
    const vector solved(solvedDirections(patch_.boundaryMesh().mesh()));
    const vector normal(patch_.Sf()[facei]/patch_.magSf()[facei]);
    const vector toFace
    (
        patch_.Cf()[facei]
      - patch_.boundaryMesh().mesh().cellCentres()[patch_.faceCells()[facei]]
    );
    const vector along(toFace - (toFace & normal)*normal);

    // Equations, each divided by the distance
    List<vector> rows(n);
    scalarList weights(n);
    scalarList quadratic(n);
    forAll(rows, i)
    {
        const vector d(cmptMultiply(neighbours_[start + i].d, solved));
        weights[i] = 1/max(mag(d), VSMALL);
        rows[i] = weights[i]*d;
        quadratic[i] = weights[i]*sqr(normal & d);
    }

    const List<vector> inverse(pseudoInverse(rows));

    // The part of the quadratic term that no linear field can have
    vector linear(Zero);
    scalar whole = 0;
    forAll(rows, i)
    {
        linear += inverse[i]*quadratic[i];
        whole += sqr(quadratic[i]);
    }
    scalar rest = 0;
    forAll(rows, i)
    {
        quadratic[i] -= rows[i] & linear;
        rest += sqr(quadratic[i]);
    }

    // Without the quadratic term if its coefficient is ill-determined or if the
    // explicit gradient would outweigh the implicit one
    constexpr scalar smallestRest = 0.01;

    // Divided by even where not used, once vectorised
    const scalar perRest = 1/max(rest, VSMALL);

    for (const bool withQuadratic : {rest > smallestRest*whole, false})
    {
        for (label i = 0; i < n; ++i)
        {
            vector coefficient(inverse[i]);
            if (withQuadratic)
            {
                coefficient -= (quadratic[i]*perRest)*linear;
            }
            coefficient *= weights[i];

            neighbours_[start + i].normal = normal & coefficient;
            neighbours_[start + i].tangential = along & coefficient;
        }

        if (stable(facei))
        {
            break;
        }
    }
}


bool Foam::SPH::wallStencil::stable(const label facei) const
{
    scalar sum = 0;
    for (label i = start_[facei]; i < start_[facei + 1]; ++i)
    {
        sum += mag(neighbours_[i].normal);
    }

    return sum <= 2*deltaCoeffs_[facei];
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::wallStencil::wallStencil
(
    const fvPatch& patch,
    const boolUList& known
)
:
    patch_(patch),
    deltaCoeffs_(patch.deltaCoeffs()),
    start_(patch.size() + 1, Zero)
{
    const fvBoundaryMesh& boundary = patch.boundaryMesh();
    List<vectorField> toPatchValues(boundary.size());
    forAll(boundary, patchi)
    {
        toPatchValues[patchi] =
            toValues
            (
                boundary[patchi],
                known[patchi] || patchi == patch.index()
            );
    }

    forAll(patch, facei)
    {
        append(facei, toPatchValues);
        start_[facei + 1] = neighbours_.size();
        fit(facei);
    }
    neighbours_.shrink();
}


// ************************************************************************* //
