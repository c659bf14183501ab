/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The undisturbed stream: loading, counts per size, bad input.
\*---------------------------------------------------------------------------*/

#include "undisturbedStream.H"

#include <gtest/gtest.h>
#include <cmath>
#include <stdexcept>

using impact::undisturbedStream;


TEST(undisturbedStream, carriesTheVolumeFraction)
{
    const undisturbedStream stream
    (
        1e-5,
        {{5e-6, 0.3, 20}, {1e-5, 0.5, 10}, {5e-5, 0.2, 2}},
        1
    );
    double volume = 0;
    double parcels = 0;
    for (int j = 0; j < 3; ++j)
    {
        volume +=
            stream.numberDensity(j)*M_PI/6*std::pow(stream.sizes()[j].d, 3);
        parcels += stream.numberDensity(j)/stream.sizes()[j].weight;
    }
    EXPECT_NEAR(volume/1e-5, 1, 1e-14);
    EXPECT_NEAR(stream.parcelDensity()/parcels, 1, 1e-14);
}


TEST(undisturbedStream, keepsTheShareOfEachSizeAtAnyTime)
{
    const undisturbedStream stream
    (
        1e-5,
        {{5e-6, 0.3, 20}, {6e-6, 0.5, 10}, {9e-6, 0.2, 2}},
        1
    );
    int counts[3] = {};
    for (int k = 0; k < 100000; ++k)
    {
        ++counts[stream.sizeOf(k)];
        if (k % 997 == 0)
        {
            for (int j = 0; j < 3; ++j)
            {
                const double share =
                    stream.numberDensity(j)/stream.sizes()[j].weight
                   /stream.parcelDensity();
                EXPECT_NEAR(counts[j], share*(k + 1), 6);
            }
        }
    }
}


// An inlet that does not fill the rectangle around it lets a part of a quiet
// stream in: of each size the same
TEST(undisturbedStream, sizesOfAPartOfAQuietStream)
{
    const int repeats = 50;
    const int n = 12000;
    double square = 0;
    for (int seed = 0; seed < repeats; ++seed)
    {
        const undisturbedStream stream
        (
            1e-5,
            {{5e-6, 0.4, 1}, {5e-6, 0.35, 1}, {5e-6, 0.25, 1}},
            seed
        );
        int all = 0;
        int middle = 0;
        for (int k = 0; k < n; ++k)
        {
            const auto draw = stream.quietOf(k, 1);
            if (std::fabs(draw.a - 0.5) + std::fabs(draw.b - 0.5) < 0.5)
            {
                ++all;
                middle += stream.quietSizeOf(k, 1) == 1;
            }
        }
        EXPECT_NEAR(all, 0.5*n, 0.01*n);
        const double error = middle/(0.35*all) - 1;
        square += error*error/repeats;
    }

    // Random sizes would be off by 0.018
    EXPECT_LT(std::sqrt(square), 0.009);
}


namespace
{
    // What a wall might count: parcels that enter in a part of time and of
    // the section, of one size, weighted
    double mean(const undisturbedStream& stream, int n, bool quiet)
    {
        double sum = 0;
        for (int k = 0; k < n; ++k)
        {
            const auto draw =
                quiet ? stream.quietOf(k, 1) : stream.drawOf(k, 1);
            const double t = (k + draw.entry)/n;
            if (t > 0.2 && t < 0.9 && draw.a > 0.13 && draw.a < 0.71)
            {
                const int size =
                    quiet ? stream.quietSizeOf(k, 1) : stream.sizeOf(k);
                sum += (1 + draw.b)*(size == 1);
            }
        }
        return sum/n;
    }

    double errorOf(int n, bool quiet)
    {
        double sum = 0, square = 0;
        const int repeats = 40;
        const double truth = 0.7*0.58*1.5*0.75;
        for (int seed = 0; seed < repeats; ++seed)
        {
            const undisturbedStream stream
            (
                1e-5,
                {{5e-6, 0.25, 1}, {5e-6, 0.75, 1}},
                seed
            );
            const double x = mean(stream, n, quiet) - truth;
            sum += x;
            square += x*x;
        }
        const double error = std::sqrt(square/repeats);

        // Unbiased: the mean of the repeats is within its own noise
        EXPECT_LT(std::fabs(sum/repeats), 4*error/std::sqrt(repeats));
        return error;
    }
}


TEST(undisturbedStream, aQuietOneErrsLikeOneOverN)
{
    const double few = errorOf(256, true);
    const double many = errorOf(65536, true);
    const double slope = std::log(many/few)/std::log(65536/256);
    EXPECT_LT(slope, -0.8);

    const double random = errorOf(65536, false);
    EXPECT_GT(random/many, 20);
    RecordProperty("slope", std::to_string(slope));
    RecordProperty("gain", std::to_string(random/many));
}


TEST(undisturbedStream, aQuietOneFillsEveryIntervalAlike)
{
    const undisturbedStream stream(1e-5, {{5e-6, 1, 1}}, 7);
    for (int first = 0; first < 4096; first += 256)
    {
        int counts[16] = {};
        for (int k = first; k < first + 256; ++k)
        {
            const auto draw = stream.quietOf(k, 0);
            EXPECT_GT(draw.a, 0);
            EXPECT_LT(draw.a, 1);
            ++counts[int(16*draw.a)];
        }
        for (int n : counts)
        {
            EXPECT_EQ(n, 16);
        }
    }
}


TEST(undisturbedStream, entersAtTheRateInShortWindows)
{
    // What enters towards a body that takes a part of the section, in a window
    // of time of so many parcels
    const double part = 0.15;
    const int first = 25000, n = 20000;
    const auto entering = [&](const int seed, const bool quiet)
    {
        const undisturbedStream stream(1e-5, {{5e-6, 1, 1}}, seed);
        int count = 0;
        for (int k = first; k < first + n; ++k)
        {
            count +=
                (quiet ? stream.quietOf(k, 1) : stream.drawOf(k, 1)).a < part;
        }
        return count/(part*n);
    };

    const int seeds = 400;
    double sum = 0, square = 0;
    for (int seed = 0; seed < seeds; ++seed)
    {
        const double x = entering(seed, false) - 1;
        sum += x;
        square += x*x;
        EXPECT_NEAR(entering(seed, true), 1, 2e-3);
    }
    const double deviation = std::sqrt((1 - part)/(part*n));
    EXPECT_NEAR(sum/seeds, 0, 4*deviation/std::sqrt(seeds));
    EXPECT_NEAR(std::sqrt(square/seeds)/deviation, 1, 4/std::sqrt(2.*seeds));
    RecordProperty("defaultSeed", std::to_string(entering(0, false)));
}


TEST(undisturbedStream, refusesBadInput)
{
    typedef std::vector<undisturbedStream::sizeClass> list;
    const list one{{5e-6, 1, 1}};
    EXPECT_THROW(undisturbedStream(0, one, 0), std::invalid_argument);
    EXPECT_THROW(undisturbedStream(0.1, one, 0), std::invalid_argument);
    EXPECT_THROW(undisturbedStream(1e-5, {}, 0), std::invalid_argument);
    for
    (
        const list& bad :
        {
            list{{0, 1, 1}},
            list{{-1e-6, 1, 1}},
            list{{5e-6, 0.5, 1}},
            list{{5e-6, 1.5, 1}, {6e-6, -0.5, 1}},
            list{{5e-6, 1, 0}}
        }
    )
    {
        EXPECT_THROW(undisturbedStream(1e-5, bad, 0), std::invalid_argument);
    }
}
