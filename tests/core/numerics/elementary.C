/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The elementary functions against the mathematics library, orientations
    against the quaternion formula and the moments of the rotation group.
\*---------------------------------------------------------------------------*/

#include "elementary.H"
#include "orientation.H"
#include "philoxLanes.H"
#include "counterRandom.H"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <cmath>
#include <random>

using namespace impact;


TEST(elementary, agreesWithTheMathematicsLibrary)
{
    counterRandom rnd(1);
    for (int i = 0; i < 200000; ++i)
    {
        double s, c;
        const double u = 4*rnd.uniform() - 2;
        sinCosTurns(u, s, c);
        EXPECT_NEAR(s, std::sin(2*M_PIl*u), 1e-15);
        EXPECT_NEAR(c, std::cos(2*M_PIl*u), 1e-15);
        const double x = 2e4*(rnd.uniform() - 0.5);
        sinCos(x, s, c);
        EXPECT_NEAR(s, std::sin(x), 3e-16*(1 + std::fabs(x)/M_PI));
        EXPECT_NEAR(c, std::cos(x), 3e-16*(1 + std::fabs(x)/M_PI));
        const double a = rnd.normal(), b = rnd.normal();
        EXPECT_NEAR(arcTan2(a, b), std::atan2(a, b), 6e-16);
    }
    for (double y : {0., 1., -1.})
    {
        for (double x : {0., 1., -1.})
        {
            EXPECT_NEAR(arcTan2(y, x), std::atan2(y, x), 5e-16);
        }
    }
}


TEST(elementary, takesCubeRoots)
{
    counterRandom rnd(3);
    for (int i = 0; i < 200000; ++i)
    {
        const double x =
            i % 2 ? std::exp(1200*(rnd.uniform() - 0.5)) : 8*rnd.uniform();

        // In double precision the library's own is off by 6e-16
        const long double exact = std::cbrt((long double)(x));
        EXPECT_NEAR(double((cubeRoot(x) - exact)/exact), 0, 2e-16) << x;
    }
    EXPECT_EQ(cubeRoot(1), 1);
    EXPECT_EQ(cubeRoot(8), 2);
    EXPECT_LT(cubeRoot(0), 1.1e-100);
}


TEST(elementary, takesLogarithms)
{
    counterRandom rnd(2);
    for (int i = 0; i < 200000; ++i)
    {
        const double x =
            i % 2 ? std::exp(600*(rnd.uniform() - 0.5)) : 0.5 + rnd.uniform();
        const double exact = std::log(x);
        EXPECT_NEAR(logarithm(x), exact, 3e-16*(1 + std::fabs(exact)));
    }
    EXPECT_EQ(logarithm(1), 0);
}


TEST(elementary, takesExponentials)
{
    std::mt19937_64 engine(3);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int i = 0; i < 200000; ++i)
    {
        const double x = (i % 2 ? 699 : 1)*uniform(engine);
        const double exact = std::exp(x);
        EXPECT_NEAR(exponential(x), exact, 4e-16*exact) << x;
    }
    EXPECT_EQ(exponential(0), 1);

    // Bounded below, so that nothing is denormal
    EXPECT_GT(exponential(-1e300), 0);
    EXPECT_EQ(exponential(-1e300), exponential(-700));
}


TEST(elementary, invertsTheTruncatedNormalLaw)
{
    // Phi(x) = (1 + erf(x/sqrt 2))/2 between -3 and 3
    const double half = 0.5*std::erf(3/std::sqrt(2.));
    for (int i = 1; i < 100000; ++i)
    {
        const double u = i*1e-5;
        const double x = truncatedNormal(u);
        EXPECT_NEAR
        (
            0.5*std::erf(x/std::sqrt(2.)), half*(2*u - 1), 1e-11
        );
    }
    EXPECT_NEAR(truncatedNormal(1 - 1e-16), 3, 1e-8);
    EXPECT_NEAR(truncatedNormal(1e-16), -3, 1e-8);
}


TEST(philoxLanes, drawsTheWordsOfTheCounterRandom)
{
    for (std::uint64_t i = 0; i < 1000; ++i)
    {
        const std::uint64_t seed = 77 + (i << 33);
        const std::uint64_t stream = 3*i + (i << 40);
        counterRandom rnd(seed, stream, 9);
        std::uint64_t w[4];
        for (std::uint32_t block = 0; block < 3; ++block)
        {
            philoxLane(seed, block, 9, stream, w[0], w[1], w[2], w[3]);
            for (std::uint64_t word : w)
            {
                ASSERT_EQ(word, rnd.bits());
            }
        }
    }
    const threeUnits least(0, 0, 0, 0);
    EXPECT_EQ(least.u0, 0x1p-43);
    EXPECT_EQ(least.u2, 0x1p-43);
    const std::uint64_t w = 0xffffffff;
    const threeUnits most(w, w, w, w);
    EXPECT_EQ(most.u0, 1 - 0x1p-43);
    EXPECT_EQ(most.u1, 1 - 0x1p-43);
    EXPECT_EQ(most.u2, 1 - 0x1p-43);
    EXPECT_LT(unitOf((1ull << 52) - 1), 1);
    EXPECT_GT(unitOf(0), 0);
}


TEST(orientation, isTheQuaternionOfTheThreeAngles)
{
    counterRandom rnd(4);
    for (int i = 0; i < 1000; ++i)
    {
        const double u[3] = {rnd.uniform(), rnd.uniform(), rnd.uniform()};
        vector3 ex, ey;
        orient<orientationLaw::uniformEuler>(u[0], u[1], u[2], ex, ey);
        double c[3], s[3];
        for (int k = 0; k < 3; ++k)
        {
            c[k] = std::cos(M_PI*u[k]);
            s[k] = std::sin(M_PI*u[k]);
        }
        // Order phi, psi, theta
        const double l0 = c[0]*c[1]*c[2] - s[0]*s[1]*s[2];
        const double l1 = s[0]*c[1]*c[2] + c[0]*s[1]*s[2];
        const double l2 = c[0]*s[1]*c[2] + s[0]*c[1]*s[2];
        const double l3 = c[0]*c[1]*s[2] - s[0]*s[1]*c[2];

        // Columns of A: laboratory axes in body components
        EXPECT_NEAR(ex.x, l0*l0 + l1*l1 - l2*l2 - l3*l3, 1e-14);
        EXPECT_NEAR(ex.y, 2*(l1*l2 - l0*l3), 1e-14);
        EXPECT_NEAR(ex.z, 2*(l0*l2 + l3*l1), 1e-14);
        EXPECT_NEAR(ey.x, 2*(l0*l3 + l1*l2), 1e-14);
        EXPECT_NEAR(ey.y, l0*l0 - l1*l1 + l2*l2 - l3*l3, 1e-14);
        EXPECT_NEAR(ey.z, 2*(l2*l3 - l0*l1), 1e-14);
    }
}


TEST(orientation, isotropicFillsTheGroupOfRotations)
{
    counterRandom rnd(5);
    const int n = 400000;
    double second[6] = {}, fourth[2] = {}, mixed = 0;
    for (int i = 0; i < n; ++i)
    {
        vector3 ex, ey;
        const double u0 = rnd.uniform(), u1 = rnd.uniform();
        orient<orientationLaw::isotropic>(u0, u1, rnd.uniform(), ex, ey);
        ASSERT_NEAR(dot(ex, ex), 1, 1e-14);
        ASSERT_NEAR(dot(ey, ey), 1, 1e-14);
        ASSERT_NEAR(dot(ex, ey), 0, 1e-14);
        for (int k = 0; k < 3; ++k)
        {
            second[k] += ex[k]*ex[k]/n;
            second[3 + k] += ey[k]*ey[k]/n;
        }
        fourth[0] += std::pow(ex.x, 4)/n;
        fourth[1] += std::pow(cross(ex, ey).z, 4)/n;
        mixed += ex.x*ex.x*ey.y*ey.y/n;
    }
    // Moments of the Haar measure: 1/3, 1/5, 2/15
    for (double m : second)
    {
        EXPECT_NEAR(m, 1./3, 5*0.3/std::sqrt(n));
    }
    EXPECT_NEAR(fourth[0], 0.2, 5*0.27/std::sqrt(n));
    EXPECT_NEAR(fourth[1], 0.2, 5*0.27/std::sqrt(n));
    EXPECT_NEAR(mixed, 2./15, 5*0.2/std::sqrt(n));
}
