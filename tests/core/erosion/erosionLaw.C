/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Erosion laws of Finnie and Oka: exact values, continuity, limits, the
    published constants for sand on steel, refusals.
\*---------------------------------------------------------------------------*/

#include "erosionLaw.H"

#include <gtest/gtest.h>
#include <cmath>
#include <stdexcept>

using impact::erosionLaw;

namespace
{
const double degree = M_PI/180;
}


TEST(erosionLaw, finnie)
{
    const double m = 2e-9, v = 120, p = 1e9;
    const erosionLaw law = erosionLaw::finnie(p);
    const double unit = m*v*v/(p*2*2);

    // K = 2: the branches meet at tan a = 1/3, sin 2a = 0.6, sin^2 a = 0.1
    const double joint = std::atan(1.0/3);
    EXPECT_NEAR(law.volume(m, 1e-4, v, joint)/unit, 0.3, 1e-14);
    EXPECT_NEAR(law.volume(m, 1e-4, v, joint*(1 - 1e-9))/unit, 0.3, 1e-8);
    EXPECT_NEAR(law.volume(m, 1e-4, v, joint*(1 + 1e-9))/unit, 0.3, 1e-8);
    EXPECT_NEAR(law.volume(m, 1e-4, v, 45*degree)/unit, 1.0/6, 1e-14);
    EXPECT_EQ(law.volume(m, 1e-4, v, 0), 0);
    EXPECT_LT(law.volume(m, 1e-4, v, 90*degree)/unit, 1e-30);

    // Greatest where tan 2a = K/3
    const double best = 0.5*std::atan(2.0/3);
    const double top = law.volume(m, 1e-4, v, best);
    for (double a = 0.5; a < 90; a += 0.5)
    {
        EXPECT_LE(law.volume(m, 1e-4, v, a*degree), top);
        EXPECT_GT(law.volume(m, 1e-4, v, a*degree), 0);
    }
    EXPECT_NEAR
    (
        erosionLaw::finnie(2*p).volume(m, 1e-4, 2*v, best)/top, 2, 1e-14
    );
}


TEST(erosionLaw, oka)
{
    const erosionLaw::okaConstants steel(1.8);
    // What table 12.3 of the Fluent theory guide gives for sand on steel
    EXPECT_NEAR(steel.n1, 0.8, 0.05);
    EXPECT_NEAR(steel.n2, 1.3, 0.1);
    EXPECT_NEAR(steel.k2, 2.35, 0.005);
    EXPECT_EQ(steel.k3, 0.19);

    const erosionLaw law = erosionLaw::oka(steel);
    const double E90 = 65e-9*std::pow(1.8, -0.12);
    EXPECT_NEAR(law.volume(3, 326e-6, 104, 90*degree)/(3*E90), 1, 1e-14);
    EXPECT_NEAR
    (
        law.volume(3, 326e-6, 208, 90*degree)/(3*E90),
        std::pow(2, steel.k2), 1e-12
    );
    EXPECT_NEAR
    (
        law.volume(3, 163e-6, 104, 90*degree)/(3*E90), std::pow(2, -0.19), 1e-12
    );
    // sin 30 = 1/2
    EXPECT_NEAR
    (
        law.volume(3, 326e-6, 104, 30*degree)/(3*E90),
        std::pow(0.5, steel.n1)*std::pow(1.9, steel.n2), 1e-12
    );
    EXPECT_EQ(law.volume(3, 326e-6, 104, 0), 0);
    EXPECT_EQ(law.volume(3, 326e-6, 0, 1), 0);

    // A metal wears most at an oblique angle
    double best = 0, angle = 0;
    for (double a = 1; a <= 90; a += 1)
    {
        const double q = law.volume(3, 326e-6, 104, a*degree);
        if (q > best)
        {
            best = q;
            angle = a;
        }
    }
    EXPECT_GT(angle, 20);
    EXPECT_LT(angle, 60);
}


TEST(erosionLaw, refusesBadInput)
{
    EXPECT_THROW(erosionLaw::finnie(0), std::invalid_argument);
    EXPECT_THROW(erosionLaw::finnie(1e9, -1), std::invalid_argument);
    EXPECT_THROW(erosionLaw::finnie(1e9, 2, 0), std::invalid_argument);
    EXPECT_THROW(erosionLaw::okaConstants(0), std::invalid_argument);
    erosionLaw::okaConstants bad(1.8);
    bad.K = 0;
    EXPECT_THROW(erosionLaw::oka(bad), std::invalid_argument);
    bad = erosionLaw::okaConstants(1.8);
    bad.n2 = -1;
    EXPECT_THROW(erosionLaw::oka(bad), std::invalid_argument);
}
