/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    What is read at the faces of the gas: rows of cell values against the
    formula face by face, gradients on a scattered stencil against a linear
    field, and the share in which the gas expands.
\*---------------------------------------------------------------------------*/

#include "expansion.H"
#include "faceRows.H"
#include "gradients.H"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

using Foam::faceBlock;
using Foam::faceRows;

namespace
{

//- Faces between cells of a mesh without any order
struct mesh
{
    int nDim;
    int nCells = 50;
    int nFaces = 150;
    std::vector<int> owner;
    std::vector<int> far;
    std::vector<double> alongOwner;
    std::vector<double> alongFar;
    std::vector<double> normal;
    std::vector<double> q;
    std::vector<double> g;

    explicit mesh(const int n)
    :
        nDim(n)
    {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> uniform(-1, 1);
        auto numbers = [&](std::vector<double>& v, const int size)
        {
            v.resize(size);
            for (double& x : v)
            {
                x = uniform(random);
            }
        };
        for (int f = 0; f < nFaces; f++)
        {
            owner.push_back(int(random() % nCells));
            far.push_back(int(random() % nCells));
        }
        numbers(alongOwner, nFaces*nDim);
        numbers(alongFar, nFaces*nDim);
        numbers(normal, nFaces*nDim);
        numbers(q, nCells*nVar());
        numbers(g, nCells*nVar()*nDim);
    }

    int nVar() const
    {
        return nDim + 2;
    }

    Foam::faceLinks links(const bool ahead) const
    {
        return
        {
            nFaces, owner.data(), far.data(), alongOwner.data(),
            alongFar.data(), normal.data(), ahead
        };
    }

    //- Twice the change of variable k of cell c along the way
    double change(const int c, const double* along, const int k) const
    {
        double sum = 0;
        for (int d = 0; d < nDim; d++)
        {
            sum += 2*along[d]*g[(c*nDim + d)*nVar() + k];
        }
        return sum;
    }
};

} // End anonymous namespace


TEST(faceRows, turnIntoTheBlockWhatTheCellsHold)
{
    for (const int nDim : {2, 3})
    {
        const mesh m(nDim);
        auto rows = std::make_unique<faceRows>();
        auto block = std::make_unique<faceBlock>();
        for (int first = 0; first < m.nFaces; first += faceBlock::size)
        {
            const int n = std::min(int(faceBlock::size), m.nFaces - first);
            const Foam::faceLinks links = m.links(first > 0);
            rows->read(links, nDim, first, n, m.q.data(), m.g.data());
            rows->turnOver(links, nDim, first, n, *block);
            for (int i = 0; i < n; i++)
            {
                const int f = first + i;
                for (int k = 0; k < m.nVar(); k++)
                {
                    const int o = m.owner[f];
                    const int r = m.far[f];
                    EXPECT_EQ(block->owner[k][i], m.q[o*m.nVar() + k]);
                    EXPECT_EQ(block->far[k][i], m.q[r*m.nVar() + k]);
                    EXPECT_EQ
                    (
                        block->slopeOwner[k][i],
                        m.change(o, &m.alongOwner[f*nDim], k)
                    );
                    EXPECT_EQ
                    (
                        block->slopeFar[k][i],
                        m.change(r, &m.alongFar[f*nDim], k)
                    );
                }
                for (int d = 0; d < nDim; d++)
                {
                    EXPECT_EQ(block->normal[d][i], m.normal[f*nDim + d]);
                }
            }
        }
    }
}


TEST(gradients, areThoseOfALinearField)
{
    // Cells on a lattice of which each knows its neighbours along the axes:
    // the vectors are then d/(2 |d|^2)
    for (const int nDim : {2, 3})
    {
        const int edge = 5;
        const int nVar = nDim + 2;
        const int nCells = nDim == 2 ? edge*edge : edge*edge*edge;
        std::vector<int> start{0};
        std::vector<int> neighbour;
        std::vector<double> vectors;
        std::vector<double> q(nCells*nVar);
        std::vector<bool> inner;
        auto slope = [](const int d, const int k)
        {
            return 1 + d - 0.7*k;
        };
        for (int c = 0; c < nCells; c++)
        {
            const int at[3] = {c % edge, c/edge % edge, c/(edge*edge)};
            bool all = true;
            int stride = 1;
            for (int d = 0; d < nDim; d++)
            {
                for (const int way : {-1, 1})
                {
                    const int to = at[d] + way;
                    if (to < 0 || to >= edge)
                    {
                        all = false;
                        continue;
                    }
                    neighbour.push_back(c + way*stride);
                    for (int e = 0; e < nDim; e++)
                    {
                        vectors.push_back(e == d ? 0.5*way : 0);
                    }
                }
                stride *= edge;
            }
            start.push_back(int(neighbour.size()));
            inner.push_back(all);
            for (int k = 0; k < nVar; k++)
            {
                q[c*nVar + k] = 3*k;
                for (int d = 0; d < nDim; d++)
                {
                    q[c*nVar + k] += slope(d, k)*at[d];
                }
            }
        }
        std::vector<double> g(nCells*nVar*nDim, 1e9);
        Foam::leastSquaresGradients
        (
            {nCells, start.data(), neighbour.data(), vectors.data()},
            nDim,
            q.data(),
            g.data()
        );
        for (int c = 0; c < nCells; c++)
        {
            for (int i = 0; i < (inner[c] ? nVar*nDim : 0); i++)
            {
                EXPECT_NEAR
                (
                    g[c*nVar*nDim + i], slope(i/nVar, i % nVar), 1e-13
                );
            }
        }
    }
}


TEST(expansion, isTheShareOfTheSmallestIncrease)
{
    const double R = 287;
    for (const int nDim : {2, 3})
    {
        auto block = std::make_unique<faceBlock>();
        for (int i = 0; i < faceBlock::size; i++)
        {
            for (int d = 0; d < nDim; d++)
            {
                block->normal[d][i] = d == nDim - 1;
                block->owner[2 + d][i] = 10;
                block->far[2 + d][i] = 10 + (i % 4 == 1 ? -i : i);
                block->slopeOwner[2 + d][i] = i % 4 == 2 ? 0.5*i : 3*i;
                block->slopeFar[2 + d][i] = 1.5*i;
            }
            block->owner[1][i] = 280;
            block->far[1][i] = 320;
        }
        Foam::faceExpansion(*block, faceBlock::size, nDim, R);
        for (int i = 0; i < faceBlock::size; i++)
        {
            // Across the next face the increase is that of both ways less
            // that across this one
            const double a = i % 4 == 1 || i % 4 == 2 ? 0 : 0.5*i;
            EXPECT_NEAR
            (
                block->expands[i], a*a/(a*a + 1e-3*R*300), 1e-14
            ) << i;
        }
    }
}
