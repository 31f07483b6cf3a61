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

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::SPH::convergenceMonitor::left() const
{
    // The rms falls like a power of the iteration, with jumps: its least value
    // tells when it gets to the tolerance. The largest residual does not
    const label n = history_.size();
    scalar before = GREAT;
    scalar least = GREAT;
    for (label i = 0; i < n; ++i)
    {
        least = min(least, history_[i].rmsResidual);
        before = i < n/2 ? least : before;
    }

    if (history_.last().rmsResidual < rmsTolerance_)
    {
        return 0;
    }
    if (rmsTolerance_ <= 0 || least <= rmsTolerance_ || least >= before)
    {
        return -1;
    }

    // How many times the iterations so far must double; ten are too many
    const scalar doublings = min
    (
        Foam::log(least/rmsTolerance_)/Foam::log(before/least),
        scalar(10)
    );
    return round(n*(pow(2, doublings) - 1));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::convergenceMonitor::add(const record& state)
{
    // Not of a lattice that is at rest but for round-off
    if (firstEnergy_ == 0 && state.maxResidual > 1e-10)
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
    if (history_.empty())
    {
        return false;
    }
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

    const label most = lastIteration - last.iteration;
    const label expected = left();
    const bool bounded = expected < 0 || expected >= most;
    const label nLeft = bounded ? most : expected;
    const scalar seconds = clock_.timeIncrement()*nLeft/logInterval_;

    os  << "  left " << (bounded ? "at most" : "about") << " = " << nLeft
        << " iterations, " << round(10*seconds)/10 << " s" << endl;
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
