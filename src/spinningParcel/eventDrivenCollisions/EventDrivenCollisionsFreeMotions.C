/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "EventDrivenCollisions.H"
#include "fetchAhead.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::collect()
{
    freeMotions_.clear();
    flights_.clear();
    trajectories_.clear();
    grow(freeMotions_, cloud_.size());
    largest_ = 0;
    anyNew_ = false;
    label n = 0;
    fetchAhead fetch;
    for (parcelType& p : cloud_)
    {
        fetch(&p, 192);
        const bool injected = n++ >= nParcels_;
        p.stepFraction() = 0;
        foamCompat::forgetTrack(p);
        if (p.active())
        {
            checkNumber(p);
            largest_ = max(largest_, p.d());
            anyNew_ = anyNew_ || injected;
            freeMotions_.emplace_back(&p, injected);
        }
        else if (!p.move(cloud_, *td_, deltaT_))
        {
            cloud_.deleteParticle(p);
        }
    }
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::regroup()
{
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
            freeMotions_.emplace_back(f.parcel, f.injected);
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
    std::size_t i = 0;
    const bool spin = law_.spin();
    if (spin)
    {
        grow(spins_, freeMotions_.size());
        spins_.resize(freeMotions_.size());
    }
    cloud_.moveInBlocks
    (
        *td_,
        [&]() -> parcelType*
        {
            if (i == freeMotions_.size())
            {
                return nullptr;
            }
            freeMotion& q = freeMotions_[i];
            parcelType& p = *q.parcel;
            p.fly(cloud_.cells());
            const typename parcelType::flight here(p.inFlight());
            q.x = here.x;
            q.cell = here.cell;
            q.U = p.U();
            q.age = p.age();
            if (spin)
            {
                spins_[i] = p.omega();
            }
            ++i;
            return &p;
        },
        [&](parcelType*, const label k) { rest.push_back(k); }
    );
    return rest;
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::planAll()
{
    inBlocks_ = !planned_.watched() && cloud_.movesInBlocks();
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
        makeHalo();
    }
}


template<class CloudType>
typename Foam::EventDrivenCollisions<CloudType>::plannedCloud::state
Foam::EventDrivenCollisions<CloudType>::startOf(const std::int32_t i) const
{
    const freeMotion& q = freeMotions_[i];
    typename plannedCloud::state start(*q.parcel);
    start.U = q.U;
    start.age = q.age;
    if (law_.spin())
    {
        start.omega = spins_[i];
    }
    auto& where = start.where;
    where.stepFraction = 0;
    where.where = typename parcelType::flight();
    where.where.x = q.x;
    where.where.cell = q.cell;
    const label celli = cloud_.cells().meshCell(q.cell);
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
    freeMotion& q = freeMotions_[i];
    if (q.trajectory >= 0)
    {
        return trajectories_[q.trajectory];
    }
    const std::int32_t slot = flightOf(i);
    flight& f = flights_[slot];
    mission m(PLAN, 0);
    if (inBlocks_)
    {
        f.start = startOf(i);
        beginPlan(f, m);
    }
    trajectory c;
    c.handedOn = !plan(f, m);
    c.identity = identityOf(*f.parcel);
    c.radius = 0.5*f.parcel->d();
    c.firstHit = -GREAT;
    c.hits = 0;
    c.events = 0;
    c.held = false;
    c.shared = false;
    c.gone = false;
    c.pull = 0;
    c.home = {Pstream::myProcNo(), slot};
    adoptPlan(c, m);
    q.trajectory = trajectories_.size();
    trajectories_.push_back(c);
    return trajectories_.back();
}


template<class CloudType>
std::int32_t Foam::EventDrivenCollisions<CloudType>::addOther
(
    const trajectory& c
)
{
    freeMotions_.emplace_back(nullptr, false);
    freeMotions_.back().trajectory = trajectories_.size();
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
