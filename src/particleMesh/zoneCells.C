/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "zoneCells.H"
#include "cellSet.H"
#include "checkEntries.H"
#include "topoSetCellSource.H"
#include "wordRes.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Cells of cellZones
    static boolList namedCells
    (
        const polyMesh& mesh,
        const dictionary& dict,
        const wordRes& names
    )
    {
        const wordList valid(mesh.cellZones().names());
        boolList chosen(mesh.nCells(), false);
        for (const wordRe& name : names)
        {
            const labelList matches(findStrings(name, valid));
            if (matches.empty())
            {
                FatalIOErrorInFunction(dict)
                    << "zone: no cellZone of the mesh is called " << name
                    << ". Valid cellZones: " << valid << nl
                    << "    or a source of topoSet, as zone {type boxToCell;"
                    << " box (0 0 0) (1 1 1);}" << exit(FatalIOError);
            }
            for (const label zonei : matches)
            {
                UIndirectList<bool>(chosen, mesh.cellZones()[zonei]) = true;
            }
        }
        return chosen;
    }

    //- Cells of a topoSetCellSource
    static boolList sourceCells(const polyMesh& mesh, const dictionary& dict)
    {
        cellSet cells(mesh, "zone", mesh.nCells()/10 + 1);
        topoSetCellSource::New(dict.get<word>("type"), mesh, dict)
          ->applyToSet(topoSetSource::ADD, cells);

        boolList chosen(mesh.nCells(), false);
        UIndirectList<bool>(chosen, cells.toc()) = true;
        return chosen;
    }

    //- Change the cells chosen by those of a source
    static void combine
    (
        const dictionary& dict,
        const boolList& cells,
        boolList& chosen
    )
    {
        const word action
        (
            checkedWord(dict, "action", "add", {"add", "subset", "subtract"})
        );

        forAll(chosen, celli)
        {
            chosen[celli] =
                action == "add" ? chosen[celli] || cells[celli]
              : action == "subset" ? chosen[celli] && cells[celli]
              : chosen[celli] && !cells[celli];
        }
    }
}
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::boolList Foam::SPH::zoneCells
(
    const polyMesh& mesh,
    const dictionary& dict
)
{
    if (!dict.found("zone"))
    {
        return boolList(mesh.nCells(), true);
    }

    boolList chosen(mesh.nCells(), false);
    if (!dict.isDict("zone"))
    {
        const tokenList& tokens = dict.lookup("zone");
        const bool isList =
            tokens.size() && tokens[0] == token::BEGIN_LIST;
        chosen = namedCells
        (
            mesh,
            dict,
            isList
          ? dict.get<wordRes>("zone")
          : wordRes(one(), dict.get<wordRe>("zone"))
        );
    }
    else if (dict.subDict("zone").found("type"))
    {
        chosen = sourceCells(mesh, dict.subDict("zone"));
    }
    else
    {
        const dictionary& sources = dict.subDict("zone");
        for (const entry& e : sources)
        {
            if (!e.isDict())
            {
                FatalIOErrorInFunction(sources)
                    << "Entry " << e.keyword() << " of zone is no dictionary"
                    << " with the type of a topoSetCellSource, as boxToCell"
                    << exit(FatalIOError);
            }
            combine(e.dict(), sourceCells(mesh, e.dict()), chosen);
        }
    }

    if (!chosen.found(true))
    {
        FatalIOErrorInFunction(dict)
            << "zone: no cell of the mesh is in it" << exit(FatalIOError);
    }

    return chosen;
}


// ************************************************************************* //
