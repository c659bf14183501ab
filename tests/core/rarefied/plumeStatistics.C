/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Statistics of the far field: against sums over the particles themselves,
    quantiles against sorted numbers, packing, empty cells.
\*---------------------------------------------------------------------------*/

#include "plumeStatistics.H"
#include "counterRandom.H"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

using namespace impact;

namespace
{

plumeStatistics::setup twoGroups()
{
    plumeStatistics::setup s;
    s.grids.push_back(plumeGrid::axis({0, 4, 4}, 2));
    s.emitted = {1e6, 3e5};
    s.stations = {2};
    s.stationHalfWidth = 1;
    s.nParticles = 1e4;
    s.hottest = 3000;
    return s;
}

} // End anonymous namespace


TEST(logHistogram, findsQuantilesToAThousandth)
{
    counterRandom rnd(8);
    logHistogram h;
    std::vector<double> x;
    for (int i = 0; i < 20000; ++i)
    {
        const double sign = rnd.uniform() < 0.3 ? -1 : 1;
        x.push_back(sign*std::exp(3*rnd.normal()));
        h.add(x.back());
    }
    for (int i = 0; i < 50; ++i)
    {
        x.push_back(0);
        h.add(0);
    }
    EXPECT_EQ(h.total(), std::int64_t(x.size()));
    std::sort(x.begin(), x.end());
    for (double p : {0.001, 0.1, 0.2, 0.5, 0.9, 0.999})
    {
        // Between two neighbours, to the width of a bin
        const std::size_t k = std::size_t(p*double(x.size()));
        const double q = h.quantile(p);
        EXPECT_GT(q, x[k - 1] - 1e-3*std::fabs(x[k - 1]) - 1e-12);
        EXPECT_LT(q, x[k] + 1e-3*std::fabs(x[k]) + 1e-12);
    }

    // Numbers that have no bin of their own
    logHistogram ends;
    ends.add(1e-30);
    ends.add(1e30);
    ends.add(-1e30);
    EXPECT_EQ(ends.total(), 3);
    EXPECT_EQ(logHistogram().quantile(0.5), 0);

    std::vector<std::int64_t> packed;
    h.pack(packed);
    logHistogram back;
    back.add(1e5);
    const std::int64_t* data = packed.data();
    back.unpack(data);
    EXPECT_EQ(data, packed.data() + packed.size());
    EXPECT_EQ(back.total(), h.total());
    EXPECT_EQ(back.quantile(0.3), h.quantile(0.3));
}


TEST(plumeStatistics, agreesWithSumsOverTheParticles)
{
    plumeStatistics s(twoGroups());
    counterRandom rnd(2);
    std::vector<double> all[2][4], temperatures[2];
    const int n = 400;
    for (int group = 0; group < 2; ++group)
    {
        std::vector<double> x(n), y(n), z(n), T(n);
        for (int i = 0; i < n; ++i)
        {
            x[i] = 3.5*rnd.uniform() - 1;
            y[i] = 2*rnd.uniform() - 0.5;
            z[i] = 2*rnd.uniform() - 0.5;
            T[i] = 300 + 1000*group + 10*rnd.normal();
            temperatures[group].push_back(T[i]);
            if (x[i] >= 0 && std::hypot(y[i], z[i]) < 2)
            {
                all[group][int(x[i])].push_back(T[i]);
            }
        }
        s.add(group, n, x.data(), y.data(), z.data(), T.data());
    }
    EXPECT_EQ(s.sampled(), 2*n);
    const double V = 4*M_PI;
    for (int c = 0; c < 3; ++c)
    {
        double number = 0, sum = 0, variance = 0;
        for (int group = 0; group < 2; ++group)
        {
            const std::vector<double>& t = all[group][c];
            const double m = double(t.size());
            ASSERT_GT(m, 20);
            const double w = twoGroups().emitted[group]/n;
            const plumeStatistics::estimate d =
                s.numberDensity(0, group, c);
            EXPECT_EQ(d.n, std::int64_t(t.size()));
            EXPECT_NEAR(d.value, m*w/V, 1e-9*d.value);
            EXPECT_NEAR(d.error, std::sqrt(m*(1 - m/n))*w/V, 1e-9*d.error);
            double mean = 0, square = 0;
            for (double T : t)
            {
                mean += T/m;
            }
            for (double T : t)
            {
                square += (T - mean)*(T - mean);
            }
            const plumeStatistics::estimate e = s.temperature(0, group, c);
            EXPECT_NEAR(e.value, mean, 1e-6);
            EXPECT_NEAR(e.error, std::sqrt(square/(m*(m - 1))), 1e-6);
            number += w*m;
            sum += w*m*mean;
            variance += w*w*m*(1 - m/n);
        }
        const plumeStatistics::estimate d = s.numberDensity(0, -1, c);
        EXPECT_NEAR(d.value, number/V, 1e-9*d.value);
        EXPECT_NEAR(d.error, std::sqrt(variance)/V, 1e-9*d.error);
        EXPECT_NEAR(s.temperature(0, -1, c).value, sum/number, 1e-6);
    }

    // Nothing beyond x = 2.5: empty, and said so
    EXPECT_EQ(s.count(0, 0, 3), 0);
    EXPECT_EQ(s.numberDensity(0, 0, 3).value, 0);
    EXPECT_EQ(s.temperature(0, 0, 3).n, 0);
    EXPECT_EQ(s.temperature(0, -1, 3).n, 0);
    double mean = 0;
    for (double T : temperatures[1])
    {
        mean += T/n;
    }
    EXPECT_NEAR(s.temperature(1).value, mean, 1e-6);
}


TEST(plumeStatistics, isTheSameInAnyOrderAndAfterTransfer)
{
    const plumeStatistics empty(twoGroups());
    plumeStatistics a(empty), b(empty), whole(empty);
    counterRandom rnd(3);
    for (int i = 0; i < 1000; ++i)
    {
        const double x = 5*rnd.uniform(), y = rnd.normal(), z = 0;
        const double T = 3000*rnd.uniform();
        const int group = i % 2;
        (i % 3 ? a : b).add(group, 1, &x, &y, &z, &T);
        whole.add(group, 1, &x, &y, &z, &T);
    }
    plumeStatistics sum(empty);
    sum.unpack(b.pack());
    sum.add(a);
    EXPECT_EQ(sum.pack(), whole.pack());
    EXPECT_NE(sum.pack(), a.pack());
    EXPECT_GT(sum.radius(0, 0, 0.99).n, 10);
    EXPECT_GT(sum.radius(0, 0, 0.99).error, 0);
}


TEST(plumeStatistics, givesNoErrorWhereThereIsNothing)
{
    const plumeStatistics s(twoGroups());
    EXPECT_EQ(s.weight(0), 0);
    EXPECT_EQ(s.temperature(0).n, 0);
    EXPECT_EQ(s.quantile(0, 0.5), 0);
    EXPECT_EQ(s.radius(0, 0, 0.99).n, 0);
    EXPECT_EQ
    (
        s.largestError(), std::numeric_limits<double>::infinity()
    );
}


TEST(plumeStatistics, holdsAsManyParticlesAsAreAskedFor)
{
    plumeStatistics::setup s(twoGroups());
    s.nParticles = 1e13;
    s.hottest = 1e4;
    plumeStatistics many(s);
    const double x = 0.5, y = 0, T = 1e4;
    many.add(0, 1, &x, &y, &y, &T);
    const std::int64_t one = many.pack()[1];
    EXPECT_LT(double(one)*1e13, 9.2e18);
    EXPECT_NEAR(many.temperature(0).value, T, 1);
    s.hottest = 1e8;
    EXPECT_THROW(plumeStatistics{s}, std::invalid_argument);
}
