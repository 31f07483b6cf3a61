/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "solidParticles.H"
#include "labelIOList.H"
#include "scalarIOField.H"
#include "vectorIOField.H"
#include "IOdictionary.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- FatalError unless the arrays agree with each other
    static void checkArrays
    (
        const fileName& path,
        const UList<particleSet>& solids,
        const labelUList& counts,
        const pointField& points,
        const scalarField& spacing,
        const labelUList& body
    )
    {
        bool valid =
            spacing.size() == points.size()
         && body.size() == points.size()
         && (
                body.empty()
             || (min(body) >= 0 && max(body) < solids.size())
            );

        labelList found(solids.size(), Zero);
        for (label i = 0; valid && i < body.size(); ++i)
        {
            ++found[body[i]];
            valid = spacing[i] > 0 && mag(points[i]) < GREAT;
        }

        if (!valid || found != counts)
        {
            FatalErrorInFunction
                << "The solid particles in " << path
                << " are inconsistent: points, spacing, body and bodies do"
                << " not agree. Regenerate them with sphMesh -overwrite"
                << exit(FatalError);
        }
    }
}
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::List<Foam::SPH::particleSet> Foam::SPH::readSolidParticles
(
    const particleFiles& files
)
{
    IOobject io(files.arrayIO("solids"));
    if (!io.typeHeaderOk<IOdictionary>(true))
    {
        return List<particleSet>();
    }
    const IOdictionary bodies(io);
    const wordList names(bodies.toc());

    List<particleSet> solids(names.size());
    labelList counts(names.size());
    forAll(names, bodyi)
    {
        const dictionary& dict = bodies.subDict(names[bodyi]);
        solids[bodyi].name = names[bodyi];
        solids[bodyi].smoothingRatio = dict.get<scalar>("smoothingRatio");
        counts[bodyi] = dict.get<label>("nParticles");
    }

    const vectorIOField points(files.arrayIO("solidPoints"));
    const scalarIOField spacing(files.arrayIO("solidSpacing"));
    const labelIOList body(files.arrayIO("solidBody"));
    checkArrays(io.path(), solids, counts, points, spacing, body);

    forAll(solids, bodyi)
    {
        solids[bodyi].points.setSize(counts[bodyi]);
        solids[bodyi].spacing.setSize(counts[bodyi]);
    }

    labelList next(solids.size(), Zero);
    forAll(body, i)
    {
        particleSet& solid = solids[body[i]];
        solid.points[next[body[i]]] = points[i];
        solid.spacing[next[body[i]]++] = spacing[i];
    }

    return solids;
}


void Foam::SPH::writeSolidParticles
(
    const particleFiles& files,
    const UList<particleSet>& solids
)
{
    DynamicList<point> points;
    DynamicList<scalar> spacing;
    DynamicList<label> body;
    dictionary bodies;

    forAll(solids, bodyi)
    {
        const particleSet& solid = solids[bodyi];
        points.append(solid.points);
        spacing.append(solid.spacing);
        body.append(labelList(solid.points.size(), bodyi));

        dictionary entry;
        entry.add("smoothingRatio", solid.smoothingRatio);
        entry.add("nParticles", solid.points.size());
        bodies.add(solid.name, entry);
    }

    files.writeArray<vectorIOField>("solidPoints", pointField(points));
    files.writeArray<scalarIOField>("solidSpacing", scalarField(spacing));
    files.writeArray<labelIOList>("solidBody", labelList(body));
    files.writeDictionary("solids", bodies);
}


// ************************************************************************* //
