/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "polygonPatch.H"
#include "IFstream.H"

#include <sstream>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<Foam::vector2D> Foam::SPH::polygonPatch::readPoints
(
    const dictionary& dict,
    const word& key,
    const fileName& directory
)
{
    ITstream& is = dict.lookup(key);

    if (is.empty() || !is[0].isString())
    {
        return List<vector2D>(is);
    }

    const fileName file(dict.get<fileName>(key));
    IFstream points(file.isAbsolute() ? file : directory/file);

    if (!points.good())
    {
        FatalIOErrorInFunction(dict)
            << "Patch " << dict.dictName() << ": cannot read the file "
            << points.name() << " of the entry " << key << exit(FatalIOError);
    }

    DynamicList<vector2D> values;
    string line;
    while (points.getLine(line))
    {
        line = line.substr(0, line.find('#'));
        if (line.find_first_not_of(" \t\r") == string::npos)
        {
            continue;
        }

        std::istringstream numbers(line);
        scalar x, y;
        if (!(numbers >> x >> y))
        {
            FatalIOErrorInFunction(points)
                << "Patch " << dict.dictName() << ": '" << line.c_str()
                << "' is not a point 'x y'" << exit(FatalIOError);
        }
        values.append(vector2D(x, y));
    }

    return List<vector2D>(std::move(values));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::polygonPatch::polygonPatch
(
    const word& name,
    const word& type,
    const UList<vector2D>& loop
)
:
    name_(name),
    type_(type)
{
    add(loop, true);
}


Foam::SPH::polygonPatch::polygonPatch
(
    const dictionary& dict,
    const fileName& directory
)
:
    name_(dict.dictName()),
    type_(dict.getOrDefault<word>("type", "wall"))
{
    if (dict.found("loop") == dict.found("line"))
    {
        FatalIOErrorInFunction(dict)
            << "Patch " << name_ << " must have one of the entries 'loop',"
            << " a closed polygon, and 'line', an open one"
            << exit(FatalIOError);
    }

    const bool closed = dict.found("loop");
    const List<vector2D> points
    (
        readPoints(dict, closed ? "loop" : "line", directory)
    );

    if (points.size() < (closed ? 3 : 2))
    {
        FatalIOErrorInFunction(dict)
            << "Patch " << name_ << " has " << points.size()
            << " points. Valid: 3 or more of a loop, 2 or more of a line"
            << exit(FatalIOError);
    }

    add(points, closed);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::polygonPatch::add
(
    const UList<vector2D>& line,
    const bool closed
)
{
    const label nSegments = closed ? line.size() : line.size() - 1;

    for (label i = 0; i < nSegments; ++i)
    {
        const vector2D& next = line[(i + 1) % line.size()];

        // A loop's file may repeat its first point at the end
        if (mag(next - line[i]) > VSMALL)
        {
            from_.append(line[i]);
            to_.append(next);
        }
    }
}


Foam::scalar Foam::SPH::polygonPatch::distance(const vector2D& p) const
{
    scalar nearest = GREAT;

    forAll(from_, i)
    {
        const vector2D d(to_[i] - from_[i]);
        const scalar s =
            max(scalar(0), min(scalar(1), ((p - from_[i]) & d)/magSqr(d)));
        nearest = min(nearest, mag(from_[i] + s*d - p));
    }

    return nearest;
}


// ************************************************************************* //
