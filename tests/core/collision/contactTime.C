/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Contact times against a scan in quadruple precision, at tangency, at
    double roots, and from touching and overlapping starts.
\*---------------------------------------------------------------------------*/

#include "contactTime.H"
#include "bracketedRoot.H"
#include "counterRandom.H"

#include <gtest/gtest.h>
#include <cmath>

using namespace impact;

namespace
{

typedef __float128 quad;

vector3 randomVector(counterRandom& rnd)
{
    return {rnd.normal(), rnd.normal(), rnd.normal()};
}


struct motion
{
    vector3 s, v, a;
    double sigma, end;

    quad gap(quad t) const
    {
        quad sum = -quad(sigma)*sigma;
        for (int k = 0; k < 3; ++k)
        {
            const quad x = quad(s[k]) + t*(quad(v[k]) + t*quad(a[k])/2);
            sum += x*x;
        }
        return sum;
    }

    quad rate(quad t) const
    {
        quad sum = 0;
        for (int k = 0; k < 3; ++k)
        {
            const quad x = quad(s[k]) + t*(quad(v[k]) + t*quad(a[k])/2);
            sum += 2*x*(quad(v[k]) + t*quad(a[k]));
        }
        return sum;
    }

    //- By definition, on n intervals: never if it finds none. depth becomes
    //  the least value of p on the points
    double scan(int n, double& minGap) const
    {
        minGap = never;
        quad last = 0;
        for (int i = 0; i <= n; ++i)
        {
            const quad t = quad(end)*i/n;
            const quad p = gap(t);
            minGap = std::min(minGap, double(p));
            if (p <= 0 && rate(t) < 0)
            {
                if (i == 0)
                {
                    return 0;
                }
                if (last <= 0)
                {
                    return double(t);   // turned back while overlapping
                }
                return bracketedChange
                (
                    [&](double time) { return gap(time) > 0; },
                    double(quad(end)*(i - 1)/n),
                    double(t),
                    [](double, double) { return false; }
                ).second;
            }
            last = p;
        }
        return never;
    }

    double solve(contactTolerance tolerance = {}) const
    {
        return parabolicContact(s, v, a, sigma, end, tolerance);
    }
};

} // End anonymous namespace


TEST(contactTime, ofStraightPathsIsThatOfQuadruplePrecision)
{
    int contacts = 0;
    for (int i = 0; i < 20000; ++i)
    {
        counterRandom rnd(21, i);
        const double sigma = 0.5 + rnd.uniform();
        const double scale = std::pow(10., 4*rnd.uniform());
        vector3 s = scale*randomVector(rnd);
        s = ((sigma + scale)/mag(s))*s;
        // Aimed at a point within 1.2 sigma of the centre
        vector3 v = (1.2*sigma*rnd.uniform()/scale)*randomVector(rnd)
          - (1/mag(s))*s;
        v = std::pow(10., 8*rnd.uniform() - 4)*v;

        quad ss = 0, sv = 0, vv = 0;
        for (int k = 0; k < 3; ++k)
        {
            ss += quad(s[k])*s[k];
            sv += quad(s[k])*v[k];
            vv += quad(v[k])*v[k];
        }
        const quad c = ss - quad(sigma)*sigma;
        const quad square = sv*sv - vv*c;
        const double t = straightContact(s, v, sigma, never);
        const double margin = double(square/(vv*sigma*sigma));
        if (std::fabs(margin) < 1e-13)
        {
            continue;
        }
        if (sv >= 0 || square <= 0)
        {
            EXPECT_EQ(t, never) << i;
            continue;
        }
        ++contacts;
        const double expected =
            double(c/(quad(std::sqrt(double(square))) - sv));
        // The root is as well known as the separation over the speed of
        // closing allows
        const double closing = std::sqrt(std::fabs(margin));
        EXPECT_NEAR
        (
            t, expected,
            1e-14*expected + 1e-15*mag(s)/mag(v)/closing
        ) << i;
        EXPECT_EQ(straightContact(s, v, sigma, 0.999*t), never);
        EXPECT_EQ(straightContact(s, v, sigma, 1.001*t), t);
    }
    EXPECT_GT(contacts, 5000);
}


TEST(contactTime, ofStraightPathsNearTangency)
{
    // Depth of passing from 1e-1 to 1e-15 of the diameter; the exact time is
    // L - sqrt(sigma^2 - b^2)
    const double sigma = 1;
    for (double distance : {3., 1e3})
    {
        for (double depth = 0.1; depth > 2e-15; depth *= 0.1)
        {
            const double b = sigma - depth;
            const vector3 s = {distance, b, 0};
            const double t = straightContact(s, {-1, 0, 0}, sigma, never);
            ASSERT_NE(t, never) << depth;
            const double half = std::sqrt((sigma - b)*(sigma + b));
            EXPECT_NEAR
                (t, distance - half, 1e-15*(distance + 1/half));
        }
        EXPECT_EQ
        (
            straightContact
                ({distance, sigma, 0}, {-1, 0, 0}, sigma, never),
            never
        );
        EXPECT_EQ
        (
            straightContact
            (
                {distance, std::nextafter(sigma, 2), 0}, {-1, 0, 0},
                sigma, never
            ),
            never
        );
    }
}


TEST(contactTime, ofParabolicPathsIsThatOfAQuadrupleScan)
{
    int contacts = 0, misses = 0, overlapping = 0;
    for (int i = 0; i < 2500; ++i)
    {
        counterRandom rnd(22, i);
        motion m;
        m.sigma = 0.2 + rnd.uniform();
        m.end = 2;
        const double far = i % 5 == 0 ? 0.3 : 1.5;
        m.s = far*randomVector(rnd);
        m.v = 2*randomVector(rnd) - m.s;
        m.a = std::pow(10., 3*rnd.uniform() - 2)*randomVector(rnd);
        if (i % 2 == 1)
        {
            m.s.z = m.v.z = m.a.z = 0;
        }
        double minGap;
        const int n = 1000;
        const double expected = m.scan(n, minGap);
        const double t = m.solve();
        const double step = m.end/n;
        const double speed = mag(m.v) + mag(m.a)*m.end;
        const bool inside = dot(m.s, m.s) < m.sigma*m.sigma;
        overlapping += inside;
        if (expected == never)
        {
            ++misses;
            if (t != never)
            {
                // Between two points of the scan: it must be true all the
                // same
                EXPECT_LE(double(m.gap(t)), 1e-13*(1 + dot(m.s, m.s)));
                EXPECT_LT(minGap, speed*speed*step*step + 2*speed*step);
            }
            continue;
        }
        ++contacts;
        ASSERT_NE(t, never) << i;
        if (inside && expected > 0 && double(m.gap(t)) < -1e-9)
        {
            // Turned while they overlapped: where the rate changes sign
            EXPECT_NEAR(t, expected, 1.01*step) << i;
            EXPECT_NEAR
                (double(m.rate(t)), 0, 1e-12*(1 + speed*speed)) << i;
        }
        else
        {
            if (t < expected - step)
            {
                // A shallow contact that the scan stepped over
                EXPECT_LE(std::fabs(double(m.gap(t))), 1e-12);
                EXPECT_LT(double(m.rate(t)), 0);
                continue;
            }
            const double rate = std::fabs(double(m.rate(expected)));
            EXPECT_NEAR
            (
                t, expected,
                1e-14*m.end
              + 4e-15*(1 + dot(m.s, m.s) + speed*speed)/(rate + 1e-300)
            ) << i;
        }
    }
    EXPECT_GT(contacts, 600);
    EXPECT_GT(misses, 500);
    EXPECT_GT(overlapping, 200);
}


TEST(contactTime, findsEveryDepthOfAParabolaThatDipsIn)
{
    // Vertical throw past a sphere at rest: the separation turns at its
    // lowest point, (0, sigma - depth); p has a double root at depth 0
    const double sigma = 1;
    for (double g : {0.1, 1., 1e3})
    {
        for (double depth = 0.1; depth > 3e-15; depth *= 0.1)
        {
            motion m;
            m.sigma = sigma;
            m.end = 10/std::sqrt(g);
            const double fall = 2;
            m.s = {0, sigma - depth + fall, 0};
            m.v = {0, -std::sqrt(2*g*fall), 0};
            m.a = {0, g, 0};
            const double t = m.solve();

            // Depth as the rounded data have it
            const quad lowest = quad(m.s.y)
              - quad(m.v.y)*m.v.y/(2*quad(g)) - quad(sigma);
            if (double(lowest) > 1e-15)
            {
                EXPECT_EQ(t, never) << depth;
                continue;
            }
            if (double(lowest) > -1e-15)
            {
                continue;
            }
            ASSERT_NE(t, never) << depth;
            const double before = std::sqrt(-2*double(lowest)/g);
            EXPECT_NEAR
            (
                t, -m.v.y/g - before,
                1e-15*m.end + 4e-15/(g*before)
            ) << depth;
        }

        // Above it by as little: no contact
        for (double height : {1e-13, 1e-10, 1e-3})
        {
            motion m;
            m.sigma = sigma;
            m.end = 10/std::sqrt(g);
            m.s = {0, sigma + height + 2, 0};
            m.v = {0, -std::sqrt(4*g), 0};
            m.a = {0, g, 0};
            EXPECT_EQ(m.solve(), never) << height;
        }
    }
}


TEST(contactTime, findsTheFirstOfTwoDips)
{
    // A W in the distance: s = (x, y), x = 1.5 - 2 t + t^2/2 ... p has four
    // real roots, two approaches; the second counts when the first misses
    motion m;
    m.end = 10;
    m.s = {3, 0.5, 0};
    m.v = {-4, 0, 0};
    m.a = {2, 0, 0};
    // x = 3 - 4 t + t^2 = 0 at t = 1 and 3, y = 0.5
    m.sigma = 0.8;
    const double half = std::sqrt(0.64 - 0.25);
    EXPECT_NEAR(m.solve(), 2 - std::sqrt(1 + half), 1e-14);

    // Lift the first pass: y = 0.5 + c (3 - t) with y(3) = 0.5
    m.s.y = 3.5;
    m.v.y = -1;
    double minGap;
    const double expected = m.scan(200000, minGap);
    EXPECT_GT(expected, 1.5);
    EXPECT_NEAR(m.solve(), expected, 1e-13);
}


TEST(contactTime, ofTouchingAndOverlappingStarts)
{
    motion m;
    m.sigma = 1;
    m.end = 10;

    // Touching and approaching: now
    m.s = {1, 0, 0};
    m.v = {-1, 0, 0};
    m.a = {0, 0, 0};
    EXPECT_EQ(m.solve(), 0);
    m.a = {0.3, 0, 0};
    EXPECT_EQ(m.solve(), 0);

    // Touching and parting: when it comes back
    m.v = {1, 0, 0};
    EXPECT_EQ(m.solve(), never);
    m.a = {-0.5, 0, 0};
    EXPECT_NEAR(m.solve(), 4, 1e-14);

    // Overlapping and parting for good, or back before it is out: at the
    // turn
    m.s = {0.9, 0, 0};
    m.a = {0, 0, 0};
    EXPECT_EQ(m.solve(), never);
    m.v = {0.01, 0, 0};
    m.a = {-0.1, 0, 0};
    EXPECT_NEAR(m.solve(), 0.1, 1e-14);

    // Overlapping and out before it is back
    m.v = {1, 0, 0};
    m.a = {-0.5, 0, 0};
    // 0.9 + t - t^2/4 = 1
    EXPECT_NEAR(m.solve(), 2 + std::sqrt(4 - 0.4), 1e-14);

    // At rest in contact, pressed together
    m.s = {1, 0, 0};
    m.v = {0, 0, 0};
    m.a = {-1, 0, 0};
    EXPECT_EQ(m.solve(), 0);

    // Concentric: any motion parts them
    m.s = {0, 0, 0};
    m.v = {1, 0, 0};
    m.a = {0, 0, 0};
    EXPECT_EQ(m.solve(), never);
    m.a = {-1, 0, 0};
    EXPECT_NEAR(m.solve(), 1, 1e-14);
}


TEST(contactTime, tolerancesPostponeWhatRestsInContact)
{
    motion m;
    m.sigma = 1;
    m.end = 10;
    m.s = {1 + 1e-12, 0, 0};
    m.v = {-1e-9, 0, 0};
    m.a = {0, 0, 0};
    EXPECT_EQ(m.solve({1e-11, 1e-8}), never);
    EXPECT_EQ(m.solve({1e-11, 1e-10}), 0);
    EXPECT_NEAR(m.solve(), 1e-3, 1e-6);

    // Pressed together: when it has become fast enough
    m.s = {1, 0, 0};
    m.a = {-0.5, 0, 0};
    EXPECT_NEAR(m.solve({1e-11, 1e-3}), 2*(1e-3 - 1e-9), 1e-8);
    EXPECT_EQ(m.solve({1e-11, 100.}), never);

    // The tolerance does not hide a contact after a flight
    m.v = {1, 0, 0};
    EXPECT_NEAR(m.solve({1e-11, 1e-3}), 4, 1e-10);
}


TEST(contactTime, letsRestingPairsSinkInByALittle)
{
    // Depth 1e-4, speed 1e-2
    const contactTolerance rest = {1e-12, 1e-12, 1e-2, 1e-4};
    motion m;
    m.sigma = 1;
    m.end = 10;
    m.a = {0, 0, 0};
    for (double gap : {5e-5, 0., -5e-5})
    {
        // Slow, straight: at the depth. Fast: at contact
        m.s = {1 + gap, 0, 0};
        m.v = {-1e-3, 0, 0};
        EXPECT_NEAR(m.solve(rest), (gap + 1e-4)/1e-3, 1e-10);
        m.v = {-2e-2, 0, 0};
        EXPECT_NEAR(m.solve(rest), std::max(gap, 0.)/2e-2, 1e-10);

        // From rest with an acceleration: as fast as 1e-2, or at the depth
        m.v = {0, 0, 0};
        for (double a : {10., 1e-2})
        {
            m.a = {-a, 0, 0};
            const double deep = std::sqrt(2*(gap + 1e-4)/a);
            const double expected = std::min(deep, 1e-2/a);
            // The rate of p is taken for the speed: s against sigma
            EXPECT_NEAR(m.solve(rest), expected, 1e-4*expected);
        }
        m.a = {0, 0, 0};
    }
    // Deeper than that: at once
    m.s = {1 - 2e-4, 0, 0};
    m.v = {-1e-3, 0, 0};
    EXPECT_EQ(m.solve(rest), 0);
}


TEST(contactTime, ofSmallAccelerationIsThatOfStraightPaths)
{
    for (int i = 0; i < 2000; ++i)
    {
        counterRandom rnd(23, i);
        const vector3 s = 3*randomVector(rnd);
        const vector3 v = randomVector(rnd) - 0.5*s;
        if (mag(s) < 1.1)
        {
            continue;
        }
        const double straight = straightContact(s, v, 1, 20);
        const vector3 a = 1e-14*randomVector(rnd);
        const double curved = parabolicContact(s, v, a, 1, 20);
        if (straight == never || curved == never)
        {
            // Only a graze may differ
            const double passing = mag(cross(s, v))/mag(v);
            EXPECT_TRUE(straight == curved || std::fabs(passing - 1) < 1e-11);
            continue;
        }
        const double closing =
            std::fabs(dot(s + straight*v, v))/mag(v);
        EXPECT_NEAR(curved, straight, 1e-11/closing);
    }
}
