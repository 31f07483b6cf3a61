/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "convergenceMonitor.H"
#include "OFstream.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::convergenceMonitor::add(const record& state)
{
    if (firstEnergy_ == 0)
    {
        firstEnergy_ = state.kineticEnergy;
    }

    record normalised(state);
    normalised.kineticEnergy =
        firstEnergy_ > 0 ? state.kineticEnergy/firstEnergy_ : 0;
    history_.append(normalised);
}


bool Foam::SPH::convergenceMonitor::converged() const
{
    const record& last = history_.last();

    return
        last.rmsResidual < rmsTolerance_
     || (
            last.relativeResidual <= 1
         && (last.kineticEnergy <= tolerance_ || last.relativeResidual <= 0.1)
        );
}


void Foam::SPH::convergenceMonitor::log
(
    Ostream& os,
    const label nActive,
    const label lastIteration
) const
{
    const record& last = history_.last();

    os  << "Iteration = " << last.iteration
        << "  residual = " << last.maxResidual
        << "  rms = " << last.rmsResidual
        << "  kinetic energy = " << last.kineticEnergy
        << "  moving particles = " << nActive;

    // When the residual, a maximum, falls below the tolerance cannot be told
    // from how it fell so far
    const label nLeft = lastIteration - last.iteration;
    const scalar seconds = clock_.timeIncrement()*nLeft/logInterval_;

    os  << "  left at most = " << nLeft << " iterations, "
        << round(10*seconds)/10 << " s" << endl;
}


void Foam::SPH::convergenceMonitor::write(const fileName& file) const
{
    mkDir(file.path());
    OFstream os(file);

    os  << "iteration,normalisedKineticEnergy,maxResidual,totalError" << nl;
    for (const record& r : history_)
    {
        os  << r.iteration << ',' << r.kineticEnergy << ',' << r.maxResidual
            << ',';
        if (r.totalError >= 0)
        {
            os  << r.totalError;
        }
        os  << nl;
    }
}


// ************************************************************************* //
