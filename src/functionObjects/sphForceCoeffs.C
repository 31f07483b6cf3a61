/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sphForceCoeffs.H"
#include "addToRunTimeSelectionTable.H"
#include "OFstream.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    defineTypeNameAndDebug(sphForceCoeffs, 0);
    addToRunTimeSelectionTable(functionObject, sphForceCoeffs, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::sphForceCoeffs::writeFileHeader()
{
    OFstream& os = coefficientFile_();

    writeHeader(os, "Force coefficients");
    writeHeaderValue(os, "dragDir", axes_->e1());
    writeHeaderValue(os, "sideDir", axes_->e2());
    writeHeaderValue(os, "liftDir", axes_->e3());
    writeHeaderValue(os, "rollAxis", axes_->e1());
    writeHeaderValue(os, "pitchAxis", axes_->e2());
    writeHeaderValue(os, "yawAxis", axes_->e3());
    writeHeaderValue(os, "magUInf", magUInf_);
    writeHeaderValue(os, "lRef", lRef_);
    writeHeaderValue(os, "Aref", Aref_);
    writeHeaderValue(os, "CofR", axes_->origin());
    writeHeader(os, "");
    writeCommented(os, "Time");
    for
    (
        const char* column :
        {
            "Cd", "Cs", "Cl", "CmRoll", "CmPitch", "CmYaw",
            "Cd(f)", "Cd(r)", "Cs(f)", "Cs(r)", "Cl(f)", "Cl(r)"
        }
    )
    {
        writeTabbed(os, column);
    }
    os  << endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::sphForceCoeffs::sphForceCoeffs
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    sphForces(name, runTime, dict, false),
    magUInf_(0),
    lRef_(0),
    Aref_(0)
{
    read(dict);
    setAxes(dict, "liftDir", "dragDir");
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::SPH::sphForceCoeffs::read(const dictionary& dict)
{
    sphForces::read(dict);

    const auto positive = [](const scalar value) { return value > 0; };

    magUInf_ = dict.getCheck<scalar>("magUInf", positive);
    lRef_ = dict.getCheck<scalar>("lRef", positive);
    Aref_ = dict.getCheck<scalar>("Aref", positive);

    // The reference dynamic pressure needs it in compressible flow too
    dict.readEntry("rhoInf", rhoRef_);

    return true;
}


bool Foam::SPH::sphForceCoeffs::execute()
{
    if (!integrate())
    {
        return true;
    }

    const scalar pDyn = 0.5*rhoRef_*sqr(magUInf_);
    const vector force
    (
        (pressureForce_ + viscousForce_)/(Aref_*pDyn)
    );
    const vector moment
    (
        (pressureMoment_ + viscousMoment_)/(Aref_*pDyn*lRef_)
    );

    // Front and rear parts: drag with roll, side force with yaw, lift with
    // pitch, as OpenFOAM defines them
    const scalar parts[] =
    {
        0.5*force.x() + moment.x(), 0.5*force.x() - moment.x(),
        0.5*force.y() + moment.z(), 0.5*force.y() - moment.z(),
        0.5*force.z() + moment.y(), 0.5*force.z() - moment.y()
    };

    Log << type() << " " << name() << ": Cd " << force.x()
        << " (pressure " << pressureForce_.x()/(Aref_*pDyn)
        << ", viscous " << viscousForce_.x()/(Aref_*pDyn)
        << ")  Cl " << force.z() << endl;

    if (writeToFile() && Pstream::master())
    {
        if (!coefficientFile_.valid())
        {
            coefficientFile_ = createFile("coefficient");
            writeFileHeader();
        }

        OFstream& os = coefficientFile_();
        writeCurrentTime(os);
        for (const vector& c : {force, moment})
        {
            os  << tab << c.x() << tab << c.y() << tab << c.z();
        }
        for (const scalar part : parts)
        {
            os  << tab << part;
        }
        os  << endl;
    }

    setResult("Cd", force.x());
    setResult("Cs", force.y());
    setResult("Cl", force.z());
    setResult("CmRoll", moment.x());
    setResult("CmPitch", moment.y());
    setResult("CmYaw", moment.z());

    return true;
}


// ************************************************************************* //
