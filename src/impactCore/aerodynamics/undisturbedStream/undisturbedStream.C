/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "undisturbedStream.H"
#include "counterRandom.H"
#include "outOfRange.H"

#include <cmath>

impact::undisturbedStream::undisturbedStream
(
    double volumeFraction,
    const std::vector<sizeClass>& sizes,
    std::uint64_t seed
)
:
    sizes_(sizes),
    parcelDensity_(0),
    seed_(seed)
{
    checkRange
    (
        volumeFraction > 0 && volumeFraction < 0.1,
        "volumeFraction",
        volumeFraction,
        "(0, 0.1)"
    );
    if (sizes.empty())
    {
        throwOutOfRange("sizes", "()", "at least one (diameter fraction)");
    }

    double sum = 0;
    for (const sizeClass& size : sizes_)
    {
        checkRange(size.d > 0, "diameter", size.d, "(0, inf)");
        checkRange
        (
            size.fraction > 0 && size.fraction <= 1,
            "fraction of sizes",
            size.fraction,
            "(0, 1]"
        );
        checkRange(size.weight > 0, "nParticle", size.weight, "(0, inf)");
        sum += size.fraction;
    }
    checkRange
    (
        std::fabs(sum - 1) < 1e-6,
        "sum of the fractions of sizes",
        sum,
        "1 +- 1e-6"
    );

    for (const sizeClass& size : sizes_)
    {
        numberDensity_.push_back
        (
            6*size.fraction/sum*volumeFraction/(M_PI*std::pow(size.d, 3))
        );
        parcelDensity_ += numberDensity_.back()/size.weight;
        share_.push_back(parcelDensity_);
    }
    for (double& s : share_)
    {
        s /= parcelDensity_;
    }
    share_.back() = 1;
}


int impact::undisturbedStream::sizeOf(std::uint64_t k) const
{
    // k times the golden ratio modulo 1, in integers so that it stays exact
    const double x =
        double(((k + 1)*0x9E3779B97F4A7C15ull) >> 11)*0x1p-53;

    int j = 0;
    while (x >= share_[j])
    {
        ++j;
    }
    return j;
}


impact::undisturbedStream::draw impact::undisturbedStream::drawOf
(
    std::uint64_t k,
    std::uint32_t sequence
) const
{
    counterRandom random(seed_, k, sequence);
    draw result;
    result.entry = random.uniform();
    result.a = random.uniform();
    result.b = random.uniform();
    result.c = random.uniform();
    return result;
}
