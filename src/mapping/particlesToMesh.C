/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particlesToMesh.H"
#include "cellSpacing.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::SPH::movingLeastSquares::cloud
Foam::SPH::particlesToMesh::sources() const
{
    return {particles_.C(), particles_.spacing()};
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::particlesToMesh::particlesToMesh(const sphMesh& particles)
:
    particles_(particles),
    cells_
    (
        particles.space(),
        sources(),
        {
            particles.mesh().cellCentres(),
            cellSpacing(particles.space(), particles.mesh())
        }
    ),
    patches_(particles.mesh().boundary().size())
{}


// ************************************************************************* //
