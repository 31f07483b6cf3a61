/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "startFields.H"
#include "cellSpacing.H"
#include "meshSearch.H"
#include "stressModels.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Change over half a cell, relative, above which a field jumps
    static const scalar jump = 0.1;
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::IOobjectList Foam::SPH::startFields::allFields(const fvMesh& mesh)
{
    IOobjectList objects(mesh, mesh.time().timeName());
    const IOobjectList constant(mesh, mesh.time().constant());
    forAllConstIters(constant, iter)
    {
        autoPtr<IOobject> io(new IOobject(*iter()));
        objects.add(io);
    }
    return objects;
}


bool Foam::SPH::startFields::isNewtonian() const
{
    const IOdictionary properties
    (
        readDictIfPresent
        (
            mesh_.time(), "turbulenceProperties", mesh_.time().constant()
        )
    );

    for (const modelEntry& e : stressModels(properties))
    {
        if (!e.isNewtonian())
        {
            return false;
        }
    }
    return true;
}


bool Foam::SPH::startFields::hasParticles(const fvPatch& patch) const
{
    if (particles_.cellMap().empty())
    {
        return true;
    }
    for (const label celli : patch.faceCells())
    {
        if (particles_.cellMap()[celli] < 0)
        {
            return true;
        }
    }
    return false;
}


void Foam::SPH::startFields::findCells()
{
    const meshSearch search(mesh_, polyMesh::FACE_PLANES);
    const pointField& points = particles_.mesh().cellCentres();

    const labelList& cellMap = particles_.cellMap();
    cells_.setSize(points.size());
    label seed = -1;
    forAll(cells_, i)
    {
        if (cellMap.size() && cellMap[i] >= 0)
        {
            cells_[i] = cellMap[i];
            beside_[i] = true;
            continue;
        }

        label celli = search.findCell(points[i], seed, true);
        if (celli < 0)
        {
            celli = search.findNearestCell(points[i], seed, true);
        }
        cells_[i] = seed = celli;
    }
}


void Foam::SPH::startFields::markJumps(const volScalarField& field)
{
    const scalarField& values = field.primitiveField();
    const scalar lowest = min(values);
    const scalar highest = max(values);
    if (highest - lowest <= jump*mag(lowest) && lowest > 0)
    {
        return;
    }

    const scalarField between(mapped(field));
    forAll(cells_, i)
    {
        const scalar value = values[cells_[i]];
        const scalar change = mag(between[i] - value);
        const bool bound = value == lowest || value == highest;

        if
        (
            (lowest > 0 && change > jump*value)
         || (bound && change > jump*(highest - lowest))
        )
        {
            beside_[i] = true;
        }
    }
}


void Foam::SPH::startFields::writeZones() const
{
    const wordList names(mesh_.cellZones().names());
    if (names.empty())
    {
        return;
    }

    const fvMesh& particles = particles_.mesh();
    cellZoneMesh zones
    (
        IOobject
        (
            "cellZones",
            particles.facesInstance(),
            polyMesh::meshSubDir,
            particles,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        particles
    );

    const auto add = [&](const word& name, const labelUList& cells)
    {
        zones.append(new cellZone(name, cells, zones.size(), zones));
    };

    // Those of a zone of particles, or that a user has added
    const bool hybrid = particles_.cellMap().size();
    const wordList own({"fvm", "sph"});
    for (const cellZone& zone : particles.cellZones())
    {
        if (!names.found(zone.name()) || (hybrid && own.found(zone.name())))
        {
            add(zone.name(), zone);
        }
    }

    for (const cellZone& zone : mesh_.cellZones())
    {
        if (hybrid && own.found(zone.name()))
        {
            continue;
        }
        boolList inside(mesh_.nCells(), false);
        UIndirectList<bool>(inside, zone) = true;

        DynamicList<label> cells;
        forAll(cells_, i)
        {
            if (inside[cells_[i]])
            {
                cells.append(i);
            }
        }
        add(zone.name(), cells);
    }

    zones.write();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::startFields::startFields(const fvMesh& mesh, particleCase& sph)
:
    mesh_(mesh),
    case_(sph),
    particles_(sph.particles()),
    objects_(allFields(mesh)),
    toParticles_
    (
        solutionSpace(mesh),
        {mesh.cellCentres(), cellSpacing(solutionSpace(mesh), mesh)},
        {particles_.mesh().cellCentres(), particles_.spacing()}
    ),
    cells_(),
    beside_(particles_.mesh().nCells(), false),
    newtonian_(isNewtonian())
{
    findCells();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::startFields::write()
{
    bool any = false;
    forAllConstIters(objects_, iter)
    {
        const IOobject& io = *iter();
        any = any || io.headerClassName().startsWith("vol");
        if
        (
            io.headerClassName() == volScalarField::typeName
         && IOobject::group(io.name()) != "sph"
        )
        {
            markJumps(volScalarField(io, mesh_));
        }
    }

    if (!any)
    {
        WarningInFunction
            << "No fields in " << mesh_.time().timePath()
            << ": the particle case has none" << endl;
    }

    writeZones();
    mapType<scalar>();
    mapType<vector>();
    mapType<sphericalTensor>();
    mapType<symmTensor>();
    mapType<tensor>();
    case_.files().write();
}


// ************************************************************************* //
