/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "contactTime.H"

#include <algorithm>

namespace
{

//- Root in [low, high] of a continuous function of opposite signs at the ends:
//  Newton's steps, bisection where they leave the bracket or lag
//  \param f  gives the value and sets the derivative
template<class Function>
double bracketedRoot(Function f, double low, double high, double fLow)
{
    const bool positive = fLow > 0;
    double t = 0.5*(low + high);
    double step = high - low, lastStep = step;
    for (int i = 0; i < 200; ++i)
    {
        double slope;
        const double value = f(t, slope);
        if (value == 0)
        {
            return t;
        }
        ((value > 0) == positive ? low : high) = t;

        // Newton's step must halve the one before the last. Compared without
        // the division, which may overflow
        double next;
        if (std::fabs(value) < 0.5*std::fabs(lastStep*slope))
        {
            next = t - value/slope;
        }
        else
        {
            next = low;
        }
        if (!(next > low && next < high))
        {
            next = low + 0.5*(high - low);
        }
        if (next == t || next == low || next == high)
        {
            return next;
        }
        lastStep = step;
        step = next - t;
        t = next;
        if (std::fabs(step) <= 1e-16*std::fabs(t))
        {
            return t;
        }
    }
    return t;
}


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
    const double a2 = dot(a, a);
    if (a2 == 0)
    {
        return straightContact(s, v, sigma, end, tolerance);
    }
    const double s2 = dot(s, s);
    const double v2 = dot(v, v);
    const double sigma2 = sigma*sigma;
    if
    (
        tolerance.restSpeed > 0
     && s2 - sigma2 <= 2*sigma*tolerance.restDepth
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

    // Too far to reach each other
    const double reach =
        sigma + (std::sqrt(v2) + 0.5*std::sqrt(a2)*end)*end;
    if (s2 > reach*reach*(1 + 1e-12))
    {
        return never;
    }

    // p' = c[0] + c[1] t + c[2] t^2 + c[3] t^3
    const double c[4] =
        {2*dot(s, v), 2*(v2 + dot(s, a)), 3*dot(v, a), a2};
    auto rate = [&](double t)
    {
        return c[0] + t*(c[1] + t*(c[2] + t*c[3]));
    };
    auto gap = [&](double t)
    {
        const vector3 x = s + t*(v + (0.5*t)*a);
        return dot(x, x) - sigma2;
    };

    // Ends of the intervals in which p' is monotone, then of those in which
    // p is
    double bends[2];
    const int nBends = quadraticRoots(3*c[3], 2*c[2], c[1], end, bends);
    double monotone[4] = {0};
    for (int i = 0; i < nBends; ++i)
    {
        monotone[i + 1] = bends[i];
    }
    const int nMonotone = nBends + 2;
    monotone[nMonotone - 1] = end;

    // A rate below this counts for a pair that touches
    const double fast = -2*sigma*tolerance.speed;
    auto rootOfRate = [&](double low, double high, double level)
    {
        return bracketedRoot
        (
            [&](double t, double& slope)
            {
                slope = c[1] + t*(2*c[2] + t*3*c[3]);
                return rate(t) - level;
            },
            low, high, rate(low) - level
        );
    };

    double approachStart = -1;  // of the current approach, none if negative
    double lastRate = rate(0);
    if (lastRate < 0)
    {
        approachStart = 0;
    }
    for (int i = 0; i + 1 < nMonotone; ++i)
    {
        const double low = monotone[i], high = monotone[i + 1];
        const double highRate = rate(high);
        double approachEnd = high;
        if ((lastRate < 0) != (highRate < 0))
        {
            const double turn =
                lastRate == 0 ? low : rootOfRate(low, high, 0);
            if (highRate < 0)
            {
                approachStart = turn;
            }
            else
            {
                approachEnd = turn;
            }
        }
        if (approachStart >= 0)
        {
            const double from = std::max(low, approachStart);
            const double before = gap(from);
            if (before <= touching)
            {
                // It touches: contact once it approaches fast enough
                const double rateFrom = rate(from);
                const double rateEnd = rate(approachEnd);
                if (rateFrom <= fast && rateFrom < 0)
                {
                    return from;
                }
                if (rateEnd < fast)
                {
                    return fast == 0
                        ? from : rootOfRate(from, approachEnd, fast);
                }
            }
            else
            {
                const double after = gap(approachEnd);
                if (after < 0 || (after == 0 && approachEnd == end))
                {
                    return bracketedRoot
                    (
                        [&](double t, double& slope)
                        {
                            slope = rate(t);
                            return gap(t);
                        },
                        from, approachEnd, before
                    );
                }
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


double impact::planeContact
(
    double h,
    double v,
    double a,
    double radius,
    double end,
    contactTolerance tolerance
)
{
    const double gap = h - radius;
    if
    (
        tolerance.restSpeed > 0 && gap <= tolerance.restDepth
     && -v < tolerance.restSpeed
    )
    {
        const double fast = planeContact
        (
            h, v, a, radius, end,
            {std::max(tolerance.gap, tolerance.restDepth), tolerance.restSpeed}
        );
        const double deep = planeContact
        (
            h, v, a, radius - tolerance.restDepth, end,
            {tolerance.gap, tolerance.speed}
        );
        return std::min(fast, deep);
    }
    const double square = v*v - 2*a*gap;
    if (gap <= tolerance.gap)
    {
        if (v < 0 && -v >= tolerance.speed)
        {
            return 0;
        }
        if (!(a < 0))
        {
            return never;
        }
        // It sinks ever faster. If it rises first, and beyond touching, it
        // collides when it is back
        double t = std::max(v + tolerance.speed, 0.);
        const bool leaves =
            v > 0 && v*v > 2*(-a)*(tolerance.gap - gap) && square > 0;
        if (leaves)
        {
            t = std::max(t, v + std::sqrt(square));
        }
        return t <= -a*end ? t/(-a) : never;
    }
    if (!(square > 0) || (v >= 0 && a >= 0))
    {
        return never;
    }
    // The root at which the height sinks
    const double root = std::sqrt(square);
    const double top = v < 0 ? 2*gap : v + root;
    const double bottom = v < 0 ? root - v : -a;
    return top <= bottom*end ? top/bottom : never;
}
