/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Free rotation: the invariants over long flights, and an independent
    Runge-Kutta integration.
\*---------------------------------------------------------------------------*/

#include "freeRotation.H"
#include "counterRandom.H"
#include "orientation.H"

#include <gtest/gtest.h>
#include <cmath>

using namespace impact;

namespace
{

void rate(const vector3& J, const rotationState& s, rotationState& d)
{
    const vector3& w = s.omega;
    d.ex = cross(s.ex, w);
    d.ey = cross(s.ey, w);
    d.omega =
    {
        (J.y - J.z)/J.x*w.y*w.z,
        (J.z - J.x)/J.y*w.z*w.x,
        (J.x - J.y)/J.z*w.x*w.y
    };
}


rotationState shifted(const rotationState& s, double h, const rotationState& d)
{
    return {s.ex + h*d.ex, s.ey + h*d.ey, s.omega + h*d.omega};
}


rotationState rungeKutta(const vector3& J, rotationState s, double t, int n)
{
    const double h = t/n;
    for (int i = 0; i < n; ++i)
    {
        rotationState a, b, c, d;
        rate(J, s, a);
        rate(J, shifted(s, h/2, a), b);
        rate(J, shifted(s, h/2, b), c);
        rate(J, shifted(s, h, c), d);
        s = shifted(s, h/6, a);
        s = shifted(s, h/3, b);
        s = shifted(s, h/3, c);
        s = shifted(s, h/6, d);
    }
    return s;
}


rotationState start(int i)
{
    counterRandom rnd(9, i);
    rotationState s;
    const double u0 = rnd.uniform(), u1 = rnd.uniform();
    orient<orientationLaw::isotropic>(u0, u1, rnd.uniform(), s.ex, s.ey);
    s.omega = {rnd.normal(), rnd.normal(), rnd.normal()};
    return s;
}


rotationState fly(const convexBody& body, const rotationState& s, double t)
{
    freeRotation f(body, s);
    rotationState now;
    while (f.horizon() < t)
    {
        const double h = f.horizon();
        f.evaluate(h, now);
        f.restart(h, now);
    }
    f.evaluate(t, now);
    return now;
}


const convexBody bodies[] =
{
    convexBody::sphere(1),
    convexBody::ellipsoid({1, 0.8, 0.8}),
    convexBody::box({1.25, 1, 1.25}),
    convexBody::box({1, 1, 0.3}),
    convexBody::box({1, 0.6, 0.8}),
    convexBody::truncatedBox({1, 0.6, 0.8}, 0.25),
    convexBody::ellipsoid({1, 0.1, 0.5}),
    convexBody::box({100, 1, 3})
};

} // End anonymous namespace


TEST(freeRotation, agreesWithAnIndependentIntegration)
{
    for (const convexBody& body : bodies)
    {
        for (int i = 0; i < 5; ++i)
        {
            const rotationState s = start(i);
            const rotationState a = fly(body, s, 10);
            const rotationState b =
                rungeKutta(body.inertia(), s, 10, 20000);
            EXPECT_LT(mag(a.ex - b.ex), 1e-10);
            EXPECT_LT(mag(a.ey - b.ey), 1e-10);
            EXPECT_LT(mag(a.omega - b.omega), 1e-10);
        }
    }
}


TEST(freeRotation, keepsItsInvariantsOverALongFlight)
{
    for (const convexBody& body : bodies)
    {
        const vector3& J = body.inertia();
        for (int i = 0; i < 5; ++i)
        {
            // About twenty turns: no visit to a wall is longer
            const rotationState s = start(100 + i);
            const rotationState e = fly(body, s, 120/mag(s.omega));
            const vector3 L0 = multiply(J, s.omega);
            const vector3 L1 = multiply(J, e.omega);
            EXPECT_NEAR
            (
                dot(L1, e.omega)/dot(L0, s.omega), 1, 1e-10
            );
            EXPECT_NEAR(dot(L1, e.ex), dot(L0, s.ex), 1e-10*mag(L0));
            EXPECT_NEAR(dot(L1, e.ey), dot(L0, s.ey), 1e-10*mag(L0));
            EXPECT_NEAR(dot(L1, e.ez()), dot(L0, s.ez()), 1e-10*mag(L0));
            EXPECT_NEAR(mag(e.ex), 1, 1e-10);
            EXPECT_NEAR(dot(e.ex, e.ey), 0, 1e-10);
        }
    }
}


TEST(freeRotation, boundsTheMotionOfItsPoints)
{
    for (const convexBody& body : bodies)
    {
        const double R = body.radius();
        for (int i = 0; i < 20; ++i)
        {
            const rotationState s = start(200 + i);
            const freeRotation f(body, s);
            double fastest = 0, sharpest = 0;
            for (int k = 0; k < 200; ++k)
            {
                const rotationState n = fly(body, s, 0.1*k);
                rotationState d;
                rate(body.inertia(), n, d);
                fastest = std::max(fastest, mag(n.omega));
                for (const vector3& r :
                    {
                        vector3{R, 0, 0}, vector3{0, R, 0},
                        vector3{0, 0, R}
                    })
                {
                    sharpest = std::max
                    (
                        sharpest,
                        mag
                        (
                            cross(d.omega, r)
                          + cross(n.omega, cross(n.omega, r))
                        )
                    );
                }
            }
            const double w = f.maxOmega();
            EXPECT_LE(fastest, w*(1 + 1e-10));
            EXPECT_LE
            (
                sharpest,
                R*w*w*(1 + freeRotation::skewness(body))*(1 + 1e-10)
            );
        }
    }
}
