/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleMeshProperties.H"
#include "sphMesh.H"
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
    static const label generationVersion = 2;

    //- Sub-dictionaries of sphMeshDict
    static const wordHashSet validDicts
    ({
        "FoamFile", "spacing", "kernel", "lattice", "bodies", "relaxation",
        "closure", "levelSet"
    });

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
        FatalErrorInFunction
            << "Cannot read the dictionary " << file
            << ". Its only required entry is 'spacing', for example"
            << " 'spacing 0.05;' [m]" << exit(FatalError);
    }

    IOdictionary dict(io);

    for (const entry& e : dict)
    {
        if (e.isDict() && !validDicts.found(e.keyword()))
        {
            IOWarningInFunction(dict)
                << "Nobody reads the sub-dictionary '" << e.keyword()
                << "'. Valid ones: " << validDicts.sortedToc() << endl;
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
    OStringStream os;
    os  << dict;
    sha.append(os.str());
    appendSurfaces(mesh, dict.subOrEmptyDict("bodies"), sha);

    dictionary key;
    key.add("content", word(sha.digest().str()));
    key.add("version", generationVersion);

    dictionary properties;
    properties.add("digest", sphMesh::digest(mesh, key));
    properties.add("kernel", dict.subOrEmptyDict("kernel"));
    properties.add("closure", dict.subOrEmptyDict("closure"));

    return properties;
}


// ************************************************************************* //
