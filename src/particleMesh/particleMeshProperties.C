/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleMeshProperties.H"
#include "checkEntries.H"
#include "particleFiles.H"
#include "OSspecific.H"
#include "SHA1.H"
#include "StringStream.H"
#include "Tuple2.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Raised whenever the same dictionary gives other particles, so that
    //- what an older sphMesh made is not taken for up to date
    static const label generationVersion = 3;

    //- Entries of sphMeshDict
    static const wordList validEntries
    ({
        "scheme", "spacing", "kernel", "lattice", "bodies", "relaxation",
        "closure", "zone"
    });

    //- Entries of its sub-dictionaries
    static const List<Tuple2<word, wordList>> subEntries
    ({
        {
            "spacing",
            {
                "type", "value", "base", "near", "regions", "growth", "scale",
                "min", "max"
            }
        },
        {"kernel", {"type", "smoothingRatio"}},
        {"lattice", {"type", "jitter", "seed"}},
        {
            "relaxation",
            {
                "type", "tolerance", "rmsTolerance", "disturbance", "momentum",
                "maxIterations", "logInterval", "skin", "freeze", "repair",
                "viscosity"
            }
        },
        {
            "closure",
            {
                "type", "order", "sweeps", "tolerance", "maxIterations",
                "volumes", "leastArea", "latticePairs", "threshold",
                "splitCorners"
            }
        }
    });

    //- Entries of each body
    static const wordList bodyEntries
    ({
        "patches", "surface", "scale", "maxHoleSize", "smoothingRatio"
    });

    //- Entries of each patch and each region of the spacing
    static const wordList nearEntries({"spacing", "growth", "layers"});

    static const wordList regionEntries
    ({
        "type", "min", "max", "centre", "radius", "point1", "point2",
        "spacing", "growth", "layers"
    });

    //- Check the entries of each sub-dictionary of a group, if there is one
    static void checkGroup
    (
        const dictionary& dict,
        const word& group,
        const wordList& valid,
        const fileName& file
    )
    {
        for (const entry& e : dict.subOrEmptyDict(group))
        {
            if (e.isDict())
            {
                checkEntries(e.dict(), valid, file);
            }
        }
    }

    //- What scheme papers stands for, but for what the dictionary says
    static void setPapers(dictionary& dict)
    {
        IStringStream is
        (
            "kernel { type LaguerreGauss; smoothingRatio 1.3; }"
            "closure { type surfaceVector; splitCorners yes; }"
            "relaxation { tolerance 1e-3; }"
        );
        const dictionary given(dict);
        dict.merge(dictionary(is));
        dict.merge(given);
    }

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

    if (!foundDictionary(io))
    {
        if (args.found("dict"))
        {
            FatalErrorInFunction
                << "Cannot read the dictionary " << file << exit(FatalError);
        }

        io.readOpt() = IOobject::NO_READ;
    }

    IOdictionary dict(io);
    if (!dict.found("spacing"))
    {
        Info<< "No "
            << (io.readOpt() == IOobject::NO_READ ? "" : "entry spacing in ")
            << file << ": particles follow the cells (spacing fromMesh)" << nl
            << endl;
        dict.add("spacing", "fromMesh");
    }

    checkEntries(dict, validEntries, file);
    for (const auto& sub : subEntries)
    {
        if (dict.isDict(sub.first()))
        {
            checkEntries(dict.subDict(sub.first()), sub.second(), file);
        }
    }
    checkGroup(dict, "bodies", bodyEntries, file);
    if (dict.isDict("spacing"))
    {
        checkGroup(dict.subDict("spacing"), "near", nearEntries, file);
        checkGroup(dict.subDict("spacing"), "regions", regionEntries, file);
    }

    if (checkedWord(dict, "scheme", "none", {"none", "papers"}) == "papers")
    {
        setPapers(dict);
    }

    return dict;
}


Foam::dictionary Foam::SPH::particleMeshProperties
(
    const particleZone& zone,
    const dictionary& dict
)
{
    const fvMesh& mesh = zone.fvm();
    SHA1 sha;
    appendMesh(mesh, sha);
    if (!zone.everywhere())
    {
        sha.append
        (
            reinterpret_cast<const char*>(zone.inside().cdata()),
            zone.inside().size()*sizeof(bool)
        );
    }

    OStringStream os;
    os.precision(17);
    os  << dict << generationVersion
        << particleFiles::surfaceDigests
           (
               mesh.time().path(),
               dict.subOrEmptyDict("bodies")
           );
    sha.append(os.str());

    // The prefix keeps a leading digit from being read back as a number
    dictionary properties;
    properties.add("digest", word(sha.digest().str(true)));
    properties.add("kernel", dict.subOrEmptyDict("kernel"));
    properties.add("closure", dict.subOrEmptyDict("closure"));
    if (dict.found("zone"))
    {
        properties.add(dict.lookupEntry("zone", keyType::LITERAL));
    }
    if (zone.bodies().size())
    {
        properties.add("bodies", dict.subDict("bodies"));
    }

    return properties;
}


// ************************************************************************* //
