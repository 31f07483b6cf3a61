/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleDiscs.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::particleDiscs::particleDiscs
(
    const particleResults& results,
    const meshSlice& slice,
    const boundBox& box
)
:
    results_(results)
{
    const vectorField& centres = results.mesh().cellCentres();
    const scalarField& spacing = results.spacing();

    forAll(centres, i)
    {
        const point centre(slice.toPlane(centres[i]));
        if
        (
            mag(slice.distance(centres[i])) > 0.5*spacing[i]
         || centre.x() < box.min().x() || centre.x() > box.max().x()
         || centre.y() < box.min().y() || centre.y() > box.max().y()
        )
        {
            continue;
        }

        particles_.append(i);
        discs_.add(12, centre, spacing[i]);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::SPH::particleDiscs::values
(
    const word& field,
    const instant& time
) const
{
    const IOobjectList objects(results_.fields(time));
    const IOobject* io = objects.findObject(field);

    tmp<scalarField> values;
    if (io && io->headerClassName() == volScalarField::typeName)
    {
        values = results_.read<scalar>(*io)().primitiveField();
    }
    else if (io && io->headerClassName() == volVectorField::typeName)
    {
        values = mag(results_.read<vector>(*io)().primitiveField());
    }

    return
        values.valid()
      ? scalarField(values(), particles_)
      : scalarField();
}

// ************************************************************************* //
