/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "fromMeshSpacing.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    defineTypeNameAndDebug(fromMeshSpacing, 0);
    addToRunTimeSelectionTable(spacingFunction, fromMeshSpacing, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::fromMeshSpacing::fromMeshSpacing
(
    const patchSurface& surface,
    const dictionary& dict
)
:
    space_(surface.space()),
    slope_(readGrowth(dict, 1.1) - 1),
    shifts_(shifts(surface))
{
    const polyMesh& mesh = surface.mesh();

    const scalar least(dict.getOrDefault<scalar>("min", 0));
    const scalar largest(dict.getOrDefault<scalar>("max", GREAT));
    const scalar scale(dict.getOrDefault<scalar>("scale", 1));

    if (least < 0 || largest < least || largest <= 0 || scale <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entries min " << least << ", max " << largest << " and scale "
            << scale << " must be positive, and min not above max"
            << exit(FatalIOError);
    }

    // Flat cells fill a narrow mesh, as those of one layer between symmetry
    // planes or cyclic patches, but one layer of particles says nothing across
    const vector low(space_.toLocal(mesh.bounds().min()));
    const vector high(space_.toLocal(mesh.bounds().max()));
    const scalar half =
        space_.nDims() == 3 ? 0.5*cmptMin(high - low) : GREAT;

    DynamicList<point> centres(mesh.nCells());
    DynamicList<scalar> sizes(mesh.nCells());
    forAll(mesh.cellVolumes(), celli)
    {
        // Bodies cut out of the mesh are cells of negative volume
        const scalar V = mesh.cellVolumes()[celli];
        if (V > 0)
        {
            centres.append(space_.toLocal(mesh.cellCentres()[celli]));
            sizes.append
            (
                Foam::min
                (
                    Foam::max(scale*space_.spacing(V), least),
                    Foam::min(largest, half)
                )
            );
        }
    }

    // A lattice of equal sites needs next to no relaxation
    if (Foam::max(sizes) < 1.01*Foam::min(sizes))
    {
        sizes = scalar(Foam::min(sizes));
    }

    setRange(Foam::min(sizes), Foam::max(sizes));
    tree_.reset
    (
        new growthTree
        (
            pointField(std::move(centres)),
            scalarField(std::move(sizes)),
            slope_
        )
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::SPH::fromMeshSpacing::operator()(const point& p) const
{
    const point x(space_.toLocal(p));

    scalar dp = max();
    for (const vector& shift : shifts_)
    {
        dp = tree_->evaluate(x + shift, dp);
    }

    return dp;
}


// ************************************************************************* //
