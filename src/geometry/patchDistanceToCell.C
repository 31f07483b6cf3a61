/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "patchDistanceToCell.H"
#include "addToRunTimeSelectionTable.H"
#include "bitSet.H"
#include "patchWave.H"
#include "polyMesh.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    defineTypeNameAndDebug(patchDistanceToCell, 0);
    addToRunTimeSelectionTable(topoSetCellSource, patchDistanceToCell, word);
    addToRunTimeSelectionTable(topoSetSource, patchDistanceToCell, word);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::patchDistanceToCell::patchDistanceToCell
(
    const polyMesh& mesh,
    const dictionary& dict
)
:
    topoSetCellSource(mesh),
    patches_(),
    distance_(dict.get<scalar>("distance"))
{
    const wordList valid(mesh.boundaryMesh().names());
    for (const wordRe& name : dict.get<wordRes>("patches"))
    {
        const labelList matches(findStrings(name, valid));
        if (matches.empty())
        {
            FatalIOErrorInFunction(dict)
                << "No patch is called " << name << ". Valid patches: "
                << valid << exit(FatalIOError);
        }
        patches_.insert(matches);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::patchDistanceToCell::applyToSet
(
    const topoSetSource::setAction action,
    topoSet& set
) const
{
    const scalarField distance(patchWave(mesh_, patches_).distance());

    bitSet near(distance.size());
    forAll(distance, celli)
    {
        near.set(celli, distance[celli] < distance_);
    }
    addOrDelete(set, near, action != topoSetSource::SUBTRACT);
}


// ************************************************************************* //
