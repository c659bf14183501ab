/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Collisions in the spin-carrying cloud at their limits: curved paths,
    extremes, rest on walls and in corners, injection upon others, refusal of
    bad input.
\*---------------------------------------------------------------------------*/

#include "eventDrivenCollisionsTest.H"

TEST_F(eventDrivenCollisionsTest, contactOnCurvedPathsConverges)
{
    // Two grains of different size slow down at different rates; where and
    // when they meet follows from the parabolas
    open("plane", 1e-6);
    const auto meeting =
        [this](const label n)
        {
            time_->setDeltaT(4e-5/n);
            const auto cloud = make
            (
                "solution{motion{type embeddedRK54;tolerance 1e-10;}"
                "collisions{type eventDriven;}}",
                "hendersonDrag;",
                word("n" + std::to_string(n))
            );
            const tracked a =
                add(*cloud, vector(1e-4, 5e-4, 5e-5), vector(40, 0, 0), 2e-6);
            add(*cloud, vector(3e-4, 5.01e-4, 5e-5), vector(10, 0, 0), 8e-6);
            scalar nPair = 0;
            for (label i = 0; i < n; ++i)
            {
                step(*cloud);
                nPair += cloud->collisions()->lastStep().pairEvents;
            }
            EXPECT_EQ(nPair, 1);
            return a.position();
        };
    const vector truth = meeting(512);
    const scalar coarse = mag(meeting(4) - truth);
    const scalar fine = mag(meeting(16) - truth);
    EXPECT_LT(coarse, 2e-5);
    EXPECT_LT(fine, 0.15*coarse);
    EXPECT_GT(coarse, 0);
}


TEST_F(eventDrivenCollisionsTest, extremesStayFiniteAndConserve)
{
    open("plane", 1e-6);
    struct pair
    {
        scalar speed, d;
    };
    for
    (
        const pair& extreme :
        {pair{1e-9, 1e-5}, pair{1e5, 1e-5}, pair{100, 1e-7}}
    )
    {
        const auto cloud = make
        (
            base, "", word("sand" + name(extreme.speed) + name(extreme.d))
        );
        time_->setDeltaT(min(scalar(1e-6), 1e-4/extreme.speed));
        const scalar way = 0.5*time_->deltaTValue()*extreme.speed;
        const scalar sigma = 0.5*(1e-5 + extreme.d);
        const vector x(4e-4, 5e-4, 5e-5);
        const vector U(extreme.speed, 0, 0);
        add(*cloud, x, U);
        const tracked b = add
        (
            *cloud, x + vector(sigma + way, 0, 0),
            vector::zero, extreme.d
        );
        const scalar E = energy(*cloud);
        step(*cloud);
        EXPECT_EQ(cloud->collisions()->lastStep().pairEvents, 1);
        EXPECT_NEAR(energy(*cloud)/E, 1, 1e-12);
        EXPECT_GT(b.U().x(), 0.999*extreme.speed);
    }
}


TEST_F(eventDrivenCollisionsTest, aLayerComesToRestOnTheWall)
{
    // e = 0.1 under a strong body force: the bounces of each parcel add up to
    // a finite time
    open("plane", 1e-6);
    g_ = dimensionedVector("g", dimAcceleration, vector(0, -1e6, 0));
    const auto cloud = make
    (
        "solution{motion embeddedRK54;collisions{type eventDriven;"
        "restitution 0.1;friction 0.2;contactDuration 1e-8;}}"
        "subModels{hardSphereWallCoeffs{patches (\"f.*\""
        "{restitution 0.1;friction 0.2;});}}",
        "gravity;"
    );
    for (int i = 0; i < 24; ++i)
    {
        add
        (
            *cloud, vector(3e-5*i + 1e-4, 1e-5, 5e-5), vector(0, -5, 0)
        );
    }
    scalar events = 0;
    for (int i = 0; i < 30; ++i)
    {
        step(*cloud);
        events += cloud->collisions()->lastStep().wallEvents;
    }
    ASSERT_EQ(cloud->size(), 24);
    EXPECT_GT(events, 100);
    for (const parcel& p : *cloud)
    {
        EXPECT_LT(mag(p.U()), 2);
        EXPECT_LT(p.position().y(), 1e-6);
    }
}


TEST_F(eventDrivenCollisionsTest, aPileInACornerComesToRest)
{
    // The number of collisions would have no bound
    open("plane", 1e-6);
    g_ = dimensionedVector("g", dimAcceleration, vector(-1e6, -1e6, 0));
    const auto cloud = make
    (
        "solution{motion embeddedRK54;collisions{type eventDriven;"
        "restitution 0.1;friction 0.2;}}"
        "subModels{hardSphereWallCoeffs{patches (\"f.*\""
        "{restitution 0.1;friction 0.2;});}}",
        "gravity;"
    );
    for (int i = 0; i < 24; ++i)
    {
        add
        (
            *cloud,
            vector(1e-5 + 1.1e-5*(i % 6), 1e-5 + 1.1e-5*(i/6), 5e-5),
            vector::zero
        );
    }
    scalar held = 0;
    for (int i = 0; i < 40; ++i)
    {
        step(*cloud);
        held += cloud->collisions()->lastStep().held;
    }
    ASSERT_EQ(cloud->size(), 24);
    EXPECT_GT(held, 0);
    EXPECT_LT(overlap(*cloud), 1e-5);
    for (const parcel& p : *cloud)
    {
        // No more than what the force of two steps gives
        EXPECT_LT(mag(p.U()), 3);
    }
}


TEST_F(eventDrivenCollisionsTest, manyFreeCollisionsInAStepHoldNobody)
{
    // A large grain through 400 small ones: more than 200 events, but no rest
    open("plane", 5e-6);
    const auto cloud = make();
    add(*cloud, vector(3e-4, 5e-4, 5e-5), vector(100, 0, 0));
    for (int i = 0; i < 400; ++i)
    {
        add
        (
            *cloud,
            vector(3.1e-4 + 2e-6*(i/20), 4.95e-4 + 5e-7*(i % 20), 5e-5),
            vector(-20, 0, 0),
            1e-7
        );
    }
    const scalar E = energy(*cloud);
    step(*cloud);
    const auto& report = cloud->collisions()->lastStep();
    EXPECT_GT(report.pairEvents, 300);
    EXPECT_EQ(report.held, 0);
    EXPECT_NEAR(energy(*cloud)/E, 1, 1e-12);
}


TEST_F(eventDrivenCollisionsTest, overlappingInjectionAsTheDictionarySays)
{
    open("plane", 1e-6);
    for (const char* way : {"refuse", "separate"})
    {
        const auto cloud = make
        (
            "solution{motion embeddedRK54;collisions{type eventDriven;"
            "overlappingInjection " + std::string(way) + ";}}",
            "",
            way
        );
        add(*cloud, vector(4e-4, 5e-4, 5e-5), vector::zero);
        step(*cloud);
        add(*cloud, vector(4.04e-4, 5e-4, 5e-5), vector::zero);
        add(*cloud, vector(6e-4, 5e-4, 5e-5), vector::zero);
        step(*cloud);
        EXPECT_EQ(cloud->size(), *way == 'r' ? 2 : 3);
        EXPECT_LT(overlap(*cloud), 1e-9);
        EXPECT_EQ(cloud->collisions()->lastStep().overlappingInjection, 1);
        step(*cloud);
        EXPECT_EQ(cloud->collisions()->lastStep().overlappingInjection, 0);
    }
}


TEST_F(eventDrivenCollisionsTest, refusesBadInput)
{
    open("plane", 1e-6);
    const auto expect =
        [this]
        (
            const std::string& entries,
            std::initializer_list<const char*> words
        )
        {
            const std::string message = refusal
            (
                "solution{collisions{type eventDriven;" + entries + "}}"
            );
            for (const char* word : words)
            {
                EXPECT_NE(message.find(word), std::string::npos) << message;
            }
        };
    expect("restitution 1.1;", {"restitution", "1.1", "[0, 1]"});
    expect("friction -1;", {"friction", "-1", "[0, 1e6]"});
    expect("tangentialRestitution 2;", {"tangentialRestitution", "[-1, 1]"});
    expect("contactDuration 0;", {"contactDuration", "(0, 1e12]"});
    expect("contactDuration -1;", {"contactDuration", "-1"});
    expect("dimension 3;", {"dimension", "3", "2"});
    expect("slabThickness 0;", {"slabThickness", "0", "(0, 1e12]"});
    expect("overlappingInjection ignore;", {"ignore", "refuse", "separate"});
    expect("type stochastic;", {"type stochastic", "eventDriven"});
    EXPECT_NE
    (
        refusal("solution{collisions on;}").find("off eventDriven"),
        std::string::npos
    );

    const auto cloud = make();
    add(*cloud, vector(4e-4, 5e-4, 5e-5), vector::zero);
    cloud->last()->nParticle() = 3;
    try
    {
        step(*cloud);
        FAIL();
    }
    catch (const error& e)
    {
        EXPECT_NE(e.message().find("nParticle"), std::string::npos);
        EXPECT_NE(e.message().find("slabThickness/d = 10"), std::string::npos)
            << e.message();
    }
    cloud->first()->nParticle() = 10;
    step(*cloud);
}


TEST_F(eventDrivenCollisionsTest, annotatedDictionaryIsValid)
{
    open("plane", 1e-6);
    IFstream is
    (
        fileName(std::getenv("PARCEL_IMPACT_DIR"))
       /"etc/caseDicts/annotated/eventDrivenCollisions"
    );
    dictionary dict(is);
    ASSERT_TRUE(dict.subDict("solution").found("collisions"));
    OStringStream os;
    dict.write(os, false);
    const auto cloud = make(os.str());
    ASSERT_TRUE(cloud->collisions());
    add(*cloud, vector(4e-4, 5e-4, 5e-5), vector(1, 0, 0));
    step(*cloud);
    EXPECT_EQ(cloud->size(), 1);
}
