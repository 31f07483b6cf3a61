/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    The dictionaries of a particle case.

\*---------------------------------------------------------------------------*/

#include "particleCase.H"
#include "particleFiles.H"
#include "dlLibraryTable.H"
#include "IFstream.H"
#include "IOdictionary.H"
#include "OSspecific.H"
#include "StringStream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- The library that every solver of a particle case loads
    static const fileName library("eulerianSPH");

    //- Dictionaries that only make the FVM mesh or compare with it
    static const wordHashSet fvmDicts
    ({
        "blockMeshDict", "compareSphFieldsDict", "snappyHexMeshDict",
        "sphMeshDict", "sphSchemes"
    });

    //- Function objects that track through cells
    static const wordHashSet trackingTypes
    ({
        "icoUncoupledKinematicCloud", "streamLine", "streamLines",
        "wallBoundedStreamLine"
    });

    //- Sets of points that are not found by tracking
    static const wordHashSet cloudTypes
    ({
        "boundaryCloud", "boundaryPoints", "cellCentre", "cloud",
        "patchCloud", "patchSeed", "triSurfaceMeshPointSet"
    });

    static bool tracksSets(const dictionary& function)
    {
        if (!function.found("sets"))
        {
            return false;
        }

        bool tracks = false;
        const auto check = [&](const dictionary& set)
        {
            tracks =
                tracks
             || !cloudTypes.found(set.getOrDefault<word>("type", "none"));
        };

        if (function.isDict("sets"))
        {
            for (const entry& e : function.subDict("sets"))
            {
                check(e.dict());
            }
        }
        else
        {
            const PtrList<entry> sets(function.lookup("sets"));
            for (const entry& e : sets)
            {
                check(e.dict());
            }
        }

        return tracks;
    }

    //- Is an entry these words, and nothing else
    static bool isScheme(ITstream& is, const wordList& words)
    {
        bool same = is.size() == words.size();
        for (label i = 0; same && i < words.size(); ++i)
        {
            same = is[i].isWord() && is[i].wordToken() == words[i];
        }
        return same;
    }

    //- Does a file have a header
    static bool hasHeader(const fileName& file)
    {
        IFstream is(file);
        const token first(is);
        return first.isWord() && first.wordToken() == "FoamFile";
    }

    //- Text of a header
    static std::string header(const word& className, const word& object)
    {
        return
            "FoamFile\n{\n    version     2.0;\n    format      ascii;\n"
            "    class       " + className + ";\n"
            "    object      " + object + ";\n}\n";
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::string Foam::SPH::particleCase::controlAdditions() const
{
    const dictionary& controlDict = mesh_.time().controlDict();

    fileNameList libs
    (
        controlDict.getOrDefault<fileNameList>("libs", fileNameList())
    );
    bool loaded = false;
    for (const fileName& lib : libs)
    {
        loaded = loaded || lib.lessExt().find(library) != std::string::npos;
    }
    if (!loaded)
    {
        libs.append(library);
    }

    OStringStream os;
    os  << "libs            (";
    forAll(libs, i)
    {
        os  << (i ? " " : "") << libs[i];
    }
    os  << ");\n\n"
        << "// A few decimal digits would open the particles\n"
        << "writeFormat     binary;\n";

    DynamicList<word> left;
    for (const entry& e : controlDict.subOrEmptyDict("functions"))
    {
        if
        (
            e.isDict()
         && (
                trackingTypes.found(e.dict().getOrDefault<word>("type", ""))
             || tracksSets(e.dict())
            )
        )
        {
            left.append(e.keyword());
        }
    }
    if (left.size())
    {
        os  << "\n// Particles fill no space to track through\nfunctions\n{\n";
        for (const word& name : left)
        {
            Info<< "    leaving out the function object " << name
                << ", which tracks through cells" << nl;
            os  << "    " << name << " { enabled false; }\n";
        }
        os  << "}\n";
    }

    return os.str();
}


std::string Foam::SPH::particleCase::schemeAdditions() const
{
    //- Schemes of the FVM case in a group, the one of a name by default
    const auto schemesOf = [&](const word& group, const word& name)
    {
        dictionary schemes(mesh_.schemesDict().subOrEmptyDict(group));
        if
        (
            !schemes.found(name, keyType::LITERAL)
         && schemes.found("default")
        )
        {
            schemes.add(name, schemes.lookup("default"));
        }
        return schemes;
    };

    // Where convection is limited there may be shocks
    bool central = false;
    std::string convection;
    for (const entry& e : schemesOf("divSchemes", "div(phi,U)"))
    {
        if (!e.keyword().isPattern() && e.keyword().starts_with("div(phi"))
        {
            if
            (
                isScheme(e.stream(), {"Gauss", "linear"})
             || isScheme(e.stream(), {"GaussAhead", "linear"})
            )
            {
                central = true;
                convection +=
                    "    " + e.keyword() + " GaussAhead reconstructed;\n";
            }
            central =
                central
             || isScheme(e.stream(), {"bounded", "Gauss", "linear"});
        }
    }

    std::string additions;
    if (!convection.empty())
    {
        additions +=
            "// Exact at the faces' centres, by the flux of the new time\n"
            "divSchemes\n{\n" + convection + "}\n";
    }

    const word pressure("grad(p)");
    const dictionary gradients(schemesOf("gradSchemes", pressure));
    const entry* e = gradients.findEntry(pressure, keyType::LITERAL);
    if (central && e && isScheme(e->stream(), {"Gauss", "linear"}))
    {
        additions +=
            "gradSchemes\n{\n"
            "    grad(p) Gauss reconstructed exact(p);\n"
            "    exact(p) leastSquares;\n}\n";
    }

    return additions;
}


std::string Foam::SPH::particleCase::additions(const word& dictName)
{
    return
        dictName == "controlDict" ? controlAdditions()
      : dictName == "fvSchemes" ? schemeAdditions()
      : dictName == "fvSolution" ? solutionAdditions()
      : std::string();
}


void Foam::SPH::particleCase::writeFolder(const word& folder)
{
    const fileName from(mesh_.time().path()/folder);
    const fileName above(fileName("..")/".."/folder);

    for (const fileName& name : readDir(from, fileName::FILE))
    {
        if (fvmDicts.found(name.lessExt()) || name.ends_with("~"))
        {
            continue;
        }

        IOobject io
        (
            name.hasExt("gz") ? name.lessExt() : name,
            folder,
            mesh_.time(),
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        );

        // Files to be included have no header, and OpenFOAM warns of that
        const bool hasClass =
            hasHeader(from/name) && io.typeHeaderOk<IOdictionary>(false);

        // Fields are mapped
        if (hasClass && io.headerClassName().starts_with("vol"))
        {
            continue;
        }

        const bool isDictionary =
            hasClass
         && (
                io.headerClassName() == "dictionary"
             || io.headerClassName().starts_with("uniformDimensioned")
            );

        if (!isDictionary)
        {
            files_.link(folder/name, above/name);
            continue;
        }

        std::string text
        (
            header(io.headerClassName(), io.name())
          + "\n// Of the FVM case\n#include \"" + (above/io.name()) + "\"\n"
        );
        const std::string own
        (
            folder == "system" ? additions(io.name()) : std::string()
        );
        if (own.size())
        {
            text += "\n" + own;
        }
        files_.writeText(folder/io.name(), text);
    }

    for (const fileName& name : readDir(from, fileName::DIRECTORY))
    {
        if (name != "polyMesh" && name != particleFiles::folder)
        {
            files_.link(folder/name, above/name);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::particleCase::writeDictionaries()
{
    writeFolder("system");
    writeFolder("constant");

    // Schemes of the native solvers may come later
    const fileName schemes("system/sphSchemes");
    files_.writeText
    (
        schemes,
        header("dictionary", schemes.name())
      + "\n// Of the FVM case, once it has them\n"
        "#includeIfPresent \"../../system/sphSchemes\"\n"
    );

    files_.write();
}


// ************************************************************************* //
