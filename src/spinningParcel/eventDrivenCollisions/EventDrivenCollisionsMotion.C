/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "EventDrivenCollisions.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::land(parcelType& p) const
{
    if (p.inFlight().cell >= 0)
    {
        p.cell() = -1;
        p.land(cloud_.cells());
    }
    else
    {
        p.setFlight({});
    }
}


template<class CloudType>
bool Foam::EventDrivenCollisions<CloudType>::atPass(const parcelType& p) const
{
    return passTo_.size() && p.onBoundaryFace() && passTo_[p.patch()] >= 0;
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::act(flight& f)
{
    f.keep =
        planned_.replay(*f.parcel, f.firstRecord, f.lastRecord, *td_)
     && f.keep;
    f.lastRecord = f.firstRecord;
    if (f.inBlock >= 0)
    {
        keptInBlock_[f.inBlock] = true;
        f.inBlock = -1;
    }
}


template<class CloudType>
bool Foam::EventDrivenCollisions<CloudType>::proceed(flight& f, mission& m)
{
    if (m.setU)
    {
        f.parcel->U() = m.U;
        if (law_.spin())
        {
            f.parcel->omega() = m.omega;
        }
        f.parcel->warm(cloud_, m.heat);
        m.heat = 0;
        m.setU = false;
    }
    switch (m.kind)
    {
        case PLAN: return plan(f, m);
        case ARRIVE: return arrive(f, m);
        case REST: return rest(f, m);
        case END_REST: return endRest(f, m);
        case HOLD:
            if (mag(f.parcel->U()) <= m.slow)
            {
                return hold(f, m);
            }
            m.kind = m.free;
            return m.kind == REST ? rest(f, m) : plan(f, m);
        case DISPLACE: return displace(f, m);
    }
    return true;
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::beginPlan(flight& f, mission& m)
{
    m.begun = true;
    m.resting = false;
    m.boundary = false;
    m.end = deltaT_;
    const auto& from = f.start.where.where;
    m.path.x = toCore
    (
        solved(from.cell != -1 ? fromCore(from.x) : f.parcel->position())
    );
    m.path.v = toCore(solved(f.start.U));
    m.path.a = impact::vector3{0, 0, 0};
    m.path.start = m.t;
}


template<class CloudType>
bool Foam::EventDrivenCollisions<CloudType>::plan(flight& f, mission& m)
{
    parcelType& p = *f.parcel;
    bool moves = m.begun;
    f.firstRecord = planned_.size();
    if (!m.begun)
    {
        f.start = typename plannedCloud::state(p);
        beginPlan(f, m);
    }
    if (p.stepFraction() < 1)
    {
        moves = true;
        p.move(planned_, *td_, deltaT_);
        f.lastRecord = planned_.size();
        if (td_->switchProcessor && atPass(p))
        {
            return false;
        }
        m.boundary = td_->switchProcessor;
    }
    f.lastRecord = planned_.size();
    if (moves)
    {
        endPlan(f, m);
    }
    return true;
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::endPlan(flight& f, mission& m)
{
    const parcelType& p = *f.parcel;
    m.end = p.stepFraction() < 1 ? p.stepFraction()*deltaT_ : deltaT_;

    const scalar h = m.end - m.path.start;
    m.path.bend(solved(p.position()), h, deltaT_);
    if (h > 1e-9*deltaT_)
    {
        // The bend of a short way is the error of its ends
        m.pull = mag(solved(p.U()) - fromCore(m.path.v))/h;
    }
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::stay(flight& f, mission& m)
{
    m.path.x = toCore(solved(f.parcel->position()));
    m.path.v = impact::vector3{0, 0, 0};
    m.path.a = impact::vector3{0, 0, 0};
    m.path.start = m.t;
    f.start = typename plannedCloud::state(*f.parcel);
    f.firstRecord = f.lastRecord = planned_.size();
}


template<class CloudType>
bool Foam::EventDrivenCollisions<CloudType>::rest(flight& f, mission& m)
{
    parcelType& p = *f.parcel;
    land(p);
    const scalar pause = min(restShare*deltaT_, deltaT_ - m.t);
    const bool home = !m.begun;
    if (home)
    {
        // What is left of the velocity towards or off the wall goes. A
        // little off it, so that the tracking does not meet the face again
        // at once
        if (p.onBoundaryFace() && !atPass(p))
        {
            vector n = p.mesh().faceAreas()[p.face()];
            n /= mag(n);
            p.U() -= (p.U() & n)*n;
            p.U() -= 1e-6*mag(p.U())*n;
        }
        m.begun = true;
        m.boundary = false;
        m.resting = true;
        stay(f, m);
        m.path.v = toCore(solved(p.U()));
        m.way = pause*p.U();
        ++cloud_.statistics().nPauses;
    }

    m.left *= p.track(m.left*m.way, 0);
    if (m.left > 0 && atPass(p) && m.crossings < maxCrossings)
    {
        return false;
    }
    if (home)
    {
        f.start.restore(p);
    }

    // In a corner it stays
    const scalar share = 1 - m.left;
    m.halt = share*pause < min(duration_.value(), 0.1*pause);

    // Not beyond the step by round-off, or it would not end in it
    m.end = min(m.t + (m.halt ? pause : share*pause), deltaT_);
    if (m.halt)
    {
        m.path.v = impact::vector3{0, 0, 0};
        if (home)
        {
            p.U() = Zero;
        }
    }
    return true;
}


template<class CloudType>
bool Foam::EventDrivenCollisions<CloudType>::endRest(flight& f, mission& m)
{
    parcelType& p = *f.parcel;
    land(p);
    const scalar pause = m.t - m.path.start;
    if (pause > 0)
    {
        if (!m.begun)
        {
            m.begun = true;
            m.way = p.position();
        }
        m.left *= p.track(m.left*pause*p.U(), 0);
        if (m.left > 0 && atPass(p) && m.crossings < maxCrossings)
        {
            return false;
        }
        td_->keepParticle = true;
        p.face() = -1;
        p.setCellValues(cloud_, *td_);
        const vector before = p.U();
        p.calc(cloud_, *td_, pause);
        if (pause > 1e-9*deltaT_)
        {
            m.pull = mag(solved(p.U() - before))/pause;
        }
        p.age() += pause;
        foamCompat::postMove(cloud_.functions(), p, pause, m.way, *td_);
        f.keep = f.keep && td_->keepParticle;
    }
    m.resting = false;
    p.stepFraction() = m.t < deltaT_ ? m.t/deltaT_ : 1;
    return true;
}


template<class CloudType>
bool Foam::EventDrivenCollisions<CloudType>::arrive(flight& f, mission& m)
{
    parcelType& p = *f.parcel;
    const scalar begin = m.path.start;
    const scalar time = m.t - begin;
    bool hit = false;
    if (!m.begun)
    {
        m.begun = true;
        f.start.restore(p);
        f.inBlock = -1;
        m.settling = time <= 1e-14*deltaT_;
        if (!m.settling)
        {
            p.stepFraction() = 0;
            foamCompat::forgetTrack(p);
        }
    }
    if (!m.settling)
    {
        f.firstRecord = planned_.size();
        if (p.stepFraction() < 1)
        {
            p.move(planned_, *td_, time);
            hit = td_->switchProcessor;
        }
        f.lastRecord = planned_.size();
        planned_.rescale(f.firstRecord, begin/deltaT_, time/deltaT_);
        act(f);
        if (hit && atPass(p))
        {
            return false;
        }
        m.settling = true;
    }

    // From where the integration leads to the parabola, along a wall if there
    // is one: another parcel is where the parabola does not lead
    const auto away = [&]()
    {
        return solved(fromCore(m.path.position(m.t)) - p.position());
    };
    land(p);
    p.track(away(), 0);
    if (p.onBoundaryFace() && !atPass(p))
    {
        vector n = p.mesh().faceAreas()[p.face()];
        n /= mag(n);
        vector way = away();
        way -= max(way & n, scalar(0))*n;
        if (mag(way) > 0)
        {
            p.track(way - 1e-6*mag(way)*n, 0);
        }
    }
    if (atPass(p) && m.crossings < maxCrossings)
    {
        return false;
    }
    hit =
        p.onBoundaryFace()
     && !atPass(p)
     && (p.U() & p.mesh().faceAreas()[p.face()]) > 0;
    p.stepFraction() = m.t < deltaT_ ? m.t/deltaT_ : 1;
    m.boundary = hit;
    if (hit)
    {
        // Its boundary event is due, and comes first
        m.end = m.t;
        stay(f, m);
    }
    return true;
}


template<class CloudType>
bool Foam::EventDrivenCollisions<CloudType>::displace(flight& f, mission& m)
{
    parcelType& p = *f.parcel;
    if (magSqr(m.way) > 0)
    {
        land(p);
        m.left *= p.track(m.left*m.way, 0);
        if (m.left > 0 && atPass(p) && m.crossings < maxCrossings)
        {
            return false;
        }
        p.face() = -1;
    }
    m.way = p.position();
    return true;
}


template<class CloudType>
bool Foam::EventDrivenCollisions<CloudType>::hold(flight& f, mission& m)
{
    parcelType& p = *f.parcel;
    m.energy = 0.5*p.nParticle()*p.mass()*magSqr(p.U());
    p.U() = Zero;
    m.begun = true;
    m.boundary = false;
    m.resting = false;
    m.end = deltaT_;
    stay(f, m);
    p.age() += deltaT_ - m.t;
    p.stepFraction() = 1;
    return true;
}
