/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The integrator of position, velocity and spin: orders of the schemes,
    error against tolerance, steps of many relaxation times, discontinuous
    torque, the limit on evaluations.
\*---------------------------------------------------------------------------*/

#include "hendersonDrag.H"
#include "largest.H"
#include "particleMotion.H"

#include <gtest/gtest.h>
#include <cmath>
#include <random>
#include <stdexcept>

using namespace impact;

namespace
{

double distance(const vector3& a, const vector3& b)
{
    return mag(a - b);
}


//- Linear drag in the linear velocity field u_x = g x, a spin that relaxes,
//  and a constant rotation of the relative velocity about z
struct linearForce
{
    double k, g, turn, kSpin;

    motionRate operator()(const motionState& s) const
    {
        const vector3 u{g*s.x.x, 0, 0};
        motionRate r;
        r.k = k;
        r.kSpin = kSpin;
        r.turn = vector3{0, 0, turn};
        r.a = k*(u - s.v) + cross(r.turn, u - s.v);
        r.alpha = -kSpin*s.omega;
        return r;
    }
};


//- Exact solution without rotation: x'' = k (g x - x')
double exactSpeed(double k, double g, double v, double t)
{
    const double root = std::sqrt(k*k/4 + k*g);
    const double l1 = -k/2 + root, l2 = -k/2 - root;
    const double c = v/(l1 - l2);
    return c*(l1*std::exp(l1*t) - l2*std::exp(l2*t));
}


//- A step with all explicit stages: solutions of order 5 and 4
template<class Force>
void rungeKutta
(
    const Force& force,
    const motionState& start,
    double h,
    motionState& fifth,
    motionState& fourth
)
{
    motionState s[6];
    motionRate f[6];
    const auto sum = [&](const double* weights, int n)
    {
        motionState to = start;
        for (int j = 0; j < n; ++j)
        {
            to.x = to.x + h*weights[j]*s[j].v;
            to.v = to.v + h*weights[j]*f[j].a;
            to.omega = to.omega + h*weights[j]*f[j].alpha;
        }
        return to;
    };
    for (int i = 0; i < 6; ++i)
    {
        s[i] = sum(cashKarp::stage[i], i);
        f[i] = force(s[i]);
    }
    fifth = sum(cashKarp::fifth, 6);
    fourth = sum(cashKarp::fourth, 6);
}


//- A step for which there are evaluations for the exponential method alone
template<class Force>
motionState exponential(const Force& force, const motionState& s, double h)
{
    return particleMotion(0.1).step(force, s, 0, 0, h, h, 3).state;
}


//- Advance over a time in steps with control; evaluations spent
template<class Force>
int advance
(
    const particleMotion& motion,
    const Force& force,
    motionState& s,
    double time
)
{
    int n = 0;
    vector3 x = s.x;
    double t = 0;
    double hTry = time;
    while (t < time)
    {
        s.x = vector3{0, 0, 0};
        const auto moved =
            [&](const motionState& other)
            {
                motionState absolute = other;
                absolute.x = x + other.x;
                return force(absolute);
            };
        const auto o =
            motion.step(moved, s, 0, 0, time - t, hTry, 50);
        EXPECT_LE(o.nForce, 50);
        n += o.nForce;
        s = o.state;
        x = x + s.x;
        t = o.h < time - t ? t + o.h : time;
        hTry = o.hNext;
    }
    s.x = x;
    return n;
}


//- A sphere in Mach 6 flow, with the full forces of the page
struct sphereInGas
{
    sphereForces::counts counts;
    hendersonDrag drag{1.4, 1};
    sphereForces force;
    gasState gas;

    sphereInGas(double d, double speed)
    :
        force(&drag, 401.87, true, true, vector3{0, 0, 0}, counts)
    {
        force.sphere(d, 2500);
        gas.u = vector3{speed, 0, 0};
        gas.spin = vector3{0, 0, 0};
        gas.rho = 0.4135;
        gas.mu = 1.458e-5;
        gas.T = 223.25;
    }

    motionRate operator()(const motionState& s) const
    {
        return force(gas, s.v, s.omega);
    }
};

} // End anonymous namespace


TEST(particleMotion, hasOrderFiveAndFour)
{
    const linearForce force{3, 0.8, 0, 2};
    double last5 = 0, last4 = 0;
    for (int n = 16; n <= 128; n *= 2)
    {
        motionState s{{0, 0, 0}, {2, 0, 0}, {0, 0, 5}};
        motionState s4;
        double worst4 = 0;
        for (int i = 0; i < n; ++i)
        {
            motionState end;
            rungeKutta(force, s, 1./n, end, s4);
            worst4 = largest(worst4, distance(end.v, s4.v));
            s = end;
        }
        const double e5 = std::fabs(s.v.x - exactSpeed(3, 0.8, 2, 1));
        EXPECT_NEAR(s.omega.z, 5*std::exp(-2), 1e-5);
        if (last5 > 0)
        {
            EXPECT_NEAR(std::log2(last5/e5), 5, 0.35) << n;
            EXPECT_NEAR(std::log2(last4/worst4), 5, 0.35) << n;
        }
        last5 = e5;
        last4 = worst4;
    }
    EXPECT_LT(last5, 1e-10);
}


TEST(particleMotion, exponentialStepHasOrderThree)
{
    // The frozen part is only a part of the force here: g is not in it, nor
    // is the second half of k
    struct partly : linearForce
    {
        motionRate operator()(const motionState& s) const
        {
            motionRate r = linearForce::operator()(s);
            r.k *= 0.5;
            r.kSpin *= 0.7;
            return r;
        }
    };
    partly force;
    force.k = 3; force.g = 0.8; force.turn = 0; force.kSpin = 2;
    double last = 0;
    for (int n = 8; n <= 64; n *= 2)
    {
        motionState s{{0, 0, 0}, {2, 0, 0}, {0, 0, 5}};
        for (int i = 0; i < n; ++i)
        {
            s = exponential(force, s, 1./n);
        }
        const double e = std::fabs(s.v.x - exactSpeed(3, 0.8, 2, 1));
        EXPECT_NEAR(s.omega.z, 5*std::exp(-2), 2e-3);
        if (last > 0)
        {
            EXPECT_NEAR(std::log2(last/e), 3, 0.3) << n;
        }
        last = e;
    }
}


TEST(particleMotion, exponentialStepIsExactInUniformGas)
{
    // Relaxation and rotation of the relative velocity in one long step
    for (const double h : {1e-3, 0.5, 2., 30., 1e6})
    {
        const linearForce force{3, 0, 7, 2};
        const motionState s{{0, 0, 0}, {2, 1, 0.5}, {1, 2, 3}};
        const motionState end = exponential(force, s, h);
        const double e = std::exp(-3*h);
        const double c = std::cos(7*h), n = std::sin(7*h);
        const vector3 v{e*(2*c + n), e*(c - 2*n), 0.5*e};
        EXPECT_LT(distance(end.v, v), 1e-13) << h;
        EXPECT_LT(distance(end.omega, std::exp(-2*h)*s.omega), 1e-13);
        // Stop distance: (k + turn x) x = v0 - v
        const vector3 lost = 3*end.x + cross(vector3{0, 0, 7}, end.x);
        EXPECT_LT(distance(lost, s.v - v), 1e-13*(1 + h)) << h;
    }
}


TEST(particleMotion, keepsTheTolerance)
{
    for (const double k : {0.01, 1., 30., 1000.})
    {
        const linearForce force{k, 0.8, 0, 0.3*k};
        for (const double tolerance : {1e-3, 1e-5, 1e-8, 1e-11})
        {
            const particleMotion motion(tolerance);
            motionState s{{0, 0, 0}, {2, 0, 0}, {0, 0, 5}};
            const int n = advance(motion, force, s, 1);
            const double error = std::fabs(s.v.x - exactSpeed(k, 0.8, 2, 1));
            EXPECT_LT(error, 2*n*tolerance) << k << ' ' << tolerance;
            EXPECT_NEAR(s.omega.z, 5*std::exp(-0.3*k), 5*n*tolerance);
        }
    }
}


TEST(particleMotion, endsEarlyWhereThatIsEnough)
{
    const linearForce force{1, 0, 0, 1};
    const motionState s{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}};
    const particleMotion motion(1e-5);
    EXPECT_EQ(motion.step(force, s, 0, 0, 1e-3, 1e-3, 50).nForce, 2);
    EXPECT_EQ(motion.step(force, s, 0, 0, 0.03, 0.03, 50).nForce, 4);
    EXPECT_EQ(motion.step(force, s, 0, 0, 0.2, 0.2, 50).nForce, 6);
}


TEST(particleMotion, aTinyGrainFollowsTheGas)
{
    // 0.1 um, relaxation about 1e-7 s; velocity field with u' = 1e-3/step
    sphereInGas sphere(1e-7, 300);
    const motionState still{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    const double tau = 1/sphere(still).k;
    const double h = 1e6*tau;
    const double gradient = 1e-3/h;
    const auto force =
        [&](const motionState& s)
        {
            sphereInGas here(sphere);
            here.gas.u = vector3{300*(1 + gradient/300*s.x.x), 0, 0};
            here.gas.spin = vector3{0, 0, 1e3};
            return here(s);
        };
    const particleMotion motion(1e-5);
    motionState s{{0, 0, 0}, {-500, 200, 0}, {1e9, -1e9, 3e8}};
    int n = 0;
    double t = 0, hTry = h;
    vector3 x{0, 0, 0};
    while (t < h && n < 50)
    {
        s.x = vector3{0, 0, 0};
        const auto moved =
            [&](const motionState& o)
            {
                motionState a = o;
                a.x = x + o.x;
                return force(a);
            };
        const auto o = motion.step(moved, s, 300, 1e3, h - t, hTry, 50 - n);
        n += o.nForce;
        s = o.state;
        x = x + s.x;
        t += o.h;
        hTry = o.hNext;
    }
    EXPECT_LE(n, 50);
    EXPECT_NEAR(t/h, 1, 1e-12);
    EXPECT_NEAR(s.v.x/(300*(1 + gradient/300*x.x)), 1, 1e-4);
    EXPECT_NEAR(x.x/(300*h), 1 + 0.5e-3, 1e-4);
    EXPECT_NEAR(s.v.y/300, 0, 1e-4);
    EXPECT_NEAR(s.omega.z/1e3, 1, 1e-3);
    EXPECT_NEAR(s.omega.x/1e3, 0, 1e-3);
}


TEST(particleMotion, stepsAcrossTheJumpOfTheTorque)
{
    // Spin alone, from far above to below ReOmega = 32
    sphereInGas sphere(2e-5, 0);
    const double scale = rotationalTorque::scale(2e-5, 2500, sphere.gas.mu);
    const double Re0 = 4e-10*sphere.gas.rho*5e6/sphere.gas.mu;
    ASSERT_GT(Re0, 50);
    const double time = 0.012/scale;
    const double share = rotationalTorque::remaining(Re0, 0.012);
    for (const double tolerance : {1e-4, 1e-5, 1e-6})
    {
        const particleMotion motion(tolerance);
        motionState s{{0, 0, 0}, {0, 0, 0}, {0, 5e6, 0}};
        const int n = advance(motion, sphere, s, time);
        EXPECT_NEAR(s.omega.y/5e6, share, 3*tolerance);
        EXPECT_LT(n, 200) << tolerance;
    }
}


TEST(particleMotion, neverSpendsMoreThanAllowed)
{
    // Sizes over six decades, any speeds, spins and steps
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const particleMotion motion(1e-10);
    int forced = 0;
    for (int i = 0; i < 3000; ++i)
    {
        sphereInGas sphere
        (
            std::pow(10., -6 + 3*uniform(random)),
            2000*uniform(random)
        );
        const double spin = std::pow(10., 9*uniform(random));
        const motionState s
        {
            {0, 0, 0},
            {2000*uniform(random), i % 3 ? 500*uniform(random) : 0, 0},
            {spin*uniform(random), spin*uniform(random), 0}
        };
        const double h = std::pow(10., -4 + 5*uniform(random));
        const int allowed = 3 + i % 48;
        const auto o = motion.step(sphere, s, 2000, 0, h, h, allowed);
        EXPECT_LE(o.nForce, allowed);
        EXPECT_LE(mag(o.state.v), 1e4);
        EXPECT_LE(mag(o.state.omega), 1.01*mag(s.omega));
        EXPECT_TRUE(o.h > 0 && o.h <= h);
        EXPECT_TRUE(!o.forced || o.h == h);
        forced += o.forced;
    }
    EXPECT_GT(forced, 0);
}


TEST(particleMotion, restIsRest)
{
    sphereInGas sphere(5e-6, 0);
    const motionState s{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    const auto o = particleMotion(1e-6).step(sphere, s, 0, 0, 1, 1, 50);
    EXPECT_EQ(mag(o.state.v), 0);
    EXPECT_EQ(mag(o.state.x), 0);
    EXPECT_EQ(mag(o.state.omega), 0);
    EXPECT_EQ(o.h, 1);
}


TEST(particleMotion, countsEvaluationsOutsideTheFits)
{
    sphereInGas sphere(5e-6, 10);
    motionState s{{0, 0, 0}, {0, 0, 0}, {0, 0, 1e6}};
    sphere(s);
    EXPECT_EQ(sphere.counts.magnus, 1);
    EXPECT_EQ(sphere.counts.magnusOutside, 0);
    EXPECT_EQ(sphere.counts.torqueOutside, 0);
    s.v.x = -3000;
    s.omega.z = 1e10;
    sphere(s);
    EXPECT_EQ(sphere.counts.magnus, 2);
    EXPECT_EQ(sphere.counts.torque, 2);
    EXPECT_EQ(sphere.counts.magnusOutside, 1);
    EXPECT_EQ(sphere.counts.torqueOutside, 1);
}


TEST(particleMotion, refusesBadTolerance)
{
    for (const double bad : {0., -1e-5, 0.2, 1e-16})
    {
        EXPECT_THROW(particleMotion motion(bad), std::invalid_argument);
    }
}
