/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleMeshProperties.H"
#include "particleFiles.H"
#include "OSspecific.H"
#include "SHA1.H"
#include "StringStream.H"

#include <fstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Raised whenever the same dictionary gives other particles, so that
    //- what an older sphMesh made is not taken for up to date
    static const label generationVersion = 3;

    //- Entries of sphMeshDict
    static const wordHashSet validEntries
    ({
        "spacing", "kernel", "lattice", "bodies", "relaxation", "closure",
        "levelSet"
    });

    //- Points, faces and patches of a mesh
    static void appendMesh(const fvMesh& mesh, SHA1& sha)
    {
        const pointField& points = mesh.points();
        sha.append
        (
            reinterpret_cast<const char*>(points.cdata()),
            points.size()*sizeof(point)
        );

        for (const face& f : mesh.faces())
        {
            sha.append
            (
                reinterpret_cast<const char*>(f.cdata()),
                f.size()*sizeof(label)
            );
        }

        OStringStream os;
        for (const polyPatch& pp : mesh.boundaryMesh())
        {
            os  << pp.name() << pp.type() << pp.start() << pp.size();
        }
        sha.append(os.str());
    }

    //- Contents of the surface files that the bodies name
    static void appendSurfaces
    (
        const fvMesh& mesh,
        const dictionary& bodies,
        SHA1& sha
    )
    {
        for (const entry& e : bodies)
        {
            const fileName name
            (
                e.isDict()
              ? e.dict().lookupOrDefault<fileName>("surface", fileName::null)
              : fileName::null
            );
            if (name.size())
            {
                std::ifstream is
                (
                    mesh.time().path()/mesh.time().constant()/"triSurface"/name
                );
                sha.append
                (
                    std::string
                    (
                        std::istreambuf_iterator<char>(is),
                        std::istreambuf_iterator<char>()
                    )
                );
            }
        }
    }
}
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::IOdictionary Foam::SPH::readSphMeshDict
(
    const fvMesh& mesh,
    const argList& args
)
{
    fileName file
    (
        args.getOrDefault<fileName>
        (
            "dict",
            mesh.time().path()/mesh.time().system()/"sphMeshDict"
        )
    );
    if (isDir(file))
    {
        file = file/"sphMeshDict";
    }

    IOobject io
    (
        file,
        mesh.time(),
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );

    if (!io.typeHeaderOk<IOdictionary>(true))
    {
        if (args.found("dict"))
        {
            FatalErrorInFunction
                << "Cannot read the dictionary " << file << exit(FatalError);
        }

        Info<< "No " << file << ": particles follow the cells (spacing"
            << " fromMesh)" << nl << endl;
        io.readOpt() = IOobject::NO_READ;
        dictionary defaults;
        defaults.add("spacing", "fromMesh");
        return IOdictionary(io, defaults);
    }

    IOdictionary dict(io);

    for (const entry& e : dict)
    {
        // Others than dictionaries may be variables
        if
        (
            e.isDict()
         && e.keyword() != "FoamFile"
         && !validEntries.found(e.keyword())
        )
        {
            FatalIOErrorInFunction(dict)
                << "Unknown entry " << e.keyword() << nl << nl
                << "Valid entries:" << nl << validEntries.sortedToc()
                << exit(FatalIOError);
        }
    }

    return dict;
}


Foam::dictionary Foam::SPH::particleMeshProperties
(
    const fvMesh& mesh,
    const dictionary& dict
)
{
    SHA1 sha;
    appendMesh(mesh, sha);

    OStringStream os;
    os.precision(17);
    os  << dict << generationVersion;
    sha.append(os.str());
    appendSurfaces(mesh, dict.subOrEmptyDict("bodies"), sha);

    // The prefix keeps a leading digit from being read back as a number
    dictionary properties;
    properties.add("digest", word(sha.digest().str(true)));
    properties.add("kernel", dict.subOrEmptyDict("kernel"));
    properties.add("closure", dict.subOrEmptyDict("closure"));

    return properties;
}


// ************************************************************************* //
