/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "chainAlpha.H"
#include "outOfRange.H"

#include <algorithm>


impact::chainAlpha::chainAlpha(double value)
:
    chainAlpha({0}, {value})
{}


impact::chainAlpha::chainAlpha
(
    const std::vector<double>& speeds,
    const std::vector<double>& values
)
:
    speeds_(speeds),
    values_(values)
{
    if (speeds.empty() || speeds.size() != values.size())
    {
        throwInvalid
        (
            "alpha: ", speeds.size(), " speeds and ", values.size(),
            " values, as many of both are needed, and one at least"
        );
    }
    for (std::size_t i = 0; i < speeds.size(); ++i)
    {
        checkRange("speeds of alpha", speeds[i], "[0, 3e8) m/s");
        checkRange("alpha", values[i], "[0, 10]");
        if (i > 0 && !(speeds[i] > speeds[i - 1]))
        {
            throwInvalid
            (
                "speeds of alpha: ", speeds[i], " follows ", speeds[i - 1],
                ", they must increase"
            );
        }
    }
}


double impact::chainAlpha::operator()(double speed) const
{
    if (speed <= speeds_.front())
    {
        return values_.front();
    }
    if (speed >= speeds_.back())
    {
        return values_.back();
    }
    const std::size_t i =
        std::upper_bound(speeds_.begin(), speeds_.end(), speed)
      - speeds_.begin();
    const double share =
        (speed - speeds_[i - 1])/(speeds_[i] - speeds_[i - 1]);
    return (1 - share)*values_[i - 1] + share*values_[i];
}
