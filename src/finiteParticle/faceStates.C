/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "faceStates.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::faceStates::faceStates
(
    const particleMesh& particles,
    const label nVariables
)
:
    particles_(particles),
    treatment_(particles.boundary().nFaces(), open),
    value_(nVariables),
    own_(nVariables),
    fixed_(nVariables),
    given_(nVariables),
    n_(treatment_.size()),
    relative_(treatment_.size()),
    magSf_(treatment_.size()),
    wallNormal_(particles.boundary().faces().wallNormal.size()),
    pressureForce_(treatment_.size(), Zero),
    viscousForce_(treatment_.size(), Zero),
    massFlux_(treatment_.size(), Zero)
{
    const boundaryFaces& faces = particles.boundary().faces();

    forAll(value_, variable)
    {
        value_[variable].setSize(treatment_.size(), Zero);
        own_[variable].setSize(treatment_.size(), false);
        fixed_[variable].setSize(treatment_.size(), false);
        given_[variable].setSize(treatment_.size(), false);
    }

    forAll(n_, facei)
    {
        const vector A(particles.space().toLocal(faces.Sf[facei]));
        magSf_[facei] = mag(A);
        n_[facei] = A/max(magSf_[facei], ROOTVSMALL);
        relative_[facei] = particles.space().toLocal
        (
            faces.Cf[facei] - particles.C()[faces.owner[facei]]
        );
    }

    forAll(wallNormal_, facei)
    {
        wallNormal_[facei] =
            particles.space().toLocal(faces.wallNormal[facei]);
    }

    labelList nFaces(particles.nParticles(), Zero);
    for (const label i : faces.owner)
    {
        ++nFaces[i];
    }

    labelList index(particles.nParticles(), -1);
    DynamicList<label> owners(faces.owner.size());
    DynamicList<label> start(faces.owner.size() + 1);
    start.append(0);
    forAll(nFaces, i)
    {
        if (nFaces[i])
        {
            index[i] = owners.size();
            owners.append(i);
            start.append(start.last() + nFaces[i]);
        }
    }
    owners_.transfer(owners);
    start_.transfer(start);

    faces_.setSize(faces.owner.size());
    labelList next(start_);
    forAll(faces.owner, facei)
    {
        faces_[next[index[faces.owner[facei]]]++] = facei;
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarList Foam::SPH::faceStates::meanLags() const
{
    const label nDims = loopDims(particles_);
    const polyBoundaryMesh& patches = particles_.mesh().boundaryMesh();

    // Areas and lags over pressure and velocity of sound are summed in whole
    // multiples of a small unit, which are exact: so ranks do not change them
    constexpr scalar largestExact = 1e15;
    const scalar unit =
        max(returnReduce(size(), sumOp<label>()), 1)/largestExact;
    const scalar largestArea = gMax(magSf_);
    const scalar scale[2] = {sqr(followSpeed_), followSpeed_};

    scalarList areas(2*patches.nNonProcessor(), Zero);
    scalarList lags(areas.size(), Zero);
    for (const particlePatch& patch : particles_.boundary())
    {
        for (label facei = patch.start(); facei < patch.start() + patch.size();
            ++facei)
        {
            const auto lag = [&](const label v)
            {
                return target_[v*size() + facei] - followed_[v*size() + facei];
            };
            scalar lagging[2] = {lag(0), 0};
            for (label d = 0; d < nDims; ++d)
            {
                lagging[1] += lag(1 + d)*n_[facei][d];
            }

            const scalar area = magSf_[facei]/(largestArea*unit);
            for (label v = 0; v < 2 && !reflects(facei); ++v)
            {
                if (!given_[v][facei])
                {
                    const label k = 2*patch.index() + v;
                    areas[k] += std::round(area);
                    lags[k] += std::round(area*lagging[v]/scale[v]);
                }
            }
        }
    }
    Pstream::listCombineGather(areas, plusEqOp<scalar>());
    Pstream::listCombineGather(lags, plusEqOp<scalar>());
    Pstream::listCombineScatter(areas);
    Pstream::listCombineScatter(lags);

    forAll(lags, k)
    {
        lags[k] *= scale[k % 2]/max(areas[k], scalar(1));
    }
    return lags;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::faceStates::startFollowing
(
    const scalar tau,
    const scalar c,
    const slicedField& W
)
{
    followTime_ = 0;
    followSpeed_ = c;
    target_.setSize(nVariables()*size());

    scalarField L(nVariables());
    scalarField outer(nVariables());
    for (label facei = 0; facei < size(); ++facei)
    {
        const label i = particles_.boundary().faces().owner[facei];
        for (label variable = 0; variable < nVariables(); ++variable)
        {
            L[variable] = W[variable][i];
            outer[variable] =
                own_[variable][facei] ? L[variable] : value_[variable][facei];
        }
        complete(L, outer, facei);
    }
    followTime_ = tau;
    followed_ = target_;
}


void Foam::SPH::faceStates::follow(const scalar dt)
{
    if (followTime_ <= 0)
    {
        return;
    }

    const scalarList lags(meanLags());
    const scalar remaining = std::exp(-0.5*dt/followTime_);
    const label nDims = loopDims(particles_);
    for (const particlePatch& patch : particles_.boundary())
    {
        for (label k = 0; k < patch.size(); ++k)
        {
            const label facei = patch.start() + k;
            const scalar* lag = &lags[2*patch.index()];
            for (label v = 0; v <= nDims; ++v)
            {
                followed_[v*size() + facei] =
                    target_[v*size() + facei]
                  - remaining*(v ? lag[1]*n_[facei][v - 1] : lag[0]);
            }
        }
    }
}


// ************************************************************************* //
