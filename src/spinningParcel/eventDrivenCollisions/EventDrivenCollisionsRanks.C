/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "EventDrivenCollisions.H"
#include "StringStream.H"
#include "globalMeshData.H"
#include "processorCyclicPolyPatch.H"
#include "wallPolyPatch.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::setPasses()
{
    if (!Pstream::parRun())
    {
        return;
    }
    const polyMesh& mesh = cloud_.mesh();
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    const globalMeshData& data = mesh.globalData();
    passTo_.setSize(patches.size(), -1);
    passPatch_.setSize(patches.size(), -1);
    exchangeTo_.setSize(patches.size(), -1);
    forAll(patches, i)
    {
        if (isA<processorPolyPatch>(patches[i]))
        {
            exchangeTo_[i] =
                refCast<const processorPolyPatch>(patches[i]).neighbProcNo();
            passPatch_[i] = data.processorPatchNeighbours()[i];
            if (!isA<processorCyclicPolyPatch>(patches[i]))
            {
                passTo_[i] = exchangeTo_[i];
            }
        }
    }
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::drop(flight& f)
{
    if (f.ghost)
    {
        delete f.parcel;
    }
    else
    {
        cloud_.deleteParticle(*f.parcel);
    }
    f.parcel = nullptr;
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::settleHere(flight& f)
{
    if (f.ghost)
    {
        cloud_.objects().append(f.parcel);
        f.ghost = false;
    }
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::pack
(
    flight& f,
    response& r,
    const bool take
)
{
    parcelType& p = *f.parcel;
    const label patch = p.patch();
    r.toRank = exchangeTo_[patch];
    r.toPatch = passPatch_[patch];
    ++r.m.crossings;
    r.m.keep = f.keep;

    const typename parcelType::place here(p);
    p.prepareForParallelTransfer();
    OStringStream os(IOstream::BINARY);
    os << p;
    buffer_ = os.str();
    r.bufferSize = buffer_.size();
    here.restore(p);
    if (!take)
    {
        return;
    }
    drop(f);
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::unpack(const request& r)
{
    const polyMesh& mesh = cloud_.mesh();
    IStringStream is(buffer_, IOstream::BINARY);
    autoPtr<parcelType> received(new parcelType(mesh, is, true));
    received->correctAfterParallelTransfer
        (mesh.globalData().processorPatches()[r.patch], *td_);
    parcelType& p = *received.ptr();
    flights_.emplace_back(p);
    flight& f = flights_.back();
    f.ghost = !takesParcel(r.m) && r.m.begun;
    f.keep = r.m.keep;
    f.injected = r.m.injected;
    if (!f.ghost)
    {
        cloud_.objects().append(&p);
    }
}


template<class CloudType>
typename Foam::EventDrivenCollisions<CloudType>::response
Foam::EventDrivenCollisions<CloudType>::answer(const request& r)
{
    response out{r.slot, r.m};
    if (r.kind == RECEIVE)
    {
        unpack(r);
        out.slot = label(flights_.size()) - 1;
    }
    flight& f = flightAt(out.slot);
    bool done = true;
    bool take = false;
    switch (r.kind)
    {
        case MOVE:
        case RECEIVE:
            done = proceed(f, out.m);
            break;

        case PASS:
            done = false;
            break;

        case LINK:
            f.next = r.next;
            return out;

        case COMMIT:
            f.keep = f.keep && r.m.keep;
            out.m.keep = f.keep;
            out.next = f.next;
            if (f.next.rank >= 0)
            {
                if (f.keep)
                {
                    act(f);
                }
                drop(f);
            }
            return out;

        case REMOVE:
            drop(f);
            return out;

        case HIT:
            done = hit(f, out);
            take = !done;
            if (out.gone)
            {
                return out;
            }
            done = done && proceed(f, out.m);
            break;

        case FINISH:
            return out;
    }

    if (!done)
    {
        if (!together_)
        {
            // The rank behind the face is told when its turn comes
            out.toRank = Pstream::myProcNo();
            return out;
        }
        pack(f, out, take || takesParcel(out.m));
        if (f.parcel && out.m.kind == REST)
        {
            f.start.restore(*f.parcel);
        }
        return out;
    }
    out.m.U = f.parcel->U();
    out.m.omega = f.parcel->omega();
    out.m.mass = f.parcel->mass();
    out.m.number = f.parcel->nParticle();
    out.m.keep = f.keep;
    return out;
}


template<class CloudType>
bool Foam::EventDrivenCollisions<CloudType>::hit(flight& f, response& out)
{
    parcelType& p = *f.parcel;
    f.keep = f.keep && out.m.keep;
    settleHere(f);
    act(f);
    td_->keepParticle = f.keep;
    td_->switchProcessor = false;
    if (f.keep)
    {
        // What a wall model lifts a parcel off the face by could press it
        // into another
        const bool wall =
            isA<wallPolyPatch>(cloud_.mesh().boundaryMesh()[p.patch()]);
        const typename parcelType::place here(p);
        p.hitFace(p.U(), cloud_, *td_);
        if (wall && td_->keepParticle)
        {
            here.restore(p);
        }
    }
    if (!td_->keepParticle)
    {
        drop(f);
        out.gone = true;
        return true;
    }

    // If not, on the other side of a period
    return !td_->switchProcessor;
}


template<class CloudType>
typename Foam::EventDrivenCollisions<CloudType>::response
Foam::EventDrivenCollisions<CloudType>::ask(const label rank, request r)
{
    if (rank == Pstream::myProcNo())
    {
        return answer(r);
    }
    r.bufferSize = r.kind == RECEIVE ? buffer_.size() : 0;
    rankMail::send(rank, &r, sizeof(r));
    rankMail::send(rank, buffer_.data(), r.bufferSize);
    response out{0, r.m};
    rankMail::receive(rank, &out, sizeof(out));
    buffer_.resize(out.bufferSize);
    rankMail::receive(rank, &buffer_[0], out.bufferSize);
    return out;
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::serve(const label leader)
{
    request r{FINISH, 0, {PLAN, 0}};
    while (true)
    {
        rankMail::receive(leader, &r, sizeof(r));
        buffer_.resize(r.bufferSize);
        rankMail::receive(leader, &buffer_[0], r.bufferSize);
        if (r.kind == FINISH)
        {
            return;
        }
        const response out = answer(r);
        rankMail::send(leader, &out, sizeof(out));
        rankMail::send(leader, buffer_.data(), out.bufferSize);
    }
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::dismiss()
{
    request r{FINISH, 0, {PLAN, 0}};
    r.bufferSize = buffer_.size();
    for (label rank = 0; rank < Pstream::nProcs(); ++rank)
    {
        if (rank != Pstream::myProcNo())
        {
            rankMail::send(rank, &r, sizeof(r));
            rankMail::send(rank, buffer_.data(), r.bufferSize);
        }
    }
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::fly(trajectory& c, mission& m)
{
    c.handedOn = false;
    response out = ask(c.home.rank, {MOVE, c.home.slot, m});
    follow(c, m, out);
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::follow
(
    trajectory& c,
    mission& m,
    response& out
)
{
    if (out.toRank >= 0 && !together_)
    {
        if (takesParcel(out.m))
        {
            FatalErrorInFunction
                << "Cloud " << cloud_.name() << ": a parcel has left its path"
                << " at " << fromCore(out.m.path.x) << " for another rank"
                << abort(FatalError);
        }

        // Until then its path is the straight one
        m = out.m;
        m.end = deltaT_;
        stopped_.emplace(c.identity, out.m);
        return;
    }
    leg last = c.home;
    while (out.toRank >= 0)
    {
        const label rank = out.toRank;
        ++report_.handOvers;

        // A parcel on the other side of a period goes on as a whole
        const bool whole = takesParcel(out.m) || !out.m.begun;
        request r{RECEIVE, 0, out.m};
        r.patch = out.toPatch;
        out = ask(rank, r);
        const leg here{rank, out.slot};
        if (whole)
        {
            c.home = last = here;
        }
        else if (out.m.kind == PLAN)
        {
            // A message between its parts must not meet the parcel in buffer_
            const std::string parcel = buffer_;
            request link{LINK, last.slot, out.m};
            link.next = here;
            ask(last.rank, link);
            buffer_ = parcel;
            c.handedOn = true;
            last = here;
        }
    }
    m = out.m;
    if (m.kind == REST && m.halt && m.crossings > 0)
    {
        mission stop{DISPLACE, m.t};
        stop.setU = true;
        stop.omega = m.omega;
        ask(c.home.rank, {MOVE, c.home.slot, stop});
    }
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::resume(trajectory& c, mission& m)
{
    response out = ask(c.home.rank, {PASS, c.home.slot, m});
    follow(c, m, out);
    adoptPlan(c, m);
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::adoptPlan
(
    trajectory& c,
    const mission& m
)
{
    c.path = m.path;
    c.end = m.end;
    c.boundary = m.boundary;
    c.resting = m.resting;
    c.held = m.kind == HOLD;
    if (c.held)
    {
        ++report_.held;
        report_.heldEnergy += m.energy;
        return;
    }
    if (m.pull >= 0)
    {
        c.pull = m.pull;
    }
}


template<class CloudType>
typename Foam::EventDrivenCollisions<CloudType>::leg
Foam::EventDrivenCollisions<CloudType>::commitLegs(trajectory& c, bool& keep)
{
    leg here = c.home;
    while (c.handedOn)
    {
        mission m{PLAN, 0};
        m.keep = keep;
        const response out = ask(here.rank, {COMMIT, here.slot, m});
        keep = out.m.keep;
        if (out.next.rank < 0)
        {
            break;
        }
        here = out.next;
    }
    c.handedOn = false;
    return here;
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::watch(const std::int32_t i)
{
    trajectory& c = at(i);
    if (!Pstream::parRun() || c.shared)
    {
        return;
    }
    c.shared =
        stopped_.count(c.identity) || meetsOthers(boxOf(c.path, c.radius));
    if (c.shared)
    {
        sharedAt_[c.identity] = i;
        if (!together_)
        {
            news_.push_back(i);
        }
    }
}


template<class CloudType>
typename Foam::EventDrivenCollisions<CloudType>::call
Foam::EventDrivenCollisions<CloudType>::callOf
(
    const impact::collisionEvent& e
) const
{
    call c{e.time, -1, -1, -1, -1, scalar(e.image), GREAT, GREAT};
    c[6] = Pstream::myProcNo();
    const auto name = [&](const label at, const std::int32_t i)
    {
        const std::uint64_t name = identity(i);
        c[at] = scalar(name >> 32);
        c[at + 1] = scalar(std::uint32_t(name));
    };
    name(1, e.first);
    if (e.second >= 0)
    {
        name(3, e.second);
    }
    return c;
}


template<class CloudType>
typename Foam::EventDrivenCollisions<CloudType>::call
Foam::EventDrivenCollisions<CloudType>::agree()
{
    call mine(GREAT);
    impact::collisionEvent e;
    if (!news_.empty())
    {
        const std::int32_t i = news_[0];
        mine = callOf({path(i).start, i, -1, 0, 0, 0});
    }
    else
    {
        if (step_.nextShared(e))
        {
            mine = callOf(e);
        }
        if (step_.next(e))
        {
            mine[7] = e.time;
        }
    }
    reduce
    (
        mine,
        [](const call& a, const call& b)
        {
            call first = a.before(b) ? a : b;
            first[7] = min(a[7], b[7]);
            return first;
        }
    );
    return mine;
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::settleSlice()
{
    call last(-GREAT);
    while (true)
    {
        const call first = agree();
        const scalar t = first[0];
        if (t == GREAT && first[7] == GREAT)
        {
            return;
        }
        const bool again = !first.before(last) && !last.before(first);
        if (first[7] <= t && !again)
        {
            // An event may bring forth a shared one: agree again
            together_ = false;
            impact::collisionEvent e;
            while
            (
                news_.empty() && step_.next(e)
             && (e.time < t || (e.time == t && callOf(e).before(first)))
            )
            {
                step_.happen(*this, e);
            }
            together_ = true;
            last = first;
            continue;
        }
        last = call(-GREAT);
        const label leader = label(first[6]);
        if (leader == Pstream::myProcNo())
        {
            lead();
        }
        else
        {
            serve(leader);
            takeOver(t);
        }
    }
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::lead()
{
    std::vector<std::int32_t> changed;
    impact::collisionEvent e;
    if (!news_.empty())
    {
        changed.swap(news_);
        for (const std::int32_t i : changed)
        {
            trajectory& c = at(i);
            const auto stopped = stopped_.find(c.identity);
            if (stopped != stopped_.end())
            {
                mission m = stopped->second;
                stopped_.erase(stopped);
                resume(c, m);
                step_.change(*this, c.path.start, i, -1);
            }
        }
    }
    else if (step_.nextShared(e))
    {
        step_.happen(*this, e);
        changed.push_back(e.first);
        if (e.second >= 0)
        {
            changed.push_back(e.second);
        }
    }
    buffer_.clear();
    for (const std::int32_t i : changed)
    {
        rankMail::append(buffer_, at(i));
    }
    dismiss();
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::takeOver(const scalar t)
{
    std::vector<trajectory> changed;
    rankMail::take(buffer_, changed);
    std::vector<std::int32_t> here;
    for (trajectory& c : changed)
    {
        const bool own = c.home.rank == Pstream::myProcNo();
        const auto there = sharedAt_.find(c.identity);
        if (there != sharedAt_.end())
        {
            const std::int32_t i = there->second;
            at(i) = c;
            at(i).shared = true;
            if (c.gone)
            {
                step_.remove(i);
            }
            else
            {
                here.push_back(i);
            }
        }
        else if
        (
            !c.gone
         && (own || (c.shared && mayMeet(boxOf(c.path, c.radius))))
        )
        {
            const std::int32_t i = addOther(c);
            at(i).shared = true;
            sharedAt_[c.identity] = i;
            step_.add(*this);
            here.push_back(i);
        }
    }
    for (const std::int32_t i : here)
    {
        step_.change(*this, t, i, -1);
    }
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::settle()
{
    step_.begin(*this, deltaT_);
    makeHalo();
    step_.takeMore();
    const int nSlices = returnReduce(step_.slices(), maxOp<label>());
    for (int k = 0; k < nSlices; ++k)
    {
        step_.beginSlice(*this, k, nSlices);
        settleSlice();
    }
}
