/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "chainAlpha.H"
#include "gridPlace.H"
#include "outOfRange.H"


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
    const gridPlace at(speeds_, speed);
    return (1 - at.share)*values_[at.low] + at.share*values_[at.high];
}
