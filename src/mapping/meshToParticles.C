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

Foam::SPH::meshToParticles::meshToParticles(const sphMesh& particles)
:
    weights_
    (
        particles.space(),
        {
            particles.mesh().cellCentres(),
            cellSpacing(particles.space(), particles.mesh())
        },
        {particles.C(), particles.spacing()}
    )
{}


// ************************************************************************* //
