/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "relaxationMethod.H"
#include "latticePattern.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    defineTypeNameAndDebug(relaxationMethod, 0);
    defineRunTimeSelectionTable(relaxationMethod, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::relaxationMethod::relaxationMethod
(
    const dictionary& dict,
    const relaxationDomain& domain,
    const scalar defaultMomentum
)
:
    tolerance_(dict.getOrDefault<scalar>("tolerance", 1e-3)),
    rmsTolerance_
    (
        dict.getOrDefault<scalar>
        (
            "rmsTolerance",
            dict.found("tolerance") ? 0 : domain.nDims() == 3 ? 2e-2 : 2e-3
        )
    ),
    disturbance_
    (
        dict.getOrDefault<scalar>("disturbance", max(0.02, tolerance_))
    ),
    momentum_(dict.getOrDefault<scalar>("momentum", defaultMomentum)),
    maxIterations_(dict.getOrDefault<label>("maxIterations", 2000)),
    logInterval_(dict.getOrDefault<label>("logInterval", 100)),
    skin_(dict.getOrDefault<scalar>("skin", 0.3)),
    freeze_(dict.getOrDefault<bool>("freeze", true)),
    repair_(dict.getOrDefault<bool>("repair", true)),
    domain_(domain),
    stableStep_(domain.bodies.size())
{
    const auto check = [&](const char* entry, const scalar value, const bool ok)
    {
        if (!ok)
        {
            FatalIOErrorInFunction(dict)
                << "Entry " << entry << " is " << value
                << ", but must be positive" << exit(FatalIOError);
        }
    };
    check("tolerance", tolerance_, tolerance_ > 0);
    check("rmsTolerance", rmsTolerance_, rmsTolerance_ >= 0);
    check("disturbance", disturbance_, disturbance_ > 0);
    check("maxIterations", maxIterations_, maxIterations_ >= 0);
    check("logInterval", logInterval_, logInterval_ > 0);
    check("skin", skin_, skin_ > 0);

    if (momentum_ < 0 || momentum_ > 0.99)
    {
        FatalIOErrorInFunction(dict)
            << "Entry momentum is " << momentum_
            << ", which is outside the range 0 to 0.99" << exit(FatalIOError);
    }

    const latticePattern square(latticePattern::SQUARE, domain.nDims());
    forAll(stableStep_, bodyi)
    {
        stableStep_[bodyi] =
            1/square.stiffness(domain.W, domain.bodies[bodyi].smoothingRatio);
    }
}


Foam::word Foam::SPH::relaxationMethod::typeOf(const dictionary& dict)
{
    const word methodType(dict.getOrDefault<word>("type", "complex"));

    if (!dictionaryConstructorTablePtr_->found(methodType))
    {
        FatalIOErrorInLookup
        (
            dict,
            "relaxation type",
            methodType,
            *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }

    return methodType;
}


Foam::autoPtr<Foam::SPH::relaxationMethod> Foam::SPH::relaxationMethod::New
(
    const dictionary& dict,
    const relaxationDomain& domain
)
{
    auto cstrIter = dictionaryConstructorTablePtr_->cfind(typeOf(dict));

    return autoPtr<relaxationMethod>(cstrIter()(dict, domain));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::SPH::relaxationMethod::sees
(
    const label bodyi,
    const label role
) const
{
    return role == bodyi || role == bodyi + domain_.bodies.size();
}


Foam::scalar Foam::SPH::relaxationMethod::band(const label bodyi) const
{
    return
        0.1
      + max(boundingDistance(bodyi, false), boundingDistance(bodyi, true));
}


Foam::scalar Foam::SPH::relaxationMethod::displacements
(
    const label bodyi,
    const particleSystem& particles,
    const verletList& list,
    const labelUList& targets,
    const vectorField& sums,
    vectorField& steps
)
{
    scalar largest = VSMALL;

    #pragma omp parallel for reduction(max: largest) if (targets.size() > 2048)
    for (label t = 0; t < targets.size(); ++t)
    {
        largest = max(largest, mag(sums[t])*particles.spacing[targets[t]]);
    }

    const scalar step = min
    (
        stableStep_[bodyi],
        stepLength()*domain_.bodies[bodyi].smoothingRatio/largest
    );

    steps.setSize(targets.size());

    #pragma omp parallel for if (targets.size() > 2048)
    for (label t = 0; t < targets.size(); ++t)
    {
        steps[t] = -step*sqr(particles.spacing[targets[t]])*sums[t];
    }

    return step;
}


// ************************************************************************* //
