/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sphCloud.H"
#include "addToRunTimeSelectionTable.H"
#include "ListListOps.H"
#include "particleFiles.H"
#include "particleVtp.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    defineTypeNameAndDebug(sphCloud, 0);
    addToRunTimeSelectionTable(functionObject, sphCloud, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- The values of all ranks, one rank after another, on the master
    template<class Type>
    static Field<Type> gathered(const Field<Type>& values)
    {
        if (!Pstream::parRun())
        {
            return values;
        }

        List<Field<Type>> all(Pstream::nProcs());
        all[Pstream::myProcNo()] = values;
        Pstream::gatherList(all);
        return ListListOps::combine<Field<Type>>
        (
            all, accessOp<Field<Type>>()
        );
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
void Foam::SPH::sphCloud::addFields(particleVtp& file) const
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;

    for (const word& name : mesh_.sortedNames<fieldType>())
    {
        if (fields_.empty() || fields_.match(name))
        {
            const auto& field = mesh_.lookupObject<fieldType>(name);
            const Field<Type> values(gathered(field.primitiveField()));
            if (Pstream::master())
            {
                file.add(name, values);
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::sphCloud::sphCloud
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict)
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::SPH::sphCloud::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    fields_.clear();
    dict.readIfPresent("fields", fields_);
    return true;
}


bool Foam::SPH::sphCloud::execute()
{
    return true;
}


bool Foam::SPH::sphCloud::write()
{
    const Time& time = mesh_.time();
    if (!particleFiles(time).found())
    {
        return true;
    }

    const fileName folder(time.globalPath()/"postProcessing"/name());
    const fileName file(name() + "_" + time.timeName() + ".vtp");

    particleVtp particles(folder/file);
    addFields<scalar>(particles);
    addFields<vector>(particles);

    const pointField points(gathered(mesh_.cellCentres()));
    if (Pstream::master())
    {
        particles.write(points);
        series_.append(time.value(), file);
        series_.write(folder/name() + ".vtp");
    }

    return true;
}


// ************************************************************************* //
