/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Panels of turning slip against small Runge-Kutta steps of Coulomb's
    equations.
\*---------------------------------------------------------------------------*/

#include "slipTurn.H"
#include "counterRandom.H"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

using namespace impact;

namespace
{

//- Slip, velocity along the normal, impulses, and the work of the normal one
struct motion
{
    double x, y, v, S1, S2, p, work;
};


motion sum(const motion& a, double h, const motion& b)
{
    return
    {
        a.x + h*b.x, a.y + h*b.y, a.v + h*b.v, a.S1 + h*b.S1,
        a.S2 + h*b.S2, a.p + h*b.p, a.work + h*b.work
    };
}


motion rate(const contactResponse& c, const motion& q)
{
    const double s = std::hypot(q.x, q.y);
    const double ex = q.x/s, ey = q.y/s;
    return
    {
        c.f1 - c.mu*(c.k11*ex + c.k12*ey), c.f2 - c.mu*(c.k12*ex + c.k22*ey),
        c.a - c.mu*(c.f1*ex + c.f2*ey), -c.mu*ex, -c.mu*ey, 1, q.v
    };
}


//- After the normal impulse p
motion integrated(const contactResponse& c, motion q, double p)
{
    const int n = 4000;
    const double h = p/n;
    for (int i = 0; i < n; ++i)
    {
        const motion r1 = rate(c, q);
        const motion r2 = rate(c, sum(q, 0.5*h, r1));
        const motion r3 = rate(c, sum(q, 0.5*h, r2));
        const motion r4 = rate(c, sum(q, h, r3));
        q = sum(sum(sum(sum(q, h/6, r1), h/3, r2), h/3, r3), h/6, r4);
    }
    return q;
}


//- A response that a body can have: more than that of its mass alone
contactResponse randomResponse(counterRandom& rnd)
{
    double b[3][3];
    for (auto& line : b)
    {
        for (double& value : line)
        {
            value = rnd.normal();
        }
    }
    auto product = [&](int i, int j)
    {
        return b[i][0]*b[j][0] + b[i][1]*b[j][1] + b[i][2]*b[j][2];
    };
    contactResponse c;
    c.mu = 0.05 + rnd.uniform();
    c.k11 = 1 + product(0, 0);
    c.k12 = product(0, 1);
    c.k22 = 1 + product(1, 1);
    c.f1 = product(0, 2);
    c.f2 = product(1, 2);
    c.a = 1 + product(2, 2);
    return c;
}

} // End anonymous namespace


TEST(slipTurn, agreesWithSmallSteps)
{
    int panels = 0, turned = 0, second = 0;
    for (int i = 0; i < 400; ++i)
    {
        counterRandom rnd(31, i);
        const contactResponse c = randomResponse(rnd);
        motion q =
            {rnd.normal(), rnd.normal(), -0.2 - rnd.uniform(), 0, 0, 0, 0};
        slipTurn turn;
        if (!turn.begin(c, q.x, q.y))
        {
            continue;
        }
        for (int n = 0; n < 2; ++n)
        {
            const double impulse = 1.5*std::fabs(q.v)/c.a;
            const double slip = std::hypot(q.x, q.y);
            if (n == 1)
            {
                turn.proceed();
            }
            if (!turn.panel(slip, q.v, q.work, impulse, 1e-10))
            {
                break;
            }
            ++panels;
            second += n;

            // Close to the end of slip the small steps are not exact
            auto check = [&](const slipTurn::place& to)
            {
                const motion r = integrated(c, q, to.p);
                double S1, S2, x, y;
                turn.tangential(to, S1, S2, x, y);
                EXPECT_NEAR(x, r.x, 2e-8) << "run " << i;
                EXPECT_NEAR(y, r.y, 2e-8) << "run " << i;
                EXPECT_NEAR(to.v, r.v, 2e-8) << "run " << i;
                EXPECT_NEAR(q.S1 + S1, r.S1, 2e-8) << "run " << i;
                EXPECT_NEAR(q.S2 + S2, r.S2, 2e-8) << "run " << i;
                EXPECT_NEAR(to.work, r.work, 2e-8) << "run " << i;
                return r;
            };
            const slipTurn::place last = turn.end();
            if (last.s < 0.02*slip)
            {
                break;
            }
            const motion r = check(last);
            if (q.v < 0 && last.v > 0)
            {
                ++turned;
                const slipTurn::place low = turn.stoppingPoint();
                const double deepest = turn.turningPoint().work;
                EXPECT_NEAR(turn.turningPoint().p, low.p, 1e-7);
                EXPECT_NEAR(low.v, 0, 1e-13);
                EXPECT_NEAR(low.work, deepest, 1e-11);
                check(low);
                const double some = deepest + 0.3*(last.work - deepest);
                const slipTurn::place to = turn.workDone(low, deepest, some);
                EXPECT_NEAR(to.work, some, 1e-11);
                EXPECT_GT(to.p, low.p);
                check(to);
            }
            q = r;
        }
    }
    EXPECT_GT(panels, 300);
    EXPECT_GT(second, 50);
    EXPECT_GT(turned, 100);
}


TEST(slipTurn, leavesStraightSlipAlone)
{
    // Of a sphere; along an axis of symmetry
    slipTurn turn;
    EXPECT_FALSE(turn.begin({0.3, 3.5, 0, 3.5, 0, 0, 1}, 0.6, 0.8));
    EXPECT_FALSE(turn.begin({0.3, 2, 0, 3, 0.5, 0, 2}, 1, 0));
}
