/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Application
    taylorGreenError

Description
    Error of the velocities of the Taylor-Green vortex in cells or particles of
    the periodic unit square against the exact incompressible flow,

        u = exp(-8 pi^2 nu t) (-cos 2 pi x sin 2 pi y, sin 2 pi x cos 2 pi y)

Usage
    \b taylorGreenError [-case sph]

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::noParallel();

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    const instantList times(runTime.times());
    runTime.setTime(times.last(), times.size() - 1);

    const volVectorField U
    (
        IOobject("U", runTime.timeName(), mesh, IOobject::MUST_READ),
        mesh
    );
    const IOdictionary transport
    (
        IOobject
        (
            "transportProperties",
            runTime.constant(),
            mesh,
            IOobject::MUST_READ
        )
    );
    const scalar nu =
        dimensionedScalar("nu", dimViscosity, transport).value();

    const scalar k = constant::mathematical::twoPi;
    const scalar decay = std::exp(-2*k*k*nu*runTime.value());

    scalar error = 0;
    scalar reference = 0;
    scalar largest = 0;
    forAll(U, i)
    {
        const vector x(k*mesh.C()[i]);
        const vector exact
        (
            -decay*std::cos(x.x())*std::sin(x.y()),
            decay*std::sin(x.x())*std::cos(x.y()),
            0
        );
        error += mesh.V()[i]*magSqr(U[i] - exact);
        reference += mesh.V()[i]*magSqr(exact);
        largest = max(largest, mag(U[i] - exact));
    }

    Info<< "particles " << U.size() << " time " << runTime.value()
        << " relativeL2 " << std::sqrt(error/reference)
        << " Linf " << largest << nl << "End\n" << endl;

    return 0;
}


// ************************************************************************* //
