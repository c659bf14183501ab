/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    What the sweeps of the implicit march come to rest at: the solution of the
    linearised equations, with the change of the fluxes as differences of the
    fluxes of two states.
\*---------------------------------------------------------------------------*/

#include "gaussSeidel.H"

#include <gtest/gtest.h>
#include <cmath>
#include <random>
#include <vector>

namespace
{

//- Gas constant and specific heat at constant volume [J/(kg K)]
const double R = 287;
const double cv = 717.5;


//- Flux of W = (rho, rho E, rho u) in direction d
std::vector<double> flux(const std::vector<double>& W, const int d)
{
    const std::size_t nVar = W.size();
    double mm = 0;
    for (std::size_t k = 2; k < nVar; k++)
    {
        mm += W[k]*W[k];
    }
    const double p = R/cv*(W[1] - 0.5*mm/W[0]);
    const double u = W[2 + d]/W[0];
    std::vector<double> F(nVar);
    for (std::size_t k = 0; k < nVar; k++)
    {
        F[k] = u*W[k];
    }
    F[1] += u*p;
    F[2 + d] += p;
    return F;
}


//- A ring of cells, each beside two others and one behind a boundary
struct ring
{
    const int nDim;
    const int nVar;
    const int nCells = 12;
    std::vector<int> start{0};
    std::vector<int> neighbour;
    std::vector<double> coeffs;
    std::vector<double> cells;
    std::vector<double> q;
    std::vector<double> rate;
    std::vector<double> change;

    explicit ring(const int n)
    :
        nDim(n),
        nVar(n + 2)
    {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> uniform(-1, 1);
        for (int c = 0; c < nCells; c++)
        {
            for (const int to : {(c + 5) % nCells, (c + 7) % nCells, nCells})
            {
                neighbour.push_back(to);
                coeffs.push_back(100 + 30*uniform(random));
                for (int d = 0; d < nDim; d++)
                {
                    coeffs.push_back(0.05*uniform(random));
                }
            }
            start.push_back(int(neighbour.size()));
            const double T = 300 + 50*uniform(random);
            q.push_back(1e5*(1 + 0.2*uniform(random)));
            q.push_back(T);
            for (int d = 0; d < nDim; d++)
            {
                q.push_back(500*uniform(random));
            }
            cells.push_back(1/500.0);
            cells.push_back(R/cv);
            cells.push_back(cv*T);
            for (int k = 0; k < nVar; k++)
            {
                rate.push_back(uniform(random)*(k == 1 ? 1e5 : k ? 300 : 1));
            }
        }
        change.assign((nCells + 1)*nVar*(nDim + 1), 0);
        for (int k = 0; k < nVar*(nDim + 1); k++)
        {
            change[nCells*nVar*(nDim + 1) + k] = 1e-3*k;
        }
    }

    void sweep(const bool forward)
    {
        const Foam::gaussSeidelRows rows
        {
            nCells, start.data(), neighbour.data(), coeffs.data(),
            cells.data(), q.data(), rate.data(), R
        };
        Foam::gaussSeidelSweep(rows, nDim, forward, change.data());
    }

    //- Change of the conserved variables (d = -1) or of their flux
    std::vector<double> changeOf(const int c, const int d) const
    {
        const double* at = &change[(c*(nDim + 1))*nVar];
        if (d < 0 || c == nCells)
        {
            return {at + (d + 1)*nVar, at + (d + 2)*nVar};
        }
        std::vector<double> W(nVar);
        W[0] = q[c*nVar]/(R*q[c*nVar + 1]);
        W[1] = cv*q[c*nVar + 1];
        for (int k = 2; k < nVar; k++)
        {
            W[k] = W[0]*q[c*nVar + k];
            W[1] += 0.5*q[c*nVar + k]*q[c*nVar + k];
        }
        W[1] *= W[0];
        std::vector<double> above(W), below(W);
        const double step = 1e-5;
        for (int k = 0; k < nVar; k++)
        {
            above[k] += step*at[k];
            below[k] -= step*at[k];
        }
        std::vector<double> dF(flux(above, d));
        const std::vector<double> other(flux(below, d));
        for (int k = 0; k < nVar; k++)
        {
            dF[k] = (dF[k] - other[k])/(2*step);
        }
        return dF;
    }
};


void solves(const int nDim)
{
    ring r(nDim);
    for (int i = 0; i < 200; i++)
    {
        r.sweep(i % 2 == 0);
    }
    for (int c = 0; c < r.nCells; c++)
    {
        const std::vector<double> own(r.changeOf(c, -1));
        std::vector<double> sum(&r.rate[c*r.nVar], &r.rate[(c + 1)*r.nVar]);
        for (int i = r.start[c]; i < r.start[c + 1]; i++)
        {
            const double* coeffs = &r.coeffs[i*(nDim + 1)];
            for (int d = -1; d < nDim; d++)
            {
                const double share = d < 0 ? coeffs[0] : -coeffs[d + 1];
                const auto other = r.changeOf(r.neighbour[i], d);
                for (int k = 0; k < r.nVar; k++)
                {
                    sum[k] += share*other[k];
                }
            }
        }
        for (int k = 0; k < r.nVar; k++)
        {
            const double scale = k == 1 ? 1e5 : k ? 300 : 1;
            EXPECT_NEAR(own[k]/r.cells[3*c], sum[k], 1e-6*scale);
        }
    }
}

} // End anonymous namespace


TEST(gaussSeidel, solvesTheLinearisedEquationsInAPlane)
{
    solves(2);
}


TEST(gaussSeidel, solvesTheLinearisedEquationsInSpace)
{
    solves(3);
}


TEST(gaussSeidel, goesFromTheFirstCellToTheLastOrBack)
{
    // The first cell sees nothing but what stands behind the boundary
    ring forward(2);
    ring backward(2);
    ring one(2);
    forward.sweep(true);
    backward.sweep(false);
    for (int k = 0; k < 4; k++)
    {
        const double* boundary = &one.change[one.nCells*12];
        double first = one.rate[k];
        double last = one.rate[(one.nCells - 1)*4 + k];
        const double* a = &one.coeffs[2*3];
        const double* b = &one.coeffs[(one.neighbour.size() - 1)*3];
        for (int d = 0; d < 3; d++)
        {
            first += (d ? -1 : 1)*a[d]*boundary[d*4 + k];
            last += (d ? -1 : 1)*b[d]*boundary[d*4 + k];
        }
        EXPECT_NEAR(forward.change[k], first/500, 1e-12*std::abs(first));
        EXPECT_NEAR
        (
            backward.change[(one.nCells - 1)*12 + k], last/500,
            1e-12*std::abs(last)
        );
    }
}
