/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "scatteringStatistics.H"
#include "outOfRange.H"
#include "scatteringKernels.H"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
    const double degree = 0.017453292519943295;
}


void impact::fixedSum::pack(std::vector<std::int64_t>& data) const
{
    data.push_back(std::int64_t(value_ >> 64));
    data.push_back(std::int64_t(value_));
}


void impact::fixedSum::unpack(const std::int64_t*& data)
{
    const unsigned __int128 high = std::uint64_t(data[0]);
    value_ = __int128((high << 64) | std::uint64_t(data[1]));
    data += 2;
}


impact::scatteringStatistics::scatteringStatistics
(
    double binWidth,
    double reference,
    bool sharedRelief
)
:
    binWidth_(binWidth),
    nAlpha_(0),
    reference_(reference)
{
    const char* const range = "(0.018, 180] deg, a whole part of 180";
    checkRange("binWidth", binWidth, range);
    const double bins = 180/binWidth;
    if (std::fabs(bins - std::round(bins)) > 1e-9*bins)
    {
        throwOutOfRange("binWidth", binWidth, range);
    }
    nAlpha_ = int(std::round(bins));
    counts_.assign(std::size_t(nAlpha_)*nAlpha_ + 1, 0);
    if (sharedRelief)
    {
        blocks_.assign(std::size_t(profileBlocks)*(nAlpha_ + 1), 0);
    }
}


void impact::scatteringStatistics::addDirections
(
    int n,
    const double* Vx,
    const double* Vy,
    const double* Vz,
    const unsigned char* profileBlock
)
{
    const int size = 256;
    int bins[size];
    double a[size], b[size];
    double sums[4] = {};
    for (int from = 0; from < n; from += size)
    {
        const int m = std::min(size, n - from);
        directionAngles
        (
            m, Vx + from, Vy + from, Vz + from, reference_,
            nAlpha_/180., nAlpha_, a, b, bins
        );
        double parts[4];
        sumAndSquares(m, a, parts[0], parts[1]);
        sumAndSquares(m, b, parts[2], parts[3]);
        for (int k = 0; k < 4; ++k)
        {
            sums[k] += parts[k];
        }
        int back = 0;
        for (int i = 0; i < m; ++i)
        {
            back += Vx[from + i] < 0;
        }
        counters_[backward] += back;

        for (int i = 0; i < m; ++i)
        {
            ++counts_[bins[i]];
        }
        const int nBins = nAlpha_*nAlpha_;
        if (profileBlock)
        {
            for (int i = 0; i < m; ++i)
            {
                std::int64_t* block =
                    &blocks_[profileBlock[from + i]*(nAlpha_ + 1)];
                ++block[nAlpha_];
                if (bins[i] < nBins)
                {
                    ++block[bins[i]/nAlpha_];
                }
            }
        }
    }
    counters_[particles] += n;
    sums_[alpha].add(sums[0]);
    sums_[alphaSquared].add(sums[1]);
    sums_[beta].add(sums[2]);
    sums_[betaSquared].add(sums[3]);
}


void impact::scatteringStatistics::add(const scatteringStatistics& s)
{
    for (int i = 0; i < nCounters; ++i)
    {
        counters_[i] += s.counters_[i];
    }
    for (int i = 0; i < nSums; ++i)
    {
        sums_[i].add(s.sums_[i]);
    }
    for (std::size_t i = 0; i < counts_.size(); ++i)
    {
        counts_[i] += s.counts_[i];
    }
    for (std::size_t i = 0; i < blocks_.size(); ++i)
    {
        blocks_[i] += s.blocks_[i];
    }
}


std::vector<std::int64_t> impact::scatteringStatistics::pack() const
{
    std::vector<std::int64_t> data(counters_.begin(), counters_.end());
    for (const fixedSum& s : sums_)
    {
        s.pack(data);
    }
    data.insert(data.end(), counts_.begin(), counts_.end());
    data.insert(data.end(), blocks_.begin(), blocks_.end());
    return data;
}


void impact::scatteringStatistics::unpack
(
    const std::vector<std::int64_t>& data
)
{
    const std::int64_t* p = data.data();
    std::copy_n(p, int(nCounters), counters_.begin());
    p += nCounters;
    for (fixedSum& s : sums_)
    {
        s.unpack(p);
    }
    std::copy_n(p, counts_.size(), counts_.begin());
    p += counts_.size();
    std::copy_n(p, blocks_.size(), blocks_.begin());
}


std::int64_t impact::scatteringStatistics::alphaCount(int i) const
{
    std::int64_t n = 0;
    for (int j = 0; j < nAlpha_; ++j)
    {
        n += count(i, j);
    }
    return n;
}


double impact::scatteringStatistics::F(int i) const
{
    const double N = double(counters_[particles]);
    return N > 0 ? alphaCount(i)/(N*binWidth_*degree) : 0;
}


double impact::scatteringStatistics::standardError(int i) const
{
    const double N = double(counters_[particles]);
    if (!(N > 0))
    {
        return 0;
    }
    const double width = binWidth_*degree;
    const double p = alphaCount(i)/N;
    const double binomial = std::sqrt(p*(1 - p)/N)/width;
    if (blocks_.empty())
    {
        return binomial;
    }

    // Ratio estimator: blocks of the profile get nearly equal numbers
    double squares = 0;
    for (int b = 0; b < profileBlocks; ++b)
    {
        const std::int64_t* block = &blocks_[b*(nAlpha_ + 1)];
        const double d = block[i] - p*block[nAlpha_];
        squares += d*d;
    }
    const double B = profileBlocks;
    return std::max(binomial, std::sqrt(squares*B/(B - 1))/(N*width));
}


double impact::scatteringStatistics::I(int i, int j) const
{
    const double N = double(counters_[particles]);
    const double width = binWidth_*degree;
    return N > 0 ? count(i, j)/(N*width*width) : 0;
}


double impact::scatteringStatistics::mean(sum s) const
{
    const double N = double(counters_[particles]);
    return N > 0 ? sums_[s].value()/N : 0;
}


double impact::scatteringStatistics::meanAlpha() const
{
    return (reference_ + mean(alpha))/degree;
}


double impact::scatteringStatistics::deviationAlpha() const
{
    const double m = mean(alpha);
    return std::sqrt(std::max(0., mean(alphaSquared) - m*m))/degree;
}


double impact::scatteringStatistics::meanBeta() const
{
    return mean(beta)/degree;
}


double impact::scatteringStatistics::deviationBeta() const
{
    const double m = mean(beta);
    return std::sqrt(std::max(0., mean(betaSquared) - m*m))/degree;
}


double impact::scatteringStatistics::modeAlpha() const
{
    int best = 0;
    std::int64_t maxCount = -1;
    std::vector<std::int64_t> n(nAlpha_ + 2, 0);
    for (int i = 0; i < nAlpha_; ++i)
    {
        n[i + 1] = alphaCount(i);
    }
    for (int i = 0; i < nAlpha_; ++i)
    {
        const std::int64_t three = n[i] + n[i + 1] + n[i + 2];

        // A peak one bin wide gives three equal means: the middle one
        if (three > maxCount || (three == maxCount && n[i + 1] > n[best + 1]))
        {
            maxCount = three;
            best = i;
        }
    }
    return alphaCentre(best);
}


double impact::scatteringStatistics::largestError() const
{
    double peak = 0;
    std::vector<double> f(nAlpha_);
    for (int i = 0; i < nAlpha_; ++i)
    {
        f[i] = F(i);
        peak = std::max(peak, f[i]);
    }
    double error = peak > 0 ? 0 : std::numeric_limits<double>::infinity();
    for (int i = 0; i < nAlpha_; ++i)
    {
        if (f[i] > 0.1*peak)
        {
            error = std::max(error, standardError(i)/f[i]);
        }
    }
    return error;
}
