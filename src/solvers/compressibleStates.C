/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "compressibleStates.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    static IOobject registeredIO(const word& name, const fvMesh& mesh)
    {
        return IOobject(name, mesh.time().timeName(), mesh);
    }
}
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::SPH::compressibleStates::correctFlux(const label patchi)
{
    const fvPatch& patch = U_.boundaryField()[patchi].patch();

    for (const label celli : patch.faceCells())
    {
        const scalar psi = 1/(R_*T_[celli]);
        psi_.primitiveFieldRef()[celli] = psi;
        thermoPsi_.primitiveFieldRef()[celli] = psi;
        rho_.primitiveFieldRef()[celli] = psi*p_[celli];
    }

    const scalarField psi(1/(R_*T_.boundaryField()[patchi]));
    const scalarField rho(psi*p_.boundaryField()[patchi]);
    psi_.boundaryFieldRef()[patchi] == psi;
    thermoPsi_.boundaryFieldRef()[patchi] == psi;
    rho_.boundaryFieldRef()[patchi] == rho;

    boundaryStates::correctFlux(patchi);
    phi_.boundaryFieldRef()[patchi] ==
        rho*phi_.boundaryField()[patchi];
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::compressibleStates::compressibleStates
(
    const particleMesh& particles,
    volVectorField& U,
    volScalarField& T,
    volScalarField& p,
    volScalarField& rho,
    surfaceScalarField& phi,
    const perfectGasFluid& gas
)
:
    boundaryStates
    (
        particles,
        U,
        {{T, 0}, {p, 1 + loopDims(particles)}},
        phi,
        gas.viscous()
    ),
    R_(gas.R),
    T_(T),
    p_(p),
    rho_(rho),
    psi_
    (
        registeredIO("psi", particles.mesh()),
        particles.mesh(),
        dimensionedScalar(dimDensity/dimPressure, Zero)
    ),
    thermoPsi_(registeredIO("thermo:psi", particles.mesh()), psi_)
{
    correctDensity();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::compressibleStates::correctDensity()
{
    psi_.primitiveFieldRef() = 1/(R_*T_.primitiveField());
    rho_.primitiveFieldRef() = psi_.primitiveField()*p_.primitiveField();

    forAll(psi_.boundaryField(), patchi)
    {
        const scalarField psi(1/(R_*T_.boundaryField()[patchi]));
        psi_.boundaryFieldRef()[patchi] == psi;
        rho_.boundaryFieldRef()[patchi] ==
            psi*p_.boundaryField()[patchi];
    }

    thermoPsi_ == psi_;
}


// ************************************************************************* //
