/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "fieldNorms.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"

#include <limits>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::fieldNorms::addComponent
(
    const word& field,
    const word& component,
    const scalarField& V,
    const scalarField& difference,
    const scalarField& reference,
    const scalar size
)
{
    // Of the whole: what solvers leave of a component that is zero
    constexpr scalar roundOff = 1e-12;

    const scalar lowest = gMin(reference);
    const scalar highest = gMax(reference);
    const scalar range = highest - lowest;
    const scalar magnitude = max(mag(lowest), mag(highest));
    const bool none = magnitude <= roundOff*size;
    const scalar scale =
        none ? size : range > SMALL*magnitude ? range : magnitude;

    const scalarField d(mag(difference));
    const scalar volume = gSum(V);
    const scalar referenceL2 =
        none ? size : sqrt(gSum(V*sqr(reference))/volume);

    const auto over = [](const scalar absolute, const scalar by)
    {
        return
            absolute == 0 ? 0
          : by > VSMALL ? absolute/by
          : std::numeric_limits<scalar>::infinity();
    };

    const auto append = [&](const word& name, const scalar absolute)
    {
        norms_.append
        (
            norm
            {
                field,
                component,
                name,
                absolute,
                over(absolute, scale),
                range,
                over(absolute, referenceL2)
            }
        );
    };

    append("L1", gSum(V*d)/volume);
    append("L2", sqrt(gSum(V*sqr(d))/volume));
    append("Linf", gMax(d));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::fieldNorms::write(const fileName& file) const
{
    if (!Pstream::master())
    {
        return;
    }

    mkDir(file.path());
    OFstream os(file);
    os.precision(8);

    os  << "field,component,norm,absolute,relative,reference_range,relative_l2"
        << nl;
    for (const norm& n : norms_)
    {
        os  << n.field.c_str() << ',' << n.component.c_str() << ','
            << n.name.c_str() << ',' << n.absolute << ',' << n.relative
            << ',' << n.range << ',' << n.relativeL2 << nl;
    }

    if (!os.stdStream().flush())
    {
        FatalErrorInFunction
            << "Cannot write " << file << exit(FatalError);
    }
}

// ************************************************************************* //
