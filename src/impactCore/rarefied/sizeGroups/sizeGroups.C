/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "sizeGroups.H"
#include "outOfRange.H"

#include <boost/math/distributions/normal.hpp>

#include <cmath>

namespace
{
    //- Part of a normal law between two values; the tail that is the smaller
    //  one keeps its digits
    double between(double a, double b)
    {
        const double r = std::sqrt(0.5);
        return
            a > 0 ? 0.5*(std::erfc(r*a) - std::erfc(r*b))
          : 0.5*(std::erfc(-r*b) - std::erfc(-r*a));
    }

    //- Where the part p of a normal law is below
    double quantile(double p)
    {
        return boost::math::quantile(boost::math::normal(), p);
    }
}


std::vector<impact::sizeGroups::group> impact::sizeGroups::list
(
    const std::vector<double>& diameters,
    const std::vector<double>& fractions
)
{
    checkRange("number of diameters", diameters.size(), "[1, inf)");
    checkRange
    (
        fractions.size() == diameters.size(),
        "number of massFractions", double(fractions.size()),
        "that of diameters, " + std::to_string(diameters.size())
    );
    double sum = 0;
    for (std::size_t i = 0; i < diameters.size(); ++i)
    {
        checkRange("diameters", diameters[i], "(0, 1e3) m");
        checkRange("massFractions", fractions[i], "(0, 1e30]");
        sum += fractions[i];
    }

    std::vector<group> groups;
    for (std::size_t i = 0; i < diameters.size(); ++i)
    {
        groups.push_back({diameters[i], fractions[i]/sum});
    }
    return groups;
}


std::vector<impact::sizeGroups::group> impact::sizeGroups::lognormal
(
    double radius,
    double deviation,
    weighting w,
    int classes
)
{
    checkRange("radius", radius, "(0, 1e3) m");
    checkRange("deviation", deviation, "(1, 10]");
    checkRange("classes", classes, "[1, 100]");

    // The law of mass has the same deviation, about a median greater by
    // exp(3 s^2)
    const double s = std::log(deviation);
    const double shift = 3*s;
    const double median =
        w == weighting::number ? std::log(radius)
      : std::log(radius) - 3*s*s;
    const double meanCube = 3*median + 4.5*s*s;

    std::vector<group> groups;
    for (int i = 0; i < classes; ++i)
    {
        const double from = i ? quantile(double(i)/classes) : -40;
        const double to =
            i < classes - 1 ? quantile(double(i + 1)/classes) : 40;
        const double number = between(from + shift, to + shift);
        const double cube = meanCube - std::log(classes*number);
        groups.push_back({2*std::exp(cube/3), 1./classes});
    }
    return groups;
}
