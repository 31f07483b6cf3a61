/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "closure.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    defineTypeNameAndDebug(closure, 0);
    defineRunTimeSelectionTable(closure, dictionary);

    defineTypeNameAndDebug(noClosure, 0);
    addToRunTimeSelectionTable(closure, noClosure, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::SPH::closure> Foam::SPH::closure::New
(
    const dictionary& dict
)
{
    const word closureType(dict.lookupOrDefault<word>("type", "consistent"));

    auto cstrIter = dictionaryConstructorTablePtr_->cfind(closureType);

    if (!cstrIter.found())
    {
        FatalIOErrorInLookup
        (
            dict,
            "closure",
            closureType,
            *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }

    return autoPtr<closure>(cstrIter()(dict));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::noClosure::close
(
    const fvMesh& mesh,
    const solutionSpace&,
    const kernel&,
    const signedDistance&,
    particleMeshData& data
) const
{
    data.boundary.start = labelList(mesh.boundary().size() + 1, Zero);
}


// ************************************************************************* //
