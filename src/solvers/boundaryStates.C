/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "boundaryStates.H"
#include "advectiveFvPatchField.H"
#include "basicSymmetryFvPatchFields.H"
#include "fixedFluxPressureFvPatchScalarField.H"
#include "freestreamFvPatchField.H"
#include "freestreamVelocityFvPatchVectorField.H"
#include "mixedFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Conditions that a pressure equation sets get a gradient of zero: without
    //- body forces a wall or an inlet has no other
    static void holdGradient(fvPatchScalarField& pp)
    {
        if (isA<fixedFluxPressureFvPatchScalarField>(pp))
        {
            refCast<fixedFluxPressureFvPatchScalarField>(pp).updateSnGrad
            (
                scalarField(pp.size(), Zero)
            );
        }
    }

    //- Conditions of a free stream divide by the velocity to see which way it
    //- points: fluid at rest leaves as the stream would
    static void keepDirection(fvPatchVectorField& Up)
    {
        const auto* stream = isA<freestreamVelocityFvPatchVectorField>(Up);
        forAll(Up, facei)
        {
            if (stream && magSqr(Up[facei]) < VSMALL)
            {
                Up[facei] = SMALL*stream->freestreamValue()[facei];
            }
        }
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::boundaryStates::setCells(const slicedField& W)
{
    vectorField& U = U_.primitiveFieldRef();
    for (label d = 0; d < loopDims(particles_); ++d)
    {
        const scalar* values = W[1 + d];
        const direction axis = particles_.space().axis(d);
        for (const label i : cells_)
        {
            U[i][axis] = values[i];
        }
    }

    for (const scalarVariable& s : scalars_)
    {
        const scalar* values = W[s.variable];
        scalarField& field = s.field.primitiveFieldRef();
        for (const label i : cells_)
        {
            field[i] = values[i];
        }
    }
}


template<class Type>
void Foam::SPH::boundaryStates::copyPatch
(
    const label patchi,
    const Field<Type>& patchField,
    const label variable,
    const direction cmpt
)
{
    const particlePatch& patch = particles_.boundary()[patchi];
    const labelUList from(patch.face());
    const labelUList owner(patch.owner());

    SubList<scalar> values(value_[variable], patch.size(), patch.start());
    forAll(values, k)
    {
        if (corrects(owner[k]))
        {
            values[k] = component(patchField[from[k]], cmpt);
        }
    }
}


void Foam::SPH::boundaryStates::setGiven(const label patchi)
{
    const particlePatch& patch = particles_.boundary()[patchi];
    const labelUList face(patch.face());
    const fvPatchVectorField& Up = U_.boundaryField()[patchi];

    // Walls that give part of a value give a gradient with it
    const bool reflecting = reflects(patchTreatment_[patchi]);
    const scalar least = reflecting ? 1 - SMALL : 0.5;

    // What flows out has the velocity of the flow
    const bool velocity = reflecting || givesVelocity(Up);
    const auto* mixedU = isA<mixedFvPatchVectorField>(Up);
    for (label d = 0; d < loopDims(particles_); ++d)
    {
        forAll(face, k)
        {
            const label facei = face[k];
            given_[1 + d][patch.start() + k] =
                mixedU
              ? mixedU->valueFraction()[facei] > least
             && (reflecting || (Up[facei] & Up.patch().Sf()[facei]) <= 0)
              : velocity;
        }
    }

    for (const scalarVariable& s : scalars_)
    {
        const fvPatchScalarField& sp = s.field.boundaryField()[patchi];
        const bool fixes = sp.fixesValue();

        // The values of advective conditions follow a wave that leaves
        const auto* mixed =
            isA<advectiveFvPatchField<scalar>>(sp)
          ? nullptr
          : isA<mixedFvPatchScalarField>(sp);
        forAll(face, k)
        {
            given_[s.variable][patch.start() + k] =
                mixed ? mixed->valueFraction()[face[k]] > least : fixes;
        }
    }
}


void Foam::SPH::boundaryStates::holdStream
(
    const label patchi,
    vectorField& velocity
)
{
    // A gas may leave faster than sound
    const bool alwaysSubsonic = scalars_.size() == 1;
    const fvPatchVectorField& Up = U_.boundaryField()[patchi];
    if (!alwaysSubsonic || !isStream(Up))
    {
        return;
    }

    const vectorField& stream =
        refCast<const mixedFvPatchVectorField>(Up).refValue();
    const particlePatch& patch = particles_.boundary()[patchi];
    const labelUList face(patch.face());
    forAll(face, k)
    {
        const label facei = patch.start() + k;
        if (!given_[0][facei])
        {
            velocity[face[k]] = stream[face[k]];
            for (label d = 0; d < loopDims(particles_); ++d)
            {
                given_[1 + d][facei] = true;
            }
        }
    }
}


void Foam::SPH::boundaryStates::copyPatches(const label patchi)
{
    setGiven(patchi);

    const fvPatchVectorField& Up = U_.boundaryField()[patchi];

    // Of the velocity of a slip wall only what moves the wall counts: along an
    // edge or a curved wall, velocities along it point through the next face
    vectorField velocity(Up);
    if (isA<basicSymmetryFvPatchField<vector>>(Up))
    {
        velocity = Zero;
    }
    else if (patchTreatment_[patchi] == slip)
    {
        const vectorField n(Up.patch().nf());
        velocity = n*(n & Up);
    }
    holdStream(patchi, velocity);

    for (label d = 0; d < loopDims(particles_); ++d)
    {
        copyPatch(patchi, velocity, 1 + d, particles_.space().axis(d));
    }

    for (const scalarVariable& s : scalars_)
    {
        copyPatch(patchi, s.field.boundaryField()[patchi], s.variable, 0);
    }
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::SPH::boundaryStates::correctFlux(const label patchi)
{
    const fvPatchVectorField& Up = U_.boundaryField()[patchi];

    if (givesVelocity(Up))
    {
        phi_.boundaryFieldRef()[patchi] == (Up.patch().Sf() & Up);
    }
    else if (isA<mixedFvPatchVectorField>(Up))
    {
        // Its own value follows from phi: by that alone an outlet that has no
        // velocity yet would stay closed, and so would, by that of the
        // particles alone, a free stream around fluid at rest
        phi_.boundaryFieldRef()[patchi] ==
            0.5*(Up.patch().Sf() & (Up + Up.patchInternalField()));
    }
    else
    {
        phi_.boundaryFieldRef()[patchi] ==
            (Up.patch().Sf() & Up.patchInternalField());
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::boundaryStates::boundaryStates
(
    const particleMesh& particles,
    volVectorField& U,
    const std::vector<scalarVariable>& scalars,
    surfaceScalarField& phi,
    const bool viscous
)
:
    faceStates(particles, loopDims(particles) + label(scalars.size())),
    U_(U),
    scalars_(scalars),
    phi_(phi)
{
    classify(viscous);

    labelHashSet cells;
    for (const label patchi : evaluatedPatches_)
    {
        cells.insert(particles.mesh().boundary()[patchi].faceCells());
    }
    cells_ = cells.sortedToc();

    for (const particlePatch& patch : particles.boundary())
    {
        if (patch.size())
        {
            copyPatches(patch.index());
        }
    }
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

bool Foam::SPH::boundaryStates::givesVelocity(const fvPatchVectorField& Up)
{
    return
        Up.fixesValue()
     && !isA<mixedFvPatchVectorField>(Up)
     && !Up.type().starts_with("pressure");
}


bool Foam::SPH::boundaryStates::isStream(const fvPatchVectorField& Up)
{
    return
        isA<freestreamFvPatchField<vector>>(Up)
     || isA<freestreamVelocityFvPatchVectorField>(Up);
}


void Foam::SPH::boundaryStates::evaluateVelocity(volVectorField& U)
{
    U.correctBoundaryConditions();
    for (fvPatchVectorField& Up : U.boundaryFieldRef())
    {
        keepDirection(Up);
    }
}


void Foam::SPH::boundaryStates::evaluatePressure(volScalarField& p)
{
    for (fvPatchScalarField& pp : p.boundaryFieldRef())
    {
        holdGradient(pp);
    }
    p.correctBoundaryConditions();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::boundaryStates::correct
(
    const slicedField& W,
    const scalar timeLeft
)
{
    if (evaluatedPatches_.empty())
    {
        return;
    }

    // Boundary conditions ask the case for the time
    Time& time = const_cast<Time&>(U_.time());
    const scalar timeValue = time.value();
    if (timeLeft > 0)
    {
        time.setTime(timeValue - timeLeft, time.timeIndex());
    }

    setCells(W);

    for (const label patchi : evaluatedPatches_)
    {
        correctFlux(patchi);
    }

    for (const label patchi : evaluatedPatches_)
    {
        fvPatchVectorField& Up = U_.boundaryFieldRef()[patchi];
        Up.evaluate();
        keepDirection(Up);
        checkWall(patchi);
        for (const scalarVariable& s : scalars_)
        {
            fvPatchScalarField& sp = s.field.boundaryFieldRef()[patchi];
            holdGradient(sp);
            sp.evaluate();
        }
        copyPatches(patchi);
    }

    if (timeLeft > 0)
    {
        time.setTime(timeValue, time.timeIndex());
    }
}


void Foam::SPH::boundaryStates::info(Ostream& os) const
{
    static const char* names[] =
        {"open", "given velocity", "no-slip wall", "slip wall"};

    for (const particlePatch& patch : particles_.boundary())
    {
        const label size = patchSize_[patch.index()];
        if (size)
        {
            os  << "    " << patch.name() << ": "
                << names[patchTreatment_[patch.index()]] << ", " << size
                << (patch.size() && contact(patch.start())
                    ? " pairs with solid particles"
                    : " boundary faces")
                << (evaluatedPatches_.found(patch.index())
                    ? ", evaluated at each stage"
                    : "")
                << nl;
        }
    }
}


// ************************************************************************* //
