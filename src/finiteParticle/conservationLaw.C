/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "conservationLaw.H"
#include "compat.H"
#include "Switch.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    defineTypeNameAndDebug(conservationLaw, 0);
    defineRunTimeSelectionTable(conservationLaw, weaklyCompressible);
    defineRunTimeSelectionTable(conservationLaw, compressible);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::SPH::conservationLaw::setGeometry()
{
    const label nDims = loopDims(particles_);

    for (label i = 0; i < V_.size(); ++i)
    {
        const bool padding = i >= particles_.nParticles();
        V_[0][i] = padding ? 1 : particles_.V()[i];
        rSpacing_[0][i] = padding ? 0 : 1/particles_.spacing()[i];
    }

    vectorField residual(particles_.nParticles(), Zero);

    forAll(particles_.owner(), pairi)
    {
        const vector A(particles_.space().toLocal(particles_.Sf()[pairi]));
        const vector& delta = particles_.delta()[pairi];
        const scalar weight =
            mag(particles_.Sf()[pairi] & delta)/magSqr(delta);

        for (const bool atOwner : {true, false})
        {
            const label i =
                atOwner
              ? particles_.owner()[pairi]
              : particles_.neighbour()[pairi];
            if (i >= particles_.nParticles())
            {
                continue;
            }

            residual[i] += atOwner ? A : -A;
            diffusionWeight_[0][i] += weight;
            areaByVolume_[0][i] += mag(A)/V_[0][i];
        }
    }

    forAll(faces_.owners(), k)
    {
        const label i = faces_.owners()[k];
        for (const label facei : faces_.faces(k))
        {
            residual[i] += faces_.magSf()[facei]*faces_.n()[facei];
            areaByVolume_[0][i] += faces_.magSf()[facei]/V_[0][i];
            diffusionWeight_[0][i] +=
                2*faces_.magSf()[facei]/mag(faces_.distance()[facei]);
        }
    }

    // Sums of some twenty areas that close but for round-off and the
    // tolerance of an iterative closure
    constexpr scalar roundOff = 1e-11;

    closed_ = true;
    forAll(residual, i)
    {
        const scalar area = particles_.V()[i]/particles_.spacing()[i];
        if (mag(residual[i]) > roundOff*area)
        {
            closed_ = false;
        }
    }
    reduce(closed_, andOp<bool>());

    if (!closed_)
    {
        residualArea_ = slicedField(nDims, pairs_.nSlices());
        forAll(residual, i)
        {
            for (label d = 0; d < nDims; ++d)
            {
                residualArea_[d][i] = residual[i][d];
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::conservationLaw::conservationLaw
(
    const dictionary& schemes,
    faceStates& faces,
    const label nVariables,
    const scalar maxSkew
)
:
    particles_(faces.particles()),
    faces_(faces),
    pairs_(particles_, maxSkew),
    halo_(particles_),
    V_(1, pairs_.nSlices()),
    rSpacing_(1, pairs_.nSlices()),
    areaByVolume_(1, pairs_.nSlices()),
    diffusionWeight_(1, pairs_.nSlices()),
    residualArea_(0, 0),
    closed_(false),
    Q_(nVariables, pairs_.nSlices()),
    Q0_(nVariables, pairs_.nSlices()),
    Qp_(nVariables, 0),
    R0_(nVariables, 0),
    W_(nVariables, haloExchange::nSlices(particles_)),
    present_(0, 0),
    R_(nVariables, pairs_.nSlices()),
    force_(0, 0),
    sleeping_
    (
        faces, pairs_, schemes.getOrDefault<Switch>("sleeping", true)
    ),
    levels_(particles_, pairs_, halo_),
    nFallbacks_(0),
    nReduced_(0),
    failed_(particles_.nParticles(), false),
    firstOrder_(particles_.nParticles(), false),
    limits_(1, stepLimit{1, 0, 0}),
    sliceRates_(1, scalarList(pairs_.nSlices(), Zero)),
    sliceSums_(pairs_.nSlices(), Zero),
    meanAcoustic_(0),
    slicesCurrent_(false),
    limitsCurrent_(false),
    physical_(true)
{
    setGeometry();
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::SPH::conservationLaw> Foam::SPH::conservationLaw::New
(
    const dictionary& schemes,
    const weaklyCompressibleFluid& fluid,
    faceStates& faces
)
{
    const word scheme
    (
        schemes.getOrDefault<word>("fluxScheme", "linearisedLimited")
    );

    const auto cstrIter =
        weaklyCompressibleConstructorTablePtr_->cfind(scheme);

    if (!cstrIter.found())
    {
        FatalIOErrorInFunction(schemes)
            << "Unknown fluxScheme " << scheme << nl << nl
            << "Valid flux schemes of weakly compressible flow:" << nl
            << weaklyCompressibleConstructorTablePtr_->sortedToc()
            << exit(FatalIOError);
    }

    return cstrIter()(schemes, fluid, faces);
}


Foam::autoPtr<Foam::SPH::conservationLaw> Foam::SPH::conservationLaw::New
(
    const dictionary& schemes,
    const perfectGasFluid& fluid,
    faceStates& faces
)
{
    const bool papers =
        schemes.getOrDefault<word>("scheme", "none") == "papers";
    const word scheme
    (
        schemes.getOrDefault<word>
        (
            "fluxScheme", papers ? "HLLCLimited" : "Kurganov"
        )
    );

    const auto cstrIter = compressibleConstructorTablePtr_->cfind(scheme);

    if (!cstrIter.found())
    {
        FatalIOErrorInFunction(schemes)
            << "Unknown fluxScheme " << scheme << nl << nl
            << "Valid flux schemes of compressible flow:" << nl
            << compressibleConstructorTablePtr_->sortedToc()
            << exit(FatalIOError);
    }

    return cstrIter()(schemes, fluid, faces);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::SPH::conservationLaw::conserved
(
    const label v
) const
{
    return tmp<scalarField>::New(UList<scalar>
    (
        const_cast<scalar*>(Q_[v]), particles_.nParticles()
    ));
}


Foam::tmp<Foam::scalarField> Foam::SPH::conservationLaw::primitive
(
    const label v
) const
{
    return tmp<scalarField>::New(UList<scalar>
    (
        const_cast<scalar*>(W_[v]), particles_.nParticles()
    ));
}


void Foam::SPH::conservationLaw::info(Ostream& os) const
{
    os  << "    particles " << (closed_ ? "closed" : "not all closed")
        << nl;
}


Foam::label Foam::SPH::conservationLaw::nFallbacks()
{
    const label n = nReduced_;
    nReduced_ = 0;
    return n;
}


void Foam::SPH::conservationLaw::setForce(const vectorField& forceByVolume)
{
    const label nDims = loopDims(particles_);
    force_ = slicedField(nDims, pairs_.nSlices());
    forAll(forceByVolume, i)
    {
        for (label d = 0; d < nDims; ++d)
        {
            force_[d][i] =
                particles_.V()[i]*forceByVolume[i][particles_.space().axis(d)];
        }
    }
}


void Foam::SPH::conservationLaw::startSleeping()
{
    // Uniform flow changes where particles are not closed
    if (sleeping_.on() && closed_)
    {
        // To the last bit what a step without change gives
        store();
        restore();

        halo_.start(W_.components());
        halo_.finish(W_.components());
        sleeping_.start(W_);
    }
}


void Foam::SPH::conservationLaw::startSleeping(const scalarField& awake)
{
    if (sleeping_.on() && closed_)
    {
        boolList asleep(awake.size());
        forAll(asleep, i)
        {
            asleep[i] = awake[i] < 0.5;
        }
        sleeping_.start(asleep);
    }
}


bool Foam::SPH::conservationLaw::anyAsleep() const
{
    return sleeping_.anywhere();
}


Foam::tmp<Foam::scalarField> Foam::SPH::conservationLaw::awake() const
{
    tmp<scalarField> tawake(new scalarField(particles_.nParticles(), 1));
    scalarField& awake = tawake.ref();

    forAll(awake, i)
    {
        if (sleeping_.on() && sleeping_.isAsleep(i))
        {
            awake[i] = 0;
        }
    }
    return tawake;
}


void Foam::SPH::conservationLaw::store()
{
    Q0_ = Q_;
    failed_ = false;
}


bool Foam::SPH::conservationLaw::startSuperStep(const scalar bDt)
{
    Qp_ = Q0_;
    R0_ = R_;
    return update(0, bDt, 0, nVariables());
}


Foam::label Foam::SPH::conservationLaw::dropReconstruction()
{
    const label nBefore = firstOrders_.size();

    const auto drop = [&](const label i)
    {
        if (!firstOrder_[i])
        {
            firstOrder_[i] = true;
            firstOrders_.append(i);
        }
    };

    slicedField failed(1, haloExchange::nSlices(particles_));
    forAll(failed_, i)
    {
        failed[0][i] = failed_[i];
    }
    halo_.start(failed.components());
    halo_.finish(failed.components());

    for (label slice = 0; slice < pairs_.nSlices(); ++slice)
    {
        for (const pairSlices::rows& rows : pairs_.all(slice))
        {
            for (label e = rows.begin*nLanes; e < rows.end*nLanes; ++e)
            {
                const label i = slice*nLanes + e % nLanes;
                if (failed[0][i] + failed[0][rows.neighbour[e]] > 0)
                {
                    drop(i);
                }
            }
        }
    }
    failed_ = false;

    return returnReduce(firstOrders_.size() - nBefore, sumOp<label>());
}


void Foam::SPH::conservationLaw::resumeReconstruction()
{
    for (const label i : firstOrders_)
    {
        firstOrder_[i] = false;
    }
    firstOrders_.clear();
}


// ************************************************************************* //
