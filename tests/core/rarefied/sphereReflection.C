/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Directions of molecules reflected by a sphere: moments and distribution of
    the angle, symmetry about the direction of incidence.
\*---------------------------------------------------------------------------*/

#include "sphereReflection.H"
#include "largest.H"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <vector>

using namespace impact;
using sphereReflection::law;

namespace
{
    //- Density of the angle of diffuse reflection
    double density(law form, double x)
    {
        return
            form == law::polynomial
          ? 0.02042*std::pow(x, 6) - 0.2515*std::pow(x, 5)
          + 1.104*std::pow(x, 4) - 1.903*std::pow(x, 3) + 0.4938*x*x + 1.248*x
          : 4/(3*M_PI)*std::sin(x)*(std::sin(x) + (M_PI - x)*std::cos(x));
    }

    //- Integral of the density times a power of the cosine
    double moment(law form, int power)
    {
        const int n = 100000;
        double sum = 0;
        for (int i = 0; i < n; ++i)
        {
            const double x = (i + 0.5)*M_PI/n;
            sum += density(form, x)
               *std::pow(std::cos(x), power);
        }
        return sum*M_PI/n;
    }
}


TEST(sphereReflection, momentsOfTheExactLaw)
{
    EXPECT_NEAR(moment(law::exact, 0), 1, 1e-9);
    EXPECT_NEAR(moment(law::exact, 1), 4./9, 1e-9);
    double greatest = 0;
    for (double x = 0; x <= M_PI; x += 1e-3)
    {
        greatest = largest
        (
            greatest,
            std::fabs
            (
                density(law::exact, x)
              - density(law::polynomial, x)
            )
        );
        EXPECT_LT(density(law::polynomial, x), 0.75);
    }
    EXPECT_LT(greatest, 0.0055);
    EXPECT_LT(density(law::polynomial, 3.1), 0);
}


TEST(sphereReflection, samplesFollowTheDensity)
{
    const vector3 incident{-2./3, 1./3, 2./3};
    const vector3 across{0, 2/std::sqrt(5.), -1/std::sqrt(5.)};
    for (const law form : {law::exact, law::polynomial})
    {
        counterRandom rnd(11, form == law::exact);
        const int n = 400000, nBins = 20;
        std::vector<double> count(nBins, 0);
        double c1 = 0, c2 = 0, side = 0;
        for (int i = 0; i < n; ++i)
        {
            const vector3 d = sphereReflection::diffuse(form, incident, rnd);
            ASSERT_NEAR(dot(d, d), 1, 1e-12);
            const double c = -dot(d, incident);
            c1 += c/n;
            c2 += c*c/n;
            side += dot(d, across)/n;
            const double x = std::acos(std::min(1., std::max(-1., c)));
            ++count[std::min(nBins - 1, int(x/M_PI*nBins))];
        }
        if (form == law::exact)
        {
            EXPECT_NEAR(c1, 4./9, 5*0.55/std::sqrt(n));
            EXPECT_NEAR(c2, moment(form, 2), 5*0.4/std::sqrt(n));
        }
        EXPECT_NEAR(side, 0, 5*0.6/std::sqrt(n));

        // Chi squared of bins that expect enough: 20 bins, < 1e-6 by chance
        double chi2 = 0, norm = 0;
        std::vector<double> share(nBins, 0);
        for (int b = 0; b < nBins; ++b)
        {
            for (int j = 0; j < 200; ++j)
            {
                const double x = (b + (j + 0.5)/200)*M_PI/nBins;
                share[b] +=
                    std::max(0., density(form, x));
            }
            norm += share[b];
        }
        for (int b = 0; b < nBins; ++b)
        {
            const double expected = n*share[b]/norm;
            if (expected > 20)
            {
                chi2 += (count[b] - expected)*(count[b] - expected)/expected;
            }
        }
        EXPECT_LT(chi2, 65);
    }
}


TEST(sphereReflection, specularIsIsotropic)
{
    counterRandom rnd(5);
    const int n = 200000;
    vector3 mean{0, 0, 0}, square{0, 0, 0};
    for (int i = 0; i < n; ++i)
    {
        const vector3 d = sphereReflection::specular(rnd);
        mean = mean + (1./n)*d;
        square = square + (1./n)*vector3{d.x*d.x, d.y*d.y, d.z*d.z};
    }
    for (int d = 0; d < 3; ++d)
    {
        EXPECT_NEAR(mean[d], 0, 5*0.58/std::sqrt(n));
        EXPECT_NEAR(square[d], 1./3, 5*0.3/std::sqrt(n));
    }
}
