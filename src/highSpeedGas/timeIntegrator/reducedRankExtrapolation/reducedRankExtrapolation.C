/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "reducedRankExtrapolation.H"
#include <Eigen/Cholesky>

Foam::reducedRankExtrapolation::reducedRankExtrapolation(gasEquations& gas)
:
    gas_(gas),
    nIterations_(-rest_),
    marchImbalance_(0),
    scale_(gas.conserved.size()),
    equationScale_(gas.conserved.size())
{}


void Foam::reducedRankExtrapolation::restart()
{
    states_.clear();
    march_.clear();
    nIterations_ = -rest_;
}


std::vector<double> Foam::reducedRankExtrapolation::weights()
{
    constexpr int n = nModes_ + 1;
    gas_.scales(scale_, equationScale_);

    scalarList products(n*n, Zero);
    for (std::size_t k = 0; k < scale_.size(); k++)
    {
        double change[n];
        for (int i = 0; i < n; i++)
        {
            change[i] = (states_[i + 1][k] - states_[i][k])/scale_[k];
        }
        for (int i = 0; i < n; i++)
        {
            for (int j = 0; j < n; j++)
            {
                products[i*n + j] += change[i]*change[j];
            }
        }
    }
    if (Pstream::parRun())
    {
        Pstream::listCombineGather(products, plusEqOp<scalar>());
        Pstream::listCombineScatter(products);
    }

    // Fewer modes than states leave some weights free: then none is large
    typedef Eigen::Matrix<double, n, n> matrix;
    matrix M = Eigen::Map<matrix>(products.data());
    M += 1e-10*M.trace()*matrix::Identity();
    Eigen::Matrix<double, n, 1> g =
        M.ldlt().solve(Eigen::Matrix<double, n, 1>::Ones());
    g /= g.sum();
    return std::vector<double>(g.data(), g.data() + n);
}


void Foam::reducedRankExtrapolation::extrapolate()
{
    const std::vector<double> g(weights());
    std::vector<double> limit(scale_.size(), 0);
    for (std::size_t i = 0; i < g.size(); i++)
    {
        for (std::size_t k = 0; k < limit.size(); k++)
        {
            limit[k] += g[i]*states_[i + 1][k];
        }
    }
    restart();
    march_ = gas_.conserved;
    if (gas_.accept(limit) == 0)
    {
        gas_.conserved.swap(limit);
        gas_.correctBoundary();
    }
    else
    {
        gas_.calm();
        march_.clear();
    }
}


void Foam::reducedRankExtrapolation::follow(const scalar imbalance)
{
    if (!march_.empty())
    {
        if (imbalance > marchImbalance_)
        {
            gas_.conserved = march_;
            gas_.restore(march_);
            gas_.correctBoundary();
        }
        restart();
        return;
    }
    if (++nIterations_ <= 0 || nIterations_ % stride_ != 0)
    {
        return;
    }
    states_.push_back(gas_.conserved);
    if (label(states_.size()) == nModes_ + 2)
    {
        marchImbalance_ = imbalance;
        extrapolate();
    }
}
