/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "plumeSource.H"
#include "outOfRange.H"

#include <algorithm>
#include <cmath>
#include <stdexcept>

impact::plumeSource impact::plumeSource::analytic
(
    double exitRadius,
    const std::vector<beam>& beams
)
{
    checkRange("exitRadius", exitRadius, "[0, 1e6) m");
    checkRange("number of groups", beams.size(), "[1, 64]");
    plumeSource s;
    s.exitRadius_ = exitRadius;
    s.beams_ = beams;
    for (const beam& b : beams)
    {
        checkRange("diameter", b.diameter, "(0, 1e3) m");
        checkRange("flux", b.flux, "(0, 1e30) 1/s");
        checkRange("speed", b.speed, "(0, 3e8) m/s");
        checkRange
        (
            b.speedDeviation >= 0 && b.speedDeviation < b.speed/3,
            "speedDeviation", b.speedDeviation, "[0, speed/3) m/s"
        );
        const bool cone = b.distribution == angleLaw::cone;
        checkRange
        (
            "spread", b.spread, cone ? "[0, 180] deg" : "(1e-6, 180] deg"
        );
        checkRange("temperature", b.temperature, "(0, 1e8) K");
        s.groups_.push_back({b.diameter, b.flux, 0, 0});
    }
    return s;
}


impact::plumeSource impact::plumeSource::interface
(
    const std::vector<record>& records,
    const std::vector<double>& groupEdges,
    bool axisymmetric,
    double smoothing
)
{
    checkRange("smoothing", smoothing, "[0, 1e8) m/s");
    plumeSource s;
    s.axisymmetric_ = axisymmetric;
    s.smoothing_ = smoothing;
    for (const record& r : records)
    {
        if (r.weight > 0)
        {
            s.records_.push_back(r);
        }
    }
    if (s.records_.empty())
    {
        throw std::invalid_argument
        (
            "file: none of its records has a weight > 0"
        );
    }
    std::stable_sort
    (
        s.records_.begin(), s.records_.end(),
        [](const record& a, const record& b)
        {
            return a.diameter < b.diameter;
        }
    );

    // Upper ends of the groups
    std::vector<double> ends(groupEdges);
    if (groupEdges.empty())
    {
        for (const record& r : s.records_)
        {
            // Diameters written with few digits are still one group
            if (ends.empty() || r.diameter > ends.back())
            {
                ends.push_back(r.diameter*(1 + 1e-6));
                checkRange
                (
                    "number of different diameters in the interface file",
                    ends.size(),
                    "[1, 64]; give groupEdges for a continuous distribution"
                );
            }
        }
    }
    else
    {
        checkRange("number of groupEdges", groupEdges.size(), "[2, 65]");
        for (std::size_t i = 0; i < groupEdges.size(); ++i)
        {
            checkRange
            (
                groupEdges[i] > (i ? groupEdges[i - 1] : 0),
                "groupEdges", groupEdges[i], "> 0 and ascending, m"
            );
        }
        const double low = groupEdges.front(), high = groupEdges.back();
        for (const record& r : s.records_)
        {
            if (!(r.diameter >= low && r.diameter < high))
            {
                throwOutOfRange
                (
                    "diameter of the interface file", r.diameter, '[', low,
                    ", ", high, ") (m), that of groupEdges"
                );
            }
        }
        ends.erase(ends.begin());
    }

    std::size_t at = 0;
    for (const double end : ends)
    {
        group g = {0, 0, at, at};
        for (; at < s.records_.size() && s.records_[at].diameter < end; ++at)
        {
            g.flux += s.records_[at].weight;
            g.diameter += s.records_[at].weight*s.records_[at].diameter;
        }
        g.last = at;
        if (g.last > g.first)
        {
            g.diameter /= g.flux;
            s.groups_.push_back(g);
        }
    }
    return s;
}


double impact::plumeSource::topSpeed() const
{
    double top = 0;
    for (const beam& b : beams_)
    {
        top = std::max(top, b.speed + 3*b.speedDeviation);
    }
    for (const record& r : records_)
    {
        top = std::max(top, mag(r.velocity) + 3*std::sqrt(3.)*smoothing_);
    }
    return top;
}
