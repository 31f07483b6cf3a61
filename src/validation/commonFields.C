/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "commonFields.H"
#include "particleResults.H"
#include "timeSelector.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    static bool isVolField(const IOobject& io)
    {
        return
            io.headerClassName().startsWith("vol")
         && io.headerClassName().endsWith("Field");
    }

    //- volFields of one method: those of SPH without their group "sph", or
    //- all others
    static HashTable<word> classes
    (
        const IOobjectList& objects,
        const bool ofSph,
        const wordRes& names
    )
    {
        HashTable<word> result;
        forAllConstIters(objects, iter)
        {
            const IOobject& io = *iter();
            const word field
            (
                ofSph ? IOobject::member(io.name()) : io.name()
            );

            if
            (
                isVolField(io)
             && (IOobject::group(io.name()) == "sph") == ofSph
             && (names.empty() || names.match(field))
            )
            {
                result.insert(field, io.headerClassName());
            }
        }
        return result;
    }

    //- Times of either case, ascending and without 'constant'
    static instantList allTimes(const instantList& a, const instantList& b)
    {
        DynamicList<instant> result;
        for (const instantList* list : {&a, &b})
        {
            for (const instant& time : *list)
            {
                bool known = time.name() == "constant";
                for (const instant& t : result)
                {
                    known = known || particleResults::equal(t, time);
                }
                if (!known)
                {
                    result.append(time);
                }
            }
        }
        Foam::sort(result, instant::less());

        return instantList(result);
    }
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::commonFields::commonFields
(
    const fvMesh& mesh,
    const referenceCase& reference,
    const wordRes& names,
    const particleResults* particles
)
:
    times_(),
    fvmOnly_(),
    sphOnly_(),
    fields_()
{
    DynamicList<instant> both;
    DynamicList<instant> fvmOnly;
    DynamicList<instant> sphOnly;

    for (const instant& time : allTimes(mesh.time().times(), reference.times()))
    {
        const HashTable<word> sph
        (
            classes(IOobjectList(mesh, time.name()), true, names)
        );
        const HashTable<word> fvm
        (
            classes(reference.objects(time), false, names)
        );

        DynamicList<word> common;
        for (const word& field : sph.sortedToc())
        {
            if (fvm.found(field))
            {
                if (sph[field] != fvm[field])
                {
                    FatalErrorInFunction
                        << "At time " << time.name() << " field " << field
                        << " is a " << fvm[field] << ", but "
                        << particleResults::volName(field) << " is a "
                        << sph[field] << exit(FatalError);
                }
                common.append(field);
            }
        }

        if (common.size())
        {
            both.append(time);
            fields_.insert(time.name(), wordList(common));
        }
        else if (fvm.size())
        {
            fvmOnly.append(time);
        }
        else if (sph.size())
        {
            sphOnly.append(time);
        }
    }

    times_.transfer(both);
    fvmOnly_.transfer(fvmOnly);
    sphOnly_.transfer(sphOnly);

    if (times_.empty())
    {
        FatalErrorInFunction
            << "No time has fields to compare"
            << (names.empty() ? "" : " that match the entry or option fields")
            << nl
            << "    FVM fields in " << reference.path() << " at times: "
            << this->names(fvmOnly_).c_str() << nl
            << "    SPH fields (<field>.sph) in " << mesh.time().path()
            << " at times: " << this->names(sphOnly_).c_str() << nl;
        if (particles)
        {
            FatalError
                << "    Fields of the particles in "
                << particles->mesh().time().path() << " at times: "
                << this->names(allTimes(particles->times(), {})).c_str() << nl;
        }
        FatalError
            << "    Write both at the same times, or compare the start with"
            << " -withZero" << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::instantList Foam::SPH::commonFields::select(const argList& args) const
{
    if (args.found("latestTime"))
    {
        return instantList(1, times_.last());
    }

    // A single time selects the nearest one: out of all times, so that one
    // without fields of both methods is not replaced by another
    const instantList all(allTimes(times_, allTimes(fvmOnly_, sphOnly_)));

    DynamicList<instant> selected;
    for (const instant& time : timeSelector::select(all, args))
    {
        if (fields_.found(time.name()))
        {
            selected.append(time);
        }
    }

    if (selected.empty())
    {
        FatalErrorInFunction
            << "The time options select none of the times with fields of both"
            << " methods. Valid choices: " << names(times_).c_str()
            << ", time 0 with -withZero"
            << exit(FatalError);
    }

    return instantList(selected);
}


void Foam::SPH::commonFields::print() const
{
    Info<< "Times with FVM and SPH fields: " << names(times_).c_str() << nl;

    if (fvmOnly_.size())
    {
        Info<< "Not compared, FVM fields only: " << names(fvmOnly_).c_str()
            << nl;
    }
    if (sphOnly_.size())
    {
        Info<< "Not compared, SPH fields only: " << names(sphOnly_).c_str()
            << nl;
    }
    Info<< endl;
}


std::string Foam::SPH::commonFields::names(const instantList& times)
{
    std::string list;
    for (const instant& time : times)
    {
        list += (list.empty() ? "" : " ") + time.name();
    }
    return list.empty() ? "none" : list;
}

// ************************************************************************* //
