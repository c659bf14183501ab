/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The coarse correction of linear equations by strips of cells, in a row of
    cells each of which feels the next two on either side.
\*---------------------------------------------------------------------------*/

#include "stripCorrection.H"
#include "randomNumbers.H"

#include <gtest/gtest.h>
#include <algorithm>
#include <random>

namespace
{

typedef std::vector<double> numbers;


//- Random blocks of a row of cells, stronger on the diagonal
struct row
{
    const int nCells;
    const int nVar;
    std::vector<int> lower;
    std::vector<int> diagonal;
    std::vector<int> column;
    std::vector<float> block;
    numbers weight;
    std::mt19937 random;

    row(const int nCells, const int nVar)
    :
        nCells(nCells),
        nVar(nVar),
        random(nCells)
    {
        add(lower, -2, 0);
        add(diagonal, 0, 3);
        std::uniform_real_distribution<double> scale(0.5, 2);
        for (int i = 0; i < nCells*nVar; i++)
        {
            weight.push_back(scale(random));
        }
    }

    void add(std::vector<int>& start, const int from, const int to)
    {
        std::normal_distribution<float> normal;
        start.push_back(int(column.size()));
        for (int r = 0; r < nCells; r++)
        {
            const int end = std::min(r + to, nCells);
            for (int c = std::max(r + from, 0); c < end; c++)
            {
                column.push_back(c);
                for (int k = 0; k < nVar*nVar; k++)
                {
                    block.push_back
                    (
                        normal(random)
                      + (c == r && k/nVar == k%nVar ? 20 : 0)
                    );
                }
            }
            start.push_back(int(column.size()));
        }
    }

    numbers times(const numbers& x) const
    {
        numbers y(x.size(), 0);
        for (const std::vector<int>* start : {&lower, &diagonal})
        {
            for (int r = 0; r < nCells; r++)
            {
                for (int i = (*start)[r]; i < (*start)[r + 1]; i++)
                {
                    for (int k = 0; k < nVar*nVar; k++)
                    {
                        y[r*nVar + k/nVar] +=
                            double(block[i*nVar*nVar + k])
                           *x[column[i]*nVar + k%nVar];
                    }
                }
            }
        }
        return y;
    }

    void give(Foam::stripCorrection& strips) const
    {
        strips.set(lower, diagonal, column, block, weight);
    }
};

} // End anonymous namespace


TEST(stripCorrection, findsAChangeThatIsTheSameInEachStrip)
{
    for (const int nCells : {1, 7, 333, 1000})
    {
        for (const int nVar : {4, 5})
        {
            row cells(nCells, nVar);
            Foam::stripCorrection strips(nCells, nVar);
            cells.give(strips);

            // As many runs of cells as there are strips
            const int nStrips = std::min(50, nCells);
            const numbers value =
                randomNumbers(cells.random, nStrips*nVar);
            numbers change(nCells*nVar);
            for (int i = 0; i < nCells*nVar; i++)
            {
                const int c = i/nVar;
                change[i] = value[c*nStrips/nCells*nVar + i%nVar];
            }

            numbers b = cells.times(change);
            strips.remove(b);
            numbers found(nCells*nVar, 0);
            strips.add(found);
            for (int i = 0; i < nCells*nVar; i++)
            {
                ASSERT_NEAR(found[i], change[i], 1e-5);
                ASSERT_NEAR(b[i], 0, 1e-3);
            }
        }
    }
}


TEST(stripCorrection, leavesNoSumOverAStrip)
{
    const int nCells = 400;
    const int nVar = 4;
    row cells(nCells, nVar);
    Foam::stripCorrection strips(nCells, nVar);
    cells.give(strips);

    const numbers before = randomNumbers(cells.random, nCells*nVar);
    numbers b = before;
    strips.remove(b);

    // What is left is b less the product with the change
    numbers change(nCells*nVar, 0);
    strips.add(change);
    const numbers product = cells.times(change);
    double sums[50][nVar] = {};
    for (int i = 0; i < nCells*nVar; i++)
    {
        ASSERT_NEAR(b[i], before[i] - product[i], 1e-5);
        sums[i/nVar*50/nCells][i%nVar] += cells.weight[i]*b[i];
    }
    for (const auto& strip : sums)
    {
        for (const double sum : strip)
        {
            EXPECT_NEAR(sum, 0, 1e-4);
        }
    }
}
