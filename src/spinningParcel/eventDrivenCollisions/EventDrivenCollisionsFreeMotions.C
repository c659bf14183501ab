/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "EventDrivenCollisions.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::admit
(
    parcelType* p,
    const scalar nParticle,
    const scalar d,
    const point& x,
    const bool injected
)
{
    checkNumber(nParticle, d, x);
    largest_ = max(largest_, d);
    anyNew_ = anyNew_ || injected;
    freeMotions_.push_back({p, injected});
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::collect()
{
    freeMotions_.clear();
    trajectoryOf_.clear();
    flights_.clear();
    trajectories_.clear();
    largest_ = 0;
    anyNew_ = false;
    inBlocks_ = cloud_.inArrays();
    exchanging_ = cloud_.solution().coupled() || cloud_.heated();
    grow(freeMotions_, cloud_.size());
    const auto& parcels = arrays();
    for (label i = 0; i < parcels.size(); ++i)
    {
        admit
        (
            nullptr, parcels.nParticle[i], parcels.d[i], parcels.x[i],
            i >= nKnown_
        );
    }
    label n = 0;
    for (parcelType& p : cloud_.objects())
    {
        p.stepFraction() = 0;
        foamCompat::forgetTrack(p);
        if (p.active())
        {
            admit(&p, p.nParticle(), p.d(), p.position(), n++ >= nKnown_);
        }
        else if (!p.move(cloud_, *td_, deltaT_))
        {
            cloud_.deleteParticle(p);
        }
    }
}


template<class CloudType>
Foam::label Foam::EventDrivenCollisions<CloudType>::nActive() const
{
    label n = arrays().size();
    for (const parcelType& p : cloud_.objects())
    {
        n += p.active();
    }
    return n;
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::regroup()
{
    if (inBlocks_)
    {
        // What is an object now goes to the end of the arrays. The gaps are
        // filled here as they are there
        std::unordered_map<const parcelType*, bool> injected;
        for (const flight& f : flights_)
        {
            injected[f.parcel] = f.injected;
        }
        for (label i = label(freeMotions_.size()) - 1; i >= 0; --i)
        {
            if (freeMotions_[i].flight >= 0)
            {
                freeMotions_[i] = freeMotions_.back();
                freeMotions_.pop_back();
            }
        }
        cloud_.arrays().fill();
        for (const parcelType& p : cloud_.objects())
        {
            if (p.active())
            {
                freeMotions_.push_back({nullptr, injected[&p]});
            }
        }
        cloud_.pack(cloud_.cells());
        flights_.clear();
        return;
    }

    for (freeMotion& q : freeMotions_)
    {
        if (q.flight >= 0)
        {
            q.parcel = flights_[q.flight].parcel;
            flights_[q.flight].parcel = nullptr;
            q.flight = -1;
        }
    }
    for (const flight& f : flights_)
    {
        if (f.parcel)
        {
            freeMotions_.push_back({f.parcel, f.injected});
        }
    }
    flights_.clear();
    freeMotions_.erase
    (
        std::remove_if
        (
            freeMotions_.begin(), freeMotions_.end(),
            [](const freeMotion& q) { return !q.parcel; }
        ),
        freeMotions_.end()
    );
}


template<class CloudType>
std::vector<std::int32_t>
Foam::EventDrivenCollisions<CloudType>::moveInBlocks()
{
    std::vector<std::int32_t> rest;
    begin_.take(arrays());
    keptInBlock_.assign(exchanging_ ? arrays().size() : 0, false);
    cloud_.moveInBlocks
    (
        [&](const label i, const typename parcelType::begun& begun)
        {
            parcelType* p = freeMotions_[i].parcel = cloud_.take(i);
            rest.push_back(i);
            if (exchanging_)
            {
                // What it has given to the gas so far is not remembered
                startOf(i).restore(*p);
                return;
            }
            p->stepFraction() = begun.share;
            cloud_.leaveBegun(*p, begun);
        },
        exchanging_ ? &planned_ : nullptr
    );
    return rest;
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::planAll()
{
    grow(trajectoryOf_, freeMotions_.size());
    trajectoryOf_.assign(freeMotions_.size(), -1);
    if (inBlocks_)
    {
        for (const std::int32_t i : moveInBlocks())
        {
            at(i);
        }
    }
    else
    {
        for (std::size_t i = 0; i < freeMotions_.size(); ++i)
        {
            at(i);
        }
    }
    if (Pstream::parRun())
    {
        handOn();
    }
}


template<class CloudType>
typename Foam::EventDrivenCollisions<CloudType>::plannedCloud::state
Foam::EventDrivenCollisions<CloudType>::startOf(const std::int32_t i) const
{
    typename plannedCloud::state start(*freeMotions_[i].parcel);
    start.U = begin_.U[i];
    start.age = begin_.age[i];
    if (begin_.omega.size())
    {
        start.omega = begin_.omega[i];
    }
    if (begin_.T.size())
    {
        start.T = begin_.T[i];
    }
    auto& where = start.where;
    where.stepFraction = 0;
    where.where = typename parcelType::flight
    (
        toCore(begin_.x[i]), begin_.cell[i]
    );
    const label celli = cloud_.cells().meshCell(begin_.cell[i]);
    if (where.cell != celli)
    {
        where.cell = celli;
        where.tetFace = cloud_.mesh().cells()[celli][0];
        where.tetPt = 1;
    }
    return start;
}


template<class CloudType>
std::int32_t Foam::EventDrivenCollisions<CloudType>::flightOf
(
    const std::int32_t i
)
{
    freeMotion& q = freeMotions_[i];
    if (q.flight < 0)
    {
        if (!q.parcel)
        {
            q.parcel = cloud_.take(i);
        }
        q.flight = flights_.size();
        flights_.emplace_back(*q.parcel);
        flights_.back().injected = q.injected;
    }
    return q.flight;
}


template<class CloudType>
typename Foam::EventDrivenCollisions<CloudType>::flight&
Foam::EventDrivenCollisions<CloudType>::flightAt(const label slot)
{
    return flights_[slot >= 0 ? slot : flightOf(~slot)];
}


template<class CloudType>
typename Foam::EventDrivenCollisions<CloudType>::trajectory&
Foam::EventDrivenCollisions<CloudType>::at(const std::int32_t i)
{
    if (trajectoryOf_[i] >= 0)
    {
        return trajectories_[trajectoryOf_[i]];
    }
    const std::int32_t slot = flightOf(i);
    flight& f = flights_[slot];
    mission m{PLAN, 0};
    if (inBlocks_)
    {
        f.start = startOf(i);
        const bool arrived = f.parcel->stepFraction() == 1;
        f.inBlock = exchanging_ && arrived ? i : -1;
        beginPlan(f, m);
    }
    trajectory c;
    c.handedOn = !plan(f, m);
    c.identity = identityOf(*f.parcel);
    c.radius = 0.5*f.parcel->d();
    c.home = {Pstream::myProcNo(), slot};
    adoptPlan(c, m);
    trajectoryOf_[i] = trajectories_.size();
    trajectories_.push_back(c);
    return trajectories_.back();
}


template<class CloudType>
std::int32_t Foam::EventDrivenCollisions<CloudType>::addOther
(
    const trajectory& c
)
{
    freeMotions_.push_back({nullptr, false});
    trajectoryOf_.push_back(trajectories_.size());
    trajectories_.push_back(c);
    return std::int32_t(freeMotions_.size()) - 1;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class CloudType>
double Foam::EventDrivenCollisions<CloudType>::wallTime
(
    const std::int32_t i,
    double,
    double
) const
{
    const trajectory* c = known(i);
    return
        c
     && c->home.rank == Pstream::myProcNo()
     && (c->boundary || c->resting)
      ? c->end : impact::never;
}
