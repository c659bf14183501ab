/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Tests of dissipationLaw.
\*---------------------------------------------------------------------------*/

#include "dissipationLaw.H"
#include "jkrMotion.H"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

using namespace impact;


TEST(dissipationLaw, marshallGivesTheRestitutionBack)
{
    // In the effective-mass convention, within the error of the fit
    const dissipationLaw law = dissipationLaw::marshall();
    for (double e = 0.05; e <= 1; e += 0.05)
    {
        EXPECT_NEAR(jkrMotion::hertzRestitution(law.alpha(e)), e, 2.5e-3);
    }

    // Without the factor it does not
    EXPECT_NEAR
    (
        jkrMotion::hertzRestitution(law.alpha(0.5)/std::sqrt(2.)), 0.616, 1e-3
    );
}


TEST(dissipationLaw, calibrationInvertsTheImpact)
{
    for (unloadingType unloading : {unloadingType::soft, unloadingType::hard})
    {
        for (double alpha : {0.01, 0.3, 1.1891, 1.8})
        {
            const double g = jkrMotion(alpha, unloading).captureRatio();
            for (double f : {1.01, 2., 100.})
            {
                const double e =
                    dissipationLaw::restitution(alpha, f*g, unloading);
                EXPECT_NEAR
                (
                    dissipationLaw::calibrated(f*g, e, unloading),
                    alpha,
                    1e-7
                );
            }
        }
    }
}


TEST(dissipationLaw, fitRecoversAPolynomial)
{
    // Impacts made with a known law
    const dissipationLaw known =
        dissipationLaw({0.9, -0.4, -0.35});
    std::vector<dissipationLaw::measurement> data;
    for (double e : {0.05, 0.1, 0.2, 0.25, 0.28, 0.3})
    {
        const double q = known.speed(e);
        ASSERT_TRUE(std::isfinite(q)) << e;
        data.push_back({q, e});
    }
    const dissipationLaw fit = dissipationLaw::fit(data, 2);
    ASSERT_EQ(fit.coeffs().size(), 3u);
    for (int i = 0; i < 3; ++i)
    {
        EXPECT_NEAR(fit.coeffs()[i], known.coeffs()[i], 1e-5);
    }
    EXPECT_EQ(fit.low(), 0.05);
    EXPECT_EQ(fit.high(), 0.3);
    for (const auto& d : data)
    {
        EXPECT_NEAR(fit.speed(d.restitution)/d.q, 1, 1e-5);
    }

    // Valid within its data alone, but where it is told otherwise
    EXPECT_THROW(fit.alpha(0.31), std::invalid_argument);
    EXPECT_THROW(fit.alpha(0), std::invalid_argument);
    EXPECT_THROW(fit.rebound(1), std::invalid_argument);
    EXPECT_THROW(fit.rebound(1e6), std::invalid_argument);
    const dissipationLaw further = dissipationLaw::fit(data, 2, true);
    EXPECT_NEAR(further.alpha(0), 0.9, 1e-5);
    EXPECT_TRUE(further.rebound(1).captured);
}


TEST(dissipationLaw, reboundInvertsTheSpeed)
{
    const dissipationLaw law =
        dissipationLaw({0.5, 0.2, -0.1}, 0, 0.5);
    EXPECT_TRUE(law.ambiguous().empty());
    for (double e : {0.01, 0.1, 0.3})
    {
        const double q = law.speed(e);
        ASSERT_TRUE(std::isfinite(q));
        EXPECT_NEAR(law.rebound(q).restitution, e, 1e-7);
        EXPECT_NEAR
        (
            dissipationLaw::restitution(law.alpha(e), q), e, 1e-9
        );
    }
    EXPECT_NEAR(law.speed(0), jkrMotion(0.5).captureRatio(), 1e-6);
    EXPECT_TRUE(law.rebound(0.999*law.speed(0)).captured);
    EXPECT_FALSE(law.rebound(1.001*law.speed(0)).captured);
    EXPECT_TRUE(std::isinf(law.speed(0.5)));
}


TEST(dissipationLaw, findsTheSpeedsOfSeveralRestitutions)
{
    // alpha falls with e: V(e) goes down from capture before it rises
    const dissipationLaw law = dissipationLaw({1.2, -1.0, -0.2});
    const auto found = law.ambiguous();
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].high, law.speed(0), 1e-9*law.speed(0));
    EXPECT_LT(found[0].low, 0.995*found[0].high);

    // Two solutions within, the larger one taken; none below
    const double q = 0.5*(found[0].low + found[0].high);
    const double e = law.rebound(q).restitution;
    EXPECT_GT(e, 0);
    EXPECT_NEAR(law.speed(e)/q, 1, 1e-6);
    int solutions = 0;
    double last = law.speed(0) - q;
    for (int i = 1; i <= 500; ++i)
    {
        const double next = law.speed(1e-4*i) - q;
        solutions += (next > 0) != (last > 0);
        last = next;
    }
    EXPECT_EQ(solutions, 2);
    EXPECT_TRUE(law.rebound(0.999*found[0].low).captured);
    EXPECT_TRUE(dissipationLaw::constant(1.2).ambiguous().empty());
}


TEST(dissipationLaw, refusesWhatIsOutOfRange)
{
    typedef dissipationLaw law;
    EXPECT_THROW(law({}), std::invalid_argument);
    EXPECT_THROW(law({0.5, -1}), std::invalid_argument);
    EXPECT_THROW(law({11}), std::invalid_argument);
    EXPECT_THROW(law({1}, 0.5, 0.4), std::invalid_argument);
    EXPECT_THROW(law({1}, -0.1, 0.4), std::invalid_argument);
    EXPECT_THROW(law::constant(-1), std::invalid_argument);
    EXPECT_THROW(law::marshall().alpha(1.01), std::invalid_argument);

    // More than an elastic contact gives back; captured
    EXPECT_THROW(law::calibrated(2, 0.87), std::invalid_argument);
    EXPECT_THROW(law::calibrated(2, 0), std::invalid_argument);
    EXPECT_THROW(law::fit({{3, 0.3}}, 0), std::invalid_argument);
    EXPECT_THROW(law::fit({{3, 0.3}, {4, 0.4}}, 2), std::invalid_argument);
    EXPECT_THROW
    (
        law::fit({{3, 0.3}, {4, 0.4}, {4, 0.4}}, 2), std::invalid_argument
    );
    EXPECT_NO_THROW(law::fit({{3, 0.3}, {4, 0.4}, {4, 0.4}}, 1));
}
