/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "testCase.H"
#include "cyclicPolyPatch.H"
#include "emptyPolyPatch.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "polyPatch.H"
#include "wallPolyPatch.H"

#include <cstdlib>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- The vertices of the six faces of a hexahedron (x-, x+, y-, y+, z-, z+), as
//- steps in x, y, z, ordered so that the normal points outwards
constexpr label hexFaces[6][4][3] =
{
    {{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}},
    {{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}},
    {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}},
    {{0, 1, 0}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0}},
    {{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}},
    {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}
};


//- The box of hexahedra as faces, numbered as polyMesh wants them
class hexBox
{
    const SPH::testCase::layout& layout_;

    //- Cell of each position of the box, -1 where it was cut out
    labelList cellMap_;

    //- Point of each vertex of the box, -1 where it is not used
    labelList pointMap_;

    //- Patch of each face of a hexahedron, in 2-D with the last two merged
    label sidePatch(const label facei) const
    {
        return layout_.twoD ? min(facei, label(4)) : facei;
    }

    label cell(const labelVector& ijk) const
    {
        const labelVector& n = layout_.nCells;
        return cellMap_[ijk.x() + n.x()*(ijk.y() + n.y()*ijk.z())];
    }

    point position(const labelVector& ijk, const scalar offset) const
    {
        point p(layout_.box.min());
        for (direction d = 0; d < 3; ++d)
        {
            p[d] += layout_.box.span()[d]*(ijk[d] + offset)/layout_.nCells[d];
        }
        return p;
    }

    template<class Action>
    void forAllCells(const Action& action) const
    {
        labelVector ijk;
        for (ijk.z() = 0; ijk.z() < layout_.nCells.z(); ++ijk.z())
        {
            for (ijk.y() = 0; ijk.y() < layout_.nCells.y(); ++ijk.y())
            {
                for (ijk.x() = 0; ijk.x() < layout_.nCells.x(); ++ijk.x())
                {
                    action(ijk);
                }
            }
        }
    }

    //- The face of a cell, adding its vertices to the points
    face makeFace(const labelVector& ijk, const label facei)
    {
        const labelVector& n = layout_.nCells;

        face f(4);
        forAll(f, pi)
        {
            const auto& step = hexFaces[facei][pi];
            const labelVector vertex
            (
                ijk + labelVector(step[0], step[1], step[2])
            );

            label& pointi = pointMap_
            [
                vertex.x()
              + (n.x() + 1)*(vertex.y() + (n.y() + 1)*vertex.z())
            ];
            if (pointi == -1)
            {
                pointi = points.size();
                const point p(position(vertex, 0));
                points.append(layout_.transform ? layout_.transform(p) : p);
            }
            f[pi] = pointi;
        }
        return f;
    }


public:

    DynamicList<point> points;
    DynamicList<face> faces;
    DynamicList<label> owner;
    DynamicList<label> neighbour;
    wordList patchNames;
    labelList patchSizes;

    explicit hexBox(const SPH::testCase::layout& l);
};


hexBox::hexBox(const SPH::testCase::layout& l)
:
    layout_(l),
    cellMap_(cmptProduct(l.nCells), label(-1)),
    pointMap_(cmptProduct(l.nCells + labelVector::one), label(-1)),
    patchNames({"left", "right", "bottom", "top"})
{
    if (l.twoD)
    {
        patchNames.append("frontAndBack");
    }
    else
    {
        patchNames.append(wordList({"back", "front"}));
    }

    const label holePatch = patchNames.size();
    patchNames.append("hole");

    label nCells = 0;
    label position0 = 0;
    forAllCells
    (
        [&](const labelVector& ijk)
        {
            if (!l.hole.contains(position(ijk, 0.5)))
            {
                cellMap_[position0] = nCells++;
            }
            ++position0;
        }
    );

    List<DynamicList<face>> patchFaces(patchNames.size());
    List<DynamicList<label>> patchOwner(patchNames.size());

    forAllCells
    (
        [&](const labelVector& ijk)
        {
            const label celli = cell(ijk);

            for (label facei = 0; facei < 6 && celli != -1; ++facei)
            {
                const direction d = facei/2;
                labelVector next(ijk);
                next[d] += (facei % 2 ? 1 : -1);

                const bool outside = (next[d] < 0 || next[d] == l.nCells[d]);
                const label nbr = (outside ? -1 : cell(next));

                if (nbr > celli)
                {
                    faces.append(makeFace(ijk, facei));
                    owner.append(celli);
                    neighbour.append(nbr);
                }
                else if (nbr == -1)
                {
                    const label patchi = outside ? sidePatch(facei) : holePatch;
                    patchFaces[patchi].append(makeFace(ijk, facei));
                    patchOwner[patchi].append(celli);
                }
            }
        }
    );

    if (patchFaces[holePatch].empty())
    {
        patchNames.resize(holePatch);
    }

    patchSizes.resize(patchNames.size());
    forAll(patchNames, patchi)
    {
        patchSizes[patchi] = patchFaces[patchi].size();
        faces.append(patchFaces[patchi]);
        owner.append(patchOwner[patchi]);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::testCase::writeMesh(const layout& l) const
{
    hexBox box(l);

    labelList sizes(box.patchSizes);
    const wordList names(box.patchNames);
    label start = box.neighbour.size();

    polyMesh mesh
    (
        IOobject
        (
            polyMesh::defaultRegion,
            timePtr_->constant(),
            *timePtr_,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE,
            false
        ),
        pointField(box.points),
        faceList(box.faces),
        labelList(box.owner),
        labelList(box.neighbour)
    );

    List<polyPatch*> patches(names.size());
    forAll(names, patchi)
    {
        word type(polyPatch::typeName);
        if (names[patchi] == "frontAndBack")
        {
            type = emptyPolyPatch::typeName;
        }
        else if (names[patchi] == "hole")
        {
            type = wallPolyPatch::typeName;
        }

        dictionary dict;
        if (patchi < 6 && l.periodic[patchi/2])
        {
            type = cyclicPolyPatch::typeName;
            dict.add("neighbourPatch", names[patchi ^ 1]);
        }
        dict.add("type", l.patchTypes.lookup(names[patchi], type));
        dict.add("nFaces", sizes[patchi]);
        dict.add("startFace", start);

        patches[patchi] = polyPatch::New
        (
            names[patchi],
            dict,
            patchi,
            mesh.boundaryMesh()
        ).ptr();
        start += sizes[patchi];
    }
    mesh.addPatches(patches);
    mesh.write();
}


void Foam::SPH::testCase::openTime()
{
    timePtr_.reset
    (
        new Time
        (
            Time::controlDictName,
            path_.path(),
            fileName(path_.name())
        )
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::testCase::testCase()
{
    const char* parent = std::getenv("TMPDIR");
    std::string directory(parent ? parent : "/tmp");
    directory += "/eulerianSPHTest.XXXXXX";
    if (!::mkdtemp(&directory[0]))
    {
        FatalErrorInFunction
            << "Cannot make the directory " << directory << exit(FatalError);
    }
    path_ = directory;
}


Foam::SPH::testCase::testCase(const layout& l)
:
    testCase()
{
    write
    (
        "system/controlDict",
        "application wcSphFoam; startFrom startTime; startTime 0;"
        "stopAt endTime; endTime 1; deltaT 0.1;"
        "writeControl timeStep; writeInterval 1; writeFormat binary;"
    );
    write
    (
        "system/fvSchemes",
        "ddtSchemes { default Euler; } gradSchemes { default Gauss linear; }"
        "divSchemes { default none; } laplacianSchemes { default none; }"
        "interpolationSchemes { default linear; }"
        "snGradSchemes { default corrected; }"
    );
    write("system/fvSolution", "solvers {}");

    openTime();
    writeMesh(l);
    reopen();
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::SPH::testCase::~testCase()
{
    meshPtr_.clear();
    timePtr_.clear();
    rmDir(path_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::testCase::reopen()
{
    meshPtr_.clear();
    openTime();
    meshPtr_.reset
    (
        new fvMesh
        (
            IOobject
            (
                polyMesh::defaultRegion,
                timePtr_->timeName(),
                *timePtr_,
                IOobject::MUST_READ
            )
        )
    );
}


void Foam::SPH::testCase::write
(
    const fileName& file,
    const std::string& content,
    const word& className
) const
{
    mkDir((path_/file).path());

    OFstream os(path_/file);
    os  << "FoamFile { version 2.0; format ascii; class " << className
        << "; object " << file.name() << "; }" << nl
        << content.c_str() << endl;
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::string Foam::SPH::errorMessage(const std::function<void()>& function)
{
    try
    {
        function();
    }
    catch (const IOerror& error)
    {
        return error.message() + '\n' + error.ioFileName();
    }
    catch (const error& error)
    {
        return error.message();
    }
    return std::string();
}


// ************************************************************************* //
