/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Speed, angle and energy of an impact from its velocities.
\*---------------------------------------------------------------------------*/

#include "impactMeasures.H"

#include <gtest/gtest.h>
#include <cmath>

using impact::impactMeasures;
using impact::vector3;

TEST(impactMeasures, areThoseOfTheVelocities)
{
    const vector3 n{0, 1, 0};
    const vector3 v0{3, -4, 0};
    const impactMeasures m(v0, n);
    EXPECT_EQ(m.speed, 5);
    EXPECT_EQ(m.normalSpeed, 4);
    EXPECT_NEAR(std::tan(m.angle), 4.0/3, 1e-15);
    EXPECT_NEAR(impactMeasures({0, -2, 0}, n).angle, M_PI/2, 1e-15);
    EXPECT_LT(impactMeasures({0, 2, 0}, n).normalSpeed, 0);
    EXPECT_EQ(impactMeasures({0, 0, 0}, n).angle, 0);

    EXPECT_EQ(impactMeasures::translationalLoss(2, v0, {0, 0, 0}), 25);
    // A loss of 1e-12 of the energy, which a difference of squares loses
    const vector3 v1{3, 4*(1 - 1e-12), 0};
    EXPECT_NEAR
    (
        impactMeasures::translationalLoss(2, v0, v1)/32e-12, 1, 1e-3
    );
}
