/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    Reading and writing of constant/sphMesh.

\*---------------------------------------------------------------------------*/

#include "sphMesh.H"
#include "solidParticles.H"
#include "storedArrays.H"
#include "labelIOList.H"
#include "scalarIOField.H"
#include "vectorIOField.H"
#include "IOdictionary.H"
#include "OSspecific.H"
#include "SHA1.H"
#include "StringStream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Vectors from owner to neighbour
    static vectorField centreDifferences(const particleMeshData& data)
    {
        vectorField d(data.owner.size());
        forAll(d, pairi)
        {
            d[pairi] =
                data.points[data.neighbour[pairi]]
              - data.points[data.owner[pairi]];
        }
        return d;
    }

    static IOobject storedIO(const word& name, const fvMesh& mesh)
    {
        return arrayIO(name, mesh, sphMesh::folder, IOobject::MUST_READ);
    }

    static IOdictionary readProperties(const fvMesh& mesh)
    {
        IOobject io(storedIO("sphMeshProperties", mesh));

        if (!io.typeHeaderOk<IOdictionary>(true))
        {
            FatalErrorInFunction
                << "No particle mesh in " << sphMesh::directory(mesh)
                << ". Generate it with sphMesh" << exit(FatalError);
        }

        IOdictionary properties(io);

        // Before any array, whose sizes mean nothing on another mesh
        if
        (
            properties.get<word>("mesh")
         != sphMesh::digest(mesh, dictionary::null)
        )
        {
            FatalErrorInFunction
                << "The particle mesh in " << sphMesh::directory(mesh)
                << " was generated for another mesh or other patches."
                << " Regenerate it with sphMesh" << exit(FatalError);
        }

        return properties;
    }

    template<class Container>
    static Container readStored(const word& name, const fvMesh& mesh)
    {
        return readArray<Container>(name, mesh, sphMesh::folder);
    }

    static particleMeshData readArrays(const fvMesh& mesh)
    {
        particleMeshData data;
        data.points = readStored<vectorIOField>("points", mesh);
        data.V = readStored<scalarIOField>("V", mesh);
        data.spacing = readStored<scalarIOField>("spacing", mesh);
        data.owner = readStored<labelIOList>("owner", mesh);
        data.neighbour = readStored<labelIOList>("neighbour", mesh);
        data.Sf = readStored<vectorIOField>("Sf", mesh);

        const auto optional = [&](const word& name, vectorField& field)
        {
            IOobject io(storedIO(name, mesh));
            const bool found = io.typeHeaderOk<vectorIOField>(true);
            if (found)
            {
                field = vectorIOField(io);
            }
            return found;
        };

        if (!optional("delta", data.delta))
        {
            data.delta = centreDifferences(data);
        }
        optional("skew", data.skew);

        data.boundary.owner = readStored<labelIOList>("boundaryOwner", mesh);
        data.boundary.Sf = readStored<vectorIOField>("boundarySf", mesh);
        data.boundary.Cf = readStored<vectorIOField>("boundaryCf", mesh);
        data.boundary.distance =
            readStored<scalarIOField>("boundaryDistance", mesh);
        data.boundary.face = readStored<labelIOList>("boundaryFace", mesh);

        const IOdictionary patches(storedIO("boundary", mesh));

        data.boundary.start.setSize(mesh.boundary().size() + 1);
        data.boundary.start[0] = 0;
        forAll(mesh.boundary(), patchi)
        {
            data.boundary.start[patchi + 1] =
                data.boundary.start[patchi]
              + patches.subDict(mesh.boundary()[patchi].name())
               .get<label>("nFaces");
        }

        return data;
    }
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::sphMesh::sphMesh(const fvMesh& mesh)
:
    // The braces have the properties read first, whose error says that there
    // is no particle mesh
    sphMesh{mesh, readProperties(mesh), readArrays(mesh)}
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fileName Foam::SPH::sphMesh::directory(const fvMesh& mesh)
{
    return mesh.time().path()/mesh.time().constant()/folder;
}


Foam::word Foam::SPH::sphMesh::digest
(
    const fvMesh& mesh,
    const dictionary& dict
)
{
    SHA1 sha;

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
    os  << dict;
    sha.append(os.str());

    // The prefix keeps a leading digit from being read back as a number
    return sha.digest().str(true);
}


Foam::word Foam::SPH::sphMesh::storedDigest(const fvMesh& mesh)
{
    IOobject io(storedIO("sphMeshProperties", mesh));

    return
        io.typeHeaderOk<IOdictionary>(true)
      ? IOdictionary(io).getOrDefault<word>("digest", word::null)
      : word::null;
}


void Foam::SPH::sphMesh::writeMesh
(
    const UList<particleSet>& solids
) const
{
    // A complete new folder replaces the old one at the end, so that an
    // interrupted run leaves no mixture of two particle meshes
    const word partial(folder + ".partial");
    const fileName partialPath
    (
        mesh_.time().path()/mesh_.time().constant()/partial
    );
    rmDir(partialPath, true);

    writeArray<vectorIOField>("points", mesh_, partial, C());
    writeArray<scalarIOField>("V", mesh_, partial, V());
    writeArray<scalarIOField>("spacing", mesh_, partial, spacing());
    writeArray<labelIOList>("owner", mesh_, partial, owner());
    writeArray<labelIOList>("neighbour", mesh_, partial, neighbour());
    writeArray<vectorIOField>("Sf", mesh_, partial, Sf());

    if (delta() != centreDifferences(data_))
    {
        writeArray<vectorIOField>("delta", mesh_, partial, delta());
    }
    if (skew().size())
    {
        writeArray<vectorIOField>("skew", mesh_, partial, skew());
    }

    const boundaryFaces& faces = boundary().faces();
    writeArray<labelIOList>("boundaryOwner", mesh_, partial, faces.owner);
    writeArray<vectorIOField>("boundarySf", mesh_, partial, faces.Sf);
    writeArray<vectorIOField>("boundaryCf", mesh_, partial, faces.Cf);
    writeArray<scalarIOField>
    (
        "boundaryDistance", mesh_, partial, faces.distance
    );
    writeArray<labelIOList>("boundaryFace", mesh_, partial, faces.face);

    IOdictionary patches
    (
        arrayIO("boundary", mesh_, partial, IOobject::NO_READ)
    );
    for (const sphPatch& patch : boundary())
    {
        dictionary entry;
        entry.add("nFaces", patch.size());
        entry.add("startFace", patch.start());
        patches.add(patch.name(), entry);
    }
    checkWritten(patches.regIOobject::write(), patches);

    if (solids.size())
    {
        writeSolidParticles(mesh_, partial, solids);
    }

    IOdictionary properties
    (
        arrayIO("sphMeshProperties", mesh_, partial, IOobject::NO_READ),
        properties_
    );
    properties.set("mesh", digest(mesh_, dictionary::null));
    properties.set("nParticles", nParticles());
    properties.set("nPairs", nPairs());
    const unsigned precision = IOstream::defaultPrecision(17);
    checkWritten(properties.regIOobject::write(), properties);
    IOstream::defaultPrecision(precision);

    rmDir(directory(mesh_), true);
    mv(partialPath, directory(mesh_));
}


bool Foam::SPH::sphMesh::writeData(Ostream& os) const
{
    properties_.write(os, false);
    return os.good();
}


// ************************************************************************* //
