/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The events of a step against those of a search over all pairs, walls and
    changing paths included, and against another order of the particles.
\*---------------------------------------------------------------------------*/

#include "collisionStep.H"
#include "counterRandom.H"
#include "loneHost.H"
#include "pairLaw.H"
#include "planeWalls.H"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace impact;

namespace
{

struct happening
{
    double time;
    std::int64_t first, second;     // identities, second -1 for a wall
};


//- Spheres in a carrier that pulls at each of them differently after every
//  event, as a cloud's drag does: the path is a parabola with an
//  acceleration that depends on the velocity. A floor at z = 0 reflects,
//  spheres above a lid are taken away
template<class PathType>
struct balls
:
    loneHost
{
    typedef PathType Path;

    struct ball
    {
        std::uint64_t identity;
        double r, m;
        Path path;
        bool gone;
    };

    std::vector<ball> all;
    collisionDomain domain;
    pairLaw law = pairLaw(0.8, 0.3, false);
    bool floor = false;
    int images = 2;                 // on each side, that brute force sees
    double lid = never;
    std::vector<happening> happenings;

    static void pull(parabolicPath& p)
    {
        p.a = -0.7*(p.v - vector3{0.4, -0.1, 0.8});
    }

    static void pull(straightPath&)
    {}

    balls(int n, int seed, bool polydisperse, bool twoD, double spread)
    {
        domain.high = {spread, spread, twoD ? 1 : spread};
        counterRandom rnd(41, seed);
        while (int(all.size()) < n)
        {
            ball b;
            b.identity = (all.size()*7919) % 1000003;
            b.r = polydisperse
                ? 0.5*std::pow(10., -2*rnd.uniform()) : 0.25;
            b.m = b.r*b.r*b.r;
            b.path = Path();
            b.path.start = 0;
            for (int k = 0; k < (twoD ? 2 : 3); ++k)
            {
                b.path.x[k] = spread*rnd.uniform();
                b.path.v[k] = rnd.normal();
            }
            pull(b.path);
            b.gone = false;
            bool clear = true;
            for (const ball& o : all)
            {
                vector3 d = o.path.x - b.path.x;
                for (int k = 0; k < 3; ++k)
                {
                    d[k] -= spread*std::round(d[k]/spread);
                }
                clear = clear && mag(d) > o.r + b.r;
            }
            if (clear)
            {
                all.push_back(b);
            }
        }
    }

    void at(ball& b, double t)
    {
        const vector3 x = b.path.position(t), v = b.path.velocity(t);
        b.path.x = x;
        b.path.v = v;
        b.path.start = t;
    }

    std::size_t size() const
    {
        return all.size();
    }
    std::uint64_t identity(int i) const
    {
        return all[i].identity;
    }
    double radius(int i) const
    {
        return all[i].r;
    }
    Path path(int i) const
    {
        return all[i].path;
    }
    double wallTime(int i, double from, double end) const
    {
        const ball& b = all[i];
        double t = never;
        if (floor)
        {
            t = planeContact
            (
                b.path.x.z, b.path.v.z, b.path.acceleration().z, b.r,
                end - from, {1e-14, 1e-14}
            );
        }
        if (lid < never)
        {
            t = std::min
            (
                t,
                planeContact
                (
                    lid - b.path.x.z, -b.path.v.z,
                    -b.path.acceleration().z, 0, end - from, {1e-14, 1e-14}
                )
            );
        }
        return from + t;
    }
    void collide(int i, int j, const vector3& s, double t)
    {
        ball& a = all[i];
        ball& b = all[j];
        EXPECT_LT(a.identity, b.identity);
        EXPECT_NEAR(mag(s), a.r + b.r, 1e-11);
        at(a, t);
        at(b, t);
        const vector3 zero = {0, 0, 0};
        const pairCollision out = law.collide
        (
            {a.path.v, zero, a.m, a.r}, {b.path.v, zero, b.m, b.r},
            (1/mag(s))*s
        );
        a.path.v = out.v1;
        b.path.v = out.v2;
        pull(a.path);
        pull(b.path);
        happenings.push_back
            ({t, std::int64_t(a.identity), std::int64_t(b.identity)});
    }
    bool hitWall(int i, double t)
    {
        ball& b = all[i];
        at(b, t);
        happenings.push_back({t, std::int64_t(b.identity), -1});
        if (b.path.x.z > 0.5*lid)
        {
            b.gone = true;
            return false;
        }
        b.path.v.z *= -0.9;
        pull(b.path);
        return true;
    }

    //- First contact of a pair over all images that may matter
    double contact(int i, int j, double end, vector3& separation) const
    {
        const Path& p = all[i].path;
        const Path& q = all[j].path;
        const double from = std::max(p.start, q.start);
        double first = never;
        int reach[3];
        for (int k = 0; k < 3; ++k)
        {
            reach[k] = domain.periodic[k] ? images : 0;
        }
        for (int x = -reach[0]; x <= reach[0]; ++x)
        {
            for (int y = -reach[1]; y <= reach[1]; ++y)
            {
                for (int z = -reach[2]; z <= reach[2]; ++z)
                {
                    const vector3 L = domain.period();
                    const vector3 shift = {x*L.x, y*L.y, z*L.z};
                    const double t = from + parabolicContact
                    (
                        q.position(from) + shift - p.position(from),
                        q.velocity(from) - p.velocity(from),
                        q.acceleration() - p.acceleration(),
                        all[i].r + all[j].r, end - from, {1e-13, 1e-13}
                    );
                    if (t < first)
                    {
                        first = t;
                        separation = q.position(t) + shift - p.position(t);
                    }
                }
            }
        }
        return first;
    }

    //- The same events from a table of all pairs
    void bruteForce(double end)
    {
        const int n = int(all.size());
        std::vector<double> times(n*n, never), walls(n, never);
        std::vector<vector3> separations(n*n);
        auto renew = [&](int i)
        {
            walls[i] =
                all[i].gone ? never : wallTime(i, all[i].path.start, end);
            for (int j = 0; j < n; ++j)
            {
                // From the lower identity to the higher
                const bool turn = all[j].identity < all[i].identity;
                const int a = turn ? j : i, b = turn ? i : j;
                if (a != b)
                {
                    times[a*n + b] = all[a].gone || all[b].gone
                      ? never : contact(a, b, end, separations[a*n + b]);
                }
            }
        };
        for (int i = 0; i < n; ++i)
        {
            renew(i);
        }
        while (true)
        {
            const int pair = int
                (std::min_element(times.begin(), times.end()) - times.begin());
            const int i = int
                (std::min_element(walls.begin(), walls.end()) - walls.begin());
            if (std::min(times[pair], walls[i]) > end)
            {
                return;
            }
            if (walls[i] < times[pair])
            {
                hitWall(i, walls[i]);
                renew(i);
                continue;
            }
            const int a = pair/n, b = pair % n;
            collide(a, b, separations[pair], times[pair]);
            renew(a);
            renew(b);
        }
    }

    void finish(double end)
    {
        for (ball& b : all)
        {
            if (!b.gone)
            {
                at(b, end);
                b.path.start = 0;
            }
        }
    }

    bool gone() const
    {
        return std::any_of
            (all.begin(), all.end(), [](const ball& b) { return b.gone; });
    }
};


template<class Path>
void compare
(
    int seed,
    bool polydisperse,
    bool twoD,
    int periodic,
    bool walls,
    double end,
    std::size_t atLeast,
    double speed = 1
)
{
    balls<Path> gas(200, seed, polydisperse, twoD, twoD ? 11 : 5);
    for (auto& b : gas.all)
    {
        b.r /= speed;
        b.path.v = speed*b.path.v;
        gas.pull(b.path);
    }
    gas.images = speed > 1 ? 5 : 2;
    for (int k = 0; k < 3; ++k)
    {
        gas.domain.periodic[k] = (periodic >> k) & 1;
    }
    if (walls)
    {
        for (auto& b : gas.all)
        {
            b.path.x.z += 0.5;
        }
        gas.floor = true;
        gas.lid = 6.5;
    }
    balls<Path> reference = gas;
    collisionStep<balls<Path>> step(gas.domain);
    const collisionCounts counts = step.run(gas, end);
    gas.finish(end);
    reference.bruteForce(end);
    reference.finish(end);

    if (speed > 1)
    {
        EXPECT_GT(counts.slices, 1u);
    }
    ASSERT_GE(gas.happenings.size(), atLeast);
    ASSERT_EQ(gas.happenings.size(), reference.happenings.size());
    EXPECT_EQ(counts.pairEvents + counts.wallEvents, gas.happenings.size());
    for (std::size_t k = 0; k < gas.happenings.size(); ++k)
    {
        const happening& a = gas.happenings[k];
        const happening& b = reference.happenings[k];
        ASSERT_EQ(a.first, b.first) << k;
        ASSERT_EQ(a.second, b.second) << k;
        ASSERT_NEAR(a.time, b.time, 1e-9) << k;
    }
    for (std::size_t i = 0; i < gas.all.size(); ++i)
    {
        EXPECT_EQ(gas.all[i].gone, reference.all[i].gone);
        if (!gas.all[i].gone)
        {
            EXPECT_LT
            (
                mag(gas.all[i].path.x - reference.all[i].path.x), 1e-8
            );
        }
    }
    if (walls)
    {
        EXPECT_TRUE(gas.gone());
        EXPECT_GT(counts.wallEvents, 10u);
    }
}

} // End anonymous namespace


TEST(collisionStep, missesNoEventOfStraightPaths)
{
    compare<straightPath>(1, false, false, 0, false, 0.5, 40);
    compare<straightPath>(2, false, false, 7, false, 0.5, 60);
    compare<straightPath>(3, true, false, 5, false, 1, 40);
    compare<straightPath>(4, false, true, 3, false, 1, 60);
    compare<straightPath>(5, false, false, 3, true, 1, 100);
}


TEST(collisionStep, missesNoEventOfParabolicPaths)
{
    compare<parabolicPath>(1, false, false, 0, false, 1, 20);
    compare<parabolicPath>(2, false, false, 7, false, 1, 60);
    compare<parabolicPath>(3, true, false, 3, false, 1, 20);
    compare<parabolicPath>(4, false, true, 3, false, 1, 60);
    compare<parabolicPath>(5, false, false, 3, true, 1, 60);
}


TEST(collisionStep, missesNoEventOfACrowdSearchedInSlices)
{
    compare<straightPath>(1, false, true, 3, false, 0.4, 30, 10);
    compare<straightPath>(2, true, true, 0, false, 0.8, 10, 10);
    compare<straightPath>(3, false, false, 3, true, 0.4, 80, 10);
    compare<parabolicPath>(4, false, true, 3, false, 0.4, 30, 10);
    compare<parabolicPath>(5, false, false, 7, false, 0.5, 5, 10);
    compare<parabolicPath>(6, true, false, 3, true, 0.4, 60, 10);
}


TEST(collisionStep, doesNotDependOnTheOrderOfTheParticles)
{
    balls<parabolicPath> gas(300, 6, true, false, 5);
    gas.floor = true;
    for (auto& b : gas.all)
    {
        b.path.x.z += 0.5;
    }
    balls<parabolicPath> other = gas;
    counterRandom rnd(42);
    for (std::size_t i = other.all.size() - 1; i > 0; --i)
    {
        std::swap
            (other.all[i], other.all[std::size_t(rnd.uniform()*(i + 1))]);
    }
    collisionStep<balls<parabolicPath>> a(gas.domain), b(gas.domain);
    for (int k = 0; k < 10; ++k)
    {
        a.run(gas, 0.2);
        b.run(other, 0.2);
        gas.finish(0.2);
        other.finish(0.2);
    }
    auto byIdentity = [](const auto& p, const auto& q)
    {
        return p.identity < q.identity;
    };
    std::sort(gas.all.begin(), gas.all.end(), byIdentity);
    std::sort(other.all.begin(), other.all.end(), byIdentity);
    EXPECT_GT(gas.happenings.size(), 100u);
    ASSERT_EQ(gas.happenings.size(), other.happenings.size());
    for (std::size_t i = 0; i < gas.all.size(); ++i)
    {
        for (int k = 0; k < 3; ++k)
        {
            EXPECT_EQ(gas.all[i].path.x[k], other.all[i].path.x[k]);
            EXPECT_EQ(gas.all[i].path.v[k], other.all[i].path.v[k]);
        }
    }
}


TEST(collisionStep, takesMoreParticlesAndNewPathsBeforeItsSlices)
{
    balls<straightPath> gas(200, 5, false, false, 5);
    gas.domain.periodic[0] = true;
    balls<straightPath> parts = gas;
    const double end = 0.5;
    collisionStep<balls<straightPath>> a(gas.domain), b(gas.domain);
    a.run(gas, end);

    // Half of them come later, the others fly another way until then
    const auto half = parts.all.begin() + 100;
    const auto later = std::vector<balls<straightPath>::ball>
        (half, parts.all.end());
    parts.all.erase(half, parts.all.end());
    const auto first = parts.all;
    for (auto& ball : parts.all)
    {
        ball.path.x.y += 2.5;
        ball.path.v = {0, 0, 20};
    }
    b.begin(parts, end);
    EXPECT_NEAR(b.swept(7).extent(), 20*end + 2*parts.all[7].r, 1e-9);
    parts.all = first;
    for (int i = 0; i < 100; ++i)
    {
        b.take(i);
    }
    parts.all.insert(parts.all.end(), later.begin(), later.end());
    b.takeMore();
    const int nSlices = b.slices();
    for (int k = 0; k < nSlices; ++k)
    {
        b.beginSlice(parts, k, nSlices);
        collisionEvent e;
        while (b.next(e))
        {
            b.happen(parts, e);
        }
    }
    EXPECT_GT(gas.happenings.size(), 50u);
    ASSERT_EQ(gas.happenings.size(), parts.happenings.size());
    for (std::size_t k = 0; k < gas.happenings.size(); ++k)
    {
        EXPECT_EQ(gas.happenings[k].time, parts.happenings[k].time);
        EXPECT_EQ(gas.happenings[k].first, parts.happenings[k].first);
        EXPECT_EQ(gas.happenings[k].second, parts.happenings[k].second);
    }
}


TEST(collisionStep, ordersEventsOfOneInstantByIdentity)
{
    // Two spheres hit a third from both sides at the same instant
    for (bool swap : {false, true})
    {
        balls<straightPath> gas(0, 0, false, false, 5);
        const double x[3] = {-2, 0, 2};
        for (int i = 0; i < 3; ++i)
        {
            gas.all.push_back
            ({
                std::uint64_t(10 + i), 0.5, 1,
                {{x[i], 0, 0}, {-x[i]/2, 0, 0}, 0}, false
            });
        }
        if (swap)
        {
            std::reverse(gas.all.begin(), gas.all.end());
        }
        gas.law = pairLaw(1, 0);
        collisionStep<balls<straightPath>> step;
        step.run(gas, 10);

        // 10-11 first; the momentum then passes through 12 and back
        ASSERT_EQ(gas.happenings.size(), 3u);
        for (const happening& h : gas.happenings)
        {
            EXPECT_EQ(h.time, 1);
        }
        EXPECT_EQ(gas.happenings[0].first, 10);
        EXPECT_EQ(gas.happenings[1].first, 11);
        EXPECT_EQ(gas.happenings[1].second, 12);
        EXPECT_EQ(gas.happenings[2].first, 10);
    }
}


TEST(collisionStep, endsAStepThatWouldNotEnd)
{
    // A light sphere between the floor and a heavy one coming down: 3141
    // events before the heavy one has turned
    balls<straightPath> gas(0, 0, false, false, 5);
    gas.all.push_back({1, 1, 1, {{0, 0, 1.5}, {0, 0, 0}, 0}, false});
    gas.all.push_back({2, 1, 1e6, {{0, 0, 5}, {0, 0, -1}, 0}, false});
    gas.floor = true;
    gas.law = pairLaw(1, 0);
    collisionStep<balls<straightPath>> step
        ({}, contactDuration(), 1000);
    EXPECT_THROW(step.run(gas, 1e3), std::runtime_error);
}


TEST(collisionStep, boundsTheEventsOfPairsThatAreHeldTogether)
{
    // A constant pull towards each other, from contact at rest, a little
    // apart, and overlapping: four to eight events in a contact duration,
    // and no sinking in beyond what is stated. The acceleration of the pair
    // is that of either sphere, or a hundredth of it
    struct held : balls<parabolicPath>
    {
        held()
        :
            balls<parabolicPath>(0, 0, false, false, 5)
        {}

        void collide(int i, int j, const vector3& s, double t)
        {
            at(all[i], t);
            at(all[j], t);
            const vector3 zero = {0, 0, 0};
            const pairCollision out = law.collide
            (
                {all[i].path.v, zero, 1, 0.5}, {all[j].path.v, zero, 1, 0.5},
                (1/mag(s))*s, true
            );
            all[i].path.v = out.v1;
            all[j].path.v = out.v2;
            happenings.push_back({t, i, j});
        }
    };
    const double tc = 1e-3, a = 10, end = 0.5;
    for (double gap : {0., 1e-9, -1e-9, -1e-3})
    {
        for (double common : {0., 99.})
        {
            held pair;
            for (int i = 0; i < 2; ++i)
            {
                pair.all.push_back
                ({
                    std::uint64_t(i), 0.5, 1,
                    {
                        {i*(1 + gap), 0, 0}, {0, 0, 0},
                        {common*a + (i ? -a : a), 0, 0}, 0
                    },
                    false
                });
            }
            collisionStep<held> step({}, contactDuration(tc));
            const collisionCounts counts = step.run(pair, end);
            pair.finish(end);
            const double total = (common > 0 ? 2*common : 2)*a;
            const double depth = 0.04*total*tc*tc + std::max(0., -gap);
            EXPECT_LT(counts.pairEvents, 9*end/tc);
            EXPECT_GT
            (
                pair.all[1].path.x.x - pair.all[0].path.x.x, 1 - 1.001*depth
            );
            EXPECT_LT(counts.deepestOverlap, 1.001*depth);
        }
    }
}


TEST(collisionStep, refusesBadInput)
{
    typedef collisionStep<balls<straightPath>> stepType;
    balls<straightPath> gas(3, 0, false, false, 5);
    stepType step;
    EXPECT_THROW(step.run(gas, -1), std::invalid_argument);
    EXPECT_THROW(step.run(gas, never), std::invalid_argument);
    gas.all[1].path.x.x = never;
    EXPECT_THROW(step.run(gas, 1), std::invalid_argument);
}
