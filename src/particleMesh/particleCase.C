/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleCase.H"
#include "contactBoundary.H"
#include "particleFiles.H"
#include "particlePolyMesh.H"
#include "solidParticles.H"
#include "labelIOList.H"
#include "OSspecific.H"
#include "scalarIOField.H"
#include "vectorIOField.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    const word particleCase::folder("sph");
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    static const word meshFolder("polyMesh");

    //- Folder of constant/, and region, where new files wait until all of
    //- them are written
    static const word newFolder("new");

    static void moveFile(const fileName& from, const fileName& to)
    {
        if (!mv(from, to))
        {
            FatalErrorInFunction
                << "Cannot move " << from << " to " << to
                << exit(FatalError);
        }
    }

    //- Arrays beside the polyMesh, which gives points and volumes but for
    //- round-off that depends on how it is decomposed
    static void writeArrays
    (
        const particleFiles& files,
        const pointField& points,
        const scalarField& V,
        const scalarField& spacing
    )
    {
        files.writeArray<vectorIOField>("points", points);
        files.writeArray<scalarIOField>("V", V);
        files.writeArray<scalarIOField>("spacing", spacing);
    }

    //- Folders of times, but for the start
    static fileNameList resultFolders
    (
        const fileName& path,
        const word& start
    )
    {
        DynamicList<fileName> folders;
        for (const instant& time : Time::findTimes(path))
        {
            if (time.name() != "constant" && time.name() != start)
            {
                folders.append(path/time.name());
            }
        }
        for (const fileName& name : readDir(path, fileName::DIRECTORY))
        {
            if (name.starts_with("processor"))
            {
                folders.append(path/name);
            }
        }
        return fileNameList(std::move(folders));
    }
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::particleCase::particleCase(const fvMesh& mesh)
:
    mesh_(mesh),
    path_(mesh.time().path()/folder),
    files_(path_)
{}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

void Foam::SPH::particleCase::requireFvm(const Time& runTime)
{
    if (particleFiles(runTime).found())
    {
        FatalErrorInFunction
            << runTime.path() << " is a particle case: start this command in"
            << " the FVM case that it was made from" << exit(FatalError);
    }
}


Foam::autoPtr<Foam::Time> Foam::SPH::particleCase::caseTime
(
    const fileName& path
)
{
    return autoPtr<Time>::New
    (
        Time::controlDictName,
        path.path(),
        fileName(path.name()),
        word("system"),
        word("constant"),
        false
    );
}


Foam::autoPtr<Foam::Time> Foam::SPH::particleCase::openTime
(
    const Time& runTime
)
{
    requireFvm(runTime);

    const fileName path(runTime.path()/folder);
    if (!isFile(path/"system"/"controlDict"))
    {
        FatalErrorInFunction
            << "There is no particle case " << path
            << ". Generate it with sphMesh" << exit(FatalError);
    }

    autoPtr<Time> timePtr(caseTime(path));
    particleFiles(*timePtr).requireCurrent();
    return timePtr;
}


Foam::instant Foam::SPH::particleCase::startTime(const Time& runTime)
{
    const word from
    (
        runTime.controlDict().getOrDefault<word>("startFrom", "latestTime")
    );

    if (from == "startTime")
    {
        const scalar start = runTime.controlDict().get<scalar>("startTime");
        return instant(start, Time::timeName(start));
    }

    // Later times are results of FVM
    for (const instant& time : runTime.times())
    {
        if (time.name() != runTime.constant())
        {
            return time;
        }
    }

    return instant(0, "0");
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::SPH::particleResults& Foam::SPH::particleCase::particles()
{
    if (!particles_.valid())
    {
        autoPtr<Time> timePtr(caseTime(path_));
        timePtr->setTime(startTime(mesh_.time()), 0);
        particles_.reset(new particleResults(std::move(timePtr)));
    }
    return *particles_;
}


Foam::word Foam::SPH::particleCase::digest() const
{
    if
    (
        !isFile(path_/"system"/"controlDict")
     || !isFile(path_/"constant"/particleFiles::folder/"sphMeshProperties")
    )
    {
        return word::null;
    }

    return
        particleFiles(caseTime(path_)()).properties()
       .getOrDefault<word>("digest", word::null);
}


void Foam::SPH::particleCase::updateSource() const
{
    const autoPtr<Time> timePtr(caseTime(path_));
    const particleFiles files(*timePtr);
    dictionary properties(files.properties());
    const dictionary source
    (
        particleFiles::sourceDigests
        (
            mesh_.time().path(),
            properties.found("zone")
        )
    );

    if (properties.subOrEmptyDict("source") != source)
    {
        properties.set("source", source);
        files.writeDictionary("sphMeshProperties", properties);
    }
}


void Foam::SPH::particleCase::requireNoResults() const
{
    const fileNameList folders
    (
        resultFolders(path_, startTime(mesh_.time()).name())
    );

    if (folders.size())
    {
        FatalErrorInFunction
            << "There are results on the present particles, which new ones"
            << " would make unreadable: " << folders.first()
            << (folders.size() > 1 ? " and others" : "") << nl
            << "    Move them, or let 'sphMesh -overwrite' remove them"
            << exit(FatalError);
    }
}


void Foam::SPH::particleCase::removeResults() const
{
    for
    (
        const fileName& name
      : resultFolders(path_, startTime(mesh_.time()).name())
    )
    {
        rmDir(name);
    }
}


void Foam::SPH::particleCase::writeMesh
(
    const dictionary& properties,
    const particleZone& zone,
    const particleMeshData& data,
    const UList<particleSet>& solids,
    const boundaryFaces& contact
)
{
    writeDictionaries();

    // Those may have looked at the particles that are replaced here
    particles_.clear();
    autoPtr<Time> timePtr(caseTime(path_));
    timePtr->setTime(startTime(mesh_.time()), 0);

    // A complete new folder replaces the old one at the end, so that an
    // interrupted run leaves no mixture of two particle meshes
    const fileName constant(path_/timePtr->constant());
    rmDir(constant/newFolder, true);

    const particleFiles files(*timePtr, newFolder);
    const solutionSpace space(mesh_);
    if (zone.bodies().size())
    {
        files.writeArray<labelIOList>("solidCells", zone.bodies().cells());
    }
    particlePolyMesh mesh(zone, space, data);
    files.writeArray<labelIOList>("boundaryFace", mesh.boundaryFace());
    if (!zone.everywhere())
    {
        files.writeArray<labelIOList>("cellMap", mesh.cellMap());
        files.writeArray<labelIOList>("faceMap", mesh.faceMap());
    }
    writeArrays(files, mesh.points(), mesh.V(), mesh.spacing());
    const autoPtr<polyMesh> meshPtr(mesh.makeMesh(*timePtr, newFolder));
    particleFiles::checkWritten(meshPtr->write(), *meshPtr);

    if (solids.size())
    {
        writeSolidParticles(files, solids);
    }
    if (contact.owner.size())
    {
        writeContactBoundary(files, *meshPtr, contact);
    }

    dictionary stored(properties);
    stored.add
    (
        "source",
        particleFiles::sourceDigests
        (
            mesh_.time().path(),
            properties.found("zone")
        )
    );
    stored.add("nParticles", data.points.size());
    stored.add("nPairs", data.owner.size());
    files.writeDictionary("sphMeshProperties", stored);

    for (const word& name : {meshFolder, particleFiles::folder})
    {
        rmDir(constant/name, true);
        moveFile(constant/newFolder/name, constant/name);
    }
    rmDir(constant/newFolder, true);
    files_.write();
}


// ************************************************************************* //
