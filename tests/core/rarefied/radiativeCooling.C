/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Temperature of a radiating sphere: against values computed elsewhere,
    against a numerical integration of the energy balance written here, the
    table against the closed form, and limits.
\*---------------------------------------------------------------------------*/

#include "radiativeCooling.H"
#include "largest.H"

#include <gtest/gtest.h>
#include <cmath>
#include <stdexcept>

using namespace impact;

namespace
{

double heatCapacity(const radiativeCooling::setup& s, double T)
{
    const auto& c = s.heatCapacity;
    if (c.size() == 1 || T <= c.front().first)
    {
        return c.front().second;
    }
    for (std::size_t i = 1; i < c.size(); ++i)
    {
        if (T < c[i].first)
        {
            const double f =
                (T - c[i - 1].first)/(c[i].first - c[i - 1].first);
            return c[i - 1].second + f*(c[i].second - c[i - 1].second);
        }
    }
    return c.back().second;
}


//- The balance as it stands, by Runge-Kutta with steps of a share of the
//  time the temperature changes in
double integrated
(
    const radiativeCooling::setup& s,
    double T,
    double diameter,
    double time
)
{
    const double R = 0.5*diameter;
    auto slope = [&](double T)
    {
        const double in =
            (s.absorptivity*(s.sunlight + s.reflected)
          + s.emissivity*s.infrared)*M_PI*R*R;
        const double out =
            4*M_PI*R*R*s.emissivity*5.670374419184429e-8*T*T*T*T;
        const double m = 4./3*M_PI*R*R*R*s.density;
        return (in - out)/(m*heatCapacity(s, T));
    };
    double t = 0;
    while (t < time)
    {
        const double fast = 4*s.emissivity*5.67e-8*T*T*T*3
            /(R*s.density*heatCapacity(s, T)) + std::fabs(slope(T))/T;
        const double h = std::min(0.004/(fast + 1e-300), time - t);
        const double k1 = slope(T), k2 = slope(T + 0.5*h*k1);
        const double k3 = slope(T + 0.5*h*k2), k4 = slope(T + h*k3);
        T += h/6*(k1 + 2*k2 + 2*k3 + k4);
        t += h;
    }
    return T;
}


std::string complaint(const radiativeCooling::setup& s, double T = 300)
{
    try
    {
        radiativeCooling(s).start(T);
    }
    catch (const std::invalid_argument& error)
    {
        return error.what();
    }
    return "accepted";
}

} // End anonymous namespace


TEST(radiativeCooling, reproducesTheValuesOfTheDigest)
{
    // Computed by another program from the same balance
    const radiativeCooling cooling((radiativeCooling::setup()));
    EXPECT_NEAR(cooling.equilibrium(), 278.68, 0.005);
    EXPECT_NEAR(cooling.after(2200, 20e-6, 10), 308.29, 0.005);
    EXPECT_NEAR(cooling.after(2200, 200e-6, 70), 330.55, 0.005);
    EXPECT_NEAR(cooling.eulerLimit(2200, 20e-6), 13e-3, 0.5e-3);
}


TEST(radiativeCooling, satisfiesTheEnergyBalance)
{
    for (double alpha : {0., 0.5, 1.})
    {
        for (double eps : {0., 0.1, 1.})
        {
            radiativeCooling::setup s;
            s.absorptivity = alpha;
            s.emissivity = eps;
            s.reflected = 100;
            s.infrared = 240;
            const radiativeCooling cooling(s);
            for (double T : {3., 150., 278., 500., 3500.})
            {
                for (double d : {1e-6, 20e-6, 1e-3})
                {
                    for (double t : {1e-3, 0.5, 70.})
                    {
                        const double exact = integrated(s, T, d, t);
                        EXPECT_NEAR
                        (
                            cooling.after(T, d, t), exact, 1e-9*exact
                        ) << alpha << ' ' << eps << ' ' << T << ' ' << d
                            << ' ' << t;
                    }
                }
            }
        }
    }
}


TEST(radiativeCooling, takesAHeatCapacityThatDependsOnTheTemperature)
{
    radiativeCooling::setup s;
    s.heatCapacity =
        {{100, 130}, {300, 780}, {600, 1080}, {1200, 1240}, {3000, 1400}};
    const radiativeCooling cooling(s);
    for (double T : {120., 270., 299., 301., 2200., 3000.})
    {
        for (double t : {1e-3, 0.1, 1., 10., 70.})
        {
            const double exact = integrated(s, T, 20e-6, t);
            EXPECT_NEAR(cooling.after(T, 20e-6, t), exact, 1e-8*exact);
            radiativeCooling::state state = cooling.start(T);
            state.y += t*cooling.rate(20e-6);
            const double inverted = cooling.exactTemperature(state);
            EXPECT_NEAR
            (
                cooling.temperature(state), inverted, 1e-9*inverted
            ) << T << ' ' << t;
        }
    }
}


TEST(radiativeCooling, tabulatesTheClosedFormTo1em10)
{
    for (double alpha : {0., 0.5})
    {
        for (double eps : {0., 0.5})
        {
            radiativeCooling::setup s;
            s.absorptivity = alpha;
            s.emissivity = eps;
            const radiativeCooling cooling(s);
            const double rate = cooling.rate(20e-6);
            for (double T : {1., 250., 279., 2200., 1e5})
            {
                double worst = 0;
                for (int i = -400; i < 400; ++i)
                {
                    radiativeCooling::state state = cooling.start(T);
                    state.y += rate*std::pow(10., 0.0173*i);
                    const double exact = cooling.exactTemperature(state);
                    worst = largest
                    (
                        worst,
                        std::fabs(cooling.temperature(state)/exact - 1)
                    );
                }
                EXPECT_LT(worst, 1e-10) << alpha << ' ' << eps << ' ' << T;
            }
        }
    }
}


TEST(radiativeCooling, staysAtTheEquilibrium)
{
    const radiativeCooling cooling((radiativeCooling::setup()));
    const double T = cooling.equilibrium();
    for (double t : {0., 1., 1e5, 1e12})
    {
        EXPECT_NEAR(cooling.after(T, 1e-8, t), T, 1e-12*T);
        EXPECT_NEAR(cooling.after(T, 1e-2, t), T, 1e-12*T);
    }
    for (double start : {1., 3000.})
    {
        EXPECT_NEAR(cooling.after(start, 1e-8, 1e5), T, 1e-12*T);
        radiativeCooling::state s = cooling.start(start);
        s.y += cooling.rate(1e-8)*1e5;
        EXPECT_NEAR(cooling.temperature(s), T, 1e-12*T);
    }
    radiativeCooling::setup dark;
    dark.absorptivity = 0;
    dark.emissivity = 0;
    const radiativeCooling none(dark);
    EXPECT_EQ(none.rate(1e-5), 0);
    EXPECT_NEAR(none.after(777, 1e-5, 1e5), 777, 1e-9);
    EXPECT_NEAR(none.temperature(none.start(777)), 777, 1e-9);
    dark.emissivity = 1;
    EXPECT_EQ(radiativeCooling(dark).equilibrium(), 0);
    EXPECT_GT(radiativeCooling(dark).after(777, 1e-8, 1e5), 0);
}


TEST(radiativeCooling, stepsExplicitlyToFirstOrder)
{
    const radiativeCooling cooling((radiativeCooling::setup()));
    auto step = [&](double T, double deltaT)
    {
        return
            T
          + deltaT
           *(cooling.eulerHeat(20e-6) - cooling.eulerLoss(20e-6)*T*T*T*T);
    };
    const double exact = cooling.after(2200, 20e-6, 1);
    double last = 0;
    for (int n : {400, 800, 1600})
    {
        double T = 2200;
        for (int i = 0; i < n; ++i)
        {
            T = step(T, 1./n);
        }
        const double error = std::fabs(T - exact);
        if (last > 0)
        {
            EXPECT_NEAR(last/error, 2, 0.1);
        }
        last = error;
    }

    // Up to the limit the equilibrium is not passed, twice that it is
    const double T = cooling.equilibrium();
    const double limit = cooling.eulerLimit(T, 20e-6);
    EXPECT_GT(step(1.0001*T, 0.99*limit), T);
    EXPECT_LT(step(1.0001*T, 1.01*limit), T);
}


TEST(radiativeCooling, refusesWhatIsOutOfRange)
{
    radiativeCooling::setup s;
    EXPECT_EQ(complaint(s), "accepted");
    auto has = [](const std::string& text, const char* words)
    {
        return text.find(words) != std::string::npos;
    };
    EXPECT_TRUE(has(complaint(s, 0), "temperature 0: valid range [1e-06"));
    EXPECT_TRUE(has(complaint(s, 1e9), "1e+08"));
    s.density = 0;
    EXPECT_TRUE(has(complaint(s), "density 0: valid range (0, 1e6)"));
    s = {};
    s.absorptivity = 1.1;
    EXPECT_TRUE(has(complaint(s), "absorptivity 1.1: valid range [0, 1]"));
    s = {};
    s.emissivity = -0.1;
    EXPECT_TRUE(has(complaint(s), "emissivity -0.1"));
    s = {};
    s.sunlight = -1;
    EXPECT_TRUE(has(complaint(s), "sunlight -1"));
    s = {};
    s.heatCapacity = {{0, 0}};
    EXPECT_TRUE(has(complaint(s), "heatCapacity 0"));
    s.heatCapacity = {};
    EXPECT_TRUE(has(complaint(s), "empty"));
    s.heatCapacity = {{300, 800}, {200, 900}};
    EXPECT_TRUE(has(complaint(s), "greater than the one before"));
    s.heatCapacity = {{300, 800}, {2000, 900}};
    EXPECT_TRUE(has(complaint(s), "equilibrium temperature 278"));
    s.heatCapacity = {{200, 800}, {2000, 900}};
    EXPECT_TRUE(has(complaint(s, 2100), "[200, 2000]"));
}
