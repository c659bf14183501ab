/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Test particles of the far field: extremes, what is refused.
\*---------------------------------------------------------------------------*/

#include "plumeSamplerTest.H"

TEST(plumeSampler, staysFiniteAtExtremes)
{
    for (double alpha : {0., 0.5})
    {
        for (double eps : {0., 0.5})
        {
            plumeSampler::setup s
            (
                basic
                (
                    beams
                    ({
                        {1e-8, 1e20, 5000, 0, 180, cone, 3000},
                        {1e-2, 1e-3, 1, 0, 0, cone, 3}
                    })
                )
            );
            radiativeCooling::setup material;
            material.absorptivity = alpha;
            material.emissivity = eps;
            s.cooling = std::make_shared<const radiativeCooling>(material);
            s.time = 1e5;
            s.nParticles = 10000;

            // Far away from all particles, and around them
            s.grids.push_back(plumeGrid::axis({1e12, 2e12, 5}, 1));
            s.grids.push_back
                (plumeGrid::sphere({0, 0, 0}, {0, 1e9, 10}, 3, 1));
            s.stations = {74e3};
            const plumeStatistics r(run(s));
            for (int group : {0, 1})
            {
                EXPECT_EQ(r.inside(0, group), 0);
                EXPECT_EQ(r.inside(1, group), 5000);
                EXPECT_TRUE(std::isfinite(r.temperature(group).value));
                EXPECT_TRUE(std::isfinite(r.quantile(group, 0.999)));
            }
            if (eps > 0 && alpha > 0)
            {
                EXPECT_NEAR(r.temperature(0).value, 278.68, 0.01);
            }
            if (eps == 0 && alpha == 0)
            {
                EXPECT_NEAR(r.temperature(0).value, 3000, 1e-4);
            }
        }
    }
}


TEST(plumeSampler, emitsNothingBeforeIgnition)
{
    plumeSampler::setup s
        (basic(beams({{1e-5, 1e12, 1000, 0, 180, cone, 2000}})));
    s.grids.push_back(plumeGrid::axis({0, 1e5, 5}, 1e3));
    for (double time : {-10., 0.})
    {
        s.time = time;
        const plumeStatistics r(run(s));
        EXPECT_EQ(r.sampled(), 0);
        EXPECT_EQ(plumeSampler(s).emitted(0), 0);
        EXPECT_EQ(r.numberDensity(0, 0, 2).value, 0);
        EXPECT_TRUE(plumeSampler(s).states(0, 0, 10).empty());
    }

    // While it burns only what has left exists
    s.time = 7;
    EXPECT_EQ(plumeSampler(s).emitted(0), 7e12);
    s.time = 1000;
    EXPECT_EQ(plumeSampler(s).emitted(0), 70e12);
}


TEST(plumeSampler, refusesWhatIsOutOfRange)
{
    const beam good = {1e-5, 1e9, 1000, 0, 20, cone, 2000};
    auto has = [](const std::string& text, const char* words)
    {
        return text.find(words) != std::string::npos;
    };
    auto bad = [&](const char* words, beam b, double radius = 0)
    {
        const std::string text = complaintOf([&] { beams({b}, radius); });
        EXPECT_TRUE(has(text, words)) << text;
    };
    auto with = [&](auto change)
    {
        beam b(good);
        change(b);
        return b;
    };
    bad("exitRadius -1", good, -1);
    bad("diameter 0", with([](beam& b) { b.diameter = 0; }));
    bad("flux 0", with([](beam& b) { b.flux = 0; }));
    bad("speed 0", with([](beam& b) { b.speed = 0; }));
    bad("[0, speed/3)", with([](beam& b) { b.speedDeviation = 400; }));
    bad("spread 181", with([](beam& b) { b.spread = 181; }));
    bad("(1e-6, 180]", with([](beam& b)
        { b.spread = 0; b.distribution = gaussian; }));
    bad("temperature -3", with([](beam& b) { b.temperature = -3; }));
    EXPECT_TRUE(has(complaintOf([] { beams({}); }), "number of groups 0"));

    std::vector<record> many;
    for (int i = 0; i < 100; ++i)
    {
        many.push_back({{0, 0, 0}, {1, 0, 0}, 9, 1e-5*(i + 1), 1});
    }
    EXPECT_TRUE(has(complaintOf([&] { records(many); }), "groupEdges"));
    EXPECT_TRUE(has
    (
        complaintOf([&] { records(many, false, 0, {1e-5, 2e-4}); }),
        "that of groupEdges"
    ));
    EXPECT_TRUE(has
    (
        complaintOf([&] { records(many, false, 0, {1e-5, 1e-6}); }),
        "ascending"
    ));
    EXPECT_TRUE(has
        (complaintOf([&] { records(many, false, -1); }), "smoothing -1"));
    EXPECT_TRUE(has
    (
        complaintOf
            ([] { records({{{0, 0, 0}, {1, 0, 0}, 9, 1e-5, 0}}); }),
        "none of its records has a weight"
    ));

    auto refused = [&](const char* words, auto change)
    {
        plumeSampler::setup s(basic(beams({good})));
        change(s);
        const std::string text = complaint(s);
        EXPECT_TRUE(has(text, words)) << text;
    };
    typedef plumeSampler::setup setup;
    refused("accepted", [](setup&) {});
    refused("end 0", [](setup& s) { s.burnEnd = 0; });
    refused("nParticles 0", [](setup& s) { s.nParticles = 0; });
    refused("velocity", [](setup& s) { s.velocity.x = 1e9; });
    refused("needs gravity", [](setup& s)
        { s.motion = plumeSampler::nozzleMotion::orbit; });
    refused("centre of gravity", [](setup& s)
        { s.gravity = std::make_shared<keplerOrbit>(1e14); });
    refused("stable for a particle", [](setup& s)
    {
        s.temperature = plumeSampler::temperatureMethod::euler;
        s.deltaT = 1;
    });
    refused("deltaT 0", [](setup& s)
        { s.temperature = plumeSampler::temperatureMethod::euler; });
    refused("stationHalfWidth 0", [](setup& s) { s.stationHalfWidth = 0; });
    refused("time 70: valid range up to", [](setup& s)
    {
        radiativeCooling::setup dark;
        dark.absorptivity = 0;
        s.cooling = std::make_shared<const radiativeCooling>(dark);
        s.source = beams({{1e-300, 1, 1e-3, 0, 0, cone, 300}});
    });

    // Without an equilibrium the temperature leaves any pairs at last
    const auto pairs = [](setup& s, double time, bool sunlit)
    {
        radiativeCooling::setup c;
        c.heatCapacity = {{300, 900}, {2500, 1300}};
        (sunlit ? c.emissivity : c.absorptivity) = 0;
        s.cooling = std::make_shared<const radiativeCooling>(c);
        s.source = beams({{1e-3, 1, 1e-3, 0, 0, cone, 2200}});
        s.time = time;
    };
    refused("accepted", [&](setup& s) { pairs(s, 100, false); });
    refused("] K, that of the pairs of heatCapacity, which a particle of",
        [&](setup& s) { pairs(s, 1e4, false); });
    refused("accepted", [&](setup& s) { pairs(s, 100, true); });
    refused("valid range [300, 2500] K, that of the pairs",
        [&](setup& s) { pairs(s, 1e7, true); });
}
