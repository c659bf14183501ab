/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "EventDrivenCollisions.H"

#include <limits>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class CloudType>
typename Foam::EventDrivenCollisions<CloudType>::mission
Foam::EventDrivenCollisions<CloudType>::next
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::collide
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


template<class CloudType>
bool Foam::EventDrivenCollisions<CloudType>::hitWall
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
