/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "undisturbedStream.H"
#include "counterRandom.H"
#include "outOfRange.H"

#include <cmath>

double impact::undisturbedStream::vanDerCorput
(
    std::uint64_t k,
    int base,
    double shift
)
{
    double x = shift;
    double place = 1;
    for (; k; k /= base)
    {
        place /= base;
        x += place*double(k % base);
    }
    x -= std::floor(x);

    // In the open interval
    return std::fmin(std::fmax(x, 0x1p-53), 1 - 0x1p-53);
}


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
    checkRange("volumeFraction", volumeFraction, "(0, 0.1)");
    if (sizes.empty())
    {
        throwOutOfRange("sizes", "()", "at least one (diameter fraction)");
    }

    double sum = 0;
    for (const sizeClass& size : sizes_)
    {
        checkRange("diameter", size.d, "(0, inf)");
        checkRange("fraction of sizes", size.fraction, "(0, 1]");
        checkRange("nParticle", size.weight, "(0, inf)");
        sum += size.fraction;
    }
    checkRange("sum of the fractions of sizes", sum, "[0.999999, 1.000001]");

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


int impact::undisturbedStream::classAt(double x) const
{
    int j = 0;
    while (x >= share_[j])
    {
        ++j;
    }
    return j;
}


int impact::undisturbedStream::sizeOf(std::uint64_t k) const
{
    // k times the golden ratio modulo 1, in integers so that it stays exact
    return classAt(double(((k + 1)*0x9E3779B97F4A7C15ull) >> 11)*0x1p-53);
}


int impact::undisturbedStream::quietSizeOf
(
    std::uint64_t k,
    std::uint32_t sequence
) const
{
    // A number that no parcel has, and not that of quietOf
    counterRandom random(seed_, ~std::uint64_t(1), sequence);
    return classAt(vanDerCorput(k, 7, random.uniform()));
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


impact::undisturbedStream::draw impact::undisturbedStream::quietOf
(
    std::uint64_t k,
    std::uint32_t sequence
) const
{
    // The stream of random numbers that no parcel has
    counterRandom random(seed_, ~std::uint64_t(0), sequence);
    draw result;
    result.entry = random.uniform();
    std::uint64_t mask = std::uint64_t(random.bits()) << 32;
    mask |= random.bits();

    // In base 2 the bits of the number itself, turned round. A shift of the
    // bits instead of the sum keeps every dyadic interval as full as it was.
    std::uint64_t bits = 0;
    for (int i = 0; i < 64; ++i)
    {
        bits |= ((k >> i) & 1) << (63 - i);
    }
    result.a = (double((bits ^ mask) >> 12) + 0.5)*0x1p-52;
    result.b = vanDerCorput(k, 3, random.uniform());
    result.c = vanDerCorput(k, 5, random.uniform());
    return result;
}
