/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "componentPreconditioner.H"
#include "ListOps.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    static dictionary controls(const word& preconditioner)
    {
        dictionary cycle;
        cycle.add("preconditioner", preconditioner);
        cycle.add("agglomerator", "algebraicPair");
        cycle.add("smoother", "GaussSeidel");
        cycle.add("nPreSweeps", 0);
        cycle.add("nPostSweeps", 1);
        cycle.add("nVcycles", 1);
        cycle.add("nCellsInCoarsestLevel", 10);
        cycle.add("tolerance", SMALL);
        cycle.add("relTol", 0.1);

        dictionary dict;
        dict.add("solver", "PCG");
        dict.add("preconditioner", cycle);
        return dict;
    }
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::componentPreconditioner::graphMesh::graphMesh
(
    const pairGraph& graph,
    labelList&& lower,
    labelList&& upper
)
:
    lduPrimitiveMesh
    (
        graph.nParticles(), lower, upper, UPstream::worldComm, true
    ),
    registry_
    (
        IOobject
        (
            "pairSystem",
            graph.time().timeName(),
            graph.time(),
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        )
    )
{}


Foam::SPH::componentPreconditioner::componentPreconditioner
(
    const pairGraph& graph,
    const scalarField& weights,
    const scalarField& anchors,
    const scalarField& least,
    const labelList& order,
    const word& type
)
:
    order_(order),
    coeffs_(0)
{
    // Keeps systems without anchors regular
    constexpr scalar shift = 1e-9;

    DynamicList<label> lower(weights.size());
    DynamicList<label> upper(weights.size());
    DynamicList<scalar> coefficients(weights.size());
    const labelList place(invert(order.size(), order));
    scalarField diagonal(order.size());
    forAll(order, row)
    {
        const label i = order[row];
        DynamicList<label> others;
        DynamicList<label> pairs;
        scalar sum = anchors[i];
        graph.forLinks
        (
            i,
            [&](const label j, const label pairi)
            {
                sum += weights[pairi];
                if (place[j] > row)
                {
                    others.append(place[j]);
                    pairs.append(pairi);
                }
            }
        );
        diagonal[row] = max((1 + shift)*sum, least[i]);
        for (const label k : sortedOrder(others))
        {
            lower.append(row);
            upper.append(others[k]);
            coefficients.append(-weights[pairs[k]]);
        }
    }

    mesh_.reset(new graphMesh(graph, std::move(lower), std::move(upper)));
    matrix_.reset(new lduMatrix(mesh_()));
    matrix_->diag() = diagonal;
    matrix_->upper() = coefficients;

    const dictionary dict(controls(type));
    solver_ = lduMatrix::solver::New
    (
        "pairSystem", matrix_(), coeffs_, coeffs_, interfaces_, dict
    );
    preconditioner_ = lduMatrix::preconditioner::New(solver_(), dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::componentPreconditioner::precondition
(
    scalarField& z,
    const scalarField& r,
    const label width,
    const label e
) const
{
    solveScalarField rOrdered(order_.size());
    solveScalarField zOrdered(order_.size());
    forAll(order_, row)
    {
        rOrdered[row] = r[order_[row]*width + e];
    }
    preconditioner_->precondition(zOrdered, rOrdered);
    forAll(order_, row)
    {
        z[order_[row]*width + e] = zOrdered[row];
    }
}


// ************************************************************************* //
