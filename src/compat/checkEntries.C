/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "checkEntries.H"
#include "IOdictionary.H"
#include "OSspecific.H"
#include "Time.H"

#include <cctype>
#include <fstream>
#include <string>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Insertions, deletions and changes of one letter between two words,
    //- whatever their case
    static label editDistance(const word& a, const word& b)
    {
        labelList row(identity(b.size() + 1));
        for (std::size_t i = 0; i < a.size(); ++i)
        {
            label diagonal = row[0];
            row[0] = i + 1;
            for (std::size_t j = 0; j < b.size(); ++j)
            {
                const label changed =
                    diagonal + (std::tolower(a[i]) != std::tolower(b[j]));
                diagonal = row[j + 1];
                row[j + 1] = min(changed, min(row[j], diagonal) + 1);
            }
        }
        return row.last();
    }

    //- Text of a file and of those that it includes
    static std::string textOf(const fileName& file)
    {
        std::ifstream is(file);
        std::string text;
        for (std::string line; std::getline(is, line); )
        {
            text += line + '\n';

            const auto open = line.find('"');
            const auto close = line.find('"', open + 1);
            if
            (
                line.find("#include") != std::string::npos
             && close != std::string::npos
            )
            {
                fileName included(line.substr(open + 1, close - open - 1));
                included.expand();
                text += textOf
                (
                    included.isAbsolute() ? included : file.path()/included
                );
            }
        }
        return text;
    }

    //- Does a text take $name or ${name}
    static bool isVariable(const std::string& text, const word& name)
    {
        for
        (
            auto at = text.find('$');
            at != std::string::npos;
            at = text.find('$', at + 1)
        )
        {
            const auto start = text.find_first_not_of("{:", at + 1);
            if
            (
                start != std::string::npos
             && text.compare(start, name.size(), name) == 0
            )
            {
                const auto end = start + name.size();
                const char next = end < text.size() ? text[end] : ' ';
                if (!std::isalnum(next) && next != '_')
                {
                    return true;
                }
            }
        }
        return false;
    }
}
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::SPH::checkEntries
(
    const dictionary& dict,
    const wordList& valid,
    const fileName& file
)
{
    for (const word& name : dict.sortedToc())
    {
        if
        (
            name == "FoamFile"
         || valid.found(name)
         || isVariable(textOf(file), name)
        )
        {
            continue;
        }

        word nearest(valid[0]);
        for (const word& other : valid)
        {
            if (editDistance(name, other) < editDistance(name, nearest))
            {
                nearest = other;
            }
        }

        FatalIOErrorInFunction(dict)
            << "Unknown entry " << name << ", nearest is " << nearest << nl
            << nl << "Valid entries:" << nl << valid << exit(FatalIOError);
    }
}


bool Foam::SPH::foundDictionary(const IOobject& io)
{
    const bool found = IOobject(io).typeHeaderOk<IOdictionary>(true);
    const fileName file
    (
        io.instance().isAbsolute()
      ? io.objectPath()
      : io.time().globalPath()/io.instance()/io.name()
    );

    if (Pstream::master() && !found && isFile(file))
    {
        FatalErrorInFunction
            << "Cannot read " << file << ": it does not begin with the header"
            << nl << "    FoamFile { version 2.0; format ascii;"
            << " class dictionary; object " << io.name() << "; }"
            << exit(FatalError);
    }
    return found;
}


Foam::word Foam::SPH::checkedWord
(
    const dictionary& dict,
    const word& entry,
    const word& defaultValue,
    const wordList& choices
)
{
    const word value(dict.getOrDefault<word>(entry, defaultValue));
    if (!choices.found(value))
    {
        FatalIOErrorInFunction(dict)
            << "Unknown " << entry << " " << value << nl << nl
            << "Valid choices:" << nl << choices << exit(FatalIOError);
    }
    return value;
}


// ************************************************************************* //
