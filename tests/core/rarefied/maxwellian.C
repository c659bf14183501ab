/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The samples of an equilibrium gas against moments of their densities, and
    the flux through a surface against its integral, all by quadrature.
\*---------------------------------------------------------------------------*/

#include "maxwellian.H"

#include <gtest/gtest.h>
#include <cmath>
#include <functional>

using namespace impact;

namespace
{
    //- Midpoint rule: integrands vanish, or are smooth, at both ends
    double integral(const std::function<double(double)>& f, double a, double b)
    {
        const int n = 200000;
        double sum = 0;
        for (int i = 0; i < n; ++i)
        {
            sum += f(a + (i + 0.5)*(b - a)/n);
        }
        return sum*(b - a)/n;
    }

    //- Mean and standard error of some power of a sample
    struct sampleMean
    {
        double value, error;
    };

    sampleMean mean
    (
        const std::function<double(counterRandom&)>& draw,
        int power
    )
    {
        const int n = 400000;
        counterRandom rnd(17, power);
        double sum = 0, sum2 = 0;
        for (int i = 0; i < n; ++i)
        {
            const double x = std::pow(draw(rnd), power);
            sum += x;
            sum2 += x*x;
        }
        const double m = sum/n;
        return {m, std::sqrt((sum2/n - m*m)/n)};
    }
}


TEST(maxwellian, fluxIsTheIntegralOfInwardVelocities)
{
    for (const double s : {-4., -1.5, -0.2, 0., 0.3, 2., 8.})
    {
        const double exact = integral
        (
            [s](double x) { return x*std::exp(-(x - s)*(x - s)); },
            0,
            s + 8
        )/std::sqrt(M_PI);
        EXPECT_NEAR(maxwellian::fluxFactor(s)/exact, 1, 1e-8) << s;
    }
}


TEST(maxwellian, speedsThroughASurfaceHaveTheirMoments)
{
    for (const double s : {-6., -1.5, -0.4, 0., 0.3, 1., 6.})
    {
        const auto density = [s](double x)
        {
            return x*std::exp(-(x - s)*(x - s) + (s < 0 ? s*s : 0));
        };
        const double end = std::fabs(s) + 8;
        const double norm = integral(density, 0, end);
        for (const int power : {1, 2, 4})
        {
            const double exact = integral
            (
                [&](double x) { return std::pow(x, power)*density(x); },
                0,
                end
            )/norm;
            const sampleMean m = mean
            (
                [s](counterRandom& r) { return maxwellian::fluxSpeed(s, r); },
                power
            );
            EXPECT_NEAR(m.value, exact, 4.5*m.error) << s << ' ' << power;
        }
    }
}


TEST(maxwellian, velocitiesThroughATurnedSurface)
{
    const vector3 n{0.6, 0, -0.8};
    const vector3 along{400, 50, 300};
    const double c = 420;
    const auto component = [&](const vector3& d)
    {
        return [&, d](counterRandom& r)
        {
            return dot(maxwellian::crossingVelocity(n, along, c, 0, r), d);
        };
    };
    const sampleMean through = mean(component(n), 1);
    EXPECT_NEAR(through.value, c*std::sqrt(M_PI)/2, 4.5*through.error);
    for (const vector3& d : {vector3{0.8, 0, 0.6}, vector3{0, 1, 0}})
    {
        const double mean1 = dot(along, d);
        const sampleMean first = mean(component(d), 1);
        const sampleMean second = mean(component(d), 2);
        EXPECT_NEAR(first.value, mean1, 4.5*first.error);
        EXPECT_NEAR(second.value, c*c/2 + mean1*mean1, 4.5*second.error);
    }
    EXPECT_NEAR
    (
        maxwellian::meanSpeed(300, 5e-26),
        2/std::sqrt(M_PI)*maxwellian::mostProbableSpeed(300, 5e-26),
        1e-10
    );
}


TEST(maxwellian, gammaVariatesHaveTheirMoments)
{
    for (const double a : {0.5, 1., 1.5, 2., 2.5, 7.})
    {
        const auto draw = [a](counterRandom& r)
        {
            return maxwellian::gammaVariate(a, r);
        };
        double exact = 1;
        for (int power = 1; power <= 3; ++power)
        {
            exact *= a + power - 1;
            const sampleMean m = mean(draw, power);
            EXPECT_NEAR(m.value, exact, 4.5*m.error) << a << ' ' << power;
        }
    }
}


TEST(maxwellian, betaVariatesHaveTheirMoments)
{
    for (const double a : {0.5, 1., 1.5, 3.})
    {
        for (const double b : {1.69, 1.76, 2.})
        {
            const auto draw = [a, b](counterRandom& r)
            {
                return maxwellian::betaVariate(a, b, r);
            };
            double exact = 1;
            for (int power = 1; power <= 3; ++power)
            {
                exact *= (a + power - 1)/(a + b + power - 1);
                const sampleMean m = mean(draw, power);
                EXPECT_NEAR(m.value, exact, 4.5*m.error)
                    << a << ' ' << b << ' ' << power;
            }
        }
    }
}


TEST(maxwellian, internalEnergyIsHalfPerDegreeOfFreedom)
{
    counterRandom rnd(1);
    EXPECT_EQ(maxwellian::internalEnergy(0, rnd), 0);
    for (const int zeta : {1, 2, 3, 5})
    {
        const sampleMean m = mean
        (
            [zeta](counterRandom& r)
            {
                return maxwellian::internalEnergy(zeta, r);
            },
            1
        );
        EXPECT_NEAR(m.value, 0.5*zeta, 4.5*m.error);
    }
}
