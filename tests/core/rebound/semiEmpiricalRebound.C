/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The semi-empirical rebound against the formulae of its source, the angular
    momentum about the contact where the law keeps it, and the hard sphere
    that sticks.
\*---------------------------------------------------------------------------*/

#include "semiEmpiricalRebound.H"
#include "counterRandom.H"
#include "hardSphereWall.H"

#include <gtest/gtest.h>
#include <cmath>

using namespace impact;

namespace
{

typedef semiEmpiricalRebound law;

law make(double eN, double eT, double betaC)
{
    return law
    (
        reboundCoefficient::constant(law::normalQuantity(), eN),
        reboundCoefficient::constant(law::tangentialQuantity(), eT),
        reboundCoefficient::constant(law::criticalAngleQuantity(), betaC)
    );
}


vector3 randomUnit(counterRandom& rnd)
{
    const vector3 v = {rnd.normal(), rnd.normal(), rnd.normal()};
    return (1/mag(v))*v;
}


vector3 momentumAboutContact
(
    const vector3& n,
    double radius,
    const sphereState& s
)
{
    return radius*cross(n, s.V) + sphereInertia(radius)*s.omega;
}


struct randomFall
{
    vector3 n;
    double r;
    sphereState s;

    explicit randomFall(int i)
    {
        counterRandom rnd(21, i);
        n = randomUnit(rnd);
        r = std::pow(10, -6 + 3*rnd.uniform());
        do
        {
            s.V = (300*rnd.uniform())*randomUnit(rnd);
        }
        while (dot(s.V, n) >= 0);
        s.omega = (300*rnd.uniform()/r)*randomUnit(rnd);
    }

    double scale() const
    {
        return mag(s.V) + r*mag(s.omega);
    }
};

} // End anonymous namespace


TEST(semiEmpiricalRebound, keepsAngularMomentumInTheFirstBranch)
{
    for (int i = 0; i < 10000; ++i)
    {
        randomFall f(i);
        counterRandom rnd(22, i);
        const double eN = rnd.uniform(), eT = rnd.uniform();
        const sphereState before = f.s;
        const double scale = f.scale();
        const auto out = make(eN, eT, 90).rebound(f.n, f.r, f.s);
        EXPECT_FALSE(out.rolls);
        EXPECT_FALSE(out.outside);
        EXPECT_NEAR(dot(f.s.V, f.n), -eN*dot(before.V, f.n), 1e-13*scale);
        EXPECT_LT
        (
            mag
            (
                momentumAboutContact(f.n, f.r, f.s)
              - momentumAboutContact(f.n, f.r, before)
            ),
            2e-14*f.r*scale
        );
    }
}


TEST(semiEmpiricalRebound, rollsAfterTheSecondBranch)
{
    for (int i = 0; i < 10000; ++i)
    {
        randomFall f(i);
        counterRandom rnd(23, i);
        const double eN = rnd.uniform(), eT = rnd.uniform();
        const sphereState before = f.s;
        const double scale = f.scale();
        const vector3 Vt = before.V - dot(before.V, f.n)*f.n;
        const vector3 x = (1/mag(Vt))*Vt;
        const auto out = make(eN, eT, 0).rebound(f.n, f.r, f.s);
        EXPECT_TRUE(out.rolls);

        // No slip along x; spin about x and about the normal stays
        EXPECT_NEAR
        (
            dot(contactVelocity(f.n, f.r, f.s), x), 0, 1e-13*scale
        );
        const vector3 dOmega = f.s.omega - before.omega;
        EXPECT_NEAR(f.r*dot(dOmega, x), 0, 1e-13*scale);
        EXPECT_NEAR(f.r*dot(dOmega, f.n), 0, 1e-13*scale);
        EXPECT_NEAR(dot(f.s.V, cross(x, f.n)), 0, 1e-13*scale);
    }
}


TEST(semiEmpiricalRebound, equalsTheStickingHardSphere)
{
    // In the plane, e_T = 5/7: both branches, and the hard sphere with
    // friction without bound
    for (int i = 0; i < 2000; ++i)
    {
        randomFall f(i);
        counterRandom rnd(24, i);
        const double e = rnd.uniform();
        const vector3 Vt = f.s.V - dot(f.s.V, f.n)*f.n;
        const vector3 z = (1/mag(Vt))*cross(Vt, f.n);
        f.s.omega = (rnd.normal()*100/f.r)*z;
        const double scale = f.scale();
        sphereState first = f.s, second = f.s, hard = f.s;
        make(e, 5./7, 90).rebound(f.n, f.r, first);
        make(e, 5./7, 0).rebound(f.n, f.r, second);
        hardSphereWall::strike(f.n, f.r, e, 1e6, hard);
        EXPECT_LT(mag(first.V - hard.V), 1e-12*scale);
        EXPECT_LT(mag(second.V - hard.V), 1e-12*scale);
        EXPECT_LT(f.r*mag(first.omega - hard.omega), 1e-12*scale);
        EXPECT_LT(f.r*mag(second.omega - hard.omega), 1e-12*scale);
    }
}


TEST(semiEmpiricalRebound, equalsTheFormulaeOfTheSource)
{
    const double r = 25e-6, eN = 0.6, eT = 0.8;
    for (int i = 0; i < 1000; ++i)
    {
        counterRandom rnd(25, i);
        const double vx = 200*rnd.uniform(), vy = -200*rnd.uniform();
        const double w = 1e7*rnd.normal();
        const double beta = std::atan2(-vy, vx)*180/std::acos(-1.);
        for (const double betaC : {20., 60.})
        {
            sphereState s = {{vx, vy, 0}, {3, 5, w}};
            const auto out = make(eN, eT, betaC).rebound({0, 1, 0}, r, s);
            const bool first = beta < betaC;
            EXPECT_EQ(out.rolls, !first);
            const double ux = first
              ? eT*vx + (eT - 1)*r*w : eT*vx - 2./7*r*w;
            const double spin = first
              ? 2.5/r*(eT - 1)*vx + 2.5*(eT - 0.6)*w : -eT*vx/r + 2./7*w;
            EXPECT_NEAR(s.V.x, ux, 1e-11);
            EXPECT_NEAR(s.V.y, -eN*vy, 1e-12);
            EXPECT_NEAR(s.V.z, 0, 1e-12);
            EXPECT_NEAR(r*s.omega.z, r*spin, 1e-11);
            EXPECT_EQ(s.omega.x, 3);
            EXPECT_EQ(s.omega.y, 5);
        }
    }
}


TEST(semiEmpiricalRebound, survivesExtremes)
{
    const vector3 n = {0, 0, 1};
    for (const double eN : {0., 1.})
    {
        for (const double betaC : {0., 90.})
        {
            const law l = make(eN, 0.7, betaC);
            sphereState down = {{0, 0, -3}, {0, 0, 7}};
            l.rebound(n, 1e-6, down);
            EXPECT_EQ(down.V.x, 0);
            EXPECT_EQ(down.V.y, 0);
            EXPECT_EQ(down.V.z, 3*eN);
            EXPECT_EQ(down.omega.z, 7);

            // A vertical fall with spin moves off along the slip
            sphereState spun = {{0, 0, -3}, {0, 1e9, 0}};
            l.rebound(n, 1e-6, spun);
            EXPECT_TRUE(std::isfinite(mag(spun.omega)));
            EXPECT_NE(spun.V.x, 0);
            EXPECT_EQ(spun.V.y, 0);

            sphereState graze = {{100, 0, -1e-7}, {0, 0, 0}};
            l.rebound(n, 1e-6, graze);
            EXPECT_NEAR(graze.V.z, 1e-7*eN, 1e-20);
            EXPECT_TRUE(std::isfinite(mag(graze.omega)));
        }
    }
}


TEST(semiEmpiricalRebound, fallsVerticallyOnWallsOfAnyNormal)
{
    // What is left of V along the wall is round-off, far less than the slip
    counterRandom rnd(5, 0, 0);
    const double r = 1e-5, V = 0.1;
    const vector3 spin = {3e5, -2e5, 5e5};
    for (int i = 0; i < 2000; ++i)
    {
        const vector3 n = randomUnit(rnd);
        sphereState s = {-V*n, spin};
        make(0.7, 0.6, 45).rebound(n, r, s);
        EXPECT_NEAR(dot(s.V, n), 0.7*V, 1e-12*mag(spin)*r);

        // Two sevenths of the slip, against it
        const vector3 along = s.V - dot(s.V, n)*n;
        const vector3 slip = r*cross(n, spin);
        EXPECT_LT(mag(along + (2./7)*slip), 1e-12*mag(spin)*r);
    }
}


TEST(semiEmpiricalRebound, reportsGainsAndRanges)
{
    // Rolling without loss of speed stores energy in the spin
    sphereState s = {{10, -1, 0}, {0, 0, 0}};
    EXPECT_TRUE(make(1, 1, 0).rebound({0, 1, 0}, 1e-5, s).gains);
    s = {{10, -1, 0}, {0, 0, 0}};
    EXPECT_FALSE(make(1, 5./7, 0).rebound({0, 1, 0}, 1e-5, s).gains);

    const law measured
    (
        reboundCoefficient::table
        (
            law::normalQuantity(), {10, 90}, {0}, {0.9, 0.4}
        ),
        reboundCoefficient::constant(law::tangentialQuantity(), 0.7),
        reboundCoefficient::constant(law::criticalAngleQuantity(), 30)
    );
    s = {{10, -1, 0}, {0, 0, 0}};
    EXPECT_TRUE(measured.rebound({0, 1, 0}, 1e-5, s).outside);
    EXPECT_NEAR(s.V.y, 0.9, 1e-14);
    s = {{10, -10, 0}, {0, 0, 0}};
    EXPECT_FALSE(measured.rebound({0, 1, 0}, 1e-5, s).outside);
}
