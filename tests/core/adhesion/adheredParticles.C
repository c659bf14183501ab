/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Tests of adheredParticles.
\*---------------------------------------------------------------------------*/

#include "adheredParticles.H"

#include <gtest/gtest.h>

using namespace impact;
typedef adheredParticles layer;

namespace
{

double massOf(double d, double rho)
{
    return M_PI/6*rho*d*d*d;
}

} // End anonymous namespace


TEST(adheredParticles, classesBySize)
{
    const layer two({5e-6, 2e-5}, 3);
    EXPECT_EQ(two.nClasses(), 3);
    EXPECT_EQ(two.nFaces(), 3u);
    EXPECT_EQ(two.classOf(1e-9), 0);
    EXPECT_EQ(two.classOf(5e-6), 1);
    EXPECT_EQ(two.classOf(1.99e-5), 1);
    EXPECT_EQ(two.classOf(1), 2);
    EXPECT_EQ(layer({}, 1).classOf(1e-5), 0);
}


TEST(adheredParticles, coverageIsTheirProjectedArea)
{
    layer l({5e-6}, 2);
    l.add(1, 0, 1e9, 2e-6, massOf(2e-6, 2000));
    l.add(1, 1, 1e8, 1e-5, massOf(1e-5, 3000));
    const double small = 1e9*M_PI/4*4e-12, large = 1e8*M_PI/4*1e-10;
    EXPECT_EQ(l.coverage(0), 0);
    EXPECT_NEAR(l.coverage(1), small + large, 1e-16);

    // The share of the draws, of the wall and of both classes
    const int n = 100000;
    int met[3] = {0, 0, 0};
    for (int i = 0; i < n; ++i)
    {
        ++met[l.partner(1, (i + 0.5)/n) + 1];
        ASSERT_EQ(l.partner(0, (i + 0.5)/n), -1);
    }
    EXPECT_NEAR(met[1]/double(n), small, 2./n);
    EXPECT_NEAR(met[2]/double(n), large, 2./n);

    // Covered twice: no wall is left, the shares are those of the area
    l.add(1, 0, 4e11, 2e-6, massOf(2e-6, 2000));
    const double c = l.coverage(1);
    ASSERT_GT(c, 1);
    int wall = 0, first = 0;
    for (int i = 0; i < n; ++i)
    {
        const int k = l.partner(1, (i + 0.5)/n);
        wall += k < 0;
        first += k == 0;
    }
    EXPECT_EQ(wall, 0);
    EXPECT_NEAR(first/double(n), 1 - large/c, 2./n);
}


TEST(adheredParticles, theMeanKeepsNumberMassAndVolume)
{
    layer l({}, 1);
    l.add(0, 0, 3e9, 2e-6, massOf(2e-6, 2000));
    l.add(0, 0, 1e9, 4e-6, massOf(4e-6, 1000));
    const layer::sums all = l.of(0, 0);
    const layer::particle mean = l.meanOf(0, 0);
    EXPECT_NEAR(massOf(mean.diameter, mean.density)*4e9/all[layer::mass],
        1, 1e-14);

    // Taken in parts, down to nothing
    double mass = 0, number = 0, volume = 0;
    for (double part : {1e9, 2.5e9, 1e9})
    {
        const layer::sums taken = l.take(0, 0, part);
        mass += taken[layer::mass];
        number += taken[layer::number];
        volume += taken[layer::volume];
    }
    EXPECT_NEAR(number/4e9, 1, 1e-15);
    EXPECT_NEAR(mass/all[layer::mass], 1, 1e-15);
    EXPECT_NEAR(volume/all[layer::volume], 1, 1e-15);
    EXPECT_EQ(l.coverage(0), 0);
    EXPECT_EQ(l.partner(0, 1e-9), -1);
    EXPECT_EQ(l.take(0, 0, 1)[layer::number], 0);

    // Alike, they stay what they are however often some are taken
    layer same({}, 1);
    same.add(0, 0, 1e9, 3e-6, massOf(3e-6, 2500));
    for (int i = 0; i < 1000; ++i)
    {
        same.take(0, 0, 9e5);
    }
    EXPECT_NEAR(same.meanOf(0, 0).diameter/3e-6, 1, 1e-12);
    EXPECT_NEAR(same.of(0, 0)[layer::number]/1e8, 1, 1e-10);
}


TEST(adheredParticles, refusesBoundsOutOfOrder)
{
    EXPECT_THROW(layer({0}, 1), std::invalid_argument);
    EXPECT_THROW(layer({2e-6, 2e-6}, 1), std::invalid_argument);
    EXPECT_THROW(layer({-1e-6}, 1), std::invalid_argument);
    EXPECT_THROW(layer({INFINITY}, 1), std::invalid_argument);
    EXPECT_THROW
    (
        layer(std::vector<double>(layer::maxBounds + 1, 1), 1),
        std::invalid_argument
    );
}
