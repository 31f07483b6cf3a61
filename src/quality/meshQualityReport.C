/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    Report of the measures, as text and as comma-separated values.

\*---------------------------------------------------------------------------*/

#include "meshQuality.H"
#include "OFstream.H"
#include "OSspecific.H"

#include <limits>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- A measure in words
    struct measureText
    {
        const char* measure;
        const char* text;
    };

    static const measureText measureTexts[] =
    {
        {"kernelGradientSumMean", "Mean kernel gradient sum times spacing"},
        {"kernelGradientSumMax", "Max kernel gradient sum times spacing"},
        {"totalError", "Total error over volume"},
        {"volume", "Volume of all particles over that of the mesh, minus 1"},
        {"closureResidual", "Max area sum of a particle"},
        {"linearResidualMax", "Max error of a linear field's gradient"},
        {"linearResidualRms", "RMS error of a linear field's gradient"},
        {"patchArea", "Area error of patch"},
        {"spacingMin", "Min distance of particles over spacing"},
        {"spacingVoid", "Max radius of a void over spacing"},
        {"spacingRatioMean", "Mean spacing over the one wanted"},
        {"spacingRatioMax", "Max spacing over the one wanted"},
        {"spacingRatioMin", "Min spacing over the one wanted"},
        {"offSurfaceMean", "Mean offset of the first layer over spacing"},
        {"offSurfaceMax", "Max offset of the first layer over spacing"},
        {"flippedAreas", "Pair areas turned round by the closure"},
        {"flippedAreasFraction", "Their fraction of all pair areas"},
        {"areaChangeMax", "Max relative change of a pair area"},
        {"faceShiftMax", "Max shift of a face centre over pair length"},
        {"areaErrorMax", "Max change of a pair area over a particle's side"},
        {"momentErrorMax", "Max shift of a face times area over volume"},
        {"faceDistanceMin", "Min height of a particle over its face over dp"},
        {"faceOffsetRms", "RMS offset of faces from the surface over dp"},
        {"kineticEnergy", "Kinetic energy over its first value"}
    };

    static const char* text(const word& measure)
    {
        for (const measureText& m : measureTexts)
        {
            if (measure == m.measure)
            {
                return m.text;
            }
        }
        return measure.c_str();
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::SPH::meshQuality::limit(const row& r) const
{
    // Sums of areas of the order of one, that come from points far away
    const scalar extent = max
    (
        cmptMax(cmptMag(mesh_.bounds().min())),
        cmptMax(cmptMag(mesh_.bounds().max()))
    );
    const scalar roundOff = max
    (
        1e-12,
        10*std::numeric_limits<scalar>::epsilon()*extent
       /min(particles_.spacing())
    );

    const dictionary closure
    (
        particles_.properties().subOrEmptyDict("closure")
    );
    const bool consistent =
        closure.lookupOrDefault<word>("type", "consistent") == "consistent";
    const bool linear =
        consistent && closure.lookupOrDefault<label>("order", 1) == 1;
    const bool mirrored = consistent && r.measure == "patchArea";
    const bool closed = consistent && r.measure == "closureResidual";
    const bool exact = linear && r.measure == "linearResidualMax";

    if (mirrored || closed || exact || r.measure == "volume")
    {
        return roundOff;
    }
    if (r.measure == "spacingMin")
    {
        return 0.4;
    }
    if (r.measure == "spacingVoid")
    {
        // A quarter wider than in a cubic lattice, less than where a
        // particle of it is missing
        return 1.25*0.5*sqrt(scalar(particles_.nDims()));
    }
    if (r.measure == "faceDistanceMin")
    {
        // Half the distance that the first layer keeps
        return 0.1;
    }
    if (r.measure == "momentErrorMax")
    {
        // Three times what smooth walls need, half of what a sharp trailing
        // edge too fine for its particles does
        return 0.2;
    }
    if (r.measure == "flippedAreas")
    {
        return 0;
    }
    if (r.measure == "kernelGradientSumMean" && r.set == "interface")
    {
        return 0.05;
    }

    return GREAT;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::SPH::meshQuality::report(Ostream& os) const
{
    label nFailed = 0;

    for (const row& r : rows_)
    {
        const scalar bound = limit(r);
        const bool lower =
            r.measure == "spacingMin" || r.measure == "faceDistanceMin";
        const bool good =
            lower ? r.value >= bound : mag(r.value) <= bound;

        os  << (good ? "    " : " ***") << text(r.measure)
            << " (" << r.set << ") = " << r.value;
        if (!good)
        {
            os  << ", limit " << bound;
            ++nFailed;
        }
        else if (bound < GREAT)
        {
            os  << " OK.";
        }
        os  << nl;
    }

    os  << nl;
    if (nFailed)
    {
        os  << "Failed " << nFailed << " particle mesh checks." << endl;
    }
    else
    {
        os  << "Particle mesh OK." << endl;
    }

    return nFailed;
}


void Foam::SPH::meshQuality::write(const fileName& file) const
{
    mkDir(file.path());
    OFstream os(file);
    os.precision(12);

    os  << "measure,set,value" << nl;
    for (const row& r : rows_)
    {
        os  << r.measure.c_str() << ',' << r.set.c_str() << ',' << r.value
            << nl;
    }

    if (!os.stdStream().flush())
    {
        FatalErrorInFunction
            << "Cannot write " << file << exit(FatalError);
    }
}


// ************************************************************************* //
