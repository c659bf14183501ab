/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "plumeStatistics.H"
#include "elementary.H"
#include "outOfRange.H"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace
{

//- Sum of squared deviations from the mean, an exact integer before its
//  conversion, to the scale of the temperature
double deviations(const impact::cellSum& s, double scale)
{
    // n T2 - T T may need more than 128 bits: the mean is taken out first
    const std::int64_t mean = s.T/s.n;
    const __int128 rest = __int128(s.T) - __int128(mean)*s.n;
    const __int128 about =
        s.T2 - __int128(mean)*mean*s.n - 2*__int128(mean)*rest;
    return
        (double(about) - double(rest)*double(rest)/double(s.n))/scale/scale;
}


impact::plumeStatistics::estimate mean(const impact::cellSum& s, double scale)
{
    if (s.n == 0)
    {
        return {0, 0, 0};
    }
    const double n = double(s.n);
    const double error =
        s.n > 1
      ? std::sqrt(std::max(0., deviations(s, scale))/(n*(n - 1))) : 0;
    return {double(s.T)/n/scale, error, s.n};
}

} // End anonymous namespace


void impact::logHistogram::add(const logHistogram& h)
{
    zero_ += h.zero_;
    for (int o = 0; o < 2*nOctaves; ++o)
    {
        for (std::size_t i = 0; i < h.octaves_[o].size(); ++i)
        {
            at(o, std::int64_t(i)) += h.octaves_[o][i];
        }
    }
}


std::int64_t impact::logHistogram::total() const
{
    std::int64_t n = zero_;
    for (const auto& counts : octaves_)
    {
        for (const std::int64_t c : counts)
        {
            n += c;
        }
    }
    return n;
}


double impact::logHistogram::quantile(double p) const
{
    const double wanted = p*double(total());
    double below = 0, result = 0;

    // The bin from a to b, in the order of the numbers: is it the one?
    auto found = [&](std::int64_t count, double a, double b)
    {
        const double c = double(count);
        if (count == 0 || below + c < wanted)
        {
            below += c;
            return false;
        }
        result = a + std::max(0., (wanted - below)/c)*(b - a);
        return true;
    };
    auto end = [](int octave, std::size_t i)
    {
        return std::ldexp(1 + double(i)/perOctave, lowest + octave);
    };
    for (int o = nOctaves; o-- > 0;)
    {
        const auto& counts = octaves_[nOctaves + o];
        for (std::size_t i = counts.size(); i-- > 0;)
        {
            if (found(counts[i], -end(o, i + 1), -end(o, i)))
            {
                return result;
            }
        }
    }
    if (found(zero_, 0, 0))
    {
        return 0;
    }
    for (int o = 0; o < nOctaves; ++o)
    {
        const auto& counts = octaves_[o];
        for (std::size_t i = 0; i < counts.size(); ++i)
        {
            if (found(counts[i], end(o, i), end(o, i + 1)))
            {
                return result;
            }
        }
    }
    return 0;
}


void impact::logHistogram::pack(std::vector<std::int64_t>& data) const
{
    data.push_back(zero_);
    for (const auto& counts : octaves_)
    {
        data.push_back(std::int64_t(counts.size()));
        data.insert(data.end(), counts.begin(), counts.end());
    }
}


void impact::logHistogram::unpack(const std::int64_t*& data)
{
    zero_ = *data++;
    for (auto& counts : octaves_)
    {
        const std::int64_t n = *data++;
        counts.assign(data, data + n);
        data += n;
    }
}


impact::plumeStatistics::plumeStatistics(const setup& s)
:
    setup_(s)
{
    checkRange("stationHalfWidth", s.stationHalfWidth, "(0, 1e15) m");
    for (const double x : s.stations)
    {
        checkRange("stations", x, "(-1e15, 1e15) m");
    }
    const int room =
        62 - int(std::ceil(std::log2(s.nParticles + 1)))
      - int(std::ceil(std::log2(s.hottest + 1)));
    const int quick = 49 - int(std::ceil(std::log2(s.hottest + 1)));
    const int bits = std::min({24, room, quick});
    if (bits < 0)
    {
        throw std::invalid_argument
        (
            "nParticles: too many for their temperature"
        );
    }
    scale_ = std::ldexp(1., bits);

    groups_.resize(s.emitted.size());
    for (groupSum& g : groups_)
    {
        g.radius.resize(s.stations.size());
    }
    std::size_t size = 0;
    for (const plumeGrid& g : s.grids)
    {
        offsets_.push_back(size);
        size += std::size_t(g.nCells())*s.emitted.size();
    }
    cells_.resize(size);
}


void impact::plumeStatistics::add
(
    int group,
    int n,
    const double* x,
    const double* y,
    const double* z,
    const double* T
)
{
    groupSum& g = groups_[group];
    std::int64_t q[plumeGrid::batch];
    cellSum all;
    for (int i = 0; i < n; ++i)
    {
        std::int64_t k;
        nearest(T[i]*scale_, k);
        q[i] = k - 0x4338000000000000ll;
    }
    for (int i = 0; i < n; ++i)
    {
        all.add(q[i]);
        g.x.add(x[i]);
    }
    g.all.add(all);

    for (std::size_t s = 0; s < setup_.stations.size(); ++s)
    {
        const double X = setup_.stations[s];
        for (int i = 0; i < n; ++i)
        {
            if (std::fabs(x[i] - X) < setup_.stationHalfWidth)
            {
                g.radius[s].add(std::sqrt(y[i]*y[i] + z[i]*z[i]));
            }
        }
    }

    int cell[plumeGrid::batch];
    for (std::size_t grid = 0; grid < setup_.grids.size(); ++grid)
    {
        const plumeGrid& shape = setup_.grids[grid];
        shape.locate(n, x, y, z, cell);
        cellSum* sums =
            cells_.data() + offsets_[grid]
          + std::size_t(group)*shape.nCells();
        for (int i = 0; i < n; ++i)
        {
            if (cell[i] >= 0)
            {
                sums[cell[i]].add(q[i]);
            }
        }
    }
}


void impact::plumeStatistics::add(const plumeStatistics& s)
{
    for (std::size_t g = 0; g < groups_.size(); ++g)
    {
        groups_[g].all.add(s.groups_[g].all);
        groups_[g].x.add(s.groups_[g].x);
        for (std::size_t i = 0; i < groups_[g].radius.size(); ++i)
        {
            groups_[g].radius[i].add(s.groups_[g].radius[i]);
        }
    }
    for (std::size_t i = 0; i < cells_.size(); ++i)
    {
        cells_[i].add(s.cells_[i]);
    }
}


std::vector<std::int64_t> impact::plumeStatistics::pack() const
{
    std::vector<std::int64_t> data;
    auto put = [&](const cellSum& s)
    {
        data.push_back(s.n);
        data.push_back(s.T);
        data.push_back(std::int64_t(s.T2 >> 64));
        data.push_back(std::int64_t(s.T2));
    };
    for (const groupSum& g : groups_)
    {
        put(g.all);
        g.x.pack(data);
        for (const logHistogram& h : g.radius)
        {
            h.pack(data);
        }
    }
    for (const cellSum& s : cells_)
    {
        put(s);
    }
    return data;
}


void impact::plumeStatistics::unpack(const std::vector<std::int64_t>& data)
{
    const std::int64_t* p = data.data();
    auto get = [&](cellSum& s)
    {
        s.n = p[0];
        s.T = p[1];
        const unsigned __int128 high = std::uint64_t(p[2]);
        s.T2 = __int128((high << 64) | std::uint64_t(p[3]));
        p += 4;
    };
    for (groupSum& g : groups_)
    {
        get(g.all);
        g.x.unpack(p);
        for (logHistogram& h : g.radius)
        {
            h.unpack(p);
        }
    }
    for (cellSum& s : cells_)
    {
        get(s);
    }
}


std::int64_t impact::plumeStatistics::sampled() const
{
    std::int64_t n = 0;
    for (const groupSum& g : groups_)
    {
        n += g.all.n;
    }
    return n;
}


std::int64_t impact::plumeStatistics::inside(int grid, int group) const
{
    std::int64_t n = 0;
    for (int i = 0; i < setup_.grids[grid].nCells(); ++i)
    {
        n += count(grid, group, i);
    }
    return n;
}


double impact::plumeStatistics::weight(int group) const
{
    const std::int64_t n = sampled(group);
    return n > 0 ? setup_.emitted[group]/double(n) : 0;
}


impact::plumeStatistics::estimate impact::plumeStatistics::numberDensity
(
    int grid,
    int group,
    int cell
) const
{
    const plumeGrid& g = setup_.grids[grid];
    const int i = cell % g.n(0);
    const int j = cell/g.n(0) % g.n(1);
    const int k = cell/g.n(0)/g.n(1);
    const int first = group < 0 ? 0 : group;
    const int last = group < 0 ? nGroups() : group + 1;
    double number = 0, variance = 0;
    std::int64_t n = 0;
    for (int m = first; m < last; ++m)
    {
        const double c = double(count(grid, m, cell));
        const double w = weight(m);
        if (c > 0)
        {
            n += count(grid, m, cell);
            number += w*c;
            variance += w*w*c*(1 - c/double(sampled(m)));
        }
    }
    const double V = g.volume(i, j, k);
    return {number/V, std::sqrt(variance)/V, n};
}


impact::plumeStatistics::estimate impact::plumeStatistics::temperature
(
    int grid,
    int group,
    int cell
) const
{
    if (group >= 0)
    {
        return mean(cells(grid, group)[cell], scale_);
    }
    double number = 0, sum = 0;
    std::int64_t n = 0;
    for (int m = 0; m < nGroups(); ++m)
    {
        const estimate e = mean(cells(grid, m)[cell], scale_);
        const double w = weight(m)*double(e.n);
        number += w;
        sum += w*e.value;
        n += e.n;
    }
    if (n == 0 || !(number > 0))
    {
        return {0, 0, 0};
    }

    // Error of a ratio of two sums over the sampled particles
    const double T = sum/number;
    double variance = 0;
    for (int m = 0; m < nGroups(); ++m)
    {
        const cellSum& s = cells(grid, m)[cell];
        if (s.n > 0)
        {
            const double d = double(s.T)/double(s.n)/scale_ - T;
            const double w = weight(m);
            variance +=
                w*w*(std::max(0., deviations(s, scale_)) + double(s.n)*d*d);
        }
    }
    return {T, std::sqrt(variance)/number, n};
}


impact::plumeStatistics::estimate impact::plumeStatistics::temperature
(
    int group
) const
{
    return mean(groups_[group].all, scale_);
}


impact::plumeStatistics::estimate impact::plumeStatistics::radius
(
    int group,
    int station,
    double p
) const
{
    const logHistogram& h = groups_[group].radius[station];
    const std::int64_t n = h.total();
    if (n == 0)
    {
        return {0, 0, 0};
    }

    // One deviation of the number of particles beyond
    const double d = std::sqrt(p*(1 - p)/double(n));
    const double error =
        0.5*(h.quantile(std::min(1., p + d)) - h.quantile(std::max(0., p - d)));
    return {h.quantile(p), error, n};
}


double impact::plumeStatistics::largestError() const
{
    // Below zero without any cell; where all fall into one it is none
    double worst = -1;
    for (std::size_t grid = 0; grid < setup_.grids.size(); ++grid)
    {
        const int nCells = setup_.grids[grid].nCells();
        for (int group = 0; group < nGroups(); ++group)
        {
            const cellSum* sums = cells(int(grid), group);
            std::int64_t maxCount = 0;
            for (int i = 0; i < nCells; ++i)
            {
                maxCount = std::max(maxCount, sums[i].n);
            }
            const double N = double(sampled(group));
            for (int i = 0; i < nCells; ++i)
            {
                const double n = double(sums[i].n);
                if (maxCount > 0 && n >= 0.1*double(maxCount))
                {
                    worst = std::max(worst, std::sqrt((1 - n/N)/n));
                }
            }
        }
    }
    return worst >= 0 ? worst : std::numeric_limits<double>::infinity();
}
