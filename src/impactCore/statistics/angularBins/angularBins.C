/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "angularBins.H"
#include "outOfRange.H"

#include <algorithm>
#include <cmath>

namespace impact
{

namespace
{

const double degree = std::acos(-1.0)/180;

//- Round-off in which a position stands on the edge of a bin, in parts of the
//  bin, and a polygon in the plane of one, in parts of its distance
const double onEdge = 1e-9;

//- Part of a polygon where side . (x - origin) >= 0
void cut
(
    const std::vector<vector3>& polygon,
    const vector3& origin,
    const vector3& side,
    std::vector<vector3>& part
)
{
    part.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
        const vector3& a = polygon[i];
        const vector3& b = polygon[(i + 1) % polygon.size()];
        const double da = dot(side, a - origin);
        const double db = dot(side, b - origin);
        if (da >= 0)
        {
            part.push_back(a);
        }
        if ((da >= 0) != (db >= 0))
        {
            part.push_back(a + (da/(da - db))*(b - a));
        }
    }
}


vector3 areaVector(const std::vector<vector3>& polygon)
{
    vector3 sum{0, 0, 0};
    for (std::size_t i = 2; i < polygon.size(); ++i)
    {
        sum = sum + 0.5*cross
        (
            polygon[i - 1] - polygon[0],
            polygon[i] - polygon[0]
        );
    }
    return sum;
}


[[noreturn]] void refuse(const char* what, const vector3& v, const char* valid)
{
    impact::throwInvalid
    (
        what, " (", v.x, ' ', v.y, ' ', v.z, "): valid range ", valid
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

int angularBins::fold(int k) const
{
    const int half = nCircle_/2;
    return !folded_ ? k : k >= half ? k - half : half - 1 - k;
}


int angularBins::edgeBin(int k) const
{
    return fold(k == 0 ? nCircle_ - 1 : k);
}


bool angularBins::addInPlane
(
    const std::vector<vector3>& polygon,
    const vector3& n,
    std::vector<double>& areas
) const
{
    double reach = 0;
    for (const vector3& x : polygon)
    {
        const vector3 r = x - origin_;
        reach = std::max(reach, mag(r - dot(r, axis_)*axis_));
    }
    const auto isIn =
        [&](const vector3& edge)
        {
            for (const vector3& x : polygon)
            {
                if (std::fabs(dot(edge, x - origin_)) > onEdge*reach)
                {
                    return false;
                }
            }
            return true;
        };
    for (int k = 0; k < nCircle_/2; ++k)
    {
        if (isIn(edges_[k]))
        {
            // To both sides of the axis
            std::vector<vector3> part;
            const vector3 along = cross(edges_[k], axis_);
            cut(polygon, origin_, along, part);
            areas[edgeBin(k)] += dot(n, areaVector(part));
            cut(polygon, origin_, -along, part);
            areas[edgeBin(k + nCircle_/2)] += dot(n, areaVector(part));
            return true;
        }
    }
    return false;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

angularBins::angularBins
(
    const vector3& origin,
    const vector3& direction,
    const vector3& from,
    double width,
    bool folded
)
:
    origin_(origin),
    width_(width),
    folded_(folded)
{
    const double length = mag(direction);
    if (!(length > 0))
    {
        refuse("direction", direction, "of a length > 0");
    }
    axis_ = (1/length)*direction;

    const vector3 across = from - dot(from, axis_)*axis_;
    const double a = mag(across);
    if (!(a > 1e-9*mag(from)))
    {
        refuse
        (
            "from", from, "with a part across the axis"
        );
    }
    e0_ = (1/a)*across;
    e1_ = cross(axis_, e0_);

    checkRange("binWidth", width, "(0, 90] deg");
    const double half = std::round(180/width);
    if (std::fabs(half*width - 180) > 1e-9*180 || half > 1e6)
    {
        throwOutOfRange
        (
            "binWidth", width, "(0, 90] deg, a whole part of 180, not less than"
            " a millionth"
        );
    }
    nCircle_ = 2*int(half);

    edges_.reserve(nCircle_ + 1);
    for (int k = 0; k <= nCircle_; ++k)
    {
        const double a = (k*width_ - 180)*degree;
        edges_.push_back(std::cos(a)*e1_ - std::sin(a)*e0_);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double angularBins::centre(int bin) const
{
    return (bin + 0.5)*width_ - (folded_ ? 0 : 180);
}


double angularBins::phi(const vector3& position) const
{
    const vector3 r = position - origin_;
    const double x = dot(e0_, r);
    const double y = dot(e1_, r);
    return x == 0 && y == 0 ? 0 : std::atan2(y, x)/degree;
}


int angularBins::bin(const vector3& position) const
{
    const double q = (phi(position) + 180)/width_;
    const int k = int(std::floor(q + onEdge));
    return q < onEdge || k >= nCircle_ ? edgeBin(0) : fold(k);
}


vector3 angularBins::normal(const vector3& position) const
{
    const vector3 r = position - origin_;
    const vector3 across = r - dot(r, axis_)*axis_;
    const double a = mag(across);
    return a > 0 ? (1/a)*across : across;
}


void angularBins::addArea
(
    const std::vector<vector3>& polygon,
    std::vector<double>& areas
) const
{
    const vector3 whole = areaVector(polygon);
    const double area = mag(whole);
    if (polygon.size() < 3 || !(area > 0))
    {
        return;
    }
    const vector3 n = (1/area)*whole;
    if (addInPlane(polygon, n, areas))
    {
        return;
    }

    std::vector<vector3> low;
    std::vector<vector3> part;
    for (int k = 0; k < nCircle_; ++k)
    {
        // Beyond the half-plane of the lower angle, before that of the upper:
        // a wedge, as the width is less than 180 degrees
        const vector3& beyond = edges_[k];
        const vector3 before = -edges_[k + 1];

        bool some = false;
        bool all = true;
        bool someBefore = false;
        for (const vector3& x : polygon)
        {
            const bool inside = dot(beyond, x - origin_) >= 0;
            const bool insideToo = dot(before, x - origin_) >= 0;
            some = some || inside;
            someBefore = someBefore || insideToo;
            all = all && inside && insideToo;
        }
        if (all)
        {
            areas[fold(k)] += area;
        }
        else if (some && someBefore)
        {
            cut(polygon, origin_, beyond, low);
            cut(low, origin_, before, part);
            areas[fold(k)] += dot(n, areaVector(part));
        }
    }
}

} // End namespace impact
