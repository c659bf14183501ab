/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorTargets.H"

#include "hopInline.H"

namespace
{

using namespace impact;

//- Unit of time of a hop with the angular velocity w and the rate of rising
//  Vy, by the radius
impactInline double hopUnit(const vector3& w, double Vy)
{
    // 1 over the next power of two: its exponent alone, and no division
    const double sum = std::fabs(w.x) + std::fabs(w.y) + std::fabs(w.z)
      + 1e-3*std::fabs(Vy) + 1e-100;
    const std::uint64_t exponent =
        __builtin_bit_cast(std::uint64_t, sum) & 0x7ff0000000000000ull;
    return __builtin_bit_cast(double, 0x7fd0000000000000ull - exponent);
}


//- What hops begin with, in double precision: loops that mix numbers of
//  different sizes become worse code
struct hopStart
{
    typedef double lane[lanesAtOnce + 8];

    lane height, rise, spin[3], outcome;
};

//- A hop that begins at the height y with the velocity Vy and the angular
//  velocity w
impactInline void beginHop
(
    double perRadius,
    double y,
    double Vy,
    const vector3& w,
    int j,
    hopStart& q
)
{
    const double rising = Vy*perRadius;
    const double unit = hopUnit(w, rising);
    q.height[j] = y*perRadius;
    q.rise[j] = rising*unit;
    put(unit*w, q.spin, j);
}

//- The same of n hops from number from on, with the normals m
impactInline void beginHops
(
    int from,
    int n,
    const hopStart& __restrict__ q,
    const double* __restrict__ mx,
    const double* __restrict__ my,
    const double* __restrict__ mz,
    smoothHops& __restrict__ h
)
{
    for (int j = 0; j < n; ++j)
    {
        const int i = from + j;
        h.height[i] = float(q.height[j]);
        h.rise[i] = float(q.rise[j]);
        h.spin[0][i] = float(q.spin[0][j]);
        h.spin[1][i] = float(q.spin[1][j]);
        h.spin[2][i] = float(q.spin[2][j]);
        h.m[0][i] = float(mx[j]);
        h.m[1][i] = float(my[j]);
        h.m[2][i] = float(mz[j]);
        h.outcome[i] = int(q.outcome[j]);
    }
}


//- Those of n hops that surely do not come back are gone
impactInline void cull
(
    int from,
    int n,
    const single3& a,
    float bend,
    smoothHops& __restrict__ h
)
{
    for (int i = from; i < from + n; ++i)
    {
        const bool leaves = boxLeaves
        (
            a, 1.f, bend, hopMargin, h.height[i], h.rise[i], at(h.spin, i),
            at(h.m, i)
        );
        const int outcome = h.outcome[i];
        h.outcome[i] = leaves & (outcome == hopOutcome::again)
          ? hopOutcome::gone : outcome;
    }
}


template<orientationLaw law>
impactInline void meet
(
    std::uint64_t seed,
    std::int64_t first,
    int n,
    const double* V,
    const smoothBody& b,
    bool decide,
    int to,
    smoothLanes& __restrict__ l,
    smoothHops& __restrict__ h,
    int* counts
)
{
    const double gone = hopOutcome::gone, again = hopOutcome::again;
    const double ifSinks = decide ? gone : again;
    const vector3 a = {b.a[0], b.a[1], b.a[2]};
    const double perRadius = 1/b.radius;
    const stillApproach arrival(V, b);
    std::int64_t pulling = 0, gaining = 0, into = 0;
    hopStart q;
    for (int from = 0; from < n; from += lanesAtOnce)
    {
        const int m = n - from < lanesAtOnce ? n - from : lanesAtOnce;
        drawOrientations<law>(seed, first + from, to + from, m, l);
        for (int j = 0; j < m; ++j)
        {
            const int i = to + from + j;
            const vector3 ex = at(l.ex, i);
            const vector3 ey = at(l.ey, i);
            const vector3 r = -signedHalf(a, ey);
            const double y = -dot(r, ey);
            const vector3 w =
                cornerJump(b, r, arrival.contactChange(ex, ey));
            const vector3 dV = arrival.change(ex, ey, w, r);
            const double Vy = arrival.V1 + dV.y;
            pulling += dV.y < 0;
            gaining += arrival.gains(dV);
            into += Vy <= 0;
            put(w, l.w, i);
            l.V[0][i] = arrival.V0 + dV.x;
            l.V[1][i] = Vy;
            l.V[2][i] = dV.z;
            q.outcome[j] = Vy > 0 ? again : ifSinks;
            beginHop(perRadius, y, Vy, w, j, q);
        }
        const int i = to + from;
        beginHops(from, m, q, l.ey[0] + i, l.ey[1] + i, l.ey[2] + i, h);
        for (int k = from; k < from + m; ++k)
        {
            h.slot[k] = to + k;
            h.contacts[k] = 1;
        }
    }
    cull(0, n, singleHalf(b), float(b.bend/b.radius), h);
    counts[1] = int(pulling);
    counts[2] = int(gaining);
    counts[3] = int(into);
}


//- What the loops of strike() hand on
struct strikeScratch
{
    typedef double lane[lanesAtOnce + 8];

    struct state
    {
        lane ex[3], ey[3], w[3], V[3];
    };

    state start;            // of the hop
    lane k[3], rate;        // unit angular momentum, rate of precession
    lane turnEnergy;        // twice that of rotation, by mass
    lane t;                 // of the contact
    state end;              // there; then after the impact
    lane r[3];              // contact point
    lane spinEnergy;        // twice that of rotation, by mass, after it
    lane there;             // has the contact been found? 1 or 0
    hopStart next;
};

constexpr std::size_t strikeStride = sizeof(strikeScratch::lane)/sizeof(double);


//- The start of the hops, and how the bodies turn
template<int axis>
impactInline void precess
(
    int from,
    int n,
    const hopBody<axis>& b,
    double perRadius,
    const smoothLanes& __restrict__ l,
    const smoothHops& __restrict__ h,
    strikeScratch& __restrict__ q
)
{
    for (int j = 0; j < n; ++j)
    {
        const int i = h.slot[from + j];
        copyColumns<stateColumns, strikeStride>(laneOf(l, i), laneOf(q.start, j));
        q.t[j] = h.end[from + j];
    }
    for (int j = 0; j < n; ++j)
    {
        const vector3 w = at(q.start.w, j);
        const vector3 L = multiply(b.J, w);
        const double size = std::sqrt(dot(L, L));
        const double unit = 1/nonZero(size);
        put(unit*L, q.k, j);
        q.rate[j] = size*b.inverse;
        q.turnEnergy[j] = dot(w, L);
        q.t[j] *= hopUnit(w, q.start.V[1][j]*perRadius);
    }
}


//- To the contact itself
template<int axis>
impactInline void reach
(
    int n,
    const hopBody<axis>& b,
    strikeScratch& __restrict__ q
)
{
    for (int j = 0; j < n; ++j)
    {
        const vector3 m0 = at(q.start.ey, j);
        const vector3 e0 = at(q.start.ex, j);
        const vector3 w0 = at(q.start.w, j);
        const double Vy = q.start.V[1][j];
        const double t = q.t[j];

        // With the angles theta = rate t of precession and phi = rateAxis t
        // about the axis of symmetry, a fixed direction in body components is
        // A + B cos(theta) + C sin(theta), turned by -phi
        const vector3 k = at(q.k, j);
        const double rate = q.rate[j];
        const double rateAxis = b.ratio*alongAxis<axis>(w0);
        double s, c, sf = 0, cf = 1;
        sinCos(rate*t, s, c);
        const vector3 A = dot(k, m0)*k;
        const vector3 B = m0 - A;
        const vector3 C = cross(m0, k);
        vector3 m = A + (c*B + s*C);
        vector3 w = w0;
        if (axis < 3)
        {
            sinCos(-rateAxis*t, sf, cf);
            turnAxis<axis>(sf, cf, m);
            turnAxis<axis>(sf, cf, w);
        }
        const vector3 mRate = cross(m, w);
        const vector3 mBend = cross(mRate, w)
          + cross(m, plusAxisCross<axis>(vector3{0, 0, 0}, rateAxis, w));
        const vector3 half = signedHalf(b.a, m);
        const double g = boxDepth(b.a, m0) + Vy*t - dot(half, m);
        const double r = Vy - dot(half, mRate);
        const double d = stepToZero(g, r, -dot(half, mBend), 1e-300);
        const double turning = rate + std::fabs(rateAxis);
        const bool there =
            (r < 0) & (t + d > 0) & (std::fabs(d)*turning < 2e-5);
        q.there[j] = there ? 1. : 0.;

        // The rest of the way: an angle so small that series end with its
        // second or third power
        const double x = rate*d, x2 = 0.5*x*x;
        const double sx = x - x*x2*(1./3), cx = 1 - x2;
        const double s1 = s*cx + c*sx;
        const double c1 = c*cx - s*sx;
        m = m + d*(mRate + (0.5*d)*mBend);
        const vector3 Ae = dot(k, e0)*k;
        const vector3 Be = e0 - Ae;
        const vector3 Ce = cross(e0, k);
        vector3 e = Ae + (c1*Be + s1*Ce);
        w = w0;
        if (axis < 3)
        {
            const double f = -rateAxis*d, f2 = 0.5*f*f;
            const double sd = f - f*f2*(1./3), cd = 1 - f2;
            const double sf1 = sf*cd + cf*sd;
            const double cf1 = cf*cd - sf*sd;
            turnAxis<axis>(sf1, cf1, e);
            turnAxis<axis>(sf1, cf1, w);
        }
        put(e, q.end.ex, j);
        put(m, q.end.ey, j);
        put(w, q.end.w, j);
        put(-half, q.r, j);
    }
}


//- The impact there
impactInline void rebound
(
    int n,
    const smoothBody& b,
    double small,
    strikeScratch& __restrict__ q,
    std::int64_t* counts
)
{
    const double again = hopOutcome::again;
    const double open = hopOutcome::open;
    const double perRadius = 1/b.radius;
    const double J0 = b.J[0], J1 = b.J[1], J2 = b.J[2];
    const double tangent = b.tangential - 1;
    const double bounce = b.normal + b.tangential;
    std::int64_t large = 0, pulling = 0, gaining = 0;
    for (int j = 0; j < n; ++j)
    {
        const vector3 ex = at(q.end.ex, j);
        const vector3 m = at(q.end.ey, j);
        const vector3 ez = cross(ex, m);
        const vector3 w = at(q.end.w, j);
        const vector3 r = at(q.r, j);
        const double V0 = q.start.V[0][j], V1 = q.start.V[1][j], V2 = q.start.V[2][j];
        const vector3 V = V0*ex + V1*m + V2*ez;

        const vector3 Vc = V + cross(w, r);
        const double vn = dot(Vc, m);
        const vector3 dVc = tangent*Vc - (bounce*vn)*m;
        const vector3 dw = cornerJump(b, r, dVc);
        const vector3 dV = dVc - cross(dw, r);

        // Work of the impulse at the mean velocity of its point; twice that,
        // and the energy
        const double change = dot(Vc + Vc + dVc, dV);
        const double before = V0*V0 + V1*V1 + V2*V2 + q.turnEnergy[j];
        const double away = dot(dV, m);
        const bool there = q.there[j] > 0;
        large += there & (-vn > small);
        pulling += there & (away < 0);
        gaining += there & (change > 1e-12*before);

        const vector3 w1 = w + dw;
        const double Vy1 = V1 + away;
        const double y = -dot(r, m);
        q.end.V[0][j] = V0 + dot(dV, ex);
        q.end.V[1][j] = Vy1;
        q.end.V[2][j] = V2 + dot(dV, ez);
        put(w1, q.end.w, j);
        q.spinEnergy[j] = J0*w1.x*w1.x + J1*w1.y*w1.y + J2*w1.z*w1.z;
        q.next.outcome[j] = there ? again : open;
        beginHop(perRadius, y, Vy1, w1, j, q.next);
    }
    counts[0] += large;
    counts[1] += pulling;
    counts[2] += gaining;
}


template<int axis>
impactInline int strike
(
    int n,
    const smoothBody& b,
    double small,
    const int* particles,
    smoothLanes& l,
    smoothHops& h,
    const smoothResults& results,
    int* counts
)
{
    const hopBody<axis> body(b);
    strikeScratch q;
    std::int64_t sums[3] = {};
    int missed = 0;
    for (int i = n; i < ((n + 7) & ~7); ++i)
    {
        h.slot[i] = spareLane;
    }
    for (int from = 0; from < n; from += lanesAtOnce)
    {
        const int rest = (n - from + 7) & ~7;
        const int m = rest < lanesAtOnce ? rest : lanesAtOnce;
        precess<axis>(from, m, body, 1/b.radius, l, h, q);
        reach<axis>(m, body, q);
        rebound(m, b, small, q, sums);
        beginHops(from, m, q.next, q.end.ey[0], q.end.ey[1], q.end.ey[2], h);
        cull(from, m, body.as, body.bend, h);

        // The state is wanted only where another hop begins
        int list[lanesAtOnce];
        int left = 0;
        for (int j = 0; j < m && from + j < n; ++j)
        {
            const int i = from + j;
            if (q.there[j] > 0)
            {
                const int particle = particles[h.slot[i]];
                results.V[0][particle] = q.end.V[0][j];
                results.V[1][particle] = q.end.V[1][j];
                results.V[2][particle] = q.end.V[2][j];
                results.spinEnergy[particle] = q.spinEnergy[j];
                ++h.contacts[i];
            }
            else
            {
                ++missed;
            }
            list[left] = j;
            left += h.outcome[i] == hopOutcome::again ? 1 : 0;
        }
        for (int k = 0; k < left; ++k)
        {
            copyColumns<stateColumns, smoothStride, strikeStride>
            (
                laneOf(q.end, list[k]), laneOf(l, h.slot[from + list[k]])
            );
        }
    }
    for (int k = 0; k < 3; ++k)
    {
        counts[k] = int(sums[k]);
    }
    return missed;
}

} // End anonymous namespace


namespace impact
{

impactKernel void hopMeet
(
    bool isotropic,
    std::uint64_t seed,
    std::int64_t first,
    int n,
    const double V[3],
    const smoothBody& b,
    bool decide,
    int to,
    smoothLanes& l,
    smoothHops& h,
    int counts[4]
)
{
    if (isotropic)
    {
        meet<orientationLaw::isotropic>
            (seed, first, n, V, b, decide, to, l, h, counts);
    }
    else
    {
        meet<orientationLaw::uniformEuler>
            (seed, first, n, V, b, decide, to, l, h, counts);
    }
}


impactKernel int hopStrike
(
    int n,
    const smoothBody& b,
    double small,
    const int* particles,
    smoothLanes& l,
    smoothHops& h,
    const smoothResults& results,
    int* counts
)
{
    return b.axis == 0 ? strike<0>(n, b, small, particles, l, h, results, counts)
      : b.axis == 1 ? strike<1>(n, b, small, particles, l, h, results, counts)
      : b.axis == 2 ? strike<2>(n, b, small, particles, l, h, results, counts)
      : strike<3>(n, b, small, particles, l, h, results, counts);
}

} // End namespace impact
