/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The overlapping pairs of the grid against all pairs, and the queue of
    events against a sorted list.
\*---------------------------------------------------------------------------*/

#include "counterRandom.H"
#include "eventQueue.H"
#include "sweptGrid.H"

#include <gtest/gtest.h>
#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>
#include <tuple>

using namespace impact;

namespace
{

typedef std::tuple<int, int, int, int, int> imagePair;


struct boxes
{
    collisionDomain domain;
    std::vector<sweptBox> all;
    bool twoD;
    double spread;

    //- \param kind  bits: periodic x, y, z; 8: 2-D; 16: sizes from 1e-3 to 1;
    //      32: a few far away; 64: period smaller than some boxes
    boxes(int kind, int n, counterRandom& rnd)
    :
        twoD(kind & 8),
        spread((kind & 64) ? 0.5 : 8)
    {
        domain.low = {-0.3*spread, 0, 2};
        domain.high = domain.low + vector3{spread, 1.3*spread, 0.7*spread};
        for (int k = 0; k < 3; ++k)
        {
            domain.periodic[k] = (kind >> k) & 1 && !(k == 2 && twoD);
        }
        for (int i = 0; i < n; ++i)
        {
            all.push_back(box(kind, rnd));
        }
    }

    sweptBox box(int kind, counterRandom& rnd) const
    {
        sweptBox b;
        const double size = (kind & 16)
            ? std::pow(10., -3*rnd.uniform()) : 0.2 + 0.3*rnd.uniform();
        const bool far = (kind & 32) && rnd.uniform() < 0.02;
        for (int k = 0; k < 3; ++k)
        {
            const double u = rnd.uniform(), e = size*rnd.uniform();
            double c = domain.low[k] + u*(domain.high[k] - domain.low[k]);
            if (far && !domain.periodic[k])
            {
                c *= 1e6;
            }
            if (twoD && k == 2)
            {
                c = 0;
            }
            b.low[k] = c - 0.5*e;
            b.high[k] = c + 0.5*e;
        }
        return b;
    }

    //- What single precision may round coordinates by
    double rounding() const
    {
        double span = 0;
        for (int k = 0; k < 3; ++k)
        {
            double least = domain.low[k], most = domain.high[k];
            for (const sweptBox& b : all)
            {
                least = std::min(least, b.low[k]);
                most = std::max(most, b.high[k]);
            }
            span = std::max(span, most - least);
        }
        return 5e-7*span;
    }

    //- Images of j that overlap i, or miss it by no more than a margin
    void images
    (
        int i,
        int j,
        std::set<imagePair>& found,
        double margin = 0
    ) const
    {
        // Axis by axis, more images than any box reaches
        const vector3 L = domain.period();
        std::vector<int> shifts[3];
        for (int k = 0; k < 3; ++k)
        {
            const int reach = domain.periodic[k] ? 12 : 0;
            for (int m = -reach; m <= reach; ++m)
            {
                if
                (
                    all[i].low[k] - m*L[k] <= all[j].high[k] + margin
                 && all[j].low[k] <= all[i].high[k] - m*L[k] + margin
                )
                {
                    shifts[k].push_back(m);
                }
            }
        }
        for (int x : shifts[0])
        {
            for (int y : shifts[1])
            {
                for (int z : shifts[2])
                {
                    found.insert(ordered(i, j, x, y, z));
                }
            }
        }
    }

    static imagePair ordered(int i, int j, int x, int y, int z)
    {
        return i < j
          ? imagePair(i, j, x, y, z) : imagePair(j, i, -x, -y, -z);
    }
};


imagePair unpacked(int i, int j, std::int32_t image)
{
    return boxes::ordered
    (
        i, j, (image & 1023) - 512, ((image >> 10) & 1023) - 512,
        ((image >> 20) & 1023) - 512
    );
}

} // End anonymous namespace


TEST(sweptGrid, findsEveryOverlapOnce)
{
    std::size_t total = 0;
    int exact = 0;
    for (int kind = 0; kind < 128; ++kind)
    {
        counterRandom rnd(31, kind);
        const int n = kind % 5 == 0 ? 3 : 200;
        boxes b(kind, n, rnd);
        sweptGrid grid(b.domain);
        grid.resize(n);
        for (int i = 0; i < n; ++i)
        {
            grid.box(i) = b.all[i];
        }
        grid.build();

        const auto within = [](const auto& some, const auto& all)
        {
            return std::includes
                (all.begin(), all.end(), some.begin(), some.end());
        };
        const double margin = b.rounding();
        std::set<imagePair> expected, allowed, found;
        for (int i = 0; i < n; ++i)
        {
            for (int j = i + 1; j < n; ++j)
            {
                b.images(i, j, expected);
                b.images(i, j, allowed, margin);
            }
        }
        bool twice = false;
        grid.pairs([&](int i, int j, std::int32_t image)
        {
            twice = !found.insert(unpacked(i, j, image)).second || twice;
        });
        EXPECT_TRUE(within(expected, found)) << kind;
        EXPECT_TRUE(within(found, allowed)) << kind;
        exact += found == expected;
        EXPECT_FALSE(twice) << kind;
        total += expected.size();

        // Move some, also far and large, and take some away
        std::vector<bool> gone(n, false);
        for (int m = 0; m < n; ++m)
        {
            const int i = int(rnd.uniform()*n);
            if (gone[i])
            {
                continue;
            }
            if (m % 7 == 0)
            {
                gone[i] = true;
                grid.remove(i);
                continue;
            }
            b.all[i] = b.box(kind, rnd);
            if (m % 11 == 0 && !b.twoD)
            {
                b.all[i].low[m % 3] -= 1.5;
                b.all[i].high[m % 3] += 1.5;
            }
            grid.move(i, b.all[i]);
            std::set<imagePair> around, near, seen;
            const double farther = b.rounding();
            for (int j = 0; j < n; ++j)
            {
                if (j != i && !gone[j])
                {
                    b.images(i, j, around);
                    b.images(i, j, near, std::max(margin, farther));
                }
            }
            grid.neighbours(i, [&](int j, std::int32_t image)
            {
                EXPECT_TRUE(seen.insert(unpacked(i, j, image)).second);
            });
            EXPECT_TRUE(within(around, seen)) << kind << ' ' << m;
            EXPECT_TRUE(within(seen, near)) << kind << ' ' << m;
        }
    }
    EXPECT_GT(total, 10000u);

    // Without boxes far away that there is nothing to round
    EXPECT_GE(exact, 64);
}


TEST(sweptGrid, refusesWhatIsNotFinite)
{
    collisionDomain d;
    d.periodic[1] = true;
    EXPECT_THROW(sweptGrid{d}, std::invalid_argument);
    d.high.y = -1;
    EXPECT_THROW(sweptGrid{d}, std::invalid_argument);
    d.high.y = 1;
    sweptGrid grid(d);
    grid.resize(1);
    grid.box(0) = {{0, 0, 0}, {1, 1, 1}};
    grid.build();
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_THROW
        (grid.move(0, {{0, 0, 0}, {infinite, 1, 1}}), std::invalid_argument);
    EXPECT_THROW
        (grid.move(0, {{0, 0, 0}, {1, 101, 1}}), std::invalid_argument);
    grid.box(0) = {{0, 0, 0}, {infinite, 1, 1}};
    EXPECT_THROW(grid.build(), std::invalid_argument);
}


TEST(eventQueue, givesEventsBackInTheirOrder)
{
    const auto before = [](const collisionEvent& a, const collisionEvent& b)
    {
        return a.time != b.time ? a.time < b.time : a.first < b.first;
    };
    eventQueue queue;
    for (int run = 0; run < 40; ++run)
    {
        counterRandom rnd(32, run);
        const int n = run % 4 == 0 ? 5 : 3000;
        const double end = run % 3 == 0 ? 1e-300 : run % 3 == 1 ? 1 : 1e5;
        queue.reset(0, end, run % 2 ? n : 16);

        // Most at the start, the rest while others are taken, some at the
        // same instant, some at the end
        auto before2 = [&](const collisionEvent& a, const collisionEvent& b)
        {
            return before(a, b);
        };
        std::set<collisionEvent, decltype(before2)> expected(before2);
        int number = 0;
        auto push = [&](double from)
        {
            double t = from + (end - from)*rnd.uniform();
            if (number % 10 == 0)
            {
                t = from;
            }
            if (number % 17 == 0)
            {
                t = end;
            }
            const collisionEvent e = {t, number++, 0, 0, 0, 0};
            queue.push(e, before);
            expected.insert(e);
        };
        for (int i = 0; i < n; ++i)
        {
            push(0);
        }
        int taken = 0;
        while (const collisionEvent* top = queue.top(before))
        {
            const collisionEvent e = *top;
            queue.discard(before);
            ASSERT_FALSE(expected.empty());
            EXPECT_EQ(e.first, expected.begin()->first);
            EXPECT_EQ(e.time, expected.begin()->time);
            expected.erase(expected.begin());
            if (++taken < n && taken % 2 == 0)
            {
                push(e.time);
            }
        }
        EXPECT_TRUE(expected.empty());
    }
}
