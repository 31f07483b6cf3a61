/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Application
    exactRiemann

Description
    Writes the exact density of a shock tube along x as rho.exact at the latest
    time, averaged over each cell, and prints the waves.

    The states are those of the first and of the last cell at the start, the
    diaphragm is where they jump most there, and the gas is that of
    constant/thermophysicalProperties (hConst, perfectGas).

Usage
    \b exactRiemann [-case \<case\>]

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "riemannProblem.H"
#include "thermodynamicConstants.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::noParallel();
    argList::addNote("Write the exact density of a shock tube along x");

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    const IOdictionary thermo
    (
        IOobject
        (
            "thermophysicalProperties",
            runTime.constant(),
            mesh,
            IOobject::MUST_READ
        )
    );
    const dictionary& mixture = thermo.subDict("mixture");
    const scalar Cp =
        mixture.subDict("thermodynamics").get<scalar>("Cp");
    const scalar R =
        constant::thermodynamic::RR
       /mixture.subDict("specie").get<scalar>("molWeight");

    const instantList times(runTime.times());
    const auto read = [&](const word& name)
    {
        return IOobject(name, runTime.timeName(), mesh, IOobject::MUST_READ);
    };

    // Skips constant
    runTime.setTime(times[1], 1);
    const volScalarField p(read("p"), mesh);
    const volScalarField T(read("T"), mesh);
    const volVectorField U(read("U"), mesh);

    const scalarField x(mesh.C().primitiveField().component(0));
    const labelList order(sortedOrder(x));
    const auto stateOf = [&](const label celli)
    {
        return riemannProblem::state
        ({
            p[celli]/(R*T[celli]), U[celli].x(), p[celli]
        });
    };

    // Pressure, temperature or velocity, each over its largest value
    const scalar maxP = gMax(p);
    const scalar maxT = gMax(T);
    const scalar maxU = max(gMax(mag(U)()), VSMALL);

    scalar largest = 0;
    scalar diaphragm = 0;
    for (label i = 1; i < order.size(); ++i)
    {
        const label a = order[i - 1];
        const label b = order[i];
        const scalar jump =
            mag(p[b] - p[a])/maxP + mag(T[b] - T[a])/maxT
          + mag(U[b] - U[a])/maxU;
        if (jump > largest)
        {
            largest = jump;
            diaphragm = 0.5*(x[a] + x[b]);
        }
    }

    const riemannProblem exact
    (
        Cp/(Cp - R),
        stateOf(order.first()),
        stateOf(order.last())
    );

    runTime.setTime(times.last(), times.size() - 1);
    const scalar t = runTime.value();

    volScalarField rho
    (
        IOobject("rho.exact", runTime.timeName(), mesh),
        mesh,
        dimensionedScalar(dimDensity, Zero)
    );

    const label nSamples = 100;
    forAll(rho, celli)
    {
        const boundBox box
        (
            mesh.cells()[celli].points(mesh.faces(), mesh.points())
        );
        for (label i = 0; i < nSamples; ++i)
        {
            const scalar sample =
                box.min().x() + (i + 0.5)/nSamples*box.span().x();
            rho[celli] += exact((sample - diaphragm)/t).rho/nSamples;
        }
    }
    rho.write();

    Info<< "contactPressure = " << exact.contactPressure() << nl
        << "contactPosition = " << diaphragm + t*exact.contactVelocity() << nl
        << "shockPosition = " << diaphragm + t*exact.rightShockSpeed() << nl
        << "contactDensity = "
        << exact(exact.contactVelocity()*(1 + 1e-9) + 1e-9).rho << nl
        << "\nEnd\n" << endl;

    return 0;
}


// ************************************************************************* //
