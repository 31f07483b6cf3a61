/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "timeScheme.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    defineTypeNameAndDebug(timeScheme, 0);
    defineRunTimeSelectionTable(timeScheme, empty);
}
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::SPH::timeScheme::evaluate
(
    conservationLaw& law,
    faceStates& faces,
    const scalar timeLeft,
    const scalar ahead
)
{
    faces.correct(law.W(), timeLeft);
    law.evaluate(ahead);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::SPH::timeScheme> Foam::SPH::timeScheme::New
(
    const dictionary& schemes
)
{
    const word scheme(schemes.getOrDefault<word>("timeScheme", "automatic"));

    const auto cstrIter = emptyConstructorTablePtr_->cfind(scheme);

    if (!cstrIter.found())
    {
        FatalIOErrorInFunction(schemes)
            << "Unknown timeScheme " << scheme << nl << nl
            << "Valid time schemes:" << nl
            << emptyConstructorTablePtr_->sortedToc()
            << exit(FatalIOError);
    }

    return cstrIter()();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::SPH::timeScheme::stableDeltaT
(
    conservationLaw& law,
    const scalar maxCo
)
{
    return 1/law.stableRate(maxCo, maxDiffusion());
}


bool Foam::SPH::timeScheme::advance
(
    conservationLaw& law,
    faceStates& faces,
    const scalar dt,
    const scalar timeLeft
) const
{
    law.store();

    stages(law, faces, dt, timeLeft);

    law.reduceState();
    const bool physical = law.physical();
    if (!physical)
    {
        law.restore();
    }

    return physical;
}


// ************************************************************************* //
