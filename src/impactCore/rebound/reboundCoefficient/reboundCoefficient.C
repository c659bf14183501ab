/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "reboundCoefficient.H"
#include "gridPlace.H"
#include "outOfRange.H"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace
{

constexpr double radians = 3.14159265358979323846/180;


//- Of a quantity's own range
void checkValue
(
    const impact::reboundCoefficient::quantity& q,
    const std::string& entry,
    double value
)
{
    impact::checkRange(entry, value, q.low, q.high);
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
        impact::throwInvalid(name, " ", what, ": the list is empty");
    }
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        impact::checkRange(name + ' ' + what, x[i], low, high);
        if (i > 0 && !(x[i] > x[i - 1]))
        {
            impact::throwInvalid
            (
                name, " ", what, " ", x[i], " follows ", x[i - 1],
                ": they must increase"
            );
        }
    }
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
    checkValue(q, q.name, value);
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
    checkGrid(q.name, "angles", angles, 0, 90);
    checkGrid(q.name, "speeds", speeds, 0, 1e100);
    if (values.size() != angles.size()*speeds.size())
    {
        impact::throwInvalid
        (
            q.name, " values: ", angles.size(), " angles times ",
            speeds.size(), " speeds need ", angles.size()*speeds.size(),
            " values, there are ", values.size()
        );
    }
    for (const double value : values)
    {
        checkValue(q, q.name + " values", value);
    }
    reboundCoefficient c(formType::table);
    c.angles_ = angles;
    c.speeds_ = speeds;
    c.values_ = values;
    return c;
}


impact::reboundCoefficient impact::reboundCoefficient::table
(
    const quantity& q,
    const std::string& fileName
)
{
    const std::string what = q.name + " file \"" + fileName + '"';
    std::ifstream file(fileName);
    if (!file)
    {
        throwInvalid(what, " cannot be read");
    }
    std::vector<double> angles, speeds, values;
    std::size_t columns = 0;
    bool namesMayFollow = true;
    std::string line;
    for (int number = 1; std::getline(file, line); ++number)
    {
        std::replace(line.begin(), line.end(), ',', ' ');
        const std::size_t first = line.find_first_not_of(" \t\r");
        if (first == std::string::npos || line[first] == '#')
        {
            continue;
        }
        const bool names =
            namesMayFollow
         && std::isalpha(static_cast<unsigned char>(line[first]));
        namesMayFollow = false;
        if (names)
        {
            continue;
        }
        std::istringstream words(line);
        std::vector<double> row;
        for (double x; words >> x;)
        {
            row.push_back(x);
        }
        columns = columns ? columns : row.size();
        if
        (
            !words.eof() || row.size() != columns
         || (columns != 2 && columns != 3)
        )
        {
            throwInvalid
            (
                what, ", line ", number, ": two numbers (angle value) or"
                " three (angle speed value) expected, as in its first line"
            );
        }
        const double speed = columns == 3 ? row[1] : 0;
        if (angles.empty() || row[0] != angles.back())
        {
            angles.push_back(row[0]);
        }
        if (angles.size() == 1)
        {
            speeds.push_back(speed);
        }
        const std::size_t i = values.size() % speeds.size();
        if
        (
            speed != speeds[i]
         || angles.size() != values.size()/speeds.size() + 1
        )
        {
            throwInvalid
            (
                what, ", line ", number, ": the points must be those of a"
                " grid, every angle with the speeds of the first one"
            );
        }
        values.push_back(row.back());
    }
    try
    {
        return table(q, angles, speeds, values);
    }
    catch (const std::invalid_argument& error)
    {
        throwInvalid(what, ": ", error.what());
    }
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
        impact::throwInvalid(q.name, " coefficients: the list is empty");
    }
    reboundCoefficient c(formType::polynomial);
    c.nSpeedPowers_ = int(coefficients[0].size());
    for (const auto& row : coefficients)
    {
        if (int(row.size()) != c.nSpeedPowers_)
        {
            impact::throwInvalid
            (
                q.name, " coefficients: rows of ", c.nSpeedPowers_, " and ",
                row.size(), " numbers"
            );
        }
        c.values_.insert(c.values_.end(), row.begin(), row.end());
    }
    c.angles_ = {angleLow, angleHigh};
    checkGrid(q.name, "angleRange", c.angles_, 0, 90);
    c.speeds_ = {0};
    if (c.nSpeedPowers_ > 1)
    {
        c.speeds_ = {speedLow, speedHigh};
        checkGrid(q.name, "speedRange", c.speeds_, 0, 1e6);
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
                impact::throwOutOfRange
                (
                    q.name + " coefficients: the polynomial is", value,
                    impact::rangeText("[]", q.low, q.high), ", here at ",
                    angle, " deg, ", speed, " m/s"
                );
            }
        }
    }
    c.low_ = q.low;
    c.high_ = q.high;
    return c;
}


impact::reboundCoefficient impact::reboundCoefficient::McNamaraFalcon
(
    const quantity& q,
    double value,
    double speed
)
{
    checkValue(q, q.name, value);
    checkRange(q.name + "Speed", speed, "(1e-100, 1e100) m/s");
    reboundCoefficient c(formType::McNamaraFalcon);
    c.value_ = value;
    c.perSpeed_ = 1/speed;
    return c;
}


std::vector<std::string> impact::reboundCoefficient::fits(const quantity& q)
{
    switch (q.of)
    {
        case component::normal:
        {
            return {"corundumOnSteel", "GrantTabakoff"};
        }
        case component::tangential:
        {
            return {"GrantTabakoff"};
        }
        case component::none:
        {
            break;
        }
    }
    return {};
}


impact::reboundCoefficient impact::reboundCoefficient::fit
(
    const quantity& q,
    const std::string& name
)
{
    const std::vector<std::string> valid(fits(q));
    if (std::find(valid.begin(), valid.end(), name) == valid.end())
    {
        throwInvalid(q.name, " has no fit ", name);
    }
    if (name == "corundumOnSteel")
    {
        return reboundCoefficient(formType::corundumOnSteel);
    }
    return q.of == component::normal
      ? polynomial(q, {{0.993}, {-1.76}, {1.56}, {-0.49}}, 0, 90, 0, 0)
      : polynomial(q, {{0.988}, {-1.66}, {2.11}, {-0.67}}, 0, 90, 0, 0);
}


bool impact::reboundCoefficient::dependsOnSpeed() const
{
    return
        form_ == formType::McNamaraFalcon
     || form_ == formType::corundumOnSteel
     || speeds_.size() > 1;
}


std::string impact::reboundCoefficient::describe() const
{
    if (form_ == formType::corundumOnSteel)
    {
        return "corundumOnSteel";
    }
    std::ostringstream text;
    text.precision(12);
    if (form_ == formType::constant)
    {
        text<< value_;
        return text.str();
    }
    if (form_ == formType::McNamaraFalcon)
    {
        text<< "McNamaraFalcon " << value_ << ' ' << 1/perSpeed_;
        return text.str();
    }
    text<< (form_ == formType::table ? "table" : "polynomial");
    for (const auto* list : {&angles_, &speeds_, &values_})
    {
        text<< ' ' << list->size();
        for (const double x : *list)
        {
            text<< ' ' << x;
        }
    }
    return text.str();
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
            const gridPlace a(angles_, angle), s(speeds_, speed);
            const auto at = [&](int i)
            {
                const double* v = &values_[i*speeds_.size()];
                return (1 - s.share)*v[s.low] + s.share*v[s.high];
            };
            return (1 - a.share)*at(a.low) + a.share*at(a.high);
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
            return std::min(std::max(sum, low_), high_);
        }
        case formType::McNamaraFalcon:
        {
            const double x = perSpeed_*speed*std::sin(radians*angle);
            return x <= 1
              ? 1 - (1 - value_)*std::pow(x, 0.2)
              : value_/std::sqrt(std::sqrt(x));
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
