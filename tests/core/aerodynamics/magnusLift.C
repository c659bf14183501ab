/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Coefficient of the Magnus force: slow flow, fit, limits.
\*---------------------------------------------------------------------------*/

#include "magnusLift.H"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>

using impact::magnusLift;

TEST(magnusLift, isThatOfSlowFlowForLittleSpin)
{
    for (const double Re : {1e-300, 1e-3, 1., 140., 1e6})
    {
        EXPECT_EQ(magnusLift::coefficient(Re, 0), 1);
        EXPECT_EQ(magnusLift::coefficient(Re, 0.44*Re), 1);
    }
}


TEST(magnusLift, followsTheFit)
{
    // The formula written down a second time, in lift coefficient over slow
    // flow: C_L/(2 s) with C_L = 0.45 + (2 s - 0.45) exp(...) and the s = W d
    // /(2|u - v|) of the experiments, half of ours
    for (const double Re : {10., 40., 140.})
    {
        for (const double ReOmega : {20., 60., 400., 3000.})
        {
            const double s = 0.5*ReOmega/Re;
            if (2*s > 0.45)
            {
                const double CL =
                    0.45
                  + (2*s - 0.45)
                   *std::exp
                    (
                       -0.05684*std::pow(ReOmega, 0.4)*std::pow(Re, 0.3)
                    );
                EXPECT_NEAR
                (
                    magnusLift::coefficient(Re, ReOmega)/(CL/(2*s)),
                    1,
                    1e-14
                );
            }
        }
    }
}


TEST(magnusLift, hasAKinkAndNoJump)
{
    const double Re = 50;
    const double at = 0.45*Re;
    const double step = 1e-6*at;
    EXPECT_NEAR(magnusLift::coefficient(Re, at + step), 1, 1e-6);
    const double slope =
        (magnusLift::coefficient(Re, at + step) - 1)/step;
    const double expected =
       -(1 - std::exp(-0.05684*std::pow(at, 0.4)*std::pow(Re, 0.3)))/at;
    EXPECT_NEAR(slope/expected, 1, 1e-4);
}


TEST(magnusLift, isFiniteInAllLimits)
{
    const double tiny = std::numeric_limits<double>::denorm_min();
    for (const double Re : {0., tiny, 1e-200, 1e-30, 1., 1e30, 1e300})
    {
        for (const double ReOmega : {0., tiny, 1e-200, 1e-30, 1., 1e30, 1e300})
        {
            const double c = magnusLift::coefficient(Re, ReOmega);
            EXPECT_TRUE(c >= 0 && c <= 1) << Re << ' ' << ReOmega;
        }
    }
    // Without relative motion: slow flow, whatever the spin
    EXPECT_EQ(magnusLift::coefficient(0, 1e9), 1);
    EXPECT_NEAR(magnusLift::coefficient(1e-12, 1), 1, 1e-4);
}
