/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "blockStatistics.H"
#include "outOfRange.H"

#include <boost/math/distributions/chi_squared.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace impact
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Function>
void blockStatistics::overBlocks(std::size_t item, Function f) const
{
    for (std::size_t b = 0; b < nBlocks(); ++b)
    {
        f(block(b, item), times_[b]);
    }
    if (openTime_ > 0)
    {
        f(&settled_[item*nQuantities_], openTime_);
    }
}


blockStatistics::estimate blockStatistics::errorOf
(
    std::size_t item,
    std::size_t quantity,
    double ratio,
    double denominator,
    const std::size_t* reference
) const
{
    if (!errorsKnown())
    {
        return {ratio, -1};
    }

    double squares = 0;
    double n = 0;
    overBlocks
    (
        item,
        [&](const double* sums, double time)
        {
            const double y = reference ? sums[*reference] : time;
            const double rest = sums[quantity] - ratio*y;
            squares += rest*rest;
            n += y != 0;
        }
    );
    if (n < 2)
    {
        // All of it in one block: no scatter to see
        return {ratio, -1};
    }
    return {ratio, std::sqrt(n/(n - 1)*squares)/denominator, n};
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

blockStatistics::blockStatistics
(
    std::size_t nItems,
    std::size_t nQuantities,
    std::size_t minBlocks
)
:
    nItems_(nItems),
    nQuantities_(nQuantities),
    minBlocks_(minBlocks),
    length_(0),
    openTime_(0),
    open_(nItems*nQuantities, 0.0),
    settled_(nItems*nQuantities, 0.0)
{
    if (nQuantities == 0)
    {
        throw std::invalid_argument("blockStatistics: no quantities");
    }
    if (minBlocks < 10)
    {
        throwOutOfRange("blocks", minBlocks, "[10, inf)");
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool blockStatistics::advance(double dt)
{
    if (length_ == 0)
    {
        length_ = dt;
    }
    openTime_ += dt;

    // Steps that add up to the length but for round-off fill the block
    return openTime_ > length_*(1 - 1e-9);
}


void blockStatistics::settle()
{
    for (std::size_t i = 0; i < open_.size(); ++i)
    {
        settled_[i] += open_[i];
        open_[i] = 0;
    }
}


void blockStatistics::close()
{
    settle();
    blocks_.insert(blocks_.end(), settled_.begin(), settled_.end());
    times_.push_back(openTime_);
    std::fill(settled_.begin(), settled_.end(), 0.0);
    openTime_ = 0;

    if (times_.size() < 2*minBlocks_)
    {
        return;
    }

    const std::size_t width = nItems_*nQuantities_;
    for (std::size_t b = 0; b < minBlocks_; ++b)
    {
        times_[b] = times_[2*b] + times_[2*b + 1];
        for (std::size_t i = 0; i < width; ++i)
        {
            blocks_[b*width + i] =
                blocks_[2*b*width + i] + blocks_[(2*b + 1)*width + i];
        }
    }
    times_.resize(minBlocks_);
    blocks_.resize(minBlocks_*width);
    length_ = std::max(2*length_, (time() - openTime_)/minBlocks_);
}


double blockStatistics::errorBound(double nBlocks)
{
    const double free = nBlocks - 1;
    const boost::math::chi_squared_distribution<double> squares(free);
    return std::sqrt(free/quantile(squares, 0.1));
}


double blockStatistics::time() const
{
    double sum = openTime_;
    for (const double t : times_)
    {
        sum += t;
    }
    return sum;
}


double blockStatistics::sum(std::size_t item, std::size_t quantity) const
{
    double sum = settled_[item*nQuantities_ + quantity];
    for (std::size_t b = 0; b < nBlocks(); ++b)
    {
        sum += block(b, item)[quantity];
    }
    return sum;
}


blockStatistics::estimate blockStatistics::rate
(
    std::size_t item,
    std::size_t quantity
) const
{
    const double total = time();
    if (!(total > 0))
    {
        return {0, -1};
    }
    return errorOf(item, quantity, sum(item, quantity)/total, total, nullptr);
}


blockStatistics::estimate blockStatistics::ratio
(
    std::size_t item,
    std::size_t quantity,
    std::size_t reference
) const
{
    const double total = sum(item, reference);
    if (total == 0)
    {
        return {0, -1};
    }
    return
        errorOf(item, quantity, sum(item, quantity)/total, total, &reference);
}


std::vector<double> blockStatistics::times() const
{
    std::vector<double> all{length_, openTime_};
    all.insert(all.end(), times_.begin(), times_.end());
    return all;
}


std::vector<double> blockStatistics::state(std::size_t item) const
{
    const double* first = &settled_[item*nQuantities_];
    std::vector<double> all(first, first + nQuantities_);
    for (std::size_t b = 0; b < nBlocks(); ++b)
    {
        all.insert(all.end(), block(b, item), block(b, item) + nQuantities_);
    }
    return all;
}


void blockStatistics::setTimes(const std::vector<double>& times)
{
    if (times.size() < 2 || times.size() - 2 >= 2*minBlocks_)
    {
        throwOutOfRange
        (
            "number of saved blocks", times.size() < 2 ? 0 : times.size() - 2,
            "[0, ", 2*minBlocks_, "), below twice the least number"
        );
    }
    length_ = times[0];
    openTime_ = times[1];
    times_.assign(times.begin() + 2, times.end());
    blocks_.assign(times_.size()*nItems_*nQuantities_, 0.0);
    std::fill(settled_.begin(), settled_.end(), 0.0);
    std::fill(open_.begin(), open_.end(), 0.0);
}


void blockStatistics::setState
(
    std::size_t item,
    const double* sums,
    std::size_t n
)
{
    if (item >= nItems_ || n != (nBlocks() + 1)*nQuantities_)
    {
        throw std::invalid_argument
        (
            "blockStatistics: " + std::to_string(n)
          + " saved sums for item " + std::to_string(item) + " where "
          + std::to_string((nBlocks() + 1)*nQuantities_) + " for an item below "
          + std::to_string(nItems_) + " are valid"
        );
    }
    std::copy_n(sums, nQuantities_, &settled_[item*nQuantities_]);
    for (std::size_t b = 0; b < nBlocks(); ++b)
    {
        std::copy_n
        (
            sums + (b + 1)*nQuantities_,
            nQuantities_,
            &blocks_[(b*nItems_ + item)*nQuantities_]
        );
    }
}

} // End namespace impact
