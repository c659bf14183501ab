/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "contactTime.H"
#include "bracketedRoot.H"

#include <algorithm>

namespace
{

using namespace impact;

//- Roots in (0, end) of a2 t^2 + a1 t + a0, in order
int quadraticRoots
(
    double a2,
    double a1,
    double a0,
    double end,
    double roots[2]
)
{
    const double square = a1*a1 - 4*a2*a0;
    if (!(square >= 0))
    {
        return 0;
    }
    const double q = -0.5*(a1 + std::copysign(std::sqrt(square), a1));
    int n = 0;
    // A root outside (0, end) is not computed: its division may overflow
    auto take = [&](double top, double bottom)
    {
        if (bottom < 0)
        {
            top = -top;
            bottom = -bottom;
        }
        if (top > 0 && top < bottom*end)
        {
            roots[n++] = top/bottom;
        }
    };
    take(q, a2);
    take(a0, q);
    if (n == 2 && roots[0] > roots[1])
    {
        std::swap(roots[0], roots[1]);
    }
    return n;
}

//- p = |s + v t + a t^2/2|^2 - sigma^2, negative where spheres overlap
class gapOnParabolas
{
    const vector3 s_, v_, a_;
    const double sigma2_;

    // p' = c[0] + c[1] t + c[2] t^2 + c[3] t^3
    const double c_[4];

public:

    gapOnParabolas
    (
        const vector3& s,
        const vector3& v,
        const vector3& a,
        double sigma
    )
    :
        s_(s),
        v_(v),
        a_(a),
        sigma2_(sigma*sigma),
        c_
        {
            2*dot(s, v), 2*(dot(v, v) + dot(s, a)), 3*dot(v, a), dot(a, a)
        }
    {}

    double operator()(double t) const
    {
        const vector3 x = s_ + t*(v_ + (0.5*t)*a_);
        return dot(x, x) - sigma2_;
    }

    //- p'
    double rate(double t) const
    {
        return c_[0] + t*(c_[1] + t*(c_[2] + t*c_[3]));
    }

    //- Where p' has a value, between two times with that value between theirs
    double timeOfRate(double low, double high, double level) const
    {
        return bracketedRoot
        (
            [&](double t) { return rate(t) - level; }, low, high
        );
    }

    //- Ends of the intervals of (0, end) in which p' is monotone
    //  \return their number
    int monotone(double end, double ends[4]) const
    {
        double bends[2];
        const int n = quadraticRoots(3*c_[3], 2*c_[2], c_[1], end, bends);
        ends[0] = 0;
        std::copy_n(bends, n, ends + 1);
        ends[n + 1] = end;
        return n + 2;
    }

    //- Contact within an approach, or never
    //  \param touching  p at most this: the pair touches, and collides once
    //      p' is below \c fast
    //  \param last  a contact at the very end counts
    double contact
    (
        double from,
        double to,
        double touching,
        double fast,
        bool last
    ) const
    {
        const double before = (*this)(from);
        if (before <= touching)
        {
            const double rateFrom = rate(from);
            if (rateFrom <= fast && rateFrom < 0)
            {
                return from;
            }
            return
                !(rate(to) < fast) ? never
              : fast == 0 ? from : timeOfRate(from, to, fast);
        }
        const double after = (*this)(to);
        if (!(after < 0 || (after == 0 && last)))
        {
            return never;
        }
        return bracketedRoot
        (
            *this, from, to, before, after, allDigits
        );
    }
};

} // End anonymous namespace


double impact::parabolicContact
(
    const vector3& s,
    const vector3& v,
    const vector3& a,
    double sigma,
    double end,
    contactTolerance tolerance
)
{
    if (dot(a, a) == 0)
    {
        return straightContact(s, v, sigma, end, tolerance);
    }
    if
    (
        tolerance.restSpeed > 0
     && dot(s, s) - sigma*sigma <= 2*sigma*tolerance.restDepth
     && -dot(s, v) < sigma*tolerance.restSpeed
    )
    {
        // Which comes first: the speed, or the depth?
        const double fast = parabolicContact
        (
            s, v, a, sigma, end,
            {std::max(tolerance.gap, tolerance.restDepth), tolerance.restSpeed}
        );
        const double deep = parabolicContact
        (
            s, v, a, sigma - tolerance.restDepth, end,
            {tolerance.gap, tolerance.speed}
        );
        return std::min(fast, deep);
    }
    const double touching = 2*sigma*tolerance.gap;

    if (passBy(s, v, a, sigma + tolerance.gap, end))
    {
        return never;
    }

    const gapOnParabolas gap(s, v, a, sigma);
    double monotone[4];
    const int nMonotone = gap.monotone(end, monotone);

    // A rate below this counts for a pair that touches
    const double fast = -2*sigma*tolerance.speed;
    double approachStart = -1;  // of the current approach, none if negative
    double lastRate = gap.rate(0);
    if (lastRate < 0)
    {
        approachStart = 0;
    }
    for (int i = 0; i + 1 < nMonotone; ++i)
    {
        const double low = monotone[i], high = monotone[i + 1];
        const double highRate = gap.rate(high);
        double approachEnd = high;
        if ((lastRate < 0) != (highRate < 0))
        {
            const double turn =
                lastRate == 0 ? low : gap.timeOfRate(low, high, 0);
            (highRate < 0 ? approachStart : approachEnd) = turn;
        }
        if (approachStart >= 0)
        {
            const double t = gap.contact
            (
                std::max(low, approachStart), approachEnd, touching, fast,
                approachEnd == end
            );
            if (t < never)
            {
                return t;
            }
        }
        if (!(highRate < 0))
        {
            approachStart = -1;
        }
        lastRate = highRate;
    }
    return never;
}
