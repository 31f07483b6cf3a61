/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleSystem.H"
#include "periodicImages.H"
#include "DynamicList.H"
#include "SubField.H"
#include "boundBox.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::particleSystem::setSize(const label n)
{
    for (scalarField& c : x)
    {
        c.setSize(n, Zero);
    }
    spacing.setSize(n);
    V.setSize(n);
    role.setSize(n);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::particleSystem::particleSystem
(
    const label nDims,
    const label nBodies,
    const List<vector>& translations
)
:
    nDims_(nDims),
    nBodies_(nBodies),
    translations_(translations)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vectorField Foam::SPH::particleSystem::positions() const
{
    vectorField points(size());

    #pragma omp parallel for
    for (label i = 0; i < size(); ++i)
    {
        points[i] = position(i);
    }

    return points;
}


void Foam::SPH::particleSystem::setParticles
(
    const UList<vector>& points,
    const UList<scalar>& spacings,
    const UList<label>& bodies,
    const UList<scalar>& distances,
    const UList<bool>& isRegular
)
{
    const label n = points.size();
    const label nFixed = nOriginals_ - nParticles_;

    // Fixed points follow the particles
    vectorField fixedPoints(nFixed);
    const scalarField fixedSpacing
    (
        SubField<scalar>(spacing, nFixed, nParticles_)
    );
    const scalarField fixedV(SubField<scalar>(V, nFixed, nParticles_));
    const labelList fixedRole(SubList<label>(role, nFixed, nParticles_));
    forAll(fixedPoints, k)
    {
        fixedPoints[k] = position(nParticles_ + k);
    }

    nParticles_ = n;
    nOriginals_ = n + nFixed;
    imageOrigin_.clear();
    imageOffset_.clear();
    setSize(nOriginals_);

    forAll(points, i)
    {
        setPosition(i, points[i]);
        setSpacing(i, spacings[i]);
        role[i] = bodies[i];
    }
    forAll(fixedPoints, k)
    {
        setPosition(n + k, fixedPoints[k]);
        spacing[n + k] = fixedSpacing[k];
        V[n + k] = fixedV[k];
        role[n + k] = fixedRole[k];
    }

    phi = distances;
    drift.setSize(n);
    drift = Zero;
    regular = isRegular;
    active.setSize(n);
    forAll(active, i)
    {
        active[i] = !regular[i];
    }
}


void Foam::SPH::particleSystem::setFixedPoints
(
    const UList<vector>& points,
    const UList<scalar>& spacings,
    const UList<scalar>& volumes,
    const UList<label>& bodies
)
{
    const label n = nParticles_;

    nOriginals_ = n + points.size();
    imageOrigin_.clear();
    imageOffset_.clear();
    setSize(nOriginals_);

    forAll(points, k)
    {
        setPosition(n + k, points[k]);
        spacing[n + k] = spacings[k];
        V[n + k] = volumes[k];
        role[n + k] = nBodies_ + bodies[k];
    }
}


void Foam::SPH::particleSystem::makeImages
(
    const vector& low,
    const vector& high,
    const scalar distance
)
{
    setSize(nOriginals_);
    imageOrigin_.clear();
    imageOffset_.clear();

    if (translations_.empty())
    {
        return;
    }

    for (label i = 0; i < nParticles_; ++i)
    {
        vector p(position(i));
        for (const vector& T : translations_)
        {
            const vector e(T/magSqr(T));
            p -= T*floor((p - low) & e);
        }
        setPosition(i, p);
    }

    const vector margin(vector::one*distance);
    const boundBox near(low - margin, high + margin);

    DynamicList<label> origins;
    DynamicList<vector> offsets;
    for (const vector& offset : imageOffsets(translations_))
    {
        for (label i = 0; i < nOriginals_; ++i)
        {
            if (near.contains(position(i) + offset))
            {
                origins.append(i);
                offsets.append(offset);
            }
        }
    }
    imageOrigin_.transfer(origins);
    imageOffset_.transfer(offsets);

    setSize(nOriginals_ + imageOrigin_.size());
    forAll(imageOrigin_, k)
    {
        const label i = imageOrigin_[k];
        spacing[nOriginals_ + k] = spacing[i];
        V[nOriginals_ + k] = V[i];
        role[nOriginals_ + k] = role[i];
    }
    updateImages();
}


void Foam::SPH::particleSystem::updateImages()
{
    forAll(imageOrigin_, k)
    {
        setPosition
        (
            nOriginals_ + k,
            position(imageOrigin_[k]) + imageOffset_[k]
        );
    }
}


// ************************************************************************* //
