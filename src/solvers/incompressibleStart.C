/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "incompressibleStart.H"
#include "boundaryStates.H"
#include "fixedValueFvPatchFields.H"
#include "fvcSurfaceIntegrate.H"
#include "fvMatrices.H"
#include "gaussGrad.H"
#include "gaussLaplacianScheme.H"
#include "linear.H"
#include "mixedFvPatchFields.H"
#include "surfaceFields.H"
#include "uncorrectedSnGrad.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Solve laplacian(field) = div(flux)
    static void solvePoisson
    (
        volScalarField& field,
        const surfaceScalarField& flux
    )
    {
        const fvMesh& mesh = field.mesh();
        const surfaceScalarField one
        (
            IOobject("one", mesh.time().timeName(), mesh),
            mesh,
            dimensionedScalar("one", dimless, 1)
        );

        // Schemes by hand: those of the case have no names for these terms
        fvScalarMatrix matrix
        (
            fv::gaussLaplacianScheme<scalar, scalar>
            (
                mesh,
                tmp<surfaceInterpolationScheme<scalar>>
                (
                    new linear<scalar>(mesh)
                ),
                tmp<fv::snGradScheme<scalar>>
                (
                    new fv::uncorrectedSnGrad<scalar>(mesh)
                )
            ).fvmLaplacian(one, field)
        );
        matrix.source() +=
            fvc::surfaceIntegrate(flux)().primitiveField()*mesh.V();
        if (field.needReference())
        {
            matrix.setReference(0, field[0]);
        }

        IStringStream controls
        (
            "solver PCG; preconditioner DIC; tolerance 0; relTol 1e-12;"
        );
        matrix.solve(dictionary(controls));
    }
}
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::SPH::incompressibleStart(volVectorField& U, volScalarField& p)
{
    const fvMesh& mesh = U.mesh();

    // A free stream fixes p where it leaves
    wordList types
    (
        p.boundaryField().size(),
        zeroGradientFvPatchScalarField::typeName
    );
    forAll(types, patchi)
    {
        const fvPatchScalarField& pp = p.boundaryField()[patchi];
        if (isA<mixedFvPatchScalarField>(pp))
        {
            types[patchi] = mixedFvPatchScalarField::typeName;
        }
        else if (pp.fixesValue())
        {
            types[patchi] = fixedValueFvPatchScalarField::typeName;
        }
    }
    volScalarField Phi
    (
        IOobject("Phi", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimArea/dimTime, Zero),
        types
    );
    forAll(types, patchi)
    {
        fvPatchScalarField& Phip = Phi.boundaryFieldRef()[patchi];
        if (isA<mixedFvPatchScalarField>(Phip))
        {
            mixedFvPatchScalarField& mixed =
                refCast<mixedFvPatchScalarField>(Phip);

            mixed.refValue() = Zero;
            mixed.refGrad() = Zero;
            mixed.valueFraction() =
                refCast<const mixedFvPatchScalarField>
                (
                    p.boundaryField()[patchi]
                ).valueFraction();
        }
    }

    solvePoisson
    (
        Phi, surfaceScalarField(linearInterpolate(U) & mesh.Sf())
    );
    U.primitiveFieldRef() -=
        fv::gaussGrad<scalar>::gradf(linearInterpolate(Phi), "grad(Phi)")()
       .primitiveField();
    boundaryStates::evaluateVelocity(U);

    const scalarMinMax range(gMinMax(p.primitiveField()));
    if (range.min() < range.max())
    {
        return;
    }

    // Convection; through patches that do not fix p its flux has no normal
    // part, as their pressure has no normal gradient
    const surfaceVectorField face(linearInterpolate(U));
    const surfaceVectorField momentum((face & mesh.Sf())*face);
    const volVectorField convection(fvc::surfaceIntegrate(momentum));

    surfaceScalarField force(-(linearInterpolate(convection) & mesh.Sf()));
    forAll(types, patchi)
    {
        const fvPatchScalarField& Phip = Phi.boundaryField()[patchi];
        if (isA<mixedFvPatchScalarField>(Phip))
        {
            force.boundaryFieldRef()[patchi] *=
                refCast<const mixedFvPatchScalarField>(Phip).valueFraction();
        }
        else if (!Phip.coupled() && !Phip.fixesValue())
        {
            force.boundaryFieldRef()[patchi] = Zero;
        }
    }
    solvePoisson(p, force);
    p.correctBoundaryConditions();
}


// ************************************************************************* //
