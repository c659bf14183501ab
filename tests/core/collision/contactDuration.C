/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The rule that bounds the number of dissipative collisions.
\*---------------------------------------------------------------------------*/

#include "contactDuration.H"

#include <gtest/gtest.h>

using namespace impact;


TEST(contactDuration, allowsEightDissipativeCollisionsInAWindow)
{
    const contactDuration rule(1e-3);
    recentContacts r;
    int dissipative = 0;
    for (int i = 0; i < 100000; ++i)
    {
        // Ten windows, ten thousand collisions in each
        const double t = 5 + 1e-7*i;
        dissipative += !rule.elastic(r, t, 1, 0);
        rule.count(r, t);
    }
    EXPECT_GE(dissipative, 8*10);
    EXPECT_LE(dissipative, 9*11);

    // Rarely enough: all of them
    recentContacts s;
    for (int i = 0; i < 1000; ++i)
    {
        EXPECT_FALSE(rule.elastic(s, 2e-4*i, 1, 0));
        rule.count(s, 2e-4*i);
    }
}


TEST(contactDuration, makesSlowContactsUnderLoadElastic)
{
    const contactDuration rule(1e-3);
    const recentContacts r;
    EXPECT_TRUE(rule.elastic(r, 0, 0.0049, 9.81));
    EXPECT_FALSE(rule.elastic(r, 0, 0.0050, 9.81));
    EXPECT_FALSE(rule.elastic(r, 0, 1e-9, 0));

    // None of it without a duration
    const contactDuration none;
    recentContacts s;
    for (int i = 0; i < 100; ++i)
    {
        EXPECT_FALSE(none.elastic(s, 0, 0, 9.81));
        none.count(s, 0);
    }
}


TEST(contactDuration, saysWhatRestsOnWhat)
{
    const contactDuration rule(1e-3);

    // More than eight slow contacts one after another, however far apart
    recentContacts slow;
    for (int i = 0; i < 9; ++i)
    {
        EXPECT_FALSE(rule.rests(slow, i));
        rule.count(slow, i, rule.slow(0.0049, 9.81));
    }
    EXPECT_TRUE(rule.rests(slow, 9));
    rule.count(slow, 9, rule.slow(0.005, 9.81));
    EXPECT_FALSE(rule.rests(slow, 10));

    // 24 of any speed in a window
    recentContacts many;
    for (int i = 0; i < 24; ++i)
    {
        EXPECT_FALSE(rule.rests(many, 1e-5*i));
        rule.count(many, 1e-5*i);
    }
    EXPECT_TRUE(rule.rests(many, 24e-5));
    EXPECT_FALSE(rule.rests(many, 1.1e-3));
}
