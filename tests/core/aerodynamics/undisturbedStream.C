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
