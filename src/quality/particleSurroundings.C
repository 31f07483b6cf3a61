/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleSurroundings.H"
#include "particlePairs.H"
#include "periodicImages.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::particleSurroundings::addPairs
(
    const kernel& W,
    const scalarField& smoothingRatios
)
{
    const label n = points_.size();
    const label d = W.nDims();
    const scalar cutOff = W.support(1)/W.smoothingRatio();

    scalarField volume(n);
    support_.setSize(n);
    forAll(support_, i)
    {
        volume[i] = kernel::integerPow(spacing_[i], d);
        support_[i] = cutOff*smoothingRatios[body_[i]]*spacing_[i];

        density_[i] = ownDensity_[i] =
            volume[i]*W.W(0, smoothingRatios[body_[i]]*spacing_[i]);
    }

    const particlePairs pairs(points_, support_, offsets_);

    // What i sees of j
    const auto see = [&](const label i, const label j, const vector& delta)
    {
        if (body_[i] > 0 && body_[i] != body_[j])
        {
            return;
        }

        // Two particles in one place exert no force on each other
        const scalar r = mag(delta) + VSMALL;
        const scalar hi = smoothingRatios[body_[i]]*spacing_[i];
        const scalar hj = smoothingRatios[body_[i]]*spacing_[j];
        const scalar VW = 0.5*volume[j]*(W.W(r, hi) + W.W(r, hj));

        gradientSum_[i] -=
            0.5*volume[j]*(W.dWdr(r, hi) + W.dWdr(r, hj))/r*delta;
        density_[i] += VW;
        if (body_[i] == body_[j])
        {
            ownDensity_[i] += VW;
        }
    };

    forAll(pairs.owner, pairi)
    {
        const label i = pairs.owner[pairi];
        const label j = pairs.neighbour[pairi];
        const vector& delta = pairs.delta[pairi];

        see(i, j, delta);
        see(j, i, -delta);

        const scalar distance =
            2*mag(delta)/(spacing_[i] + spacing_[j]);
        if (body_[i] == 0 && body_[j] == 0)
        {
            closestFluid_ = min(closestFluid_, distance);
        }
        else if (body_[i] == 0 || body_[j] == 0)
        {
            closestSolid_ = min(closestSolid_, distance);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::particleSurroundings::particleSurroundings
(
    const particleMesh& particles,
    const UList<particleSet>& solids
)
:
    nFluid_(particles.nParticles()),
    closestFluid_(GREAT),
    closestSolid_(GREAT)
{
    const solutionSpace& space = particles.space();

    DynamicList<vector> points(nFluid_);
    DynamicList<scalar> spacing(particles.spacing());
    DynamicList<label> body(labelList(nFluid_, Zero));
    scalarField smoothingRatios(solids.size() + 1);

    for (const point& p : particles.C())
    {
        points.append(space.toLocal(p));
    }
    smoothingRatios[0] = particles.W().smoothingRatio();

    forAll(solids, solidi)
    {
        for (const point& p : solids[solidi].points)
        {
            points.append(space.toLocal(p));
        }
        spacing.append(solids[solidi].spacing);
        body.append(labelList(solids[solidi].points.size(), solidi + 1));
        smoothingRatios[solidi + 1] = solids[solidi].smoothingRatio;
    }

    points_.transfer(points);
    spacing_.transfer(spacing);
    body_.transfer(body);

    vectorField translations(periodicTranslations(particles.mesh()));
    for (vector& T : translations)
    {
        T = space.toLocal(T);
    }
    offsets_ = imageOffsets(translations);

    gradientSum_ = vectorField(points_.size(), Zero);
    density_.setSize(points_.size());
    ownDensity_.setSize(points_.size());

    addPairs(particles.W(), smoothingRatios);
}


// ************************************************************************* //
