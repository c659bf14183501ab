/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The territory of a mesh in a larger domain: every box within reach of its
    cells must be near, across a period too, and no box that is two cells of
    the coarse grid farther away.
\*---------------------------------------------------------------------------*/

#include "boxMeshTest.H"
#include "counterRandom.H"
#include "rankTerritories.H"

#include <gtest/gtest.h>

using namespace Foam;

class rankTerritoriesTest
:
    public boxMeshTest
{
protected:

    void check(const vector& directions, const bool periodic)
    {
        // The mesh is the unit cube
        impact::collisionDomain domain;
        domain.low = {-1, -2, 0};
        domain.high = {3, 3, 4};
        domain.periodic[0] = periodic;
        rankTerritories territories(*mesh_, domain, directions);
        impact::counterRandom rnd(7);
        label nNear = 0, nFar = 0;
        for (const scalar reach : {0.5, 0.1})
        {
            territories.setReach(reach);
            territories.setReach(0.01, true);
            for (label i = 0; i < 5000; ++i)
            {
                impact::sweptBox box;
                scalar away = 0;
                for (label k = 0; k < 3; ++k)
                {
                    const scalar L = domain.high[k] - domain.low[k];
                    box.low[k] = domain.low[k] + L*rnd.uniform();
                    box.high[k] = box.low[k] + 0.1*rnd.uniform();
                    const auto gap = [&](const scalar shift)
                    {
                        return
                            max(box.low[k] + shift - 1, -box.high[k] - shift);
                    };
                    scalar d = gap(0);
                    if (domain.periodic[k])
                    {
                        d = min(d, min(gap(L), gap(-L)));
                    }
                    if (directions[k] > 0)
                    {
                        away = max(away, d);
                    }
                }
                const bool near = territories.near(0, box);
                nNear += away < reach;
                nFar += away > reach + 0.3;
                EXPECT_TRUE(near || away >= reach) << away;
                EXPECT_FALSE(near && away > reach + 0.3) << away;

                // There is no other rank
                EXPECT_FALSE(territories.foreign(box));
            }
        }
        EXPECT_GT(nNear, 50);
        EXPECT_GT(nFar, 50);
    }
};


TEST_F(rankTerritoriesTest, holdsWhatIsWithinReach)
{
    check(vector(1, 1, 1), false);
    check(vector(1, 1, 1), true);
    check(vector(1, 1, 0), true);
}
