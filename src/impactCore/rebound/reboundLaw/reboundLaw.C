/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "reboundLaw.H"
#include "elementary.H"
#include "frictionKernels.H"
#include "slipTurn.H"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace
{

using impact::frictionOrder;
using impact::frictionSeries;
using impact::inverses;
using impact::slipEndOrder;
using impact::slipTurn;
using impact::vector3;

void checkRange
(
    const char* name,
    double value,
    double low,
    double high,
    const char* range
)
{
    if (!(value >= low && value <= high))
    {
        std::ostringstream text;
        text<< name << ' ' << value << ": valid range " << range;
        throw std::invalid_argument(text.str());
    }
}


//- Change of the contact point's velocity for an impulse S at it
vector3 response
(
    const vector3& inverseInertia,
    const vector3& r,
    const vector3& S
)
{
    return S + cross(multiply(inverseInertia, cross(r, S)), r);
}


//- Sixteenth root: square roots round alike on every machine
double root16(double x)
{
    return std::sqrt(std::sqrt(std::sqrt(std::sqrt(x))));
}


//- Value and derivative of a polynomial. Even and odd orders apart, in powers
//  of the square: half the time is spent waiting for results of before
inline double polynomial(const double* c, double t, double& rate)
{
    static_assert(frictionOrder % 2 == 0, "pairs of orders");
    const double t2 = t*t;
    double even = c[frictionOrder], odd = c[frictionOrder - 1];
    double evenRate = 0, oddRate = 0;       // by the square
    for (int n = frictionOrder - 2; n >= 2; n -= 2)
    {
        evenRate = even + t2*evenRate;
        oddRate = odd + t2*oddRate;
        even = c[n] + t2*even;
        odd = c[n - 1] + t2*odd;
    }
    evenRate = even + t2*evenRate;
    even = c[0] + t2*even;
    rate = odd + 2*t*(evenRate + t*oddRate);
    return even + t*odd;
}


//- Where a polynomial rises through zero between lo and hi
double rising(const double* c, double lo, double hi, double guess)
{
    double t = guess > lo && guess < hi ? guess : 0.5*(lo + hi);
    for (int i = 0; i < 60; ++i)
    {
        double rate;
        const double e = polynomial(c, t, rate);
        (e > 0 ? hi : lo) = t;
        const double step = rate > 0 ? -e/rate : hi;

        // An error left here comes back squared
        if (std::fabs(step) <= 1e-8*hi)
        {
            return t + step;
        }
        const bool inside = t + step > lo && t + step < hi;
        t = inside ? t + step : 0.5*(lo + hi);
    }
    return t;
}


//- Directions to bracket others between
struct directionCircle
{
    static constexpr int parts = 64;
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


//- How far an impact with friction has come
struct impactState
{
    double x, y, v;                 // velocities along tangents and normal
    double slip;                    // magnitude of the former
    double S1 = 0, S2 = 0, p = 0;   // impulse so far
    double rubbed = 0;              // integral of the squared slip by tau
};


//- One impact with friction, in units of the approaching contact point's
//  speed, by components along two tangents and the normal. With p the normal
//  impulse, t the velocity of slip, v that along the normal,
//      dt/dp = f - mu k t/|t|,   dv/dp = a - mu f.t/|t|,   dW/dp = v
//  become, by the measure dp = |t| dtau, equations without any singularity,
//      t' = f |t| - mu k t,   v' = a |t| - mu f.t
//  which are solved by Taylor series in tau. The impulse S does the work
//  S.(V0 + V)/2, of which friction does -mu int |t|^2 dtau and the normal
//  force the rest, W. Slip ends at tau = infinity; see slipEnds().
struct frictionProcess
:
    impactState
{
    const double mu;
    const double e2;                // restitution squared
    const double k11, k12, k22;     // response along the tangents
    const double f1, f2, a;         // and its parts along the normal

    const double x0, y0, v0;        // velocities on arrival

    double compression = 0;         // normal work when the approach stopped
    bool restituting = false;

    frictionProcess
    (
        double mu,
        double e2,
        double k11,
        double k12,
        double k22,
        double f1,
        double f2,
        double a,
        double x,
        double y,
        double v
    )
    :
        impactState{x, y, v, std::sqrt(x*x + y*y)},
        mu(mu), e2(e2), k11(k11), k12(k12), k22(k22), f1(f1), f2(f2), a(a),
        x0(x), y0(y), v0(v)
    {}

    //- Rates of ln|t|, the direction of slip being (c, s), and of its angle,
    //  the derivative of the latter by the angle
    void rates
    (
        double c,
        double s,
        double& growth,
        double& turning,
        double& change
    ) const
    {
        const double v1 = f1 - mu*(k11*c + k12*s);
        const double v2 = f2 - mu*(k12*c + k22*s);
        growth = c*v1 + s*v2;
        turning = c*v2 - s*v1;
        change =
            mu*((k11 - k22)*(c*c - s*s) + 4*k12*c*s) - f1*c - f2*s;
    }

    //- Follow a constant direction (d1, d2, 1) of the impulse to the end
    void finish(double d1, double d2)
    {
        const double rate = a + f1*d1 + f2*d2;
        double more = 0;
        double rest = 0;            // work still to be given back
        double from = v;
        if (restituting)
        {
            rest = compression*(1 - e2) - normalWork(*this);
        }
        else
        {
            more = -v/rate;
            rest = -e2*(normalWork(*this) + 0.5*v*more);
            from = 0;
        }
        // v p + rate p^2/2 = rest
        more +=
            (std::sqrt(std::max(0., from*from + 2*rate*rest)) - from)/rate;
        S1 += more*d1;
        S2 += more*d2;
        p += more;
    }

    //- The rest of an impact whose contact does not slide at the moment
    void finishFromRest()
    {
        // It stays at rest if the cone holds the T of f + k T = 0
        const double det = k11*k22 - k12*k12;
        const double T1 = (k12*f2 - k22*f1)/det;
        const double T2 = (k12*f1 - k11*f2)/det;
        if (T1*T1 + T2*T2 <= mu*mu)
        {
            finish(T1, T2);
            return;
        }
        // Else it slides off in a direction that it keeps: of those that do
        // not turn, the one of fastest growth
        const directionCircle& around = directionCircle::all();
        double bestC = 1, bestS = 0, fastest = -1;
        double growth, change, last;
        rates(around.c[0], around.s[0], growth, last, change);
        for (int i = 0; i < directionCircle::parts; ++i)
        {
            const double c0 = around.c[i], s0 = around.s[i];
            double turning;
            rates
            (
                around.c[i + 1], around.s[i + 1], growth, turning, change
            );
            if ((last > 0) != (turning > 0))
            {
                double lo = 0, hi = 6.283185307179586/directionCircle::parts;
                double angle = hi*last/(last - turning), c = c0, s = s0;
                for (int k = 0; k < 60; ++k)
                {
                    double sine, cosine, here;
                    impact::sinCos(angle, sine, cosine);
                    c = c0*cosine - s0*sine;
                    s = s0*cosine + c0*sine;
                    rates(c, s, growth, here, change);
                    ((here > 0) == (last > 0) ? lo : hi) = angle;
                    double next = change != 0 ? angle - here/change : hi;
                    if (!(next > lo && next < hi))
                    {
                        next = 0.5*(lo + hi);
                    }
                    if (std::fabs(next - angle) <= 1e-16)
                    {
                        break;
                    }
                    angle = next;
                }
                if (growth > fastest)
                {
                    fastest = growth;
                    bestC = c;
                    bestS = s;
                }
            }
            last = turning;
        }
        finish(-mu*bestC, -mu*bestS);
    }

    //- On to the end of slip, if it comes before that of compression or
    //  restitution, and is near enough
    bool slipEnds()
    {
        // The direction that slip tends to is where it would no longer turn,
        // by Newton's method; d is the angle from there to the present one
        double c = x/slip, s = y/slip, d = 0;
        double R0, turning, change;
        rates(c, s, R0, turning, change);
        const double now = a - mu*(f1*c + f2*s);
        if (!(R0 < 0))
        {
            return false;
        }

        // Half the impulse that ends slip of this direction: by then
        // compression or restitution may be over by far
        const double half = -0.5*slip/R0;
        const double then = v + half*now;
        if
        (
            restituting
          ? half*(v + then) > 2*(compression*(1 - e2) - normalWork(*this))
          : then > 0
        )
        {
            return false;
        }
        const bool straight =
            std::fabs(turning) <= -1e-14*R0 && change <= -1e-9*R0;
        for (int i = 0; !straight && i < 8; ++i)
        {
            if (!(change < 0) || std::fabs(turning) > -change)
            {
                return false;
            }
            const double step = -turning/change;
            double sine, cosine;
            impact::sinCos(step, sine, cosine);
            const double c0 = c;
            c = c*cosine - s*sine;
            s = s*cosine + c0*sine;
            d -= step;
            rates(c, s, R0, turning, change);
            if (std::fabs(step) <= 1e-9)
            {
                break;
            }
        }
        if (!(R0 < 0) || std::fabs(d) > 1)
        {
            return false;
        }
        // As functions of the angle from there, (p_end - p)/|t| = P and
        // int |t|^2 dtau/|t|^2 = Z satisfy, with R the growth and T the
        // turning,
        //     P' T + P R = -1,   Z' T + 2 Z R = -1
        // and are analytic where T = 0: their power series, times d^k
        const double fR = f1*c + f2*s;
        const double fT = f2*c - f1*s;
        const double mean = 0.5*(k11 + k22);
        const double kRT = k12*(c*c - s*s) + (k22 - k11)*c*s;
        const double skew = 0.5*(k11 - k22)*(c*c - s*s) + 2*k12*c*s;
        const double T1 = straight ? 0 : change;
        double R[slipEndOrder + 1], T[slipEndOrder + 1];
        double P[slipEndOrder + 1], Z[slipEndOrder + 1];
        R[0] = fR - mu*(mean + skew);
        P[0] = -1/R[0];
        Z[0] = 0.5*P[0];
        double sumP = P[0], sumZ = Z[0];
        double one = 1, two = 1;    // d^k/k!, (2d)^k/k!
        int small = d == 0 ? 2 : 0;
        for (int k = 1; k <= slipEndOrder && small < 2; ++k)
        {
            // Coefficients of the cosine and the sine of d and of 2d; T[k]
            // is that of d^(k+1), times d^k
            one *= d*inverses.of[k];
            two *= 2*d*inverses.of[k];
            const double sign = k & 2 ? -1. : 1.;
            const double one1 = one*inverses.of[k + 1];
            const double two1 = 2*two*inverses.of[k + 1];
            if (k & 1)
            {
                R[k] = sign*(fT*one - mu*kRT*two);
                T[k] = -sign*(fT*one1 - mu*kRT*two1);
            }
            else
            {
                R[k] = sign*(fR*one - mu*skew*two);
                T[k] = -sign*(fR*one1 - mu*skew*two1);
            }
            double sum = 0, sum2 = 0;
            for (int j = 1; j <= k; ++j)
            {
                const double turns = (k - j)*T[j];
                sum += (R[j] + turns)*P[k - j];
                sum2 += (2*R[j] + turns)*Z[k - j];
            }
            P[k] = -sum/(k*T1 + R[0]);
            Z[k] = -sum2/(k*T1 + 2*R[0]);
            sumP += P[k];
            sumZ += Z[k];
            const bool gone =
                std::fabs(P[k]) + std::fabs(Z[k]) < 1e-15*P[0];
            small = gone ? small + 1 : 0;
            if (k == 8 && std::fabs(P[7]) + std::fabs(P[8]) > 1e-3*P[0])
            {
                return false;
            }
        }

        // On the way the velocity along the normal is monotonic
        const bool steady = now*(a - mu*fR) > 0;
        if (small < 2 || !steady)
        {
            return false;
        }

        // t + f dp + k dS = 0
        impactState end = *this;
        const double more = slip*sumP;
        const double det = k11*k22 - k12*k12;
        const double b1 = -x - f1*more, b2 = -y - f2*more;
        const double dS1 = (k22*b1 - k12*b2)/det;
        const double dS2 = (k11*b2 - k12*b1)/det;
        end.S1 += dS1;
        end.S2 += dS2;
        end.p += more;
        end.rubbed += slip*slip*sumZ;
        end.v += a*more + f1*dS1 + f2*dS2;
        end.x = end.y = end.slip = 0;
        if
        (
            restituting
          ? !(end.v > 0) || normalWork(end) >= compression*(1 - e2)
          : !(end.v < 0)
        )
        {
            return false;
        }
        move(end);
        return true;
    }

    //- Work of the normal force up to a state
    double normalWork(const impactState& q) const
    {
        return
            0.5*(q.S1*(x0 + q.x) + q.S2*(y0 + q.y) + q.p*(v0 + q.v))
          + mu*q.rubbed;
    }

    //- The series from here on
    void expand(frictionSeries& c) const
    {
        const double k[3] = {k11, k12, k22};
        const double f[3] = {f1, f2, a};
        c.z[0][0] = x;
        c.z[0][1] = y;
        c.z[0][2] = slip;
        c.z[0][3] = v;
        expandFriction(mu, k, f, c);
    }

    //- How far the series goes: its last two terms are below 1e-11 of the
    //  slip. A fraction of the radius of convergence is tried first
    static double range(const frictionSeries& c)
    {
        const double inverse = 1/c.z[0][2];
        const double unit = 0.5*inverse;
        auto size = [&](int n)
        {
            const double* z = c.z[n];
            return 1e-200 + unit
               *(
                    (std::fabs(z[0]) + std::fabs(z[1]))
                  + (std::fabs(z[2]) + std::fabs(z[3]))
                  + std::fabs(c.square[n])*inverse
                );
        };
        const double last = size(frictionOrder);
        const double before = size(frictionOrder - 1);
        double h = 0.4*root16(1/size(16));
        for (;;)
        {
            const double h2 = h*h, h4 = h2*h2, h8 = h4*h4;
            if (!((h8*h8)*(h4*h2*h)*std::max(before, h*last) > 1e-11))
            {
                return h;
            }
            h *= 0.85;
        }
    }

    //- The state at tau of a series
    impactState after
    (
        const impactState& origin,
        double tau,
        const frictionSeries& c
    ) const
    {
        double sums[8];
        sumFriction(tau, c, sums);
        impactState q = origin;
        q.x = sums[0];
        q.y = sums[1];
        q.slip = std::sqrt(q.x*q.x + q.y*q.y);
        q.v = sums[3];
        q.S1 -= mu*sums[4];
        q.S2 -= mu*sums[5];
        q.p += sums[6];
        q.rubbed += sums[7];
        return q;
    }

    //- Of the velocity along the normal by tau
    double normalRate(const impactState& q) const
    {
        return a*q.slip - mu*(f1*q.x + f2*q.y);
    }

    //- Of the magnitude of slip by tau
    double slipRate(const impactState& q) const
    {
        return
            f1*q.x + f2*q.y
          - mu*(k11*q.x*q.x + 2*k12*q.x*q.y + k22*q.y*q.y)/q.slip;
    }

    void move(const impactState& q)
    {
        static_cast<impactState&>(*this) = q;
    }

    //- Follow the series from tau = 0 up to its range; true at the end of
    //  the impact
    bool follow(const frictionSeries& c, double range)
    {
        const impactState origin = *this;
        const impactState last = after(origin, range, c);
        double from = 0;
        while (from < range)
        {
            // The velocity along the normal passes zero at most once while
            // slip turns so little, or comes back once
            double h = range;
            impactState next = last;
            const double direction = restituting ? -1 : 1;
            const double rate0 = direction*normalRate(*this);
            const double rate1 = direction*normalRate(next);
            bool turns = direction*next.v > 0;
            if (turns || (rate0 > 0 && rate1 < 0))
            {
                double w[frictionOrder + 1], fall[frictionOrder + 1];
                for (int n = 0; n <= frictionOrder; ++n)
                {
                    w[n] = direction*c.z[n][3];
                }
                if (!turns)
                {
                    for (int n = 0; n < frictionOrder; ++n)
                    {
                        fall[n] = -(n + 1)*w[n + 1];
                    }
                    fall[frictionOrder] = 0;
                    const double top = rising(fall, from, h, from);
                    turns = direction*after(origin, top, c).v > 0;
                    h = turns ? top : h;
                }
                if (turns)
                {
                    // Guess by the parabola through both ends
                    const double length = h - from;
                    const double start = direction*v;
                    const double bend =
                        (direction*next.v - start - rate0*length)
                       /(length*length);
                    const double square = rate0*rate0 - 4*bend*start;
                    const double guess = rate0 > 0 && square > 0
                      ? from - 2*start/(rate0 + std::sqrt(square)) : from;
                    h = rising(w, from, h, guess);
                    next = after(origin, h, c);
                }
            }
            double done = normalWork(next);

            // Work is given back as long as the velocity is positive
            const double all = compression*(1 - e2);
            if (restituting && done >= all)
            {
                // Of an impact so slight that round-off is all its work
                const double start = normalWork(*this);
                if (start >= all)
                {
                    return true;
                }
                // Nearly a parabola if the velocity has just passed zero
                double lo = from, hi = h;
                h = from + (h - from)*std::sqrt((all - start)/(done - start));
                next = after(origin, h, c);
                done = normalWork(next);
                for (int i = 0; i < 60; ++i)
                {
                    (done >= all ? hi : lo) = h;
                    // To second order in the step
                    const double rate = next.v*next.slip;
                    const double change =
                        next.v*slipRate(next) + next.slip*normalRate(next);
                    const double rest = all - done;
                    const double square = rate*rate + 2*change*rest;
                    const double step = rate > 0 && square > 0
                      ? 2*rest/(rate + std::sqrt(square)) : h;
                    const bool near = std::fabs(step) <= 1e-5*h;
                    const bool inside = h + step > lo && h + step < hi;
                    h = near || inside ? h + step : 0.5*(lo + hi);
                    next = after(origin, h, c);
                    if (near)
                    {
                        break;
                    }
                    done = normalWork(next);
                }
                move(next);
                return true;
            }
            move(next);
            if (!turns)
            {
                return false;
            }
            v = 0;
            if (e2 == 0)
            {
                return true;
            }
            compression = restituting ? compression : done;
            restituting = !restituting;
            from = h;
        }
        return false;
    }

    //- To a place of a panel
    void move(const slipTurn& turn, const slipTurn::place& q)
    {
        double more1, more2;
        turn.tangential(q, more1, more2, x, y);
        slip = q.s;
        v = q.v;
        S1 += more1;
        S2 += more2;
        p += q.p;
        rubbed += q.Z;
    }

    enum class progress
    {
        none,
        some,
        all
    };

    //- On by a panel of integrals, if slip turns and the velocity along the
    //  normal rises
    progress turnOn(slipTurn& turn, bool& begun)
    {
        const bool again = begun;
        begun = false;
        double growth, turning, change;
        rates(x/slip, y/slip, growth, turning, change);
        const double rise = a - mu*(f1*x + f2*y)/slip;
        if (!(rise > 0) || (restituting ? v < 0 : !(v < 0)))
        {
            return progress::none;
        }

        // The impulse still to come if the rates stay. The change of slip
        // due to a very small one would be round-off
        const double work = normalWork(*this);
        const double back = restituting
          ? std::max(0., compression*(1 - e2) - work) : 0.5*e2*v*v/rise;
        const double from = restituting ? v : 0;
        const double impulse =
            (restituting ? 0 : -v/rise)
          + (std::sqrt(from*from + 2*rise*back) - from)/rise;
        if
        (
            impulse < 3e-3*slip
         || std::fabs(turning)*impulse < 1e-6*slip
        )
        {
            return progress::none;
        }
        if (again)
        {
            turn.proceed();
        }
        else if (!turn.begin({mu, k11, k12, k22, f1, f2, a}, x, y))
        {
            return progress::none;
        }
        if (!turn.panel(slip, v, work, impulse, 1e-10))
        {
            return progress::none;
        }
        begun = true;

        const slipTurn::place last = turn.end();
        slipTurn::place start = turn.beginning();
        if (!restituting)
        {
            if (last.v < 0)
            {
                move(turn, last);
                return progress::some;
            }
            if (e2 == 0)
            {
                move(turn, turn.stoppingPoint());
                return progress::all;
            }
            start = turn.turningPoint();
            compression = start.work;
            restituting = true;
        }
        const double all = compression*(1 - e2);
        if (last.work < all)
        {
            move(turn, last);
            return progress::some;
        }
        if (start.work < all)
        {
            move(turn, turn.workDone(start, compression, all));
        }
        return progress::all;
    }

    //- The whole impact
    void run()
    {
        if (mu == 0)
        {
            finish(0, 0);
            return;
        }
        frictionSeries c;
        slipTurn turn;
        bool turning = false;
        for (int step = 0; step < 10000; ++step)
        {
            if (slip <= 1e-12 || slipEnds())
            {
                finishFromRest();
                return;
            }
            const progress done = turnOn(turn, turning);
            if (done == progress::all)
            {
                return;
            }
            if (done == progress::some)
            {
                continue;
            }
            expand(c);
            if (follow(c, range(c)))
            {
                return;
            }
        }
    }
};

} // End anonymous namespace


impact::reboundLaw::reboundLaw
(
    lawType law,
    double normal,
    double tangential,
    double friction
)
:
    law_(law),
    normal_(normal),
    tangential_(tangential),
    friction_(friction)
{}


impact::reboundLaw impact::reboundLaw::restitution
(
    double normal,
    double tangential
)
{
    checkRange("normal", normal, 0, 1, "[0, 1]");
    checkRange("tangential", tangential, -1, 1, "[-1, 1]");
    return reboundLaw(lawType::restitution, normal, tangential, 0);
}


impact::reboundLaw impact::reboundLaw::coulomb
(
    double restitution,
    double friction
)
{
    checkRange("restitution", restitution, 0, 1, "[0, 1]");
    checkRange("friction", friction, 0, 1e6, "[0, 1e6]");
    return reboundLaw(lawType::friction, restitution, 0, friction);
}


impact::vector3 impact::reboundLaw::frictionImpulse
(
    const vector3& inertia,
    const vector3& r,
    const vector3& n,
    const vector3& Vc0
) const
{
    vector3 t1 = std::fabs(n.x) < 0.6
        ? cross(n, vector3{1, 0, 0}) : cross(n, vector3{0, 1, 0});
    t1 = (1/mag(t1))*t1;
    const vector3 t2 = cross(n, t1);
    const vector3 inverse = {1/inertia.x, 1/inertia.y, 1/inertia.z};
    const vector3 K1 = response(inverse, r, t1);
    const vector3 K2 = response(inverse, r, t2);
    const vector3 Kn = response(inverse, r, n);
    const double speed0 = mag(Vc0);
    if (!(speed0 > 0))
    {
        return {0, 0, 0};
    }
    frictionProcess process
    (
        friction_, normal_*normal_,
        dot(t1, K1), dot(t1, K2), dot(t2, K2),
        dot(t1, Kn), dot(t2, Kn), dot(n, Kn),
        dot(t1, Vc0)/speed0, dot(t2, Vc0)/speed0, dot(n, Vc0)/speed0
    );
    process.run();
    return
        (speed0*process.S1)*t1 + (speed0*process.S2)*t2
      + (speed0*process.p)*n;
}


impact::impactRecord impact::reboundLaw::impact
(
    const vector3& inertia,
    const vector3& r,
    const vector3& n,
    const vector3& V,
    const vector3& omega
) const
{
    const vector3 Vc = V + cross(omega, r);
    const double vn = dot(Vc, n);

    impactRecord out;
    if (law_ == lawType::restitution)
    {
        const vector3 dVc =
            (tangential_ - 1)*Vc - ((normal_ + tangential_)*vn)*n;
        out.dOmega = spinChange(inertia, r, dVc);
        out.dV = dVc - cross(out.dOmega, r);
    }
    else
    {
        out.dV = frictionImpulse(inertia, r, n, Vc);
        const vector3 m = cross(r, out.dV);
        out.dOmega = {m.x/inertia.x, m.y/inertia.y, m.z/inertia.z};
    }
    out.approachSpeed = -vn;
    const vector3 spin = multiply(inertia, omega);
    const vector3 dSpin = multiply(inertia, out.dOmega);
    out.energyBefore = 0.5*(dot(V, V) + dot(omega, spin));
    out.energyChange =
        dot(V, out.dV) + 0.5*dot(out.dV, out.dV)
      + dot(omega, dSpin) + 0.5*dot(out.dOmega, dSpin);
    out.pulling = dot(out.dV, n) < 0;
    return out;
}
