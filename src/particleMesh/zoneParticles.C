/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "zoneParticles.H"
#include "boundaryFaceList.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::autoPtr<Foam::SPH::particleMesh> Foam::SPH::zoneParticles
(
    const particleZone& zone,
    const particleMesh& all,
    const labelUList& cellMap
)
{
    DynamicList<label> cells(cellMap.size());
    labelList particle(cellMap.size(), -1);
    forAll(cellMap, celli)
    {
        if (cellMap[celli] < 0)
        {
            particle[celli] = cells.size();
            cells.append(celli);
        }
    }

    particleMeshData data;
    data.points = pointField(all.C(), cells);
    data.V = scalarField(all.V(), cells);
    data.spacing = scalarField(all.spacing(), cells);

    const boundaryFaces& from = all.boundary().faces();
    boundaryFaceList faces;
    for (label patchi = 0; patchi < zone.borderPatch(); ++patchi)
    {
        for (label s = from.start[patchi]; s < from.start[patchi + 1]; ++s)
        {
            if (particle[from.owner[s]] >= 0)
            {
                faces.append
                (
                    particle[from.owner[s]],
                    from.Sf[s],
                    from.Cf[s],
                    from.distance[s],
                    from.face[s]
                );
            }
        }
        faces.endPatch();
    }

    DynamicList<label> pairs(all.nPairs());
    forAll(all.owner(), pairi)
    {
        const label i = all.owner()[pairi];
        const label j = all.neighbour()[pairi];
        if (particle[i] >= 0 && particle[j] >= 0)
        {
            pairs.append(pairi);
        }
        else if (particle[i] >= 0 || particle[j] >= 0)
        {
            // To the outside, from the particle
            const bool ownerInside = particle[i] >= 0;
            const scalar sign = ownerInside ? 1 : -1;
            const label celli = ownerInside ? i : j;
            const vector Sf(sign*all.Sf()[pairi]);
            const vector r(0.5*sign*all.delta()[pairi] + all.skew()[pairi]);

            faces.append
            (
                particle[celli], Sf, all.C()[celli] + r, (r & Sf)/mag(Sf), -1
            );
        }
    }
    faces.endPatch();
    data.boundary = faces.faces();

    data.owner = labelList(UIndirectList<label>(all.owner(), pairs));
    data.neighbour = labelList(UIndirectList<label>(all.neighbour(), pairs));
    inplaceRenumber(particle, data.owner);
    inplaceRenumber(particle, data.neighbour);
    data.Sf = vectorField(all.Sf(), pairs);
    data.delta = vectorField(all.delta(), pairs);
    data.skew = vectorField(all.skew(), pairs);

    return autoPtr<particleMesh>
    (
        new particleMesh(zone.mesh(), all.properties(), std::move(data))
    );
}


// ************************************************************************* //
