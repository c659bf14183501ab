/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "samplerWorkspace.H"
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


//- Who flies in a lane
struct passenger
{
    int particle;           // of the block
    int slot;               // of the relief
    std::int64_t at;        // an interval near it
    int contacts = 0;
    int impacts = 0, micro = 0, pulling = 0, gaining = 0, outside = 0;
    bool second = false, into = false;
};


//- Where a particle of the batch of arrivals begins
struct arrivalPlace
{
    int slot;
    std::int64_t at;
};


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
    const double B =
        1.0001
       *(
            l.turning[i]*std::sqrt(1 + steep*steep)
          + crest*l.speedX[i]*l.speedX[i]
        )
      + 1e-30*fastest*fastest/body.radius;
    const double reach = std::sqrt(2/B);
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


void impact::scatteringSampler::setRoughBody()
{
    const convexBody& body = setup_.body;
    const relief& wall = *setup_.wall;
    const reboundLaw& law = setup_.law;
    const bool ellipsoid =
        body.shape() == convexBody::shapeType::ellipsoid;
    const double R = body.radius();
    const double shortest = wall.meanSpacing() - 3*wall.sigmaSpacing();

    vectorRough_ =
        body.symmetryAxis() >= 0 && (ellipsoid || body.isBox())
     && law.normal().least() > 0
     && stretch_ < 512
     && 2.001*R < 2*shortest;
    if (!vectorRough_)
    {
        return;
    }
    const int axis = body.symmetryAxis() % 3;
    const vector3& half = body.semiAxes();
    rough_.shape = body.isSphere() ? roughBody::sphere
      : ellipsoid ? roughBody::spheroid : roughBody::box;
    rough_.a = half[axis];
    rough_.b = half[(axis + 1) % 3];
    rough_.c = half[(axis + 2) % 3];
    rough_.Ja = body.inertia()[axis];
    rough_.Jc = body.inertia()[(axis + 1) % 3];
    rough_.radius = R;
    rough_.wide = 2.001*R > shortest;
    rough_.lever = R - body.leastCurvature();
    rough_.bend = rough_.lever*(1 + freeRotation::skewness(body));
    rough_.top = wall.top();
    rough_.normal = smooth_.normal;
    rough_.tangential = smooth_.tangential;
}


void impact::scatteringSampler::sampleRandomRelief
(
    std::int64_t first,
    int n,
    workspace& w,
    scatteringStatistics& result
) const
{
    const relief& wall = *setup_.wall;
    const bool once =
        setup_.treatment == visitTreatment::firstImpact;
    const bool oneByOne =
        setup_.law.law() != reboundLaw::lawType::restitution
     || !setup_.law.isConstant();
    const double small = 1e-3*mag(V1_);
    const double V[3] = {V1_.x, V1_.y, V1_.z};
    const double spin[3] = {setup_.spin.x, setup_.spin.y, setup_.spin.z};
    const double start = wall.top() + setup_.body.radius();
    const double longest = wall.meanSpacing() + 3*wall.sigmaSpacing();
    const int axis = setup_.body.symmetryAxis() % 3;
    const int side = (axis + 1) % 3;
    const vector3& J = setup_.body.inertia();

    roughLanes& l = w.rough;
    roughLanes& arrivals = w.arrivals;
    roughLanes& hits = w.impacts;
    const int flightFields = fieldsBefore(l, l.approach);
    const int impactFields = fieldsBefore(l, l.deep);
    const int allFields = int(sizeof(roughLanes)/sizeof(roughLanes::lane));

    visitCounts total;
    passenger who[roughBatch];
    arrivalPlace places[roughBatch];
    int inFlight = 0;
    int drawn = 0, boarded = 0, batchStart = 0;
    std::int64_t identity = -1;
    int slot = -1;

    // The next particles, up to a batch of them, above their relief
    auto draw = [&]
    {
        const int m = std::min(roughBatch, n - drawn);
        batchStart = drawn;
        smoothArrive
        (
            setup_.orientation == orientationLaw::isotropic, setup_.seed,
            first + drawn, m, V, spin, smooth_, w.lanes
        );
        const smoothLanes& s = w.lanes;
        for (int i = 0; i < m; ++i)
        {
            const vector3 ex = {s.ex[0][i], s.ex[1][i], s.ex[2][i]};
            const vector3 ey = {s.ey[0][i], s.ey[1][i], s.ey[2][i]};
            const vector3 ez = cross(ex, ey);
            arrivals.u[0][i] = ex[axis];
            arrivals.u[1][i] = ey[axis];
            arrivals.u[2][i] = ez[axis];
            arrivals.v[0][i] = ex[side];
            arrivals.v[1][i] = ey[side];
            arrivals.v[2][i] = ez[side];
            arrivals.V[0][i] = V1_.x;
            arrivals.V[1][i] = V1_.y;
            arrivals.V[2][i] = V1_.z;
            arrivals.y[i] = start;
        }

        // As in arrival()
        const int tries = 4;
        double u0[tries][roughBatch], u1[tries][roughBatch];
        for (int k = 0; k < 2; ++k)
        {
            roughPositions(setup_.seed, k, first + drawn, m, u0[k], u1[k]);
        }
        for (int i = 0; i < m; ++i)
        {
            const std::int64_t number = first + drawn + i;
            if (number/perPiece_ != identity)
            {
                identity = number/perPiece_;
                slot = 0;
                while (slot < int(w.slots.size()) && w.slots[slot]->users)
                {
                    ++slot;
                }
                if (slot == int(w.slots.size()))
                {
                    w.slots.emplace_back
                    (
                        new reliefSlot{reliefPiece(wall, setup_.seed), 0}
                    );
                }
                w.slots[slot]->piece.start
                (
                    std::uint64_t(identity), perPiece_*stretch_
                );
            }
            reliefPiece& piece = w.slots[slot]->piece;
            ++w.slots[slot]->users;
            std::int64_t at = (number - identity*perPiece_)*stretch_;
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
                    roughPositions
                        (setup_.seed, attempt, number, 1, &p0, &p1);
                }
                const double begin = piece.knot(at);
                const double length = piece.knot(at + 1) - begin;
                if (p0*longest < length)
                {
                    arrivals.x[i] = begin + p1*length;
                    break;
                }
            }
            places[i] = {slot, at};
        }
        roughLaunch
        (
            wholeVectors(m), rough_, setup_.spin.x, setup_.spin.y,
            setup_.spin.z, arrivals
        );
        drawn += m;
    };

    auto record = [&](int particle, const vector3& v, double spinEnergy)
    {
        w.Vx[particle] = v.x;
        w.Vy[particle] = v.y;
        w.Vz[particle] = v.z;
        w.spinEnergy[particle] = spinEnergy;
    };

    // The visit of lane i is over; V and spin are those of its flight
    auto leave = [&](int i)
    {
        const passenger& q = who[i];
        const vector3 u = {l.u[0][i], l.u[1][i], l.u[2][i]};
        const vector3 omega =
            l.rateL[i]*vector3{l.axisL[0][i], l.axisL[1][i], l.axisL[2][i]}
          + l.rateAxis[i]*u;
        const double along = dot(omega, u);
        record
        (
            q.particle, {l.V[0][i], l.V[1][i], l.V[2][i]},
            rough_.Jc*dot(omega, omega)
          + (rough_.Ja - rough_.Jc)*along*along
        );
        total.impacts += q.impacts;
        total.micro += q.micro;
        total.pulling += q.pulling;
        total.gaining += q.gaining;
        total.outside += q.outside;
        total.second += q.second;
        total.into += q.into;
        --w.slots[q.slot]->users;
    };

    // The whole visit by the general search
    auto leaveToSearch = [&](int i)
    {
        const passenger& q = who[i];
        reliefPiece& piece = w.slots[q.slot]->piece;
        const std::int64_t number = first + q.particle;
        std::int64_t own = number/perPiece_, hint = 0;
        const bodyState b = arrival(number, piece, own, hint);
        const visitResult r = visit_.visit(b, piece, hint);
        const vector3& omega = r.state.rotation.omega;
        record(q.particle, r.state.V, dot(multiply(J, omega), omega));
        total.addImpacts(r);
        total.into += r.intoWall;
        total.second += r.second;
        --w.slots[q.slot]->users;
    };

    // The next particle into lane i, or the last lane if there is none left
    auto board = [&](int i)
    {
        if (boarded == drawn && drawn < n)
        {
            draw();
        }
        if (boarded < drawn)
        {
            const int k = boarded - batchStart;
            copyLane(arrivals, k, l, i, flightFields);
            who[i] = {boarded, places[k].slot, places[k].at};
            ++boarded;
            return;
        }
        --inFlight;
        if (i < inFlight)
        {
            copyLane(l, inFlight, l, i, allFields);
            who[i] = who[inFlight];
        }
    };

    // Serve lane i until it flies or strikes; it may be another body then
    auto serve = [&](int i)
    {
        while (i < inFlight)
        {
            const double status = l.status[i];
            if (status == roughStatus::window)
            {
                reliefPiece& piece = w.slots[who[i].slot]->piece;
                moveWindow(rough_, piece, l, i, who[i].at);
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
            else if
            (
                status == roughStatus::strikes
             && (
                    (once && who[i].contacts > 0)
                 || who[i].contacts >= setup_.maxImpacts
                )
            )
            {
                // Would strike again, or strikes too often
                who[i].second = who[i].second || once;
                total.capped += !once;
                leave(i);
                board(i);
            }
            else
            {
                return status == roughStatus::strikes;
            }
        }
        return false;
    };

    for (; inFlight < std::min(roughBatch, n); ++inFlight)
    {
        const int i = inFlight;
        if (boarded == drawn)
        {
            draw();
        }
        copyLane(arrivals, i, l, i, flightFields);
        who[i] = {boarded, places[i].slot, places[i].at};
        ++boarded;
    }
    while (inFlight > 0)
    {
        int struck[roughBatch];
        int m = 0;
        for (int i = 0; i < inFlight; ++i)
        {
            if (l.status[i] != roughStatus::flies && serve(i))
            {
                struck[m++] = i;
            }
        }
        for (int k = 0; k < wholeVectors(m); ++k)
        {
            const int i = struck[std::min(k, m - 1)];
            copyLane(l, i, hits, k, impactFields);
        }
        bool outside[roughBatch] = {};
        if (oneByOne)
        {
            roughArrive(wholeVectors(m), hits);
            for (int k = 0; k < m; ++k)
            {
                outside[k] = strikeOne(setup_.law, rough_, hits, k);
            }
            roughDepart(wholeVectors(m), rough_, hits);
        }
        else
        {
            roughImpact(wholeVectors(m), rough_, hits);
        }

        // Backwards: a lane may be taken by the last one
        for (int k = m - 1; k >= 0; --k)
        {
            const int i = struck[k];
            passenger& q = who[i];
            if (!(hits.approach[k] > 0))
            {
                l.status[i] = roughStatus::special;
            }
            else
            {
                copyLane(hits, k, l, i, flightFields);
                q.second = q.second || q.contacts > 0;
                q.into = q.contacts > 0 ? q.into : l.V[1][i] <= 0;
                ++(hits.approach[k] > small ? q.impacts : q.micro);
                q.pulling += hits.pulling[k] > 0;
                q.gaining += hits.gaining[k] > 0;
                q.outside += outside[k];
                ++q.contacts;
            }
            serve(i);
        }
        roughAdvance(wholeVectors(inFlight), rough_, l);
    }
    total.addTo(result);
}
