/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Eddies: their statistics, and how far they carry what they do, against
    exact sums of independent flights.
\*---------------------------------------------------------------------------*/

#include "eddyInteraction.H"

#include <gtest/gtest.h>
#include <cmath>

using namespace impact;

namespace
{

const eddyInteraction::turbulence gas{24, 5e4};

const vector3 all{1, 1, 1};

constexpr double never = 1e298;

} // End namespace


TEST(eddyInteraction, crossingEndsAsTheSphereRelaxes)
{
    // A sphere of speed w and rate r has come (w/r)(1 - exp(-r t))
    for (const double share : {1e-14, 1e-6, 0.3, 0.99})
    {
        const double rate = 700, speed = 40, size = share*speed/rate;
        const double t = eddyInteraction::crossing(size, speed, rate);
        EXPECT_NEAR(-speed/rate*std::expm1(-rate*t), size, 1e-13*size);
    }
    EXPECT_GT(eddyInteraction::crossing(1, 40, 40), never);
    EXPECT_GT(eddyInteraction::crossing(1, 40, 50), never);
    EXPECT_GT(eddyInteraction::crossing(1, 0, 50), never);
    EXPECT_NEAR(eddyInteraction::crossing(1, 40, 0), 1./40, 1e-15);
}


TEST(eddyInteraction, gasWithoutTurbulenceIsStill)
{
    for (const auto& none : {eddyInteraction::turbulence{0, 5}, {5, 0}, {0, 0}})
    {
        const auto e = eddyInteraction::begin
            (none, {3, 4, 5}, 100, all, 1e-3, counterRandom(1));
        EXPECT_EQ(mag(e.u), 0);
        EXPECT_GT(e.life, never);

        // A file of OpenFOAM can hold it
        EXPECT_LT(e.life, 1e300);
    }
}


TEST(eddyInteraction, hasTheEnergyOfTheTurbulence)
{
    // Of 2e5 draws the mean energy has a standard deviation of 0.18 %
    const int n = 200000;
    double energy = 0, fourth = 0, cross = 0;
    vector3 mean{0, 0, 0};
    for (int i = 0; i < n; ++i)
    {
        const auto e = eddyInteraction::begin
            (gas, {0, 0, 0}, never, all, 0, counterRandom(3, i));
        EXPECT_EQ(e.life, eddyInteraction::lifetime(gas));
        energy += 0.5*dot(e.u, e.u)/n;
        fourth += std::pow(e.u.x, 4)/n;
        cross += e.u.x*e.u.y/n;
        mean = mean + 1./n*e.u;
    }
    const double sigma2 = 2*gas.k/3;
    EXPECT_NEAR(energy, gas.k, 0.007*gas.k);
    EXPECT_NEAR(fourth, 3*sigma2*sigma2, 0.06*sigma2*sigma2);
    EXPECT_NEAR(cross, 0, 0.01*sigma2);
    EXPECT_LT(mag(mean), 0.012*std::sqrt(sigma2));
}


TEST(eddyInteraction, keepsToTheDirectionsThatAreSolved)
{
    const auto e = eddyInteraction::begin
        (gas, {0, 0, 0}, never, {1, 0, 1}, 0, counterRandom(3));
    EXPECT_EQ(e.u.y, 0);
    EXPECT_NE(e.u.x*e.u.z, 0);
}


TEST(eddyInteraction, spreadsAlikeWhateverIsTakenTogether)
{
    // What follows the gas spreads with 0.1 k^2/epsilon, in one direction by
    // the variance 2 D t; 4e4 of them have it to 0.7 %
    const double T = eddyInteraction::lifetime(gas);
    const double end = 40*T, D = 0.1*gas.k*gas.k/gas.epsilon;
    const int n = 40000;
    for (const double shortest : {0., T, 4*T, 20*T})
    {
        double variance = 0;
        for (int i = 0; i < n; ++i)
        {
            double x = 0, t = 0;
            for (int j = 0; t < end*(1 - 1e-9); ++j)
            {
                const auto e = eddyInteraction::begin
                (
                    gas, {0, 0, 0}, never, all, shortest,
                    counterRandom(11, i, j)
                );
                x += e.life*e.u.x;
                t += e.life;
            }
            variance += x*x/n;
        }
        EXPECT_NEAR(variance, 2*D*end, 0.03*2*D*end) << shortest;
    }
}


TEST(eddyInteraction, heavySpheresCrossEddies)
{
    // A sphere at rest that hardly relaxes leaves an eddy after L/|u'|, if
    // that is sooner; |u'| has Maxwell's distribution
    const double L = eddyInteraction::size(gas);
    const double T = eddyInteraction::lifetime(gas);
    const int n = 100000;
    double mean = 0;
    for (int i = 0; i < n; ++i)
    {
        const auto e = eddyInteraction::begin
            (gas, {0, 0, 0}, 1e-9, all, 0, counterRandom(5, i));
        EXPECT_NEAR(e.life, std::min(T, L/mag(e.u)), 1e-9*T);
        mean += e.life/n;
    }

    // The same mean as an integral over the speed
    const double sigma = std::sqrt(2*gas.k/3);
    const int m = 20000;
    double exact = 0;
    for (int i = 0; i < m; ++i)
    {
        const double s = (i + 0.5)*8/m;
        exact +=
            std::sqrt(2/M_PI)*s*s*std::exp(-0.5*s*s)*8/m
           *std::min(T, L/(sigma*s));
    }
    EXPECT_NEAR(mean, exact, 0.005*exact);
}
