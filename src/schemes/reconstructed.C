/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "reconstructed.H"
#include "gradScheme.H"
#include "surfaceFields.H"
#include "volFields.H"

#include <type_traits>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
Foam::ITstream& Foam::SPH::reconstructed<Type>::gradScheme
(
    const word& fieldName
) const
{
    const word name
    (
        gradName_.empty() ? word("grad(" + fieldName + ')') : gradName_
    );

    ITstream& scheme = this->mesh().gradScheme(name);
    for (const token& entry : scheme)
    {
        if (entry.isWord() && entry.wordToken() == this->type())
        {
            FatalIOErrorInFunction(scheme)
                << "The gradient " << name << " of the scheme " << this->type()
                << " is itself " << this->type() << ". Valid choices:"
                << " gradients without it, such as 'Gauss linear' or"
                << " leastSquares" << exit(FatalIOError);
        }
    }

    return scheme;
}


template<class Type>
template<class GradType, class Component>
void Foam::SPH::reconstructed<Type>::addExtrapolation
(
    const GeometricField<GradType, fvPatchField, volMesh>& gradient,
    GeometricField<Type, fvsPatchField, surfaceMesh>& faceValues,
    const Component& component
) const
{
    const fvMesh& mesh = this->mesh();
    const labelUList& owner = mesh.owner();
    const labelUList& neighbour = mesh.neighbour();
    const vectorField& C = mesh.C();
    const vectorField& Cf = mesh.Cf();

    forAll(owner, facei)
    {
        const label own = owner[facei];
        const label nei = neighbour[facei];

        component(faceValues[facei]) +=
            0.5
           *(
                ((Cf[facei] - C[own]) & gradient[own])
              + ((Cf[facei] - C[nei]) & gradient[nei])
            );
    }

    forAll(faceValues.boundaryField(), patchi)
    {
        auto& values = faceValues.boundaryFieldRef()[patchi];
        if (!values.coupled())
        {
            continue;
        }

        const fvPatch& patch = mesh.boundary()[patchi];
        const vectorField toFace(patch.Cf() - patch.Cn());
        const vectorField toNeighbour(patch.delta());
        const auto& patchGradient = gradient.boundaryField()[patchi];
        const Field<GradType> ownGradient(patchGradient.patchInternalField());
        const Field<GradType> neiGradient(patchGradient.patchNeighbourField());

        forAll(values, facei)
        {
            component(values[facei]) +=
                0.5
               *(
                    (toFace[facei] & ownGradient[facei])
                  + ((toFace[facei] - toNeighbour[facei]) & neiGradient[facei])
                );
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::tmp<Foam::GeometricField<Type, Foam::fvsPatchField, Foam::surfaceMesh>>
Foam::SPH::reconstructed<Type>::correction
(
    const GeometricField<Type, fvPatchField, volMesh>& vf
) const
{
    const fvMesh& mesh = this->mesh();

    tmp<GeometricField<Type, fvsPatchField, surfaceMesh>> tresult
    (
        new GeometricField<Type, fvsPatchField, surfaceMesh>
        (
            IOobject
            (
                "reconstructed::correction(" + vf.name() + ')',
                mesh.time().timeName(),
                mesh,
                IOobject::NO_READ,
                IOobject::NO_WRITE,
                false
            ),
            mesh,
            dimensioned<Type>(vf.dimensions(), Zero)
        )
    );
    GeometricField<Type, fvsPatchField, surfaceMesh>& result = tresult.ref();

    // From the weighted mean of both values to the plain one
    const surfaceScalarField& weights = mesh.surfaceInterpolation::weights();
    const labelUList& owner = mesh.owner();
    const labelUList& neighbour = mesh.neighbour();

    forAll(owner, facei)
    {
        result[facei] =
            (0.5 - weights[facei])*(vf[owner[facei]] - vf[neighbour[facei]]);
    }

    forAll(vf.boundaryField(), patchi)
    {
        const fvPatchField<Type>& values = vf.boundaryField()[patchi];
        if (values.coupled())
        {
            result.boundaryFieldRef()[patchi] =
                (0.5 - weights.boundaryField()[patchi])
               *(values.patchInternalField() - values.patchNeighbourField());
        }
    }

    ITstream& schemeData = gradScheme(vf.name());
    const word ownName("grad(" + vf.name() + ')');

    if constexpr
    (
        std::is_same<Type, scalar>::value || std::is_same<Type, vector>::value
    )
    {
        // The gradient that the solution may hold is that of this entry only
        const auto scheme = fv::gradScheme<Type>::New(mesh, schemeData);
        const auto gradient =
            gradName_.empty() || gradName_ == ownName
          ? scheme().grad(vf, ownName)
          : scheme().calcGrad(vf, ownName);

        addExtrapolation
        (
            gradient(), result, [](Type& value) -> Type& { return value; }
        );
    }
    else
    {
        const auto scheme = fv::gradScheme<scalar>::New(mesh, schemeData);

        for (direction cmpt = 0; cmpt < pTraits<Type>::nComponents; ++cmpt)
        {
            const volScalarField values(vf.component(cmpt));
            const auto gradient =
                scheme().calcGrad(values, "grad(" + values.name() + ')');

            addExtrapolation
            (
                gradient(),
                result,
                [cmpt](Type& value) -> scalar& { return value[cmpt]; }
            );
        }
    }

    return tresult;
}


// * * * * * * * * * * * * * * * Registration  * * * * * * * * * * * * * * * //

// OpenFOAM's macros specialise templates of its own namespace
namespace Foam
{
    using SPH::reconstructed;

    makeSurfaceInterpolationScheme(reconstructed)
}

// ************************************************************************* //
