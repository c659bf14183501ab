/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "reboundCoefficient.H"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace
{

constexpr double radians = 3.14159265358979323846/180;


template<class... Parts>
[[noreturn]] void refuse(const Parts&... parts)
{
    std::ostringstream text;
    (text << ... << parts);
    throw std::invalid_argument(text.str());
}


void checkGrid
(
    const std::string& name,
    const char* what,
    const std::vector<double>& x,
    double low,
    double high
)
{
    if (x.empty())
    {
        refuse(name, " ", what, "s: the list is empty");
    }
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        if (!(x[i] >= low && x[i] <= high))
        {
            refuse
            (
                name, " ", what, " ", x[i], ": valid range [", low, ", ",
                high, "]"
            );
        }
        if (i > 0 && !(x[i] > x[i - 1]))
        {
            refuse
            (
                name, " ", what, " ", x[i], " follows ", x[i - 1],
                ": they must increase"
            );
        }
    }
}


//- Interval of a grid and place in it; the ends are held
int locate(const std::vector<double>& grid, double x, double& share)
{
    const int n = int(grid.size());
    if (n == 1 || x <= grid.front())
    {
        share = 0;
        return 0;
    }
    if (x >= grid.back())
    {
        share = 1;
        return n - 2;
    }
    const int i =
        int(std::upper_bound(grid.begin(), grid.end(), x) - grid.begin()) - 1;
    share = (x - grid[i])/(grid[i + 1] - grid[i]);
    return i;
}

} // End anonymous namespace


impact::reboundCoefficient::reboundCoefficient(formType form)
:
    form_(form)
{}


impact::reboundCoefficient impact::reboundCoefficient::constant
(
    const quantity& q,
    double value
)
{
    if (!(value >= q.low && value <= q.high))
    {
        refuse
        (
            q.name, " ", value, ": valid range [", q.low, ", ", q.high, "]"
        );
    }
    reboundCoefficient c(formType::constant);
    c.value_ = value;
    return c;
}


impact::reboundCoefficient impact::reboundCoefficient::table
(
    const quantity& q,
    const std::vector<double>& angles,
    const std::vector<double>& speeds,
    const std::vector<double>& values
)
{
    checkGrid(q.name, "angle", angles, 0, 90);
    checkGrid(q.name, "speed", speeds, 0, 1e100);
    if (values.size() != angles.size()*speeds.size())
    {
        refuse
        (
            q.name, " values: ", angles.size(), " angles times ",
            speeds.size(), " speeds need ", angles.size()*speeds.size(),
            " values, there are ", values.size()
        );
    }
    for (const double value : values)
    {
        if (!(value >= q.low && value <= q.high))
        {
            refuse
            (
                q.name, " value ", value, ": valid range [", q.low, ", ",
                q.high, "]"
            );
        }
    }
    reboundCoefficient c(formType::table);
    c.angles_ = angles;
    c.speeds_ = speeds;
    c.values_ = values;
    return c;
}


impact::reboundCoefficient impact::reboundCoefficient::polynomial
(
    const quantity& q,
    const std::vector<std::vector<double>>& coefficients,
    double angleLow,
    double angleHigh,
    double speedLow,
    double speedHigh
)
{
    if (coefficients.empty() || coefficients[0].empty())
    {
        refuse(q.name, " coefficients: the list is empty");
    }
    reboundCoefficient c(formType::polynomial);
    c.nSpeedPowers_ = int(coefficients[0].size());
    for (const auto& row : coefficients)
    {
        if (int(row.size()) != c.nSpeedPowers_)
        {
            refuse
            (
                q.name, " coefficients: rows of ", c.nSpeedPowers_, " and ",
                row.size(), " numbers"
            );
        }
        c.values_.insert(c.values_.end(), row.begin(), row.end());
    }
    c.angles_ = {angleLow, angleHigh};
    checkGrid(q.name, "angle", c.angles_, 0, 90);
    c.speeds_ = {0};
    if (c.nSpeedPowers_ > 1)
    {
        c.speeds_ = {speedLow, speedHigh};
        checkGrid(q.name, "speed", c.speeds_, 0, 1e6);
    }
    for (int i = 0; i <= 180; ++i)
    {
        for (int j = 0; j <= 64; ++j)
        {
            const double angle = angleLow + (angleHigh - angleLow)*i/180;
            const double speed =
                c.speeds_[0] + (c.speeds_.back() - c.speeds_[0])*j/64;
            const double value = c.evaluate(angle, speed);
            if (!(value >= q.low && value <= q.high))
            {
                refuse
                (
                    q.name, " coefficients: the polynomial is ", value,
                    " at ", angle, " deg, ", speed, " m/s: valid range [",
                    q.low, ", ", q.high, "]"
                );
            }
        }
    }
    return c;
}


impact::reboundCoefficient impact::reboundCoefficient::corundumOnSteel()
{
    return reboundCoefficient(formType::corundumOnSteel);
}


double impact::reboundCoefficient::evaluate(double angle, double speed) const
{
    switch (form_)
    {
        case formType::constant:
        {
            return value_;
        }
        case formType::table:
        {
            double a, s;
            const int i = locate(angles_, angle, a);
            const int j = locate(speeds_, speed, s);
            const int n = int(speeds_.size());
            const int right = n > 1 ? 1 : 0;
            const int up = angles_.size() > 1 ? n : 0;
            const double* v = &values_[i*n + j];
            return
                (1 - a)*((1 - s)*v[0] + s*v[right])
              + a*((1 - s)*v[up] + s*v[up + right]);
        }
        case formType::polynomial:
        {
            const double x = radians
               *std::min(std::max(angle, angles_[0]), angles_[1]);
            const double y =
                std::min(std::max(speed, speeds_[0]), speeds_.back());
            const int nRows = int(values_.size())/nSpeedPowers_;
            double sum = 0;
            for (int i = nRows - 1; i >= 0; --i)
            {
                double row = 0;
                for (int j = nSpeedPowers_ - 1; j >= 0; --j)
                {
                    row = row*y + values_[i*nSpeedPowers_ + j];
                }
                sum = sum*x + row;
            }
            return sum;
        }
        case formType::corundumOnSteel:
        {
            return
                1
              + std::expm1(-0.1*std::pow(speed, 0.61))
               *std::sin(radians*angle);
        }
    }
    return value_;
}
