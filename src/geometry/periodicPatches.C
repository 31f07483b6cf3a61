/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "periodicPatches.H"
#include "cyclicAMIPolyPatch.H"
#include "cyclicPolyPatch.H"
#include "StringStream.H"
#include "SubField.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    const word cornerGroup("cornerPairs");

    //- From the owner side to the neighbour side [m]
    static vector translation(const cyclicPolyPatch& pp)
    {
        const vectorField jump
        (
            pp.neighbPatch().faceCentres() - pp.faceCentres()
        );
        const vector T(average(jump));

        const polyMesh& mesh = pp.boundaryMesh().mesh();
        if (pp.size() && max(mag(jump)) < 1e-6*mesh.bounds().mag())
        {
            FatalErrorInFunction
                << "The cyclic patches " << pp.name() << " and "
                << pp.neighbPatchName() << " of "
                << mesh.boundaryMesh().objectPath()
                << " lie on one another, as those of fans and baffles do,"
                << " which is not supported. With the entry zone of"
                << " sphMeshDict FVM cells can stay there" << exit(FatalError);
        }

        if (max(mag(jump - T)) > 1e-6*mag(T))
        {
            FatalErrorInFunction
                << "The cyclic patches " << pp.name() << " and "
                << pp.neighbPatchName() << " of "
                << mesh.boundaryMesh().objectPath()
                << " are not a translation of one another. Valid cyclic"
                << " transforms: translational" << exit(FatalError);
        }

        return T;
    }
}
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::SPH::checkCoupling(const polyPatch& pp)
{
    // Arbitrary couplings are not coupled in this sense; overset patches are
    // generic without their library
    OStringStream os;
    pp.write(os);
    const dictionary dict(IStringStream(os.str())());
    const word type(dict.get<word>("type"));

    if
    (
        (pp.coupled() && !isA<cyclicPolyPatch>(pp))
     || isA<cyclicAMIPolyPatch>(pp)
     || type == "overset"
    )
    {
        FatalErrorInFunction
            << "Patch " << pp.name() << " of "
            << pp.boundaryMesh().objectPath()
            << " has type " << type << ", which is not supported."
            << " Valid coupled patch types: cyclic" << exit(FatalError);
    }
}


Foam::labelList Foam::SPH::periodicPatches(const polyMesh& mesh)
{
    DynamicList<label> patches;
    DynamicList<vector> translations;

    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (!pp.coupled() || pp.empty() || pp.inGroups().found(cornerGroup))
        {
            continue;
        }

        checkCoupling(pp);

        const auto& cyclic = refCast<const cyclicPolyPatch>(pp);
        if (cyclic.owner())
        {
            const vector T(translation(cyclic));

            // Two pairs of patches may have the same period
            bool known = false;
            for (const vector& other : translations)
            {
                known = known || mag(T - other) < 1e-6*mag(T);
            }
            if (!known)
            {
                patches.append(pp.index());
                translations.append(T);
            }
        }
    }

    return labelList(std::move(patches));
}


Foam::List<Foam::vector> Foam::SPH::periodicTranslations(const polyMesh& mesh)
{
    DynamicList<vector> translations;
    for (const label patchi : periodicPatches(mesh))
    {
        translations.append
        (
            translation
            (
                refCast<const cyclicPolyPatch>(mesh.boundaryMesh()[patchi])
            )
        );
    }

    return List<vector>(std::move(translations));
}


// ************************************************************************* //
