/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Size groups: number and mass of a lognormal law against its moments.
\*---------------------------------------------------------------------------*/

#include "sizeGroups.H"

#include <gtest/gtest.h>
#include <cmath>
#include <stdexcept>

using namespace impact;

TEST(sizeGroups, aListIsScaledToOne)
{
    const auto g = sizeGroups::list({3e-6, 6e-6}, {1, 3});
    ASSERT_EQ(g.size(), 2u);
    EXPECT_DOUBLE_EQ(g[0].massFraction, 0.25);
    EXPECT_DOUBLE_EQ(g[1].massFraction, 0.75);
    EXPECT_EQ(g[1].diameter, 6e-6);
    EXPECT_THROW(sizeGroups::list({}, {}), std::invalid_argument);
    EXPECT_THROW(sizeGroups::list({1e-6}, {1, 2}), std::invalid_argument);
    EXPECT_THROW(sizeGroups::list({0}, {1}), std::invalid_argument);
    EXPECT_THROW(sizeGroups::list({1e-6}, {0}), std::invalid_argument);
    EXPECT_THROW(sizeGroups::list({1e-6}, {-1}), std::invalid_argument);
}


TEST(sizeGroups, aLognormalKeepsItsNumberAndMass)
{
    const double r = 5e-6;
    for (const double deviation : {1.05, 1.6, 2.5})
    {
        const double s = std::log(deviation);
        for (const int n : {1, 5, 40})
        {
            for (const bool byMass : {false, true})
            {
                const auto groups = sizeGroups::lognormal
                (
                    r, deviation,
                    byMass ? sizeGroups::weighting::mass
                  : sizeGroups::weighting::number,
                    n
                );
                ASSERT_EQ(int(groups.size()), n);

                // Particles for the mass of spheres of the unit density; the
                // cube of the radius has the mean r^3 exp(9 s^2/2) over the
                // numbers, and 1/r^3 exp(9 s^2/2) over the mass
                double number = 0, mass = 0, last = 0;
                for (const auto& g : groups)
                {
                    number += g.massFraction/std::pow(g.diameter/2, 3);
                    mass += g.massFraction;
                    EXPECT_GT(g.diameter, last);
                    last = g.diameter;
                }
                EXPECT_NEAR(mass, 1, 1e-12);
                const double exact =
                    std::exp((byMass ? 4.5 : -4.5)*s*s)/(r*r*r);
                EXPECT_NEAR(number/exact, 1, 1e-9);
            }
        }
    }
    const auto w = sizeGroups::weighting::number;
    EXPECT_THROW(sizeGroups::lognormal(0, 2, w, 5), std::invalid_argument);
    EXPECT_THROW(sizeGroups::lognormal(r, 1, w, 5), std::invalid_argument);
    EXPECT_THROW(sizeGroups::lognormal(r, 2, w, 0), std::invalid_argument);
}
