/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    What the gas of a cell changes by: exact for one kind of particles with
    linear drag and heat, the common state for long steps, bounds for any
    mixture.
\*---------------------------------------------------------------------------*/

#include "jointExchange.H"

#include <gtest/gtest.h>
#include <random>

using namespace impact;

TEST(jointExchange, isExactForOneKindOfParticles)
{
    for (const double eta : {0.01, 1., 10., 1000.})
    {
        for (const double z : {1e-3, 0.1, 1., 5.})
        {
            const double beta = -std::expm1(-z);
            const vector3 a{2, -1, 0.5};
            jointExchange e;
            e.addMotion(0.4*eta, beta, a);
            e.addMotion(0.6*eta, beta, a);
            const auto gas = e(1, 0);

            // Of the particles in the gas that has changed, and exactly
            const vector3 moved = beta*(gas.u - a);
            const double share = -std::expm1(-z*(1 + eta))/(1 + eta);
            EXPECT_NEAR(moved.x, -share*a.x, 1e-7*share*2) << eta << ' ' << z;
            EXPECT_NEAR(moved.y, -share*a.y, 1e-7*share*2);
            EXPECT_NEAR(moved.z, -share*a.z, 1e-7*share*2);
            EXPECT_EQ(gas.T, 0);
        }
    }
}


TEST(jointExchange, endsInTheCommonState)
{
    std::mt19937 draw(5);
    std::uniform_real_distribution<> any(-1, 1);
    for (int trial = 0; trial < 100; ++trial)
    {
        jointExchange e;
        const double M = 2, C = 1400, cp = 800;
        double mass = 0, heat = 0, energy = 0;
        vector3 impulse{0, 0, 0};
        for (int i = 0; i < 20; ++i)
        {
            const double W = 1 + any(draw);
            const vector3 a{100*any(draw), 100*any(draw), 0};
            const double b = 300*any(draw);
            e.addMotion(W, 1, a);
            e.addHeat(W*cp, 1, b);
            mass += W;
            impulse = impulse + W*a;
            energy += 0.5*W*dot(a, a) + W*cp*b;
            heat += W*cp;
        }
        const vector3 u = (1/(M + mass))*impulse;
        const double T =
            (energy - 0.5*(M + mass)*dot(u, u))/(C + heat);
        const auto gas = e(M, C);
        EXPECT_NEAR(mag(gas.u - u), 0, 1e-12*mag(u));
        EXPECT_NEAR(gas.T/T, 1, 1e-10);
    }
}


TEST(jointExchange, neverChangesMoreThanThereIs)
{
    std::mt19937 draw(7);
    std::uniform_real_distribution<> any(0, 1);
    for (int trial = 0; trial < 10000; ++trial)
    {
        jointExchange e;
        for (int i = 0; i < 3; ++i)
        {
            const double W = std::pow(10, 10*any(draw) - 5);
            const double z = std::pow(10, 10*any(draw) - 5);
            e.addMotion(W, -std::expm1(-z), {1, 0, 0});
            e.addHeat(W, -std::expm1(-z), 1);
        }
        const auto gas = e(1, 1e9);
        EXPECT_GE(gas.u.x, 0);
        EXPECT_LE(gas.u.x, 1);
        EXPECT_GE(gas.T, 0);
        EXPECT_LE(gas.T, 1);
    }
    EXPECT_EQ(jointExchange()(1, 1).u.x, 0);
}
