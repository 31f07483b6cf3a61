/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "compressibleFlow.H"
#include "fundamentalConstants.H"
#include "physicoChemicalConstants.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::SPH::perfectGasFluid Foam::SPH::compressibleFlow::readFluid() const
{
    const IOdictionary properties
    (
        IOobject
        (
            "thermophysicalProperties",
            runTime_.constant(),
            particles_.mesh(),
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );

    const dictionary& type = properties.subDict("thermoType");

    const auto choose = [&](const word& entry, const wordList& choices)
    {
        const word choice(type.get<word>(entry));
        if (!choices.found(choice))
        {
            FatalIOErrorInFunction(type)
                << "Entry " << entry << " " << choice
                << " is not supported" << nl << nl
                << "Valid choices:" << nl << choices << exit(FatalIOError);
        }
        return choice;
    };

    choose("type", {"hePsiThermo"});
    choose("mixture", {"pureMixture"});
    choose("equationOfState", {"perfectGas"});
    choose("specie", {"specie"});
    choose("energy", {"sensibleInternalEnergy", "sensibleEnthalpy"});
    const word thermo(choose("thermo", {"hConst", "eConst"}));
    const word transport(choose("transport", {"const", "sutherland"}));

    const dictionary& mixture = properties.subDict("mixture");
    const dictionary& heat = mixture.subDict("thermodynamics");
    const dictionary& viscosity = mixture.subDict("transport");
    const auto positive = [](const scalar value) { return value > 0; };
    const auto notNegative = [](const scalar value) { return value >= 0; };

    // Universal gas constant by kmol, as molWeight is in kg/kmol
    const scalar R =
        1000*constant::physicoChemical::R.value()
       /mixture.subDict("specie").getCheck<scalar>("molWeight", positive);

    const scalar Cv =
        thermo == "hConst"
      ? heat.getCheck<scalar>("Cp", positive) - R
      : heat.getCheck<scalar>("Cv", positive);

    if (Cv <= 0)
    {
        FatalIOErrorInFunction(heat)
            << "Entry Cp " << Cv + R << " is not larger than the gas constant"
            << " R = " << R << " J/(kg K) of molWeight [kg/kmol]"
            << exit(FatalIOError);
    }

    perfectGasFluid gas;
    gas.R = R;
    gas.gamma = 1 + R/Cv;
    gas.mu = 0;
    gas.As = 0;
    gas.Ts = 0;

    if (transport == "sutherland")
    {
        gas.As = viscosity.getCheck<scalar>("As", notNegative);
        gas.Ts = viscosity.getCheck<scalar>("Ts", notNegative);

        // Modified Eucken relation, as OpenFOAM's sutherland transport
        gas.kappaByMu = Cv*(1.32 + 1.77*R/Cv);
    }
    else
    {
        gas.mu = viscosity.getCheck<scalar>("mu", notNegative);
        gas.kappaByMu =
            (Cv + R)/viscosity.getCheck<scalar>("Pr", positive);
    }

    return gas;
}


// ************************************************************************* //
