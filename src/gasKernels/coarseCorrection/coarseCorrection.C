/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "coarseCorrection.H"
#include <algorithm>
#include <cmath>
#include <map>

namespace
{

//- Strength of a link of two groups
struct link
{
    int a, b;
    double strength;
};


//- Join groups in pairs, each with the one that it is linked to most of those
//  left. Returns their number, and the pair of each group.
int pairs
(
    const int nGroups,
    const std::vector<link>& links,
    std::vector<int>& pairOf
)
{
    std::vector<std::map<int, double>> neighbours(nGroups);
    for (const link& l : links)
    {
        neighbours[l.a][l.b] += l.strength;
        neighbours[l.b][l.a] += l.strength;
    }
    pairOf.assign(nGroups, -1);
    int nPairs = 0;
    for (int g = 0; g < nGroups; g++)
    {
        if (pairOf[g] >= 0)
        {
            continue;
        }
        int partner = g;
        double most = 0;
        for (const auto& neighbour : neighbours[g])
        {
            if (pairOf[neighbour.first] < 0 && neighbour.second > most)
            {
                partner = neighbour.first;
                most = neighbour.second;
            }
        }
        pairOf[g] = pairOf[partner] = nPairs++;
    }
    return nPairs;
}

} // End anonymous namespace


Foam::coarseCorrection::coarseCorrection(const int nCells, const int nVar)
:
    nVar_(nVar),
    nCells_(nCells),
    nGroups_(0),
    solvable_(false)
{}


void Foam::coarseCorrection::set
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

    const auto eachBlock = [&](const int r, const auto& take)
    {
        for (const std::vector<int>* start : {&lower, &diagonal})
        {
            for (int i = (*start)[r]; i < (*start)[r + 1]; i++)
            {
                take(i);
            }
        }
    };

    if (nGroups_ == 0)
    {
        std::vector<link> links;
        group_.resize(nCells_);
        for (int r = 0; r < nCells_; r++)
        {
            group_[r] = r;
            eachBlock(r, [&](const int i)
            {
                double strength = 0;
                for (int k = 0; k < nn && column[i] != r; k++)
                {
                    strength += std::fabs(block[i*nn + k]);
                }
                links.push_back({r, column[i], strength});
            });
        }
        nGroups_ = nCells_;
        while (nGroups_ > maxGroups)
        {
            std::vector<int> pairOf;
            const int n = pairs(nGroups_, links, pairOf);
            if (n == nGroups_)
            {
                break;      // nothing is linked
            }
            nGroups_ = n;
            for (int& g : group_)
            {
                g = pairOf[g];
            }
            for (link& l : links)
            {
                l.a = pairOf[l.a];
                l.b = pairOf[l.b];
            }
            links.erase
            (
                std::remove_if
                (
                    links.begin(), links.end(),
                    [](const link& l) { return l.a == l.b; }
                ),
                links.end()
            );
        }
    }

    start_.assign(1, 0);
    groupOf_.clear();
    block_.clear();
    std::vector<Eigen::Triplet<double>> sums;
    for (int r = 0; r < nCells_; r++)
    {
        eachBlock(r, [&](const int i)
        {
            const int G = group_[column[i]];
            const size_t e =
                std::find(groupOf_.begin() + start_[r], groupOf_.end(), G)
              - groupOf_.begin();
            if (e == groupOf_.size())
            {
                groupOf_.push_back(G);
                block_.resize(block_.size() + nn, 0);
            }
            for (int k = 0; k < nn; k++)
            {
                block_[e*nn + k] += block[i*nn + k];
            }
        });
        start_.push_back(int(groupOf_.size()));

        for (int e = start_[r]; e < start_[r + 1]; e++)
        {
            for (int k = 0; k < nn; k++)
            {
                const int row = k/nVar_;
                sums.emplace_back
                (
                    group_[r]*nVar_ + row,
                    groupOf_[e]*nVar_ + k%nVar_,
                    weight_[r*nVar_ + row]*block_[e*nn + k]
                );
            }
        }
    }

    Eigen::SparseMatrix<double> equations(nGroups_*nVar_, nGroups_*nVar_);
    equations.setFromTriplets(sums.begin(), sums.end());
    solvable_ = nGroups_ > 0;
    if (solvable_)
    {
        factors_.compute(equations);
        solvable_ = factors_.info() == Eigen::Success;
    }
    change_ = Eigen::VectorXd::Zero(nGroups_*nVar_);
}


void Foam::coarseCorrection::remove(std::vector<double>& b)
{
    if (!solvable_)
    {
        return;
    }
    change_.setZero();
    for (int r = 0; r < nCells_; r++)
    {
        double* sum = &change_[group_[r]*nVar_];
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
            const double* x = &change_[groupOf_[e]*nVar_];
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


void Foam::coarseCorrection::add(std::vector<double>& x) const
{
    for (int r = 0; r < nCells_ && solvable_; r++)
    {
        for (int k = 0; k < nVar_; k++)
        {
            x[r*nVar_ + k] += change_[group_[r]*nVar_ + k];
        }
    }
}
