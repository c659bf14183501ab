/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Single visits of a wall, keyed by impact: the exact rebound of a sphere,
    the distributions of scatteringSampler, similarity of sizes, the frame of
    the wall, keys, extremes.
\*---------------------------------------------------------------------------*/

#include "nonSphericalRebound.H"
#include "scatteringSampler.H"
#include "counterRandom.H"

#include <gtest/gtest.h>
#include <cmath>
#include <set>
#include <stdexcept>

using namespace impact;

namespace
{

constexpr double degree = 3.14159265358979323846/180;


scatteringSampler::setup rough(const convexBody& body)
{
    scatteringSampler::setup s;
    s.body = body;
    s.wall = std::make_shared<const relief>
    (
        relief::rough(80e-6, 10e-6, 20e-6)
    );
    return s;
}


impactKey key(int i)
{
    return impactKey::ofTime(1, 0, i, 1, 0, 0);
}


vector3 arrival(double incidence, double speed)
{
    return
    {
        speed*std::cos(incidence*degree), -speed*std::sin(incidence*degree), 0
    };
}


//- Counts of alpha2 in bins of 6 degrees from -180 to 180
std::vector<double> histogram
(
    const scatteringSampler::setup& s,
    const vector3& V,
    const vector3& omega,
    int n
)
{
    nonSphericalRebound wall(s);
    std::vector<double> counts(60);
    for (int i = 0; i < n; ++i)
    {
        const wallDeparture d = wall.depart(V, omega, wall.diameter(), key(i));
        const double alpha = std::atan2(d.V.y, d.V.x)/degree;
        ++counts[std::min(59, int((alpha + 180)/6))];
    }
    return counts;
}


std::vector<double> reference(const scatteringSampler::setup& s, int n)
{
    std::vector<double> counts(60);
    const scatteringSampler sampler(s);
    for (const visitResult& r : sampler.visits(0, n))
    {
        const double alpha = std::atan2(r.state.V.y, r.state.V.x)/degree;
        ++counts[std::min(59, int((alpha + 180)/6))];
    }
    return counts;
}


//- Chi squared of two histograms less its number of bins, over its deviation
double excess(const std::vector<double>& a, const std::vector<double>& b)
{
    double na = 0, nb = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        na += a[i];
        nb += b[i];
    }
    double sum = 0, dof = -1;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        const double both = a[i] + b[i];
        if (both > 20)
        {
            const double x = a[i]*nb - b[i]*na;
            sum += x*x/(na*nb*both);
            ++dof;
        }
    }
    return (sum - dof)/std::sqrt(2*dof);
}

} // End anonymous namespace


TEST(nonSphericalRebound, sphereOnASmoothWallIsExact)
{
    scatteringSampler::setup s;
    s.body = convexBody::sphere(32e-6);
    s.law = reboundLaw::restitution(0.8, 0);
    nonSphericalRebound wall(s);
    for (const double incidence : {1e-6, 1., 15., 45., 89., 90.})
    {
        const vector3 V = arrival(incidence, 200);
        const wallDeparture d = wall.depart(V, {0, 0, 0}, 10e-6, key(1));
        EXPECT_NEAR(d.V.x, 5*V.x/7, 1e-10);
        EXPECT_NEAR(d.V.y, -0.8*V.y, 1e-10);
        EXPECT_NEAR(d.V.z, 0, 1e-10);

        // Rolling: for the particle's own radius
        EXPECT_NEAR(d.omega.z*5e-6, -d.V.x, 1e-9);
        EXPECT_EQ(d.impacts, 1);
        EXPECT_NEAR
        (
            d.rotation1, 0.2*std::pow(5e-6*d.omega.z, 2), 1e-9*200*200
        );
    }
}


TEST(nonSphericalRebound, withoutRestitutionASphereSlidesAlongAPlane)
{
    scatteringSampler::setup s;
    s.body = convexBody::sphere(32e-6);
    s.law = reboundLaw::coulomb(0, 0.1);
    nonSphericalRebound wall(s);
    for (int i = 0; i < 2000; ++i)
    {
        // (2000 searches along the whole wall would take minutes)
        const vector3 V = arrival(15 + 0.01*i, 200);
        const wallDeparture d = wall.depart(V, {0, 0, 0}, 10e-6, key(i));
        EXPECT_NEAR(d.V.x, V.x + 0.1*V.y, 1e-10);
        EXPECT_NEAR(d.V.y, 0, 1e-10);
        EXPECT_NEAR(d.omega.z*5e-6, 2.5*0.1*V.y, 1e-9);
        EXPECT_TRUE(d.capped);
    }
}


TEST(nonSphericalRebound, scattersAsTheSamplerDoes)
{
    const vector3 size = {32e-6, 25.6e-6, 25.6e-6};
    const int n = 20000;
    for
    (
        const convexBody& body
      : {
            convexBody::ellipsoid(size), convexBody::box(size),
            convexBody::truncatedBox({32e-6, 19.2e-6, 25.6e-6}, 0.25)
        }
    )
    {
        scatteringSampler::setup s = rough(body);
        s.speed = 200;
        for (const double incidence : {5., 15., 60.})
        {
            s.incidence = incidence;
            EXPECT_LT
            (
                excess
                (
                    histogram(s, arrival(incidence, 200), s.spin, n),
                    reference(s, n)
                ),
                5
            ) << "rough, " << incidence;
        }

        // Another incidence is told apart, and so is another law
        s.incidence = 25;
        EXPECT_GT
        (
            excess(histogram(s, arrival(15, 200), s.spin, n), reference(s, n)),
            10
        );

        s.incidence = 15;
        s.wall = nullptr;
        s.orientation = orientationLaw::uniformEuler;
        s.spin = {0, 0, -2e6};
        EXPECT_LT
        (
            excess(histogram(s, arrival(15, 200), s.spin, n), reference(s, n)),
            5
        ) << "smooth";
        s.wall = std::make_shared<const relief>
        (
            relief::sinusoidal(20e-6, 160e-6)
        );
        s.treatment = visitTreatment::firstImpact;
        EXPECT_LT
        (
            excess(histogram(s, arrival(15, 200), s.spin, n), reference(s, n)),
            5
        ) << "sinusoidal";
    }
}


TEST(nonSphericalRebound, isTheSameFromBothSides)
{
    const scatteringSampler::setup s =
        rough(convexBody::box({3e-5, 2e-5, 2e-5}));
    nonSphericalRebound wall(s);
    for (int i = 0; i < 200; ++i)
    {
        const auto a =
            wall.depart({80, -30, 20}, {1e6, 2e6, -3e6}, 2e-5, key(i));
        const auto b =
            wall.depart({-80, -30, -20}, {-1e6, 2e6, 3e6}, 2e-5, key(i));
        EXPECT_EQ(a.V.x, -b.V.x);
        EXPECT_EQ(a.V.y, b.V.y);
        EXPECT_EQ(a.V.z, -b.V.z);
        EXPECT_EQ(a.omega.y, b.omega.y);
        EXPECT_EQ(a.omega.z, -b.omega.z);
    }
}


TEST(nonSphericalRebound, scalesTheBodyToTheParticle)
{
    // A particle twice as large on a relief twice as coarse, spin half
    for (int profile = 0; profile < 2; ++profile)
    {
        scatteringSampler::setup small =
            rough(convexBody::box({3e-5, 2e-5, 2.5e-5}));
        scatteringSampler::setup large = small;
        if (profile)
        {
            small.wall = std::make_shared<const relief>
            (
                relief::sinusoidal(10e-6, 90e-6)
            );
            large.wall = std::make_shared<const relief>
            (
                relief::sinusoidal(20e-6, 180e-6)
            );
        }
        else
        {
            large.wall = std::make_shared<const relief>
            (
                relief::rough(160e-6, 20e-6, 40e-6)
            );
        }
        nonSphericalRebound a(small), b(large);
        EXPECT_NEAR(a.diameter(), std::cbrt(6*1.5e-14/(180*degree)), 1e-19);
        int same = 0;
        for (int i = 0; i < 200; ++i)
        {
            const auto x =
                a.depart({80, -30, 9}, {1e6, 2e6, -3e6}, 2e-5, key(i));
            const auto y =
                b.depart({80, -30, 9}, {5e5, 1e6, -1.5e6}, 4e-5, key(i));
            // Some visits of many impacts part by round-off
            same +=
                mag(x.V - y.V) < 1e-4 && mag(x.omega - 2*y.omega) < 1e2;
        }
        EXPECT_GT(same, 190);
    }
}


//- Largest energy after one of many visits over that before it, and the last
//  over the first
std::pair<double, double> energies(const scatteringSampler::setup& s)
{
    nonSphericalRebound wall(s);
    const double d = wall.diameter();
    vector3 V = {80, -30, 9}, omega = {0, 0, 0};
    const auto energy = [&]
    {
        return translationalEnergy(V) + sphereRotationalEnergy(0.5*d, omega);
    };
    const double first = energy();
    double largest = 0;
    for (int i = 0; i < 200; ++i)
    {
        const double before = energy();
        const wallDeparture x = wall.depart(V, omega, d, key(i));
        V = x.V;
        V.y = -std::max(V.y, 1e-6*mag(V));
        omega = x.omega;
        largest = std::max(largest, energy()/before);
    }
    return {largest, energy()/first};
}


TEST(nonSphericalRebound, gainsNoEnergyBetweenVisits)
{
    for (const vector3& size :
        {vector3{1e-4, 1e-5, 1e-5}, vector3{1e-4, 1e-4, 1e-5},
         vector3{6.4e-5, 2.56e-5, 1e-5}})
    {
        for (const bool box : {true, false})
        {
            scatteringSampler::setup s;
            s.body = box ? convexBody::box(size) : convexBody::ellipsoid(size);
            s.law = reboundLaw::coulomb(1, 0);
            const auto kept = energies(s);
            EXPECT_NEAR(kept.first, 1, 1e-9);
            EXPECT_NEAR(kept.second, 1, 1e-9);

            s.law = reboundLaw::coulomb(0.8, 0.3);
            const auto lost = energies(s);
            EXPECT_LT(lost.first, 1 + 1e-9);
            EXPECT_LT(lost.second, 0.1);
        }
    }
}


TEST(nonSphericalRebound, dependsOnTheKeyAlone)
{
    const scatteringSampler::setup s =
        rough(convexBody::ellipsoid({3e-5, 2e-5, 2e-5}));
    nonSphericalRebound wall(s);
    const vector3 V = {80, -30, 0};
    std::vector<wallDeparture> first;
    for (int i = 0; i < 50; ++i)
    {
        first.push_back(wall.depart(V, {0, 0, 0}, 2e-5, key(i)));
    }
    nonSphericalRebound copy(wall);
    for (int i = 49; i >= 0; --i)
    {
        copy.depart({1, -9, 1}, {0, 0, 1e5}, 3e-5, key(1000 + i));
        const wallDeparture d = copy.depart(V, {0, 0, 0}, 2e-5, key(i));
        EXPECT_EQ(d.V.x, first[i].V.x);
        EXPECT_EQ(d.V.y, first[i].V.y);
        EXPECT_EQ(d.omega.z, first[i].omega.z);
        EXPECT_TRUE(i == 0 || d.V.x != first[i - 1].V.x);
    }
}


TEST(nonSphericalRebound, survivesExtremes)
{
    for (const bool isRough : {true, false})
    {
        scatteringSampler::setup s =
            rough(convexBody::box({3e-5, 2e-5, 2e-5}));
        if (!isRough)
        {
            s.wall = nullptr;
        }
        nonSphericalRebound wall(s);
        int capped = 0, raised = 0;
        for (int i = 0; i < 20; ++i)
        {
            for (const double incidence : {1e-9/degree, 0.005, 90.})
            {
                const wallDeparture d = wall.depart
                (
                    arrival(incidence, 200), {0, 0, 0}, 2e-5, key(i)
                );
                EXPECT_TRUE(std::isfinite(mag(d.V) + mag(d.omega)));
                EXPECT_GE(d.V.y, 0);
                raised += d.raised;
                capped += d.capped;
            }
            const wallDeparture d = wall.depart
            (
                {100, -100, 0}, {1e9, -1e9, 1e9}, 1e-6, key(i)
            );
            EXPECT_TRUE(std::isfinite(mag(d.V) + mag(d.omega)));
        }
        EXPECT_EQ(raised, isRough ? 40 : 0);
        EXPECT_LE(capped, 3);
    }

    // However slowly it comes down, it meets a relief that repeats
    std::vector<double> x(1000), y(1000);
    for (int i = 0; i < 1000; ++i)
    {
        x[i] = 10e-6*i;
        y[i] = 10e-6*std::sin(1.7*i) + 5e-6*std::sin(0.37*i*i);
    }
    for (const relief& wall :
        {relief::profile(x, y), relief::sinusoidal(10e-6, 200e-6)})
    {
        scatteringSampler::setup s =
            rough(convexBody::box({4e-5, 3e-5, 3e-5}));
        s.law = reboundLaw::coulomb(0.8, 0.3);
        s.wall = std::make_shared<const relief>(wall);
        nonSphericalRebound law(s);
        for (const double incidence : {1e-6, 180 - 1e-6})
        {
            const wallDeparture d = law.depart
            (
                arrival(incidence, 100), {0, 0, 0}, law.diameter(), key(3)
            );
            EXPECT_TRUE(d.raised);
            EXPECT_FALSE(d.capped);
            EXPECT_GT(d.impacts, 0);
            EXPECT_GT(d.V.y, 0);
        }
    }

    // Without restitution the sphere goes on along the wall
    scatteringSampler::setup s;
    s.body = convexBody::sphere(1e-5);
    s.law = reboundLaw::coulomb(0, 0.3);
    nonSphericalRebound dead(s);
    const wallDeparture d = dead.depart({9, -1, 0}, {0, 0, 0}, 1e-5, key(1));
    EXPECT_NEAR(d.V.y, 0, 1e-12);
    EXPECT_GE(d.V.y, 0);
    EXPECT_GT(d.V.x, 6);

    s.maxImpacts = 0;
    EXPECT_THROW(nonSphericalRebound{s}, std::invalid_argument);
}


TEST(wallFrame, isOrthonormal)
{
    for (int i = 0; i < 1000; ++i)
    {
        counterRandom rnd(5, i);
        vector3 n = {rnd.normal(), rnd.normal(), rnd.normal()};
        n = (1/mag(n))*n;
        const vector3 v = i % 10 == 0
          ? 3*n : vector3{rnd.normal(), rnd.normal(), rnd.normal()};
        for
        (
            const wallFrame& f
          : {wallFrame::across(n, v), wallFrame::along(n, v)}
        )
        {
            EXPECT_NEAR(mag(f.x), 1, 1e-14);
            EXPECT_NEAR(dot(f.x, f.y), 0, 1e-14);
            EXPECT_LT(mag(cross(f.x, f.y) - f.z), 1e-14);
            EXPECT_LT(mag(f.y - n), 1e-15);
            EXPECT_LT(mag(f.fromWall(f.toWall(v)) - v), 1e-14*mag(v) + 1e-14);
        }
        if (i % 10)
        {
            EXPECT_NEAR(wallFrame::across(n, v).toWall(v).z, 0, 1e-14*mag(v));
            EXPECT_GT(wallFrame::across(n, v).toWall(v).x, 0);
            EXPECT_NEAR(wallFrame::along(n, v).toWall(v).x, 0, 1e-14*mag(v));
        }
    }
}


TEST(impactKey, differsInEveryPart)
{
    std::set<std::pair<std::uint64_t, std::uint64_t>> keys;
    int n = 0;
    auto add = [&](const impactKey& k)
    {
        keys.insert({k.seed, k.stream});
        ++n;
    };
    for (int a = 0; a < 3; ++a)
    {
        for (int b = 0; b < 3; ++b)
        {
            for (int c = 0; c < 3; ++c)
            {
                for (int d = 0; d < 3; ++d)
                {
                    add(impactKey::ofCount(a, b, c, d));
                    for (int e = 0; e < 3; ++e)
                    {
                        for (int f = 0; f < 3; ++f)
                        {
                            add(impactKey::ofTime(a, b, c, d, e, f));
                        }
                    }
                }
            }
        }
    }
    EXPECT_EQ(int(keys.size()), n);
    EXPECT_EQ
    (
        impactKey::rounded(0.3), impactKey::rounded(0.3 + 1e-12)
    );
    EXPECT_NE(impactKey::rounded(0.3), impactKey::rounded(0.30001));
}
