/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "fieldComparison.H"
#include "particleResults.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
void Foam::SPH::fieldComparison::addQuantities
(
    const word& name,
    const labelUList& components,
    const GeometricField<Type, fvPatchField, volMesh>& sph,
    const GeometricField<Type, fvPatchField, volMesh>& fvm
)
{
    quantities_.append
    (
        new comparedQuantity
        {
            "|" + name + "|", name, name, true, false,
            mag(fvm), mag(sph), mag(sph - fvm)
        }
    );

    for (const label d : components)
    {
        const word component(name + pTraits<Type>::componentNames[d]);
        quantities_.append
        (
            new comparedQuantity
            {
                component, component, name, false, true,
                fvm.component(d),
                sph.component(d),
                sph.component(d) - fvm.component(d)
            }
        );
    }
}


template<class Type>
void Foam::SPH::fieldComparison::add(const word& name, const word& className)
{
    typedef GeometricField<Type, fvPatchField, volMesh> volFieldType;

    if (className != volFieldType::typeName)
    {
        return;
    }

    volFieldType sph
    (
        IOobject
        (
            particleResults::volName(name),
            time_.name(),
            mesh_,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh_
    );
    tmp<volFieldType> tfvm(reference_.read(name, time_, sph));
    volFieldType& fvm = tfvm.ref();
    for (const label celli : solid_)
    {
        sph[celli] = Zero;
        fvm[celli] = Zero;
    }

    if (sph.dimensions() != fvm.dimensions())
    {
        FatalErrorInFunction
            << "At time " << time_.name() << " the dimensions of " << name
            << ' ' << fvm.dimensions() << " and " << sph.name() << ' '
            << sph.dimensions() << " differ" << exit(FatalError);
    }

    alignLevel(sph, fvm);

    // Components of vectors in directions that are not solved are not listed
    DynamicList<label> components;
    if (pTraits<Type>::rank > 0)
    {
        for (direction d = 0; d < pTraits<Type>::nComponents; ++d)
        {
            if (pTraits<Type>::rank > 1 || mesh_.geometricD()[d] > 0)
            {
                components.append(d);
            }
        }
    }

    norms_.add<Type>
    (
        name,
        components,
        inFluid(mesh_.V().field()),
        inFluid(sph.primitiveField()),
        inFluid(fvm.primitiveField())
    );

    addQuantities(name, components, sph, fvm);
}

// ************************************************************************* //
