/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Bins of an angle: where positions fall, the areas of the surface between
    the half-planes, refusals.
\*---------------------------------------------------------------------------*/

#include "angularBins.H"

#include <gtest/gtest.h>
#include <cmath>
#include <numeric>
#include <string>

using impact::angularBins;
using impact::vector3;

namespace
{

const vector3 origin{0.1, -0.2, 0.3};
const vector3 axis{0, 0, 2};
const vector3 upstream{-1, 0, 5};

//- Point on a cylinder of radius R about the axis, phi from upstream
vector3 at(double R, double degrees, double z)
{
    const double a = degrees*M_PI/180;
    return
    {
        origin.x - R*std::cos(a),
        origin.y - R*std::sin(a),
        origin.z + z
    };
}


std::string refusal(const vector3& direction, const vector3& from, double width)
{
    try
    {
        angularBins(origin, direction, from, width);
    }
    catch (const std::invalid_argument& e)
    {
        return e.what();
    }
    return "none";
}

} // End anonymous namespace


TEST(angularBins, findsTheBin)
{
    const angularBins folded(origin, axis, upstream, 1);
    const angularBins open(origin, axis, upstream, 5, false);
    EXPECT_EQ(folded.size(), 180);
    EXPECT_EQ(open.size(), 72);
    for (double a = -179.75; a < 180; a += 0.5)
    {
        const vector3 x = at(2, a, 7);
        EXPECT_NEAR(folded.phi(x), a, 1e-10);
        EXPECT_EQ(folded.bin(x), int(std::fabs(a)));
        EXPECT_LT(std::fabs(open.centre(open.bin(x)) - a), 2.5);
    }
    EXPECT_EQ(folded.centre(0), 0.5);
    EXPECT_EQ(folded.centre(179), 179.5);
    EXPECT_EQ(folded.bin(at(1, 180, 0)), 179);
    EXPECT_EQ(folded.bin(origin), 0);

    const vector3 n = folded.normal(at(2, 60, 7));
    EXPECT_NEAR(n.x, -0.5, 1e-14);
    EXPECT_NEAR(n.y, -std::sqrt(0.75), 1e-14);
    EXPECT_EQ(n.z, 0);
}


TEST(angularBins, hasTheAreaOfTheFaces)
{
    // Half a cylinder of flat faces of 0.7 degrees, whose edges are not those
    // of the bins: chord times thickness, between the half-planes
    const angularBins bins(origin, axis, upstream, 1);
    const double R = 0.03;
    const double dz = 1e-3;
    std::vector<double> areas(bins.size(), 0.0);
    const int n = 180;
    const double dphi = 0.7;
    double total = 0;
    for (int i = 0; i < n; ++i)
    {
        const double a = i*dphi - 30;
        bins.addArea
        (
            {
                at(R, a, 0), at(R, a + dphi, 0),
                at(R, a + dphi, dz), at(R, a, dz)
            },
            areas
        );
        total += 2*R*std::sin(dphi/2*M_PI/180)*dz;
    }
    const double sum = std::accumulate(areas.begin(), areas.end(), 0.0);
    EXPECT_NEAR(sum/total, 1, 1e-13);

    const double arc = R*M_PI/180*dz;
    const double flat = 1 - std::pow(dphi*M_PI/180, 2)/24;
    for (int k = 0; k < bins.size(); ++k)
    {
        // Both signs of phi up to 30 degrees, one up to 96
        const double exact = k < 30 ? 2 : k < 96 ? 1 : 0;
        EXPECT_NEAR(areas[k]/arc, exact*flat, 3e-5) << k;
    }
}


TEST(angularBins, cutsLargeFaces)
{
    // A square about the axis as seen along it: sides at distance 1
    const angularBins bins(origin, axis, upstream, 10, false);
    std::vector<double> areas(bins.size(), 0.0);
    const double h = std::sqrt(2.0);
    for (int side = 0; side < 4; ++side)
    {
        const double a = 45 + 90*side;
        bins.addArea({at(h, a, 0), at(h, a + 90, 0), at(h, a + 90, 3),
            at(h, a, 3)}, areas);
    }
    EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), 24, 1e-12);
    const auto tangent = [](double d) { return std::tan(d*M_PI/180); };
    EXPECT_NEAR(areas[18], 3*tangent(10), 1e-12);
    EXPECT_NEAR(areas[21], 3*(tangent(40) - tangent(30)), 1e-12);
    EXPECT_NEAR(areas[22], 6*(1 - tangent(40)), 1e-12);
}


TEST(angularBins, givesAWallInThePlaneOfAnEdgeToTheBinsOfItsHits)
{
    // A floor through the axis: 1 on one side of it, 3 on the other, 2 along
    for (const double turned : {0.0, 20.0, 60.0, 90.0, 180.0, 300.0})
    {
        for (const bool folded : {false, true})
        {
            const vector3 from = at(1, turned, 0) - origin;
            const angularBins bins(origin, axis, from, 10, folded);
            std::vector<double> areas(bins.size(), 0.0);
            bins.addArea
            (
                {at(1, 0, 0), at(3, 180, 0), at(3, 180, 2), at(1, 0, 2)}, areas
            );
            std::vector<double> hits(bins.size(), 0.0);
            for (const double R : {0.01, 0.3, 0.9})
            {
                hits[bins.bin(at(R, 0, 2*R))] += 2.0/3;
                hits[bins.bin(at(3*R, 180, 2*R))] += 6.0/3;
            }
            for (int k = 0; k < bins.size(); ++k)
            {
                EXPECT_NEAR(areas[k], hits[k], 1e-12) << turned << ' ' << k;
            }
        }
    }
}


TEST(angularBins, refusesBadInput)
{
    const vector3 zero{0, 0, 0};
    EXPECT_NE(refusal(zero, upstream, 1).find("length"), std::string::npos);
    EXPECT_NE(refusal(axis, axis, 1).find("across"), std::string::npos);
    EXPECT_NE(refusal(axis, zero, 1).find("across"), std::string::npos);
    for (const double width : {0.0, -1.0, 91.0, 7.0})
    {
        EXPECT_NE(refusal(axis, upstream, width).find("binWidth"),
            std::string::npos) << width;
    }
    EXPECT_EQ(refusal(axis, upstream, 0.25), "none");
}
