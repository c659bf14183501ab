/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Numbers must be written as ever, whatever their size, the precision and the
    format of the stream.
\*---------------------------------------------------------------------------*/

#include "fastNumberOutput.H"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <sstream>
#include <vector>

namespace
{

std::vector<double> numbers()
{
    typedef std::numeric_limits<double> limits;
    std::vector<double> x
    {
        0, -0.0, 1, -1, 0.5, 1e5, 999999.5, 1e6, 123456789, 1e-4, 9.9999995e-5,
        1e-5, 1e22, 1e23, limits::max(), limits::min(), limits::denorm_min(),
        limits::infinity(), -limits::infinity(), limits::quiet_NaN(),
        -limits::quiet_NaN()
    };
    std::mt19937_64 generator(1);
    std::uniform_real_distribution<double> mantissa(-1, 1), power(-300, 300);
    for (int i = 0; i < 20000; ++i)
    {
        x.push_back(mantissa(generator)*std::pow(10, power(generator)));
        x.push_back(std::round(1e4*mantissa(generator))/64);
    }
    return x;
}


// \param format  applied to the stream before each number
template<class Format>
std::string text(const std::vector<double>& x, const Format& format)
{
    std::ostringstream stream;
    for (const double value : x)
    {
        format(stream);
        stream << value << '\n';
    }
    return stream.str();
}


template<class Format>
void compare(const std::vector<double>& x, const Format& format)
{
    const std::string plain(text(x, format));
    std::string fast;
    {
        const Foam::fastNumberOutput now;
        EXPECT_TRUE(std::locale() != std::locale::classic());
        fast = text(x, format);
    }
    EXPECT_TRUE(std::locale() == std::locale::classic());
    EXPECT_EQ(fast.substr(0, 60), plain.substr(0, 60));
    EXPECT_TRUE(fast == plain);
}

} // End namespace


TEST(fastNumberOutput, precisions)
{
    const std::vector<double> x(numbers());
    for (int precision = 0; precision <= 45; ++precision)
    {
        compare(x, [&](std::ostream& s) { s.precision(precision); });
    }
}


TEST(fastNumberOutput, formats)
{
    const std::vector<double> x(numbers());
    compare(x, [](std::ostream& s) { s << std::scientific; });
    compare(x, [](std::ostream& s) { s << std::hexfloat; });
    compare(x, [](std::ostream& s) { s << std::showpoint; });
    compare(x, [](std::ostream& s) { s << std::showpos; });
    compare(x, [](std::ostream& s) { s << std::uppercase; });
    compare(x, [](std::ostream& s) { s.fill('*'); s.width(14); });
    compare
    (
        {1.5, -2.25, 1e10},
        [](std::ostream& s) { s << std::fixed; s.precision(3); }
    );
}
