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

void Foam::SPH::haloExchange::start(const slicedField& field)
{
    const label nComponents = field.nComponents();
    firstRequest_ = UPstream::nRequests();

    for (neighbourRank& other : ranks_)
    {
        other.received.setSize(nComponents*other.halo.size());
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
        other.toSend.setSize(nComponents*n);
        for (label c = 0; c < nComponents; ++c)
        {
            const scalar* values = field[c];
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


void Foam::SPH::haloExchange::finish(slicedField& field)
{
    if (ranks_.size())
    {
        UPstream::waitRequests(firstRequest_);
    }

    for (const neighbourRank& other : ranks_)
    {
        const label n = other.halo.size();
        for (label c = 0; c < field.nComponents(); ++c)
        {
            scalar* values = field[c];
            const scalar* received = other.received.cdata() + c*n;
            for (label k = 0; k < n; ++k)
            {
                values[other.halo[k]] = received[k];
            }
        }
    }
}


// ************************************************************************* //
