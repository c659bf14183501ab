/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "roughFlights.H"
#include "searchStep.H"

#include <cmath>
#include <limits>

namespace
{

using impact::roughLanes;

//- Number of the arrays from the first of the struct up to one of its lanes
int fieldsBefore(const roughLanes& l, const roughLanes::lane& end)
{
    return int(&end - &l.x);
}


//- Copy the first n arrays of a lane
void copyLane(const roughLanes& a, int i, roughLanes& b, int j, int n)
{
    const double* from = a.x + i;
    double* to = b.x + j;
    const std::size_t stride = sizeof(roughLanes::lane)/sizeof(double);
    for (int k = 0; k < n; ++k)
    {
        to[k*stride] = from[k*stride];
    }
}


int wholeVectors(int n)
{
    return (n + 7) & ~7;
}


//- Bring the window of a lane to where its flight goes on: false if that is
//  nowhere, the body being gone, or the search lost
bool moveWindow
(
    const impact::roughBody& body,
    impact::reliefPiece& piece,
    roughLanes& l,
    int i,
    std::int64_t& at
)
{
    const double x = l.x[i], Vx = l.V[0][i];
    const double wide = l.wide[i];
    double t = l.t[i];
    bool lost = false;
    const double jump = piece.firstReach
    (
        x, l.y[i], Vx, l.V[1][i], l.deep[i], wide, t, at, lost
    );
    if (lost)
    {
        l.status[i] = impact::roughStatus::special;
        return false;
    }
    if (jump == std::numeric_limits<double>::infinity())
    {
        l.status[i] = impact::roughStatus::gone;
        return false;
    }
    const bool moved = jump > t;
    if (moved)
    {
        l.t[i] = t = jump;
        l.gap[i] = 0;
    }

    const bool back = Vx < 0;
    const double cx = x + Vx*t;
    at = piece.find(back ? cx + wide : cx - wide, at);
    const int intervals = body.wide ? 4 : 3;
    const std::int64_t first = back ? at - intervals + 1 : at;
    double steep = 0, crest = 0, from = 0, to = 0;
    for (int k = 0; k < intervals; ++k)
    {
        const impact::relief::interval& s = piece.at(first + k);
        l.x0[k][i] = s.x0;
        l.c0[k][i] = s.c0;
        l.c1[k][i] = s.c1;
        l.c2[k][i] = s.c2;
        l.c3[k][i] = s.c3;
        l.top[k][i] = s.top;
        steep = std::max(steep, s.steep);
        crest = std::max(crest, s.crest);
        from = k == 0 ? s.x0 : from;
        to = s.x1;
    }
    const double least = l.least[i];
    const double longest = 64e10*least;
    const double way = back ? cx - wide - from : to - wide - cx;
    const double fastest = 1e-10*body.radius/least;
    const double reach = impact::boundedReach
        (l.turning[i], l.speedX[i], fastest, body.radius, steep, crest);
    const double room =
        way < std::fabs(Vx)*longest ? way/std::fabs(Vx) : longest;
    l.steep[i] = steep;
    l.reach[i] = reach;
    l.end[i] = t + room;
    l.status[i] = impact::roughStatus::flies;
    if (moved)
    {
        // The gap there is not known yet
        l.tau[i] = 0;
        return true;
    }
    const double gap = l.gap[i], rate = l.rate[i];
    const double root = std::sqrt(gap + impact::allowedDepth*body.radius);
    const double tau = impact::stepAhead(gap, root, rate, reach, 0.9);
    l.tau[i] = std::min(std::max(tau, least), room);
    return true;
}

//- One impact by any law. Returns whether a coefficient was asked for outside
//  of its range
bool strikeOne
(
    const impact::reboundLaw& law,
    const impact::roughBody& body,
    roughLanes& l,
    int i
)
{
    using impact::vector3;
    auto get = [i](const roughLanes::lane* a)
    {
        return vector3{a[0][i], a[1][i], a[2][i]};
    };
    auto put = [i](roughLanes::lane* a, const vector3& b)
    {
        a[0][i] = b.x;
        a[1][i] = b.y;
        a[2][i] = b.z;
    };
    const vector3 u = get(l.u), v = get(l.v), t = cross(u, v);
    auto toBody = [&](const vector3& a)
    {
        return vector3{dot(a, u), dot(a, v), dot(a, t)};
    };
    auto fromBody = [&](const vector3& a)
    {
        return a.x*u + a.y*v + a.z*t;
    };
    const vector3 V = get(l.V), w = get(l.w);
    const double cosine = 1/std::sqrt(1 + l.slope[i]*l.slope[i]);
    const impact::impactRecord record = law.impact
    (
        {body.Ja, body.Jc, body.Jc}, toBody(get(l.r)),
        toBody({-cosine*l.slope[i], cosine, 0}), toBody(V), toBody(w)
    );
    l.approach[i] = record.approachSpeed;
    l.pulling[i] = record.pulling;
    l.gaining[i] = record.gainsEnergy();
    put(l.V, V + fromBody(record.dV));
    put(l.w, w + fromBody(record.dOmega));
    return record.outside;
}

} // End anonymous namespace


impact::scatteringSampler::roughFlights::roughFlights
(
    const scatteringSampler& sampler,
    workspace& work,
    visitCounts& total,
    std::int64_t first,
    int n
)
:
    sampler_(sampler),
    setup_(sampler.setup_),
    body_(sampler.rough_),
    work_(work),
    total_(total),
    first_(first),
    n_(n),
    once_(setup_.treatment == visitTreatment::firstImpact),
    byKernel_
    (
        setup_.law.law() == reboundLaw::lawType::restitution
     && setup_.law.isConstant()
    ),
    small_(1e-3*mag(sampler.V1_))
{}


void impact::scatteringSampler::roughFlights::choosePiece(std::int64_t number)
{
    const int perPiece = sampler_.perPiece_;
    auto& slots = work_.slots;
    if (number/perPiece != identity_)
    {
        identity_ = number/perPiece;
        slot_ = 0;
        while (slot_ < int(slots.size()) && slots[slot_]->users)
        {
            ++slot_;
        }
        if (slot_ == int(slots.size()))
        {
            slots.emplace_back
            (
                new reliefSlot{reliefPiece(*setup_.wall, setup_.seed), 0}
            );
        }
        slots[slot_]->piece.start
        (
            std::uint64_t(identity_), perPiece*sampler_.stretch_
        );
    }
    ++slots[slot_]->users;
}


void impact::scatteringSampler::roughFlights::place
(
    int i,
    std::int64_t number,
    const double (*u0)[roughBatch],
    const double (*u1)[roughBatch]
)
{
    // As in arrival()
    choosePiece(number);
    reliefPiece& piece = work_.slots[slot_]->piece;
    const relief& wall = *setup_.wall;
    const double longest = wall.meanSpacing() + 3*wall.sigmaSpacing();
    std::int64_t at =
        (number - identity_*sampler_.perPiece_)*sampler_.stretch_;
    for (int attempt = 0; ; ++attempt, ++at)
    {
        double p0 = 0, p1 = 0;
        if (attempt < 2)
        {
            p0 = u0[attempt][i];
            p1 = u1[attempt][i];
        }
        else
        {
            roughPositions(setup_.seed, attempt, number, 1, &p0, &p1);
        }
        const double begin = piece.knot(at);
        const double length = piece.knot(at + 1) - begin;
        if (p0*longest < length)
        {
            work_.arrivals.x[i] = begin + p1*length;
            break;
        }
    }
    places_[i] = {slot_, at};
}


void impact::scatteringSampler::roughFlights::draw()
{
    const vector3& V1 = sampler_.V1_;
    const vector3& omega = setup_.spin;
    const double V[3] = {V1.x, V1.y, V1.z};
    const double spin[3] = {omega.x, omega.y, omega.z};
    const double start = setup_.wall->top() + setup_.body.radius();
    const int axis = setup_.body.symmetryAxis() % 3;
    const int side = (axis + 1) % 3;
    roughLanes& l = work_.arrivals;
    const int m = std::min(roughBatch, n_ - drawn_);
    batchStart_ = drawn_;
    smoothArrive
    (
        setup_.orientation == orientationLaw::isotropic, setup_.seed,
        first_ + drawn_, m, V, spin, sampler_.smooth_, work_.lanes
    );
    const smoothLanes& s = work_.lanes;
    for (int i = 0; i < m; ++i)
    {
        const vector3 ex = {s.ex[0][i], s.ex[1][i], s.ex[2][i]};
        const vector3 ey = {s.ey[0][i], s.ey[1][i], s.ey[2][i]};
        const vector3 ez = cross(ex, ey);
        const vector3 u = {ex[axis], ey[axis], ez[axis]};
        const vector3 v = {ex[side], ey[side], ez[side]};
        for (int k = 0; k < 3; ++k)
        {
            l.u[k][i] = u[k];
            l.v[k][i] = v[k];
            l.V[k][i] = V[k];
        }
        l.y[i] = start;
    }
    double u0[2][roughBatch], u1[2][roughBatch];
    for (int k = 0; k < 2; ++k)
    {
        roughPositions(setup_.seed, k, first_ + drawn_, m, u0[k], u1[k]);
    }
    for (int i = 0; i < m; ++i)
    {
        place(i, first_ + drawn_ + i, u0, u1);
    }
    roughLaunch(wholeVectors(m), body_, omega.x, omega.y, omega.z, l);
    drawn_ += m;
}


void impact::scatteringSampler::roughFlights::record
(
    int particle,
    const vector3& V,
    double spinEnergy
)
{
    work_.Vx[particle] = V.x;
    work_.Vy[particle] = V.y;
    work_.Vz[particle] = V.z;
    work_.spinEnergy[particle] = spinEnergy;
}


void impact::scatteringSampler::roughFlights::leave(int i)
{
    const roughLanes& l = work_.rough;
    const passenger& q = who_[i];
    const vector3 u = {l.u[0][i], l.u[1][i], l.u[2][i]};
    const vector3 omega =
        l.rateL[i]*vector3{l.axisL[0][i], l.axisL[1][i], l.axisL[2][i]}
      + l.rateAxis[i]*u;
    const double along = dot(omega, u);
    record
    (
        q.particle, {l.V[0][i], l.V[1][i], l.V[2][i]},
        body_.Jc*dot(omega, omega) + (body_.Ja - body_.Jc)*along*along
    );
    total_.impacts += q.impacts;
    total_.micro += q.micro;
    total_.pulling += q.pulling;
    total_.gaining += q.gaining;
    total_.outside += q.outside;
    total_.second += q.second;
    total_.into += q.into;
    --work_.slots[q.slot]->users;
}


void impact::scatteringSampler::roughFlights::leaveToSearch(int i)
{
    const passenger& q = who_[i];
    reliefPiece& piece = work_.slots[q.slot]->piece;
    const std::int64_t number = first_ + q.particle;
    std::int64_t own = number/sampler_.perPiece_, hint = 0;
    const bodyState b = sampler_.arrival(number, piece, own, hint);
    const visitResult r = sampler_.visit_.visit(b, piece, hint);
    const vector3& omega = r.state.rotation.omega;
    record
    (
        q.particle, r.state.V,
        dot(multiply(setup_.body.inertia(), omega), omega)
    );
    total_.addImpacts(r);
    total_.into += r.intoWall;
    total_.second += r.second;
    --work_.slots[q.slot]->users;
}


void impact::scatteringSampler::roughFlights::take(int i)
{
    const int k = boarded_ - batchStart_;
    copyLane
    (
        work_.arrivals, k, work_.rough, i,
        fieldsBefore(work_.rough, work_.rough.approach)
    );
    who_[i] = {boarded_, places_[k].slot, places_[k].at};
    ++boarded_;
}


void impact::scatteringSampler::roughFlights::board(int i)
{
    if (boarded_ == drawn_ && drawn_ < n_)
    {
        draw();
    }
    if (boarded_ < drawn_)
    {
        take(i);
        return;
    }
    --inFlight_;
    if (i < inFlight_)
    {
        copyLane
        (
            work_.rough, inFlight_, work_.rough, i,
            int(sizeof(roughLanes)/sizeof(roughLanes::lane))
        );
        who_[i] = who_[inFlight_];
    }
}


bool impact::scatteringSampler::roughFlights::serve(int i)
{
    while (i < inFlight_)
    {
        passenger& q = who_[i];
        const double status = work_.rough.status[i];
        if (status == roughStatus::window)
        {
            moveWindow
                (body_, work_.slots[q.slot]->piece, work_.rough, i, q.at);
        }
        else if (status == roughStatus::gone)
        {
            leave(i);
            board(i);
        }
        else if (status == roughStatus::special)
        {
            leaveToSearch(i);
            board(i);
        }
        else if (status == roughStatus::strikes && !impactsLeft(q))
        {
            // Would strike again, or strikes too often
            q.second = q.second || once_;
            total_.capped += !once_;
            leave(i);
            board(i);
        }
        else
        {
            return status == roughStatus::strikes;
        }
    }
    return false;
}


bool impact::scatteringSampler::roughFlights::impactsLeft
(
    const passenger& q
) const
{
    return q.contacts < (once_ ? 1 : setup_.maxImpacts);
}


void impact::scatteringSampler::roughFlights::strike
(
    int m,
    const int* struck,
    bool* outside
)
{
    roughLanes& hits = work_.impacts;
    const int whole = wholeVectors(m);
    for (int k = 0; k < whole; ++k)
    {
        copyLane
        (
            work_.rough, struck[std::min(k, m - 1)], hits, k,
            fieldsBefore(hits, hits.deep)
        );
    }
    if (byKernel_)
    {
        roughImpact(whole, body_, hits);
        return;
    }
    roughArrive(whole, hits);
    for (int k = 0; k < m; ++k)
    {
        outside[k] = strikeOne(setup_.law, body_, hits, k);
    }
    roughDepart(whole, body_, hits);
}


void impact::scatteringSampler::roughFlights::goOn(int i, int k, bool outside)
{
    roughLanes& l = work_.rough;
    const roughLanes& hits = work_.impacts;
    passenger& q = who_[i];
    if (!(hits.approach[k] > 0))
    {
        l.status[i] = roughStatus::special;
        return;
    }
    copyLane(hits, k, l, i, fieldsBefore(l, l.approach));
    q.second = q.second || q.contacts > 0;
    q.into = q.contacts > 0 ? q.into : l.V[1][i] <= 0;
    ++(hits.approach[k] > small_ ? q.impacts : q.micro);
    q.pulling += hits.pulling[k] > 0;
    q.gaining += hits.gaining[k] > 0;
    q.outside += outside;
    ++q.contacts;
}


void impact::scatteringSampler::roughFlights::run()
{
    roughLanes& l = work_.rough;
    for (; inFlight_ < std::min(roughBatch, n_); ++inFlight_)
    {
        if (boarded_ == drawn_)
        {
            draw();
        }
        take(inFlight_);
    }
    while (inFlight_ > 0)
    {
        int struck[roughBatch];
        int m = 0;
        for (int i = 0; i < inFlight_; ++i)
        {
            if (l.status[i] != roughStatus::flies && serve(i))
            {
                struck[m++] = i;
            }
        }
        bool outside[roughBatch] = {};
        strike(m, struck, outside);

        // Backwards: a lane may be taken by the last one
        for (int k = m - 1; k >= 0; --k)
        {
            goOn(struck[k], k, outside[k]);
            serve(struck[k]);
        }
        roughAdvance(wholeVectors(inFlight_), body_, l);
    }
}
