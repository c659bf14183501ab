/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Test particles of the far field: exact flights and temperatures, the
    field of a point source, moments of the laws of emission, conservation,
    independence of threads and processes.
\*---------------------------------------------------------------------------*/

#include "plumeSamplerTest.H"

TEST(plumeSampler, fliesStraightAndCoolsByTheClosedForm)
{
    const plumeSampler sampler
        (basic(beams({{20e-6, 1e9, 1650, 0, 20, cone, 2200}}, 0.05)));
    double youngest = 70, oldest = 0, widest = 0;
    for (const plumeSampler::state& s : sampler.states(0, 0, 20000))
    {
        const vector3& x = s.position;
        const double r = std::hypot(x.y, x.z);
        EXPECT_NEAR(mag(x), 1650*s.age, 0.05 + 1e-12*mag(x));
        EXPECT_LT(r, std::tan(20*M_PI/180)*x.x + 0.05001);
        const double T = sampler.settings().cooling->after
            (2200, 20e-6, s.age);
        EXPECT_NEAR(s.temperature, T, 1e-9*T);
        youngest = std::min(youngest, s.age);
        oldest = std::max(oldest, s.age);
        if (x.x > 1e4)
        {
            widest = std::max(widest, std::atan(r/x.x));
        }
    }
    EXPECT_LT(youngest, 0.02);
    EXPECT_GT(oldest, 69.98);
    EXPECT_GT(widest, 19.98*M_PI/180);
}


TEST(plumeSampler, drawsTheLawsOfEmission)
{
    // Uniform over the solid angle: mean of cos = (1 + cos spread)/2;
    // exponential in 1 - cos: mean of 1 - cos = square, less the cut
    const int n = 200000;
    for (double spread : {0.01, 5., 90., 180.})
    {
        for (auto law : {cone, gaussian})
        {
            const double a = spread*M_PI/180;
            plumeSampler::setup s
            (
                basic(beams({{1e-5, 1, 1000, 50, spread, law, 300}}, 2))
            );
            s.time = 1e5;
            s.burnEnd = 1e-9;
            const plumeSampler sampler(s);
            double versine = 0, square = 0, speed = 0, speed2 = 0;
            double y = 0, z = 0, cosine2 = 0;
            for (const plumeSampler::state& p : sampler.states(0, 0, n))
            {
                const vector3 v = (1/s.time)*p.position;
                const double magnitude = mag(v);
                const double r2 = v.y*v.y + v.z*v.z;
                const double c = v.x/magnitude;
                const double d =
                    c > 0 ? r2/(magnitude*(magnitude + v.x)) : 1 - c;
                versine += d/n;
                square += d*d/n;
                speed += magnitude/n;
                speed2 += (magnitude - 1000)*(magnitude - 1000)/n;
                y += v.y/n;
                z += v.z/n;
                if (r2 > 0)
                {
                    cosine2 += v.y*v.y/r2/n;
                }
            }
            const double k = law == cone ? 0 : std::exp(-2/(a*a));
            const double expected =
                law == cone
              ? 0.5*(1 - std::cos(a))
              : a*a - 2*k/(1 - k);
            const double deviation =
                std::sqrt(std::max(0., square - versine*versine)/n);

            // The disc blurs the angle of the narrowest beam by 2e-8
            EXPECT_NEAR(versine, expected, 4*deviation + 1e-13)
                << spread << ' ' << (law == cone);
            EXPECT_NEAR(speed, 1000, 4*50/std::sqrt(double(n)));
            EXPECT_NEAR(std::sqrt(speed2), 0.98658*50, 0.4);
            EXPECT_NEAR(y, 0, 4*1000/std::sqrt(double(n)));
            EXPECT_NEAR(z, 0, 4*1000/std::sqrt(double(n)));
            EXPECT_NEAR(cosine2, 0.5, 0.005);
        }
    }
}


TEST(plumeSampler, fillsTheExitDiscUniformly)
{
    // Seen a moment after emission
    plumeSampler::setup s(basic(beams({{1e-5, 1, 1, 0, 0, cone, 300}}, 2)));
    s.burnEnd = s.time = 1e-9;
    const int n = 100000;
    double inner = 0, r2 = 0;
    for (const plumeSampler::state& p : plumeSampler(s).states(0, 0, n))
    {
        const double r = std::hypot(p.position.y, p.position.z);
        EXPECT_LE(r, 2);
        inner += r < 1;
        r2 += r*r/n;
    }
    EXPECT_NEAR(inner/n, 0.25, 4*std::sqrt(0.25*0.75/n));
    EXPECT_NEAR(r2, 2, 4*std::sqrt(4./3/n));
}


TEST(plumeSampler, givesThePointSourceItsFieldAndKeepsTheNumber)
{
    // Steady isotropic source: n = flux/(4 pi r^2 u)
    plumeSampler::setup s
        (basic(beams({{1e-5, 1e12, 1000, 0, 180, cone, 2000}})));
    s.grids.push_back
        (plumeGrid::sphere({0, 0, 0}, {0, 70e3 + 1, 70}, 6, 5));
    s.nParticles = 2000000;
    const plumeStatistics r(run(s));
    const plumeGrid& g = s.grids[0];
    EXPECT_EQ(r.inside(0, 0), s.nParticles);
    double chi2 = 0, number = 0;
    int cells = 0;
    for (int c = 0; c < g.nCells(); ++c)
    {
        const int i = c % 70;
        const auto d = r.numberDensity(0, 0, c);
        number += d.value*g.volume(i, c/70 % 6, c/420);
        if (i == 69)
        {
            continue;
        }
        const double a = g.coordinate(0, i), b = g.coordinate(0, i + 1);
        const double exact = 1e12/1000*3*(b - a)
            /(4*M_PI*(b*b*b - a*a*a));
        chi2 += std::pow((d.value - exact)/d.error, 2);
        ++cells;
    }
    EXPECT_NEAR(number, 1e12*70, 1e-9*1e12*70);
    EXPECT_NEAR(chi2/cells, 1, 5*std::sqrt(2./cells));
}


TEST(plumeSampler, statesItsErrorRight)
{
    // Scatter of the density over seeds against the error it states
    plumeSampler::setup s
    (
        basic
        (
            beams
            ({
                {1e-5, 1e12, 1000, 0, 30, gaussian, 2000},
                {2e-5, 3e12, 800, 20, 10, cone, 2000}
            })
        )
    );
    s.grids.push_back(plumeGrid::meridian({0, 60e3, 3}, {0, 10e3, 1}));
    s.nParticles = 20000;
    const int seeds = 200;
    for (int group : {-1, 0, 1})
    {
        double sum = 0, sum2 = 0, T = 0, T2 = 0, error = 0, errorT = 0;
        for (int seed = 1; seed <= seeds; ++seed)
        {
            s.seed = std::uint64_t(seed);
            const plumeStatistics r(run(s));
            const auto d = r.numberDensity(0, group, 1);
            const auto t = r.temperature(0, group, 1);
            sum += d.value/seeds;
            sum2 += d.value*d.value/seeds;
            error += d.error/seeds;
            T += (t.value - 400)/seeds;
            T2 += (t.value - 400)*(t.value - 400)/seeds;
            errorT += t.error/seeds;
        }
        EXPECT_NEAR(std::sqrt(sum2 - sum*sum)/error, 1, 0.2);
        EXPECT_NEAR(std::sqrt(T2 - T*T)/errorT, 1, 0.2);
    }
}


TEST(plumeSampler, doesNotDependOnThreadsOrProcesses)
{
    std::vector<record> file;
    for (int i = 0; i < 40; ++i)
    {
        file.push_back
        ({
            {0.3, 0.01*i, 0}, {1500. + i, 5.*i, 0}, 1500,
            i % 2 ? 2e-5 : 5e-5, 1. + i
        });
    }
    const std::shared_ptr<const plumeSource> sources[] =
    {
        beams
        (
            {
                {2e-5, 1e9, 1600, 30, 20, cone, 1500},
                {5e-5, 1e8, 1400, 30, 10, gaussian, 1500}
            },
            0.1
        ),
        records(file, true, 3)
    };
    for (const auto& source : sources)
    {
        plumeSampler::setup s(basic(source));
        s.grids.push_back
            (plumeGrid::plane({0, 120e3, 60}, {-40e3, 40e3, 40}, 0, 4e3));
        s.grids.push_back(plumeGrid::meridian({0, 120e3, 60}, {0, 4e4, 40}));
        s.stations = {74e3};
        s.nParticles = 100001;
        const std::vector<std::int64_t> one(run(s).pack());
        EXPECT_EQ(run(s, 3).pack(), one);
        EXPECT_EQ(run(s, 1, 3).pack(), one);
        EXPECT_EQ(run(s, 2, 2).pack(), one);
        s.seed = 2;
        EXPECT_NE(run(s).pack(), one);
    }
}


TEST(plumeSampler, drawsRecordsByTheirWeight)
{
    // Velocity tells the record
    std::vector<record> file;
    double total = 0;
    for (int i = 0; i < 37; ++i)
    {
        const double weight = i == 5 ? 0 : std::pow(1.2, i);
        total += weight;
        file.push_back({{0, 0, 0}, {100. + i, 0, 0}, 500, 1e-5, weight});
    }
    plumeSampler::setup s(basic(records(file)));
    s.burnEnd = 1e-9;
    s.time = 1000;
    const int n = 200000;
    std::vector<int> counts(37, 0);
    const plumeSampler sampler(s);
    for (const plumeSampler::state& p : sampler.states(0, 0, n))
    {
        ++counts[int(std::round(p.position.x/1000)) - 100];
    }
    double chi2 = 0;
    EXPECT_EQ(counts[5], 0);
    for (int i = 0; i < 37; ++i)
    {
        const double expected = n*file[i].weight/total;
        if (expected > 0)
        {
            chi2 += std::pow(counts[i] - expected, 2)/expected;
        }
    }
    EXPECT_NEAR(chi2/35, 1, 5*std::sqrt(2./35));
    EXPECT_NEAR(sampler.emitted(0), total*1e-9, 1e-12*total*1e-9);
}


TEST(plumeSampler, turnsAndSmoothsRecords)
{
    plumeSampler::setup s
    (
        basic
        (
            records({{{1, 3, 4}, {1000, 60, 80}, 500, 1e-5, 1}}, true, 10)
        )
    );
    s.burnEnd = 1e-9;
    s.time = 1000;
    const int n = 100000;
    double x = 0, x2 = 0, y = 0, r2 = 0;
    for (const plumeSampler::state& p : plumeSampler(s).states(0, 0, n))
    {
        const vector3 v = 1e-3*p.position;
        x += v.x/n;
        x2 += (v.x - 1000.001)*(v.x - 1000.001)/n;
        y += v.y/n;
        r2 += (v.y*v.y + v.z*v.z)/n;
    }

    // Variance of a normal law cut off at 3 deviations: 0.97334
    const double variance = 0.97334*100;
    EXPECT_NEAR(x, 1000.001, 4*10/std::sqrt(double(n)));
    EXPECT_NEAR(x2, variance, 0.03*variance);
    EXPECT_NEAR(y, 0, 4*72/std::sqrt(double(n)));
    EXPECT_NEAR(r2, 100.005*100.005 + 2*variance, 40);
}


TEST(plumeSampler, groupsRecordsByDiameter)
{
    std::vector<record> file;
    for (double d : {3e-5, 1e-5, 2e-5, 1.0000005e-5, 2e-5})
    {
        file.push_back({{0, 0, 0}, {1, 0, 0}, 500, d, 2});
    }
    const auto apart = records(file);
    ASSERT_EQ(apart->groups().size(), 3u);
    EXPECT_NEAR(apart->groups()[0].diameter, 1.00000025e-5, 1e-16);
    EXPECT_EQ(apart->groups()[1].flux, 4);
    const auto classes = records(file, false, 0, {5e-6, 2e-5, 4e-5});
    ASSERT_EQ(classes->groups().size(), 2u);
    EXPECT_EQ(classes->groups()[1].flux, 6);
    EXPECT_NEAR(classes->groups()[1].diameter, 7e-5/3, 1e-18);
}


TEST(plumeSampler, followsAMovingNozzle)
{
    plumeSampler::setup s
        (basic(beams({{1e-5, 1, 1000, 0, 0, cone, 500}})));
    s.position = {10, 20, 30};
    s.velocity = {-50, 7, 0};
    s.acceleration = {-3, 0, 0.5};
    s.burnStart = 5;
    s.burnEnd = 25;
    s.time = 105;
    for (const plumeSampler::state& p : plumeSampler(s).states(0, 0, 1000))
    {
        const double t = 100 - p.age;
        const vector3 at =
            s.position + t*s.velocity + (0.5*t*t)*s.acceleration;
        const vector3 v = s.velocity + t*s.acceleration + vector3{1000, 0, 0};
        EXPECT_LT(mag(p.position - (at + p.age*v)), 1e-8);
    }

    // Relative to the nozzle, which coasts after the burn
    const vector3 end =
        s.position + 20.*s.velocity + 200.*s.acceleration;
    const vector3 now = end + 80.*(s.velocity + 20.*s.acceleration);
    const auto inertial = plumeSampler(s).states(0, 0, 100);
    s.frame = plumeSampler::frameType::nozzle;
    const auto relative = plumeSampler(s).states(0, 0, 100);
    for (int i = 0; i < 100; ++i)
    {
        EXPECT_LT
        (
            mag(inertial[i].position - now - relative[i].position), 1e-8
        );
    }
}


TEST(plumeSampler, fallsInGravity)
{
    // A nozzle on a circular orbit, particles by their own orbits
    const double mu = 3.986004418e14, r = 7e6;
    const double circular = std::sqrt(mu/r);
    plumeSampler::setup s
        (basic(beams({{1e-5, 1, 100, 0, 60, cone, 500}})));
    s.gravity = std::make_shared<const keplerOrbit>(mu);
    s.gravityCentre = {0, 0, -r};
    s.velocity = {circular, 0, 0};
    s.motion = plumeSampler::nozzleMotion::orbit;
    s.burnEnd = 1e-6;
    s.time = 70;
    s.frame = plumeSampler::frameType::nozzle;
    plumeSampler::setup free(s);
    free.gravity = nullptr;
    free.motion = plumeSampler::nozzleMotion::uniform;
    const auto fallen = plumeSampler(s).states(0, 0, 2000);
    const auto straight = plumeSampler(free).states(0, 0, 2000);

    // Relative motion in orbit (Clohessy & Wiltshire) from the nozzle, x
    // along the flight, z outwards. Their axes turn by n t, ours do not:
    // on leaving, when nothing is far yet, the velocities are the same.
    const double n = circular/r, t = 70, nt = n*t;
    const double s1 = std::sin(nt), c1 = std::cos(nt);
    for (int i = 0; i < 2000; ++i)
    {
        const vector3 u = (1/t)*straight[i].position;
        const double x = u.x/n*(4*s1 - 3*nt) - 2*u.z/n*(1 - c1);
        const double y = u.y/n*s1;
        const double z = u.z/n*s1 + 2*u.x/n*(1 - c1);
        const vector3& p = fallen[i].position;
        const double px = p.x*c1 - p.z*s1;
        const double pz = p.x*s1 + p.z*c1;
        EXPECT_NEAR(px, x, 0.5);
        EXPECT_NEAR(p.y, y, 0.5);
        EXPECT_NEAR(pz, z, 0.5);
        EXPECT_GT(mag(p - straight[i].position), 0.05);
    }

    // At rest above the centre: g t^2/2 down
    s.motion = plumeSampler::nozzleMotion::uniform;
    s.velocity = {0, 0, 0};
    s.frame = plumeSampler::frameType::inertial;
    s.source = beams({{1e-5, 1, 1e-3, 0, 0, cone, 500}});
    s.time = 10;
    const auto dropped = plumeSampler(s).states(0, 0, 10);
    EXPECT_NEAR(dropped[0].position.z, -50*mu/(r*r), 0.01);
}


TEST(plumeSampler, stepsTemperaturesLikeThePaper)
{
    plumeSampler::setup s
        (basic(beams({{20e-6, 1e9, 1650, 0, 20, cone, 2200}})));
    s.temperature = plumeSampler::temperatureMethod::euler;
    const radiativeCooling& cooling = *s.cooling;
    double last = 0;
    for (double deltaT : {8e-3, 4e-3})
    {
        s.deltaT = deltaT;
        double error = 0;
        for (const plumeSampler::state& p : plumeSampler(s).states(0, 0, 600))
        {
            // One step after the other, and the rest
            double T = 2200, left = p.age;
            while (left > 0)
            {
                const double h = std::min(left, deltaT);
                T += h*(cooling.eulerHeat(20e-6)
                  - cooling.eulerLoss(20e-6)*T*T*T*T);
                left -= h;
            }
            EXPECT_NEAR(p.temperature, T, 1e-9*T);
            error = std::max
            (
                error,
                std::fabs(T - cooling.after(2200, 20e-6, p.age))
            );
        }
        if (last > 0)
        {
            EXPECT_NEAR(last/error, 2, 0.4);
        }
        last = error;
    }
    s.source = records({{{0, 0, 0}, {9, 0, 0}, 2200, 20e-6, 1}});
    for (const plumeSampler::state& p : plumeSampler(s).states(0, 0, 100))
    {
        const double exact = cooling.after(2200, 20e-6, p.age);
        EXPECT_NEAR(p.temperature, exact, 0.1*exact);
        EXPECT_NE(p.temperature, exact);
    }
}


TEST(plumeSampler, takesTemperaturesOfRecordsOnBothSides)
{
    std::vector<record> file =
    {
        {{0, 0, 0}, {1000, 0, 0}, 2000, 20e-6, 1},
        {{0, 0, 0}, {2000, 0, 0}, 20, 30e-6, 1}
    };
    plumeSampler::setup s(basic(records(file, false, 0, {1e-5, 1e-4})));
    for (const plumeSampler::state& p : plumeSampler(s).states(0, 0, 1000))
    {
        const bool hot = p.position.x < 1500*p.age;
        const double T = s.cooling->after
            (hot ? 2000 : 20, hot ? 20e-6 : 30e-6, p.age);
        EXPECT_NEAR(p.temperature, T, 1e-9*T);
    }
    radiativeCooling::setup table;
    table.heatCapacity = {{10, 50}, {500, 1000}, {2500, 1300}};
    s.cooling = std::make_shared<const radiativeCooling>(table);
    for (const plumeSampler::state& p : plumeSampler(s).states(0, 0, 1000))
    {
        const bool hot = p.position.x < 1500*p.age;
        const double T = s.cooling->after
            (hot ? 2000 : 20, hot ? 20e-6 : 30e-6, p.age);
        EXPECT_NEAR(p.temperature, T, 1e-9*T);
    }
}
