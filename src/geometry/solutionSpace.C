/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "solutionSpace.H"
#include "Time.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::solutionSpace::solutionSpace(const polyMesh& mesh)
:
    nDims_(0),
    axes_({0, 1, 2}),
    thickness_(1),
    midPlane_(Zero)
{
    const fileName file(mesh.boundaryMesh().objectPath());

    if (returnReduce(mesh.nCells(), sumOp<label>()) == 0)
    {
        FatalErrorInFunction
            << "The mesh in " << file.path()
            << " has no cells" << exit(FatalError);
    }

    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<wedgePolyPatch>(pp))
        {
            FatalErrorInFunction
                << "Patch " << pp.name() << " in "
                << file << " has type wedge, which is not"
                << " supported. Valid choices: a 2-D case with empty patches"
                << " or a 3-D case" << exit(FatalError);
        }
    }

    const Vector<label>& solved = mesh.geometricD();
    const vector span(mesh.bounds().span());
    const point mid(mesh.bounds().midpoint());

    label nUnsolved = 0;
    for (direction d = 0; d < 3; ++d)
    {
        if (solved[d] == 1)
        {
            axes_[nDims_++] = d;
        }
        else
        {
            axes_[2 - nUnsolved++] = d;
            thickness_ *= span[d];
            midPlane_[d] = mid[d];
        }
    }

    if (nDims_ == 0)
    {
        FatalErrorInFunction
            << "All directions of the mesh in " << file
            << " are empty" << exit(FatalError);
    }
}


Foam::SPH::solutionSpace::solutionSpace
(
    const label nDims,
    const FixedList<direction, 3>& axes,
    const scalar thickness,
    const vector& midPlane
)
:
    nDims_(nDims),
    axes_(axes),
    thickness_(thickness),
    midPlane_(midPlane)
{}


// ************************************************************************* //
