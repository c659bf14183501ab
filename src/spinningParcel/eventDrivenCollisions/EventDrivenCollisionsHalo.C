/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "EventDrivenCollisions.H"

#include <cstring>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class CloudType>
impact::sweptBox Foam::EventDrivenCollisions<CloudType>::boxOf
(
    const Path& path,
    const scalar r
) const
{
    impact::sweptBox box;
    for (int k = 0; k < 3; ++k)
    {
        path.range(k, 0, deltaT_, box.low[k], box.high[k]);
        box.low[k] -= r;
        box.high[k] += r;
    }
    return box;
}


template<class CloudType>
bool Foam::EventDrivenCollisions<CloudType>::meetsOthers
(
    const impact::sweptBox& box
) const
{
    return box.extent() > reach_ || territories_->foreign(box);
}


template<class CloudType>
bool Foam::EventDrivenCollisions<CloudType>::mayMeet
(
    const impact::sweptBox& box
) const
{
    return
        box.extent() > reach_
     || territories_->near(Pstream::myProcNo(), box);
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::write
(
    post& out,
    const label rank,
    const request& n
)
{
    rankMail::append(out[rank], n);
    out[rank].append(buffer_, 0, n.bufferSize);
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::passOn
(
    flight& f,
    const label slot,
    const leg& home,
    const mission& m,
    post& out
)
{
    response packed{slot, m};
    pack(f, packed, false);
    request n{RECEIVE, 0, packed.m};
    n.patch = packed.toPatch;
    n.bufferSize = packed.bufferSize;
    n.home = home;
    n.next = {Pstream::myProcNo(), slot};
    write(out, packed.toRank, n);
    ++report_.handOvers;
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::read(const request& n, post& out)
{
    switch (n.kind)
    {
        case RECEIVE:
        {
            unpack(n);
            const label slot = label(flights_.size()) - 1;
            request link{LINK, n.next.slot, n.m};
            link.next = {Pstream::myProcNo(), slot};
            write(out, n.next.rank, link);
            mission m = n.m;
            flight& f = flights_[slot];
            if (plan(f, m))
            {
                write(out, n.home.rank, request{PASS, n.home.slot, m});
            }
            else
            {
                passOn(f, slot, n.home, m, out);
            }
            return;
        }

        case LINK:
            flights_[n.slot].next = n.next;
            return;

        case PASS:
            adoptPlan(at(n.slot), n.m);
            return;

        default:                    // COMMIT
            commit(n.slot, n.m.keep, out);
    }
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::deliver(post& out)
{
    while (rankMail::any(out))
    {
        for (const std::string& bytes : rankMail::exchange(out))
        {
            for (std::size_t at = 0; at < bytes.size();)
            {
                request n{LINK, 0, {PLAN, 0}};
                std::memcpy(static_cast<void*>(&n), &bytes[at], sizeof(n));
                at += sizeof(n);
                buffer_.assign(bytes, at, n.bufferSize);
                at += n.bufferSize;
                read(n, out);
            }
        }
    }
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::handOn()
{
    post out(Pstream::nProcs());
    for (std::size_t i = 0; i < freeMotions_.size(); ++i)
    {
        const trajectory* c = known(i);
        if (c && c->handedOn)
        {
            mission m{PLAN, 0};
            m.begun = true;
            m.path = c->path;
            m.end = deltaT_;
            passOn
            (
                flights_[c->home.slot], c->home.slot,
                {Pstream::myProcNo(), label(i)}, m, out
            );
        }
    }
    deliver(out);
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::makeHalo()
{
    const std::int32_t own = freeMotions_.size();
    reach_ = 0;
    for (std::int32_t i = 0; i < own; ++i)
    {
        reach_ = max(reach_, step_.swept(i).extent());
    }
    reduce(reach_, maxOp<scalar>());
    territories_->setReach(reach_);

    sharedAt_.clear();
    news_.clear();
    stopped_.clear();
    post out(Pstream::nProcs());
    const auto farAway = [&](const std::int32_t i)
    {
        return
            !known(i)
         && !territories_->foreignFrom
            (
                cloud_.cells().meshCell(begin_.cell[i])
            );
    };
    for (std::int32_t i = 0; i < own; ++i)
    {
        if (farAway(i))
        {
            continue;
        }
        const impact::sweptBox b(step_.swept(i));
        if (!meetsOthers(b))
        {
            continue;
        }
        trajectory& c = at(i);
        c.shared = true;
        step_.take(i);
        sharedAt_[c.identity] = i;
        for (label rank = 0; rank < Pstream::nProcs(); ++rank)
        {
            if (rank != Pstream::myProcNo() && territories_->near(rank, b))
            {
                rankMail::append(out[rank], c);
            }
        }
    }
    std::vector<trajectory> halo;
    for (const std::string& bytes : rankMail::exchange(out))
    {
        rankMail::take(bytes, halo);
    }
    for (const trajectory& c : halo)
    {
        sharedAt_[c.identity] = addOther(c);
    }
    work_[0] = own;
    work_[1] = halo.size();
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::commit
(
    const label slot,
    const bool keep,
    post& out
)
{
    mission m{PLAN, deltaT_};
    m.keep = keep;
    const response done = answer(request{COMMIT, slot, m});
    if (done.next.rank < 0)
    {
        settleHere(flights_[slot]);
        return;
    }
    m.keep = done.m.keep;
    write(out, done.next.rank, request{COMMIT, done.next.slot, m});
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::commitAll()
{
    post out(Pstream::nProcs());
    for (const trajectory& c : trajectories_)
    {
        if
        (
            c.home.rank == Pstream::myProcNo()
         && c.handedOn && !c.resting && !c.gone
        )
        {
            commit(c.home.slot, true, out);
        }
    }
    deliver(out);
}
