/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Departures drawn from a table against visits followed one by one, at and
    between its angles of incidence; the file; what does not fit is refused.
\*---------------------------------------------------------------------------*/

#include "scatteringTable.H"
#include "scatteringSampler.H"

#include <gtest/gtest.h>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <unistd.h>

using namespace impact;

namespace
{

constexpr double degree = 3.14159265358979323846/180;


scatteringSampler::setup rough()
{
    scatteringSampler::setup s;
    s.body = convexBody::box({32e-6, 25.6e-6, 25.6e-6});
    s.wall = std::make_shared<const relief>
    (
        relief::rough(80e-6, 10e-6, 20e-6)
    );
    s.speed = 200;
    return s;
}


vector3 arrival(double incidence, double speed)
{
    return
    {
        speed*std::cos(incidence*degree), -speed*std::sin(incidence*degree), 0
    };
}


impactKey key(int i)
{
    return impactKey::ofTime(7, 0, i, 1, 0, 0);
}


//- Means, and deviations of the means, of what a departure holds
struct moments
{
    static constexpr int nMoments = 9;
    double sum[nMoments] = {}, square[nMoments] = {};
    int n = 0;

    void add(const wallDeparture& d, double speed, double radius)
    {
        const double alpha = std::atan2(d.V.y, d.V.x);
        const double beta = std::atan2(d.V.z, std::hypot(d.V.x, d.V.y));
        const double v = mag(d.V)/speed;
        const double w = radius*d.omega.z/speed;
        const double x[nMoments] =
        {
            alpha, beta*beta, v, w, alpha*alpha, alpha*v, v*w,
            beta*d.omega.x*radius/speed, 2*d.rotation1/(speed*speed)
        };
        for (int i = 0; i < nMoments; ++i)
        {
            sum[i] += x[i];
            square[i] += x[i]*x[i];
        }
        ++n;
    }

    double mean(int i) const
    {
        return sum[i]/n;
    }

    double error2(int i) const
    {
        return (square[i]/n - mean(i)*mean(i))/n;
    }
};


std::string folder()
{
    return std::filesystem::temp_directory_path();
}


//- A file that is gone with its name
struct tableFile
{
    std::string name;

    explicit tableFile(const std::string& text)
    :
        name(folder() + "/parcelImpactTable" + std::to_string(::getpid()))
    {
        std::ofstream(name) << text;
    }

    ~tableFile()
    {
        std::filesystem::remove(name);
    }
};


std::string written(const scatteringTable& table)
{
    std::string text;
    table.write([&](const char* part) { text += part; });
    return text;
}


template<class Action>
std::string refusal(Action action)
{
    try
    {
        action();
    }
    catch (const std::invalid_argument& error)
    {
        return error.what();
    }
    return "none";
}

} // End anonymous namespace


TEST(scatteringTable, departsAsVisitsDo)
{
    const scatteringSampler::setup s = rough();
    const int rows = 20000, n = 20000;
    const scatteringTable table(s, {8, 15, 22, 30}, rows);
    nonSphericalRebound wall(s);
    const double d = wall.diameter();
    for (const double incidence : {8., 15., 18.5, 27.})
    {
        moments drawn, followed;
        for (int i = 0; i < n; ++i)
        {
            bool outside;
            const vector3 V = arrival(incidence, 150);
            drawn.add
            (
                table.depart(V, d, key(i), outside), 150, s.body.radius()
            );
            EXPECT_FALSE(outside);
            followed.add
            (
                wall.depart(V, {0, 0, 0}, d, key(i)), 150, s.body.radius()
            );
        }
        for (int i = 0; i < moments::nMoments; ++i)
        {
            // The table itself is a sample of as many visits as it has rows
            const double error = std::sqrt
            (
                drawn.error2(i) + followed.error2(i)
              + drawn.error2(i)*n/rows
            );
            EXPECT_NEAR(drawn.mean(i), followed.mean(i), 5*error)
                << "moment " << i << " at " << incidence;
        }
    }
}


TEST(scatteringTable, leadsNoParticleIntoTheWall)
{
    // Without restitution many visits are ended on their way into the wall
    scatteringSampler::setup s = rough();
    s.law = reboundLaw::coulomb(0, 0.2);
    const int n = 4000;
    const scatteringTable table(s, {30, 60}, n);
    const tableFile file(written(table));
    const scatteringTable read(file.name);
    nonSphericalRebound wall(s);
    const double d = wall.diameter();
    double along[3] = {};
    for (int i = 0; i < n; ++i)
    {
        bool outside;
        const vector3 V = arrival(30, 150);
        const vector3 out[3] =
        {
            table.depart(V, d, key(i), outside).V,
            read.depart(V, d, key(i), outside).V,
            wall.depart(V, {0, 0, 0}, d, key(i)).V
        };
        for (int k = 0; k < 3; ++k)
        {
            EXPECT_GE(out[k].y, 0);
            along[k] += out[k].y < 1e-6*mag(out[k]);
        }
        EXPECT_GE(table.depart(arrival(45, 150), d, key(i), outside).V.y, 0);
    }
    EXPECT_GT(along[2], 0.2*n);
    EXPECT_NEAR(along[0], along[2], 5*std::sqrt(2.*n*0.25));
    EXPECT_NEAR(along[1], along[2], 5*std::sqrt(2.*n*0.25));
}


TEST(scatteringTable, keepsVisitsTogether)
{
    // On a smooth wall a sphere has one outcome at each incidence, and each
    // quantity is monotonic in it: between two angles all of a departure but
    // alpha must come from one of them
    scatteringSampler::setup s;
    s.body = convexBody::sphere(2e-5);
    const scatteringTable table(s, {10, 20}, 5);
    int low = 0;
    for (int i = 0; i < 4000; ++i)
    {
        bool outside;
        const wallDeparture d =
            table.depart(arrival(14, 10), 2e-5, key(i), outside);
        const double alpha = std::atan2(d.V.y, d.V.x);
        auto exact = [](double a) { return std::atan(1.12*std::tan(a)); };
        EXPECT_NEAR
        (
            alpha, 0.6*exact(10*degree) + 0.4*exact(20*degree), 1e-6
        );
        const double v = mag(d.V)/10;
        auto speed = [&](double a)
        {
            return std::hypot(5./7*std::cos(a), 0.8*std::sin(a));
        };
        const bool first = std::fabs(v - speed(10*degree)) < 1e-6;
        EXPECT_TRUE(first || std::fabs(v - speed(20*degree)) < 1e-6);
        low += first;

        // Rolling at the incidence that was chosen
        EXPECT_NEAR
        (
            d.omega.z*1e-5/10,
            -5./7*std::cos((first ? 10 : 20)*degree), 1e-5
        );
    }
    EXPECT_NEAR(low, 2400, 5*std::sqrt(4000*0.24));
}


TEST(scatteringTable, scalesWithSpeedAndSize)
{
    scatteringSampler::setup s = rough();
    s.wall = nullptr;
    const scatteringTable table(s, {10, 20}, 100);
    bool outside;
    const wallDeparture a =
        table.depart(arrival(14, 10), 2e-5, key(3), outside);
    const wallDeparture b =
        table.depart(arrival(14, 30), 4e-5, key(3), outside);
    EXPECT_NEAR(b.V.x, 3*a.V.x, 1e-12);
    EXPECT_NEAR(b.omega.z, 1.5*a.omega.z, 1e-9*std::fabs(a.omega.z));
    EXPECT_NEAR(b.rotation1, 9*a.rotation1, 1e-12);
    const vector3 V = arrival(14, 10);
    const wallDeparture c =
        table.depart({-V.x, V.y, 0}, 2e-5, key(3), outside);
    EXPECT_EQ(c.V.x, -a.V.x);
    EXPECT_EQ(c.V.z, -a.V.z);
    EXPECT_EQ(c.omega.x, -a.omega.x);

    table.depart(arrival(9.9, 10), 2e-5, key(3), outside);
    EXPECT_TRUE(outside);
    table.depart(arrival(20.1, 10), 2e-5, key(3), outside);
    EXPECT_TRUE(outside);
    table.depart(arrival(20, 10), 2e-5, key(3), outside);
    EXPECT_FALSE(outside);
}


//- Of a law of the local speed: restitution falls from 0.9 to 0.4 between 1
//  and 25 m/s, friction rises from 0.05 to 0.4
struct ofSpeed
{
    scatteringSampler::setup s;
    scatteringTable table;

    static scatteringSampler::setup setup()
    {
        typedef reboundCoefficient form;
        scatteringSampler::setup s = rough();
        s.law = reboundLaw
        (
            reboundLaw::lawType::friction,
            form::McNamaraFalcon(form::restitutionQuantity(), 0.9, 1),
            form::polynomial
            (
                form::frictionQuantity(), {{0.05, 0.014}}, 0, 90, 0, 25
            )
        );
        return s;
    }

    explicit ofSpeed(int rows, const std::vector<double>& speeds = {2, 5, 20})
    :
        s(setup()),
        table(s, {15, 20}, rows, speeds)
    {}
};


TEST(scatteringTable, departsAsVisitsDoAtEachSpeed)
{
    const int rows = 20000, n = 20000;
    const ofSpeed of(rows, {2, 2.6, 3.4, 4.4, 5.7, 7.4, 9.7, 12.5, 16.2, 21});
    nonSphericalRebound wall(of.s);
    const double d = wall.diameter();
    bool outside;
    double before[moments::nMoments] = {};
    for (const double speed : {3.3, 7., 14.})
    {
        moments drawn, followed;
        double gap = 0;
        for (int i = 0; i < n; ++i)
        {
            const vector3 V = arrival(17, speed);
            const wallDeparture one = of.table.depart(V, d, key(i), outside);
            EXPECT_FALSE(one.held || outside);
            drawn.add(one, speed, of.s.body.radius());
            followed.add
            (
                wall.depart(V, {0, 0, 0}, d, key(i)), speed,
                of.s.body.radius()
            );
        }
        for (int i = 0; i < moments::nMoments; ++i)
        {
            // The table itself is a sample of as many visits as it has rows
            const double error = std::sqrt
            (
                drawn.error2(i) + followed.error2(i)
              + drawn.error2(i)*n/rows
            );
            EXPECT_NEAR(drawn.mean(i), followed.mean(i), 5*error)
                << "moment " << i << " at " << speed << " m/s";
            gap = std::max
            (
                gap, std::fabs(followed.mean(i) - before[i])/error
            );
            before[i] = followed.mean(i);
        }
        // A table of one of these speeds would not do for the next
        if (speed > 4)
        {
            EXPECT_GT(gap, 20);
        }
    }
}


TEST(scatteringTable, choosesAmongSpeeds)
{
    // A sphere on a smooth wall has one outcome at each speed: between two of
    // them alpha lies in proportion to the logarithm, and all else is of one
    scatteringSampler::setup s = ofSpeed::setup();
    s.body = convexBody::sphere(2e-5);
    s.wall = nullptr;
    const scatteringTable table(s, {30}, 5, {2, 8});
    const double share = std::log(3/2.)/std::log(8/2.);
    bool outside;
    const wallDeparture low =
        table.depart(arrival(30, 2), 2e-5, key(0), outside);
    const wallDeparture high =
        table.depart(arrival(30, 8), 2e-5, key(0), outside);
    const double a = std::atan2(low.V.y, low.V.x);
    const double b = std::atan2(high.V.y, high.V.x);
    EXPECT_GT(std::fabs(a - b), 0.02);
    EXPECT_FALSE(low.held || high.held);
    int slow = 0;
    for (int i = 0; i < 4000; ++i)
    {
        const wallDeparture d =
            table.depart(arrival(30, 3), 2e-5, key(i), outside);
        EXPECT_NEAR
        (
            std::atan2(d.V.y, d.V.x), (1 - share)*a + share*b, 1e-6
        );
        const bool first = std::fabs(mag(d.V)/3 - mag(low.V)/2) < 1e-6;
        const wallDeparture& one = first ? low : high;
        const double v = first ? 2 : 8;
        EXPECT_NEAR(mag(d.V)/3, mag(one.V)/v, 1e-6);
        EXPECT_NEAR(d.omega.z/3, one.omega.z/v, 1e-5*std::fabs(one.omega.z));
        EXPECT_NEAR(d.rotation1/9, one.rotation1/(v*v), 1e-6*one.rotation1);
        slow += first;
    }
    EXPECT_NEAR
    (
        slow, 4000*(1 - share), 5*std::sqrt(4000*share*(1 - share))
    );

    // Outside: the nearest speed
    const wallDeparture slower =
        table.depart(arrival(30, 1.999), 2e-5, key(0), outside);
    EXPECT_TRUE(slower.held);
    EXPECT_NEAR(mag(slower.V)/1.999, mag(low.V)/2, 1e-12);
    EXPECT_TRUE
    (
        table.depart(arrival(30, 8.001), 2e-5, key(0), outside).held
    );
}


TEST(scatteringTable, readsWhatItWrites)
{
    const scatteringTable table(rough(), {10, 20.5, 90}, 30);
    const tableFile file(written(table));
    const scatteringTable read(file.name);
    EXPECT_EQ(read.incidences(), table.incidences());
    ASSERT_EQ(read.nRows(), 30);
    EXPECT_NEAR(read.diameter(), table.diameter(), 1e-16);
    for (int i = 0; i < 3; ++i)
    {
        for (int k = 0; k < 30; ++k)
        {
            const auto& a = table.rows(i)[k];
            const auto& b = read.rows(i)[k];
            EXPECT_NEAR(a.alpha, b.alpha, 1e-6);
            EXPECT_NEAR(a.beta, b.beta, 1e-6);
            EXPECT_NEAR(a.speed, b.speed, 1e-6);
            EXPECT_NEAR(a.spin[0], b.spin[0], 1e-5);
            EXPECT_NEAR(a.rotation, b.rotation, 1e-5);
        }
    }
    read.checkCovers(rough(), 10, 90);
    EXPECT_TRUE(read.speeds().empty());

    const ofSpeed of(30);
    const tableFile speeds(written(of.table));
    const scatteringTable again(speeds.name);
    EXPECT_EQ(again.speeds(), of.table.speeds());
    EXPECT_EQ(again.incidences(), of.table.incidences());
    for (int i = 0; i < 2; ++i)
    {
        for (int j = 0; j < 3; ++j)
        {
            for (int k = 0; k < 30; ++k)
            {
                const auto& a = of.table.rows(i, j)[k];
                const auto& b = again.rows(i, j)[k];
                EXPECT_NEAR(a.alpha, b.alpha, 1e-6);
                EXPECT_NEAR(a.speed, b.speed, 1e-6);
                EXPECT_NEAR(a.rotation, b.rotation, 1e-5);
            }
        }
    }
    again.checkCovers(of.s, 15, 20, 2, 20);
}


TEST(scatteringTable, readsTablesWithoutSpeeds)
{
    // As written before there were speeds: the same text today
    scatteringSampler::setup s;
    s.body = convexBody::sphere(2e-5);
    const std::string text(written(scatteringTable(s, {30}, 2)));
    EXPECT_EQ(text.find("# scatteringResponse version 2\n"), 0u);
    EXPECT_EQ(text.find("nSpeeds"), std::string::npos);
    EXPECT_NE
    (
        text.find
        (
            "\nalpha1_deg,alpha2_deg,beta2_deg,speedRatio,spinX,spinY,spinZ,"
            "rotation\n30,32.8"
        ),
        std::string::npos
    ) << text;
}


TEST(scatteringTable, refusesFilesThatAreNone)
{
    const std::string good
    (
        written(scatteringTable(rough(), {10, 20}, 30))
    );
    auto complaint = [](const std::string& text)
    {
        const tableFile file(text);
        return refusal([&] { scatteringTable{file.name}; });
    };
    auto edited = [&](const std::string& from, const std::string& to)
    {
        std::string text(good);
        return complaint(text.replace(text.find(from), from.size(), to));
    };
    auto expect = [](const std::string& text, const char* word)
    {
        EXPECT_NE(text.find(word), std::string::npos) << text;
    };
    EXPECT_EQ(complaint(good), "none");
    std::string foreign;
    for (const char c : good)
    {
        foreign += c == '\n' ? "\r\n" : std::string(1, c);
    }
    EXPECT_EQ(complaint(foreign), "none");
    expect
    (
        refusal([] { scatteringTable("/nowhere/table.csv"); }),
        "cannot be read"
    );
    expect(edited("version 2", "version 1"), "version 1");
    expect(complaint(good.substr(0, good.size() - 40)), "row 60 of 60");
    expect(edited("# nRows 30", "# nRows 31"), "not in order");
    expect(edited("# nRows 30", "# nRows 29"), "must increase");
    expect(complaint(good + "20,1,1,1,1,1,1,1\n"), "goes on");
    expect(edited("# nRows 30", "# nRows 0"), "nRows 0");
    expect(edited("spinX,", ""), "columns");
    expect(edited("\n20,", "\n5,"), "must increase");
}


TEST(scatteringTable, refusesSpeedsThatAreNone)
{
    const ofSpeed of(3);
    const std::string good(written(of.table));
    auto complaint = [&](const std::string& from, const std::string& to)
    {
        std::string text(good);
        const tableFile file(text.replace(text.find(from), from.size(), to));
        return refusal([&] { scatteringTable{file.name}; });
    };
    auto expect = [](const std::string& text, const char* word)
    {
        EXPECT_NE(text.find(word), std::string::npos) << text;
    };
    EXPECT_EQ(complaint("", ""), "none");
    expect(complaint("version 3", "version 2"), "columns");
    expect(complaint("# nSpeeds 3\n", ""), "nSpeeds 0");
    expect(complaint("# nSpeeds 3", "# nSpeeds 4"), "row 19 of 24");
    expect(complaint("# nSpeeds 3", "# nSpeeds 2"), "goes on");
    expect(complaint("speed1,", ""), "columns");
    expect(complaint("\n2,15,", "\n-2,15,"), "speed -2");
    expect(complaint("\n5,15,", "\n1,15,"), "speed 1 follows 2");
    expect(complaint("\n5,20,", "\n5,21,"), "alike at each speed");
    expect(complaint("\n5,20,", "\n4,20,"), "alike at each speed");

    auto covers = [&](double slowest, double fastest)
    {
        return refusal
        (
            [&] { of.table.checkCovers(of.s, 15, 20, slowest, fastest); }
        );
    };
    EXPECT_EQ(covers(2, 20), "none");
    expect(covers(1.9, 20), "2 to 20 m/s, this wall needs 1.9 to 20");
    expect(covers(2, 21), "this wall needs 2 to 21");

    auto made = [](const scatteringSampler::setup& s, std::vector<double> v)
    {
        return refusal([&] { scatteringTable(s, {10, 20}, 5, v); });
    };
    expect(made(of.s, {}), "needs speeds");
    expect(made(of.s, {3, 3}), "speed 3 of a table follows 3");
    expect(made(of.s, {-1, 3}), "speed");
    expect(made(rough(), {2, 3}), "holds for every speed");

    // One with this law but no speeds
    scatteringTable constant(rough(), {15, 20}, 3);
    std::string text(written(constant));
    const std::string law(good.substr(good.find("# law")));
    text.replace
    (
        text.find("# law"), text.find('\n', text.find("# law"))
      - text.find("# law"), law.substr(0, law.find('\n'))
    );
    const tableFile file(text);
    expect
    (
        refusal
        (
            [&] { scatteringTable(file.name).checkCovers(of.s, 15, 20, 2, 20); }
        ),
        "holds no speeds"
    );
}


TEST(scatteringTable, refusesAnotherWall)
{
    const scatteringTable table(rough(), {10, 20}, 30);
    auto expect = [&](const scatteringSampler::setup& s, const char* word)
    {
        const std::string text = refusal([&] { table.checkCovers(s, 10, 20); });
        EXPECT_NE(text.find(word), std::string::npos) << text;
    };
    table.checkCovers(rough(), 10, 20);
    scatteringSampler::setup s = rough();
    s.body = convexBody::box({32e-6, 25.6e-6, 20e-6});
    expect(s, "shape");
    s.body = convexBody::ellipsoid({32e-6, 25.6e-6, 25.6e-6});
    expect(s, "shape");
    s.body = convexBody::box({64e-6, 51.2e-6, 51.2e-6});
    expect(s, "size");
    s = rough();
    s.law = reboundLaw::restitution(0.7, 0);
    expect(s, "law restitution 0.8 0");
    s.law = reboundLaw::coulomb(0.8, 0);
    expect(s, "law friction");
    typedef reboundCoefficient form;
    const auto tangential =
        form::constant(reboundLaw::tangentialQuantity(), 0);
    s.law = reboundLaw
    (
        reboundLaw::lawType::restitution,
        form::fit(reboundLaw::normalQuantity(), "GrantTabakoff"), tangential
    );
    expect(s, "law restitution polynomial");
    scatteringTable(s, {10, 20}, 30).checkCovers(s, 10, 20);
    s = rough();
    s.wall = std::make_shared<const relief>
    (
        relief::rough(80e-6, 10e-6, 21e-6)
    );
    expect(s, "wall rough");
    s.wall = nullptr;
    expect(s, "wall smooth");
    s = rough();
    s.orientation = orientationLaw::uniformEuler;
    expect(s, "orientation");
    s = rough();
    s.treatment = visitTreatment::firstImpact;
    expect(s, "treatment");
    s = rough();
    s.spin = {0, 0, 1};
    const scatteringTable turning(s, {10, 20}, 30);
    EXPECT_NE
    (
        refusal([&] { turning.checkCovers(s, 10, 20); }).find("spin"),
        std::string::npos
    );

    s = rough();
    EXPECT_NE
    (
        refusal([&] { table.checkCovers(s, 5, 20); }).find("5 to 20"),
        std::string::npos
    );
    EXPECT_NE
    (
        refusal([&] { table.checkCovers(s, 10, 21); }).find("10 to 20"),
        std::string::npos
    );
    EXPECT_NE
    (
        refusal([&] { scatteringTable(s, {20, 10}, 5); }).find("increase"),
        std::string::npos
    );
}
