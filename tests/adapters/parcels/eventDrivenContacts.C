/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Collisions in the spin-carrying cloud: exact two-body cases, a closed box
    against a search of all pairs at every event, a periodic box against the
    mesh-free gas, conservation, cloud functions and sources.
\*---------------------------------------------------------------------------*/

#include "eventDrivenCollisionsTest.H"
#include "hardSphereGas.H"
#include "largest.H"

namespace
{

//- Spheres in a closed box by search of all pairs and walls at every event
struct allPairs
{
    struct sphere
    {
        impact::vector3 x, v, omega;
        double r, m;
    };
    std::vector<sphere> s;
    impact::pairLaw law;
    int nPair = 0, nWall = 0;

    void run(double time, int dimensions)
    {
        while (true)
        {
            double first = time;
            int a = -1, b = -1, axis = -1;
            for (int i = 0; i < int(s.size()); ++i)
            {
                for (int k = 0; k < dimensions; ++k)
                {
                    const double v = s[i].v[k];
                    const double t =
                        v > 0 ? (1e-3 - s[i].x[k])/v
                      : v < 0 ? s[i].x[k]/(-v) : first;
                    if (t < first)
                    {
                        first = std::max(t, 0.);
                        a = i;
                        b = -1;
                        axis = k;
                    }
                }
                for (int j = 0; j < i; ++j)
                {
                    const auto x = s[j].x - s[i].x, v = s[j].v - s[i].v;
                    const double bb = dot(x, v);
                    const double sigma = s[i].r + s[j].r;
                    const double c = dot(x, x) - sigma*sigma;
                    const double D = bb*bb - dot(v, v)*c;
                    if (bb < 0 && D > 0)
                    {
                        const double t = c/(-bb + std::sqrt(D));
                        if (t < first)
                        {
                            first = std::max(t, 0.);
                            a = i;
                            b = j;
                        }
                    }
                }
            }
            for (sphere& p : s)
            {
                p.x = p.x + first*p.v;
            }
            time -= first;
            if (a < 0)
            {
                return;
            }
            if (b < 0)
            {
                s[a].v[axis] = -s[a].v[axis];
                ++nWall;
                continue;
            }
            const auto x = s[b].x - s[a].x;
            const auto out = law.collide
            (
                {s[a].v, s[a].omega, s[a].m, s[a].r},
                {s[b].v, s[b].omega, s[b].m, s[b].r},
                (1/mag(x))*x
            );
            s[a].v = out.v1;
            s[b].v = out.v2;
            s[a].omega = out.omega1;
            s[b].omega = out.omega2;
            ++nPair;
        }
    }
};

} // End anonymous namespace


TEST_F(eventDrivenCollisionsTest, offBuildsNothing)
{
    open("plane", 1e-6);
    EXPECT_FALSE(make("", "", "default")->collisions());
    EXPECT_FALSE(make("solution{collisions off;}", "", "off")->collisions());
    EXPECT_TRUE(make(base, "", "on")->collisions());
}


TEST_F(eventDrivenCollisionsTest, headOnIsExact)
{
    open("plane", 1e-6);
    for (const char* motion : {"stock", "embeddedRK54"})
    {
        const auto cloud = make
        (
            "solution{motion " + std::string(motion) + ";collisions"
            "{type eventDriven;restitution 0.5;friction 0;}}",
            "",
            motion
        );
        const tracked a =
            add(*cloud, vector(4e-4, 5e-4, 5e-5), vector(100, 0, 0));
        const tracked b = add(*cloud, vector(4.6e-4, 5e-4, 5e-5), vector::zero);
        step(*cloud);

        // They meet after 5e-5 m; with e = 0.5 they leave with 25 and 75 m/s
        EXPECT_NEAR(a.U().x(), 25, 1e-11);
        EXPECT_NEAR(b.U().x(), 75, 1e-11);
        EXPECT_NEAR(a.position().x(), 4.5e-4 + 25*0.5e-6, 1e-17);
        EXPECT_NEAR(b.position().x(), 4.6e-4 + 75*0.5e-6, 1e-17);
        const auto& report = cloud->collisions()->lastStep();
        EXPECT_EQ(report.pairEvents, 1);
        EXPECT_EQ(report.wallEvents, 0);
        EXPECT_NEAR
        (
            report.restitutionLoss/(a.mass()*0.25*1e4*0.75), 1, 1e-12
        );
        step(*cloud);
        EXPECT_EQ(cloud->collisions()->lastStep().pairEvents, 0);
        EXPECT_NEAR(b.position().x(), 4.6e-4 + 75*1.5e-6, 1e-16);
    }
}


TEST_F(eventDrivenCollisionsTest, reboundHitsIncomingInTheSameStep)
{
    open("plane", 1e-6);
    const auto cloud = make();

    // a is at the wall x = 1e-3 after 0.2 us, comes back at 200 m/s and
    // meets b, which comes at 300 m/s; they exchange their velocities; b
    // then goes to the left, a to the wall again and returns
    const tracked a =
        add(*cloud, vector(9.6e-4, 5e-4, 5e-5), vector(200, 0, 0));
    const tracked b = add(*cloud, vector(8e-4, 5e-4, 5e-5), vector(300, 0, 0));
    step(*cloud);
    const scalar t = 0.2e-6 + (1.4e-4 - 1e-5)/500;
    const scalar meetA = 1e-3 - 200*(t - 0.2e-6);
    const scalar meetB = 8e-4 + 300*t;
    ASSERT_NEAR(meetA - meetB, 1e-5, 1e-16);
    const scalar again = t + (1e-3 - meetA)/300;
    EXPECT_NEAR(a.position().x(), 1e-3 - 300*(1e-6 - again), 1e-15);
    EXPECT_NEAR(b.position().x(), meetB - 200*(1e-6 - t), 1e-15);
    EXPECT_NEAR(a.U().x(), -300, 1e-10);
    EXPECT_NEAR(b.U().x(), -200, 1e-10);
    EXPECT_EQ(cloud->collisions()->lastStep().pairEvents, 1);
    EXPECT_EQ(cloud->collisions()->lastStep().wallEvents, 2);
}


TEST_F(eventDrivenCollisionsTest, eventsAreThoseOfASearchOfAllPairs)
{
    for (const bool plane : {true, false})
    {
        close();
        rmDir(root_/"case");
        open(plane ? "plane" : "box", 2e-6);
        for (const char* motion : {"stock", "embeddedRK54"})
        {
            const auto cloud = make
            (
                "solution{motion " + std::string(motion) + ";maxCo 1;"
                "collisions{type eventDriven;restitution 0.8;friction 0.3;"
                "contactDuration 1e-15;}}",
                "",
                motion
            );
            allPairs exact{{}, impact::pairLaw(0.8, 0.3)};
            std::vector<tracked> parcels;
            fill
            (
                200, plane ? 1e-5 : 2e-5, plane ? 4e-5 : 8e-5, 50, plane,
                [&]
                (
                    const vector& x,
                    const vector& U,
                    const scalar d,
                    const vector& omega
                )
                {
                    parcels.push_back(add(*cloud, x, U, d, omega));
                    const parcel p = *parcels.back();
                    exact.s.push_back
                    ({
                        toCore(p.position()), toCore(U), toCore(omega),
                        0.5*d, p.mass()
                    });
                }
            );
            // What round-off grows to from collision to collision
            allPairs disturbed(exact);
            std::mt19937 generator(3);
            std::uniform_real_distribution<double> noise(-1e-18, 1e-18);
            for (auto& sphere : disturbed.s)
            {
                sphere.x.x += noise(generator);
                sphere.x.y += noise(generator);
            }

            const scalar before = energy(*cloud);
            scalar nPair = 0, nWall = 0, lost = 0;
            for (int i = 0; i < 4; ++i)
            {
                step(*cloud);
                const auto& report = cloud->collisions()->lastStep();
                nPair += report.pairEvents;
                nWall += report.wallEvents;
                lost += report.restitutionLoss + report.frictionLoss;
                EXPECT_LT(overlap(*cloud), 1e-9);
            }
            exact.run(8e-6, plane ? 2 : 3);
            disturbed.run(8e-6, plane ? 2 : 3);
            EXPECT_EQ(nPair, exact.nPair);
            EXPECT_EQ(nWall, exact.nWall);
            EXPECT_GT(nPair, 40);
            EXPECT_GT(nWall, 20);
            scalar worst = 0, roundOff = 0;
            for (std::size_t i = 0; i < parcels.size(); ++i)
            {
                const parcel p = *parcels[i];
                const auto deviation =
                    [&](const vector& x, const vector& U, const vector& omega)
                    {
                        return
                            mag(x - fromCore(exact.s[i].x))/1e-5
                          + mag(U - fromCore(exact.s[i].v))/50
                          + 0.5*p.d()/50
                           *mag(omega - fromCore(exact.s[i].omega));
                    };
                worst = largest
                    (worst, deviation(p.position(), p.U(), p.omega()));
                const auto& q = disturbed.s[i];
                roundOff = largest
                (
                    roundOff,
                    deviation(fromCore(q.x), fromCore(q.v), fromCore(q.omega))
                );
            }
            EXPECT_LT(worst, 30*roundOff) << plane << motion;
            EXPECT_LT(worst, 1e-5);
            EXPECT_NEAR((energy(*cloud) + lost)/before, 1, 1e-12);
        }
    }
}


TEST_F(eventDrivenCollisionsTest, periodicBoxKeepsAllAndIsTheMeshFreeGas)
{
    open("periodic", 5e-6);
    const auto cloud = make
    (
        base + "subModels{patchInteractionModel standardWallInteraction;}"
    );
    impact::collisionDomain domain;
    domain.high = impact::vector3{1e-3, 1e-3, 1e-3};
    for (bool& periodic : domain.periodic)
    {
        periodic = true;
    }
    impact::hardSphereGas<> gas(domain, impact::pairLaw(1, 0), 3);
    std::vector<tracked> parcels;
    fill
    (
        300, 4e-5, 6e-5, 50, false,
        [&]
        (
            const vector& x,
            const vector& U,
            const scalar d,
            const vector& omega
        )
        {
            const tracked p = add(*cloud, x, U, d, omega);
            gas.add
            ({
                parcels.size(), p.mass(), 0.5*d, toCore(p.position()),
                toCore(U), toCore(omega)
            });
            parcels.push_back(p);
        }
    );
    const vector before = momentum(*cloud);
    const scalar E = energy(*cloud);
    scalar nPair = 0;
    for (int i = 0; i < 2; ++i)
    {
        step(*cloud);
        nPair += cloud->collisions()->lastStep().pairEvents;
    }
    gas.run(1e-5);
    EXPECT_EQ(nPair, gas.counts().pairEvents);
    EXPECT_GT(nPair, 50);
    EXPECT_NEAR(energy(*cloud)/E, 1, 1e-12);
    const scalar scale = 300*parcels[0].mass()*50;
    EXPECT_LT(mag(momentum(*cloud) - before), 1e-12*scale);
    scalar worst = 0;
    for (std::size_t i = 0; i < parcels.size(); ++i)
    {
        const impact::gasSphere s = gas.particle(i);
        vector way =
            parcels[s.identity].position() - fromCore(s.x);
        for (int k = 0; k < 3; ++k)
        {
            way[k] -= 1e-3*std::round(way[k]/1e-3);
        }
        worst = largest(worst, mag(way)/1e-5);
        worst = largest
            (worst, mag(parcels[s.identity].U() - fromCore(s.v))/50);
    }
    EXPECT_LT(worst, 1e-7);
}


TEST_F(eventDrivenCollisionsTest, anEventKeepsMomentumAndAngularMomentum)
{
    open("box", 1e-6);
    const auto cloud = make
    (
        "solution{motion embeddedRK54;collisions{type eventDriven;"
        "restitution 0.7;friction 0.4;}}"
    );
    const tracked a = add
    (
        *cloud, vector(4e-4, 5e-4, 5e-4), vector(100, 3, -2), 1e-5,
        vector(1e6, -2e6, 3e6)
    );
    const tracked b = add
    (
        *cloud, vector(4.6e-4, 5.05e-4, 4.97e-4), vector(-20, 0, 1), 3e-5,
        vector(-3e6, 1e6, 1e5)
    );
    const vector p = momentum(*cloud);
    const vector L = angularMomentum(*cloud);
    const scalar E = energy(*cloud);
    step(*cloud);
    const auto& report = cloud->collisions()->lastStep();
    ASSERT_EQ(report.pairEvents, 1);
    EXPECT_LT(mag(momentum(*cloud) - p), 1e-12*mag(p));
    const scalar scale =
        mag(L) + (*a).momentOfInertia()*4e6 + (*b).momentOfInertia()*4e6;
    EXPECT_LT(mag(angularMomentum(*cloud) - L), 1e-12*scale);
    EXPECT_NEAR
    (
        (energy(*cloud) + report.restitutionLoss + report.frictionLoss)/E,
        1,
        1e-13
    );
    EXPECT_GT(report.frictionLoss, 0);
}


TEST_F(eventDrivenCollisionsTest, theGasReceivesEveryMotionOnce)
{
    // Drag, and collisions that cut motions short; nothing reaches a wall
    for (const char* motion : {"stock", "embeddedRK54"})
    {
        close();
        rmDir(root_/"case");
        open("plane", 1e-6);
        const auto cloud = make
        (
            "solution{motion " + std::string(motion) + ";coupled yes;"
            "sourceTerms{schemes{U explicit 1;}}"
            "collisions{type eventDriven;}}"
            "subModels{rotationalTorqueModel rotationalTorque;}",
            "hendersonDrag;magnus;",
            motion
        );
        add(*cloud, vector(4e-4, 5e-4, 5e-5), vector(200, 0, 0));
        add
        (
            *cloud, vector(5e-4, 5.03e-4, 5e-5), vector(-150, 0, 0), 1.2e-5,
            vector(0, 0, 1e6)
        );
        const vector p = momentum(*cloud);
        const scalar E = energy(*cloud);
        step(*cloud);
        const auto& report = cloud->collisions()->lastStep();
        ASSERT_EQ(report.pairEvents, 1);
        const vector given = gSum(cloud->UTrans());
        EXPECT_GT(mag(given), 1e-3*mag(p));
        EXPECT_LT(mag(momentum(*cloud) + given - p), 1e-12*mag(p));
        EXPECT_NEAR
        (
            (
                energy(*cloud) + gSum(cloud->ETrans())
              + report.restitutionLoss + report.frictionLoss
            )/E,
            1,
            1e-12
        );
    }
}


TEST_F(eventDrivenCollisionsTest, freeParcelsMoveAsWithoutCollisions)
{
    open("plane", 1e-6);
    for (const char* motion : {"stock", "embeddedRK54"})
    {
        vector x[2], U[2], omega[2];
        for (const bool on : {false, true})
        {
            const auto cloud = make
            (
                "solution{motion " + std::string(motion) + ";collisions "
              + (on ? "{type eventDriven;}" : "off;") + "}"
                "subModels{rotationalTorqueModel rotationalTorque;}",
                "hendersonDrag;magnus;",
                word(motion) + (on ? "On" : "Off")
            );
            const tracked p = add
            (
                *cloud, vector(4e-4, 5e-4, 5e-5), vector(200, 30, 0), 1e-5,
                vector(0, 0, 1e6)
            );
            step(*cloud, 20);
            x[on] = p.position();
            U[on] = p.U();
            omega[on] = p.omega();
        }
        // Without collisions parcels move in blocks, which round differently
        EXPECT_LT(mag(x[0] - x[1]), 1e-14*mag(x[0])) << motion;
        EXPECT_LT(mag(U[0] - U[1]), 1e-13*mag(U[0])) << motion;
        EXPECT_LT(mag(omega[0] - omega[1]), 1e-13*mag(omega[0])) << motion;
        EXPECT_GT(mag(U[0] - vector(200, 30, 0)), 10);
    }
}
