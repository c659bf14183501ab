/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "NewtonKrylov.H"
#include <algorithm>

Foam::NewtonKrylov::NewtonKrylov(gasEquations& gas)
:
    gas_(gas),
    nVar_(gas.nVar()),
    nCells_(gas.geometry().nCells()),
    nUnknowns_(nCells_*nVar_),
    groups_(nCells_, nVar_),
    slow_(false),
    unknownScale_(nUnknowns_),
    equationScale_(nUnknowns_),
    ownStep_(nCells_),
    baseResidual_(nUnknowns_),
    trial_(nUnknowns_),
    work_(nUnknowns_),
    rest_(nUnknowns_),
    norm_(GREAT),
    solved_(true),
    nProducts_(0)
{
    setBlocks();
}


void Foam::NewtonKrylov::setScales()
{
    gas_.scales(unknownScale_, equationScale_);

    const std::vector<double>& volume = gas_.geometry().volume;
    scalar longest = 0;
    for (label c = 0; c < nCells_; c++)
    {
        const label i = c*nVar_;
        ownStep_[c] = volume[c]*unknownScale_[i]/equationScale_[i];
        longest = max(longest, ownStep_[c]);
    }
    reduce(longest, maxOp<scalar>());
    for (double& step : ownStep_)
    {
        step /= longest;
    }
}


Foam::scalar Foam::NewtonKrylov::dot
(
    const std::vector<double>& a,
    const std::vector<double>& b
) const
{
    return returnReduce(krylovBasis::dot(a, b), sumOp<scalar>());
}


void Foam::NewtonKrylov::residual(std::vector<double>& r) const
{
    for (label i = 0; i < nUnknowns_; i++)
    {
        r[i] = gas_.rate[i]/equationScale_[i];
    }
}


bool Foam::NewtonKrylov::move
(
    const std::vector<double>& change,
    const scalar share
)
{
    for (label i = 0; i < nUnknowns_; i++)
    {
        trial_[i] = base_[i] + share*change[i]*unknownScale_[i];
    }
    if (gas_.accept(trial_) != 0)
    {
        gas_.calm();
        return false;
    }
    gas_.correctKeptBoundary();
    gas_.computeRate();
    nProducts_++;
    return true;
}


bool Foam::NewtonKrylov::multiply
(
    const std::vector<double>& v,
    const scalar Co,
    std::vector<double>& Av
)
{
    // A change of 1e-7 of the state in the mean; v has unit length
    const scalar nAll = returnReduce(scalar(nUnknowns_), sumOp<scalar>());
    scalar largest = 0;
    for (label i = 0; i < nUnknowns_; i++)
    {
        largest = max(largest, mag(v[i]));
    }
    reduce(largest, maxOp<scalar>());
    scalar step =
        min(1e-7*std::sqrt(nAll), 1e-4/max(largest, VSMALL));

    // Next to a vacuum even a small change may be too large
    int attempt = 0;
    while (!move(v, step))
    {
        if (++attempt == 4)
        {
            return false;
        }
        step *= 0.1;
    }
    for (label c = 0; c < nCells_; c++)
    {
        const double inertia = ownStep_[c]/Co;
        for (label i = c*nVar_; i < (c + 1)*nVar_; i++)
        {
            Av[i] =
                inertia*v[i]
              - (gas_.rate[i]/equationScale_[i] - baseResidual_[i])/step;
        }
    }
    return true;
}


bool Foam::NewtonKrylov::solve
(
    const scalar Co,
    const scalar tolerance,
    const int mMax,
    std::vector<double>& change
)
{
    const scalar start = std::sqrt(dot(baseResidual_, baseResidual_));
    std::vector<std::vector<double>> H(mMax);
    std::vector<double> g(mMax + 1, 0);
    std::vector<double> cosine(mMax);
    std::vector<double> sine(mMax);
    std::vector<double> w(nUnknowns_);

    const auto sum = [](double* values, const int n)
    {
        if (Pstream::parRun())
        {
            List<scalar> all(UList<scalar>(values, n));
            Pstream::listCombineGather(all, plusEqOp<scalar>());
            Pstream::listCombineScatter(all);
            std::copy(all.begin(), all.end(), values);
        }
    };

    // (vectors of longer solutions are kept for those to come)
    basis_.set(0, baseResidual_, start);
    g[0] = start;

    int m = 0;
    while (m < mMax && mag(g[m]) > tolerance*start)
    {
        basis_.get(m, w);
        precondition(w, work_);

        // The difference is of a vector of unit length
        const scalar scale = std::sqrt(dot(work_, work_));
        for (double& x : work_)
        {
            x /= scale;
        }
        if (!multiply(work_, Co, w))
        {
            break;
        }
        for (double& x : w)
        {
            x *= scale;
        }

        std::vector<double>& h = H[m];
        h.resize(m + 2);
        basis_.remove(m + 1, w, h.data(), sum);
        basis_.set(m + 1, w, max(h[m + 1], VSMALL));

        for (int i = 0; i < m; i++)
        {
            const double t = cosine[i]*h[i] + sine[i]*h[i + 1];
            h[i + 1] = -sine[i]*h[i] + cosine[i]*h[i + 1];
            h[i] = t;
        }
        const double length = std::hypot(h[m], h[m + 1]);
        cosine[m] = h[m]/length;
        sine[m] = h[m + 1]/length;
        h[m] = length;
        g[m + 1] = -sine[m]*g[m];
        g[m] *= cosine[m];
        m++;
    }

    solved_ = mag(g[m]) <= tolerance*start;

    std::vector<double> y(m);
    for (int i = m - 1; i >= 0; i--)
    {
        double sum = g[i];
        for (int j = i + 1; j < m; j++)
        {
            sum -= H[j][i]*y[j];
        }
        y[i] = sum/H[i][i];
    }

    std::fill(change.begin(), change.end(), 0);
    basis_.add(m, 1, y.data(), change);
    precondition(change, work_);
    change = work_;
    return m > 0;
}


Foam::scalar Foam::NewtonKrylov::limit(std::vector<double>& change) const
{
    const int nDim = nVar_ - 2;
    const scalar maxChange = 0.3;
    label nLimited = 0;

    for (label c = 0; c < nCells_; c++)
    {
        const double* w = &base_[c*nVar_];
        const double* q = &basePrimitive_[c*nVar_];
        const double* s = &unknownScale_[c*nVar_];
        double* x = &change[c*nVar_];
        double uu = 0;
        double udm = 0;
        for (int d = 0; d < nDim; d++)
        {
            uu += q[2 + d]*q[2 + d];
            udm += q[2 + d]*x[2 + d]*s[2 + d];
        }
        const double rhoe = w[1] - 0.5*w[0]*uu;
        const double drhoe = x[1]*s[1] - udm + 0.5*uu*x[0]*s[0];
        const double worst = max(mag(x[0]*s[0])/w[0], mag(drhoe)/rhoe);
        if (worst > maxChange)
        {
            for (int k = 0; k < nVar_; k++)
            {
                x[k] *= maxChange/worst;
            }
            nLimited++;
        }
    }
    reduce(nLimited, sumOp<label>());
    return nLimited ? 0.5 : 1;
}


Foam::scalar Foam::NewtonKrylov::step(const scalar Co, const int maxVectors)
{
    // A boundary that lags behind the state would pass for a derivative
    gas_.settleBoundary();
    gas_.computeRate();
    gas_.keepBoundary();
    setScales();
    base_ = gas_.conserved;
    basePrimitive_ = gas_.primitive;
    residual(baseResidual_);

    const scalar nAll = returnReduce(scalar(nUnknowns_), sumOp<scalar>());
    const scalar before = std::sqrt(dot(baseResidual_, baseResidual_)/nAll);
    norm_ = before;
    if (before < VSMALL)
    {
        return 1;
    }

    nVar_ == 4 ? assemble<2>(Co) : assemble<3>(Co);

    // Solved less well, long steps go round in circles before the steady state
    std::vector<double> change(nUnknowns_);
    const bool found = solve(Co, 0.1, maxVectors, change);
    scalar share = limit(change);

    // The way to the steady state may lead uphill, but not far; next to it a
    // shock that finds its place in a cell stirs up as much as this, but
    // eddies that follow each step would not come to rest
    const scalar allowed =
        gas_.turbulent() ? 2*before : max(2*before, scalar(1e-5));
    bool accepted = false;
    scalar part = 1;
    for (int attempt = 0; found && attempt < 3 && !accepted; attempt++)
    {
        if (move(change, part))
        {
            residual(work_);
            norm_ = std::sqrt(dot(work_, work_)/nAll);
            accepted = norm_ < allowed;
        }
        part *= accepted ? 1 : 0.5;
    }
    share *= part;

    if (accepted)
    {
        gas_.conserved = trial_;
    }
    else
    {
        share = 0;
        norm_ = before;
        gas_.primitive = basePrimitive_;
        gas_.restore(base_);
        gas_.correctBoundary();
        gas_.computeRate();
    }
    return share;
}
