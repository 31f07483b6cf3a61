/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sphForces.H"
#include "addToRunTimeSelectionTable.H"
#include "cartesianCS.H"
#include "flowSolver.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    defineTypeNameAndDebug(sphForces, 0);
    addToRunTimeSelectionTable(functionObject, sphForces, dictionary);
}
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::SPH::sphForces::setAxes
(
    const dictionary& dict,
    const word& e3Name,
    const word& e1Name
)
{
    point origin;

    if (dict.readIfPresent("CofR", origin))
    {
        const vector e3
        (
            e3Name.empty() ? vector(0, 0, 1) : dict.get<vector>(e3Name)
        );
        const vector e1
        (
            e1Name.empty() ? vector(1, 0, 0) : dict.get<vector>(e1Name)
        );

        axes_.reset(new coordSystem::cartesian(origin, e3, e1));
    }
    else if (dict.found(coordinateSystem::typeName_()))
    {
        axes_ = coordinateSystem::New
        (
            obr_,
            dict,
            coordinateSystem::typeName_()
        );
    }
    else
    {
        axes_.reset(new coordSystem::cartesian(dict));
    }
}


bool Foam::SPH::sphForces::integrate()
{
    const auto* solver =
        mesh_.findObject<flowSolver>(flowSolver::typeName);

    if (!solver)
    {
        return false;
    }

    const particleMesh& particles = solver->particles();
    const solutionSpace& space = particles.space();
    const faceStates& faces = solver->faces();
    const scalar rho = solver->kinematic() ? rhoRef_ : 1;

    vector force[2] = {Zero, Zero};
    vector moment[2] = {Zero, Zero};

    for (const label patchi : patches_)
    {
        const particlePatch& patch = particles.boundary()[patchi];

        for
        (
            label facei = patch.start();
            facei < patch.start() + patch.size();
            ++facei
        )
        {
            const vector arm
            (
                particles.boundary().faces().Cf[facei] - axes_->origin()
            );
            const vector f[2] =
            {
                space.toGlobal
                (
                    rho*faces.pressureForce()[facei]
                  - pRef_*faces.magSf()[facei]*faces.n()[facei]
                ),
                rho*space.toGlobal(faces.viscousForce()[facei])
            };

            for (const int k : {0, 1})
            {
                force[k] += f[k];
                moment[k] += arm ^ f[k];
            }
        }
    }

    for (const int k : {0, 1})
    {
        reduce(force[k], sumOp<vector>());
        reduce(moment[k], sumOp<vector>());
    }

    pressureForce_ = axes_->localVector(force[0]);
    viscousForce_ = axes_->localVector(force[1]);
    pressureMoment_ = axes_->localVector(moment[0]);
    viscousMoment_ = axes_->localVector(moment[1]);

    return true;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::sphForces::writeLine
(
    const word& title,
    const vector& pressure,
    const vector& viscous,
    autoPtr<OFstream>& file
)
{
    if (!writeToFile() || !Pstream::master())
    {
        return;
    }

    if (!file.valid())
    {
        file = createFile(title);
        writeHeader(file(), title);
        writeHeaderValue(file(), "CofR", axes_->origin());
        writeHeader(file(), "");
        writeCommented(file(), "Time");
        writeTabbed(file(), "(total_x total_y total_z)");
        writeTabbed(file(), "(pressure_x pressure_y pressure_z)");
        writeTabbed(file(), "(viscous_x viscous_y viscous_z)");
        file() << endl;
    }

    writeCurrentTime(file());
    file()
        << tab << pressure + viscous
        << tab << pressure
        << tab << viscous << endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::sphForces::sphForces
(
    const word& name,
    const Time& runTime,
    const dictionary& dict,
    const bool readAxes
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(mesh_, name),
    rhoRef_(1),
    pRef_(0),
    pressureForce_(Zero),
    viscousForce_(Zero),
    pressureMoment_(Zero),
    viscousMoment_(Zero)
{
    if (readAxes)
    {
        read(dict);
        setAxes(dict, word::null, word::null);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::SPH::sphForces::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    writeFile::read(dict);

    patches_ =
        mesh_.boundaryMesh().patchSet(dict.get<wordRes>("patches"));

    pRef_ = dict.getOrDefault<scalar>("pRef", 0);
    if (dict.getOrDefault<word>("rho", "rho") == "rhoInf")
    {
        dict.readEntry("rhoInf", rhoRef_);
    }

    return true;
}


bool Foam::SPH::sphForces::execute()
{
    if (integrate())
    {
        writeLine("force", pressureForce_, viscousForce_, forceFile_);
        writeLine("moment", pressureMoment_, viscousMoment_, momentFile_);

        Log << type() << " " << name() << ": force "
            << pressureForce_ + viscousForce_
            << " (pressure " << pressureForce_
            << ", viscous " << viscousForce_ << ")" << endl;

        setResult("force", pressureForce_ + viscousForce_);
        setResult("moment", pressureMoment_ + viscousMoment_);
    }

    return true;
}


bool Foam::SPH::sphForces::write()
{
    return true;
}


// ************************************************************************* //
