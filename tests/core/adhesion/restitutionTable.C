/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Tests of restitutionTable and restitutionCurve.
\*---------------------------------------------------------------------------*/

#include "counterRandom.H"
#include "jkrMotion.H"
#include "restitutionTable.H"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace impact;

namespace
{

const unloadingType kinds[] = {unloadingType::soft, unloadingType::hard};


double exact(double alpha, double q, unloadingType unloading)
{
    double p = q*jkrMotion::separationSpeed();
    const double ratio = std::fmax(1., std::pow(p, 0.2));
    p /= std::pow(ratio, 5);
    return jkrMotion(alpha, unloading, 1e-13).impact
    (
        jkrCurve(2./3/std::pow(ratio, 3)), p
    ).exitSpeed/p;
}


//- Speeds from next to capture to 1e4 v_st, and beyond
double speed(double captureRatio, double random, int i)
{
    const double excess =
        i % 3 == 0 ? std::pow(10, 10*random - 12)
      : i % 3 == 1 ? 3*random
      : std::pow(10, 8*random);
    return captureRatio*(1 + excess);
}

} // End anonymous namespace


TEST(restitutionTable, isAccurateFromCaptureToAnySpeed)
{
    for (unloadingType unloading : kinds)
    {
        const restitutionTable table(unloading);
        for (int i = 0; i < 3000; ++i)
        {
            counterRandom random(1, i, 0);
            const double alpha =
                restitutionTable::maxAlpha*random.uniform();
            const double g =
                jkrMotion(alpha, unloading, 1e-14).captureRatio();
            EXPECT_NEAR(table.captureRatio(alpha)/g, 1, 1e-8);
            const double q = speed(g, random.uniform(), i);
            EXPECT_NEAR
            (
                table.rebound(alpha, q).restitution,
                exact(alpha, q, unloading),
                1e-6
            ) << alpha << ' ' << q/g;
        }
    }
}


TEST(restitutionTable, curveIsAccurateFromCaptureToAnySpeed)
{
    for (unloadingType unloading : kinds)
    {
        for (double alpha : {0., 0.01, 0.225, 0.6, 1.1891, 1.6, 2., 2.2})
        {
            const restitutionCurve curve(alpha, unloading);
            for (int i = 0; i < 200; ++i)
            {
                counterRandom random(2, i, 0);
                const double q =
                    speed(curve.captureRatio(), random.uniform(), i);
                EXPECT_NEAR
                (
                    curve.rebound(q).restitution,
                    exact(alpha, q, unloading),
                    2e-7
                ) << alpha << ' ' << q/curve.captureRatio();
            }
        }
    }
}


TEST(restitutionTable, hasItsLimits)
{
    const restitutionTable& table = restitutionTable::of(unloadingType::soft);
    for (double alpha : {0., 0.3, 1., 1.6, 1.875})
    {
        const restitutionCurve curve(alpha);
        const double g = curve.captureRatio();
        EXPECT_TRUE(curve.rebound(g).captured);
        EXPECT_TRUE(curve.rebound(1e-9*g).captured);
        EXPECT_TRUE(table.rebound(alpha, 0.9999*g).captured);
        EXPECT_FALSE(table.rebound(alpha, 1.0001*g).captured);
        EXPECT_EQ(table.rebound(alpha, 1e-9).restitution, 0);

        const double limit = jkrMotion::hertzRestitution(alpha);
        EXPECT_NEAR(curve.rebound(1e300).restitution, limit, 2e-7);
        EXPECT_NEAR(table.rebound(alpha, 1e300).restitution, limit, 1e-6);

        // Faster is livelier
        double last = 0;
        for (double f = 1.001; f < 1e6; f *= 1.1)
        {
            const double e = curve.rebound(f*g).restitution;
            EXPECT_GT(e, last - 2e-7);
            EXPECT_LE(e, 1);
            EXPECT_LE(table.rebound(alpha, f*g).restitution, 1);
            last = e;
        }
    }
    const restitutionCurve sticky(2.5);
    EXPECT_TRUE(sticky.rebound(1e300).captured);
    EXPECT_TRUE(std::isinf(sticky.captureRatio()));
}


TEST(restitutionTable, refusesWhatIsOutOfRange)
{
    const restitutionTable& table = restitutionTable::of(unloadingType::soft);
    EXPECT_THROW(table.rebound(-1e-9, 2), std::invalid_argument);
    EXPECT_THROW(table.rebound(1.876, 2), std::invalid_argument);
    EXPECT_THROW(table.captureRatio(2), std::invalid_argument);
    EXPECT_THROW(restitutionCurve(-1), std::invalid_argument);
}
