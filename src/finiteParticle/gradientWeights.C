/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "gradientWeights.H"
#include "bitSet.H"

#include <Eigen/Dense>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tensorField Foam::SPH::gradientWeights::pairMoments
(
    const particleMesh& particles
)
{
    tensorField M(particles.nParticles(), Zero);

    forAll(particles.owner(), pairi)
    {
        const tensor moment
        (
            0.5
           *particles.space().toLocal(particles.Sf()[pairi])
           *particles.space().toLocal(particles.delta()[pairi])
        );
        M[particles.owner()[pairi]] += moment;
        if (particles.neighbour()[pairi] < M.size())
        {
            M[particles.neighbour()[pairi]] += moment;
        }
    }

    return M;
}


bool Foam::SPH::gradientWeights::invert
(
    const tensor& M,
    const label nDims,
    tensor& inv
)
{
    // Of the volume of a particle, moments of a direction with neighbours on
    // one side only are still a third or more
    constexpr scalar resolved = 0.05;

    // Directions not solved get the scale of the others
    Eigen::Matrix3d m(mag(M)*Eigen::Matrix3d::Identity());
    for (label a = 0; a < nDims; ++a)
    {
        for (label b = 0; b < nDims; ++b)
        {
            m(a, b) = M(a, b);
        }
    }

    Eigen::JacobiSVD<Eigen::Matrix3d> svd
    (
        m,
        Eigen::ComputeFullU | Eigen::ComputeFullV
    );
    svd.setThreshold(resolved);

    const Eigen::Matrix3d pseudoInverse
    (
        svd.solve(Eigen::Matrix3d::Identity())
    );

    inv = Zero;
    for (label a = 0; a < nDims; ++a)
    {
        for (label b = 0; b < nDims; ++b)
        {
            inv(a, b) = pseudoInverse(a, b);
        }
    }

    return svd.rank() == 3;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::gradientWeights::gradientWeights(const faceStates& faces)
:
    group_(faces.nVariables()),
    nDeficient_(0)
{
    const particleMesh& particles = faces.particles();
    const label nDims = loopDims(particles);
    const tensorField moments(pairMoments(particles));

    DynamicList<bitSet> members;

    forAll(group_, variable)
    {
        bitSet isFixed(faces.size());
        forAll(faces, facei)
        {
            isFixed.set(facei, faces.fixed(variable, facei));
        }

        group_[variable] = members.find(isFixed);
        if (group_[variable] < 0)
        {
            group_[variable] = members.size();
            members.append(isFixed);
        }
    }

    labelList nDeficient(members.size(), Zero);
    forAll(members, groupi)
    {
        tensorField M(moments);
        for (const label facei : members[groupi])
        {
            // What is mirrored has no difference along the plane, wherever on
            // it the centre of the face is
            const vector& n = faces.n()[facei];
            const vector& r = faces.relative()[facei];
            M[particles.boundary().faces().owner[facei]] +=
                faces.magSf()[facei]*n
               *(faces.type(facei) == faceStates::slip ? n*(n & r) : r);
        }

        B_.append
        (
            new slicedField
            (
                nDims*nDims, slicedField::slices(particles.nParticles())
            )
        );

        forAll(M, i)
        {
            tensor inv;
            if (!invert(M[i], nDims, inv))
            {
                ++nDeficient[groupi];
            }
            for (label a = 0; a < nDims; ++a)
            {
                for (label b = 0; b < nDims; ++b)
                {
                    B_.last()[a*nDims + b][i] = inv(a, b);
                }
            }
        }
    }

    // Ranks may group the variables in other ways
    for (const label groupi : group_)
    {
        nDeficient_ = max
        (
            nDeficient_, returnReduce(nDeficient[groupi], sumOp<label>())
        );
    }
}


// ************************************************************************* //
