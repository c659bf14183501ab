/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Forces of an accelerated or sheared gas and of a turning frame against what
    they are in flows of which that is known.
\*---------------------------------------------------------------------------*/

#include "secondaryForces.H"

#include <gtest/gtest.h>
#include <cmath>

using namespace impact;

namespace
{

//- Velocity u0 + G r about the origin, spin of half the curl
linearGas flow(const vector3& u0, const double (&G)[3][3])
{
    linearGas f{};
    f.value.u = u0;
    f.value.rho = 1.2;
    f.value.mu = 1.8e-5;
    f.value.T = 300;
    f.value.spin =
        0.5*vector3{G[2][1] - G[1][2], G[0][2] - G[2][0], G[1][0] - G[0][1]};
    for (int i = 0; i < 3; ++i)
    {
        for (int j = 0; j < 3; ++j)
        {
            f.slope[j][i] = G[i][j];
        }
    }
    return f;
}


motionRate none()
{
    motionRate rate;
    rate.a = rate.alpha = rate.turn = vector3{0, 0, 0};
    rate.k = rate.kSpin = 0;
    return rate;
}


void expectNear(const vector3& a, const vector3& b)
{
    EXPECT_LE(mag(a - b), 1e-13*(mag(a) + mag(b)));
}

} // End namespace


TEST(secondaryForces, gasThatTurnsPullsInwards)
{
    // In solid-body rotation Du/Dt is -omega^2 r, wherever the sphere is going
    const double omega = 70;
    const linearGas f =
        flow({0, 0, 0}, {{0, -omega, 0}, {omega, 0, 0}, {0, 0, 0}});
    const vector3 x{0.2, -0.1, 3};
    secondaryForces s;
    s.pressureGradient = true;
    motionRate rate = none();
    s.add(f, f(x), x, {5, 6, 7}, 1e-4, 1e-3, rate);
    expectNear(rate.a, -1.2e-3*omega*omega*vector3{x.x, x.y, 0});
}


TEST(secondaryForces, virtualMassLeavesWhatMovesWithTheGas)
{
    // A sphere of the density of the gas and its velocity keeps to it, with
    // both forces; in gas whose velocity changes in place, too
    linearGas f = flow({30, 5, 0}, {{40, 9, 1}, {2, -7, 4}, {8, 6, 3}});
    f.uDot = {900, -20, 5};
    const vector3 x{0.02, -0.01, 0.03};
    const gasState gas = f(x);
    secondaryForces s;
    s.pressureGradient = true;
    s.virtualMass = 0.5;
    motionRate rate = none();
    s.add(f, gas, x, gas.u, 1e-4, 1/gas.rho, rate);
    expectNear(rate.a, f.acceleration(x));

    // Alone it takes a share of C/(1 + C) with it
    s.pressureGradient = false;
    rate = none();
    s.add(f, gas, x, gas.u, 1e-4, 1/gas.rho, rate);
    expectNear(rate.a, 1./3*f.acceleration(x));

    // And slows all else down
    rate = none();
    rate.k = 12;
    rate.turn = {1, 2, 3};
    s.add(f, gas, x, gas.u, 1e-4, 1/gas.rho, rate);
    EXPECT_NEAR(rate.k, 8, 1e-13);
    expectNear(rate.turn, 1/1.5*vector3{1, 2, 3});
}


TEST(secondaryForces, liftIsSaffmansInSlowFlow)
{
    // F = 1.615 d^2 sqrt(mu rho/|curl u|) w x curl u, for Re << sqrt(Res) and
    // both small: 6.46 is four times 1.615
    const double shear = 500, d = 1e-6, rhoP = 2000;
    const linearGas f =
        flow({0, 0, 0}, {{0, shear, 0}, {0, 0, 0}, {0, 0, 0}});
    secondaryForces s;
    s.shearLift = true;
    for (const double w : {1e-2, -1e-2})
    {
        // A sphere that lags goes to where the gas is faster
        motionRate rate = none();
        s.add(f, f({0, 0, 0}), {0, 0, 0}, {-w, 0, 0}, d, 1/rhoP, rate);
        const double F =
            1.615*d*d*std::sqrt(1.8e-5*1.2/shear)*w*shear;
        const double mass = M_PI/6*d*d*d*rhoP;

        // Mei's f is 1 at Re = 0 but for its 0.3314 sqrt(b) (1 - exp(-Re/10))
        const double Re = 1.2*std::fabs(w)*d/1.8e-5;
        const double b = 0.5*1.2*shear*d*d/1.8e-5/Re;
        const double share = 0.3314*std::sqrt(b);
        const double f1 = (1 - share)*std::exp(-0.1*Re) + share;
        EXPECT_NEAR(rate.a.y*mass/F, f1, 4e-5);
        EXPECT_EQ(rate.a.x, 0);
    }

    // Mei's fit at its two sides of Re = 40, in more digits
    const auto Cl = [](double Re)
    {
        return secondaryForces::liftCoefficient(Re, 8);
    };
    EXPECT_NEAR(Cl(39.5), 0.133787019651397, 1e-14);
    EXPECT_NEAR(Cl(40), 0.114285252856667, 1e-14);
    EXPECT_NEAR(Cl(0.5), 1.08717562389248, 1e-13);
    EXPECT_EQ(secondaryForces::liftCoefficient(0, 8), 0);
    EXPECT_EQ(secondaryForces::liftCoefficient(8, 0), 0);
}


TEST(secondaryForces, freeSpheresFlyStraightSeenFromOutside)
{
    // A place of rest outside is a circle in a frame that turns with Omega
    const vector3 Omega{0.3, -0.2, 2};
    const vector3 centre{1, 2, 3};
    secondaryForces s;
    s.Omega = Omega;
    s.centre = centre;
    const vector3 x{4, -1, 7};
    const vector3 v = -1*cross(Omega, x - centre);
    expectNear(s.frame(x, v, 0.3), cross(Omega, cross(Omega, x - centre)));

    // Where it turns faster and faster and is pushed on top
    s.OmegaDot = {5, 6, -7};
    s.acceleration = {1, 0, 2};
    expectNear
    (
        s.frame(x, v, 0.3),
        cross(Omega, cross(Omega, x - centre))
      - cross(s.OmegaDot, x - centre) - s.acceleration
    );
    EXPECT_TRUE(s.any());

    // Gas that turns with it bears a share of it, as in a centrifuge
    const vector3 all = s.frame(x, v, 0.3);
    s.buoyantFrame = true;
    expectNear(s.frame(x, v, 0.3), 0.7*all);
    const linearGas f = flow({0, 0, 0}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}});
    motionRate rate = none();
    s.add(f, f(x), x, v, 1e-4, 0.3/1.2, rate);
    expectNear(rate.a, 0.7*all);
    expectNear(rate.turn, 1.4*Omega);
    EXPECT_FALSE(secondaryForces().any());
}
