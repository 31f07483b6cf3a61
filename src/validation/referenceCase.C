/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "referenceCase.H"
#include "cellSpacing.H"
#include "particleCase.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::referenceCase::referenceCase(const fvMesh& mesh)
:
    mesh_(mesh),
    otherTime_(),
    otherMesh_(),
    mapping_()
{}


Foam::SPH::referenceCase::referenceCase
(
    const fvMesh& mesh,
    const fileName& path
)
:
    mesh_(mesh),
    otherTime_(),
    otherMesh_(),
    mapping_()
{
    if (!isFile(path/"system"/"controlDict"))
    {
        FatalErrorInFunction
            << "The reference " << path << " is not a case: it has no"
            << " system/controlDict" << exit(FatalError);
    }

    otherTime_ = particleCase::caseTime(path);
    otherMesh_.reset
    (
        new fvMesh
        (
            IOobject
            (
                polyMesh::defaultRegion,
                otherTime_->timeName(),
                *otherTime_,
                IOobject::MUST_READ
            )
        )
    );

    const solutionSpace space(mesh);
    const solutionSpace otherSpace(*otherMesh_);

    if (space.nDims() != otherSpace.nDims())
    {
        FatalErrorInFunction
            << "The reference " << path << " has " << otherSpace.nDims()
            << " dimensions, the case " << space.nDims() << exit(FatalError);
    }

    mapping_.reset
    (
        new movingLeastSquares
        (
            space,
            {otherMesh_->cellCentres(), cellSpacing(otherSpace, *otherMesh_)},
            {mesh.cellCentres(), cellSpacing(space, mesh)}
        )
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::IOobjectList Foam::SPH::referenceCase::objects
(
    const instant& time
) const
{
    const word name(timeName(time));

    return
        name.empty()
      ? IOobjectList()
      : IOobjectList(sourceMesh(), name);
}

// ************************************************************************* //
