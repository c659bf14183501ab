/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorTargets.H"

#include "hopInline.H"

namespace
{

using namespace impact;

//- Attempts to bring a hop to its end before it is left to the search step by
//  step
constexpr float manyAttempts = 8;


//- What the loops of look() hand on
struct hopScratch
{
    typedef float lane[lanesAtOnce + 16];

    lane p[3];              // derivative of the normal at the start
    lane c[3], d[3];        // m x L, (m x L) x L; L by the moment across
    lane turn2;             // L^2
    lane along;             // rate about the axis
    lane turning;           // bound of all rates
    lane w2, mL;            // w^2, m . L, which stay as they are
    lane t, comes, longest;
};


//- How the bodies turn
template<int axis>
impactInline void precession
(
    int from,
    int n,
    const hopBody<axis>& body,
    const smoothHops& __restrict__ h,
    hopScratch& __restrict__ q
)
{
    for (int j = 0; j < n; ++j)
    {
        // L = w - f e, e along the axis
        const single3 m = at(h.m, from + j);
        const single3 w = at(h.spin, from + j);
        const float wAxis = alongAxis<axis>(w);
        const float f = body.ratioSingle*wAxis;
        const single3 L =
        {
            axis == 0 ? w.x - f : w.x,
            axis == 1 ? w.y - f : w.y,
            axis == 2 ? w.z - f : w.z
        };
        const single3 p = cross(m, w);
        const single3 c = plusAxisCross<axis>(p, -f, m);
        const float turn2 = dot(L, L);
        const float turning = std::sqrt(turn2) + std::fabs(f);
        put(p, q.p, j);
        put(c, q.c, j);
        put(cross(c, L), q.d, j);
        q.turn2[j] = turn2;
        q.along[j] = f;
        q.turning[j] = turning;
        q.w2[j] = turn2 + f*(wAxis + wAxis - f);
        q.mL[j] = dot(m, L);
        q.longest[j] = 2/(turning + 1e-6f);
    }
}


//- The normal at the time t, and the angular velocity, in series good to 1e-6
//  up to t turn = 2; those of a guess to 1e-3
template<int axis, bool guess>
impactInline void turned
(
    const smoothHops& h,
    int i,
    const hopScratch& q,
    int j,
    float t,
    single3& m,
    single3& w
)
{
    const float t2 = t*t, x2 = q.turn2[j]*t2;
    const float s = guess
      ? t*(1 - x2*(1.f/6 - x2*(1.f/120 - x2*(1.f/5040))))
      : t*(1 - x2*(1.f/6 - x2*(1.f/120 - x2*(1.f/5040
          - x2*(1.f/362880 - x2*(1.f/39916800))))));
    const float c = guess
      ? t2*(0.5f - x2*(1.f/24 - x2*(1.f/720)))
      : t2*(0.5f - x2*(1.f/24 - x2*(1.f/720
          - x2*(1.f/40320 - x2*(1.f/3628800)))));
    m = at(h.m, i) + s*at(q.c, j) + c*at(q.d, j);
    w = at(h.spin, i);
    if (axis < 3)
    {
        const float f = q.along[j]*t, f2 = f*f;
        const float sf = guess
          ? -f*(1 - f2*(1.f/6 - f2*(1.f/120)))
          : -f*(1 - f2*(1.f/6 - f2*(1.f/120 - f2*(1.f/5040
              - f2*(1.f/362880)))));
        const float cf = guess
          ? 1 - f2*(0.5f - f2*(1.f/24 - f2*(1.f/720)))
          : 1 - f2*(0.5f - f2*(1.f/24 - f2*(1.f/720
              - f2*(1.f/40320 - f2*(1.f/3628800)))));
        turnAxis<axis>(sf, cf, m);
        turnAxis<axis>(sf, cf, w);
    }
}


//- Second derivative of the depth half . m of a corner, depth itself known:
//  half . ((m x w) x w + f m x (w x e)), by products of vectors alone; m . L
//  does not change
template<int axis>
impactInline float depthBend
(
    const hopScratch& q,
    int j,
    float depth,
    const single3& half,
    const single3& m,
    const single3& w
)
{
    const float f = q.along[j];
    const float mAxis = alongAxis<axis>(m);
    const float mw = q.mL[j] + f*mAxis;
    return dot(half, w)*(mw + f*mAxis) - depth*q.w2[j]
      - f*alongAxis<axis>(half)*mw;
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
        const single3 p = at(q.p, j);
        const float y = h.height[i], Vy = h.rise[i];
        const float slow = 1e-6f*(std::fabs(Vy) + q.turning[j]) + 1e-10f;
        float t = q.longest[j];
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
    }
}


//- A step of Halley's towards the zero of the height, if it falls
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
        const float t = q.t[j];
        single3 m, w;
        turned<axis, true>(h, i, q, j, t, m, w);
        const single3 half = signedHalf(a, m);
        const float depth = dot(half, m);
        const float g = h.height[i] + h.rise[i]*t - depth;
        const float r = h.rise[i] - dot(m, cross(w, half));
        const float bend = depthBend<axis>(q, j, depth, half, m, w);
        const float next = t + stepToZero(g, r, -bend, 1e-20f);
        const bool comes = (r < 0) & (next > 0) & (next < q.longest[j]);
        q.t[j] = comes ? next : t;
        q.comes[j] = comes ? 1.f : 0.f;
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
    const float quarter = 0.25f*t;
    const float v = quarter*Vy;
    const float x = turning*t, x2 = x*x;
    const float error = 1.0001f*x2*x2*(1.f/144);
    return
    {
        y + v - boxDepth(a, m0 + quarter*rate0),
        y + (v + v) - error
          - 0.5f*boxDepth(a, m0 + m1 + (t*(1.f/3))*(rate0 - rate1)),
        y + (v + v + v) - boxDepth(a, m1 - quarter*rate1)
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
        single3 m, w;
        turned<axis, false>(h, i, q, j, t, m, w);
        const float turning = q.turning[j];
        const float y = h.height[i], Vy = h.rise[i];
        const single3 m0 = at(h.m, i);
        const single3 w0 = at(h.spin, i);
        const float elapsed = h.elapsed[i], attempts = h.attempts[i];
        const single3 half = signedHalf(a, m);
        const single3 rate = cross(m, w);
        const float depth = dot(half, m);
        const float g = y + Vy*t - depth;
        const float r = Vy - dot(half, rate);

        // On from here to the contact, if it is so close that the series of
        // second degree is good, and no corner can change its place with
        // another nor the lowest one turn back within the angle reach. The
        // bound may vanish a little before the height does, within that.
        const float q2 = depthBend<axis>(q, j, depth, half, m, w);
        const float step = stepToZero(g, r, -q2, 1e-20f);
        const float angle = std::fabs(step)*turning;
        const float reach = 4*angle + 10*hopMargin;
        const bool alone =
            (a.x*std::fabs(m.x) > reach) & (a.y*std::fabs(m.y) > reach)
          & (a.z*std::fabs(m.z) > reach);
        const single3 heights =
            clearance(a, y, Vy, t, turning, m0, at(q.p, j), m, rate);
        const float early = seems ? 0.25f*std::fabs(g)*t*turning : 0.f;
        const bool clear = (heights.x > hopMargin) & (heights.y > hopMargin)
          & ((heights.z - hopMargin)*reach > early);
        const bool out = (Vy > 0) & (y + Vy*t >= 1.00005f);
        const bool gone = clear & out & (g > hopMargin);

        const float end = t + step;
        const bool falls = seems & (end > 0)
          & (r*turning + std::fabs(q2)*reach < 0);
        const bool close = angle < 3e-3f;
        const bool strikes = decide
          ? seems & (g < -hopMargin) : falls & clear & alone & close;
        const bool nearly = !decide & falls & (angle < 0.5f) & !strikes
          & (clear | !close);
        const bool still = clear & !seems & !gone & (g > 2*hopMargin);

        // What else is left is looked at half as far, unless it does not even
        // begin by rising enough to be told from round-off
        const bool more = (attempts < manyAttempts)
          & ((heights.x > hopMargin) | (t*turning > 0.4f));
        const bool again = !(strikes | gone) & more;
        h.outcome[i] = int
        (
            hopOutcome::strikes*(strikes ? 1.f : 0.f)
          + hopOutcome::gone*(gone & !strikes ? 1.f : 0.f)
          + hopOutcome::open*(strikes | gone | again ? 0.f : 1.f)
        );
        h.attempts[i] = attempts + 1;
        h.trial[i] = nearly ? end : still ? 0.f : -0.5f*t;
        h.end[i] = elapsed + end;

        // Those that are still in flight: from here on
        h.elapsed[i] = still ? elapsed + t : elapsed;
        h.height[i] = still ? y + Vy*t : y;
        put(chosen(still, m, m0), h.m, i);
        put(chosen(still, w, w0), h.spin, i);
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
        precession<axis>(from, m, body, h, q);
        guessStraight(from, m, body.as, h, q);
        guessTurning<axis>(from, m, body.as, h, q);
        guessTurning<axis>(from, m, body.as, h, q);
        chooseTrial<decide>(from, m, h, q);
        judge<axis, decide>(from, m, body.as, h, q);
    }
}

} // End anonymous namespace


namespace impact
{

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


impactKernel int hopCount
(
    int n,
    int most,
    smoothHops& __restrict__ h,
    int& second,
    int& capped
)
{
    int struck = 0, seconds = 0, over = 0;
    for (int i = 0; i < n; ++i)
    {
        const int contacts = h.contacts[i];
        const int outcome = h.outcome[i];
        const int strikes = outcome == hopOutcome::strikes ? 1 : 0;
        const int ends = contacts >= most ? strikes : 0;
        struck += strikes - ends;
        seconds += contacts == 1 ? strikes - ends : 0;
        over += ends;
        h.outcome[i] = ends > 0 ? hopOutcome::gone : outcome;
    }
    second = seconds;
    capped = over;
    return struck;
}

} // End namespace impact
