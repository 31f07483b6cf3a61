/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Application
    polygonMesh

Description
    Makes a 2-D mesh of triangular prisms around any polygons, for bodies that
    are tedious to describe to blockMesh.

    Reads system/polygonMeshDict:

    \verbatim
    size        0.1;        // longest edge of triangles [m]
    thickness   1;          // along z [m], default 1
    patches
    {
        outer   {type patch; loop ((0 0) (1 0) (1 1) (0 1));}
        wing    {type wall;  loop "constant/geometry/wing.xy";}
    }
    \endverbatim

    The mesh covers what an odd number of polygons encloses. See polygonPatch.H
    for the entries of a patch.

Usage
    \b polygonMesh [OPTION]

      - \par -dict \<file\>
        Alternative to system/polygonMeshDict

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "IOdictionary.H"
#include "prismMesh.H"
#include "version.H"

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

//- A positive number or FatalIOError
static scalar positive(const dictionary& dict, const word& key)
{
    const scalar value(dict.getOrDefault<scalar>(key, 1));
    if (value <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << key << " is " << value << ", but must be positive"
            << exit(FatalIOError);
    }
    return value;
}


int main(int argc, char *argv[])
{
    argList::addNote("Make a 2-D mesh of triangular prisms around polygons");
    argList::noParallel();
    argList::addOption("dict", "file", "Alternative to system/polygonMeshDict");

    #include "setRootCase.H"
    printVersion();
    #include "createTime.H"

    const IOdictionary dict
    (
        IOobject
        (
            args.getOrDefault<fileName>
            (
                "dict", runTime.path()/runTime.system()/"polygonMeshDict"
            ),
            runTime,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );

    PtrList<polygonPatch> patches;
    for (const entry& e : dict.subDict("patches"))
    {
        patches.append(new polygonPatch(e.dict(), runTime.path()));
    }

    dict.get<scalar>("size");
    const prismMesh prisms
    (
        patches, positive(dict, "size"), positive(dict, "thickness")
    );

    polyMesh mesh
    (
        IOobject
        (
            polyMesh::defaultRegion,
            runTime.constant(),
            runTime,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        prisms.points(),
        faceList(prisms.faces()),
        labelList(prisms.owner()),
        labelList(prisms.neighbour())
    );
    List<polyPatch*> meshPatches(prisms.newPatches(mesh.boundaryMesh()));
    mesh.addPatches(meshPatches);

    IOstream::defaultPrecision(max(16u, IOstream::defaultPrecision()));
    mesh.removeFiles();
    mesh.write();

    Info<< "cells: " << prisms.nCells() << nl << "Written to "
        << mesh.pointsInstance()/mesh.meshDir() << "\n\nEnd\n" << endl;

    return 0;
}


// ************************************************************************* //
