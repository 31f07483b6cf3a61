/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "patchSurface.H"
#include "periodicPatches.H"
#include "Time.H"
#include "emptyPolyPatch.H"
#include "processorPolyPatch.H"
#include "HashSet.H"
#include "SubField.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
namespace
{

//- Path of the mesh for messages
fileName meshPath(const polyMesh& mesh)
{
    return mesh.boundaryMesh().path();
}


void checkPatchTypes(const polyMesh& mesh)
{
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<processorPolyPatch>(pp))
        {
            FatalErrorInFunction
                << "Patch " << pp.name() << " in " << meshPath(mesh)
                << " is a processor patch: particles are generated from the"
                << " mesh before it is decomposed. Take the whole mesh, and"
                << " decompose the particles with 'decomposePar -case sph'"
                << exit(FatalError);
        }

        checkCoupling(pp);
    }
}


//- FatalError if boundary faces lie back to back: walls of no thickness
void checkBaffles(const polyMesh& mesh)
{
    labelList faces;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (!pp.coupled() && !isA<emptyPolyPatch>(pp))
        {
            faces.append(identity(pp.size(), pp.start()));
        }
    }

    // Faces in one place are neighbours along any direction; this one is that
    // of no grid line
    const vector direction(0.5434, 0.6180, 0.5681);
    const scalarField along
    (
        pointField(mesh.faceCentres(), faces) & direction
    );
    const labelList order(sortedOrder(along));

    forAll(order, i)
    {
        const label facei = faces[order[i]];
        const vector& Sf = mesh.faceAreas()[facei];
        const scalar tolerance = 1e-4*sqrt(mag(Sf));

        for
        (
            label j = i + 1;
            j < order.size() && along[order[j]] - along[order[i]] < tolerance;
            ++j
        )
        {
            const label other = faces[order[j]];
            if
            (
                mag(mesh.faceCentres()[other] - mesh.faceCentres()[facei])
              < tolerance
             && mag(mesh.faceAreas()[other] + Sf) < 1e-3*mag(Sf)
            )
            {
                const polyBoundaryMesh& patches = mesh.boundaryMesh();
                FatalErrorInFunction
                    << "The patches "
                    << patches[patches.whichPatch(facei)].name() << " and "
                    << patches[patches.whichPatch(other)].name()
                    << " in " << meshPath(mesh) << " lie back to back at "
                    << mesh.faceCentres()[facei]
                    << ": walls of no thickness are not supported."
                    << " With the entry zone of sphMeshDict FVM cells can stay"
                    << " there" << exit(FatalError);
            }
        }
    }
}


//- Of the pairs of cyclic patches. Several may repeat the region in the same
//- direction
List<vector> periodsOf(const polyMesh& mesh, const solutionSpace& space)
{
    DynamicList<vector> periods;
    for (const vector& T : periodicTranslations(mesh))
    {
        const vector period(space.toGlobal(space.toLocal(T)));

        bool known = false;
        for (const vector& other : periods)
        {
            known = known || mag(period ^ other) < 1e-6*magSqr(period);
        }
        if (!known)
        {
            periods.append(period);
        }
    }

    return List<vector>(std::move(periods));
}

} // End anonymous namespace
} // End namespace SPH
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::SPH::orientedSurface Foam::SPH::patchSurface::allElements
(
    const polyMesh& mesh,
    const solutionSpace& space
)
{
    checkPatchTypes(mesh);
    checkBaffles(mesh);

    orientedSurface surface
    (
        space.nDims() == 1 ? pointElements(mesh, space)
      : space.nDims() == 2 ? segmentElements(mesh, space)
      : triangleElements(mesh, space)
    );

    List<element> elements(surface.elements());
    for (element& e : elements)
    {
        e.coupled = mesh.boundaryMesh()[e.patchi].coupled();
    }

    return orientedSurface
    (
        space,
        pointField(surface.points()),
        std::move(elements),
        periodsOf(mesh, space)
    );
}


void Foam::SPH::patchSurface::checkClosed() const
{
    wordHashSet open;
    for (const label elementi : openElements())
    {
        open.insert(mesh_.boundaryMesh()[elements()[elementi].patchi].name());
    }

    if (open.size())
    {
        FatalErrorInFunction
            << "The boundary of the mesh in " << meshPath(mesh_)
            << " is not a closed surface: edges of the patches "
            << open.sortedToc() << " have no neighbour. Run checkMesh"
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::patchSurface::patchSurface
(
    const polyMesh& mesh,
    const solutionSpace& space
)
:
    orientedSurface(allElements(mesh, space)),
    mesh_(mesh)
{
    checkClosed();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::SPH::patchSurface::patchElements
(
    const labelUList& patches
) const
{
    const labelHashSet wanted(patches);

    DynamicList<label> found(size());
    forAll(elements(), elementi)
    {
        if (wanted.found(elements()[elementi].patchi))
        {
            found.append(elementi);
        }
    }

    return labelList(std::move(found));
}


// ************************************************************************* //
