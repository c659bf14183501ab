/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Torque on a spinning sphere: slow flow, fit, jump, and the decay of the
    spin against an integration of the equation of motion.
\*---------------------------------------------------------------------------*/

#include "rotationalTorque.H"

#include <gtest/gtest.h>
#include <cmath>

using impact::rotationalTorque;

namespace
{

//- Torque as printed [N m]
double torque(double r, double rho, double mu, double W)
{
    const double Re = 4*r*r*rho*W/mu;
    const double cl =
        Re <= 32 ? 64*M_PI/Re : 12.9/std::sqrt(Re) + 128.4/Re;
    return 0.5*std::pow(r, 5)*cl*rho*W*W;
}

} // End anonymous namespace


TEST(rotationalTorque, isThatOfSlowFlow)
{
    const double r = 3e-6, rho = 0.4, mu = 1.5e-5, rhoP = 2500;
    const double I = 0.4*rhoP*4./3*M_PI*std::pow(r, 5);
    for (const double W : {1e-9, 1., 1e6})
    {
        const double rate =
            rotationalTorque::scale(2*r, rhoP, mu)
           *rotationalTorque::clRe(4*r*r*rho*W/mu);
        EXPECT_NEAR(rate*I/(8*M_PI*mu*r*r*r), 1, 1e-14);
        EXPECT_NEAR(rate*I*W/torque(r, rho, mu, W), 1, 1e-14);
    }
    EXPECT_EQ(rotationalTorque::clRe(0), 64*M_PI);
}


TEST(rotationalTorque, followsTheFitAndItsJump)
{
    const double r = 25e-6, rho = 1.2, mu = 1.8e-5, rhoP = 2500;
    const double I = 0.4*rhoP*4./3*M_PI*std::pow(r, 5);
    for (const double W : {1e6, 1e7, 1e9})
    {
        const double Re = 4*r*r*rho*W/mu;
        ASSERT_GT(Re, 32);
        const double T =
            rotationalTorque::scale(2*r, rhoP, mu)
           *rotationalTorque::clRe(Re)*I*W;
        EXPECT_NEAR(T/torque(r, rho, mu, W), 1, 1e-14);
    }
    const double below = rotationalTorque::clRe(32);
    const double above = rotationalTorque::clRe(32*(1 + 1e-15));
    EXPECT_NEAR(above/below - 1, 0.00155, 0.00001);
}


TEST(rotationalTorque, decaysAsTheEquationOfMotion)
{
    // Classical Runge-Kutta in ln Re, stepping exactly onto the jump
    const auto slope =
        [](double lnRe) { return -rotationalTorque::clRe(std::exp(lnRe)); };
    for (const double Re0 : {1e-3, 31., 40., 1000., 1e8})
    {
        double t = 0;
        double ln = std::log(Re0);
        const double end = 3./200;
        const int n = 20000;
        for (int i = 0; i < n; ++i)
        {
            const double h = end/n;
            const double k1 = slope(ln);
            const double k2 = slope(ln + 0.5*h*k1);
            const double k3 = slope(ln + 0.5*h*k2);
            const double k4 = slope(ln + h*k3);
            ln += h/6*(k1 + 2*k2 + 2*k3 + k4);
            t += h;
            if (i % 1000 == 999)
            {
                EXPECT_NEAR
                (
                    std::log(rotationalTorque::remaining(Re0, t)*Re0),
                    ln,
                    1e-6
                ) << Re0 << ' ' << t;
            }
        }
    }
}


TEST(rotationalTorque, decaysByPiecesAsAtOnce)
{
    double share = 1;
    double Re = 5000;
    for (int i = 0; i < 100; ++i)
    {
        const double s = rotationalTorque::remaining(Re, 2e-4);
        share *= s;
        Re *= s;
    }
    EXPECT_NEAR(share/rotationalTorque::remaining(5000, 0.02), 1, 1e-12);
}


TEST(rotationalTorque, survivesExtremes)
{
    EXPECT_EQ(rotationalTorque::remaining(0, 0), 1);
    EXPECT_EQ(rotationalTorque::remaining(1e12, 0), 1);
    EXPECT_EQ(rotationalTorque::remaining(1e12, 1e9), 0);
    EXPECT_EQ(rotationalTorque::remaining(0, 1e9), 0);
    EXPECT_GT(rotationalTorque::remaining(1e12, 1e-12), 0);
}
