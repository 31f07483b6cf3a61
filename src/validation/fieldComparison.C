/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "fieldComparison.H"
#include "bitSet.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::fieldComparison::alignLevel
(
    volScalarField& sph,
    const volScalarField& fvm
)
{
    const word pressure(IOobject::member(fvm.name()));

    if
    (
        (pressure != "p" && pressure != "p_rgh")
     || fvm.dimensions() != dimPressure/dimDensity
     || !fvm.needReference()
    )
    {
        return;
    }

    const scalarField V(inFluid(mesh_.V().field()));
    const scalar level =
        gSum(V*inFluid<scalar>(sph.primitiveField() - fvm.primitiveField()))
       /gSum(V);

    for (const label celli : fluid_)
    {
        sph[celli] -= level;
    }
    for (fvPatchScalarField& patch : sph.boundaryFieldRef())
    {
        patch == patch - level;
    }

    remarks_.append
    (
        "No boundary condition fixes the level of " + fvm.name()
      + ": its mean difference of " + name(level) + " is removed."
    );
}


void Foam::SPH::fieldComparison::addQuantities
(
    const word& name,
    const labelUList&,
    const volScalarField& sph,
    const volScalarField& fvm
)
{
    quantities_.append
    (
        new comparedQuantity{name, name, name, true, true, fvm, sph, sph - fvm}
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::fieldComparison::fieldComparison
(
    const fvMesh& mesh,
    const referenceCase& reference,
    const instant& time,
    const wordList& fields,
    const labelUList& solid
)
:
    mesh_(mesh),
    reference_(reference),
    time_(time),
    fluid_((bitSet(mesh.nCells(), true) -= bitSet(mesh.nCells(), solid)).toc()),
    solid_(solid),
    norms_(),
    quantities_(),
    remarks_()
{
    const IOobjectList objects(reference.objects(time));

    for (const word& field : fields)
    {
        const word className(objects[field]->headerClassName());

        add<scalar>(field, className);
        add<vector>(field, className);
        add<sphericalTensor>(field, className);
        add<symmTensor>(field, className);
        add<tensor>(field, className);
    }
}

// ************************************************************************* //
