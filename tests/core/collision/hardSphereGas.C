/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Hard spheres against exact few-body motions and against the kinetic
    theory of gases of hard spheres and disks.
\*---------------------------------------------------------------------------*/

#include "hardSphereGasTest.H"

TEST(hardSphereGas, twoSpheresCollideAsComputedByHand)
{
    // Centre line of contact at 30 degrees: impact parameter 1/2 diameter
    hardSphereGas<> gas({}, pairLaw(1, 0), 3);
    gas.add({1, 1, 0.5, {0, 0, 0}, {1, 0, 0}, {0, 0, 0}});
    gas.add({2, 1, 0.5, {3, 0.5, 0}, {0, 0, 0}, {0, 0, 0}});
    const double t = 3 - std::sqrt(0.75);
    gas.run(t + 2);
    EXPECT_EQ(gas.counts().pairEvents, 1u);
    const auto s = byIdentity(gas);
    const vector3 n = {std::sqrt(0.75), 0.5, 0};
    const vector3 v2 = n.x*n;
    EXPECT_LT(mag(s[1].v - v2), 1e-15);
    EXPECT_LT(mag(s[0].v - (vector3{1, 0, 0} - v2)), 1e-15);
    EXPECT_LT(mag(s[1].x - (vector3{3, 0.5, 0} + 2*v2)), 1e-14);
    EXPECT_LT
    (
        mag(s[0].x - (vector3{t, 0, 0} + 2*(vector3{1, 0, 0} - v2))), 1e-14
    );
}


TEST(hardSphereGas, cradlePassesTheSpeedOn)
{
    // Each sphere comes to rest where it met the next, touching or not
    for (double space : {0., 0.3})
    {
        const int n = 7;
        hardSphereGas<> gas({}, pairLaw(1, 0), 2);
        for (int i = 0; i < n; ++i)
        {
            gas.add
            ({
                std::uint64_t(i), 2, 0.5, {1 + i*(1 + space), 0, 0},
                {i == 0 ? 3. : 0., 0, 0}, {0, 0, 0}
            });
        }
        const double t = 4;
        gas.run(t);
        EXPECT_EQ(gas.counts().pairEvents, std::uint64_t(n - 1));
        const auto s = byIdentity(gas);
        for (int i = 0; i < n; ++i)
        {
            const bool last = i == n - 1;
            const double x = last
              ? 1 + i*(1 + space) + 3*t - (n - 1)*space
              : (i + 1)*(1 + space);
            EXPECT_NEAR(s[i].x.x, x, 1e-13);
            EXPECT_NEAR(s[i].v.x, last ? 3 : 0, 1e-14);
            EXPECT_EQ(s[i].v.y, 0);
        }
    }
}


TEST(hardSphereGas, countsTheDigitsOfPi)
{
    // A light sphere between a wall and a sphere 100^k times as heavy:
    // floor(10^k pi) elastic events in all. Galperin, Regul. Chaotic Dyn. 8
    // (2003) 375
    const int digits[] = {3, 31, 314, 3141, 31415};
    for (int k = 0; k < 5; ++k)
    {
        planeWalls walls;
        walls.add({0, 0, 0}, {2, 0, 0});
        hardSphereGas<false, planeWalls> gas
            ({}, pairLaw(1, 0), 2, contactDuration(), {0, 0, 0}, walls);
        gas.add({1, 1, 0.5, {2, 0, 0}, {0, 0, 0}, {0, 0, 0}});
        gas.add
        ({
            2, std::pow(100., k), 0.5, {4, 0, 0}, {-1, 0, 0}, {0, 0, 0}
        });
        gas.run(100);
        EXPECT_EQ
        (
            gas.counts().pairEvents + gas.counts().wallEvents,
            std::uint64_t(digits[k])
        );
        // Half a unit of round-off per event
        EXPECT_NEAR
            (
                gas.translationalEnergy()/(0.5*std::pow(100., k)), 1,
                1e-12 + 2e-16*digits[k]
            );
    }
}


TEST(hardSphereGas, bouncesInTheFieldOfGravity)
{
    // One sphere: height of the n-th bounce, and time of the n-th impact
    planeWalls floor;
    floor.add({0, 0, 0}, {0, 0, 1});
    const double g = 9.81, e = 0.9;
    hardSphereGas<true, planeWalls> gas
    (
        {}, pairLaw(1, 0), 3, contactDuration(), {0, 0, -g}, floor,
        pairLaw(e, 0)
    );
    gas.add({1, 1, 0.5, {0, 0, 1.5}, {0.3, 0, 0}, {0, 0, 0}});
    double impact = std::sqrt(2/g), speed = g*impact;
    for (int n = 1; n <= 20; ++n)
    {
        speed *= e;
        const double top = impact + speed/g;
        gas.run(top - gas.time());
        EXPECT_EQ(gas.counts().wallEvents, std::uint64_t(n));
        const gasSphere s = gas.particle(0);
        EXPECT_NEAR(s.x.z, 0.5 + speed*speed/(2*g), 1e-12);
        EXPECT_NEAR(s.v.z, 0, 1e-12);
        EXPECT_NEAR(s.x.x, 0.3*top, 1e-13);
        impact = top + speed/g;
    }

    // Two spheres thrown at each other fall together: they meet as without
    // gravity
    hardSphereGas<true> pair
        ({}, pairLaw(1, 0), 3, contactDuration(), {0, 0, -g});
    pair.add({1, 1, 0.5, {0, 0, 0}, {1, 0, 0}, {0, 0, 0}});
    pair.add({2, 1, 0.5, {5, 0, 0}, {-1, 0, 0}, {0, 0, 0}});
    pair.run(3);
    const auto s = byIdentity(pair);
    EXPECT_EQ(pair.counts().pairEvents, 1u);
    EXPECT_NEAR(s[0].x.x, 1, 1e-13);
    EXPECT_NEAR(s[1].x.x, 4, 1e-13);
    EXPECT_NEAR(s[0].x.z, -4.5*g, 1e-12);
}


TEST(hardSphereGas, elasticGasKeepsWhatItMust)
{
    // A million collisions: the rate is known to 0.1 % (one deviation)
    const int n = 2000;
    const double fraction = 0.1, L = side(n, fraction, 3);
    hardSphereGas<> gas(box(L, 3), pairLaw(1, 0), 3);
    fill(gas, n, L, 3, 1);
    const double E = gas.translationalEnergy();
    const double rate = enskogRate(fraction, 3)
       *std::sqrt(2*E/(3*(n - 1)));
    gas.run(20/rate);
    const double start = gas.time();
    const std::uint64_t before = gas.counts().pairEvents;
    gas.run(2.02*1000000/(n*rate));
    const double collisions = double(gas.counts().pairEvents - before);
    EXPECT_GT(collisions, 1e6);
    EXPECT_NEAR
    (
        2*collisions/(n - 1)/(gas.time() - start)/rate, 1, 0.005
    );
    EXPECT_NEAR(gas.translationalEnergy()/E, 1, 1e-12);
    EXPECT_LT(mag(momentum(gas)), 1e-12*n);
    EXPECT_LT(gas.counts().deepestOverlap, 1e-12);
    EXPECT_LT(deepestOverlap(byIdentity(gas), L), 1e-12);
    EXPECT_EQ(gas.restitutionLoss() + gas.frictionLoss(), 0);
}


TEST(hardSphereGas, roughGasKeepsAngularMomentumAndItsEnergyBudget)
{
    // Open: the total angular momentum about the origin is kept
    for (int dimension : {2, 3})
    {
        const int n = 1000;
        const double L = side(n, 0.3, dimension);
        hardSphereGas<> gas({}, pairLaw(0.8, 0.3), dimension);
        fill(gas, n, L, dimension, 2, 1);
        auto angular = [&]
        {
            vector3 sum = {0, 0, 0};
            for (std::size_t i = 0; i < gas.size(); ++i)
            {
                const gasSphere s = gas.particle(i);
                sum = sum + s.mass*cross(s.x, s.v)
                  + (0.4*s.mass*s.radius*s.radius)*s.omega;
            }
            return sum;
        };
        const vector3 before = angular();
        const double E =
            gas.translationalEnergy() + gas.rotationalEnergy();
        gas.run(5);
        EXPECT_GT(gas.counts().pairEvents, 1000u);
        EXPECT_LT(mag(angular() - before), 1e-11*n*L);
        EXPECT_LT(mag(momentum(gas)), 1e-12*n);
        const double lost =
            E - gas.translationalEnergy() - gas.rotationalEnergy();
        EXPECT_GT(lost, 0.05*E);
        EXPECT_NEAR
            (gas.restitutionLoss() + gas.frictionLoss(), lost, 1e-12*E);
    }
}


TEST(hardSphereGas, collidesAtTheRateOfEnskog)
{
    // The contact values are within 0.1 % here (virial coefficients: Clisby
    // and McCoy, J. Stat. Phys. 122 (2006) 15); beside it four and a half
    // standard deviations of the count. The rate of n spheres without net
    // momentum is that of n - 1
    struct
    {
        int dimension;
        double fraction, collisions;
    }
    const cases[] =
    {
        {2, 0.1, 4e5}, {2, 0.001, 1.5e5}, {3, 0.001, 1.5e5}, {3, 0.1, 2e5}
    };
    for (const auto& c : cases)
    {
        const int n = 4000, dimension = c.dimension;
        const double L = side(n, c.fraction, dimension);
        hardSphereGas<> gas(box(L, dimension), pairLaw(1, 0), dimension);
        fill(gas, n, L, dimension, 3);
        const double rate = enskogRate(c.fraction, dimension);
        gas.run(15/rate);
        const double start = gas.time();
        const std::uint64_t before = gas.counts().pairEvents;
        const double T =
            2*gas.translationalEnergy()/(dimension*(n - 1));
        gas.run(2*c.collisions/(n*rate));
        const double measured =
            2.*(gas.counts().pairEvents - before)
           /(n - 1)/(gas.time() - start)/std::sqrt(T);
        EXPECT_NEAR
            (measured/rate, 1, 0.001 + 4.5/std::sqrt(c.collisions))
            << dimension << "-D, " << c.fraction;
    }
}


TEST(hardSphereGas, relaxesToMaxwellsDistribution)
{
    // All at the same speed at first: the kurtosis of a component goes from
    // 1.8 (3-D) or 1.5 (2-D) to 3, and the distribution of speeds to
    // Maxwell's. Chi-squared of 20 equally probable classes, 19 degrees of
    // freedom: above 43.8 once in a thousand
    for (int dimension : {2, 3})
    {
        const int n = 10000;
        const double L = side(n, 0.05, dimension);
        hardSphereGas<> gas(box(L, dimension), pairLaw(1, 0), dimension);
        const int m = dimension == 3 ? 22 : 100;
        counterRandom rnd(53, dimension);
        for (int i = 0; i < n; ++i)
        {
            vector3 v =
                {rnd.normal(), rnd.normal(), dimension == 3 ? rnd.normal() : 0};
            v = (std::sqrt(double(dimension))/mag(v))*v;
            gas.add
            ({
                std::uint64_t(i), 1, 0.5,
                {
                    (i % m + 0.5)*L/m, (i/m % m + 0.5)*L/m,
                    dimension == 3 ? (i/m/m + 0.5)*L/m : 0
                },
                v, {0, 0, 0}
            });
        }
        auto kurtosis = [&]
        {
            double second = 0, fourth = 0;
            for (int i = 0; i < n; ++i)
            {
                const double u = gas.particle(i).v.x;
                second += u*u;
                fourth += u*u*u*u;
            }
            return fourth*n/(second*second);
        };
        EXPECT_NEAR(kurtosis(), dimension == 3 ? 1.8 : 1.5, 0.03);
        gas.run(20/enskogRate(0.05, dimension));
        EXPECT_NEAR(kurtosis(), 3, 0.15);

        std::vector<int> classes(20, 0);
        for (int i = 0; i < n; ++i)
        {
            const vector3 v = gas.particle(i).v;
            const double half = 0.5*dot(v, v);
            const double below = dimension == 2
              ? 1 - std::exp(-half)
              : std::erf(std::sqrt(half))
              - 2/std::sqrt(M_PI)*std::sqrt(half)*std::exp(-half);
            ++classes[std::min(19, int(20*below))];
        }
        double chi2 = 0;
        for (int count : classes)
        {
            chi2 += (count - n/20.)*(count - n/20.)/(n/20.);
        }
        EXPECT_LT(chi2, 43.8);
    }
}


TEST(hardSphereGas, coolsByHaffsLaw)
{
    // T = T0/(1 + t/t0)^2, 1/t0 = (1 - e^2) omega0/(2 d), with omega0 the
    // collision rate at T0: Haff, J. Fluid Mech. 134 (1983) 401; the
    // first Sonine correction (van Noije and Ernst, Granular Matter 1 (1998)
    // 57) is below 0.3 % at e = 0.9. The law is that of a homogeneous state:
    // systems small enough not to form vortices, averaged over many
    for (int dimension : {2, 3})
    {
        const int n = 100, systems = 60;
        const double fraction = 0.1, e = 0.9;
        const double L = side(n, fraction, dimension);
        const double rate = enskogRate(fraction, dimension)*(n - 1)/n;
        const double times[3] = {0.5, 1, 2};
        double ratio[3] = {0, 0, 0};
        for (int k = 0; k < systems; ++k)
        {
            hardSphereGas<> hot(box(L, dimension), pairLaw(1, 0), dimension);
            fill(hot, n, L, dimension, 100 + k);
            hot.run(10/rate);
            hardSphereGas<> gas(box(L, dimension), pairLaw(e, 0), dimension);
            for (int i = 0; i < n; ++i)
            {
                gas.add(hot.particle(i));
            }
            const double E = gas.translationalEnergy();
            const double T = 2*E/(dimension*(n - 1));
            const double t0 = 2*dimension/((1 - e*e)*rate*std::sqrt(T));
            for (int m = 0; m < 3; ++m)
            {
                const double t = times[m];
                gas.run(t*t0 - gas.time());
                ratio[m] += gas.translationalEnergy()/E*(1 + t)*(1 + t)
                   /systems;
            }
            EXPECT_NEAR
            (
                gas.restitutionLoss(), E - gas.translationalEnergy(),
                1e-12*E
            );
        }
        for (int m = 0; m < 3; ++m)
        {
            EXPECT_NEAR(ratio[m], 1, 0.02)
                << dimension << "-D, " << times[m];
        }
    }
}


TEST(hardSphereGas, perfectlyRoughElasticSpheresShareTheirEnergy)
{
    // e = b = 1: energy is kept, and every degree of freedom gets the same
    // share: 3 and 3 in three dimensions, 2 and 1 in two
    for (int dimension : {2, 3})
    {
        const int n = 4000;
        const double L = side(n, 0.1, dimension);
        hardSphereGas<> gas
            (box(L, dimension), pairLaw(1, 1e12, true, 1), dimension);
        fill(gas, n, L, dimension, 5);
        const double E = gas.translationalEnergy();
        EXPECT_EQ(gas.rotationalEnergy(), 0);
        const double rate = enskogRate(0.1, dimension);
        gas.run(30/rate);
        double share = 0;
        const int samples = 40;
        for (int k = 0; k < samples; ++k)
        {
            gas.run(2/rate);
            share += gas.rotationalEnergy()/E/samples;
        }
        EXPECT_NEAR(share, dimension == 3 ? 0.5 : 1./3, 0.004);
        EXPECT_NEAR
        (
            (gas.translationalEnergy() + gas.rotationalEnergy())/E, 1, 1e-12
        );
    }
}


TEST(hardSphereGas, runsBackWhenReversed)
{
    // Smooth, and perfectly rough with spin. An error grows by a factor of
    // about 10 per collision of a sphere: five of them
    for (bool rough : {false, true})
    {
        const int n = 500;
        const double L = side(n, 0.1, 3);
        hardSphereGas<> gas
            (box(L, 3), pairLaw(1, rough ? 1e12 : 0, true, 1), 3);
        fill(gas, n, L, 3, 6, rough ? 2 : 0);
        const auto before = byIdentity(gas);
        const double t = 5/enskogRate(0.1, 3);
        gas.run(t);
        const std::uint64_t events = gas.counts().pairEvents;
        gas.reverse();
        gas.run(t);
        gas.reverse();
        EXPECT_GT(events, 1000u);
        EXPECT_EQ(gas.counts().pairEvents, 2*events);
        const auto after = byIdentity(gas);
        for (int i = 0; i < n; ++i)
        {
            vector3 d = after[i].x - before[i].x;
            for (int k = 0; k < 3; ++k)
            {
                d[k] -= L*std::round(d[k]/L);
            }
            EXPECT_LT(mag(d), 1e-6);
            EXPECT_LT(mag(after[i].v - before[i].v), 1e-6);
            EXPECT_LT(mag(after[i].omega - before[i].omega), 1e-6);
        }
    }
}


TEST(hardSphereGas, doesNotDependOnTheOrderOfTheSpheres)
{
    // To the last bit, over some hundred steps, polydisperse and rough
    for (int dimension : {2, 3})
    {
        const int n = 1000;
        const double L = side(n, 0.15, dimension);
        hardSphereGas<> first
        (
            box(L, dimension), pairLaw(0.9, 0.3), dimension,
            contactDuration(1e-7)
        );
        fill(first, n, L, dimension, 7, 1);
        std::vector<gasSphere> all = byIdentity(first);
        first.clear();
        for (gasSphere& s : all)
        {
            s.radius = 0.5*(1 + s.identity % 10)/10;
            s.mass = std::pow(s.radius, 3);
        }
        hardSphereGas<> second = first;
        counterRandom rnd(54);
        for (const gasSphere& s : all)
        {
            first.add(s);
        }
        for (int i = n - 1; i > 0; --i)
        {
            std::swap(all[i], all[int(rnd.uniform()*(i + 1))]);
        }
        for (const gasSphere& s : all)
        {
            second.add(s);
        }
        for (int k = 0; k < 20; ++k)
        {
            first.run(0.7);
            second.run(0.7);
        }
        EXPECT_GT(first.counts().pairEvents, 2000u);
        EXPECT_EQ(first.counts().pairEvents, second.counts().pairEvents);
        EXPECT_EQ(first.counts().candidates, second.counts().candidates);
        const auto a = byIdentity(first), b = byIdentity(second);
        for (int i = 0; i < n; ++i)
        {
            for (int k = 0; k < 3; ++k)
            {
                ASSERT_EQ(a[i].x[k], b[i].x[k]);
                ASSERT_EQ(a[i].v[k], b[i].v[k]);
                ASSERT_EQ(a[i].omega[k], b[i].omega[k]);
            }
        }
    }
}
