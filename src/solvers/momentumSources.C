/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "momentumSources.H"
#include "stressModels.H"
#include "fvMatrices.H"
#include "fvOptions.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    static const word velocityName("U");

    //- Call f for the dictionary of each active option of a case
    template<class Function>
    static void forOptions(const Time& runTime, const Function& f)
    {
        for (const word& folder : {runTime.constant(), runTime.system()})
        {
            const IOdictionary dict
            (
                readDictIfPresent(runTime, "fvOptions", folder)
            );
            for (const entry& e : dict)
            {
                if
                (
                    e.isDict()
                 && e.dict().getOrDefault<Switch>("active", true)
                )
                {
                    f(e.dict());
                }
            }
        }
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::momentumSources::getVelocity()
{
    const particleMesh& particles = law_.particles();
    for (label d = 0; d < loopDims(particles); ++d)
    {
        U_.primitiveFieldRef().replace
        (
            particles.space().axis(d), law_.primitive(1 + d)
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::momentumSources::momentumSources
(
    const volVectorField& U,
    const bool kinematic,
    conservationLaw& law
)
:
    law_(law),
    options_(fv::options::New(U.mesh())),
    U_
    (
        IOobject
        (
            velocityName,
            U.instance(),
            U.mesh(),
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        U
    ),
    rho_
    (
        IOobject
        (
            "rho",
            U.instance(),
            U.mesh(),
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        U.mesh(),
        dimensionedScalar("rho", kinematic ? dimless : dimDensity, 1)
    ),
    kinematic_(kinematic)
{
    for (fv::option& source : options_)
    {
        if (source.active() && source.applyToField(velocityName) == -1)
        {
            FatalIOErrorInFunction(source.coeffs())
                << "Entry " << source.name() << ": " << source.type()
                << " is applied to no field of this solver. Valid choices:"
                << nl << wordList({velocityName}) << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

bool Foam::SPH::momentumSources::present(const Time& runTime)
{
    bool found = false;
    forOptions(runTime, [&](const dictionary&) { found = true; });
    return found;
}


void Foam::SPH::momentumSources::refuseOthers(const Time& runTime)
{
    static const wordList valid
    ({
        "meanVelocityForce", "vectorSemiImplicitSource"
    });

    forOptions
    (
        runTime,
        [&](const dictionary& dict)
        {
            const word type(dict.get<word>("type"));
            if (!valid.found(type))
            {
                FatalIOErrorInFunction(dict)
                    << "Entry " << dict.dictName() << " of fvOptions: type "
                    << type << " is not supported by this solver. OpenFOAM's"
                    << " own solvers run on the particles: start them with"
                    << " -case sph, or set the entry's 'active' to no" << nl
                    << nl << "Valid choices:" << nl << valid
                    << exit(FatalIOError);
            }

            // The fields of meanVelocityForce are a list, those of a
            // semi-implicit source are the entries of its rates
            const dictionary& coeffs = dict.optionalSubDict(type + "Coeffs");
            wordList fields;
            coeffs.readIfPresent("fields", fields);
            if (coeffs.found("injectionRateSuSp"))
            {
                fields.append(coeffs.subDict("injectionRateSuSp").toc());
            }
            for (const word& field : fields)
            {
                if (field != velocityName)
                {
                    FatalIOErrorInFunction(coeffs)
                        << "Entry " << dict.dictName() << " of fvOptions is"
                        << " applied to the field " << field << nl << nl
                        << "Valid choices:" << nl
                        << wordList({velocityName}) << exit(FatalIOError);
                }
            }
        }
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::momentumSources::set(const scalar dt)
{
    getVelocity();
    if (!kinematic_)
    {
        rho_.primitiveFieldRef() = law_.conserved(0);
    }

    const fvVectorMatrix source
    (
        kinematic_ ? options_(U_) : options_(rho_, U_)
    );
    const scalarField& V = U_.mesh().V();
    vectorField force(-source.source()/V);
    if (source.hasDiag())
    {
        force += source.diag()/V*U_.primitiveField();
    }
    law_.setForce(force);

    fvVectorMatrix step
    (
        U_, rho_.dimensions()*U_.dimensions()*dimVolume/dimTime
    );
    step.diag() = rho_.primitiveField()*V/dt;
    options_.constrain(step);
}


void Foam::SPH::momentumSources::correct()
{
    // A restart needs every bit of what is written
    const unsigned precision = IOstream::defaultPrecision(17);

    getVelocity();
    const vectorField before(U_.primitiveField());
    options_.correct(U_);
    if (gMax(mag(U_.primitiveField() - before)()) > 0)
    {
        law_.setVelocity(U_.primitiveField());
    }

    IOstream::defaultPrecision(precision);
}


// ************************************************************************* //
