/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorTargets.H"

#include "hopKernels.H"
#include "smoothInline.H"

namespace
{

using namespace impact;

typedef vectorOf<float> single3;

//- Attempts to bring a hop to its end before it is left to the search step by
//  step
constexpr float manyAttempts = 8;

//- Of lengths by the radius: what single precision may get wrong, amply
constexpr float margin = 1e-5f;


//- Half sizes with the signs of the lowest corner's depth below the centre
template<class Real>
impactInline vectorOf<Real> signedHalf
(
    const vectorOf<Real>& a,
    const vectorOf<Real>& m
)
{
    return
    {
        m.x < 0 ? -a.x : a.x, m.y < 0 ? -a.y : a.y, m.z < 0 ? -a.z : a.z
    };
}


//- Depth of the lowest corner of a box below its centre
impactInline float boxDepth(const single3& a, const single3& m)
{
    return a.x*std::fabs(m.x) + a.y*std::fabs(m.y) + a.z*std::fabs(m.z);
}


//- Time derivative of the angular velocity w of a body that turns freely
template<int axis, class Real>
impactInline vectorOf<Real> spinRate(Real rateAxis, const vectorOf<Real>& w)
{
    return axis == 0 ? vectorOf<Real>{0, rateAxis*w.z, -rateAxis*w.y}
      : axis == 1 ? vectorOf<Real>{-rateAxis*w.z, 0, rateAxis*w.x}
      : axis == 2 ? vectorOf<Real>{rateAxis*w.y, -rateAxis*w.x, 0}
      : vectorOf<Real>{0, 0, 0};
}


//- Step to the zero of g + r x + q x^2/2 next to x = 0, r < 0: Halley's; never
//  more than twice that of Newton
template<class Real>
impactInline Real stepToZero(Real g, Real r, Real q, Real tiny)
{
    const Real r2 = r*r;
    const Real rest = 2*r2 - g*q;
    return -2*g*r/((rest > r2 ? rest : r2) + tiny);
}


//- What the kernels need to know of the body
template<int axis>
struct hopBody
{
    vector3 a, J;       // half sizes, moments of inertia per unit mass
    double inverse;     // inverse moment across the axis
    double ratio;       // of precession about the axis

    //- Half sizes by the radius, moments by that across the axis
    single3 as, Js;
    float ratioSingle;

    impactInline hopBody(const smoothBody& b)
    {
        a = {b.a[0], b.a[1], b.a[2]};
        J = {b.J[0], b.J[1], b.J[2]};
        const double across = axis == 0 ? J.y : J.x;
        const double along = axis == 0 ? J.x : axis == 1 ? J.y : J.z;
        inverse = 1/across;
        ratio = axis == 3 ? 0 : 1 - along/across;
        const double R = b.radius;
        as = {float(a.x/R), float(a.y/R), float(a.z/R)};
        Js =
        {
            float(J.x*inverse), float(J.y*inverse), float(J.z*inverse)
        };
        ratioSingle = float(ratio);
    }

    template<class Real>
    static impactInline Real along(const vectorOf<Real>& w)
    {
        return axis == 0 ? w.x : axis == 1 ? w.y : axis == 2 ? w.z : 0;
    }
};


template<int axis>
impactInline void begin
(
    int from,
    int to,
    const smoothBody& b,
    smoothHops& __restrict__ h
)
{
    const hopBody<axis> body(b);
    const double perRadius = 1/b.radius;
    for (int i = from; i < to; ++i)
    {
        const double rising = h.V[1][i]*perRadius;
        const double unit = 1/
        (
            std::fabs(h.w[0][i]) + std::fabs(h.w[1][i])
          + std::fabs(h.w[2][i]) + 1e-3*std::fabs(rising) + 1e-100
        );
        h.unit[i] = unit;
        h.height[i] = float(h.y[i]*perRadius);
        h.rise[i] = float(rising*unit);
        h.spin[0][i] = float(h.w[0][i]*unit);
        h.spin[1][i] = float(h.w[1][i]*unit);
        h.spin[2][i] = float(h.w[2][i]*unit);
        h.m[0][i] = float(h.ey[0][i]);
        h.m[1][i] = float(h.ey[1][i]);
        h.m[2][i] = float(h.ey[2][i]);
    }
    for (int i = from; i < to; ++i)
    {
        const single3 w = at(h.spin, i);
        const single3 L = multiply(body.Js, w);
        const float turn = std::sqrt(dot(L, L));
        put((1/(turn + 1e-10f))*L, h.k, i);
        h.turn[i] = turn;
        h.turnAlong[i] = body.ratioSingle*body.along(w);
        h.elapsed[i] = 0;
        h.trial[i] = 0;
        h.attempts[i] = 0;
    }
}


//- What the loops of look() hand on
struct hopScratch
{
    typedef float lane[lanesAtOnce];

    lane t, comes, longest;
};


//- A turned body
struct turnedHop
{
    single3 m, w, rate, bend;   // rate, bend: derivatives of the normal
    float s, c, sf, cf;
};

//- At the time t, in a series good to 1e-6 up to t turn = 2
template<int axis>
impactInline turnedHop turned(const smoothHops& h, int i, float t)
{
    turnedHop q;
    const float x = h.turn[i]*t, x2 = x*x;
    q.s = x*(1 - x2*(1.f/6 - x2*(1.f/120 - x2*(1.f/5040
      - x2*(1.f/362880 - x2*(1.f/39916800))))));
    q.c = x2*(0.5f - x2*(1.f/24 - x2*(1.f/720
      - x2*(1.f/40320 - x2*(1.f/3628800)))));
    const single3 m0 = at(h.m, i);
    const single3 k = at(h.k, i);
    q.m = m0 + q.s*cross(m0, k) - q.c*(m0 - dot(k, m0)*k);
    q.w = at(h.spin, i);
    const float rateAxis = h.turnAlong[i];
    if (axis < 3)
    {
        const float f = rateAxis*t, f2 = f*f;
        q.sf = -f*(1 - f2*(1.f/6 - f2*(1.f/120 - f2*(1.f/5040
          - f2*(1.f/362880)))));
        q.cf = 1 - f2*(0.5f - f2*(1.f/24 - f2*(1.f/720
          - f2*(1.f/40320 - f2*(1.f/3628800)))));
        turnAxis<axis>(q.sf, q.cf, q.m);
        turnAxis<axis>(q.sf, q.cf, q.w);
    }
    q.rate = cross(q.m, q.w);
    q.bend = cross(q.rate, q.w) + cross(q.m, spinRate<axis>(rateAxis, q.w));
    return q;
}


//- Were the normal m(t) in body components linear in time, with m' = m x w,
//  the height of the lowest corner were concave and made of straight pieces:
//  steps of Newton's from a later time towards where it comes down
impactInline void guessStraight
(
    int from,
    int n,
    const single3& a,
    const smoothHops& __restrict__ h,
    hopScratch& __restrict__ q
)
{
    for (int j = 0; j < n; ++j)
    {
        const int i = from + j;
        const single3 m0 = at(h.m, i);
        const single3 p = cross(m0, at(h.spin, i));
        const float y = h.height[i], Vy = h.rise[i];
        const float turning = h.turn[i] + std::fabs(h.turnAlong[i]);
        const float slow = 1e-6f*(std::fabs(Vy) + turning) + 1e-10f;
        const float longest = 2/(turning + 1e-6f);
        float t = longest;
        #pragma GCC unroll 2
        for (int step = 0; step < 2; ++step)
        {
            const single3 m = m0 + t*p;
            const single3 s = signedHalf(a, m);
            const float height = y + Vy*t - dot(s, m);
            const float fall = dot(s, p) - Vy;
            const float next = t + height/(std::fabs(fall) + slow);
            t = (height <= 0) & (fall > 0) & (next > 0) ? next : t;
        }
        q.t[j] = t;
        q.longest[j] = longest;
    }
}


//- A step of Halley's towards the zero of the height, if it falls, from a
//  time at which the normal and its derivatives are known
impactInline void guessStep
(
    const single3& a,
    const smoothHops& h,
    int i,
    const single3& m,
    const single3& rate,
    const single3& bend,
    int j,
    hopScratch& __restrict__ q
)
{
    const float t = q.t[j];
    const single3 half = signedHalf(a, m);
    const float g = h.height[i] + h.rise[i]*t - dot(half, m);
    const float r = h.rise[i] - dot(half, rate);
    const float next = t + stepToZero(g, r, -dot(half, bend), 1e-20f);
    const bool comes = (r < 0) & (next > 0) & (next < q.longest[j]);
    q.t[j] = comes ? next : t;
    q.comes[j] = comes ? 1.f : 0.f;
}


//- A step with the series of third degree of the normal
template<int axis>
impactInline void guessSeries
(
    int from,
    int n,
    const single3& a,
    const smoothHops& __restrict__ h,
    hopScratch& __restrict__ q
)
{
    for (int j = 0; j < n; ++j)
    {
        const int i = from + j;
        const float t = q.t[j];
        const single3 m0 = at(h.m, i);
        const single3 w = at(h.spin, i);
        const float rateAxis = h.turnAlong[i];
        const single3 p = cross(m0, w);
        single3 c = cross(p, w);
        single3 d = cross(c, w);
        if (axis < 3)
        {
            const single3 dw = spinRate<axis>(rateAxis, w);
            const single3 f = cross(m0, dw);
            c = c + f;
            d = d + cross(f, w) + cross(2*p, dw)
              + cross(m0, spinRate<axis>(rateAxis, dw));
        }
        const single3 td = t*d;
        const single3 bend = c + td;
        const single3 rate = p + t*(c + 0.5f*td);
        const single3 m = m0 + t*(p + (0.5f*t)*(c + (1.f/3)*td));
        guessStep(a, h, i, m, rate, bend, j, q);
    }
}


//- A step with the rotation itself
template<int axis>
impactInline void guessTurning
(
    int from,
    int n,
    const single3& a,
    const smoothHops& __restrict__ h,
    hopScratch& __restrict__ q
)
{
    for (int j = 0; j < n; ++j)
    {
        const int i = from + j;
        const turnedHop b = turned<axis>(h, i, q.t[j]);
        guessStep(a, h, i, b.m, b.rate, b.bend, j, q);
    }
}


//- Where to look: next to the contact; those that seem not to strike, where
//  they are out of reach
template<bool decide>
impactInline void chooseTrial
(
    int from,
    int n,
    const smoothHops& __restrict__ h,
    hopScratch& __restrict__ q
)
{
    const float beyond = decide ? 1.03f : 1.f;
    for (int j = 0; j < n; ++j)
    {
        const int i = from + j;
        const float longest = q.longest[j];
        const float out = (1.0001f - h.height[i])
           /(0.5f*(h.rise[i] + std::fabs(h.rise[i])) + 1e-12f);
        const bool comes = (q.comes[j] > 0) & (q.t[j] < out);
        const float end = comes ? beyond*q.t[j] : out;

        // What turns far is not found clear all the way: half of it, or less,
        // at first
        const bool isFar = end > 0.8f*longest;
        const float half = 0.5f*end < 0.45f*longest ? 0.5f*end : 0.45f*longest;
        const float t = isFar ? half : end;
        const float guess = comes & !isFar ? t : -t;
        q.t[j] = h.trial[i] == 0 ? guess : h.trial[i];
    }
}


//- With m(t) the normal in body components, a body at y(t) is no lower than
//  y - H(m), H its support. Between 0 and t the cubic with the values and
//  rates of m at both ends is off by at most M u^2 (t - u)^2/24, M the largest
//  fourth derivative; H is convex: it is at most that at the five control
//  points of the cubic in Bernstein's form of fourth degree, weighted, and so
//  the height is positive if it is so at those points: the middle three heights
impactInline single3 clearance
(
    const single3& a,
    float y,
    float Vy,
    float t,
    float turning,
    const single3& m0,
    const single3& rate0,
    const single3& m1,
    const single3& rate1
)
{
    const float third = t*(1.f/3);
    const single3 p1 = m0 + third*rate0;
    const single3 p2 = m1 - third*rate1;
    const float x = turning*t, x2 = x*x;
    const float error = 1.0001f*x2*x2*(1.f/144);
    return
    {
        y + 0.25f*t*Vy - boxDepth(a, 0.25f*(m0 + 3.f*p1)),
        y + 0.5f*t*Vy - boxDepth(a, 0.5f*(p1 + p2)) - error,
        y + 0.75f*t*Vy - boxDepth(a, 0.25f*(3.f*p2 + m1))
    };
}


//- What is certain at the time chosen
template<int axis, bool decide>
impactInline void judge
(
    int from,
    int n,
    const single3& a,
    smoothHops& __restrict__ h,
    const hopScratch& __restrict__ q
)
{
    for (int j = 0; j < n; ++j)
    {
        const int i = from + j;
        const float t = std::fabs(q.t[j]);
        const bool seems = q.t[j] > 0;
        const turnedHop b = turned<axis>(h, i, t);
        const float turning = h.turn[i] + std::fabs(h.turnAlong[i]);
        const float y = h.height[i], Vy = h.rise[i];
        const single3 m0 = at(h.m, i);
        const single3 w0 = at(h.spin, i);
        const single3 k0 = at(h.k, i);
        const float elapsed = h.elapsed[i], attempts = h.attempts[i];
        const single3 half = signedHalf(a, b.m);
        const float g = y + Vy*t - dot(half, b.m);
        const float r = Vy - dot(half, b.rate);

        // On from here to the contact, if it is so close that the series of
        // second degree is good, and no corner can change its place with
        // another nor the lowest one turn back within the angle reach. The
        // bound may vanish a little before the height does, within that.
        const float q2 = dot(half, b.bend);
        const float step = stepToZero(g, r, -q2, 1e-20f);
        const float angle = std::fabs(step)*turning;
        const float reach = 4*angle + 10*margin;
        const bool alone =
            (a.x*std::fabs(b.m.x) > reach) & (a.y*std::fabs(b.m.y) > reach)
          & (a.z*std::fabs(b.m.z) > reach);
        const single3 heights =
            clearance(a, y, Vy, t, turning, m0, cross(m0, w0), b.m, b.rate);
        const float early = seems ? 0.25f*std::fabs(g)*t*turning : 0.f;
        const bool clear = (heights.x > margin) & (heights.y > margin)
          & ((heights.z - margin)*reach > early);
        const bool out = (Vy > 0) & (y + Vy*t >= 1.00005f);
        const bool gone = clear & out & (g > margin);

        const float end = t + step;
        const bool falls = seems & (end > 0)
          & (r*turning + std::fabs(q2)*reach < 0);
        const bool close = angle < 3e-3f;
        const bool strikes = decide
          ? seems & (g < -margin) : falls & clear & alone & close;
        const bool nearly = !decide & falls & (angle < 0.5f) & !strikes
          & (clear | !close);
        const bool still = clear & !seems & !gone & (g > 2*margin);

        // What else is left is looked at half as far, unless it does not even
        // begin by rising enough to be told from round-off
        const bool more = (attempts < manyAttempts)
          & ((heights.x > margin) | (t*turning > 0.4f));
        const bool again = !(strikes | gone) & more;
        h.outcome[i] = int
        (
            hopOutcome::strikes*(strikes ? 1.f : 0.f)
          + hopOutcome::gone*(gone & !strikes ? 1.f : 0.f)
          + hopOutcome::open*(strikes | gone | again ? 0.f : 1.f)
        );
        h.attempts[i] = attempts + 1;
        h.trial[i] = nearly ? end : still ? 0.f : -0.5f*t;
        h.end[i] = h.unit[i]*double(elapsed + end);

        // Those that are still in flight: from here on
        single3 k = k0;
        turnAxis<axis>(b.sf, b.cf, k);
        h.elapsed[i] = still ? elapsed + t : elapsed;
        h.height[i] = still ? y + Vy*t : y;
        put(chosen(still, b.m, m0), h.m, i);
        put(chosen(still, b.w, w0), h.spin, i);
        put(chosen(still, k, k0), h.k, i);
    }
}


template<int axis, bool decide>
impactInline void look(int n, const smoothBody& b, smoothHops& h)
{
    const hopBody<axis> body(b);
    hopScratch q;
    for (int from = 0; from < n; from += lanesAtOnce)
    {
        // Whole vectors: what lies behind the last hop is an old one, and
        // harmless
        const int rest = (n - from + 15) & ~15;
        const int m = rest < lanesAtOnce ? rest : lanesAtOnce;
        guessStraight(from, m, body.as, h, q);
        guessSeries<axis>(from, m, body.as, h, q);
        guessTurning<axis>(from, m, body.as, h, q);
        chooseTrial<decide>(from, m, h, q);
        judge<axis, decide>(from, m, body.as, h, q);
    }
}


//- What the loops of strike() hand on: unit angular momentum at the start and
//  rate of precession; state at the contact, which is at r
struct strikeScratch
{
    typedef double lane[lanesAtOnce];

    lane k[3], rate;
    lane ex[3], ey[3], w[3], r[3], missed;
};


//- The rotation of the hops: a loop of its own, since root and division take
//  long and what follows needs them at once
template<int axis>
impactInline void precess
(
    int from,
    int n,
    const hopBody<axis>& b,
    const smoothLanes& __restrict__ l,
    strikeScratch& __restrict__ q
)
{
    for (int j = 0; j < n; ++j)
    {
        const int i = from + j;
        const vector3 w = at(l.w, i);
        const vector3 L = multiply(b.J, w);
        const double size = std::sqrt(dot(L, L));
        const double unit = 1/nonZero(size);
        put(unit*L, q.k, j);
        q.rate[j] = size*b.inverse;
    }
}


//- To the contact itself
template<int axis>
impactInline void reach
(
    int from,
    int n,
    const hopBody<axis>& b,
    const smoothLanes& __restrict__ l,
    strikeScratch& __restrict__ q
)
{
    for (int j = 0; j < n; ++j)
    {
        const int i = from + j;
        const vector3 m0 = at(l.ey, i);
        const vector3 e0 = at(l.ex, i);
        const vector3 w0 = at(l.w, i);
        const double Vy = l.V[1][i];
        const double t = l.end[i];

        // With the angles theta = rate t of precession and phi = rateAxis t
        // about the axis of symmetry, a fixed direction in body components is
        // A + B cos(theta) + C sin(theta), turned by -phi
        const vector3 k = at(q.k, j);
        const double rate = q.rate[j];
        const double rateAxis = b.ratio*b.along(w0);
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
        const vector3 mBend =
            cross(mRate, w) + cross(m, spinRate<axis>(rateAxis, w));
        const vector3 half = signedHalf(b.a, m);
        const double g = l.y[i] + Vy*t - dot(half, m);
        const double r = Vy - dot(half, mRate);
        const double d = stepToZero(g, r, -dot(half, mBend), 1e-300);
        const double turning = rate + std::fabs(rateAxis);
        const bool there =
            (r < 0) & (t + d > 0) & (std::fabs(d)*turning < 2e-5);
        q.missed[j] = there ? 0. : 1.;

        // The rest of the way: sines and cosines of angles so small that
        // their series end with the third power
        const double x = rate*d, x2 = 0.5*x*x;
        const double sx = x - x*x2*(1./3), cx = 1 - x2;
        const double s1 = s*cx + c*sx;
        const double c1 = c*cx - s*sx;
        m = A + (c1*B + s1*C);
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
            turnAxis<axis>(sf1, cf1, m);
            turnAxis<axis>(sf1, cf1, e);
            turnAxis<axis>(sf1, cf1, w);
        }
        put(e, q.ex, j);
        put(m, q.ey, j);
        put(w, q.w, j);
        put(-half, q.r, j);
    }
}


//- The impact there
impactInline void rebound
(
    int from,
    int n,
    const smoothBody& b,
    const strikeScratch& __restrict__ q,
    smoothLanes& __restrict__ l,
    int* __restrict__ missed
)
{
    const double J0 = b.J[0], J1 = b.J[1], J2 = b.J[2];
    const double tangent = b.tangential - 1;
    const double bounce = b.normal + b.tangential;
    for (int j = 0; j < n; ++j)
    {
        const int i = from + j;
        const vector3 ex = at(q.ex, j);
        const vector3 m = at(q.ey, j);
        const vector3 ez = cross(ex, m);
        const vector3 w = at(q.w, j);
        const vector3 r = at(q.r, j);
        const double V0 = l.V[0][i], V1 = l.V[1][i], V2 = l.V[2][i];
        const vector3 V = V0*ex + V1*m + V2*ez;

        const vector3 Vc = V + cross(w, r);
        const double vn = dot(Vc, m);
        const vector3 dVc = tangent*Vc - (bounce*vn)*m;
        const vector3 dw = cornerJump(b, r, dVc);
        const vector3 dV = dVc - cross(dw, r);

        // Work of the impulse at the mean velocity of its point
        const double change = dot(Vc + 0.5*dVc, dV);
        const double before = 0.5
           *(dot(V, V) + J0*w.x*w.x + J1*w.y*w.y + J2*w.z*w.z);
        const double away = dot(dV, m);
        l.approach[i] = -vn;
        l.contacts[i] += 1;
        l.pulling[i] = away < 0 ? 1. : 0.;
        l.gaining[i] = change > 1e-12*before ? 1. : 0.;

        const vector3 w1 = w + dw;
        const double Vy1 = V1 + away;
        const double y = -dot(r, m);
        l.spinEnergy[i] = J0*w1.x*w1.x + J1*w1.y*w1.y + J2*w1.z*w1.z;
        l.mayReturn[i] = int(boxLeaves(b, y, Vy1, w1, m) ? 0. : 1.);
        missed[i] = int(q.missed[j]);
        l.y[i] = y;
        l.V[0][i] = V0 + dot(dV, ex);
        l.V[1][i] = Vy1;
        l.V[2][i] = V2 + dot(dV, ez);
        put(w1, l.w, i);
        put(ex, l.ex, i);
        put(m, l.ey, i);
    }
}


template<int axis>
impactInline int strike
(
    int n,
    const smoothBody& b,
    smoothLanes& l,
    int* missed
)
{
    const hopBody<axis> body(b);
    strikeScratch q;
    int sum = 0;
    for (int from = 0; from < n; from += lanesAtOnce)
    {
        const int rest = (n - from + 7) & ~7;
        const int m = rest < lanesAtOnce ? rest : lanesAtOnce;
        precess<axis>(from, m, body, l, q);
        reach<axis>(from, m, body, l, q);
        rebound(from, m, b, q, l, missed);
    }
    for (int i = 0; i < n; ++i)
    {
        sum += missed[i];
    }
    return sum;
}

} // End anonymous namespace


namespace impact
{

impactKernel void hopBegin
(
    int from,
    int to,
    const smoothBody& b,
    smoothHops& h
)
{
    b.axis == 0 ? begin<0>(from, to, b, h)
  : b.axis == 1 ? begin<1>(from, to, b, h)
  : b.axis == 2 ? begin<2>(from, to, b, h)
  : begin<3>(from, to, b, h);
}


impactKernel void hopLook
(
    int n,
    const smoothBody& b,
    bool decide,
    smoothHops& h
)
{
    if (decide)
    {
        b.axis == 0 ? look<0, true>(n, b, h)
      : b.axis == 1 ? look<1, true>(n, b, h)
      : b.axis == 2 ? look<2, true>(n, b, h)
      : look<3, true>(n, b, h);
    }
    else
    {
        b.axis == 0 ? look<0, false>(n, b, h)
      : b.axis == 1 ? look<1, false>(n, b, h)
      : b.axis == 2 ? look<2, false>(n, b, h)
      : look<3, false>(n, b, h);
    }
}


impactKernel int hopStrike
(
    int n,
    const smoothBody& b,
    smoothLanes& l,
    int* missed
)
{
    return b.axis == 0 ? strike<0>(n, b, l, missed)
      : b.axis == 1 ? strike<1>(n, b, l, missed)
      : b.axis == 2 ? strike<2>(n, b, l, missed)
      : strike<3>(n, b, l, missed);
}

} // End namespace impact
