/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "reconstructed.H"
#include "fvcSurfaceIntegrate.H"
#include "gradScheme.H"
#include "lastStep.H"
#include "surfaceFields.H"
#include "volFields.H"

#include <type_traits>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
bool Foam::SPH::reconstructed<Type>::isAhead(const cellField& vf) const
{
    return
        flux_
     && vf.nOldTimes() > 1
     && (
            flux_->dimensions() == dimVelocity*dimArea
         || this->mesh().template foundObject<volScalarField>("rho")
        )
     && isOfLastStep(vf);
}


template<class Type>
Foam::tmp<typename Foam::SPH::reconstructed<Type>::cellField>
Foam::SPH::reconstructed<Type>::ahead(const cellField& vf) const
{
    const scalar ratio = stepRatio(this->mesh().time());
    const cellField& old = vf.oldTime();
    const cellField& older = old.oldTime();

    tmp<cellField> tresult(new cellField(vf.name() + ":ahead", vf));
    cellField& result = tresult.ref();

    result.primitiveFieldRef() +=
        ratio*(old.primitiveField() - older.primitiveField());

    for (fvPatchField<Type>& values : result.boundaryFieldRef())
    {
        // Given values are those of the present time
        if (!values.fixesValue())
        {
            const label patchi = values.patch().index();
            values ==
                values
              + ratio
               *(old.boundaryField()[patchi] - older.boundaryField()[patchi]);
        }
    }

    return tresult;
}


template<class Type>
Foam::tmp<Foam::surfaceScalarField>
Foam::SPH::reconstructed<Type>::upwindWeights() const
{
    const fvMesh& mesh = this->mesh();

    volScalarField Co(fvc::surfaceSum(mag(*flux_)));
    if (flux_->dimensions() != dimVelocity*dimArea)
    {
        Co /= mesh.template lookupObject<volScalarField>("rho");
    }
    Co.dimensions().reset(dimless);
    Co.primitiveFieldRef() *= 0.5*mesh.time().deltaTValue()/mesh.V().field();
    Co.correctBoundaryConditions();

    const surfaceScalarField faceCo(linearInterpolate(Co));
    return
        faceCo/(1.2 + faceCo)
       *(pos0(*flux_) - mesh.surfaceInterpolation::weights());
}


template<class Type>
void Foam::SPH::reconstructed<Type>::addDifference
(
    const surfaceScalarField& weight,
    const cellField& vf,
    faceField& faceValues
)
{
    const labelUList& owner = vf.mesh().owner();
    const labelUList& neighbour = vf.mesh().neighbour();

    forAll(owner, facei)
    {
        faceValues[facei] +=
            weight[facei]*(vf[owner[facei]] - vf[neighbour[facei]]);
    }

    forAll(vf.boundaryField(), patchi)
    {
        const fvPatchField<Type>& values = vf.boundaryField()[patchi];
        if (values.coupled())
        {
            faceValues.boundaryFieldRef()[patchi] +=
                weight.boundaryField()[patchi]
               *(values.patchInternalField() - values.patchNeighbourField());
        }
    }
}


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


template<class Type>
Foam::tmp<typename Foam::SPH::reconstructed<Type>::faceField>
Foam::SPH::reconstructed<Type>::beyondLinear
(
    const cellField& vf,
    const word& name
) const
{
    const fvMesh& mesh = this->mesh();

    tmp<faceField> tresult
    (
        new faceField
        (
            IOobject
            (
                "reconstructed::correction(" + name + ')',
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
    faceField& result = tresult.ref();

    // From the weighted mean of both values to the plain one
    addDifference(0.5 - mesh.surfaceInterpolation::weights(), vf, result);

    ITstream& schemeData = gradScheme(name);
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::tmp<typename Foam::SPH::reconstructed<Type>::faceField>
Foam::SPH::reconstructed<Type>::interpolate(const cellField& vf) const
{
    return linearInterpolate(vf) + beyondLinear(vf, vf.name());
}


template<class Type>
Foam::tmp<Foam::surfaceScalarField>
Foam::SPH::reconstructed<Type>::weights(const cellField& vf) const
{
    tmp<surfaceScalarField> linearWeights(linear<Type>::weights(vf));

    upwindWeights_.clear();
    if (!isAhead(vf))
    {
        return linearWeights;
    }
    upwindWeights_ = upwindWeights();
    return linearWeights + upwindWeights_();
}


template<class Type>
Foam::tmp<typename Foam::SPH::reconstructed<Type>::faceField>
Foam::SPH::reconstructed<Type>::correction(const cellField& vf) const
{
    if (!upwindWeights_.valid())
    {
        return beyondLinear(vf, vf.name());
    }

    tmp<faceField> result(beyondLinear(ahead(vf)(), vf.name()));
    addDifference(-upwindWeights_(), vf, result.ref());
    return result;
}


// * * * * * * * * * * * * * * * Registration  * * * * * * * * * * * * * * * //

// OpenFOAM's macros specialise templates of its own namespace
namespace Foam
{
    using SPH::reconstructed;

    makeSurfaceInterpolationScheme(reconstructed)
}

// ************************************************************************* //
