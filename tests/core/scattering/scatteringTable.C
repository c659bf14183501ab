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
    s.law = reboundLaw::restitution
    (
        form::fit(reboundLaw::normalQuantity(), "GrantTabakoff"), tangential
    );
    expect(s, "law restitution polynomial");
    scatteringTable(s, {10, 20}, 30).checkCovers(s, 10, 20);
    s.law = reboundLaw::restitution
    (
        form::fit(reboundLaw::normalQuantity(), "corundumOnSteel"), tangential
    );
    expect(s, "must not depend on");
    EXPECT_NE
    (
        refusal([&] { scatteringTable(s, {10, 20}, 30); })
       .find("must not depend on"),
        std::string::npos
    );
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
