/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Tests of lawCurve.
\*---------------------------------------------------------------------------*/

#include "lawCurve.H"
#include "jkrMotion.H"

#include <gtest/gtest.h>
#include <cmath>

using namespace impact;

TEST(lawCurve, ofAConstantIsTheCurve)
{
    const lawCurve law(dissipationLaw::constant(0.7));
    const restitutionCurve curve(0.7);
    EXPECT_EQ(law.captureRatio(), curve.captureRatio());
    for (double q : {1., 5., 7.5, 8., 30., 1e4})
    {
        EXPECT_EQ(law.rebound(q).captured, curve.rebound(q).captured);
        EXPECT_EQ(law.rebound(q).restitution, curve.rebound(q).restitution);
    }
    EXPECT_TRUE
    (
        lawCurve(dissipationLaw::constant(3)).rebound(1e9).captured
    );
}


TEST(lawCurve, isTheLargestSolution)
{
    // One that rises smoothly, and one that jumps next to capture
    for (const auto& coeffs : {std::vector<double>{0.9, -0.4, -0.35},
        std::vector<double>{1.2, -1, -0.2}, std::vector<double>{0.3, 0.4}})
    {
        const auto law = dissipationLaw(coeffs);
        const lawCurve curve(law);
        int rebounds = 0;
        for (double q = 1.3; q < 1e4; q *= 1.37)
        {
            const normalRebound fast = curve.rebound(q);
            const normalRebound slow = law.rebound(q);
            EXPECT_EQ(fast.captured, slow.captured) << q;

            // The table is good to 1e-6; a nearly double root amplifies it
            EXPECT_NEAR(fast.restitution, slow.restitution, 2e-5) << q;
            rebounds += !fast.captured;
        }
        EXPECT_GT(rebounds, 10);

        // Nothing rebounds below the speed of capture, all does above
        const double c = curve.captureRatio();
        EXPECT_TRUE(curve.rebound(c).captured);
        EXPECT_FALSE(curve.rebound(c*(1 + 1e-9)).captured);
        EXPECT_TRUE(law.rebound(0.999*c).captured);
        EXPECT_FALSE(law.rebound(1.001*c).captured);
    }
}


TEST(lawCurve, endsWhereItsDataEnd)
{
    const auto law = dissipationLaw({0.5, -0.2}, 0, 0.4);
    const lawCurve strict(law);
    const double end = strict.highSpeed();
    EXPECT_NEAR(end, law.speed(0.4), 1e-4*end);
    EXPECT_NEAR(strict.rebound(0.9999*end).restitution, 0.4, 1e-3);
    try
    {
        strict.rebound(1.01*end);
        FAIL();
    }
    catch (const std::invalid_argument& error)
    {
        EXPECT_NE
        (
            std::string(error.what()).find("up to e = 0.4"), std::string::npos
        ) << error.what();
    }

    // Held: continuous there, and the curve of the last alpha beyond
    const lawCurve held(law, unloadingType::soft, true);
    EXPECT_NEAR(held.rebound(end*(1 + 1e-9)).restitution, 0.4, 1e-5);
    EXPECT_EQ
    (
        held.rebound(10*end).restitution,
        restitutionCurve(0.5 - 0.2*0.4).rebound(10*end).restitution
    );
}


TEST(lawCurve, refusesWhatGivesNoCapture)
{
    typedef dissipationLaw law;
    EXPECT_THROW
    (
        lawCurve(law({0.5, -0.2}, 0.1, 0.9)),
        std::invalid_argument
    );
    EXPECT_THROW(lawCurve(law({2, -1})), std::invalid_argument);
}
