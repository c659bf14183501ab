/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Grids of the far field: cells of random places against the definitions,
    volumes against those of the whole, what is refused.
\*---------------------------------------------------------------------------*/

#include "plumeGrid.H"
#include "counterRandom.H"

#include <gtest/gtest.h>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

using namespace impact;

namespace
{

double total(const plumeGrid& g)
{
    double V = 0;
    for (int i = 0; i < g.n(0); ++i)
    {
        for (int j = 0; j < g.n(1); ++j)
        {
            for (int k = 0; k < g.n(2); ++k)
            {
                V += g.volume(i, j, k);
            }
        }
    }
    return V;
}


//- Cells of random places and of places far away; 'where' gives up to three
//  coordinates and whether the place is in the layer of the grid
template<class Where>
void expectCells(const plumeGrid& g, double extent, Where where)
{
    counterRandom rnd(9);
    const int n = plumeGrid::batch;
    std::vector<double> x(n), y(n), z(n);
    int inside = 0;
    for (int round = 0; round < 40; ++round)
    {
        for (int i = 0; i < n; ++i)
        {
            const double size = i % 50 ? extent : 1e12*extent;
            x[i] = size*(2*rnd.uniform() - 1);
            y[i] = size*(2*rnd.uniform() - 1);
            z[i] = size*(2*rnd.uniform() - 1);
        }
        std::vector<int> cell(n);
        g.locate(n, x.data(), y.data(), z.data(), cell.data());
        for (int i = 0; i < n; ++i)
        {
            double c[3] = {0.5, 0.5, 0.5};
            bool in = where(x[i], y[i], z[i], c);
            int at[3];
            for (int d = 0; d < 3; ++d)
            {
                const double low = g.coordinate(d, 0);
                const double high = g.coordinate(d, g.n(d));
                at[d] = int(std::floor
                (
                    std::max(-1., std::min(2., (c[d] - low)/(high - low)))
                   *g.n(d)
                ));
                in = in && at[d] >= 0 && at[d] < g.n(d);
            }
            const int index = at[0] + g.n(0)*(at[1] + g.n(1)*at[2]);
            ASSERT_EQ(cell[i], in ? index : -1);
            inside += in;
        }
    }
    EXPECT_GT(inside, 200);
}


template<class Make>
void expectRefused(Make make, const char* words)
{
    try
    {
        make();
        ADD_FAILURE() << "accepted: " << words;
    }
    catch (const std::invalid_argument& error)
    {
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos)
            << error.what();
    }
}

} // End anonymous namespace


TEST(plumeGrid, cellsOwnTheirLowerEnd)
{
    const plumeGrid line = plumeGrid::axis({0, 9, 9}, 1);
    const plumeGrid plane = plumeGrid::plane({-2, 2, 4}, {-4, 4, 8}, 0, 1);
    const double zero = 0;
    for (int i = 0; i < 9; ++i)
    {
        for (const double x : {double(i), std::nextafter(i + 1, 0.)})
        {
            int cell;
            line.locate(1, &x, &zero, &zero, &cell);
            EXPECT_EQ(cell, i) << x;
        }
    }
    for (int j = 0; j < 8; ++j)
    {
        const double x = j % 4 - 2, y = j - 4;
        int cell;
        plane.locate(1, &x, &y, &zero, &cell);
        EXPECT_EQ(cell, j % 4 + 4*j);
    }
}


TEST(plumeGrid, findsTheCellsOfPlaces)
{
    expectCells
    (
        plumeGrid::axis({-3, 5, 17}, 4), 8,
        [](double x, double y, double z, double* c)
        {
            c[0] = x;
            return std::hypot(y, z) < 4;
        }
    );
    expectCells
    (
        plumeGrid::plane({-3, 5, 17}, {-2, 6, 31}, 1, 3), 8,
        [](double x, double y, double z, double* c)
        {
            c[0] = x;
            c[1] = y;
            return std::fabs(z - 1) < 1.5;
        }
    );
    expectCells
    (
        plumeGrid::meridian({-3, 5, 17}, {1, 6, 9}), 8,
        [](double x, double y, double z, double* c)
        {
            c[0] = x;
            c[1] = std::hypot(y, z);
            return true;
        }
    );
    expectCells
    (
        plumeGrid::sphere({1, -1, 0.5}, {2, 9, 12}, 18, 24), 8,
        [](double x, double y, double z, double* c)
        {
            x -= 1;
            y += 1;
            z -= 0.5;
            c[0] = std::sqrt(x*x + y*y + z*z);
            c[1] = std::atan2(std::hypot(y, z), x);
            c[2] = std::atan2(z, y);
            c[2] += c[2] < 0 ? 2*M_PI : 0;
            return true;
        }
    );
}


TEST(plumeGrid, hasTheVolumeOfTheWhole)
{
    EXPECT_NEAR(total(plumeGrid::axis({-3, 5, 7}, 4)), 8*M_PI*16, 1e-10);
    EXPECT_NEAR
    (
        total(plumeGrid::plane({-3, 5, 7}, {0, 2, 3}, 1, 0.5)), 8, 1e-12
    );
    EXPECT_NEAR
    (
        total(plumeGrid::meridian({0, 2, 7}, {1, 3, 4})), 2*M_PI*8, 1e-12
    );
    EXPECT_NEAR
    (
        total(plumeGrid::sphere({9, 9, 9}, {1, 2, 7}, 8, 9)),
        4*M_PI/3*7, 1e-11
    );
}


TEST(plumeGrid, putsTheCentreOfACellIntoTheCell)
{
    const plumeGrid grids[] =
    {
        plumeGrid::axis({-3, 5, 7}, 4),
        plumeGrid::plane({-3, 5, 7}, {0, 2, 3}, 1, 0.5),
        plumeGrid::meridian({0, 2, 7}, {1, 3, 4}),
        plumeGrid::sphere({9, 8, 7}, {1, 2, 7}, 8, 9)
    };
    for (const plumeGrid& g : grids)
    {
        for (int c = 0; c < g.nCells(); ++c)
        {
            const int i = c % g.n(0), j = c/g.n(0) % g.n(1);
            const int k = c/g.n(0)/g.n(1);
            const vector3 p = g.point(i + 0.5, j + 0.5, k + 0.5);
            int cell;
            g.locate(1, &p.x, &p.y, &p.z, &cell);
            ASSERT_EQ(cell, c);
        }
    }
}


TEST(plumeGrid, refusesWhatIsOutOfRange)
{
    expectRefused([] { plumeGrid::axis({5, 5, 2}, 1); }, "to of x 5");
    expectRefused([] { plumeGrid::axis({0, 5, 0}, 1); }, "n of x 0");
    expectRefused([] { plumeGrid::axis({0, 5, 2}, 0); }, "radius 0");
    expectRefused
    (
        [] { plumeGrid::plane({0, 1, 2}, {0, 1, 2}, 0, 0); }, "thickness 0"
    );
    expectRefused
    (
        [] { plumeGrid::meridian({0, 1, 2}, {-1, 1, 2}); }, "from of r -1"
    );
    expectRefused
    (
        [] { plumeGrid::sphere({0, 0, 0}, {0, 1, 2}, 0, 1); }, "nPolar 0"
    );
    expectRefused
    (
        [] { plumeGrid::sphere({0, 0, 0}, {0, 1, 2}, 1, -4); }, "nAzimuth"
    );
    expectRefused
    (
        [] { plumeGrid::meridian({0, 1, 100000}, {0, 1, 100000}); },
        "number of cells"
    );
}
