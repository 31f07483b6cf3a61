/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sphMonitor.H"
#include "addToRunTimeSelectionTable.H"
#include "flowSolver.H"

#include <limits>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    defineTypeNameAndDebug(sphMonitor, 0);
    addToRunTimeSelectionTable(functionObject, sphMonitor, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::sphMonitor::createFiles(const flowSolver& solver)
{
    constexpr int allDigits = std::numeric_limits<scalar>::max_digits10;
    const label nVariables = solver.law().nVariables();

    totalsFile_ = createFile("totals");
    rangeFile_ = createFile("range");
    totalsFile_().precision(allDigits);
    rangeFile_().precision(allDigits);

    writeCommented(totalsFile_(), "Time");
    writeCommented(rangeFile_(), "Time");
    for (label v = 0; v < nVariables; ++v)
    {
        writeTabbed(totalsFile_(), "total" + Foam::name(v));
        writeTabbed(rangeFile_(), "min" + Foam::name(v));
        writeTabbed(rangeFile_(), "max" + Foam::name(v));
    }
    totalsFile_() << endl;
    rangeFile_() << endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::sphMonitor::sphMonitor
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(mesh_, name)
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::SPH::sphMonitor::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    writeFile::read(dict);
    return true;
}


bool Foam::SPH::sphMonitor::execute()
{
    const auto* solver = mesh_.findObject<flowSolver>(flowSolver::typeName);

    if (!solver)
    {
        return true;
    }

    const conservationLaw& law = solver->law();
    scalarField totals(law.nVariables());
    List<scalarMinMax> ranges(totals.size());
    forAll(totals, v)
    {
        totals[v] = gSum((solver->particles().V()*law.conserved(v))());
        ranges[v] = gMinMax(law.primitive(v)());
    }

    if (!writeToFile() || !Pstream::master())
    {
        return true;
    }
    if (!totalsFile_.valid())
    {
        createFiles(*solver);
    }

    totalsFile_() << mesh_.time().timeName();
    rangeFile_() << mesh_.time().timeName();
    forAll(totals, v)
    {
        totalsFile_() << tab << totals[v];
        rangeFile_() << tab << ranges[v].min() << tab << ranges[v].max();
    }
    totalsFile_() << endl;
    rangeFile_() << endl;

    return true;
}


bool Foam::SPH::sphMonitor::write()
{
    return true;
}


// ************************************************************************* //
