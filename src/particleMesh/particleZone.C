/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleZone.H"
#include "consistentClosure.H"
#include "cyclicPolyPatch.H"
#include "smoothBorder.H"
#include "zoneCells.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::boolList Foam::SPH::particleZone::chooseCells
(
    const fvMesh& mesh,
    const cutBodies& bodies,
    const dictionary& dict
)
{
    // Other closures do not close particles against FVM cells
    const bool around =
        bodies.size()
     && !dict.found("zone")
     && dict.subOrEmptyDict("closure").getOrDefault<word>
        (
            "type", consistentClosure::typeName
        )
     == consistentClosure::typeName;

    boolList chosen(around ? bodies.zone() : zoneCells(mesh, dict));
    smoothBorder(mesh, chosen);
    if (!chosen.found(true))
    {
        FatalIOErrorInFunction(dict)
            << "zone: no cell is left in it where its border is smoothed: it is"
            << " one cell thick or less. Valid zones are a few cells thick"
            << exit(FatalIOError);
    }
    bodies.checkZone(chosen, dict);
    return chosen;
}


void Foam::SPH::particleZone::checkCyclic(const dictionary& dict) const
{
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        const auto* cyclic = isA<cyclicPolyPatch>(pp);
        for (label k = 0; cyclic && k < pp.size(); ++k)
        {
            const bool here = inside_[pp.faceCells()[k]];
            if (here != inside_[cyclic->neighbPatch().faceCells()[k]])
            {
                FatalIOErrorInFunction(dict)
                    << "zone: of the pair of cyclic faces at "
                    << pp.faceCentres()[k] << " on patch " << pp.name()
                    << " and at "
                    << cyclic->neighbPatch().faceCentres()[k] << " on patch "
                    << cyclic->neighbPatchName() << " only the cell at "
                    << (here ? pp.name() : cyclic->neighbPatchName())
                    << " is in the zone. Put both in or leave both out"
                    << exit(FatalIOError);
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::particleZone::particleZone
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    mesh_(mesh),
    bodies_(mesh, dict),
    inside_(chooseCells(mesh, bodies_, dict))
{
    checkCyclic(dict);
    if (!everywhere() || bodies_.size())
    {
        makeMesh();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::SPH::particleZone::fvmFace
(
    const label patchi,
    const label facei
) const
{
    const label nFvm = mesh_.boundaryMesh().size();
    if (!zoneMeshPtr_.valid() || (patchi >= nFvm && patchi != borderPatch()))
    {
        return facei;
    }

    const label fvmFacei =
        faceMap_[mesh().boundaryMesh()[patchi].start() + facei];

    return
        patchi == borderPatch()
      ? fvmFacei
      : fvmFacei - mesh_.boundaryMesh()[patchi].start();
}


// ************************************************************************* //
