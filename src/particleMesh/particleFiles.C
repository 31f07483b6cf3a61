/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleFiles.H"
#include "compat.H"
#include "IFstream.H"
#include "labelIOList.H"
#include "OSspecific.H"
#include "SHA1.H"

#include <fstream>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    const word particleFiles::folder("sphMesh");

    //- Add the digest of a file, if there is one, on the master
    static void addDigest
    (
        dictionary& digests,
        const word& name,
        const fileName& file
    )
    {
        const word digest(Pstream::master() ? fileDigest(file) : word::null);
        if (digest.size())
        {
            digests.set(name, digest);
        }
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::word Foam::SPH::particleFiles::entriesDigest(const dictionary& dict)
{
    const unsigned precision = IOstream::defaultPrecision(17);
    const word digest(dict.digest().str(true));
    IOstream::defaultPrecision(precision);

    return digest;
}


void Foam::SPH::particleFiles::writeBinary(const regIOobject& object)
{
    checkWritten(writeAs(object, IOstream::BINARY), object);
}


Foam::labelList Foam::SPH::particleFiles::optionalLabels
(
    const word& name
) const
{
    IOobject io(arrayIO(name));
    return io.typeHeaderOk<labelIOList>(true) ? labelIOList(io) : labelList();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::particleFiles::checkWritten
(
    const bool written,
    const regIOobject& object
)
{
    if (!written)
    {
        FatalErrorInFunction
            << "Cannot write " << object.objectPath()
            << ": is the disk full, or the folder write-protected?"
            << exit(FatalError);
    }
}


Foam::IOobject Foam::SPH::particleFiles::arrayIO
(
    const word& name,
    const IOobject::readOption read
) const
{
    return IOobject
    (
        name,
        time_.constant(),
        local_,
        time_,
        read,
        IOobject::NO_WRITE,
        false
    );
}


bool Foam::SPH::particleFiles::found() const
{
    return arrayIO("sphMeshProperties").typeHeaderOk<IOdictionary>(true);
}


Foam::dictionary Foam::SPH::particleFiles::properties() const
{
    return
        found()
      ? dictionary(IOdictionary(arrayIO("sphMeshProperties")))
      : dictionary();
}


void Foam::SPH::particleFiles::requireCurrent() const
{
    // The whole case; its messages come from the master alone
    const fileName path(time_.globalPath());
    const bool isFound = found();
    const dictionary was(properties().subOrEmptyDict("source"));
    const dictionary is(sourceDigests(path.path(), true));
    if (!Pstream::master())
    {
        return;
    }

    if (!isFound)
    {
        FatalErrorInFunction
            << "The case " << path << " is no particle case: it has no"
            << " constant/" << folder << "/sphMeshProperties." << nl
            << "    In the FVM case, generate the particles with 'sphMesh' and"
            << " run the solver with '-case sph'." << nl
            << "    To take the cells of a mesh as particles, give the option"
            << " -cells" << exit(FatalError);
    }

    for (const entry& e : is)
    {
        const word& file = e.keyword();
        if (was.found(file) && was.get<word>(file) != is.get<word>(file))
        {
            FatalErrorInFunction
                << "The particles in " << path << " are older than "
                << string(file).replaceAll(":", "/").c_str()
                << " of the FVM case "
                << path.path() << ": run sphMesh there"
                << exit(FatalError);
        }
    }
}


void Foam::SPH::particleFiles::writeDictionary
(
    const word& name,
    const dictionary& dict
) const
{
    const unsigned precision = IOstream::defaultPrecision(17);
    const IOdictionary object(arrayIO(name, IOobject::NO_READ), dict);
    checkWritten(object.regIOobject::write(), object);
    IOstream::defaultPrecision(precision);
}


Foam::dictionary Foam::SPH::particleFiles::sourceDigests
(
    const fileName& fvmCase,
    const bool zone
)
{
    dictionary digests;
    const fileName constant(fvmCase/"constant");
    for (const word name : {"points", "faces", "boundary"})
    {
        addDigest(digests, name, constant/"polyMesh"/name);
    }

    if (zone)
    {
        addDigest(digests, "cellZones", constant/"polyMesh"/"cellZones");
    }

    const fileName file(fvmCase/"system"/"sphMeshDict");
    if (!isFile(file))
    {
        digests.add("sphMeshDict", "none");
        return digests;
    }

    IFstream is(file);
    const dictionary dict(is);
    digests.add("sphMeshDict", entriesDigest(dict));
    digests.merge(surfaceDigests(fvmCase, dict.subOrEmptyDict("bodies")));

    return digests;
}


Foam::dictionary Foam::SPH::particleFiles::surfaceDigests
(
    const fileName& fvmCase,
    const dictionary& bodies
)
{
    dictionary digests;
    for (const entry& e : bodies)
    {
        const fileName file
        (
            "triSurface"
           /(
                e.isDict()
              ? e.dict().getOrDefault<fileName>("surface", fileName::null)
              : fileName::null
            )
        );

        // A keyword has no slash
        const word name(string(file).replaceAll("/", ":"));
        addDigest(digests, name, fvmCase/"constant"/file);
    }

    return digests;
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::word Foam::SPH::fileDigest(const fileName& file)
{
    std::ifstream is(isFile(file, false) ? file : fileName(file + ".gz"));
    if (!is)
    {
        return word::null;
    }

    SHA1 sha;
    char buffer[65536];
    do
    {
        is.read(buffer, sizeof(buffer));
        sha.append(buffer, is.gcount());
    }
    while (is);

    // The prefix keeps a leading digit from being read back as a number
    return sha.digest().str(true);
}


// ************************************************************************* //
