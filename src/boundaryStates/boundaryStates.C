/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "boundaryStates.H"
#include "basicSymmetryFvPatchFields.H"
#include "cellSpacing.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::boundaryStates::setCellWeights()
{
    const fvMesh& mesh = particles_.mesh();

    labelHashSet cells;
    for (const label patchi : evaluatedPatches_)
    {
        cells.insert(mesh.boundary()[patchi].faceCells());
    }
    cells_ = cells.sortedToc();
    cellValues_.setSize(cells_.size());

    if (cells_.size())
    {
        const pointField centres(mesh.cellCentres(), cells_);
        const scalarField spacing
        (
            cellSpacing(particles_.space(), mesh), cells_
        );

        toCells_.reset
        (
            new movingLeastSquares
            (
                particles_.space(),
                {particles_.C(), particles_.spacing()},
                {centres, spacing}
            )
        );
    }
}


void Foam::SPH::boundaryStates::setCells(const slicedField& W)
{
    const label n = particles_.nParticles();

    const auto map = [&](const label variable)
    {
        // Read only: UList has no form for constant data
        const UList<scalar> values(const_cast<scalar*>(W[variable]), n);
        toCells_->map(values, cellValues_, true);
    };

    vectorField& U = U_.primitiveFieldRef();
    for (label d = 0; d < loopDims(particles_); ++d)
    {
        map(1 + d);
        forAll(cells_, k)
        {
            U[cells_[k]][particles_.space().axis(d)] = cellValues_[k];
        }
    }

    for (const scalarVariable& s : scalars_)
    {
        map(s.variable);
        UIndirectList<scalar>(s.field.primitiveFieldRef(), cells_) =
            cellValues_;
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
    const sphPatch& patch = particles_.boundary()[patchi];

    patchValues_.setSize(patchField.size());
    forAll(patchField, facei)
    {
        patchValues_[facei] = component(patchField[facei], cmpt);
    }

    SubList<scalar> values(value_[variable], patch.size(), patch.start());
    toFaces_[patchi].map(patchValues_, values);
}


void Foam::SPH::boundaryStates::copyPatches(const label patchi)
{
    const fvPatchVectorField& Up = U_.boundaryField()[patchi];

    // Of the velocity of a slip wall only what moves the wall counts: along an
    // edge or a curved wall, velocities along it point through the next face
    vectorField velocity(Up);
    if (isA<basicSymmetryFvPatchField<vector>>(Up))
    {
        velocity = Zero;
    }
    else if (treatment_[particles_.boundary()[patchi].start()] == slip)
    {
        const vectorField n(Up.patch().nf());
        velocity = n*(n & Up);
    }

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

    if (Up.fixesValue())
    {
        phi_.boundaryFieldRef()[patchi] == (Up.patch().Sf() & Up);
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
    const sphMesh& particles,
    volVectorField& U,
    const std::vector<scalarVariable>& scalars,
    surfaceScalarField& phi,
    const bool viscous
)
:
    faceStates(particles, loopDims(particles) + label(scalars.size())),
    U_(U),
    scalars_(scalars),
    phi_(phi),
    toFaces_(particles.boundary().size())
{
    classify(viscous);
    setCellWeights();

    for (const sphPatch& patch : particles.boundary())
    {
        if (patch.size())
        {
            toFaces_.set
            (
                patch.index(),
                new patchReconstruction(patch, particles.space())
            );
            copyPatches(patch.index());
        }
    }
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
        U_.boundaryFieldRef()[patchi].evaluate();
        for (const scalarVariable& s : scalars_)
        {
            s.field.boundaryFieldRef()[patchi].evaluate();
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

    for (const sphPatch& patch : particles_.boundary())
    {
        if (patch.size())
        {
            os  << "    " << patch.name() << ": "
                << names[treatment_[patch.start()]] << ", "
                << patch.size()
                << (contact(patch.start())
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
