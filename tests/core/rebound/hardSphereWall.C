/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    A hard sphere on a wall against the conservation laws, against the
    component formulae of its source in the frame of the wall, and against the
    closed solution for a contact at rest; extremes and bad values.
\*---------------------------------------------------------------------------*/

#include "hardSphereWall.H"
#include "counterRandom.H"

#include <gtest/gtest.h>
#include <cmath>
#include <stdexcept>
#include <string>

using namespace impact;

namespace
{

typedef reboundCoefficient form;

hardSphereWall constantWall(double restitution, double friction)
{
    return hardSphereWall
    (
        form::constant(form::restitutionQuantity(), restitution),
        form::constant(form::frictionQuantity(), friction)
    );
}


hardSphereWall wallOfSpeed(double restitution, double speed, double friction)
{
    return hardSphereWall
    (
        form::McNamaraFalcon(form::restitutionQuantity(), restitution, speed),
        form::constant(form::frictionQuantity(), friction)
    );
}


vector3 randomUnit(counterRandom& rnd)
{
    const vector3 v = {rnd.normal(), rnd.normal(), rnd.normal()};
    return (1/mag(v))*v;
}


//- Angular momentum per unit mass about the contact point
vector3 momentumAboutContact
(
    const vector3& n,
    double radius,
    const sphereState& s
)
{
    return radius*cross(n, s.V) + sphereInertia(radius)*s.omega;
}


double energy(double radius, const sphereState& s)
{
    return translationalEnergy(s.V) + sphereRotationalEnergy(radius, s.omega);
}


//- The message with which something is refused
template<class Action>
std::string refusal(Action action)
{
    try
    {
        action();
    }
    catch (const std::invalid_argument& error)
    {
        return error.what();
    }
    return "none";
}


bool finite(const sphereState& s)
{
    return std::isfinite(mag(s.V)) && std::isfinite(mag(s.omega));
}

} // End anonymous namespace


TEST(hardSphereWall, keepsItsLawsForAnyNormal)
{
    int sliding = 0, sticking = 0;
    for (int i = 0; i < 20000; ++i)
    {
        counterRandom rnd(11, i);
        const double e = rnd.uniform();
        const double f = rnd.uniform();
        const double r = std::pow(10, -7 + 5*rnd.uniform());
        const vector3 n = randomUnit(rnd);
        const auto law = constantWall(e, f);
        sphereState s;
        do
        {
            s.V = (300*rnd.uniform())*randomUnit(rnd);
        }
        while (dot(s.V, n) >= 0);
        s.omega = (300*rnd.uniform()/r)*randomUnit(rnd);
        const sphereState before = s;

        const bool slides = law.rebound(n, r, s).slides;
        (slides ? sliding : sticking)++;

        const double scale = mag(before.V) + r*mag(before.omega);
        EXPECT_NEAR(dot(s.V, n), -e*dot(before.V, n), 1e-13*scale);
        EXPECT_NEAR
        (
            r*dot(s.omega, n), r*dot(before.omega, n), 1e-13*scale
        );
        const vector3 dL =
            momentumAboutContact(n, r, s)
          - momentumAboutContact(n, r, before);
        EXPECT_LT(mag(dL), 2e-14*r*scale);
        EXPECT_LE(energy(r, s), (1 + 1e-13)*energy(r, before));

        const vector3 impulse = s.V - before.V;
        const double Jn = dot(impulse, n);
        const vector3 Jt = impulse - Jn*n;
        const vector3 after = contactVelocity(n, r, s);
        const vector3 slipAfter = after - dot(after, n)*n;
        if (slides)
        {
            // On the friction cone, against the slip, which goes on
            EXPECT_NEAR(mag(Jt), f*Jn, 1e-12*scale);
            EXPECT_LE(dot(Jt, slipAfter), 1e-12*scale*scale);
        }
        else
        {
            EXPECT_LT(mag(slipAfter), 1e-13*scale);
            EXPECT_LE(mag(Jt), f*Jn + 1e-12*scale);
        }
    }
    EXPECT_GT(sliding, 1000);
    EXPECT_GT(sticking, 1000);
}


TEST(hardSphereWall, equalsTheFormulaeOfTheSource)
{
    // Page 2.5 in components, y the normal: written down once more
    for (int i = 0; i < 2000; ++i)
    {
        counterRandom rnd(12, i);
        const double e = rnd.uniform(), f = rnd.uniform(), r = 25e-6;
        const double vx = 200*rnd.normal(), vz = 200*rnd.normal();
        const double vy = -100*rnd.uniform();
        const double wx = 1e6*rnd.normal(), wy = 1e6*rnd.normal();
        const double wz = 1e6*rnd.normal();

        sphereState s = {{vx, vy, vz}, {wx, wy, wz}};
        constantWall(e, f).rebound({0, 1, 0}, r, s);

        const double sx = vx + r*wz, sz = vz - r*wx;
        const double slip = std::hypot(sx, sz);
        sphereState expected;
        if (-vy/slip < 2/(7*f*(1 + e)))
        {
            const double ex = sx/slip, ez = sz/slip;
            const double push = f*(1 + e)*vy;
            expected.V = {vx + ex*push, -e*vy, vz + ez*push};
            expected.omega =
                {wx - 2.5/r*ez*push, wy, wz + 2.5/r*ex*push};
        }
        else
        {
            const double ux = 5./7*(vx - 2*r/5*wz);
            const double uz = 5./7*(vz + 2*r/5*wx);
            expected.V = {ux, -e*vy, uz};
            expected.omega = {uz/r, wy, -ux/r};
        }
        EXPECT_LT(mag(s.V - expected.V), 1e-12*400);
        EXPECT_LT(r*mag(s.omega - expected.omega), 1e-12*400);
    }
}


TEST(hardSphereWall, changesRegimeWhereTheConeEnds)
{
    // Sliding below tan(angle) = 2/(7 f (1 + e)), sticking above
    const double e = 0.7, f = 0.2;
    const double limit = 2/(7*f*(1 + e));
    const auto law = constantWall(e, f);
    sphereState low = {{1, -limit*(1 - 1e-9), 0}, {0, 0, 0}};
    sphereState high = {{1, -limit*(1 + 1e-9), 0}, {0, 0, 0}};
    EXPECT_TRUE(law.rebound({0, 1, 0}, 1e-5, low).slides);
    EXPECT_FALSE(law.rebound({0, 1, 0}, 1e-5, high).slides);
    EXPECT_NEAR(low.V.x, 5./7, 1e-8);
    EXPECT_NEAR(high.V.x, 5./7, 1e-8);
}


TEST(hardSphereWall, restitutionOfMcNamaraAndFalcon)
{
    const auto law = wallOfSpeed(0.7, 0.3, 0.2);
    auto restitution = [&](double v, double along)
    {
        sphereState s = {{along, -v, 0}, {0, 0, 0}};
        law.rebound({0, 1, 0}, 1e-5, s);
        return s.V.y/v;
    };
    for (const double along : {0., 0.01, 100.})
    {
        EXPECT_NEAR(restitution(0.3, along), 0.7, 1e-13);
        EXPECT_NEAR(restitution(0.3/32, along), 1 - 0.3/2, 1e-13);
        EXPECT_NEAR(restitution(0.3*16, along), 0.35, 1e-13);
        EXPECT_NEAR(restitution(0.3*(1 + 1e-9), along), 0.7, 1e-8);
    }
}


TEST(hardSphereWall, takesItsCoefficientsAtTheContact)
{
    // Written down once more: tables over the angle and the speed of the
    // contact, which is not that of the centre where the sphere spins
    typedef reboundCoefficient form;
    const std::vector<double> angles = {0, 30, 90}, speeds = {10, 100};
    const hardSphereWall law
    (
        form::table
        (
            form::restitutionQuantity(), angles, speeds,
            {1, 0.9, 0.8, 0.6, 0.5, 0.2}
        ),
        form::polynomial
        (
            form::frictionQuantity(), {{0.4}, {-0.2}}, 10, 80, 0, 0
        )
    );
    auto line = [](double x, double x0, double y0, double x1, double y1)
    {
        return y0 + (y1 - y0)*(x - x0)/(x1 - x0);
    };
    int spun = 0, outside = 0;
    for (int i = 0; i < 5000; ++i)
    {
        counterRandom rnd(13, i);
        const double r = 2e-5;
        const vector3 n = randomUnit(rnd);
        sphereState s;
        do
        {
            s.V = (110*rnd.uniform())*randomUnit(rnd);
        }
        while (dot(s.V, n) >= 0);
        s.omega = (i % 2*60*rnd.uniform()/r)*randomUnit(rnd);
        const sphereState before = s;

        const vector3 Vc = contactVelocity(n, r, before);
        const double speed = mag(Vc);
        const double angle = std::asin(-dot(Vc, n)/speed)*180/M_PI;
        const bool steep = angle > 30;
        const double v = std::min(std::max(speed, 10.), 100.);
        auto at = [&](double slow, double fast)
        {
            return line(v, 10, slow, 100, fast);
        };
        const double e = steep
          ? line(angle, 30, at(0.8, 0.6), 90, at(0.5, 0.2))
          : line(angle, 0, at(1, 0.9), 30, at(0.8, 0.6));
        const double held = std::min(std::max(angle, 10.), 80.);
        const double f = 0.4 - 0.2*held*M_PI/180;

        sphereState wanted = before;
        constantWall(e, f).rebound(n, r, wanted);
        const auto out = law.rebound(n, r, s);
        const double scale = mag(before.V) + r*mag(before.omega);
        EXPECT_LT(mag(s.V - wanted.V), 1e-12*scale);
        EXPECT_LT(r*mag(s.omega - wanted.omega), 1e-12*scale);
        EXPECT_EQ
        (
            out.outside,
            speed < 10 || speed > 100 || angle < 10 || angle > 80
        );
        outside += out.outside;
        spun += std::fabs(mag(before.V)/speed - 1) > 0.1;
    }
    EXPECT_GT(outside, 500);
    EXPECT_LT(outside, 4500);
    EXPECT_GT(spun, 500);
}


TEST(hardSphereWall, survivesExtremes)
{
    const vector3 n = {0, 0, 1};
    for (const double e : {0., 0.7, 1.})
    {
        for (const double f : {0., 0.2, 1e6})
        {
            const auto law = constantWall(e, f);

            // No slip at all: the sphere rolls in
            const double r = 0x1p-17;
            sphereState rolling = {{64, 0, -8}, {0, 64/r, 0}};
            law.rebound(n, r, rolling);
            EXPECT_EQ(rolling.V.x, 64);
            EXPECT_EQ(rolling.V.z, 8*e);
            EXPECT_EQ(rolling.omega.y, 64/r);

            // Straight down without spin
            sphereState down = {{0, 0, -8}, {0, 0, 0}};
            law.rebound(n, r, down);
            EXPECT_EQ(down.V.x, 0);
            EXPECT_EQ(down.V.y, 0);
            EXPECT_EQ(down.V.z, 8*e);
            EXPECT_EQ(mag(down.omega), 0);

            // Grazing, fast spin, slip too small to square
            sphereState graze = {{300, 0, -300e-9}, {0, 0, 0}};
            law.rebound(n, 5e-6, graze);
            EXPECT_TRUE(finite(graze));
            EXPECT_NEAR(graze.V.z, 300e-9*e, 1e-20);
            sphereState spinning = {{1, 0, -1}, {1e9, -1e9, 1e9}};
            const double before = energy(5e-6, spinning);
            law.rebound(n, 5e-6, spinning);
            EXPECT_TRUE(finite(spinning));
            EXPECT_EQ(spinning.omega.z, 1e9);
            EXPECT_LE(energy(5e-6, spinning), before*(1 + 1e-13));
            sphereState tiny = {{1e-200, 0, -1}, {0, 1e-200, 0}};
            law.rebound(n, 5e-6, tiny);
            EXPECT_TRUE(finite(tiny));
        }
    }
    const auto fast = wallOfSpeed(0, 1e-9, 0.2);
    sphereState s = {{1, 0, -1e-300}, {0, 0, 0}};
    fast.rebound(n, 1e-6, s);
    EXPECT_TRUE(finite(s));
}


TEST(hardSphereWall, refusesBadValues)
{
    auto text = refusal([] { constantWall(1.1, 0.2); });
    EXPECT_NE(text.find("restitution 1.1"), std::string::npos) << text;
    EXPECT_NE(text.find("[0, 1]"), std::string::npos) << text;
    text = refusal([] { constantWall(0.5, -0.1); });
    EXPECT_NE(text.find("friction -0.1"), std::string::npos) << text;
    text = refusal([] { wallOfSpeed(0.5, 0, 0.1); });
    EXPECT_NE(text.find("restitutionSpeed 0"), std::string::npos) << text;
    EXPECT_THROW(constantWall(-1e-9, 0.2), std::invalid_argument);
}
