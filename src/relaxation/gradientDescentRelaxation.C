/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "gradientDescentRelaxation.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    defineTypeNameAndDebug(gradientDescentRelaxation, 0);
    addToRunTimeSelectionTable
    (
        relaxationMethod,
        gradientDescentRelaxation,
        dictionary
    );
}
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::gradientDescentRelaxation::addBoundaryTerm
(
    const label bodyi,
    const particleSystem& particles,
    const labelUList& targets,
    vectorField& sums
) const
{
    const scalar ratio = domain_.bodies[bodyi].smoothingRatio;

    #pragma omp parallel for schedule(dynamic, 256) if (targets.size() > 1024)
    for (label t = 0; t < targets.size(); ++t)
    {
        const label i = targets[t];
        const scalar dp = particles.spacing[i];

        if (-particles.phi[i] - particles.drift[i] < band(bodyi)*dp)
        {
            const signedDistance::nearest n
            (
                domain_.find(bodyi, particles.position(i))
            );
            sums[t] +=
                domain_.W.lineW(max(-n.distance, scalar(0)), ratio*dp)
               *n.normal;
        }
    }
}


// ************************************************************************* //
