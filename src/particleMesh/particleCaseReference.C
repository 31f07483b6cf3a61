/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    Where the particle case fixes the level of a pressure that no boundary
    condition fixes.

    By a point, not by the number of a cell: in a parallel run OpenFOAM takes
    that for one of the first processor's cells, which are fewer.

\*---------------------------------------------------------------------------*/

#include "particleCase.H"
#include "StringStream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- The field whose reference cell or point an entry gives, or none
    static word fieldOfReference(const word& keyword)
    {
        for (const word suffix : {"RefCell", "RefPoint"})
        {
            if (keyword.ends_with(suffix))
            {
                return keyword.substr(0, keyword.size() - suffix.size());
            }
        }

        return word();
    }

    //- The centre nearest to a point, of the particles that OpenFOAM finds at
    //- their centre because it lies behind all of their faces
    static point nearestCentre(const polyMesh& particles, const point& p)
    {
        const vectorField& C = particles.cellCentres();
        point nearest(p);
        scalar smallest = VGREAT;
        forAll(C, i)
        {
            const scalar distance = magSqr(C[i] - p);
            if (distance < smallest && particles.pointInCell(C[i], i))
            {
                smallest = distance;
                nearest = C[i];
            }
        }

        return nearest;
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::string Foam::SPH::particleCase::solutionAdditions()
{
    // The point is one of a particle, once there are particles
    if (!isFile(path_/"constant"/"polyMesh"/"points"))
    {
        return std::string();
    }

    OStringStream os;
    os.precision(12);
    for (const entry& algorithm : mesh_.solutionDict())
    {
        if (!algorithm.isDict() || algorithm.keyword().isPattern())
        {
            continue;
        }

        const word name(algorithm.keyword());
        const dictionary& dict = algorithm.dict();
        for (const entry& e : dict)
        {
            const word field(fieldOfReference(e.keyword()));
            const word cellName(field + "RefCell");
            if (field.size() && e.keyword() == cellName)
            {
                // A wrong number stays for the solver to tell
                const label celli = dict.get<label>(cellName);
                if (celli < 0 || celli >= mesh_.nCells())
                {
                    continue;
                }

                // #remove reaches only what the same block has
                os  << "ofCells { $" << name << "; }\n#remove " << name << '\n'
                    << name << "\n{\n    $ofCells;\n    #remove " << cellName
                    << "\n    " << field << "RefPoint "
                    << nearestCentre
                       (
                           particles().mesh(), mesh_.cellCentres()[celli]
                       )
                    << ";\n}\n#remove ofCells\n";
            }
            else if (field.size() && !dict.found(cellName))
            {
                const point given(dict.get<point>(e.keyword()));
                os  << name << "\n{\n    " << field << "RefPoint "
                    << nearestCentre(particles().mesh(), given) << ";\n}\n";
            }
        }
    }

    return
        os.str().empty()
      ? std::string()
      : "// The nearest particle, in whichever processor it is\n" + os.str();
}


// ************************************************************************* //
