/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "sweptGrid.H"
#include "outOfRange.H"

#include <cstring>
#include <stdexcept>

namespace
{

//- Bins of the histogram are quarters of a power of two: the exponent of a
//  positive double and two bits of its mantissa
const int binShift = 50;
const int nBins = 1 << 13;


int binOf(double x)
{
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return int(bits >> binShift);
}


double upperEnd(int bin)
{
    const std::uint64_t bits = std::uint64_t(bin + 1) << binShift;
    double x;
    std::memcpy(&x, &bits, sizeof x);
    return x;
}

} // End anonymous namespace


impact::sweptGrid::sweptGrid(const collisionDomain& domain)
:
    domain_(domain),
    period_(domain.period()),
    anyMoved_(false),
    histogram_(nBins),
    roundOff_(0)
{
    for (int k = 0; k < 3; ++k)
    {
        if (!domain.periodic[k])
        {
            continue;
        }
        checkRange("period of the domain", period_[k], "(0, inf) m");
    }
}


void impact::sweptGrid::checkPeriods(const sweptBox& box) const
{
    for (int k = 0; k < 3; ++k)
    {
        if
        (
            domain_.periodic[k]
         && box.high[k] - box.low[k] > 100*period_[k]
        )
        {
            throwOutOfRange
            (
                "path of a particle in one step", box.high[k] - box.low[k],
                "up to 100 periods of ", period_[k], " m"
            );
        }
    }
}


void impact::sweptGrid::makeAxes(level& l, std::int64_t nBoxes) const
{
    std::int64_t product = 1;
    for (int k = 0; k < 3; ++k)
    {
        axis& a = l.axes[k];
        a.periodic = domain_.periodic[k];
        const double length = a.periodic ? period_[k] : span_[k];
        a.n = std::int64_t(std::min(length/l.size, 1e6));
        if (a.periodic)
        {
            a.n = std::max<std::int64_t>(a.n, 1);
        }
        else
        {
            // Two neighbours of a cell must not be the same one
            a.n = a.n + 1 < 3 ? 1 : a.n + 1;
        }
        product *= a.n;
    }
    while (product > 2*nBoxes + 64)
    {
        axis* longest = &l.axes[0];
        for (axis& a : l.axes)
        {
            longest = a.n > longest->n ? &a : longest;
        }
        product /= longest->n;
        longest->n = longest->periodic
          ? std::max<std::int64_t>(3*longest->n/4, 1)
          : longest->n < 6 ? 1 : longest->n/2;
        product *= longest->n;
    }
    for (int k = 0; k < 3; ++k)
    {
        axis& a = l.axes[k];
        a.origin = a.periodic ? domain_.low[k] : origin_[k];
        a.perCell = a.periodic ? a.n/period_[k] : 1/l.size;
    }
}


void impact::sweptGrid::makeLevels()
{
    const std::size_t n = boxes_.size();
    std::fill(histogram_.begin(), histogram_.end(), 0);
    double high[3];
    for (int k = 0; k < 3; ++k)
    {
        origin_[k] = high[k] = n ? boxes_[0].centre(k) : 0;
    }
    largest_ = 0;
    farthest_ = 0;
    for (const sweptBox& box : boxes_)
    {
        const double extent = box.extent();
        if (!std::isfinite(extent))
        {
            throw std::invalid_argument
                ("The path of a particle is not finite");
        }
        ++histogram_[binOf(extent)];
        largest_ = std::max(largest_, extent);
        for (int k = 0; k < 3; ++k)
        {
            const double x = box.centre(k);
            origin_[k] = std::min(origin_[k], x);
            high[k] = std::max(high[k], x);
            farthest_ = std::max
            (
                farthest_,
                std::max(std::fabs(box.low[k]), std::fabs(box.high[k]))
            );
        }
    }
    for (int k = 0; k < 3; ++k)
    {
        span_[k] = high[k] - origin_[k];
        if (domain_.periodic[k])
        {
            farthest_ = std::max
            (
                farthest_,
                std::max(std::fabs(domain_.low[k]), std::fabs(domain_.high[k]))
            );
            if (largest_ > 100*period_[k])
            {
                for (const sweptBox& box : boxes_)
                {
                    checkPeriods(box);
                }
            }
        }
    }

    roundOff_ = float(std::min(1e-15*farthest_ + 1e-37, 1e37));

    // Half of them fit the finest level: slow particles may be crowded where
    // fast ones are not
    std::size_t smaller = 0;
    int bin = 0;
    while (bin < nBins - 1 && 2*(smaller + histogram_[bin]) < n)
    {
        smaller += histogram_[bin++];
    }
    double size = std::max(upperEnd(bin), 1e-12*farthest_ + 1e-280);
    size /= fitting*fitting;

    // Boxes by level, from the histogram: its bins may straddle two levels,
    // and then both are made
    levels_.clear();
    std::size_t next = 0;
    std::int32_t first = 0;
    while (true)
    {
        std::int64_t inLevel = 0;
        const std::size_t last = std::min(binOf(fitting*size), nBins - 1);
        for (std::size_t b = next; b <= last; ++b)
        {
            inLevel += histogram_[b];
        }
        if (inLevel > 0)
        {
            level l;
            l.size = size;
            makeAxes(l, inLevel);
            l.first = first;
            first += l.nCells();
            levels_.push_back(l);
        }
        if (largest_ <= fitting*size)
        {
            break;
        }
        next = last;
        size *= 2;
    }
    // The number of cells varies a little from step to step
    const std::size_t nCells = first + 1;
    if (cellStart_.capacity() < nCells)
    {
        cellStart_.reserve(nCells + nCells/2);
        movedIn_.reserve(nCells + nCells/2);
    }
    cellStart_.assign(nCells, 0);
    movedIn_.assign(nCells, -1);
}


std::int32_t impact::sweptGrid::cell
(
    const level& l,
    const sweptBox& box
) const
{
    std::int64_t c[3];
    for (int k = 0; k < 3; ++k)
    {
        std::int64_t image;
        c[k] = wrap(l.axes[k], own(l.axes[k], box.centre(k)), image);
    }
    return std::int32_t
        (l.first + (c[2]*l.axes[1].n + c[1])*l.axes[0].n + c[0]);
}


void impact::sweptGrid::build()
{
    makeLevels();
    const std::int32_t n = std::int32_t(boxes_.size());
    where_.resize(n);
    slots_.resize(n);
    coarse_.resize(n);
    nextMoved_.resize(n);
    anyMoved_ = false;

    for (std::int32_t i = 0; i < n; ++i)
    {
        const level* l = levelFor(boxes_[i].extent());
        where_[i] = cell(*l, boxes_[i]);
        ++cellStart_[where_[i] + 1];
    }
    for (std::size_t c = 1; c < cellStart_.size(); ++c)
    {
        cellStart_[c] += cellStart_[c - 1];
    }

    // Filling moves the starts to the next cells' starts: shift them back
    for (std::int32_t i = 0; i < n; ++i)
    {
        const std::int32_t s = cellStart_[where_[i]]++;
        slots_[s] = i;
        coarse_[s] = coarse(boxes_[i]);
        where_[i] = s;
    }
    for (std::size_t c = cellStart_.size() - 1; c > 0; --c)
    {
        cellStart_[c] = cellStart_[c - 1];
    }
    cellStart_[0] = 0;
}


void impact::sweptGrid::laterRuns
(
    const level& l,
    std::int64_t x,
    std::int64_t y,
    std::int64_t z
) const
{
    runs_.clear();
    const auto take = [&](const run& r)
    {
        if (r.begin < r.end)
        {
            runs_.push_back(r);
        }
    };
    const range rx = around(l, 0, x);
    const range ry = around(l, 1, y);
    const range rz = around(l, 2, z);
    rows(l, {x + 1, rx.to}, {y, y}, {z, z}, take);
    rows(l, rx, {y + 1, ry.to}, {z, z}, take);
    rows(l, rx, ry, {z + 1, rz.to}, take);
}


void impact::sweptGrid::remove(std::int32_t i)
{
    const std::int32_t at = where_[i];
    if (at >= 0)
    {
        slots_[at] = ~i;
    }
    else if (at < -1)
    {
        std::int32_t* link = &movedIn_[movedTo(at)];
        while (*link != i)
        {
            link = &nextMoved_[*link];
        }
        *link = nextMoved_[i];
    }
    where_[i] = -1;
}


void impact::sweptGrid::move(std::int32_t i, const sweptBox& box)
{
    remove(i);
    const double extent = box.extent();
    if (!std::isfinite(extent))
    {
        throw std::invalid_argument("The path of a particle is not finite");
    }
    checkPeriods(box);
    boxes_[i] = box;
    const level* l = levelFor(extent);
    const std::int32_t c =
        l ? cell(*l, box) : std::int32_t(movedIn_.size()) - 1;
    where_[i] = movedTo(c);
    nextMoved_[i] = movedIn_[c];
    movedIn_[c] = i;
    anyMoved_ = true;
}


void impact::sweptGrid::add(const sweptBox& box)
{
    boxes_.push_back(box);
    where_.push_back(-1);
    nextMoved_.push_back(-1);
    move(std::int32_t(boxes_.size()) - 1, box);
}
