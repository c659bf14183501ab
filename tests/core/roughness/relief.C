/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The relief: smoothness, statistics of the knots, independence of the
    order of growth, periodic profiles, and what is refused.
\*---------------------------------------------------------------------------*/

#include "relief.H"

#include <gtest/gtest.h>
#include <cmath>
#include <fstream>
#include <stdexcept>

using namespace impact;

namespace
{

void expectSmooth
(
    reliefPiece& piece,
    int from,
    int to,
    double height,
    double bendStep = 1e-10     // that is allowed
)
{
    for (int i = from; i < to; ++i)
    {
        const relief::interval a = piece.at(i);
        const relief::interval b = piece.at(i + 1);
        const double h = a.x1 - a.x0;
        ASSERT_GT(h, 0);
        EXPECT_NEAR(a.x1, b.x0, 1e-12*h);
        const double y = a.c0 + h*(a.c1 + h*(a.c2 + h*a.c3));
        const double slope = a.c1 + h*(2*a.c2 + 3*h*a.c3);
        const double bend = 2*a.c2 + 6*h*a.c3;
        EXPECT_NEAR(y, b.c0, 1e-12*height);
        EXPECT_NEAR(slope, b.c1, 1e-11*height/h);
        EXPECT_NEAR(bend, 2*b.c2, bendStep*height/(h*h));

        // The bounds bound, and are reached
        double top = -1e300, steep = 0, crest = 0;
        for (int k = 0; k <= 1000; ++k)
        {
            const double u = h*k/1000;
            top = std::max(top, a.c0 + u*(a.c1 + u*(a.c2 + u*a.c3)));
            steep = std::max
            (
                steep, std::fabs(a.c1 + u*(2*a.c2 + 3*u*a.c3))
            );
            crest = std::max(crest, -(2*a.c2 + 6*u*a.c3));
        }
        EXPECT_GE(a.top, top - 1e-12*height);
        EXPECT_NEAR(a.top, top, 1e-5*height);
        EXPECT_GE(a.steep, steep*(1 - 1e-12));
        EXPECT_NEAR(a.steep, steep, 1e-5*height/h);
        EXPECT_NEAR(a.crest, crest, 1e-9*height/(h*h));
    }
}

} // End anonymous namespace


TEST(relief, hasContinuousCurvatureHoweverItGrew)
{
    const relief r = relief::rough(80e-6, 10e-6, 20e-6);
    for (int first : {1, 20, 200, 500})
    {
        reliefPiece piece(r, 7);
        piece.start(3, first);
        expectSmooth(piece, -70, 600, 60e-6);
    }
}


TEST(relief, hasContinuousSlopeWithFewKnotsBeyond)
{
    const relief r = relief::rough(80e-6, 10e-6, 20e-6);
    for (int identity : {1, 2, 3})
    {
        reliefPiece piece(r, 7, 8);
        piece.start(identity, 1);
        expectSmooth(piece, -300, 300, 60e-6, 1e-3);
    }
}


TEST(relief, isAFunctionOfSeedIdentityAndPlace)
{
    const relief r = relief::rough(80e-6, 10e-6, 20e-6);
    reliefPiece a(r, 7), b(r, 7);
    a.start(11, 300);
    b.start(11, 1);
    b.at(-40);
    b.at(250);
    for (double x : {0., 1e-3, 1.234e-2, 2e-2})
    {
        EXPECT_NEAR(a.height(x), b.height(x), 1e-16);
    }
    b.start(12, 300);
    EXPECT_GT(std::fabs(a.height(1e-3) - b.height(1e-3)), 1e-9);
    reliefPiece c(r, 8);
    c.start(11, 300);
    EXPECT_GT(std::fabs(a.height(1e-3) - c.height(1e-3)), 1e-9);
}


TEST(relief, staysBelowItsTopHoweverTheSpacingScatters)
{
    const double mean = 80, sy = 20;
    for (double share : {0., 0.125, 0.2, 0.25, 0.3, 0.32, 0.333})
    {
        const relief r = relief::rough(mean, share*mean, sy);
        reliefPiece piece(r, 7);
        double highest = 0;
        for (int k = 0; k < 5000; ++k)
        {
            piece.start(k, 100);
            for (int i = 0; i < 100; ++i)
            {
                highest = std::max(highest, piece.at(i).top);
            }
        }
        EXPECT_LE(highest, r.top()) << share;
        EXPECT_GE(highest, 3*sy) << share;
    }
}


TEST(relief, hasTheStatisticsOfItsLaws)
{
    const double mean = 80, sx = 10, sy = 20;
    const relief r = relief::rough(mean, sx, sy);
    reliefPiece piece(r, 1);
    const int n = 200000;
    piece.start(0, n);
    double s1 = 0, s2 = 0, y1 = 0, y2 = 0, neighbours = 0;
    for (int i = 0; i < n; ++i)
    {
        const relief::interval& in = piece.at(i);
        const double d = in.x1 - in.x0 - mean;
        ASSERT_LE(std::fabs(d), 3*sx*(1 + 1e-8));
        ASSERT_LE(std::fabs(in.c0), 3*sy*(1 + 1e-8));
        ASSERT_LE(in.top, r.top());
        s1 += d/n;
        s2 += d*d/n;
        y1 += in.c0/n;
        y2 += in.c0*in.c0/n;
        neighbours += in.c0*piece.at(i + 1).c0/n;
    }
    // Variance of a normal law cut at 3 deviations
    const double cut =
        1 - 6*std::exp(-4.5)/std::sqrt(2*M_PI)/std::erf(3/std::sqrt(2.));
    EXPECT_NEAR(s1, 0, 5*sx/std::sqrt(n));
    EXPECT_NEAR(s2/(sx*sx), cut, 5*std::sqrt(2./n));
    EXPECT_NEAR(y1, 0, 5*sy/std::sqrt(n));
    EXPECT_NEAR(y2/(sy*sy), cut, 5*std::sqrt(2./n));
    EXPECT_NEAR(neighbours/(sy*sy), 0, 5/std::sqrt(n));
}


TEST(relief, repeatsAProfileWithoutASeam)
{
    std::vector<double> x, y;
    for (int i = 0; i < 37; ++i)
    {
        x.push_back(5 + i + 0.3*std::sin(2.*i));
        y.push_back(4 + 0.2*i + std::sin(0.7*i)*std::cos(1.9*i));
    }
    const relief r = relief::profile(x, y);
    EXPECT_NEAR(r.period(), (x[36] - x[0])*37/36, 1e-12);
    reliefPiece piece(r, 1);
    expectSmooth(piece, -80, 80, 1);
    for (double at : {0.1, 12.3, 36.9})
    {
        EXPECT_NEAR
        (
            piece.height(at), piece.height(at - 3*r.period()), 1e-12
        );
    }
    // Through its points, less their mean line
    double sum = 0, moment = 0;
    for (int i = 0; i < 37; ++i)
    {
        const double h = piece.height(x[i] - x[0]);
        sum += h;
        moment += h*(x[i] - x[0]);
    }
    EXPECT_NEAR(sum, 0, 1e-10);
    EXPECT_NEAR(moment, 0, 1e-9);
    const double slope =
        (piece.height(x[9] - x[0]) - y[9] - piece.height(0) + y[0])
       /(x[9] - x[0]);
    for (int i = 0; i < 37; ++i)
    {
        EXPECT_NEAR
        (
            piece.height(x[i] - x[0]) - y[i],
            piece.height(0) - y[0] + slope*(x[i] - x[0]), 1e-10
        );
    }
}


TEST(relief, isFoundAtOnceFarAwayWhereItRepeats)
{
    // From a trough to where the corner of the square meets the next crest
    const relief r = relief::sinusoidal(2, 10);
    for (const double Vx : {1., -1.})
    {
        reliefPiece piece(r, 1);
        std::int64_t hint = 0;
        bool lost = false;
        const double x = Vx*1e9 - 2.5;
        EXPECT_NEAR(piece.height(x), -2, 1e-6);
        const double t =
            piece.firstReach(x, 2.49, Vx, -1e-4, 0.5, 0, hint, lost);
        EXPECT_FALSE(lost);

        // Two intervals before its top
        EXPECT_NEAR(t, 5 - 0.5 - 2*10./64, 1e-6);
    }
}


TEST(relief, scalesItsLengths)
{
    const relief r = relief::profile
    (
        std::vector<double>{0, 1, 2.5, 3, 4.2}, {0, 1, -1, 2, 0.5}
    );
    relief s = relief::flat();
    s.setScaled(r, 2);
    s.setScaled(s, 1.5);
    EXPECT_NEAR(s.top(), 3*r.top(), 1e-13);
    reliefPiece a(r, 1), b(s, 1);
    expectSmooth(b, -20, 20, 6);
    for (double x = -30; x < 30; x += 0.77)
    {
        EXPECT_NEAR(b.height(3*x), 3*a.height(x), 1e-12);
    }
}


TEST(relief, isASineToItsStatedError)
{
    const relief r = relief::sinusoidal(2, 10);
    reliefPiece piece(r, 1);
    for (int i = -100; i < 200; ++i)
    {
        const double x = 0.173*i;
        EXPECT_NEAR(piece.height(x), 2*std::sin(2*M_PI*x/10), 2e-6);
    }
    const relief f = relief::flat(3);
    reliefPiece flat(f, 1);
    EXPECT_EQ(flat.height(-17), 0);
    EXPECT_EQ(flat.at(5).crest, 0);
}


TEST(relief, refusesBadInput)
{
    EXPECT_THROW(relief::rough(0, 0, 1), std::invalid_argument);
    EXPECT_THROW(relief::rough(3, 1, 1), std::invalid_argument);
    EXPECT_THROW(relief::rough(3, -0.1, 1), std::invalid_argument);
    EXPECT_THROW(relief::rough(3, 0.5, -1), std::invalid_argument);
    EXPECT_THROW(relief::sinusoidal(1, 0), std::invalid_argument);
    EXPECT_THROW
    (
        relief::profile(std::vector<double>{0, 1, 2}, {0, 1, 0}),
        std::invalid_argument
    );
    EXPECT_THROW
    (
        relief::profile(std::vector<double>{0, 1, 1, 2}, {0, 1, 0, 1}),
        std::invalid_argument
    );
    EXPECT_THROW(relief::profile("/nonexistent"), std::invalid_argument);

    const std::string name = ::testing::TempDir() + "profile.dat";
    std::ofstream(name) << "# x y\n0 0\n1, 1\n2 0.5 # a comment\n\n3 1\n";
    EXPECT_NEAR(relief::profile(name, 2).period(), 8, 1e-12);
    std::ofstream(name) << "0 0\n1 1\n2 x\n3 1\n";
    EXPECT_THROW(relief::profile(name), std::invalid_argument);
}
