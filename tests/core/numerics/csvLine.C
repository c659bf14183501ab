/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Lines of comma-separated values: what is empty, digits, the same bits.
\*---------------------------------------------------------------------------*/

#include "csvLine.H"
#include "counterRandom.H"

#include <gtest/gtest.h>
#include <cstdlib>
#include <cmath>
#include <cstdio>

using namespace impact;


TEST(csvLine, entriesAndEmptyOnes)
{
    csvLine line(4);
    line.add("");
    line.add(std::string("wall"));
    line.add(-3);
    line.add(true);
    line.add(false, 2.5);
    line.add(true, 2.0/3);
    EXPECT_EQ(line.take(), ",wall,-3,1,,0.6667\n");
    line.add(1e-7);
    EXPECT_EQ(line.take(), "1e-07\n");
    EXPECT_EQ(line.take(), "\n");
}


TEST(csvLine, digitsAreThoseOfPrintf)
{
    counterRandom rnd(5);
    for (int i = 0; i < 10000; ++i)
    {
        const double x = std::pow(10, 40*rnd.uniform() - 20)*rnd.uniform();
        char text[64];
        std::snprintf(text, sizeof(text), "%.12g\n", x);
        csvLine line(12);
        line.add(x);
        EXPECT_EQ(line.take(), text);
    }
}


TEST(csvLine, shortestGivesBackTheSameBits)
{
    counterRandom rnd(6);
    for (int i = 0; i < 10000; ++i)
    {
        const double x = std::pow(10, 600*rnd.uniform() - 300);
        csvLine line;
        line.add(x);
        EXPECT_EQ(std::strtod(line.take().c_str(), nullptr), x);
    }
    csvLine line;
    line.add(0.1);
    EXPECT_EQ(line.take(), "0.1\n");
}
