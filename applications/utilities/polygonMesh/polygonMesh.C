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

    Reads system/polygonMeshDict, see trianglePrisms.H.

Usage
    \b polygonMesh [OPTION]

      - \par -dict \<file\>
        Alternative to system/polygonMeshDict

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "IOdictionary.H"
#include "trianglePrisms.H"
#include "version.H"

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

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

    const autoPtr<polyMesh> mesh
    (
        newPolygonMesh
        (
            IOobject
            (
                polyMesh::defaultRegion,
                runTime.constant(),
                runTime,
                IOobject::NO_READ,
                IOobject::AUTO_WRITE
            ),
            dict
        )
    );

    IOstream::defaultPrecision(max(16u, IOstream::defaultPrecision()));
    mesh->removeFiles();
    mesh->write();

    Info<< "cells: " << mesh->nCells() << nl << "Written to "
        << mesh->pointsInstance()/mesh->meshDir() << "\n\nEnd\n" << endl;

    return 0;
}


// ************************************************************************* //
