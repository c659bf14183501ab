/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The convex cells of a small box mesh, and of the same mesh with one point
    moved, whose eight cells are to be split: every plane must be that of the
    cell behind it but for its sign, every point in one cell, every ray must
    leave where the box ends.
\*---------------------------------------------------------------------------*/

#include "boxMeshTest.H"
#include "convexCells.H"
#include "counterRandom.H"

#include <gtest/gtest.h>

using namespace Foam;
using impact::vector3;

class convexCellsTest
:
    public boxMeshTest
{
protected:

    //- Planes that are not those of the cell behind them
    label nMismatched(const convexCells& cells) const
    {
        using namespace walkKernels;
        const auto value = [&](const label place, const label row)
        {
            return cells.planes()
                [stride*(place/width) + row*width + place % width];
        };

        label n = 0;
        for (label c = 0; c < cells.size(); ++c)
        {
            const label first = width*cells.firstGroup()[c];
            const label last = width*cells.firstGroup()[c + 1];
            for (label k = first; k < last; ++k)
            {
                const label next = cells.targets()[k];
                const bool used =
                    value(k, 0) != 0 || value(k, 1) != 0 || value(k, 2) != 0;
                if (!used || next < 0)
                {
                    continue;
                }
                bool found = false;
                const label end = width*cells.firstGroup()[next + 1];
                for (label m = width*cells.firstGroup()[next]; m < end; ++m)
                {
                    bool same = true;
                    for (label row = 0; row < 4; ++row)
                    {
                        same = same && value(m, row) == -value(k, row);
                    }
                    found = found || same;
                }
                n += !found;
            }
        }
        return n;
    }

    //- Of a random sample: points that are in no cell of their mesh cell, and
    //  rays to the end of z that do not end there
    void sample(const convexCells& cells, label& nNowhere, label& nAstray)
    {
        nNowhere = 0;
        nAstray = 0;
        impact::counterRandom rnd(4);
        for (label i = 0; i < 2000; ++i)
        {
            const vector3 x{rnd.uniform(), rnd.uniform(), rnd.uniform()};
            label c = -1;
            for (label celli = 0; celli < mesh_->nCells() && c < 0; ++celli)
            {
                const label some = cells.locate(celli, x);
                if (cells.height(some, x) <= 0)
                {
                    c = some;
                }
            }
            if (c < 0)
            {
                ++nNowhere;
                continue;
            }

            // Steeply up, without reaching a side
            const vector3 u
            {
                0.9*(0.5 - x.x), 0.9*(0.5 - x.y), 1
            };
            scalar t = 0;
            label boundary = -1;
            for (label step = 0; step < 1000 && boundary < 0; ++step)
            {
                label place = -1;
                t = max(t, cells.exitTime(c, x, u, 10, place));
                if (place < 0)
                {
                    break;
                }
                const label next = cells.behind(place, x + t*u);
                boundary = next < 0 ? -1 - next : -1;
                c = next;
            }
            nAstray +=
                boundary < 0
             || cells.boundary()[boundary].kind != convexCells::wall
             || mag(t - (1 - x.z)) > 1e-12;
        }
    }
};


TEST_F(convexCellsTest, regularMeshIsItself)
{
    const convexCells cells(mesh_());
    EXPECT_EQ(cells.size(), 64);
    EXPECT_EQ(cells.nSplit(), 0);
    EXPECT_EQ(nMismatched(cells), 0);
    label nNowhere, nAstray;
    sample(cells, nNowhere, nAstray);
    EXPECT_EQ(nNowhere, 0);
    EXPECT_EQ(nAstray, 0);
}


TEST_F(convexCellsTest, warpedCellsAreSplitIntoTetrahedra)
{
    warp();
    const convexCells cells(mesh_());
    EXPECT_EQ(cells.nSplit(), 8);
    EXPECT_EQ(cells.size(), 56 + 8*12);
    label nNowhere, nAstray;
    sample(cells, nNowhere, nAstray);
    EXPECT_EQ(nNowhere, 0);
    EXPECT_EQ(nAstray, 0);

    // Numbered with their mesh cells
    for (label c = 0; c < mesh_->nCells(); ++c)
    {
        const label first = cells.firstCell()[c];
        const label n = cells.firstCell()[c + 1] - first;
        EXPECT_TRUE(n == 1 || n == 12);
        for (label i = 0; i < n; ++i)
        {
            EXPECT_EQ(cells.meshCell(first + i), c);
        }
    }

    // Also where a whole cell meets a split one
    EXPECT_EQ(nMismatched(cells), 0);
}


TEST_F(convexCellsTest, cyclicPairsAreJoined)
{
    const convexCells cells(mesh_());
    label n = 0;
    for (const convexCells::boundaryFace& face : cells.boundary())
    {
        if (face.kind != convexCells::cyclic)
        {
            continue;
        }
        ++n;
        const convexCells::boundaryFace& other = cells.boundary()[face.mate];
        EXPECT_EQ(&cells.boundary()[other.mate], &face);
        EXPECT_EQ(face.rotation, -1);
        EXPECT_NEAR(mag(face.shift), 1, 1e-15);
        EXPECT_EQ(face.shift.x, -other.shift.x);
    }
    EXPECT_EQ(n, 32);
}


TEST_F(convexCellsTest, concaveMeshWithoutDecompositionIsRefused)
{
    // The middle point far outside its cells turns them inside out
    pointField points(mesh_->points());
    forAll(points, i)
    {
        if (mag(points[i] - point(0.5, 0.5, 0.5)) < 1e-9)
        {
            points[i] += vector(0.6, 0.6, 0.6);
        }
    }
    mesh_->movePoints(points);
    std::string said;
    try
    {
        const convexCells cells(mesh_());
    }
    catch (const error& e)
    {
        said = e.message();
    }
    EXPECT_NE(said.find("no decomposition"), std::string::npos) << said;
}


TEST_F(convexCellsTest, boundsGiveWhatPlanesGive)
{
    for (const bool warped : {false, true})
    {
        if (warped)
        {
            warp();
        }
        const convexCells cells(mesh_());
        ASSERT_NE(cells.shapes().bounds, nullptr);

        struct particles
        {
            std::vector<std::int32_t> start, cell, leavers, stopped;
            std::vector<double> x[6];
        };
        particles a;
        impact::counterRandom rnd(9);
        a.start.assign(1, 0);
        for (label c = 0; c < cells.size(); ++c)
        {
            const label n = label(20*rnd.uniform());
            for (label i = 0; i < n; ++i)
            {
                // A point of the cell's mesh cell in the convex cell
                const point& centre =
                    mesh_->cellCentres()[cells.meshCell(c)];
                vector3 x;
                do
                {
                    x =
                    {
                        centre.x() + 0.25*(rnd.uniform() - 0.5),
                        centre.y() + 0.25*(rnd.uniform() - 0.5),
                        centre.z() + 0.25*(rnd.uniform() - 0.5)
                    };
                }
                while (cells.height(c, x) > 0);
                const double all[6] =
                {
                    x.x, x.y, x.z,
                    rnd.normal(), i % 7 ? rnd.normal() : 0, rnd.normal()
                };
                for (label d = 0; d < 6; ++d)
                {
                    a.x[d].push_back(all[d]);
                }
                a.cell.push_back(c);
            }
            a.start.push_back(a.cell.size());
        }
        a.leavers.resize(a.cell.size() + 1);
        a.stopped.resize(a.cell.size() + 1);
        particles b(a);

        const double dt[3] = {0.1, 0.1, 0.1};
        const auto fly = [&](particles& p, const bool bounds)
        {
            walkKernels::convexShapes shapes = cells.shapes();
            if (!bounds)
            {
                shapes.bounds = nullptr;
            }
            p.stopped.resize
            (
                walkKernels::fly
                (
                    cells.size(), p.start.data(), shapes,
                    p.x[0].data(), p.x[1].data(), p.x[2].data(),
                    p.x[3].data(), p.x[4].data(), p.x[5].data(),
                    dt, p.cell.data(), p.leavers.data(), p.stopped.data()
                )
            );
        };
        fly(a, true);
        fly(b, false);
        EXPECT_GT(a.stopped.size(), 10);
        EXPECT_EQ(a.stopped, b.stopped);
        EXPECT_EQ(a.cell, b.cell);
        for (label d = 0; d < 6; ++d)
        {
            EXPECT_EQ(a.x[d], b.x[d]);
        }

        // Those that arrive are in their cell
        std::vector<bool> stopped(a.cell.size(), false);
        for (const std::int32_t i : a.stopped)
        {
            stopped[i] = true;
        }
        for (label i = 0; i < label(a.cell.size()); ++i)
        {
            const vector3 x{a.x[0][i], a.x[1][i], a.x[2][i]};
            EXPECT_TRUE(stopped[i] || cells.height(a.cell[i], x) < 1e-14);
        }
    }
}
