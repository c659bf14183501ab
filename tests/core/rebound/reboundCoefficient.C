/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Functions of impact angle and speed: values, ranges, refusals.
\*---------------------------------------------------------------------------*/

#include "reboundCoefficient.H"

#include <gtest/gtest.h>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <unistd.h>

using namespace impact;

namespace
{

typedef reboundCoefficient form;

const form::quantity unit = {"normal", 0, 1};
const form::quantity ofNormal = {"normal", 0, 1, form::component::normal};
const form::quantity ofTangential =
    {"tangential", -1, 1, form::component::tangential};


//- A file that is removed again
struct textFile
{
    const std::string name =
        testing::TempDir() + "reboundCoefficient" + std::to_string(getpid());

    explicit textFile(const char* text)
    {
        std::ofstream(name) << text;
    }

    ~textFile()
    {
        std::remove(name.c_str());
    }
};

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


TEST(reboundCoefficient, constant)
{
    const auto c = form::constant(unit, 0.4);
    EXPECT_EQ(c(0, 0), 0.4);
    EXPECT_EQ(c(90, 1e9), 0.4);
    EXPECT_FALSE(c.outside(90, 1e9));
}


TEST(reboundCoefficient, tableIsBilinear)
{
    // A bilinear function is met everywhere between the points
    auto f = [](double a, double v) { return 0.1 + 0.002*a + 2e-5*a*v; };
    const std::vector<double> angles = {5, 20, 90}, speeds = {10, 100, 300};
    std::vector<double> values;
    for (const double a : angles)
    {
        for (const double v : speeds)
        {
            values.push_back(f(a, v));
        }
    }
    const auto c = form::table(unit, angles, speeds, values);
    for (double a = 5; a <= 90; a += 1.7)
    {
        for (double v = 10; v <= 300; v += 7.3)
        {
            EXPECT_NEAR(c(a, v), f(a, v), 1e-14);
            EXPECT_FALSE(c.outside(a, v));
        }
    }
    EXPECT_EQ(c(90, 300), values.back());
    EXPECT_NEAR(c(1, 100), f(5, 100), 1e-15);
    EXPECT_NEAR(c(20, 1e6), f(20, 300), 1e-15);
    EXPECT_TRUE(c.outside(1, 100));
    EXPECT_TRUE(c.outside(20, 9.9));
    EXPECT_TRUE(c.outside(20, 301));
}


TEST(reboundCoefficient, tableOfAngleAlone)
{
    const auto c = form::table(unit, {0, 90}, {0}, {1, 0.1});
    EXPECT_NEAR(c(45, 1e9), 0.55, 1e-15);
    EXPECT_FALSE(c.outside(45, 1e9));
    const auto one = form::table(unit, {30}, {0}, {0.3});
    EXPECT_EQ(one(30, 5), 0.3);
    EXPECT_EQ(one(80, 5), 0.3);
    EXPECT_FALSE(one.outside(31, 5));
}


TEST(reboundCoefficient, polynomialIsHeldInItsRange)
{
    // Above 1 by 5e-6 between two of the points that are looked at
    const double peak = 45.25*M_PI/180, bend = 0.4;
    const auto c = form::polynomial
    (
        unit, {{1 + 5e-6 - bend*peak*peak}, {2*bend*peak}, {-bend}},
        0, 90, 0, 0
    );
    EXPECT_EQ(c(45.25, 1), 1);
    EXPECT_NEAR(c(45.5, 1), 1 - 2.6e-6, 1e-7);
}


TEST(reboundCoefficient, polynomialInRadians)
{
    const auto c =
        form::polynomial(unit, {{0.9, 1e-4}, {-0.3, 0}, {0.05, 0}}, 0, 90,
            0, 500);
    const double a = 35, x = a*std::acos(-1.)/180, v = 123;
    EXPECT_NEAR(c(a, v), 0.9 + 1e-4*v - 0.3*x + 0.05*x*x, 1e-14);
    EXPECT_NEAR(c(a, 600), c(a, 500), 1e-15);
    EXPECT_TRUE(c.outside(a, 600));
    EXPECT_FALSE(c.outside(a, 499));

    const auto angleOnly =
        form::polynomial(unit, {{0.9}, {-0.3}}, 0, 90, 0, 0);
    EXPECT_FALSE(angleOnly.outside(10, 1e9));
    EXPECT_NEAR(angleOnly(0, 1e9), 0.9, 1e-15);
}


TEST(reboundCoefficient, corundumOnSteel)
{
    const form c = form::fit(ofNormal, "corundumOnSteel");
    EXPECT_EQ(c(0, 200), 1);
    EXPECT_EQ(c(90, 0), 1);
    const double s = std::sin(std::acos(-1.)/18);
    EXPECT_NEAR
    (
        c(10, 200), 1 - (1 - std::exp(-0.1*std::pow(200, 0.61)))*s, 1e-14
    );
    // What the physics page says of it
    EXPECT_NEAR(c(10, 200), 0.84, 0.005);
    EXPECT_NEAR(c(20, 200), 0.69, 0.005);
}


TEST(reboundCoefficient, GrantTabakoff)
{
    // At pi/6 and pi/2, worked out from the printed coefficients in decimals
    const form n = form::fit(ofNormal, "GrantTabakoff");
    const form t = form::fit(ofTangential, "GrantTabakoff");
    EXPECT_NEAR(n(0, 1), 0.993, 1e-15);
    EXPECT_NEAR(n(30, 1), 0.4288106995, 1e-10);
    EXPECT_NEAR(n(90, 1), 0.1784097346, 1e-10);
    EXPECT_NEAR(t(0, 1), 0.988, 1e-15);
    EXPECT_NEAR(t(30, 1), 0.6011176359, 1e-10);
    EXPECT_NEAR(t(90, 1), 0.9899187471, 1e-10);
    EXPECT_FALSE(n.dependsOnSpeed());
    EXPECT_FALSE(n.outside(90, 1e6));

    // Friction has no fit, nor is there one of corundum along the wall
    EXPECT_TRUE(form::fits(unit).empty());
    EXPECT_NE
    (
        refusal([] { form::fit(ofTangential, "corundumOnSteel"); })
       .find("no fit corundumOnSteel"),
        std::string::npos
    );
}


TEST(reboundCoefficient, McNamaraFalcon)
{
    const form c = form::McNamaraFalcon(ofNormal, 0.7, 0.3);
    EXPECT_EQ(c(90, 0), 1);
    EXPECT_DOUBLE_EQ(c(90, 0.3), 0.7);
    EXPECT_NEAR(c(30, 0.6), 0.7, 1e-14);
    EXPECT_NEAR(c(30, 0.6/32), 0.85, 1e-14);
    EXPECT_NEAR(c(30, 0.6*16), 0.35, 1e-14);
    EXPECT_TRUE(c.dependsOnSpeed());
    EXPECT_THROW
        (form::McNamaraFalcon(ofNormal, 0.7, 0), std::invalid_argument);
    EXPECT_THROW
        (form::McNamaraFalcon(ofNormal, 1.1, 1), std::invalid_argument);
}


TEST(reboundCoefficient, tableFromAFile)
{
    const textFile both
    (
        "angle,speed,value\n# as measured\n\n10, 50, 0.9\r\n10,150,0.8\n"
        "45 50 0.7\n45 150 0.6\n"
    );
    const form c = form::table(unit, both.name);
    const form same =
        form::table(unit, {10, 45}, {50, 150}, {0.9, 0.8, 0.7, 0.6});
    EXPECT_EQ(c.describe(), same.describe());
    EXPECT_EQ(c(20, 70), same(20, 70));

    {
        const textFile angleOnly("10 0.9\n20 0.8");
        const form a = form::table(unit, angleOnly.name);
        EXPECT_NEAR(a(12, 1e9), 0.88, 1e-15);
        EXPECT_FALSE(a.dependsOnSpeed());
    }
    for
    (
        const auto& [text, why] :
        std::vector<std::pair<const char*, const char*>>
        {
            {"10 50 0.9\n10 150\n", "line 2"},
            {"10 50 0.9\n10 150 x\n", "line 2"},
            {"10 50 0.9\n10 150 0.8\n20 60 0.7\n", "line 3"},
            {"10 50 0.9\n10 150 0.8\n20 50 0.7\n30 50 0.7\n", "line 4"},
            {"10 50 0.9\n10 150 0.8\n20 50 0.7\n", "need 4 values"},
            {"10 0.9\n5 0.8\n", "must increase"},
            {"10 0.9\n20 1.8\n", "values 1.8"},
            {"10\n", "line 1"},
            {"# none\n", "empty"}
        }
    )
    {
        const textFile bad(text);
        const std::string told =
            refusal([&] { form::table(unit, bad.name); });
        EXPECT_NE(told.find(why), std::string::npos) << told;
        EXPECT_NE(told.find(bad.name), std::string::npos) << told;
    }
    EXPECT_NE
    (
        refusal([] { form::table(unit, "/nowhere"); }).find("cannot be read"),
        std::string::npos
    );
}


TEST(reboundCoefficient, refusesBadInput)
{
    auto expect = [](const std::string& text, const char* word)
    {
        EXPECT_NE(text.find(word), std::string::npos) << text;
    };
    expect(refusal([] { form::constant(unit, 1.2); }), "normal 1.2");
    expect
    (
        refusal([] { form::table(unit, {10, 5}, {0}, {0.1, 0.2}); }),
        "must increase"
    );
    expect
    (
        refusal([] { form::table(unit, {10, 95}, {0}, {0.1, 0.2}); }),
        "[0, 90]"
    );
    expect
    (
        refusal([] { form::table(unit, {10, 20}, {0}, {0.1}); }),
        "need 2 values, there are 1"
    );
    expect
    (
        refusal([] { form::table(unit, {10, 20}, {0}, {0.1, 1.2}); }),
        "1.2"
    );
    expect(refusal([] { form::table(unit, {}, {0}, {}); }), "empty");
    expect
    (
        refusal
        (
            [] { form::polynomial(unit, {{0.9}, {-2}}, 0, 90, 0, 0); }
        ),
        "coefficients: the polynomial is"
    );
    expect
    (
        refusal
        (
            [] { form::polynomial(unit, {{1, 0}, {0}}, 0, 90, 0, 1); }
        ),
        "rows of"
    );
    expect(refusal([] { form::polynomial(unit, {}, 0, 90, 0, 1); }), "empty");
    expect
    (
        refusal
        (
            [] { form::polynomial(unit, {{0.5, 0}}, 0, 90, 3, 1); }
        ),
        "must increase"
    );
}
