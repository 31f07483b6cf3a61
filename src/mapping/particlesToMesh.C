/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particlesToMesh.H"
#include "cellSpacing.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::particlesToMesh::particlesToMesh
(
    const fvMesh& mesh,
    const particleResults& particles
)
:
    mesh_(mesh),
    particles_(particles),
    cells_
    (
        solutionSpace(mesh),
        {particles.mesh().cellCentres(), particles.spacing()},
        {mesh.cellCentres(), cellSpacing(solutionSpace(mesh), mesh)}
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::SPH::particlesToMesh::write(const wordRes& names) const
{
    const Time& runTime = mesh_.time();
    return write(names, instant(runTime.value(), runTime.timeName()), false);
}


Foam::label Foam::SPH::particlesToMesh::write
(
    const wordRes& names,
    const instant& from,
    const bool newer
) const
{
    const Time& runTime = mesh_.time();
    const IOobjectList fields(particles_.fields(from));

    label nMapped = 0;
    for (const word& name : fields.sortedNames())
    {
        const IOobject& io = *fields[name];
        const fileName mapped
        (
            runTime.timePath()/particleResults::volName(name)
        );

        if
        (
            (names.size() && !names.match(name))
         || name.ends_with("_0")
         || (newer && highResLastModified(mapped)
           > highResLastModified(io.objectPath()))
        )
        {
            continue;
        }

        if
        (
            mapType<scalar>(io)
         || mapType<vector>(io)
         || mapType<sphericalTensor>(io)
         || mapType<symmTensor>(io)
         || mapType<tensor>(io)
        )
        {
            ++nMapped;
        }
    }
    return nMapped;
}


// ************************************************************************* //
