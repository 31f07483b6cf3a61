/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "drivingValues.H"
#include "boundaryStates.H"
#include "mathematicalConstants.H"
#include "mixedFvPatchFields.H"
#include "wallFvPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- A copy without the registry, where conditions find the original
    template<class Type>
    using volField = GeometricField<Type, fvPatchField, volMesh>;

    template<class Type>
    static volField<Type> copyOf(const volField<Type>& field)
    {
        return volField<Type>
        (
            IOobject
            (
                field.name(),
                field.instance(),
                field.db(),
                IOobject::NO_READ,
                IOobject::NO_WRITE,
                false
            ),
            field
        );
    }

    //- Patches with faces and conditions of their own, the same on all ranks
    static labelList uncoupledPatches(const volVectorField& U)
    {
        DynamicList<label> patches;
        for (const fvPatchVectorField& Up : U.boundaryField())
        {
            if (!Up.coupled() && returnReduce(Up.size(), sumOp<label>()))
            {
                patches.append(Up.patch().index());
            }
        }
        return labelList(std::move(patches));
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::drivingValues::history::add(const scalar value)
{
    variation += (range.valid() ? mag(value - last) : 0);
    range += value;
    last = value;
}


void Foam::SPH::drivingValues::sample(fvPatchVectorField& Up, history& flux)
{
    const bool changes = boundaryStates::mayChange(Up);
    const bool gives = boundaryStates::givesVelocity(Up);

    if (changes && (gives || !flux.range.valid()))
    {
        Up.evaluate();
    }
    if (!Up.fixesValue())
    {
        return;
    }

    velocity_ = max(velocity_, gMax(mag(Up)()));

    const scalarField normal(Up & Up.patch().nf());
    flux.add(gSum((normal*Up.patch().magSf())())/gSum(Up.patch().magSf()));

    // A wall that turns has facets; what leaves through a condition that
    // depends on the flow does not drive it
    if (gives && !(changes && isA<wallFvPatch>(Up.patch())))
    {
        through_ = max(through_, gMax(mag(normal)()));
    }
    else if (isA<mixedFvPatchVectorField>(Up))
    {
        through_ = max(through_, -gMin(normal));
    }
}


void Foam::SPH::drivingValues::sample
(
    fvPatchScalarField& pp,
    history& pressure,
    scalarMinMax& given
)
{
    if (!pp.fixesValue())
    {
        return;
    }
    if (boundaryStates::mayChange(pp))
    {
        pp.evaluate();
    }
    pressure.add(gAverage(pp));
    given += gMinMax(pp);
}


void Foam::SPH::drivingValues::addChanges
(
    const history& h,
    const scalar largest,
    const scalar T
)
{
    const scalar amplitude = 0.5*h.range.span();
    if (amplitude > SMALL*largest && largest > 0)
    {
        const scalar omega =
            constant::mathematical::piByTwo*h.variation/T/amplitude;

        frequency_ = max(frequency_, omega*Foam::sqrt(amplitude/largest));
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::drivingValues::drivingValues
(
    const volVectorField& U0,
    const volScalarField& p0
)
{
    // Enough for some hundred periods
    constexpr label maxSamples = 1000;

    volVectorField U(copyOf(U0));
    volScalarField p(copyOf(p0));
    const labelList patches(uncoupledPatches(U));

    bool changes = false;
    for (const label patchi : patches)
    {
        changes =
            changes
         || boundaryStates::mayChange(U.boundaryField()[patchi])
         || boundaryStates::mayChange(p.boundaryField()[patchi]);
    }

    // Conditions ask the case for the time
    Time& time = const_cast<Time&>(U.time());
    const dimensionedScalar start(time);
    const label startIndex = time.timeIndex();
    const scalar T = time.endTime().value() - start.value();
    const label nSamples =
        changes && T > 0 && time.deltaTValue() > 0
      ? label(min(T/time.deltaTValue(), scalar(maxSamples)))
      : 0;

    velocity_ = gMax(mag(U.primitiveField())());
    const scalarMinMax inside(gMinMax(p.primitiveField()));
    List<history> fluxes(U.boundaryField().size());
    List<history> pressures(fluxes.size());

    for (label k = 0; k <= nSamples; ++k)
    {
        if (nSamples)
        {
            // Some conditions change with the index only
            time.setTime(start.value() + T*k/nSamples, -1 - k);
        }

        scalarMinMax given;
        for (const label patchi : patches)
        {
            sample(U.boundaryFieldRef()[patchi], fluxes[patchi]);
            sample(p.boundaryFieldRef()[patchi], pressures[patchi], given);
        }

        // The level of a uniform start is none of the pressures
        if (inside.span() > 0 || !given.valid())
        {
            given += inside;
        }
        pressure_ = max(pressure_, given.span());
    }

    if (nSamples)
    {
        time.setTime(start.value(), startIndex);
        static_cast<dimensionedScalar&>(time) = start;

        for (const label patchi : patches)
        {
            const history& flux = fluxes[patchi];
            acceleration_ = max
            (
                acceleration_, constant::mathematical::piByTwo*flux.variation/T
            );
            addChanges(flux, velocity_, T);
            addChanges(pressures[patchi], pressure_, T);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::SPH::drivingValues::velocity(const scalar L) const
{
    // Unsteady flow is off by (omega L/c)^2: 5 % with ten times the velocity
    constexpr scalar compact = 0.45;

    return max
    (
        max(velocity_, compact*frequency_*L),
        Foam::sqrt(2*max(pressure_, acceleration_*L))
    );
}


// ************************************************************************* //
