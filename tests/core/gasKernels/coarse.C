/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The coarse correction of linear equations by groups of cells, in a row of
    cells each of which feels the next two on either side.
\*---------------------------------------------------------------------------*/

#include "coarseCorrection.H"
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

    void give(Foam::coarseCorrection& groups) const
    {
        groups.set(lower, diagonal, column, block, weight);
    }
};

} // End anonymous namespace


TEST(coarseCorrection, findsAChangeThatIsTheSameInEachGroup)
{
    for (const int nCells : {1, 7, 333, 1000})
    {
        for (const int nVar : {4, 5})
        {
            row cells(nCells, nVar);
            Foam::coarseCorrection groups(nCells, nVar);
            cells.give(groups);

            const numbers value =
                randomNumbers(cells.random, groups.nGroups()*nVar);
            numbers change(nCells*nVar);
            for (int i = 0; i < nCells*nVar; i++)
            {
                const int c = i/nVar;
                change[i] = value[groups.groups()[c]*nVar + i%nVar];
            }

            numbers b = cells.times(change);
            groups.remove(b);
            numbers found(nCells*nVar, 0);
            groups.add(found);
            for (int i = 0; i < nCells*nVar; i++)
            {
                ASSERT_NEAR(found[i], change[i], 1e-5);
                ASSERT_NEAR(b[i], 0, 1e-3);
            }
        }
    }
}


TEST(coarseCorrection, leavesNoSumOverAGroup)
{
    const int nCells = 900;
    const int nVar = 4;
    row cells(nCells, nVar);
    Foam::coarseCorrection groups(nCells, nVar);
    cells.give(groups);

    const numbers before = randomNumbers(cells.random, nCells*nVar);
    numbers b = before;
    groups.remove(b);

    // What is left is b less the product with the change
    numbers change(nCells*nVar, 0);
    groups.add(change);
    const numbers product = cells.times(change);
    numbers sums(groups.nGroups()*nVar, 0);
    for (int i = 0; i < nCells*nVar; i++)
    {
        ASSERT_NEAR(b[i], before[i] - product[i], 1e-5);
        sums[groups.groups()[i/nVar]*nVar + i%nVar] += cells.weight[i]*b[i];
    }
    for (const double sum : sums)
    {
        EXPECT_NEAR(sum, 0, 1e-4);
    }
}


TEST(coarseCorrection, joinsNeighboursToGroupsOfLikeSize)
{
    for (const int nCells : {1, 399, 1000, 12345})
    {
        row cells(nCells, 4);
        Foam::coarseCorrection groups(nCells, 4);
        cells.give(groups);

        std::vector<int> size(groups.nGroups(), 0);
        std::vector<int> first(groups.nGroups(), nCells);
        std::vector<int> last(groups.nGroups(), -1);
        for (int c = 0; c < nCells; c++)
        {
            const int g = groups.groups()[c];
            ASSERT_TRUE(g >= 0 && g < groups.nGroups());
            size[g]++;
            first[g] = std::min(first[g], c);
            last[g] = std::max(last[g], c);
        }
        EXPECT_LE(groups.nGroups(), Foam::coarseCorrection::maxGroups);
        EXPECT_GE(groups.nGroups(), std::min(nCells, 100));
        const double mean = double(nCells)/groups.nGroups();
        for (int g = 0; g < groups.nGroups(); g++)
        {
            EXPECT_GE(size[g], 1);
            EXPECT_LE(size[g], 4*mean);
            EXPECT_LE(last[g] - first[g], 8*mean);
        }
    }
}
