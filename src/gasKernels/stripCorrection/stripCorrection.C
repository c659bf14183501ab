/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "stripCorrection.H"
#include <algorithm>

Foam::stripCorrection::stripCorrection(const int nCells, const int nVar)
:
    nVar_(nVar),
    nCells_(nCells),
    // (more take no fewer steps of GMRES)
    nStrips_(std::min(50, nCells)),
    change_(Eigen::VectorXd::Zero(nStrips_*nVar))
{}


void Foam::stripCorrection::set
(
    const std::vector<int>& lower,
    const std::vector<int>& diagonal,
    const std::vector<int>& column,
    const std::vector<float>& block,
    const std::vector<double>& weight
)
{
    const int nn = nVar_*nVar_;
    weight_ = weight;
    start_.assign(1, 0);
    stripOf_.clear();
    block_.clear();
    Eigen::MatrixXd sums =
        Eigen::MatrixXd::Zero(nStrips_*nVar_, nStrips_*nVar_);

    for (int r = 0; r < nCells_; r++)
    {
        const auto take = [&](const int begin, const int end)
        {
            for (int i = begin; i < end; i++)
            {
                const int J = strip(column[i]);
                const size_t e =
                    std::find(stripOf_.begin() + start_[r], stripOf_.end(), J)
                  - stripOf_.begin();
                if (e == stripOf_.size())
                {
                    stripOf_.push_back(J);
                    block_.resize(block_.size() + nn, 0);
                }
                for (int k = 0; k < nn; k++)
                {
                    block_[e*nn + k] += block[i*nn + k];
                }
            }
        };
        take(lower[r], lower[r + 1]);
        take(diagonal[r], diagonal[r + 1]);
        start_.push_back(int(stripOf_.size()));

        for (int e = start_[r]; e < start_[r + 1]; e++)
        {
            for (int k = 0; k < nn; k++)
            {
                const int row = k/nVar_;
                sums(strip(r)*nVar_ + row, stripOf_[e]*nVar_ + k%nVar_) +=
                    weight_[r*nVar_ + row]*block_[e*nn + k];
            }
        }
    }
    if (nStrips_)
    {
        factors_.compute(sums);
    }
}


void Foam::stripCorrection::remove(std::vector<double>& b)
{
    if (!nStrips_)
    {
        return;
    }
    change_.setZero();
    for (int r = 0; r < nCells_; r++)
    {
        double* sum = &change_[strip(r)*nVar_];
        for (int k = 0; k < nVar_; k++)
        {
            sum[k] += weight_[r*nVar_ + k]*b[r*nVar_ + k];
        }
    }
    change_ = factors_.solve(change_).eval();

    for (int r = 0; r < nCells_; r++)
    {
        for (int e = start_[r]; e < start_[r + 1]; e++)
        {
            const float* M = &block_[e*nVar_*nVar_];
            const double* x = &change_[stripOf_[e]*nVar_];
            for (int i = 0; i < nVar_; i++)
            {
                for (int j = 0; j < nVar_; j++)
                {
                    b[r*nVar_ + i] -= M[i*nVar_ + j]*x[j];
                }
            }
        }
    }
}


void Foam::stripCorrection::add(std::vector<double>& x) const
{
    for (int r = 0; r < nCells_; r++)
    {
        for (int k = 0; k < nVar_; k++)
        {
            x[r*nVar_ + k] += change_[strip(r)*nVar_ + k];
        }
    }
}
