/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "frictionImpact.H"
#include "elementary.H"

#include <algorithm>
#include <limits>

namespace
{

constexpr double tolerance = 1e-11;
constexpr double infinity = std::numeric_limits<double>::infinity();


//- Directions to bracket others between
struct directionCircle
{
    static constexpr int parts = 64;
    static constexpr double part = 6.283185307179586/parts;
    double c[parts + 1], s[parts + 1];

    directionCircle()
    {
        for (int i = 0; i <= parts; ++i)
        {
            impact::sinCosTurns(double(i)/parts, s[i], c[i]);
        }
    }

    static const directionCircle& all()
    {
        static const directionCircle circle;
        return circle;
    }
};

} // End anonymous namespace


impact::frictionImpact::slipRates impact::frictionImpact::rates
(
    double c,
    double s
) const
{
    const double v1 = c_.f1 - c_.mu*(c_.k11*c + c_.k12*s);
    const double v2 = c_.f2 - c_.mu*(c_.k12*c + c_.k22*s);
    return
    {
        c*v1 + s*v2,
        c*v2 - s*v1,
        c_.mu*((c_.k11 - c_.k22)*(c*c - s*s) + 4*c_.k12*c*s)
      - c_.f1*c - c_.f2*s
    };
}


void impact::frictionImpact::expand()
{
    // The magnitude s of slip from s^2 = x^2 + y^2, order by order
    auto& z = terms_;
    std::copy_n(q_, nColumns, z[0]);
    const double inverse = 1/q_[slip];
    const double mu = c_.mu;
    for (int n = 0; n < order; ++n)
    {
        double rest = 0, power = 0;
        if (n > 1 && n % 2 == 0)
        {
            const state& p = z[n/2];
            rest = 0.5
               *(p[slipX]*p[slipX] + p[slipY]*p[slipY] - p[slip]*p[slip]);
            power = p[normal]*p[slip];
        }
        for (int k = (n - 1)/2; k >= 1; --k)
        {
            const state& p = z[k];
            const state& q = z[n - k];
            rest += p[slipX]*q[slipX] + p[slipY]*q[slipY] - p[slip]*q[slip];
            power += p[normal]*q[slip] + q[normal]*p[slip];
        }
        const double x = z[n][slipX], y = z[n][slipY];
        if (n > 0)
        {
            z[n][slip] = inverse
               *(z[0][slipX]*x + z[0][slipY]*y + rest);
            power += z[n][normal]*z[0][slip];
        }
        const double s = z[n][slip];
        power += z[0][normal]*s;
        const double unit = 1./(n + 1);
        state& next = z[n + 1];
        next[slipX] = unit*(c_.f1*s - mu*(c_.k11*x + c_.k12*y));
        next[slipY] = unit*(c_.f2*s - mu*(c_.k12*x + c_.k22*y));
        next[slip] = 0;
        next[normal] = unit*(c_.a*s - mu*(c_.f1*x + c_.f2*y));
        next[impulseX] = -unit*mu*x;
        next[impulseY] = -unit*mu*y;
        next[impulse] = unit*s;
        next[work] = unit*power;
    }
}


double impact::frictionImpact::range() const
{
    static_assert(order == 16, "the root");
    auto size = [&](int n)
    {
        const state& z = terms_[n];
        return std::fabs(z[slipX]) + std::fabs(z[slipY])
          + std::fabs(z[normal]) + std::fabs(z[impulse]) + 1e-200;
    };
    const double wanted = tolerance*q_[slip];
    const double last = size(order), before = size(order - 1);

    // Square roots round alike on every machine
    double h = std::sqrt(std::sqrt(std::sqrt(std::sqrt(wanted/last))));
    for (;;)
    {
        const double h3 = h*h*h, h15 = h3*h3*h3*h3*h3;
        if (!(h15*std::max(before, h*last) > wanted))
        {
            return h;
        }
        h *= 0.9;
    }
}


void impact::frictionImpact::evaluate(double tau, state& q) const
{
    std::copy_n(terms_[order], nColumns, q);
    for (int n = order - 1; n >= 0; --n)
    {
        for (int j = 0; j < nColumns; ++j)
        {
            q[j] = terms_[n][j] + tau*q[j];
        }
    }
    q[slip] = std::sqrt(q[slipX]*q[slipX] + q[slipY]*q[slipY]);
}


double impact::frictionImpact::rising
(
    column j,
    double sign,
    double value,
    double lo,
    double hi,
    double guess
) const
{
    double t = guess > lo && guess < hi ? guess : 0.5*(lo + hi);
    for (int i = 0; i < 100; ++i)
    {
        double e = terms_[order][j], rate = 0;
        for (int n = order - 1; n >= 0; --n)
        {
            rate = e + t*rate;
            e = terms_[n][j] + t*e;
        }
        e = sign*(e - value);
        rate *= sign;
        (e > 0 ? hi : lo) = t;
        const double step = rate > 0 ? -e/rate : infinity;

        // An error left here comes back squared
        if (std::fabs(step) <= 1e-7*t)
        {
            return t + step;
        }
        t = t + step > lo && t + step < hi ? t + step : 0.5*(lo + hi);
    }
    return t;
}


void impact::frictionImpact::turnRound()
{
    q_[normal] = 0;
    restituting_ = !restituting_;
    if (restituting_)
    {
        compression_ = q_[work];
    }
}


bool impact::frictionImpact::turns(double from, double& h, state& next) const
{
    // Its rate is a function of the direction of slip, which turns one way and
    // not far: the velocity passes zero at most once, or comes back once
    const double sign = restituting_ ? -1 : 1;
    auto rate = [&](const state& q)
    {
        return sign
           *(c_.a*q[slip] - c_.mu*(c_.f1*q[slipX] + c_.f2*q[slipY]));
    };
    evaluate(h, next);
    const double first = rate(q_);
    if (!(sign*next[normal] > 0))
    {
        if (!(first > 0 && rate(next) < 0))
        {
            return false;
        }
        state peak;
        double lo = from, hi = h;
        for (int i = 0; i < 40; ++i)
        {
            const double t = 0.5*(lo + hi);
            evaluate(t, peak);
            (rate(peak) > 0 ? lo : hi) = t;
        }
        if (!(sign*peak[normal] > 0))
        {
            return false;
        }
        h = hi;
    }
    const double guess = from
      - (first > 0 ? sign*q_[normal]*q_[slip]/first : infinity);
    h = rising(normal, sign, 0, from, h, guess);
    evaluate(h, next);
    return true;
}


bool impact::frictionImpact::follow()
{
    expand();
    const double end = range();
    for (double from = 0; from < end; )
    {
        double h = end;
        state next;
        const bool turned = turns(from, h, next);
        if (restituting_)
        {
            const double all = kept_*compression_;
            if (q_[work] >= all)
            {
                return true;
            }
            if (next[work] >= all)
            {
                // Nearly a parabola if the velocity has just passed zero
                const double share =
                    (all - q_[work])/(next[work] - q_[work]);
                const double guess = from + (h - from)*std::sqrt(share);
                evaluate(rising(work, 1, all, from, h, guess), q_);
                return true;
            }
        }
        std::copy_n(next, nColumns, q_);
        if (turned)
        {
            turnRound();
            if (kept_ == 1)
            {
                return true;
            }
        }
        from = h;
    }
    return false;
}


bool impact::frictionImpact::slipEnds()
{
    // The direction that slip tends to is where it would no longer turn, by
    // Newton's method; d is the angle from there to the present one
    const double magnitude = q_[slip], mu = c_.mu;
    double c = q_[slipX]/magnitude, s = q_[slipY]/magnitude, d = 0;
    const double first = c_.a - mu*(c_.f1*c + c_.f2*s);
    slipRates now = rates(c, s);
    if (!(now.growth < 0))
    {
        return false;
    }

    // Half the impulse that ends slip of this direction: by then compression
    // or restitution may be over by far
    const double half = -0.5*magnitude/now.growth;
    const double then = q_[normal] + half*first;
    if
    (
        restituting_
      ? half*(q_[normal] + then) > 2*(kept_*compression_ - q_[work])
      : then > 0
    )
    {
        return false;
    }
    double step = 1;
    for (int i = 0; std::fabs(step) > 1e-8; ++i)
    {
        if
        (
            !(now.growth < 0) || !(std::fabs(now.turning) < -now.change)
         || std::fabs(d) > 1 || i == 8
        )
        {
            return false;
        }
        step = -now.turning/now.change;
        double sine, cosine;
        sinCos(step, sine, cosine);
        const double c0 = c;
        c = c*cosine - s*sine;
        s = s*cosine + c0*sine;
        d -= step;
        now = rates(c, s);
    }
    const double R0 = now.growth;
    const double fR = c_.f1*c + c_.f2*s;
    const double last = c_.a - mu*fR;
    if (!(R0 < 0) || !(first*last > 0))
    {
        return false;
    }

    // As functions of the angle, (p_end - p)/|t| = P and
    // int |t|^2 dtau/|t|^2 = Z satisfy, with R the growth and T the turning,
    //     P' T + P R = -1,   Z' T + 2 Z R = -1
    // and are analytic where T = 0: their power series, times d^k. Those of R
    // and T are of the cosine and the sine of d and of 2d; T[k] is that of
    // d^(k+1), times d^k
    const double fT = c_.f2*c - c_.f1*s;
    const double kRT = c_.k12*(c*c - s*s) + (c_.k22 - c_.k11)*c*s;
    const double skew =
        0.5*(c_.k11 - c_.k22)*(c*c - s*s) + 2*c_.k12*c*s;
    constexpr int most = 32;
    double R[most + 1], T[most + 1], P[most + 1], Z[most + 1];
    P[0] = -1/R0;
    Z[0] = 0.5*P[0];
    double sumP = P[0], sumZ = Z[0], left = 1;
    double one = 1, two = 1;        // d^k/k!, (2d)^k/k!
    for (int k = 1; k <= most && left > tolerance; ++k)
    {
        one *= d/k;
        two *= 2*d/k;
        const double sign = k & 2 ? -1. : 1.;
        const double mean = sign*(k & 1 ? fT : fR);
        const double pair = sign*mu*(k & 1 ? kRT : skew);
        R[k] = mean*one - pair*two;
        T[k] = -(mean*one - 2*pair*two)/(k + 1);
        double sum = 0, sum2 = 0;
        for (int j = 1; j <= k; ++j)
        {
            const double turning = (k - j)*T[j];
            sum += (R[j] + turning)*P[k - j];
            sum2 += (2*R[j] + turning)*Z[k - j];
        }
        P[k] = -sum/(k*now.change + R0);
        Z[k] = -sum2/(k*now.change + 2*R0);
        sumP += P[k];
        sumZ += Z[k];
        left = magnitude*(std::fabs(P[k]) + std::fabs(P[k - 1]))/P[0];
    }
    if (left > tolerance)
    {
        return false;
    }

    // t + f dp + k dS = 0; the work of friction is -mu Z
    const double more = magnitude*sumP;
    const double det = c_.k11*c_.k22 - c_.k12*c_.k12;
    const double b1 = -q_[slipX] - c_.f1*more, b2 = -q_[slipY] - c_.f2*more;
    const double dS1 = (c_.k22*b1 - c_.k12*b2)/det;
    const double dS2 = (c_.k11*b2 - c_.k12*b1)/det;
    const double v = q_[normal] + c_.a*more + c_.f1*dS1 + c_.f2*dS2;
    const double done = q_[work]
      + 0.5*(dS1*q_[slipX] + dS2*q_[slipY] + more*(q_[normal] + v))
      + mu*magnitude*magnitude*sumZ;
    if (restituting_ ? !(v > 0 && done < kept_*compression_) : !(v < 0))
    {
        return false;
    }
    q_[impulseX] += dS1;
    q_[impulseY] += dS2;
    q_[impulse] += more;
    q_[normal] = v;
    q_[work] = done;
    q_[slipX] = q_[slipY] = q_[slip] = 0;
    return true;
}


bool impact::frictionImpact::straight(double d1, double d2, double limit)
{
    const double rate = c_.a + c_.f1*d1 + c_.f2*d2;
    auto advance = [&](double p)
    {
        q_[work] += p*(q_[normal] + 0.5*rate*p);
        q_[normal] += rate*p;
        q_[impulseX] += p*d1;
        q_[impulseY] += p*d2;
        q_[impulse] += p;
        limit -= p;
    };
    for (;;)
    {
        // Until the velocity along the normal turns
        const double v = q_[normal];
        const double turn =
            restituting_ == (rate < 0) && rate != 0 ? -v/rate : infinity;
        double end = infinity;
        if (restituting_)
        {
            const double rest = kept_*compression_ - q_[work];
            if (rest <= 0)
            {
                return true;
            }
            const double square = v*v + 2*rate*rest;
            end = square >= 0 ? 2*rest/(v + std::sqrt(square)) : infinity;
        }
        if (limit < turn && limit < end)
        {
            advance(limit);
            return false;
        }
        if (end <= turn)
        {
            advance(end);
            return true;
        }
        advance(turn);
        turnRound();
    }
}


void impact::frictionImpact::fromRest()
{
    // It stays at rest if the cone holds the T of f + k T = 0
    const double mu = c_.mu;
    const double det = c_.k11*c_.k22 - c_.k12*c_.k12;
    const double T1 = (c_.k12*c_.f2 - c_.k22*c_.f1)/det;
    const double T2 = (c_.k12*c_.f1 - c_.k11*c_.f2)/det;
    if (T1*T1 + T2*T2 <= mu*mu)
    {
        straight(T1, T2, infinity);
        return;
    }

    // Else it slides off in a direction that it keeps: of those that do not
    // turn, the one of fastest growth
    const directionCircle& around = directionCircle::all();
    double bestC = 1, bestS = 0, fastest = -1;
    slipRates last = rates(around.c[0], around.s[0]);
    for (int i = 0; i < directionCircle::parts; ++i)
    {
        const slipRates next = rates(around.c[i + 1], around.s[i + 1]);
        if ((last.turning > 0) != (next.turning > 0))
        {
            // By Newton's method from the chord, between the two
            double lo = 0, hi = directionCircle::part;
            double angle = hi*last.turning/(last.turning - next.turning);
            double c = 1, s = 0;
            slipRates here = {};
            for (int k = 0; k < 60; ++k)
            {
                double sine, cosine;
                sinCos(angle, sine, cosine);
                c = around.c[i]*cosine - around.s[i]*sine;
                s = around.s[i]*cosine + around.c[i]*sine;
                here = rates(c, s);
                ((here.turning > 0) == (last.turning > 0) ? lo : hi) = angle;
                const double step =
                    here.change != 0 ? -here.turning/here.change : hi;
                if (std::fabs(step) <= 1e-15)
                {
                    break;
                }
                angle = angle + step > lo && angle + step < hi
                  ? angle + step : 0.5*(lo + hi);
            }
            if (here.growth > fastest)
            {
                fastest = here.growth;
                bestC = c;
                bestS = s;
            }
        }
        last = next;
    }
    straight(-mu*bestC, -mu*bestS, infinity);
}


impact::frictionImpact::frictionImpact
(
    const contactResponse& c,
    double restitution,
    double x,
    double y,
    double v
)
:
    c_(c),
    kept_(1 - restitution*restitution)
{
    q_[slipX] = x;
    q_[slipY] = y;
    q_[slip] = std::sqrt(x*x + y*y);
    q_[normal] = v;
    if (c.mu == 0)
    {
        straight(0, 0, infinity);
        return;
    }
    for (int step = 0; step < 10000; ++step)
    {
        const double s = q_[slip];
        if (s <= 1e-12)
        {
            fromRest();
            return;
        }
        const double ex = q_[slipX]/s, ey = q_[slipY]/s;
        const slipRates now = rates(ex, ey);
        if (std::fabs(now.turning) <= 1e-14*std::fabs(now.growth))
        {
            const double limit = now.growth < 0 ? -s/now.growth : infinity;
            if (!straight(-c.mu*ex, -c.mu*ey, limit))
            {
                fromRest();
            }
            return;
        }
        if (slipEnds())
        {
            fromRest();
            return;
        }
        if (follow())
        {
            return;
        }
    }
}
