/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "eventDrivenCollisions.H"

#include <limits>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::eventDrivenCollisions::mission
Foam::eventDrivenCollisions::next
(
    trajectory& c,
    const motionKind free,
    const bool rests,
    const scalar t,
    const scalar pull
)
{
    const bool often = ++c.events > maxFreeEvents;
    mission m{often && rests ? HOLD : free, t};
    m.free = free;
    m.slow = c.events > maxRestEvents ? GREAT : atRest(pull);
    return m;
}


impact::sweptBox Foam::eventDrivenCollisions::boxOf
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


void Foam::eventDrivenCollisions::makeHalo()
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
    rankMail::post out(Pstream::nProcs());
    const auto farAway = [&](const std::int32_t i)
    {
        return
            !known(i)
         && !territories_->foreignFrom
            (
                cloud_.cells().meshCell(begin().cell[i])
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


void Foam::eventDrivenCollisions::watch(const std::int32_t i)
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


Foam::eventDrivenCollisions::call
Foam::eventDrivenCollisions::callOf
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


Foam::eventDrivenCollisions::call
Foam::eventDrivenCollisions::agree()
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


void Foam::eventDrivenCollisions::settleSlice()
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


void Foam::eventDrivenCollisions::lead()
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


void Foam::eventDrivenCollisions::takeOver(const scalar t)
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


void Foam::eventDrivenCollisions::settle()
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double Foam::eventDrivenCollisions::wallTime
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


void Foam::eventDrivenCollisions::collide
(
    const std::int32_t i,
    const std::int32_t j,
    const impact::vector3& separation,
    const double t
)
{
    trajectory& a = at(i);
    trajectory& b = at(j);
    const double pull = a.pull + b.pull;
    bool resting = false;
    const auto arrival = [&](trajectory& c)
    {
        mission m{c.resting ? END_REST : ARRIVE, t};
        m.path = c.path;
        if (c.held)
        {
            m.mass = std::numeric_limits<scalar>::infinity();
            return m;
        }
        fly(c, m);
        return m;
    };
    mission aThen = arrival(a);
    mission bThen = arrival(b);
    const auto go = [&](trajectory& c, mission& then)
    {
        if (c.held)
        {
            return;
        }
        if (then.boundary)
        {
            ++c.events;
            adoptPlan(c, then);
            return;
        }
        mission m = next(c, resting ? REST : PLAN, resting, t, pull);
        m.U = then.U;
        m.omega = then.omega;
        m.heat = then.heat;
        m.setU = true;
        fly(c, m);
        adoptPlan(c, m);
    };
    if (!aThen.boundary && !bThen.boundary)
    {
        const impact::collidingSphere first
        {
            toCore(aThen.U), toCore(aThen.omega), aThen.mass, a.radius
        };
        const impact::collidingSphere second
        {
            toCore(bThen.U), toCore(bThen.omega), bThen.mass, b.radius
        };
        const impact::vector3 n = (1/impact::mag(separation))*separation;
        const double approach = impact::dot(n, first.v - second.v);
        resting =
            a.held || b.held
         || (
                approach <= atRest(pull)
             && (duration_.rests(a.recent, t) || duration_.rests(b.recent, t))
            );
        const bool elastic = !resting
         && (
                duration_.elastic(a.recent, t, approach, pull)
             || duration_.elastic(b.recent, t, approach, pull)
            );
        const impact::pairCollision out =
            (resting ? restingLaw_ : law_).collide(first, second, n, elastic);

        // Forces that press may not have made a speed yet
        const bool slow = duration_.slow(approach, pull);
        duration_.count(a.recent, t, slow);
        duration_.count(b.recent, t, slow);
        if (approach > 0)
        {
            ++report_.pairEvents;
            report_.rankPairs += a.home.rank != b.home.rank;

            // Of all particles of the parcels; the mean of two that differ
            const scalar number =
                a.held || b.held
              ? max(aThen.number, bThen.number)
              : 0.5*(aThen.number + bThen.number);
            report_.restitutionLoss += number*out.restitutionLoss;
            report_.frictionLoss += number*out.frictionLoss;
        }
        aThen.heat = bThen.heat = 0.5*(out.restitutionLoss + out.frictionLoss);
        aThen.U = fromCore(out.v1);
        bThen.U = fromCore(out.v2);
        if (law_.spin())
        {
            aThen.omega = fromCore(out.omega1);
            bThen.omega = fromCore(out.omega2);
        }
    }
    go(a, aThen);
    go(b, bThen);
    watch(i);
    watch(j);
}


bool Foam::eventDrivenCollisions::hitWall
(
    const std::int32_t i,
    const double t
)
{
    trajectory& c = at(i);
    if (c.resting)
    {
        mission m{END_REST, t};
        m.path = c.path;
        fly(c, m);
        c.pull = m.pull >= 0 ? m.pull : c.pull;
        mission then = next(c, PLAN, true, t, c.pull);
        fly(c, then);
        adoptPlan(c, then);
        watch(i);
        return true;
    }

    // A parcel that is pressed against a wall does not bounce for ever
    if (t - c.firstHit >= duration_.value())
    {
        c.firstHit = t;
        c.hits = 0;
    }
    const bool rests = ++c.hits > 8;
    mission m = next(c, rests ? REST : PLAN, rests, t, c.pull);
    c.home = commitLegs(c, m.keep);
    response done = ask(c.home.rank, {HIT, c.home.slot, m});
    c.gone = done.gone;
    if (c.gone)
    {
        return false;
    }
    follow(c, m, done);
    adoptPlan(c, m);
    watch(i);
    return true;
}
