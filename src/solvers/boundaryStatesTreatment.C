/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "boundaryStates.H"
#include "basicSymmetryFvPatchFields.H"
#include "fixedFluxPressureFvPatchScalarField.H"
#include "fixedGradientFvPatchFields.H"
#include "fixedNormalSlipFvPatchFields.H"
#include "fixedValueFvPatchFields.H"
#include "inletOutletFvPatchFields.H"
#include "noSlipFvPatchVectorField.H"
#include "slipFvPatchFields.H"
#include "totalPressureFvPatchScalarField.H"
#include "uniformTotalPressureFvPatchScalarField.H"
#include "wallFvPatch.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- FatalError for coupled patches whose conditions are more than that of
    //- the patch: pairs across them know none, such as the jump of a fan
    template<class Type>
    static void refuseJumps
    (
        const GeometricField<Type, fvPatchField, volMesh>& field
    )
    {
        static const wordList plain({"cyclic", "processor", "processorCyclic"});

        for (const fvPatchField<Type>& patchField : field.boundaryField())
        {
            if (patchField.coupled() && !plain.found(patchField.type()))
            {
                FatalErrorInFunction
                    << "Patch " << patchField.patch().name() << " of field "
                    << field.name() << " in " << field.objectPath()
                    << " has the type " << patchField.type() << ", which this"
                    << " solver does not support on cyclic patches. OpenFOAM's"
                    << " own solvers run on the particles: start them with"
                    << " -case sph" << nl << nl << "Valid choices:" << nl
                    << wordList({"cyclic"}) << exit(FatalError);
            }
        }
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
bool Foam::SPH::boundaryStates::isGiven(const fvPatchField<Type>& patchField)
{
    return
        patchField.type() == fixedValueFvPatchField<Type>::typeName
     || patchField.type() == "quadraticFixedValue"
     || patchField.type() == noSlipFvPatchVectorField::typeName;
}


template<class Type>
bool Foam::SPH::boundaryStates::isOwn(const fvPatchField<Type>& patchField)
{
    return
        patchField.type() == zeroGradientFvPatchField<Type>::typeName
     || patchField.type() == fixedFluxPressureFvPatchScalarField::typeName
     || isA<basicSymmetryFvPatchField<Type>>(patchField);
}


template bool Foam::SPH::boundaryStates::isGiven
(
    const fvPatchScalarField&
);
template bool Foam::SPH::boundaryStates::isGiven
(
    const fvPatchVectorField&
);
template bool Foam::SPH::boundaryStates::isOwn(const fvPatchScalarField&);
template bool Foam::SPH::boundaryStates::isOwn(const fvPatchVectorField&);


bool Foam::SPH::boundaryStates::crosses(const fvPatchVectorField& Up)
{
    if (isGiven(Up))
    {
        return gMax(mag(Up & Up.patch().nf())()) > 1e-6*gMax(mag(Up)());
    }

    // What turns or moves a wall crosses its facets, to and fro
    constexpr scalar facets = 0.01;
    return
        !Up.type().ends_with("WallVelocity")
     && mag(gSum((Up & Up.patch().Sf())()))
      > facets*gSum((mag(Up)*Up.patch().magSf())());
}


bool Foam::SPH::boundaryStates::isWall(const fvPatchVectorField& Up)
{
    // A wall patch that the flow may cross is no wall: FVM takes its flux from
    // the velocity there
    return
        isA<noSlipFvPatchVectorField>(Up)
     || (
            isA<wallFvPatch>(Up.patch())
         && !isA<zeroGradientFvPatchVectorField>(Up)
         && !isA<fixedGradientFvPatchVectorField>(Up)
         && !isA<inletOutletFvPatchVectorField>(Up)
         && !Up.type().starts_with("pressure")
         && !crosses(Up)
        );
}


void Foam::SPH::boundaryStates::checkWall(const label patchi) const
{
    const fvPatchVectorField& Up = U_.boundaryField()[patchi];
    if
    (
        reflects(patchTreatment_[patchi])
     && isA<fixedValueFvPatchVectorField>(Up)
     && crosses(Up)
    )
    {
        FatalErrorInFunction
            << "Patch " << Up.patch().name() << " is a wall, but from time "
            << U_.time().value() << " s on " << U_.name() << ", of type "
            << Up.type() << ", points through it. Make it a patch of type patch"
            << " in constant/polyMesh/boundary of the FVM case, and run"
            << " sphMesh" << exit(FatalError);
    }
}


bool Foam::SPH::boundaryStates::givesFlux(const label patchi) const
{
    bool gives = isA<fixedValueFvPatchVectorField>(U_.boundaryField()[patchi]);

    for (const scalarVariable& s : scalars_)
    {
        // Total pressure follows from the flow inside
        const fvPatchScalarField& sp = s.field.boundaryField()[patchi];
        gives =
            gives
         && (isOwn(sp) || isA<fixedValueFvPatchScalarField>(sp))
         && !isA<totalPressureFvPatchScalarField>(sp)
         && !isA<uniformTotalPressureFvPatchScalarField>(sp);
    }

    return gives;
}


Foam::SPH::faceStates::treatment
Foam::SPH::boundaryStates::choose
(
    const label patchi,
    const bool viscous
) const
{
    const fvPatchVectorField& Up = U_.boundaryField()[patchi];

    if
    (
        isA<basicSymmetryFvPatchField<vector>>(Up)
     || isA<fixedNormalSlipFvPatchField<vector>>(Up)
    )
    {
        return slip;
    }

    if (isWall(Up))
    {
        return viscous ? noSlip : slip;
    }

    return givesFlux(patchi) ? given : open;
}


void Foam::SPH::boundaryStates::classify(const bool viscous)
{
    refuseJumps(U_);
    for (const scalarVariable& s : scalars_)
    {
        refuseJumps(s.field);
    }

    DynamicList<label> evaluated;

    patchTreatment_.setSize(particles_.boundary().size(), open);
    patchSize_.setSize(particles_.boundary().size(), Zero);

    for (const particlePatch& patch : particles_.boundary())
    {
        // Those between ranks differ from rank to rank
        if (patch.patch().coupled())
        {
            continue;
        }

        const label patchi = patch.index();
        const fvPatchVectorField& Up = U_.boundaryField()[patchi];
        const treatment type = choose(patchi, viscous);
        const bool reflecting = reflects(type);

        patchTreatment_[patchi] = type;
        patchSize_[patchi] = returnReduce(patch.size(), sumOp<label>());

        if (!reflecting && patch.size() && contact(patch.start()))
        {
            FatalErrorInFunction
                << "Patch " << patch.name() << " has solid particles behind"
                << " it, which boundaryTreatment contact makes a wall of, but "
                << U_.name() << " has a boundary condition of type "
                << Up.type() << " there: it needs that of a wall"
                << exit(FatalError);
        }

        // Symmetry gives the gradient along the normal
        const bool mirrored =
            isA<basicSymmetryFvPatchField<vector>>(Up)
         && !isA<slipFvPatchField<vector>>(Up)
         && !(patch.size() && contact(patch.start()));

        bool evaluate =
            (type != slip || isA<fixedValueFvPatchVectorField>(Up))
         && mayChange(Up);

        for (const scalarVariable& s : scalars_)
        {
            const fvPatchScalarField& sp = s.field.boundaryField()[patchi];
            const bool own = isOwn(sp);
            const bool fixed =
                mirrored || (sp.fixesValue() && (!reflecting || viscous));

            SubList<bool>(own_[s.variable], patch.size(), patch.start()) = own;
            SubList<bool>(fixed_[s.variable], patch.size(), patch.start()) =
                fixed;

            evaluate = evaluate || (!own && !isGiven(sp));
        }

        const bool UFixed =
            mirrored
         || (type != slip && (Up.fixesValue() || type == noSlip));

        for (label d = 0; d < loopDims(particles_); ++d)
        {
            SubList<bool>(own_[1 + d], patch.size(), patch.start()) =
                !reflecting && isOwn(Up);
            SubList<bool>(fixed_[1 + d], patch.size(), patch.start()) = UFixed;
        }

        SubList<treatment>(treatment_, patch.size(), patch.start()) = type;

        if (evaluate && patchSize_[patchi])
        {
            evaluated.append(patchi);
        }
    }

    evaluatedPatches_.transfer(evaluated);
}


// ************************************************************************* //
