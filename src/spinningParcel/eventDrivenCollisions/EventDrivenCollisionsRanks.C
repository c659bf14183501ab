/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "EventDrivenCollisions.H"
#include "StringStream.H"
#include "globalMeshData.H"
#include "processorCyclicPolyPatch.H"
#include "UIPstream.H"
#include "UOPstream.H"
#include "wallPolyPatch.H"


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
void Foam::EventDrivenCollisions<CloudType>::sendBytes
(
    const label rank,
    const void* data,
    const std::size_t n
)
{
    const char* from = static_cast<const char*>(data);
    const std::size_t most = 1 << 30;
    for (std::size_t i = 0; i < n; i += most)
    {
        UOPstream::write
        (
            Pstream::commsTypes::scheduled, rank, from + i, min(most, n - i)
        );
    }
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::receiveBytes
(
    const label rank,
    void* data,
    const std::size_t n
)
{
    char* to = static_cast<char*>(data);
    const std::size_t most = 1 << 30;
    for (std::size_t i = 0; i < n; i += most)
    {
        UIPstream::read
        (
            Pstream::commsTypes::scheduled, rank, to + i, min(most, n - i)
        );
    }
}


template<class CloudType>
template<class Item>
void Foam::EventDrivenCollisions<CloudType>::gather(std::vector<Item>& items)
{
    if (!Pstream::parRun())
    {
        return;
    }
    labelList sizes(Pstream::nProcs(), 0);
    sizes[Pstream::myProcNo()] = items.size();
    Pstream::gatherList(sizes);
    if (!Pstream::master())
    {
        sendBytes(Pstream::masterNo(), items.data(), items.size()*sizeof(Item));
        return;
    }
    std::size_t total = 0;
    for (const label n : sizes)
    {
        total += n;
    }
    items.reserve(total);
    std::vector<char> bytes;
    for (label rank = 1; rank < Pstream::nProcs(); ++rank)
    {
        bytes.resize(sizes[rank]*sizeof(Item));
        receiveBytes(rank, bytes.data(), bytes.size());
        const Item* from = reinterpret_cast<const Item*>(bytes.data());
        items.insert(items.end(), from, from + sizes[rank]);
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
    ++r.m.hops;
    r.m.keep = f.keep;

    const typename parcelType::place here(p);
    p.prepareForParallelTransfer();
    OStringStream os(IOstream::BINARY);
    os << p;
    blob_ = os.str();
    r.blobSize = blob_.size();
    here.restore(p);
    if (!take)
    {
        return;
    }
    if (f.guest)
    {
        delete f.parcel;
    }
    else
    {
        cloud_.deleteParticle(p);
    }
    f.parcel = nullptr;
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::unpack(const request& r)
{
    const polyMesh& mesh = cloud_.mesh();
    IStringStream is(blob_, IOstream::BINARY);
    autoPtr<parcelType> received(new parcelType(mesh, is, true));
    received->correctAfterParallelTransfer
        (mesh.globalData().processorPatches()[r.patch], *td_);
    parcelType& p = *received.ptr();
    flights_.emplace_back(p);
    flight& f = flights_.back();
    f.guest = !takesParcel(r.m) && r.m.begun;
    f.keep = r.m.keep;
    f.injected = r.m.injected;
    if (!f.guest)
    {
        cloud_.addParticle(&p);
    }
}


template<class CloudType>
typename Foam::EventDrivenCollisions<CloudType>::response
Foam::EventDrivenCollisions<CloudType>::answer(const request& r)
{
    response out{r.slot, -1, -1, 0, false, r.m};
    if (r.kind == RECEIVE)
    {
        unpack(r);
        out.slot = label(flights_.size()) - 1;
    }
    flight& f = flights_[out.slot];
    parcelType& p = *f.parcel;
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

        case COMMIT:
            f.keep = f.keep && r.m.keep;
            if (f.keep)
            {
                act(f);
            }
            out.m.keep = f.keep;
            if (f.guest)
            {
                delete f.parcel;
            }
            else
            {
                cloud_.deleteParticle(p);
            }
            f.parcel = nullptr;
            return out;

        case ADOPT:
        case HIT:
            f.keep = f.keep && r.m.keep;
            if (f.guest)
            {
                cloud_.addParticle(&p);
                f.guest = false;
            }
            if (r.kind == ADOPT)
            {
                return out;
            }
            act(f);
            td_->keepParticle = f.keep;
            td_->switchProcessor = false;
            if (f.keep)
            {
                // What a wall model lifts a parcel off the face by could
                // press it into another
                const bool wall = isA<wallPolyPatch>
                    (cloud_.mesh().boundaryMesh()[p.patch()]);
                const typename parcelType::place here(p);
                p.hitFace(p.U(), cloud_, *td_);
                if (wall && td_->keepParticle)
                {
                    here.restore(p);
                }
            }
            if (!td_->keepParticle)
            {
                cloud_.deleteParticle(p);
                f.parcel = nullptr;
                out.gone = true;
                return out;
            }
            if (td_->switchProcessor)
            {
                // The other side of a period
                done = false;
                take = true;
            }
            else
            {
                done = proceed(f, out.m);
            }
            break;

        case FINISH:
            return out;
    }

    if (!done)
    {
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
    out.m.keep = f.keep;
    return out;
}


template<class CloudType>
typename Foam::EventDrivenCollisions<CloudType>::response
Foam::EventDrivenCollisions<CloudType>::ask(const label rank, request& r)
{
    if (rank == Pstream::myProcNo())
    {
        return answer(r);
    }
    r.blobSize = r.kind == RECEIVE ? blob_.size() : 0;
    sendBytes(rank, &r, sizeof(r));
    sendBytes(rank, blob_.data(), r.blobSize);
    response out{0, -1, -1, 0, false, r.m};
    receiveBytes(rank, &out, sizeof(out));
    blob_.resize(out.blobSize);
    receiveBytes(rank, &blob_[0], out.blobSize);
    return out;
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::serve()
{
    const label master = Pstream::masterNo();
    request r{FINISH, 0, -1, 0, mission(PLAN, 0)};
    while (true)
    {
        receiveBytes(master, &r, sizeof(r));
        blob_.resize(r.blobSize);
        receiveBytes(master, &blob_[0], r.blobSize);
        if (r.kind == FINISH)
        {
            return;
        }
        const response out = answer(r);
        sendBytes(master, &out, sizeof(out));
        sendBytes(master, blob_.data(), out.blobSize);
    }
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::dismiss()
{
    const request r{FINISH, 0, -1, 0, mission(PLAN, 0)};
    for (label rank = 1; rank < Pstream::nProcs(); ++rank)
    {
        sendBytes(rank, &r, sizeof(r));
    }
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::fly(course& c, mission& m)
{
    c.next = -1;
    request r{MOVE, c.slot, -1, 0, m};
    response out = ask(c.rank, r);
    follow(c, m, out);
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::follow
(
    course& c,
    mission& m,
    response& out
)
{
    label* link = &c.next;
    label lastOfChain = -1;
    while (out.toRank >= 0)
    {
        const label rank = out.toRank;
        ++report_.handOvers;

        // A parcel on the other side of a period goes on as a whole
        const bool whole = takesParcel(out.m) || !out.m.begun;
        request r{RECEIVE, 0, out.toPatch, 0, out.m};
        out = ask(rank, r);
        if (whole)
        {
            c.rank = rank;
            c.slot = out.slot;
        }
        else if (out.m.kind == PLAN)
        {
            legs_.push_back({rank, out.slot, -1});
            const label last = label(legs_.size()) - 1;
            if (lastOfChain < 0)
            {
                *link = last;
            }
            else
            {
                legs_[lastOfChain].next = last;
            }
            lastOfChain = last;
        }
    }
    m = out.m;
    if (m.kind == REST && m.halt && m.hops > 0)
    {
        mission stop(DISPLACE, m.t);
        stop.setU = true;
        stop.omega = m.omega;
        request r{MOVE, c.slot, -1, 0, stop};
        ask(c.rank, r);
    }
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::adoptPlan
(
    course& c,
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
Foam::EventDrivenCollisions<CloudType>::commitLegs(course& c, bool& keep)
{
    leg here{c.rank, c.slot, c.next};
    while (here.next >= 0)
    {
        request r{COMMIT, here.slot, -1, 0, mission(PLAN, 0)};
        r.m.keep = keep;
        keep = ask(here.rank, r).m.keep;
        here = legs_[here.next];
    }
    return here;
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::commitAll()
{
    for (course& c : courses_)
    {
        if (c.next >= 0 && !c.resting)
        {
            mission m(PLAN, deltaT_);
            const leg last = commitLegs(c, m.keep);
            request r{ADOPT, last.slot, -1, 0, m};
            ask(last.rank, r);
        }
    }
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::planAll()
{
    const label rank = Pstream::myProcNo();
    courses_.clear();
    grow(courses_, flights_.size());
    legs_.clear();
    for (std::size_t i = 0; i < flights_.size(); ++i)
    {
        flight& f = flights_[i];
        if (!f.parcel)
        {
            continue;
        }
        mission m(PLAN, 0);
        const bool done = plan(f, m);
        course c;
        c.identity = identityOf(*f.parcel);
        c.radius = 0.5*f.parcel->d();
        c.firstHit = -GREAT;
        c.hits = 0;
        c.events = 0;
        c.held = false;
        c.pull = 0;
        c.rank = rank;
        c.slot = i;
        c.next = done ? -1 : -2;
        adoptPlan(c, m);
        courses_.push_back(c);
    }
    if (!Pstream::parRun())
    {
        return;
    }
    gather(courses_);
    if (!Pstream::master())
    {
        return;
    }
    for (course& c : courses_)
    {
        if (c.next == -2)
        {
            mission m(PLAN, 0);
            m.begun = true;
            m.path = c.path;
            c.next = -1;
            request r{PASS, c.slot, -1, 0, m};
            response out = ask(c.rank, r);
            follow(c, m, out);
            adoptPlan(c, m);
        }
    }
}
