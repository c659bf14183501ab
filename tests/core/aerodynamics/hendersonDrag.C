/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Drag laws of the core against their limits.
\*---------------------------------------------------------------------------*/

#include "hendersonDrag.H"

#include <gtest/gtest.h>

using impact::hendersonCdRe;


TEST(hendersonDrag, meetsStokesAtSmallReynoldsNumber)
{
    for (double Re : {1e-9, 1e-6, 1e-3})
    {
        EXPECT_NEAR(hendersonCdRe(Re, 1e-9*Re, 1.4, 1)/24, 1, 4e-3);
    }
    EXPECT_DOUBLE_EQ(hendersonCdRe(0, 0, 1.4, 1), 24);
}


TEST(hendersonDrag, isContinuousAtTheEndsOfTheInterpolatedRange)
{
    for (double M : {1.0, 1.75})
    {
        const double below = hendersonCdRe(50, M*(1 - 1e-12), 1.4, 1);
        const double above = hendersonCdRe(50, M*(1 + 1e-12), 1.4, 1);
        EXPECT_NEAR(below/above, 1, 1e-9);
    }
}
