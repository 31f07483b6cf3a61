/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Application
    measureField

Description
    Numbers taken from a scalar field, of FVM (rho) or of SPH mapped to the
    cells (rho.sph) alike, at the latest time that has it or that next to
    -time. One line 'name = value' for each.

Usage
    \b measureField -field \<name\> [-time VALUE] [OPTION]

      - \par -line \<((x y z) (x y z))\> -level \<value\>
        crossing: distance along the line at which the field first crosses the
        level [m], linear between points 1/4000 of the line apart

      - \par -point \<(x y z)\>
        value: interpolated to the point

      - \par -box \<((x y z) (x y z))\>
        Take min and max, which are always written, over the cells with
        centres in the box

      - \par -exact \<name\>
        L1, L2, Linf: of the difference to another field, averaged by volume

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "interpolationCellPoint.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The field at the latest of these times that has it
static volScalarField readField
(
    Time& runTime,
    const instantList& times,
    const fvMesh& mesh,
    const word& name
)
{
    forAllReverse(times, i)
    {
        runTime.setTime(times[i], i);
        IOobject io(name, runTime.timeName(), mesh, IOobject::MUST_READ);
        if (io.typeHeaderOk<volScalarField>(true))
        {
            return volScalarField(io, mesh);
        }
    }

    FatalErrorInFunction
        << "No time of " << runTime.path() << " has a scalar field " << name
        << exit(FatalError);

    return volScalarField::null();
}


static void report(const word& name, const scalar value)
{
    Info<< name << " = " << value << endl;
}


static void reportNorms(const volScalarField& f, const scalarField& reference)
{
    const scalarField& V = f.mesh().V();
    const scalarField d(mag(f.primitiveField() - reference));

    report("L1", sum(V*d)/sum(V));
    report("L2", Foam::sqrt(sum(V*sqr(d))/sum(V)));
    report("Linf", max(d));
}


//- Report where the field first crosses a level between the ends of a line
static void reportCrossing
(
    const volScalarField& f,
    const Pair<point>& line,
    const scalar level
)
{
    const label nPoints = 4000;
    const interpolationCellPoint<scalar> values(f);
    const vector step((line.second() - line.first())/nPoints);

    bool first = true;
    scalar before = 0;
    for (label i = 0; i <= nPoints; ++i)
    {
        const point x(line.first() + i*step);
        const label celli = f.mesh().findCell(x);
        if (celli < 0)
        {
            continue;
        }

        const scalar above = values.interpolate(x, celli) - level;
        if (!first && above*before <= 0)
        {
            report("crossing", (i - above/(above - before))*mag(step));
            return;
        }
        before = above;
        first = false;
    }

    FatalErrorInFunction
        << "Field " << f.name() << " does not cross " << level
        << " on the line " << line << exit(FatalError);
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::noParallel();
    argList::addNote("Numbers taken from a scalar field");
    argList::addOption("field", "name", "Scalar field to measure");
    argList::addOption("time", "value", "Time next to which to measure");
    argList::addOption("line", "points", "First and last point of a line");
    argList::addOption("level", "value", "Level whose crossing is searched");
    argList::addOption("point", "point", "Point to interpolate to");
    argList::addOption("box", "points", "Least and greatest corner of a box");
    argList::addOption("exact", "name", "Field to compare with");

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    const word name(args.get<word>("field"));
    const instantList times
    (
        args.found("time")
      ? instantList(1, runTime.findClosestTime(args.get<scalar>("time")))
      : runTime.times()
    );
    const volScalarField f(readField(runTime, times, mesh, name));

    if (args.found("line"))
    {
        reportCrossing
        (
            f,
            args.get<Pair<point>>("line"),
            args.get<scalar>("level")
        );
    }

    if (args.found("point"))
    {
        const point x(args.get<point>("point"));
        const label celli = mesh.findCell(x);
        if (celli < 0)
        {
            FatalErrorInFunction
                << "The point " << x << " is not in the mesh"
                << exit(FatalError);
        }
        report
        (
            "value",
            interpolationCellPoint<scalar>(f).interpolate(x, celli)
        );
    }

    boundBox box(mesh.bounds());
    if (args.found("box"))
    {
        const Pair<point> corners(args.get<Pair<point>>("box"));
        box = boundBox(corners.first(), corners.second());
    }

    scalar low = GREAT;
    scalar high = -GREAT;
    forAll(f, celli)
    {
        if (box.contains(mesh.C()[celli]))
        {
            low = min(low, f[celli]);
            high = max(high, f[celli]);
        }
    }
    report("min", low);
    report("max", high);

    if (args.found("exact"))
    {
        reportNorms
        (
            f,
            readField
            (
                runTime, times, mesh, args.get<word>("exact")
            ).primitiveField()
        );
    }

    Info<< "\nEnd\n" << endl;

    return 0;
}


// ************************************************************************* //
