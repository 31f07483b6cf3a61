/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "haloExchange.H"
#include "UIPstream.H"
#include "UOPstream.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::haloExchange::haloExchange(const particleMesh& particles)
:
    firstRequest_(0)
{
    if (!Pstream::parRun())
    {
        return;
    }

    // A pair has its particles in each other's halo: to whom a rank sends,
    // from them it receives
    DynamicList<neighbourRank> ranks;
    for (label rank = 0; rank < Pstream::nProcs(); ++rank)
    {
        const labelList& wanted = particles.halo().subMap()[rank];
        if (rank != Pstream::myProcNo() && wanted.size())
        {
            labelList halo(particles.halo().constructMap()[rank]);
            for (label& i : halo)
            {
                i = index(particles, i);
            }
            ranks.append(neighbourRank{int(rank), wanted, halo, {}, {}});
        }
    }
    ranks_.transfer(ranks);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::haloExchange::start(const std::vector<scalar*>& arrays)
{
    const label nArrays = arrays.size();
    firstRequest_ = UPstream::nRequests();

    for (neighbourRank& other : ranks_)
    {
        other.received.setSize(nArrays*other.halo.size());
        UIPstream::read
        (
            UPstream::commsTypes::nonBlocking,
            other.rank,
            reinterpret_cast<char*>(other.received.data()),
            other.received.size()*sizeof(scalar)
        );
    }

    for (neighbourRank& other : ranks_)
    {
        const label n = other.wanted.size();
        other.toSend.setSize(nArrays*n);
        for (label c = 0; c < nArrays; ++c)
        {
            const scalar* values = arrays[c];
            scalar* sent = other.toSend.data() + c*n;
            for (label k = 0; k < n; ++k)
            {
                sent[k] = values[other.wanted[k]];
            }
        }
        UOPstream::write
        (
            UPstream::commsTypes::nonBlocking,
            other.rank,
            reinterpret_cast<const char*>(other.toSend.cdata()),
            other.toSend.size()*sizeof(scalar)
        );
    }
}


void Foam::SPH::haloExchange::finish(const std::vector<scalar*>& arrays)
{
    if (ranks_.size())
    {
        UPstream::waitRequests(firstRequest_);
    }

    for (const neighbourRank& other : ranks_)
    {
        const label n = other.halo.size();
        for (label c = 0; c < label(arrays.size()); ++c)
        {
            scalar* values = arrays[c];
            const scalar* received = other.received.cdata() + c*n;
            for (label k = 0; k < n; ++k)
            {
                values[other.halo[k]] = received[k];
            }
        }
    }
}


// ************************************************************************* //
