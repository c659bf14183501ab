/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorTargets.H"

#include "philoxLanes.H"
#include "roughShadows.H"

namespace
{

using namespace impact;
using namespace impact::roughShadows;

//- Trials of one flight after which it is left to the general search
constexpr double manyTrials = 2000;

//- \tparam number  of intervals that the shadow may lie over
template<roughBody::shapeType shape, int number>
impactInline void advance
(
    int n,
    const roughBody& body,
    roughLanes& __restrict__ l
)
{
    const double R = body.radius;
    const double a = body.a, b = body.b, c = body.c;
    const double tolerance = contactTolerance*R;
    const double allowed = allowedDepth*R;
    for (int i = 0; i < n; ++i)
    {
        const double tau = l.tau[i];
        const double t1 = l.t[i] + tau;
        const double Vx = l.V[0][i];
        const double Vy = l.V[1][i];
        const double cx = l.x[i] + Vx*t1;
        const double cy = l.y[i] + Vy*t1;
        vector3 u = {1, 0, 0}, v = {0, 1, 0};
        if (shape != roughBody::sphere)
        {
            turnTo(l, i, t1, shape == roughBody::box, u, v);
        }

        // Half the width of the shadow
        double width = R, lean = 0, depth = R;
        vector3 g0, g1, g2;
        if (shape == roughBody::spheroid)
        {
            const double a2 = a*a, b2 = b*b;
            const double Qxx = b2*(1 - u.x*u.x) + a2*u.x*u.x;
            width = std::sqrt(Qxx);
            lean = (a2 - b2)*u.x*u.y/Qxx;
            depth = b*std::sqrt(a2*(1 - u.z*u.z) + b2*u.z*u.z)/width;
        }
        else if (shape == roughBody::box)
        {
            const vector3 w = cross(u, v);
            g0 = towardsX({a*u.x, a*u.y, a*u.z});
            g1 = towardsX({b*v.x, b*v.y, b*v.z});
            g2 = towardsX({c*w.x, c*w.y, c*w.z});
            width = g0.x + g1.x + g2.x;
        }

        const ground<number> under(l, i, cx - width);
        lowestPoint low;
        bool settled = true, sharp = false;
        if (shape == roughBody::box)
        {
            low = lowestOfBox(cx, cy, g0, g1, g2, R, under);
        }
        else
        {
            double p = l.p[i];
            settled = lowestOfArc<shape>
            (
                cx, cy, body, u, {width, lean, depth}, l.steep[i], under, p,
                sharp, low
            );
            l.p[i] = p;
        }

        double rate1 = Vy - low.slope*Vx;
        if (shape != roughBody::sphere)
        {
            const vector3 L = get(l.axisL, i);
            const double wL = l.rateL[i], wu = l.rateAxis[i];
            const double wx = wL*L.x + wu*u.x;
            const double wy = wL*L.y + wu*u.y;
            const double wz = wL*L.z + wu*u.z;
            rate1 = rate1 + (wz*low.r.x - wx*low.r.z)
              - low.slope*(wy*low.r.z - wz*low.r.y);
        }

        // See searchStep
        const double g1_ = low.gap;
        const double g0_ = l.gap[i];
        const double reach = l.reach[i];
        const double least = l.least[i];
        const double above = positivePart(g1_);
        const double root0 = std::sqrt(g0_ + allowed);
        const double root1 = std::sqrt(above + allowed);
        const bool pierced = pierces(g1_, tolerance);
        const bool clear = isClear(pierced, root0, root1, reach, tau, least);
        const bool falling = rate1 < 0;
        const bool touches = clear & isContact(g1_, rate1, tolerance);
        const bool stuck = pierced & (tau <= least);
        const bool strikes = settled & (touches | (stuck & falling));
        const bool moves = settled & clear & !touches;
        const double trials = l.trials[i] + 1;
        const bool special =
            sharp | (settled & stuck & !falling) | (trials > manyTrials);

        const double back =
            stepBack(tau, g0_, g1_, root0, rate1, reach, 1e-30*R);
        const double shorter = stepShorter(tau, root0, root1, reach);
        const double longer = stepAhead(above, root1, rate1, reach, 0.9);

        // None at a height above all of the window. (As a part of `leaves' or
        // as one side of a selection, what is loaded here would be loaded in
        // a branch, for the lanes that want it: the others would compute with
        // whatever their register held, and might trap)
        const double below = cy - l.deep[i] > under.top ? 0. : 1e300;
        const double room = smaller(below, l.end[i] - t1);
        const double onward = smaller(larger(longer, least), room);

        const double again = larger(pierced ? back : shorter, least);
        const double next = moves ? onward : again;
        const bool leaves = moves & (room <= least);
        const double wish = leaves ? roughStatus::window : 0.;
        const double ended = strikes ? roughStatus::strikes : wish;
        l.status[i] = special ? roughStatus::special : ended;
        l.trials[i] = trials;
        l.t[i] = moves ? t1 : l.t[i];
        l.gap[i] = moves ? above : g0_;
        l.tau[i] = strikes | !settled ? tau : next;
        l.rate[i] = rate1;
        l.slope[i] = low.slope;
        put(l.r, i, low.r);
    }
}


template<int number>
impactInline void advanceOver(int n, const roughBody& body, roughLanes& l)
{
    body.shape == roughBody::sphere
  ? advance<roughBody::sphere, number>(n, body, l)
  : body.shape == roughBody::spheroid
  ? advance<roughBody::spheroid, number>(n, body, l)
  : advance<roughBody::box, number>(n, body, l);
}


//- Begin a flight with angular velocity w and half extents of the shadow
impactInline void begin
(
    const roughBody& body,
    const vector3& V,
    const vector3& u,
    const vector3& w,
    double deep,
    double wide,
    roughLanes& l,
    int i
)
{
    const double R = body.radius;
    const double along = dot(w, u);
    const double extra = (body.Ja - body.Jc)*along;
    const vector3 L =
    {
        body.Jc*w.x + extra*u.x,
        body.Jc*w.y + extra*u.y,
        body.Jc*w.z + extra*u.z
    };
    const double magL = std::sqrt(L.x*L.x + L.y*L.y + L.z*L.z);
    const double unit = 1/nonZero(magL);
    const double w2 = dot(w, w);
    const double magW = std::sqrt(w2);
    const double speed = std::sqrt(V.x*V.x + V.y*V.y);
    put(l.axisL, i, {unit*L.x, unit*L.y, unit*L.z});
    l.rateL[i] = magL/body.Jc;
    l.rateAxis[i] = along*(1 - body.Ja/body.Jc);
    l.deep[i] = deep;
    l.wide[i] = wide;
    l.turning[i] = body.bend*w2;
    l.speedX[i] = std::fabs(V.x) + magW*body.lever;
    l.least[i] = leastWay*R/(speed + magW*R + 1e-100);
    l.t[i] = 0;
    l.gap[i] = 0;
    l.tau[i] = 0;
    l.trials[i] = 0;
    l.status[i] = roughStatus::window;
}

} // End anonymous namespace


namespace impact
{

impactKernel void roughAdvance(int n, const roughBody& body, roughLanes& l)
{
    body.wide ? advanceOver<3>(n, body, l) : advanceOver<2>(n, body, l);
}


impactKernel void roughImpact
(
    int n,
    const roughBody& body,
    roughLanes& __restrict__ l
)
{
    const double Ja = body.Ja, Jc = body.Jc;
    const double R = body.radius;
    const double tangent = body.tangential - 1;
    const double bounce = body.normal + body.tangential;
    for (int i = 0; i < n; ++i)
    {
        const double t1 = l.t[i] + l.tau[i];
        vector3 u, v;
        turnTo(l, i, t1, true, u, v);
        const vector3 axis = get(l.axisL, i);
        const double wL = l.rateL[i], wu = l.rateAxis[i];
        const vector3 w =
        {
            wL*axis.x + wu*u.x, wL*axis.y + wu*u.y, wL*axis.z + wu*u.z
        };
        const vector3 V = get(l.V, i);
        const vector3 r = get(l.r, i);
        const double steep = l.slope[i];
        const double secant = std::sqrt(1 + steep*steep);
        const double cosine = 1/secant;
        const vector3 m = {-cosine*steep, cosine, 0};

        const vector3 Vc = V + cross(w, r);
        const double vn = dot(Vc, m);
        const vector3 dVc = tangent*Vc - (bounce*vn)*m;

        // spinChange() of reboundLaw.H, the parts along and across the axis
        const double r2 = dot(r, r);
        const double ia = 1/(Ja + r2);
        const double ic = 1/(Jc + r2);
        const vector3 b = cross(r, dVc);
        const double ru = dot(r, u);
        const double bu = dot(b, u);
        const vector3 rc = r - ru*u;
        const vector3 q = ic*(b - bu*u) + (ia*bu)*u;
        const vector3 d = ic*rc + (ia*ru)*u;
        const double rest = Jc*ic*dot(rc, rc) + Ja*ia*ru*ru;
        const double f = dot(r, q)*r2/rest;
        const vector3 dw = q + f*d;
        const vector3 dV = dVc - cross(dw, r);

        const double extra = Ja - Jc;
        const vector3 H = Jc*w + (extra*dot(w, u))*u;
        const vector3 dH = Jc*dw + (extra*dot(dw, u))*u;
        const double before = 0.5*(dot(V, V) + dot(w, H));
        const double change =
            dot(V, dV) + 0.5*dot(dV, dV) + dot(w, dH) + 0.5*dot(dw, dH);
        l.approach[i] = -vn;
        l.pulling[i] = dot(dV, m) < 0 ? 1. : 0.;
        l.gaining[i] = change > 1e-12*before ? 1. : 0.;

        const vector3 V2 = V + dV;
        const vector3 w2 = w + dw;
        l.x[i] = l.x[i] + V.x*t1;
        l.y[i] = l.y[i] + V.y*t1;
        put(l.V, i, V2);
        put(l.u, i, u);
        put(l.v, i, v);
        begin(body, V2, u, w2, R, R, l, i);
        l.rate[i] = dot(m, V2 + cross(w2, r))*secant;
    }
}


impactKernel void roughArrive
(
    int n,
    roughLanes& __restrict__ l
)
{
    for (int i = 0; i < n; ++i)
    {
        const double t1 = l.t[i] + l.tau[i];
        vector3 u, v;
        turnTo(l, i, t1, true, u, v);
        const vector3 axis = get(l.axisL, i);
        const double wL = l.rateL[i], wu = l.rateAxis[i];
        put
        (
            l.w, i,
            {wL*axis.x + wu*u.x, wL*axis.y + wu*u.y, wL*axis.z + wu*u.z}
        );
        l.x[i] = l.x[i] + l.V[0][i]*t1;
        l.y[i] = l.y[i] + l.V[1][i]*t1;
        put(l.u, i, u);
        put(l.v, i, v);
    }
}


impactKernel void roughDepart
(
    int n,
    const roughBody& body,
    roughLanes& __restrict__ l
)
{
    const double R = body.radius;
    for (int i = 0; i < n; ++i)
    {
        const vector3 V = get(l.V, i);
        const vector3 w = get(l.w, i);
        const vector3 at = V + cross(w, get(l.r, i));
        begin(body, V, get(l.u, i), w, R, R, l, i);
        l.rate[i] = at.y - l.slope[i]*at.x;
    }
}


impactKernel void roughLaunch
(
    int n,
    const roughBody& body,
    double wx,
    double wy,
    double wz,
    roughLanes& __restrict__ l
)
{
    const double a = body.a, b = body.b, c = body.c;
    const double R = body.radius;
    const bool box = body.shape == roughBody::box;
    const vector3 omega = {wx, wy, wz};
    const bool still = dot(omega, omega) == 0;
    for (int i = 0; i < n; ++i)
    {
        const vector3 u = get(l.u, i);
        const vector3 v = get(l.v, i);
        const vector3 w = cross(u, v);

        // A body that does not turn keeps its shadow
        const double a2 = a*a, b2 = b*b;
        const double boxWide =
            a*std::fabs(u.x) + b*std::fabs(v.x) + c*std::fabs(w.x);
        const double boxDeep =
            a*std::fabs(u.y) + b*std::fabs(v.y) + c*std::fabs(w.y);
        const double ovalWide =
            std::sqrt(positivePart(b2*(1 - u.x*u.x)) + a2*u.x*u.x);
        const double ovalDeep =
            std::sqrt(positivePart(b2*(1 - u.y*u.y)) + a2*u.y*u.y);
        const double wide = 1.000001*(box ? boxWide : ovalWide);
        const double deep = 1.000001*(box ? boxDeep : ovalDeep);
        begin
        (
            body, get(l.V, i), u, omega, still ? deep : R,
            still ? wide : R, l, i
        );
        l.rate[i] = 0;
        l.p[i] = 0;
    }
}


impactKernel void roughPositions
(
    std::uint64_t seed,
    std::uint32_t attempt,
    std::int64_t first,
    int n,
    double* __restrict__ u0,
    double* __restrict__ u1
)
{
    for (int i = 0; i < n; ++i)
    {
        std::uint64_t w0, w1, w2, w3;
        philoxLane
        (
            seed, attempt, drawPurpose::position, std::uint64_t(first + i),
            w0, w1, w2, w3
        );
        double unused;
        threeUnits(w0, w1, w2, w3, u0[i], u1[i], unused);
    }
}

} // End namespace impact
