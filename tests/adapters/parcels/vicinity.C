/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    A vicinity must hold every point within the distance of those added, also
    beyond its box, and not most of the others.
\*---------------------------------------------------------------------------*/

#include "vicinity.H"

#include <gtest/gtest.h>
#include <random>

using namespace Foam;

namespace
{

void check(const vector& directions)
{
    const boundBox box(point(-1, 0, 2), point(1, 4, 3));
    const scalar distance = 0.05;
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(-0.1, 1.1);
    const auto draw = [&]()
    {
        point x;
        for (direction d = 0; d < 3; ++d)
        {
            x[d] = box.min()[d] + uniform(generator)*box.span()[d];
        }
        return x;
    };

    vicinity v(box, directions);
    const point added[3] = {draw(), draw(), draw()};
    for (const point& x : added)
    {
        EXPECT_FALSE(v.near(x));
        v.add(x, distance);
    }
    v.reduce();

    label nNear = 0;
    for (label i = 0; i < 20000; ++i)
    {
        // Half of them near by
        point x = draw();
        if (i % 2)
        {
            x = added[i % 3] + distance*(x - draw());
        }
        bool within = false;
        for (const point& y : added)
        {
            within = within || mag(cmptMultiply(directions, x - y)) <= distance;
        }
        EXPECT_TRUE(v.near(x) || !within);
        nNear += i % 2 == 0 && v.near(x);
    }
    EXPECT_GT(nNear, 0);
    EXPECT_LT(nNear, 2000);
}

} // End anonymous namespace


TEST(vicinity, missesNoneInSpace)
{
    check(vector(1, 1, 1));
}


TEST(vicinity, missesNoneInAPlane)
{
    check(vector(1, 0, 1));
}
