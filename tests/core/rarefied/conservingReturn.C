/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    What a cell is given it takes to round-off, or it says what it has left.
\*---------------------------------------------------------------------------*/

#include "conservingReturn.H"
#include "counterRandom.H"

#include <gtest/gtest.h>
#include <cmath>

using namespace impact;

namespace
{
    const std::vector<cellCollisions::species> kinds =
        {{3.3e-27, 2.9e-10, 0.67, 2}, {66e-27, 4e-10, 0.74, 0}};

    struct cell
    {
        std::vector<double> u, v, w, e;
        std::vector<std::int32_t> kind;

        cell(int n, double spread)
        {
            counterRandom rnd(n);
            for (int i = 0; i < n; ++i)
            {
                u.push_back(1500 + spread*rnd.normal());
                v.push_back(spread*rnd.normal());
                w.push_back(spread*rnd.normal());
                kind.push_back(i % 2);
                e.push_back(i % 2 ? 0 : 1e-21*rnd.uniform());
            }
        }

        cellCollisions::molecules molecules()
        {
            return
            {
                int(u.size()), nullptr, nullptr, nullptr, u.data(), v.data(),
                w.data(), e.data(), kind.data()
            };
        }
    };
}


TEST(conservingReturn, theCellTakesWhatItCan)
{
    const conservingReturn cells(kinds);
    for (const int n : {2, 3, 50})
    {
        for (const double size : {0., 1e-3, 0.3, 30., -0.1, -0.9, -50.})
        {
            cell c(n, 400);
            const balance before = cells.of(c.molecules());
            double thermal = 0;
            for (int i = 0; i < n; ++i)
            {
                thermal += 1.5*kinds[c.kind[i]].mass*400*400;
            }
            balance given;
            given.energy = size*thermal;
            given.momentum =
                {size*n*3e-26*300, -0.5*size*n*3e-26*300, 1e-26*size};
            const balance left = cells.give(c.molecules(), given);
            const balance after = cells.of(c.molecules());
            const double tolerance = 1e-13*before.energy;
            EXPECT_NEAR
            (
                after.energy + left.energy - before.energy - given.energy, 0,
                tolerance*(1 + std::fabs(size))
            ) << n << ' ' << size;
            const vector3 P = after.momentum + left.momentum
                - before.momentum - given.momentum;
            EXPECT_LT(mag(P), 1e-13*mag(before.momentum)*(1 + std::fabs(size)));
            if (std::fabs(size) < 1e-2 && n > 2)
            {
                EXPECT_TRUE(left.isZero());
            }
            if (std::fabs(size) > 20)
            {
                EXPECT_FALSE(left.isZero());
            }
        }
    }
}


TEST(conservingReturn, oneMoleculeAndAColdCellTakeNothing)
{
    const conservingReturn cells(kinds);
    balance given;
    given.energy = 1e-22;
    given.momentum = {1e-25, 0, 0};
    for (const int n : {0, 1})
    {
        cell c(n, 400);
        const cell before = c;
        const balance left = cells.give(c.molecules(), given);
        EXPECT_EQ(left.energy, given.energy);
        EXPECT_EQ(left.momentum.x, given.momentum.x);
        EXPECT_EQ(c.u, before.u);
    }

    // All of one velocity: there is no thermal motion to scale
    cell cold(4, 0);
    cold.e.assign(4, 0);
    const balance left = cells.give(cold.molecules(), given);
    EXPECT_EQ(left.energy, given.energy);
    EXPECT_EQ(cold.u[3], 1500);
}


TEST(conservingReturn, aShiftKeepsTheThermalMotion)
{
    const conservingReturn cells(kinds);
    cell c(40, 400);
    const cell before = c;
    const balance b = cells.of(c.molecules());
    double mass = 0;
    for (const int s : c.kind)
    {
        mass += kinds[s].mass;
    }
    balance given;
    given.momentum = {0, 10*mass, 0};
    given.energy = 10*b.momentum.y + 0.5*100*mass;
    EXPECT_TRUE(cells.give(c.molecules(), given).isZero());
    for (int i = 0; i < 40; ++i)
    {
        EXPECT_NEAR(c.u[i], before.u[i], 1e-9);
        EXPECT_NEAR(c.v[i], before.v[i] + 10, 1e-9);
    }
}
