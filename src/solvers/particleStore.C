/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleStore.H"
#include "cloud.H"
#include "IOdictionary.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    static const fileName cloudFolder(cloud::prefix/"sph");
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::IOobject Foam::SPH::particleStore::fieldIO
(
    const word& name,
    const IOobject::readOption read
) const
{
    return IOobject
    (
        name,
        particles_.mesh().time().timeName(),
        cloudFolder,
        particles_.mesh(),
        read,
        IOobject::NO_WRITE,
        false
    );
}


void Foam::SPH::particleStore::remove(const word& timeName) const
{
    const fileName path(particles_.mesh().time().path()/timeName);

    rmDir(path/cloudFolder, true);
    rmDir(path/"uniform"/cloudFolder, true);
    for (const fileName& file : readDir(path, fileName::FILE))
    {
        if (file.hasExt("sph"))
        {
            rm(path/file);
        }
    }

    // Folders that other solvers wrote into stay
    for (const fileName& folder : {path/cloud::prefix, path/"uniform", path})
    {
        if
        (
            readDir(folder, fileName::FILE).empty()
         && readDir(folder, fileName::DIRECTORY).empty()
        )
        {
            rmDir(folder, true);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::particleStore::particleStore(const sphMesh& particles)
:
    particles_(particles)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::SPH::particleStore::found(const word& name) const
{
    return isFile(fieldIO(name, IOobject::NO_READ).objectPath());
}


void Foam::SPH::particleStore::writePositions() const
{
    const IOobject io(fieldIO("positions", IOobject::NO_READ));
    mkDir(io.path());

    OFstream os(io.objectPath());
    os.precision(12);
    io.writeHeader(os, "Cloud<passiveParticle>");

    const labelList& cells = particles_.cells();

    os  << particles_.nParticles() << nl << token::BEGIN_LIST << nl;
    forAll(cells, i)
    {
        os  << particles_.C()[i] << token::SPACE << cells[i] << nl;
    }
    os  << token::END_LIST << nl;
    IOobject::writeEndDivider(os);

    if (!os.good())
    {
        FatalErrorInFunction
            << "Cannot write " << io.objectPath() << exit(FatalError);
    }

    // Tells cloud readers to look for positions
    IOdictionary properties
    (
        IOobject
        (
            "cloudProperties",
            particles_.mesh().time().timeName(),
            "uniform"/cloudFolder,
            particles_.mesh(),
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        )
    );
    properties.add("geometry", "positions");

    dictionary count;
    count.add("particleCount", particles_.nParticles());
    properties.add(word("processor" + Foam::name(Pstream::myProcNo())), count);
    properties.regIOobject::write();
}


void Foam::SPH::particleStore::purge()
{
    const Time& runTime = particles_.mesh().time();
    const label purgeWrite =
        runTime.controlDict().getOrDefault<label>("purgeWrite", 0);

    written_.append(runTime.timeName());

    if (purgeWrite > 0 && written_.size() > purgeWrite)
    {
        remove(written_.first());
        written_.remove(0);
    }
}


// ************************************************************************* //
