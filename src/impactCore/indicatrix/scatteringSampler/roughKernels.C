/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorTargets.H"

#include "roughKernels.H"
#include "elementary.H"
#include "philoxLanes.H"
#include "searchStep.H"
#include "vector3.H"

namespace
{

using namespace impact;

//- Trials of one flight after which it is left to the general search
constexpr double manyTrials = 2000;

//- Newton steps of one trial; an ellipse that needs more goes on in the next
constexpr int newtonSteps = 4;


//- v turned about the unit vector k
impactInline vector3 turned
(
    const vector3& v,
    const vector3& k,
    double s,
    double c
)
{
    const double d = (1 - c)*(k.x*v.x + k.y*v.y + k.z*v.z);
    return
    {
        c*v.x + s*(k.y*v.z - k.z*v.y) + d*k.x,
        c*v.y + s*(k.z*v.x - k.x*v.z) + d*k.y,
        c*v.z + s*(k.x*v.y - k.y*v.x) + d*k.z
    };
}


impactInline vector3 get(const roughLanes::lane* l, int i)
{
    return {l[0][i], l[1][i], l[2][i]};
}


impactInline void put(roughLanes::lane* l, int i, const vector3& v)
{
    l[0][i] = v.x;
    l[1][i] = v.y;
    l[2][i] = v.z;
}


struct cubic
{
    double x0, c0, c1, c2, c3;

    impactInline double height(double x) const
    {
        const double u = x - x0;
        return c0 + u*(c1 + u*(c2 + u*c3));
    }

    impactInline double slope(double x) const
    {
        const double u = x - x0;
        return c1 + u*(2*c2 + 3*u*c3);
    }

    impactInline double bend(double x) const
    {
        return 2*c2 + 6*(x - x0)*c3;
    }
};


impactInline cubic chosen(bool second, const cubic& p, const cubic& q)
{
    return
    {
        second ? q.x0 : p.x0,
        second ? q.c0 : p.c0,
        second ? q.c1 : p.c1,
        second ? q.c2 : p.c2,
        second ? q.c3 : p.c3
    };
}


impactInline cubic interval(const roughLanes& l, int k, int i)
{
    return {l.x0[k][i], l.c0[k][i], l.c1[k][i], l.c2[k][i], l.c3[k][i]};
}


//- The intervals under a shadow
template<int number>
struct ground
{
    cubic part[number];
    double split[number];   // where the next one begins
    double top;

    impactInline cubic at(double x) const
    {
        cubic c = chosen(x >= split[0], part[0], part[1]);
        if (number > 2)
        {
            c = chosen(x >= split[number - 2], c, part[number - 1]);
        }
        return c;
    }

    //- Lane i, from its second interval on if the shadow has left the first
    impactInline ground(const roughLanes& l, int i, double left)
    {
        const bool later = left >= l.x0[1][i];
        top = -1e300;
        for (int k = 0; k < number; ++k)
        {
            part[k] =
                chosen(later, interval(l, k, i), interval(l, k + 1, i));
            const double t = later ? l.top[k + 1][i] : l.top[k][i];
            top = larger(top, t);
        }
        for (int k = 0; k < number; ++k)
        {
            split[k] = k + 1 < number ? part[k + 1].x0 : 1e300;
        }
    }
};


//- The point of least height above the relief
struct lowestPoint
{
    double gap, x, slope;
    vector3 r;              // from the centre
};


//- A corner of the shadow, at r from the centre
template<int number>
impactInline void offerCorner
(
    double cx,
    double cy,
    const vector3& r,
    const ground<number>& under,
    lowestPoint& best
)
{
    const double x = cx + r.x;
    const double gap = cy + r.y - under.at(x).height(x);
    const bool lower = gap < best.gap;
    best.gap = lower ? gap : best.gap;
    best.x = lower ? x : best.x;
    best.r.x = lower ? r.x : best.r.x;
    best.r.y = lower ? r.y : best.r.y;
    best.r.z = lower ? r.z : best.r.z;
}


//- The crest of an interval that the edge from r to r + 2 g may touch
//  between xa and xb
impactInline void offerCrest
(
    double cx,
    double cy,
    const vector3& r,
    const vector3& g,
    double m,
    double xa,
    double xb,
    double R,
    const cubic& s,
    lowestPoint& best
)
{
    // Where the relief has the slope m, falling: of the two forms of the
    // root, the one without cancellation
    const double a = s.c1 - m;
    const double square = s.c2*s.c2 - 3*s.c3*a;
    const double root = std::sqrt(positivePart(square));
    const bool direct = s.c2 <= 0;
    const double num = direct ? a : -s.c2 - root;
    const double den = direct ? root - s.c2 : 3*s.c3;
    const double sign = den < 0 ? -1. : 1.;
    const double ratio = sign*num/(std::fabs(den) + 1e-100);
    const double u = larger(smaller(ratio, 1e6*R), -1e6*R);
    const double x = s.x0 + u;
    const double far = 2*g.x;
    const double f = (x - cx - r.x)/(far + 1e-12*R);
    const vector3 at = {r.x + f*far, r.y + 2*f*g.y, r.z + 2*f*g.z};
    const double gap =
        cy + at.y - (s.c0 + u*(s.c1 + u*(s.c2 + u*s.c3)));
    const bool lower =
        (square > 0) & (x > xa) & (x < xb) & (gap < best.gap);
    best.gap = lower ? gap : best.gap;
    best.x = lower ? x : best.x;
    best.r.x = lower ? at.x : best.r.x;
    best.r.y = lower ? at.y : best.r.y;
    best.r.z = lower ? at.z : best.r.z;
}


impactInline vector3 towardsX(const vector3& g)
{
    const double s = g.x < 0 ? -1. : 1.;
    return {s*g.x, s*g.y, s*g.z};
}


//- Exchange two segments unless a rises less than b
impactInline void bySlope(vector3& a, vector3& b)
{
    const bool swap = a.y*b.x > b.y*a.x;
    const vector3 p = a, q = b;
    a = {swap ? q.x : p.x, swap ? q.y : p.y, swap ? q.z : p.z};
    b = {swap ? p.x : q.x, swap ? p.y : q.y, swap ? p.z : q.z};
}


impactInline vector3 sum(const vector3& a, const vector3& b, double f)
{
    return {a.x + f*b.x, a.y + f*b.y, a.z + f*b.z};
}


//- Orientation after the time t
impactInline void turnTo
(
    const roughLanes& l,
    int i,
    double t,
    bool side,
    vector3& u,
    vector3& v
)
{
    const vector3 axis = get(l.axisL, i);
    double s, c;
    sinCos(l.rateL[i]*t, s, c);
    const vector3 u0 = get(l.u, i);
    u = turned(u0, axis, s, c);
    if (side)
    {
        double s2, c2;
        sinCos(l.rateAxis[i]*t, s2, c2);
        const vector3 v0 = get(l.v, i);
        const vector3 w0 = cross(u0, v0);
        const vector3 v1 =
        {
            c2*v0.x + s2*w0.x, c2*v0.y + s2*w0.y, c2*v0.z + s2*w0.z
        };
        v = turned(v1, axis, s, c);
    }
}


//- The lowest point of a box over the relief; g0, g1, g2: the half edges of
//  its shadow, towards x
template<int number>
impactInline lowestPoint lowestOfBox
(
    double cx,
    double cy,
    vector3 g0,
    vector3 g1,
    vector3 g2,
    double R,
    const ground<number>& under
)
{
    const double tiny = 1e-12*R;
    lowestPoint low;
    bySlope(g0, g1);
    bySlope(g1, g2);
    bySlope(g0, g1);
    const vector3 half = sum(sum(g0, g1, 1), g2, 1);
    const vector3 v0 = {-half.x, -half.y, -half.z};
    const vector3 v1 = sum(v0, g0, 2);
    const vector3 v2 = sum(v1, g1, 2);
    low.r = v0;
    low.x = cx + v0.x;
    low.gap = cy + v0.y - under.at(low.x).height(low.x);
    offerCorner(cx, cy, v1, under, low);
    offerCorner(cx, cy, v2, under, low);
    offerCorner(cx, cy, half, under, low);

    const double x0 = cx + v0.x, x1 = cx + v1.x;
    const double x2 = cx + v2.x, x3 = cx + half.x;
    const double m0 = g0.y/(g0.x + tiny);
    const double m1 = g1.y/(g1.x + tiny);
    const double m2 = g2.y/(g2.x + tiny);
    auto crest = [&]
    (
        const vector3& r,
        const vector3& g,
        double m,
        double xa,
        double xb
    ) __attribute__((always_inline))
    {
        #pragma GCC unroll 3
        for (int k = 0; k < number; ++k)
        {
            const double from = k > 0 ? under.split[k - 1] : xa;
            offerCrest
            (
                cx, cy, r, g, m, larger(xa, from),
                smaller(xb, under.split[k]), R, under.part[k], low
            );
        }
    };
    crest(v0, g0, m0, x0, x1);
    crest(v1, g1, m1, x1, x2);
    crest(v2, g2, m2, x2, x3);
    low.slope = under.at(low.x).slope(low.x);
    return low;
}


//- The lower arc of an elliptic shadow
struct shadowArc
{
    double width, lean, depth;
};


//- The lowest point of an ellipsoid over the relief
//  \param steep  largest slope of the relief
//  \param p  where on the arc it was lowest, and is
//  \param sharp  the relief bends more than the arc: there may be two
//  \return  has Newton's method settled?
template<roughBody::shapeType shape, int number>
impactInline bool lowestOfArc
(
    double cx,
    double cy,
    const roughBody& body,
    const vector3& u,
    const shadowArc& arc,
    double steep,
    const ground<number>& under,
    double& p,
    bool& sharp,
    lowestPoint& low
)
{
    const double R = body.radius, a = body.a, b = body.b;
    const double width = arc.width, lean = arc.lean, depth = arc.depth;

    // The slope of the lower arc is lean + p depth/width at
    // xi = p/sqrt(1 + p^2). A relief that nowhere under it bends as
    // much as the arc where that is flattest has one lowest point
    const double f = width/depth;
    const double left = cx - width;
    const double right = cx + width;
    double bend =
        larger(under.at(left).bend(left), under.at(right).bend(right));
    for (int k = 0; k + 1 < number; ++k)
    {
        const double at = under.split[k];
        const double there = under.part[k + 1].bend(at);
        const bool more = (left < at) & (right > at) & (there > bend);
        bend = more ? there : bend;
    }
    sharp = !(bend*width*f < 0.999);

    double lo = (-steep - lean)*f*1.0001 - 1e-6;
    double hi = (steep - lean)*f*1.0001 + 1e-6;
    double at = p;
    at = (at > lo) & (at < hi) ? at : 0.5*(lo + hi);
    bool settled = false;
    #pragma GCC unroll 4
    for (int k = 0; k < newtonSteps; ++k)
    {
        const double s = 1/std::sqrt(1 + at*at);
        const double x = cx + width*at*s;
        const cubic in = under.at(x);
        const double e = at - (in.slope(x) - lean)*f;
        const double rate = 1 - in.bend(x)*f*width*s*s*s;
        lo = e > 0 ? lo : at;
        hi = e > 0 ? at : hi;
        const double step = e/(positivePart(rate - 1e-3) + 1e-3);
        const double next = at - step;

        // An error of p left here comes back squared
        settled = std::fabs(step) <= 1e-5*(1 + std::fabs(at));
        const bool good = settled | ((next > lo) & (next < hi));
        at = good ? next : 0.5*(lo + hi);
    }
    p = at;
    const double s = 1/std::sqrt(1 + at*at);
    const double xi = at*s;
    low.x = cx + width*xi;
    const cubic in = under.at(low.x);
    low.slope = in.slope(low.x);
    low.gap =
        cy + lean*width*xi - depth*s - in.height(low.x);
    if (shape == roughBody::sphere)
    {
        low.r = {R*xi, -R*s, 0};
    }
    else
    {
        // The support along the outward normal of the arc
        const double m = lean + at/f;
        const double un = m*u.x - u.y;
        const double a2 = a*a, b2 = b*b;
        const double across2 = b2*(m*m + 1 - un*un);
        const double g =
            1/std::sqrt(positivePart(across2) + a2*un*un);
        const double d = (a2 - b2)*un;
        low.r =
        {
            g*(b2*m + d*u.x), g*(d*u.y - b2), g*d*u.z
        };
    }
    return settled;
}


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
        const bool pierced = g1_ < -tolerance;
        const bool shortest = tau <= least;
        const bool falling = rate1 < 0;
        const bool clear =
            (!pierced) & (clears(root0, root1, reach, tau) | shortest);
        const bool touches = clear & falling & (g1_ <= tolerance);
        const bool stuck = pierced & shortest;
        const bool strikes = settled & (touches | (stuck & falling));
        const bool moves = settled & clear & !touches;
        const double trials = l.trials[i] + 1;
        const bool special =
            sharp | (settled & stuck & !falling) | (trials > manyTrials);

        const double back =
            stepBack(tau, g0_, g1_, root0, rate1, reach, 1e-30*R);
        const double shorter = stepShorter(tau, root0, root1, reach);
        const double longer = stepAhead(above, root1, rate1, reach, 0.9);
        const double room = l.end[i] - t1;
        const double onward = smaller(larger(longer, least), room);

        const double again = larger(pierced ? back : shorter, least);
        const double next = moves ? onward : again;
        const bool leaves =
            moves
          & ((room <= least) | (cy - l.deep[i] > under.top));
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
