/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sphForces.H"
#include "addToRunTimeSelectionTable.H"
#include "flowSolver.H"
#include "forceCoeffs.H"
#include "forces.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- The dictionary with the entries that let OpenFOAM take a field of forces
    static dictionary withForceDensity
    (
        const dictionary& dict,
        const word& fieldName
    )
    {
        dictionary result(dict);
        result.set("directForceDensity", true);
        result.set("fD", fieldName);
        return result;
    }

    //- Add the forces of the fluxes to the faces of the patches
    static void addForces
    (
        const flowSolver& solver,
        const dictionary& dict,
        volVectorField::Boundary& density
    )
    {
        const solutionSpace& space = solver.particles().space();
        const faceStates& faces = solver.faces();
        const scalar pRef = dict.getOrDefault<scalar>("pRef", 0);
        const scalar rho =
            solver.kinematic() ? dict.getOrDefault<scalar>("rhoInf", 1) : 1;

        for (const particlePatch& patch : solver.particles().boundary())
        {
            const fvPatch& meshPatch = patch.patch();
            vectorField& values = density[patch.index()];
            const labelUList face(patch.face());
            forAll(face, k)
            {
                const label facei = patch.start() + k;
                values[face[k]] +=
                    space.toGlobal
                    (
                        rho
                       *(
                            faces.pressureForce()[facei]
                          + faces.viscousForce()[facei]
                        )
                      - pRef*faces.magSf()[facei]*faces.n()[facei]
                    )
                   /meshPatch.magSf()[face[k]];
            }
        }
    }
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class Forces>
Foam::SPH::fluxForces<Forces>::fluxForces
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    Forces(name, runTime, withForceDensity(dict, name + ":forceDensity")),
    dict_(dict),
    density_
    (
        IOobject
        (
            name + ":forceDensity",
            runTime.timeName(),
            this->mesh_,
            IOobject::NO_READ,
            IOobject::NO_WRITE
        ),
        this->mesh_,
        dimensionedVector(dimPressure, Zero)
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Forces>
bool Foam::SPH::fluxForces<Forces>::read(const dictionary& dict)
{
    dict_ = dict;
    return Forces::read(withForceDensity(dict, density_.name()));
}


template<class Forces>
bool Foam::SPH::fluxForces<Forces>::execute()
{
    const auto* solver =
        this->mesh_.template findObject<flowSolver>(flowSolver::typeName);
    if (!solver)
    {
        return true;
    }

    density_ == dimensionedVector(dimPressure, Zero);
    addForces(*solver, dict_, density_.boundaryFieldRef());
    return Forces::execute();
}


// * * * * * * * * * * * * * * * Registration  * * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    typedef fluxForces<functionObjects::forces> sphForces;
    typedef fluxForces<functionObjects::forceCoeffs> sphForceCoeffs;

    defineTemplateTypeNameAndDebugWithName(sphForces, "sphForces", 0);
    addToRunTimeSelectionTable(functionObject, sphForces, dictionary);

    defineTemplateTypeNameAndDebugWithName(sphForceCoeffs, "sphForceCoeffs", 0);
    addToRunTimeSelectionTable(functionObject, sphForceCoeffs, dictionary);
}
}


// ************************************************************************* //
