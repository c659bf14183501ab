/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Heat to a sphere: the formulas as printed with 50 digits, the
    free-molecular law against a sum over the molecules' speeds, limits, all
    Re and M, refusals.
\*---------------------------------------------------------------------------*/

#include "heatLaw.H"

#include <boost/math/special_functions/erf.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

using impact::heatLaw;

namespace
{

typedef boost::multiprecision::cpp_bin_float_50 number;

number n(const char* text)
{
    return number(text);
}


heatLaw::coefficients gas(double gamma, double Pr)
{
    heatLaw::coefficients c;
    c.gamma = gamma;
    c.Pr = Pr;
    return c;
}


//- The moments <c> and <c^3> of the speed relative to the sphere, over the
//  most probable speed of molecules, by the trapezoidal rule over the speeds
void moments(double s, double& c1, double& c3)
{
    c1 = c3 = 0;
    const double h = 1e-3;
    for (int i = 1; i*h < s + 12; ++i)
    {
        const double c = i*h;
        const double f =
            c/(std::sqrt(M_PI)*s)
           *std::exp(-(c - s)*(c - s))*(-std::expm1(-4*c*s));
        c1 += h*c*f;
        c3 += h*c*c*c*f;
    }
}

} // End anonymous namespace


TEST(heatLaw, equalsThePrintedFormulas)
{
    const number pi = boost::multiprecision::acos(number(-1));
    for (const double gamma : {1.1, 1.4, 5./3})
    {
        for (const double Pr : {0.1, 0.71, 7.})
        {
            const auto c = gas(gamma, Pr);
            auto original = c;
            original.form = "original";
            auto partial = c;
            partial.accommodation = 0.3;
            partial.recoveryFactor = 0.9;
            const auto ranz = heatLaw::New("ranzMarshall", partial);
            const auto kavanau = heatLaw::New("kavanau", c);
            const auto old = heatLaw::New("kavanau", original);
            const auto fox = heatLaw::New("fox", c);
            const auto free = heatLaw::New("freeMolecular", partial);
            for (double Re = 1e-6; Re < 1e7; Re *= 7.3)
            {
                for (double M = 1e-5; M < 60; M *= 1.9)
                {
                    const double K = M/Re;
                    const number k = K;
                    const number re = Re;
                    const number m = k*re;
                    const number pr = Pr;
                    const number g = gamma;
                    const auto compare =
                        [&]
                        (
                            const heatLaw& law,
                            const number& Nu,
                            const number& Taw
                        )
                        {
                            const heatLaw::result r = law(Re, K);
                            EXPECT_LT
                            (
                                std::fabs(double(r.Nu/Nu - 1)), 1e-12
                            ) << Re << ' ' << M;
                            EXPECT_LT
                            (
                                std::fabs(double(r.TawOverT/Taw - 1)), 1e-12
                            ) << Re << ' ' << M;
                        };
                    const number recovery = 1 + sqrt(pr)*(g - 1)/2*m*m;
                    const number Nu0 =
                        2 + n("0.6")*sqrt(re)*pow(pr, number(1)/3);
                    const number Nu1 =
                        2 + n("0.459")*pow(re, n("0.55"))*pow(pr, n("0.33"));
                    compare
                    (
                        *ranz, Nu0, 1 + number(0.9)*(g - 1)/2*m*m
                    );
                    compare
                    (
                        *kavanau, Nu0/(1 + n("3.42")*Nu0*m/(re*pr)), recovery
                    );
                    compare
                    (
                        *old, Nu1/(1 + n("3.42")*Nu1*m/(re*pr)), recovery
                    );
                    compare
                    (
                        *fox,
                        2*exp(-m)/(1 + 17*m/re)
                      + n("0.459")*pow(pr, n("0.33"))*pow(re, n("0.55"))
                       *(1 + n("0.5")*exp(-17*m/re))/n("1.5"),
                        recovery
                    );
                    const number s = m*sqrt(g/2);
                    const number gauss = exp(-s*s)/sqrt(pi);
                    const number erf = boost::math::erf(s);
                    const number c1 = gauss + (s + 1/(2*s))*erf;
                    const number c3 =
                        (s*s + n("2.5"))*gauss
                      + (s*s*s + 3*s + 3/(4*s))*erf;
                    const number z = (5 - 3*g)/(g - 1);
                    compare
                    (
                        *free,
                        number(0.3)*pr*(g + 1)/(8*g)*sqrt(2/g)*c1/k,
                        (c3/c1 + z/2)/(2 + z/2)
                    );
                }
            }
        }
    }
}


TEST(heatLaw, isTheSumOverMoleculesInFreeMolecularFlow)
{
    const double gamma = 1.4;
    const auto law = heatLaw::New("freeMolecular", gas(gamma, 0.71));
    for (const double s : {0.01, 0.3, 0.99, 1.01, 3., 8.})
    {
        double c1, c3;
        moments(s, c1, c3);
        const double M = s/std::sqrt(gamma/2);
        const double K = 1e3;
        const heatLaw::result r = (*law)(M/K, K);

        // Two internal degrees of freedom
        EXPECT_NEAR(r.TawOverT/((c3/c1 + 1)/3), 1, 1e-12) << s;
        EXPECT_NEAR
        (
            r.Nu/(0.71*2.4/(8*1.4)*std::sqrt(2/gamma)*c1/K), 1, 1e-12
        ) << s;

        // Above the total temperature
        EXPECT_GT(r.TawOverT, 1 + 0.2*M*M);
    }
}


TEST(heatLaw, hasItsLimits)
{
    const auto c = gas(1.4, 0.71);
    const auto ranz = heatLaw::New("ranzMarshall", c);
    const auto kavanau = heatLaw::New("kavanau", c);
    const auto fox = heatLaw::New("fox", c);
    const auto free = heatLaw::New("freeMolecular", c);

    for (const double Re : {0., 1e-3, 1., 1e5})
    {
        // Dense gas
        EXPECT_NEAR((*kavanau)(Re, 0).Nu/(*ranz)(Re, 0).Nu, 1, 1e-15);
        EXPECT_EQ((*kavanau)(Re, 0).TawOverT, 1);
    }
    EXPECT_EQ((*ranz)(0, 0).Nu, 2);
    EXPECT_EQ((*fox)(0, 0).Nu, 2);

    // Rarefied gas at low speed: times Re/M
    const double K = 1e6;
    EXPECT_NEAR((*kavanau)(1e-12, K).Nu*K/0.71, 0.2924, 5e-5);
    EXPECT_NEAR
    (
        (*free)(1e-12, K).Nu*K/0.71,
        2.4/(2.8*std::sqrt(2*M_PI*1.4)), 1e-12
    );
    EXPECT_NEAR((*free)(1e-12, K).Nu*K, 0.205, 5e-4);
    EXPECT_NEAR((*fox)(1e-30, K).Nu*K, 2./17, 1e-6);
    EXPECT_NEAR((*free)(0, K).TawOverT, 1, 1e-15);
}


TEST(heatLaw, isFiniteAndPositiveOnAnyInputAndInBatches)
{
    for (const std::string& name : heatLaw::names())
    {
        for (const double gamma : {1.01, 1.4, 5./3})
        {
            const auto law = heatLaw::New(name, gas(gamma, 0.7));
            const auto expectGood = [&](double Re, double K)
            {
                const heatLaw::result r = (*law)(Re, K);
                EXPECT_TRUE(std::isfinite(r.Nu) && r.Nu > 0)
                    << name << ' ' << Re << ' ' << K << ' ' << r.Nu;
                EXPECT_TRUE(std::isfinite(r.TawOverT) && r.TawOverT >= 1)
                    << name << ' ' << Re << ' ' << K << ' ' << r.TawOverT;
                heatLaw::result batch[1];
                (*law)(1, &Re, &K, batch);
                EXPECT_EQ(batch[0].Nu, r.Nu);
                EXPECT_EQ(batch[0].TawOverT, r.TawOverT);
            };
            for (int i = -300; i <= 150; i += 10)
            {
                const double Re = std::pow(10., i);
                for (int j = -300; j <= 150; j += 10)
                {
                    // 1/K would overflow below
                    if (j - i < 300 && j - i > -300)
                    {
                        expectGood(Re, std::pow(10., j - i));
                    }
                }
                expectGood(Re, 0);
                expectGood(0, Re);
            }
            expectGood(0, 0);
        }
    }
}


TEST(heatLaw, refusesWhatIsOutOfRange)
{
    const auto message =
        [](const char* name, const heatLaw::coefficients& c)
        {
            try
            {
                heatLaw::New(name, c);
            }
            catch (const std::invalid_argument& error)
            {
                return std::string(error.what());
            }
            return std::string("accepted");
        };
    heatLaw::coefficients c;
    EXPECT_EQ(message("kavanau", c), "accepted");
    c.gamma = 1.7;
    EXPECT_NE(message("fox", c).find("gamma 1.7: valid range (1, 1.66"),
        std::string::npos) << message("fox", c);
    c = gas(1.4, 0);
    EXPECT_EQ(message("fox", c), "Pr 0: valid range (0, 100]");
    c = gas(std::numeric_limits<double>::quiet_NaN(), 0.7);
    EXPECT_NE(message("fox", c), "accepted");
    c = gas(1.4, 0.7);
    c.recoveryFactor = 2.5;
    EXPECT_EQ(message("fox", c), "recoveryFactor 2.5: valid range [0, 2]");
    c.recoveryFactor = -1;
    c.accommodation = 1.5;
    EXPECT_EQ
    (
        message("freeMolecular", c), "accommodation 1.5: valid range [0, 1]"
    );
    c.accommodation = 1;
    c.form = "new";
    EXPECT_EQ
    (
        message("kavanau", c), "form new: valid range (ranzMarshall original)"
    );
    EXPECT_NE(message("kavanaugh", gas(1.4, 0.7)).find("kavanau"),
        std::string::npos);
}


TEST(heatLaw, becomesThatOfAnotherGas)
{
    for (const std::string& name : heatLaw::names())
    {
        const auto wanted = heatLaw::New(name, gas(1.3, 0.9));
        const auto law = heatLaw::New(name, gas(1.6, 0.7));
        EXPECT_NE((*law)(3, 0.2).TawOverT, (*wanted)(3, 0.2).TawOverT);
        law->set(gas(1.3, 0.9));
        EXPECT_EQ((*law)(3, 0.2).Nu, (*wanted)(3, 0.2).Nu) << name;
        EXPECT_EQ((*law)(3, 0.2).TawOverT, (*wanted)(3, 0.2).TawOverT);
    }
}
