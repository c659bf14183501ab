/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Material and heat of a sphere: enthalpy and its inverse, melting, order of
    the motion with heat, steps of a million relaxation times, what is
    radiated, refusals.
\*---------------------------------------------------------------------------*/

#include "sphereHeat.H"

#include <gtest/gtest.h>
#include <cmath>
#include <memory>
#include <stdexcept>

using namespace impact;

namespace
{

//- A sphere in a uniform gas, and what it is made of
struct scene
{
    std::unique_ptr<heatLaw> law;
    specificHeat material;
    std::unique_ptr<dragLaw> drag;
    sphereForces::counts counts;
    gasState gas;
    double d;
    double emissivity;

    explicit scene
    (
        double diameter,
        const specificHeat& m = specificHeat({800}, {}),
        double eps = 0
    )
    :
        law(heatLaw::New("ranzMarshall", {})),
        material(m),
        drag(dragLaw::New("hendersonDrag", {})),
        gas{{300, 0, 0}, {0, 0, 0}, 0.7, 2.6e-5, 500},
        d(diameter),
        emissivity(eps)
    {}

    sphereHeat heat() const
    {
        sphereHeat h
        (
            {law.get(), &material, 1005/0.71, 1.4*287.05, emissivity, 300}
        );
        h.sphere(d, 2500);
        return h;
    }

    thermalRate operator()(const thermalState& s) const
    {
        sphereForces f
        (
            drag.get(), 1.4*287.05, false, false, {0, 0, 0},
            const_cast<sphereForces::counts&>(counts)
        );
        f.sphere(d, 2500);
        const double T = material.T(s.h);
        thermalRate r;
        static_cast<motionRate&>(r) = f(gas, s.v, s.omega, T);
        heat()(gas, s.v, T, s.h, r);
        return r;
    }

    thermalState start(double T) const
    {
        thermalState s;
        s.x = s.v = s.omega = vector3{0, 0, 0};
        s.h = material.h(T);
        return s;
    }

    //- State after a time, in steps of the error control
    thermalState after(double T, double time, double tolerance) const
    {
        const particleMotion motion(tolerance);
        thermalState s = start(T);
        double hTry = time;
        for (double t = 0; t < time;)
        {
            s.x = vector3{0, 0, 0};
            const auto o = motion.step(*this, s, 300, 0, time - t, hTry, 1000);
            EXPECT_FALSE(o.forced);
            s = o.state;
            t = o.h < time - t ? t + o.h : time;
            hTry = o.hNext;
        }
        return s;
    }
};

} // End anonymous namespace


TEST(specificHeat, temperatureBelongsToEnthalpy)
{
    const specificHeat polynomial({650, 0.4, -5e-5}, {});
    const specificHeat melting({700, 0.3}, {2326, 2328, 1.07e6});
    for (double T = 1; T < 4900; T *= 1.01)
    {
        EXPECT_NEAR(polynomial.T(polynomial.h(T))/T, 1, 1e-14);
        EXPECT_NEAR(melting.T(melting.h(T))/T, 1, 1e-12);
        const double dT = 1e-4*T;
        EXPECT_NEAR
        (
            (polynomial.h(T + dT) - polynomial.h(T - dT))
           /(2*dT*polynomial.cp(T)),
            1,
            1e-8
        );
    }
    // Coefficients printed: 650 T + 0.2 T^2 - 5e-5/3 T^3 at 1000 K
    EXPECT_NEAR(polynomial.h(1000), 833333.33333333333, 1e-6);
    EXPECT_DOUBLE_EQ
    (
        melting.h(2328) - melting.h(2326),
        700*2 + 0.15*(2328.*2328 - 2326.*2326) + 1.07e6
    );
    EXPECT_DOUBLE_EQ(melting.liquidShare(2327), 0.5);

    // Beyond its temperatures a polynomial may turn back: it stays there
    const specificHeat turning({600, 1.2, -2e-4}, {}, 5000);
    EXPECT_DOUBLE_EQ(turning.cp(2e4), 600 + 1.2*5000 - 2e-4*25e6);
    EXPECT_NEAR
    (
        turning.h(2e4), turning.h(5000) + turning.cp(5000)*1.5e4, 1e-6
    );
    for (const double T : {4999., 5001., 2e4, 1e7})
    {
        EXPECT_NEAR(turning.T(turning.h(T))/T, 1, 1e-13);
        EXPECT_GT(turning.meanCp(T, turning.h(T), 0.5*T), 0);
    }

    // Trial steps of a stiff integration may take more than there is
    EXPECT_EQ(specificHeat({800}, {}).T(-1e5), 0);
    EXPECT_EQ(polynomial.T(-1e5), 0);
}


TEST(specificHeat, refusesWhatIsNoMaterial)
{
    EXPECT_THROW(specificHeat({}, {}), std::invalid_argument);
    EXPECT_THROW(specificHeat({-1}, {}), std::invalid_argument);
    EXPECT_THROW(specificHeat({800, -1}, {}), std::invalid_argument);
    EXPECT_THROW(specificHeat({800}, {900, 900, 1e5}), std::invalid_argument);
    EXPECT_THROW(specificHeat({800}, {-1, 900, 1e5}), std::invalid_argument);
    EXPECT_THROW(specificHeat({800}, {800, 900, -1}), std::invalid_argument);
    EXPECT_THROW(specificHeat({NAN}, {}), std::invalid_argument);
}


TEST(sphereHeat, ratesAreThoseOfTheEquation)
{
    scene s(1e-5, specificHeat({800}, {}), 0.6);
    const thermalState at = s.start(900);
    const thermalRate r = s(at);
    const double Re = 0.7*300*1e-5/2.6e-5;
    const double Nu = 2 + 0.6*std::sqrt(Re)*std::cbrt(0.71);
    const double lambda = 1005*2.6e-5/0.71;
    const double cp = 1.4*287.05/0.4;
    const double Taw = 500 + std::sqrt(0.71)*300*300/(2*cp);
    const double mass = 2500*M_PI/6*1e-15;
    const double q =
        M_PI*1e-5*Nu*lambda*(Taw - 900)
      - 0.6*5.670374419e-8*M_PI*1e-10*(std::pow(900, 4) - std::pow(300, 4));
    EXPECT_NEAR(r.hDot/(q/mass), 1, 1e-12);
}


TEST(sphereHeat, errorFollowsTheTolerance)
{
    scene s(2e-5, specificHeat({700, 0.3}, {}), 0.6);
    const thermalState exact = s.after(2000, 3e-3, 1e-13);
    double last = 1;
    for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9})
    {
        const thermalState found = s.after(2000, 3e-3, tolerance);
        const double error = std::fabs(found.h/exact.h - 1);
        EXPECT_LT(error, 20*tolerance);
        EXPECT_LT(error, last);
        last = error;
    }
}


TEST(sphereHeat, meltsByTheClock)
{
    // Behind the plateau by the latent heat over the power, which hardly
    // changes there
    const double L = 3e5;
    scene melts(2e-5, specificHeat({800}, {600, 600.5, L}));
    scene does(2e-5, specificHeat({800}, {}));
    melts.gas.T = does.gas.T = 1200;
    melts.gas.u = does.gas.u = vector3{0, 0, 0};
    const thermalRate r = does(does.start(600.25));
    const double more = L/r.hDot;
    const double until = 2e-3;
    const thermalState a = melts.after(300, until + more, 1e-9);
    const thermalState b = does.after(300, until, 1e-9);
    EXPECT_GT(does.material.T(b.h), 700);
    EXPECT_NEAR(melts.material.T(a.h), does.material.T(b.h), 0.05);
}


TEST(sphereHeat, longStepsEndInTheGas)
{
    for (const double latent : {0., 1e6})
    {
        const specificHeat material
        (
            {800}, {600, 601, latent}
        );
        scene s(1e-8, material);
        s.gas.T = 900;
        const thermalState at = s.start(300);
        const double k = s(at).kHeat;
        const particleMotion motion(1e-5);
        for (const double length : {10., 1e3, 1e6})
        {
            const auto o = motion.step
            (
                s, at, 300, 0, length/k, length/k, 50
            );
            if (o.h == length/k)
            {
                EXPECT_NEAR(material.T(o.state.h), 900, length > 50 ? 1 : 40)
                    << latent << ' ' << length;
            }
            EXPECT_GT(material.T(o.state.h), 299);
            EXPECT_LT(material.T(o.state.h), 950);
        }
    }
}


TEST(sphereHeat, radiatedIsTheIntegral)
{
    scene s(1e-5, specificHeat({800}, {}), 0.8);
    const sphereHeat heat = s.heat();

    // Temperatures on an exponential way, summed finely
    for (const double z : {0., 1e-3, 0.1, 1.})
    {
        const double T0 = 1000, T1 = 990, t = 1e-3;
        double sum = 0;
        const int n = 20000;
        for (int i = 0; i < n; ++i)
        {
            const double x = (i + 0.5)/n;
            const double share =
                z > 0 ? std::expm1(-z*x)/std::expm1(-z) : x;
            sum += heat.radiated(T0 + (T1 - T0)*share)*t/n;
        }
        EXPECT_NEAR(heat.radiatedIn(t, T0, T1, z/t)/sum, 1, 2e-4) << z;
    }
    EXPECT_NEAR(heat.radiatedIn(1e-3, 1000, 300, 1e9), 0, 1);
}


TEST(specificHeat, nothingOnTheWayTakesMoreThanTheSteepest)
{
    const specificHeat metal({700, 0.3}, {600, 610, 5e5});
    for (double T = 300; T < 1500; T += 7.3)
    {
        for (double end = 305; end < 1500; end += 11.1)
        {
            const double steepest = metal.steepestCp(T, end);
            for (int i = 1; i <= 50; ++i)
            {
                const double x = T + 0.02*i*(end - T);
                ASSERT_LE
                (
                    std::fabs(metal.h(x) - metal.h(T)),
                    steepest*std::fabs(x - T)*(1 + 1e-9) + 1e-6
                ) << T << " to " << x;
            }
        }
    }
    const specificHeat constant({900}, {});
    EXPECT_EQ(constant.steepestCp(300, 800), 900);
}
