/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Errors of rates and ratios from blocks of time: the scatter of repeated
    runs against the errors that each of them claims, for independent and for
    correlated events; the joining of blocks; a restart to the last bit.
\*---------------------------------------------------------------------------*/

#include "blockStatistics.H"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using impact::blockStatistics;

namespace
{

enum { number, speed };

//- A run of steps of length 1: particles arrive at random, each strikes once
//  and again nRepeats times on average, after delays of "memory" on average
//  and with a speed near its own
void run
(
    blockStatistics& statistics,
    std::mt19937_64& random,
    int nSteps,
    double arrivals,
    double nRepeats,
    double memory
)
{
    std::poisson_distribution<int> arrive(arrivals);
    std::poisson_distribution<int> repeats(std::max(nRepeats, 1e-300));
    std::exponential_distribution<double> delay(1/memory);
    std::normal_distribution<double> normal(0, 1);

    std::vector<double> n(nSteps, 0.0);
    std::vector<double> v(nSteps, 0.0);
    // Particles that arrived before the record strike in it, too
    const int before = int(10*memory);
    for (int i = -before; i < nSteps; ++i)
    {
        for (int k = arrive(random); k > 0; --k)
        {
            const double own = 100 + 20*normal(random);
            double t = i + 0.5;
            for (int hits = 1 + repeats(random); hits > 0; --hits)
            {
                const int step = int(std::floor(t));
                if (step >= 0 && step < nSteps)
                {
                    n[step] += 1;
                    v[step] += own + 5*normal(random);
                }
                t += delay(random);
            }
        }
    }
    for (int i = 0; i < nSteps; ++i)
    {
        statistics.open()[number] += n[i];
        statistics.open()[speed] += v[i];
        if (statistics.advance(1))
        {
            statistics.close();
        }
    }
    statistics.settle();
}


struct scatter
{
    double mean = 0;
    double square = 0;
    double claimed = 0;
    int n = 0;

    void add(const blockStatistics::estimate& e)
    {
        mean += e.value;
        square += e.value*e.value;
        claimed += e.error*e.error;
        ++n;
    }

    //- Root mean square of the claimed errors over the observed scatter
    double ratio() const
    {
        const double m = mean/n;
        return std::sqrt(claimed/n)/std::sqrt((square/n - m*m)*n/(n - 1));
    }
};

} // End anonymous namespace


TEST(blockStatistics, claimsTheScatterOfIndependentEvents)
{
    std::mt19937_64 random(1);
    scatter rate, ratio;
    for (int i = 0; i < 400; ++i)
    {
        blockStatistics statistics(1, 2);
        run(statistics, random, 1500, 0.5, 0, 1);
        rate.add(statistics.rate(0, number));
        ratio.add(statistics.ratio(0, speed, number));
    }
    // The scatter of 400 runs is known to 3.5 %
    EXPECT_NEAR(rate.ratio(), 1, 0.12);
    EXPECT_NEAR(ratio.ratio(), 1, 0.12);
    EXPECT_NEAR(rate.mean/rate.n, 0.5, 4*std::sqrt(0.5/1500/400));
}


TEST(blockStatistics, claimsTheScatterOfCorrelatedEvents)
{
    std::mt19937_64 random(2);
    scatter rate, ratio;
    double poisson = 0;
    for (int i = 0; i < 400; ++i)
    {
        blockStatistics statistics(1, 2);
        run(statistics, random, 4000, 0.2, 4, 3);
        rate.add(statistics.rate(0, number));
        ratio.add(statistics.ratio(0, speed, number));
        poisson += statistics.sum(0, number)/4000/4000;
    }
    EXPECT_NEAR(rate.ratio(), 1, 0.15);
    EXPECT_NEAR(ratio.ratio(), 1, 0.15);

    // Counting impacts as if they were independent claims less than half
    const double claimed = std::sqrt(poisson/400);
    const double observed = std::sqrt(rate.claimed/rate.n)/rate.ratio();
    EXPECT_LT(claimed/observed, 0.55);
}


TEST(blockStatistics, joinsBlocksAndKeepsTheirSums)
{
    blockStatistics statistics(3, 2, 12);
    double total = 0;
    for (int i = 1; i <= 1000; ++i)
    {
        statistics.open()[2*2 + 1] += i;
        total += i;
        if (statistics.advance(0.1))
        {
            statistics.close();
        }
        EXPECT_LT(statistics.nBlocks(), 24u);
        EXPECT_EQ(statistics.errorsKnown(), i >= 12);
    }
    statistics.settle();
    EXPECT_EQ(statistics.sum(2, 1), total);
    EXPECT_EQ(statistics.sum(2, 0), 0);
    EXPECT_EQ(statistics.sum(1, 1), 0);
    EXPECT_NEAR(statistics.time(), 100, 1e-10);
    EXPECT_NEAR(statistics.rate(2, 1).value, total/100, 1e-8);
}


TEST(blockStatistics, weighsStepsByTheirLength)
{
    // A steady stream seen in steps of any length has no scatter
    blockStatistics statistics(1, 1);
    for (int i = 0; i < 500; ++i)
    {
        const double dt = 0.01*(1 + i % 7);
        statistics.open()[0] += 3*dt;
        if (statistics.advance(dt))
        {
            statistics.close();
        }
    }
    statistics.settle();
    EXPECT_NEAR(statistics.rate(0, 0).value, 3, 1e-12);
    EXPECT_GE(statistics.rate(0, 0).error, 0);
    EXPECT_LT(statistics.rate(0, 0).error, 1e-12);
}


TEST(blockStatistics, goesOnFromASavedState)
{
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal(0, 1);
    blockStatistics straight(4, 3);
    blockStatistics first(4, 3);
    const auto step = [](blockStatistics& s, const std::vector<double>& x)
    {
        for (std::size_t i = 0; i < x.size(); ++i)
        {
            s.open()[i] += x[i];
        }
        if (s.advance(1e-3))
        {
            s.close();
        }
    };
    std::vector<double> x(12);
    std::vector<double> saved;
    blockStatistics second(4, 3);
    for (int i = 0; i < 777; ++i)
    {
        for (double& xi : x)
        {
            xi = normal(random);
        }
        step(straight, x);
        step(i < 450 ? first : second, x);
        if (i == 449)
        {
            straight.settle();
            first.settle();
            second.setTimes(first.times());
            for (int item = 0; item < 4; ++item)
            {
                saved = first.state(item);
                second.setState(item, saved.data(), saved.size());
            }
        }
    }
    straight.settle();
    second.settle();
    for (int item = 0; item < 4; ++item)
    {
        EXPECT_EQ(straight.state(item), second.state(item));
        EXPECT_EQ(straight.rate(item, 1).error, second.rate(item, 1).error);
        EXPECT_GT(straight.rate(item, 1).error, 0);
    }
    EXPECT_EQ(straight.times(), second.times());
}


TEST(blockStatistics, blocksKeepUpWithLongerSteps)
{
    // The first step is far shorter than those that follow, or they grow
    std::mt19937_64 random(5);
    std::poisson_distribution<int> hits(20);
    for (const double growth : {1e6, 1.1})
    {
        scatter rate;
        double longest = 0;
        for (int run = 0; run < 300; ++run)
        {
            blockStatistics s(1, 1);
            double dt = 1e-6;
            for (int i = 0; i < 1000; ++i)
            {
                s.open()[0] += dt*hits(random);
                if (s.advance(dt))
                {
                    s.close();
                }
                dt = std::min(1., dt*growth);
            }
            s.settle();
            rate.add(s.rate(0, 0));
            const std::vector<double> times = s.times();
            longest = std::max
            (
                longest,
                *std::max_element(times.begin() + 2, times.end())/s.time()
            );
        }
        // The scatter of 300 runs is known to 4 %
        EXPECT_NEAR(rate.ratio(), 1, 0.12) << growth;
        EXPECT_LT(longest, 0.15) << growth;
    }
}


TEST(blockStatistics, boundsTheErrorOfAsManyBlocksAsHaveSomething)
{
    // Chi-squared of 1 and 9 degrees of freedom: 0.01579, 4.168
    EXPECT_NEAR(blockStatistics::errorBound(2), 7.958, 1e-3);
    EXPECT_NEAR(blockStatistics::errorBound(10), 1.469, 1e-3);

    // Mean speeds of rare impacts until their error seems to be below 5 %
    std::mt19937_64 random(6);
    std::poisson_distribution<int> hits(0.1);
    std::normal_distribution<double> normal(10, 2);
    double square = 0;
    const int nRuns = 1000;
    for (int run = 0; run < nRuns; ++run)
    {
        blockStatistics s(1, 2);
        for (;;)
        {
            for (int k = hits(random); k > 0; --k)
            {
                s.open()[number] += 1;
                s.open()[speed] += normal(random);
            }
            if (s.advance(1))
            {
                s.close();
                const auto e = s.ratio(0, speed, number);
                if
                (
                    e.error >= 0
                 && s.errorBound(e.nBlocks)*e.error < 0.05*e.value
                )
                {
                    square += std::pow(e.value/10 - 1, 2);
                    break;
                }
            }
        }
    }
    // Known to 2.5 %
    EXPECT_LT(std::sqrt(square/nRuns), 0.06);
}


TEST(blockStatistics, hasNothingToSayAboutNothing)
{
    blockStatistics statistics(1, 2);
    EXPECT_EQ(statistics.rate(0, 0).value, 0);
    EXPECT_LT(statistics.rate(0, 0).error, 0);
    for (int i = 0; i < 30; ++i)
    {
        if (statistics.advance(1))
        {
            statistics.close();
        }
    }
    EXPECT_EQ(statistics.ratio(0, 1, 0).value, 0);
    EXPECT_LT(statistics.ratio(0, 1, 0).error, 0);
    EXPECT_EQ(statistics.rate(0, 1).error, 0);

    // One event has a speed, and a rate of 100 % error, but no scatter
    statistics.open()[number] += 1;
    statistics.open()[speed] += 300;
    statistics.advance(1);
    statistics.close();
    EXPECT_EQ(statistics.ratio(0, speed, number).value, 300);
    EXPECT_LT(statistics.ratio(0, speed, number).error, 0);
    const auto rate = statistics.rate(0, number);
    EXPECT_NEAR(rate.error/rate.value, 1, 0.1);
}


TEST(blockStatistics, refusesBadInput)
{
    EXPECT_THROW(blockStatistics(1, 1, 9), std::invalid_argument);
    EXPECT_THROW(blockStatistics(1, 0), std::invalid_argument);
    blockStatistics statistics(2, 2);
    const std::vector<double> sums(2);
    EXPECT_THROW
    (
        statistics.setTimes(std::vector<double>(22)),
        std::invalid_argument
    );
    EXPECT_THROW(statistics.setTimes({}), std::invalid_argument);
    EXPECT_THROW(statistics.setState(2, &sums[0], 2), std::invalid_argument);
    EXPECT_THROW(statistics.setState(0, &sums[0], 1), std::invalid_argument);
}
