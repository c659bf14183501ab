/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The set of identities against std::set, its memory, and its saved form.
\*---------------------------------------------------------------------------*/

#include "identitySet.H"

#include <gtest/gtest.h>
#include <algorithm>
#include <random>
#include <set>

using impact::identitySet;

TEST(identitySet, isASet)
{
    std::mt19937 random(1);
    std::uniform_int_distribution<int> processor(-1, 3);
    std::uniform_int_distribution<int> number(-5000, 20000);
    identitySet ours;
    std::set<std::pair<int, int>> theirs;
    for (int i = 0; i < 50000; ++i)
    {
        const int p = processor(random);
        const int n = number(random);
        EXPECT_EQ(ours.contains(p, n), theirs.count({p, n}) == 1);
        EXPECT_EQ(ours.insert(p, n), theirs.insert({p, n}).second);
    }
    EXPECT_EQ(ours.size(), theirs.size());
    for (int p = -2; p < 5; ++p)
    {
        for (int n = -6000; n < 21000; ++n)
        {
            ASSERT_EQ(ours.contains(p, n), theirs.count({p, n}) == 1);
        }
    }
}


TEST(identitySet, takesABitPerParcel)
{
    identitySet set;
    for (int i = 0; i < 1000000; ++i)
    {
        set.insert(0, i);
    }
    EXPECT_EQ(set.size(), 1000000u);
    EXPECT_LT(8*set.words().size(), 140000u);
    identitySet lonely;
    lonely.insert(0, 2000000000);
    EXPECT_LT(8*lonely.words().size(), 600u);
}


TEST(identitySet, hasASavedFormOfItsMembersAlone)
{
    std::vector<std::pair<int, int>> members;
    std::mt19937 random(2);
    for (int i = 0; i < 3000; ++i)
    {
        members.push_back({int(random() % 3), int(random() % 100000)});
    }
    identitySet a;
    for (const auto& m : members)
    {
        a.insert(m.first, m.second);
    }
    std::reverse(members.begin(), members.end());
    identitySet b;
    for (const auto& m : members)
    {
        b.insert(m.first, m.second);
    }
    EXPECT_EQ(a.words(), b.words());

    const identitySet c(a.words());
    EXPECT_EQ(c.size(), a.size());
    EXPECT_EQ(c.words(), a.words());
    for (const auto& m : members)
    {
        EXPECT_TRUE(c.contains(m.first, m.second));
    }
    EXPECT_THROW
    (
        identitySet(std::vector<std::uint64_t>(64)),
        std::invalid_argument
    );
}
