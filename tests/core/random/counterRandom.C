/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The counter-based generator against the known-answer vectors of the
    Random123 library (file kat_vectors, philox4x32 with 10 rounds), and its
    uniform and normal numbers against their moments.
\*---------------------------------------------------------------------------*/

#include "counterRandom.H"

#include <gtest/gtest.h>
#include <cmath>

using impact::counterRandom;


TEST(counterRandom, reproducesThePublishedVectors)
{
    typedef counterRandom::counterType C;
    typedef counterRandom::keyType K;

    EXPECT_EQ
    (
        counterRandom::philox(C{{0, 0, 0, 0}}, K{{0, 0}}),
        (C{{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}})
    );
    const std::uint32_t f = 0xffffffff;
    EXPECT_EQ
    (
        counterRandom::philox(C{{f, f, f, f}}, K{{f, f}}),
        (C{{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}})
    );
    EXPECT_EQ
    (
        counterRandom::philox
        (
            C{{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}},
            K{{0xa4093822, 0x299f31d0}}
        ),
        (C{{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}})
    );
}


TEST(counterRandom, isAFunctionOfSeedStreamAndSubstream)
{
    counterRandom first(7, 123456789012ull, 3);
    counterRandom again(7, 123456789012ull, 3);
    for (int i = 0; i < 100; ++i)
    {
        ASSERT_EQ(first.bits(), again.bits());
    }

    // One bit of difference anywhere gives other numbers
    const double reference = counterRandom(1, 2, 3).uniform();
    EXPECT_NE(reference, counterRandom(0, 2, 3).uniform());
    EXPECT_NE(reference, counterRandom(1, 3, 3).uniform());
    EXPECT_NE(reference, counterRandom(1, 2, 2).uniform());
    EXPECT_NE(reference, counterRandom(1, 2 + (1ull << 40), 3).uniform());
    EXPECT_NE(reference, counterRandom(1 + (1ull << 40), 2, 3).uniform());
}


TEST(counterRandom, uniformNumbersFillTheUnitInterval)
{
    // One number from each of many streams: the way it is used for particles
    const int n = 200000;
    double sum = 0, sum2 = 0, neighbours = 0, last = 0.5;
    int bins[16] = {};
    for (int i = 0; i < n; ++i)
    {
        const double x = counterRandom(42, i).uniform();
        ASSERT_GT(x, 0);
        ASSERT_LT(x, 1);
        sum += x;
        sum2 += x*x;
        neighbours += (x - 0.5)*(last - 0.5);
        last = x;
        ++bins[int(16*x)];
    }
    // Five standard errors each
    EXPECT_NEAR(sum/n, 0.5, 5*std::sqrt(1./12/n));
    EXPECT_NEAR(sum2/n, 1./3, 5*std::sqrt(4./45/n));
    EXPECT_NEAR(neighbours/n, 0, 5*1./12/std::sqrt(n));
    double chi2 = 0;
    for (int b : bins)
    {
        chi2 += std::pow(b - n/16., 2)/(n/16.);
    }
    EXPECT_LT(chi2, 44.3);      // 15 degrees of freedom, probability 1e-4
}


TEST(counterRandom, normalNumbersHaveTheirMoments)
{
    counterRandom rnd(11);
    const int n = 200000;
    double m1 = 0, m2 = 0, m3 = 0, m4 = 0;
    for (int i = 0; i < n; ++i)
    {
        const double x = rnd.normal();
        m1 += x;
        m2 += x*x;
        m3 += x*x*x;
        m4 += x*x*x*x;
    }
    EXPECT_NEAR(m1/n, 0, 5*std::sqrt(1./n));
    EXPECT_NEAR(m2/n, 1, 5*std::sqrt(2./n));
    EXPECT_NEAR(m3/n, 0, 5*std::sqrt(15./n));
    EXPECT_NEAR(m4/n, 3, 5*std::sqrt(96./n));
}
