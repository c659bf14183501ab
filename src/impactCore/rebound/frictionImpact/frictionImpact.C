/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "frictionImpact.H"
#include "bracketedRoot.H"
#include "elementary.H"
#include "outOfRange.H"

#include <algorithm>
#include <limits>

namespace
{

//- Of a step of the series, by the slip at its start
constexpr double tolerance = 2e-9;

//- Of the end of slip
constexpr double fine = 1e-11;

constexpr double infinity = std::numeric_limits<double>::infinity();


//- The n-th root, up to 1 % too large and 6 % too small, alike on every
//  machine: its binary logarithm is read off the bits
double roughRoot(double x, int n)
{
    const std::int64_t one = __builtin_bit_cast(std::int64_t, 1.);
    const std::int64_t bits = __builtin_bit_cast(std::int64_t, x);
    return 0.95*__builtin_bit_cast(double, one + (bits - one)/n);
}


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
        c,
        s,
        c*v1 + s*v2,
        c*v2 - s*v1,
        c_.mu*((c_.k11 - c_.k22)*(c*c - s*s) + 4*c_.k12*c*s)
      - c_.f1*c - c_.f2*s
    };
}


void impact::frictionImpact::tangential
(
    double x,
    double y,
    double p,
    double& S1,
    double& S2
) const
{
    // (x, y) = f p + k S
    const double inverse = 1/(c_.k11*c_.k22 - c_.k12*c_.k12);
    const double b1 = x - c_.f1*p, b2 = y - c_.f2*p;
    S1 = inverse*(c_.k22*b1 - c_.k12*b2);
    S2 = inverse*(c_.k11*b2 - c_.k12*b1);
}


double impact::frictionImpact::normalRate(const state& q) const
{
    return c_.a*q[slip] - c_.mu*(c_.f1*q[slipX] + c_.f2*q[slipY]);
}


void impact::frictionImpact::expand(const slipRates& now)
{
    // The magnitude of slip from |t|^2 = x^2 + y^2, order by order: it is that
    // of t along the first direction, and a rest made of earlier terms. So one
    // order follows from the one before by a matrix, and none waits long
    auto& z = terms_;
    std::copy_n(q_, nColumns, z[0]);
    const double c = now.c, s = now.s, mu = c_.mu;
    const double inverse = 1/q_[slip];
    const double m11 = c_.f1*c - mu*c_.k11, m12 = c_.f1*s - mu*c_.k12;
    const double m21 = c_.f2*c - mu*c_.k12, m22 = c_.f2*s - mu*c_.k22;
    const double v1 = c_.a*c - mu*c_.f1, v2 = c_.a*s - mu*c_.f2;
    double share[order][3];
    #pragma GCC unroll 16
    for (int n = 0; n < order; ++n)
    {
        double rest = 0, power = 0;
        #pragma GCC unroll 8
        for (int k = n/2; k > 0; --k)
        {
            const double twice = 2*k < n ? 1 : 0.5;
            const state& p = z[k];
            const state& q = z[n - k];
            rest += twice
               *(
                    share[k][0]*q[slipX] + share[k][1]*q[slipY]
                  - share[k][2]*q[slip]
                );
            power += twice*(p[normal]*q[slip] + q[normal]*p[slip]);
        }
        const double x = z[n][slipX], y = z[n][slipY];
        const double all = n > 0 ? c*x + s*y + rest : z[0][slip];
        const double unit = 1./(n + 1);
        state& next = z[n + 1];
        z[n][slip] = all;
        share[n][0] = inverse*x;
        share[n][1] = inverse*y;
        share[n][2] = inverse*all;
        next[slipX] = unit*m11*x + unit*m12*y + unit*c_.f1*rest;
        next[slipY] = unit*m21*x + unit*m22*y + unit*c_.f2*rest;
        next[slip] = 0;
        next[normal] = unit*v1*x + unit*v2*y + unit*c_.a*rest;
        next[impulseX] = -unit*mu*x;
        next[impulseY] = -unit*mu*y;
        next[impulse] = unit*all;
        power += z[0][normal]*all + (n > 0 ? z[n][normal]*q_[slip] : 0);
        next[work] = unit*power;
    }
}


double impact::frictionImpact::range() const
{
    auto root = [&](int n)
    {
        const state& z = terms_[n];
        const double magnitude = std::fabs(z[slipX]) + std::fabs(z[slipY])
          + std::fabs(z[normal]) + std::fabs(z[impulse])
          + std::fabs(z[work]) + 1e-200;
        return roughRoot(tolerance*q_[slip]/magnitude, n);
    };
    return std::min(root(order - 1), root(order));
}


void impact::frictionImpact::evaluate(double tau, state& q) const
{
    // Even and odd terms: half as many that wait for each other
    const double square = tau*tau;
    state odd;
    std::copy_n(terms_[order], nColumns, q);
    std::copy_n(terms_[order - 1], nColumns, odd);
    for (int n = order - 2; n > 0; n -= 2)
    {
        for (int j = 0; j < nColumns; ++j)
        {
            q[j] = terms_[n][j] + square*q[j];
            odd[j] = terms_[n - 1][j] + square*odd[j];
        }
    }
    for (int j = 0; j < nColumns; ++j)
    {
        q[j] = terms_[0][j] + square*q[j] + tau*odd[j];
    }
    q[slip] = std::sqrt(q[slipX]*q[slipX] + q[slipY]*q[slipY]);
}


template<class Function>
double impact::frictionImpact::zero
(
    sample a,
    sample b,
    double margin,
    const Function& at,
    state& q
) const
{
    // By the cubic that has the values and the rates of both ends and is one of
    // the value, or Newton's method
    double tau = a.tau;
    for (int i = 0; i < 60; ++i)
    {
        tau = b.rate > 0 ? b.tau - b.value/b.rate : a.tau;
        if (a.value < -margin && a.rate > 0 && b.rate > 0)
        {
            const double h = b.value - a.value, w = b.tau - a.tau;
            const double u = -a.value/h, v = b.value/h;
            tau = a.tau + u*u*(3 - 2*u)*w + h*u*v*(v/a.rate - u/b.rate);
        }
        if (!(tau > a.tau && tau < b.tau) || i > 6)
        {
            tau = 0.5*(a.tau + b.tau);
        }
        evaluate(tau, q);
        const sample now = at(tau, q);
        if (std::fabs(now.value) <= margin)
        {
            break;
        }
        (now.value < 0 ? a : b) = now;
    }
    return tau;
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
    auto velocity = [&](double tau, const state& q)
    {
        return sample{tau, sign*q[normal], sign*normalRate(q)};
    };
    evaluate(h, next);
    const sample begin = velocity(from, q_);
    sample end = velocity(h, next);
    if (!(end.value > 0))
    {
        if (!(begin.rate > 0 && end.rate < 0))
        {
            return false;
        }
        state peak;
        auto rate = [&](double tau)
        {
            evaluate(tau, peak);
            end = velocity(tau, peak);
            return end.rate;
        };
        const double width = h - from;
        rate
        (
            bracketedRoot
            (
                rate, from, h, begin.rate, end.rate,
                [=](double a, double b) { return b - a <= 1e-12*width; }
            )
        );
        if (!(end.value > 0))
        {
            return false;
        }
    }

    // Work does not change there: no need to be close
    h = zero(begin, end, margin_, velocity, next);
    return true;
}


bool impact::frictionImpact::follow(const slipRates& now)
{
    expand(now);
    const double end = range();
    for (double from = 0; from < end; )
    {
        double h = end;
        state next;
        const bool turned = turns(from, h, next);
        if (restituting_)
        {
            // The root of the share of the work that is given back rises
            // almost evenly from the end of compression on
            const double all = kept_*compression_;
            const double given = all - compression_;
            auto share = [&](double tau, const state& q)
            {
                const double rate = q[normal]*q[slip];
                const double y =
                    std::sqrt(positivePart((q[work] - compression_)/given));
                return sample
                {
                    tau, y - 1,
                    y > 1e-3 ? rate/(2*given*y)
                      : std::sqrt(positivePart(normalRate(q)*q[slip]/(2*given)))
                };
            };
            if (q_[work] >= all)
            {
                return true;
            }
            if (next[work] >= all)
            {
                zero(share(from, q_), share(h, next), 1e-9, share, next);
                std::copy_n(next, nColumns, q_);
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


bool impact::frictionImpact::slipEnds(slipRates now)
{
    // The direction that slip tends to is where it would no longer turn, by
    // Newton's method; d is the angle from there to the present one. Bounds
    // would cost more than the search: four fifths of the impacts are turned
    // down on the way, after one step on average
    const double magnitude = q_[slip], mu = c_.mu;
    const double first = normalRate(q_)/magnitude;
    double c = now.c, s = now.s, d = 0;
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
    constexpr int maxOrder = 32;
    double R[maxOrder + 1], T[maxOrder + 1], P[maxOrder + 1], Z[maxOrder + 1];
    P[0] = -1/R0;
    Z[0] = 0.5*P[0];
    double sumP = P[0], sumZ = Z[0], left = 1;
    double one = 1, two = 1;        // d^k/k!, (2d)^k/k!
    for (int k = 1; k <= maxOrder && left > fine; ++k)
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
    if (left > fine)
    {
        return false;
    }

    // The work of friction is -mu Z
    const double more = magnitude*sumP;
    double S1, S2;
    tangential(-q_[slipX], -q_[slipY], more, S1, S2);
    const double v = q_[normal] + c_.a*more + c_.f1*S1 + c_.f2*S2;
    const double done = q_[work]
      + 0.5*(S1*q_[slipX] + S2*q_[slipY] + more*(q_[normal] + v))
      + mu*magnitude*magnitude*sumZ;
    if (restituting_ ? !(v > 0 && done < kept_*compression_) : !(v < 0))
    {
        return false;
    }
    q_[impulseX] += S1;
    q_[impulseY] += S2;
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
    double T1, T2;
    tangential(0, 0, 1, T1, T2);
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
            double c = 1, s = 0;
            auto at = [&](double angle)
            {
                double sine, cosine;
                sinCos(angle, sine, cosine);
                c = around.c[i]*cosine - around.s[i]*sine;
                s = around.s[i]*cosine + around.c[i]*sine;
                return rates(c, s);
            };
            const slipRates here = at
            (
                bracketedRoot
                (
                    [&](double angle) { return at(angle).turning; },
                    0,
                    directionCircle::part,
                    last.turning,
                    next.turning,
                    [](double a, double b) { return b - a <= 2e-15; }
                )
            );
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


bool impact::frictionImpact::keepsDirection(const slipRates& now) const
{
    const double turning = std::fabs(now.turning), v = -q_[normal];
    return turning <= 1e-14*std::fabs(now.growth)
      || (q_[impulse] == 0 && v > 0 && v*turning < 1e-9*normalRate(q_));
}


void impact::frictionImpact::solve()
{
    if (c_.mu == 0)
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
        const slipRates now = rates(q_[slipX]/s, q_[slipY]/s);
        if (keepsDirection(now))
        {
            const double limit = now.growth < 0 ? -s/now.growth : infinity;
            if (!straight(-c_.mu*now.c, -c_.mu*now.s, limit))
            {
                fromRest();
            }
            return;
        }
        if (slipEnds(now))
        {
            fromRest();
            return;
        }
        if (follow(now))
        {
            return;
        }
    }
    throwInvalid
    (
        "an impact with friction ", c_.mu, " is not over after 10000 steps"
    );
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
    kept_(1 - restitution*restitution),
    margin_((kept_ == 1 ? 1e-13 : 1e-6)*std::fabs(v))
{
    q_[slipX] = x;
    q_[slipY] = y;
    q_[slip] = std::sqrt(x*x + y*y);
    q_[normal] = v;
    solve();
}

