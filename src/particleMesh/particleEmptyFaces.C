/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    Faces of the empty patches of particles in one and two dimensions.

\*---------------------------------------------------------------------------*/

#include "particleFaces.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::particleFaces::emptyFaces
(
    scalarField& scale,
    vectorField& shift
) const
{
    const label n = data_.points.size();
    const label nEmpty = emptySides_.size();
    const scalar m = 0.5*nEmpty;

    // Sums over the other faces of each particle
    scalarField nFaces(n, Zero);
    vectorField sumR(n, Zero);
    vectorField sumA(n, Zero);
    scalarField sumAR(n, Zero);
    vectorField sumARR(n, Zero);
    tensorField sumAoR(n, Zero);

    const auto add = [&](const label i, const vector& A, const vector& r)
    {
        nFaces[i] += 1;
        sumR[i] += r;
        sumA[i] += A;
        sumAR[i] += A & r;
        sumARR[i] += (A & r)*r;
        sumAoR[i] += A*r;
    };

    forAll(data_.owner, pairi)
    {
        const label i = data_.owner[pairi];
        if (!kept(i, data_.Sf[pairi]))
        {
            continue;
        }
        const vector half(0.5*data_.delta[pairi]);
        const vector skew
        (
            data_.skew.size() ? data_.skew[pairi] : vector::zero
        );
        add(i, data_.Sf[pairi], half + skew);
        add(data_.neighbour[pairi], -data_.Sf[pairi], skew - half);
    }
    for (const patchFaces& patch : patches_)
    {
        forAll(patch.face, k)
        {
            if (!patch.dict.found("neighbourPatch"))
            {
                const label i = patch.owner[k];
                add(i, patch.Sf[k], patch.Cf[k] - data_.points[i]);
            }
        }
    }

    // The formulae of primitiveMesh for estimated centre e, volume and centre
    constexpr label maxIterations = 200;
    scale.setSize(n);
    shift.setSize(n);
    forAll(scale, i)
    {
        const scalar V = data_.V[i];
        vector s(Zero);
        scalar f = 1;
        for (label iter = 0; iter < maxIterations; ++iter)
        {
            const vector e((sumR[i] + nEmpty*s)/(nFaces[i] + nEmpty));
            const scalar volume3 = sumAR[i] - (sumA[i] & e);
            const vector moment
            (
                0.75*(sumARR[i] - (e & sumAoR[i])) + 0.25*volume3*e
            );
            f = (3*V - volume3)/(m*V);
            const vector next(-(moment/(0.75*m*f*V) + e/3));
            const scalar change = mag(next - s);
            s = next;
            if (change < 1e-16*data_.spacing[i])
            {
                break;
            }
        }
        scale[i] = f;
        shift[i] = s;
    }
}


void Foam::SPH::particleFaces::addEmptyFaces()
{
    if (emptySides_.empty())
    {
        return;
    }

    scalarField scale;
    vectorField shift;
    emptyFaces(scale, shift);

    forAll(emptySides_, k)
    {
        patchFaces& patch = patches_[emptyPatches_[k]];
        const vector& side = emptySides_[k];
        const scalar extent = mag(emptyEdges_[k]);

        forAll(scale, i)
        {
            patch.owner.append(i);
            patch.face.append(-1);
            patch.Sf.append(scale[i]*data_.V[i]/extent*side);
            patch.Cf.append
            (
                data_.points[i] + shift[i] + 0.5*extent*side
            );
        }
    }
}


// ************************************************************************* //
