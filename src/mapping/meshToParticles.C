/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "meshToParticles.H"
#include "cellSpacing.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::meshToParticles::meshToParticles
(
    const fvMesh& mesh,
    const pointField& points,
    const scalarField& spacing
)
:
    weights_
    (
        solutionSpace(mesh),
        {mesh.cellCentres(), cellSpacing(solutionSpace(mesh), mesh)},
        {points, spacing}
    )
{}


// ************************************************************************* //
