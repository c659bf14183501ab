/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "plumeGrid.H"
#include "gridKernels.H"
#include "outOfRange.H"

#include <cmath>
#include <string>

namespace
{

using impact::checkRange;
using impact::plumeGrid;

const plumeGrid::range& checked
(
    const plumeGrid::range& r,
    const char* name,
    bool distance
)
{
    checkRange
    (
        std::string("from of ") + name, r.from,
        distance ? "[0, 1e15) m" : "(-1e15, 1e15) m"
    );
    checkRange
    (
        r.to > r.from && r.to < 1e15,
        std::string("to of ") + name, r.to, "(from, 1e15) m"
    );
    checkRange(std::string("n of ") + name, r.n, "[1, 1e6]");
    return r;
}


const plumeGrid::range none = {0, 1, 1};

} // End anonymous namespace


impact::plumeGrid::plumeGrid
(
    gridType type,
    const range& a,
    const range& b,
    const range& c
)
:
    type_(type),
    ranges_{{a, b, c}}
{
    const double cells = double(a.n)*b.n*c.n;
    checkRange("number of cells", cells, "[1, 1e8]");
}


impact::plumeGrid impact::plumeGrid::axis(const range& x, double radius)
{
    checkRange("radius", radius, "(0, 1e15) m");
    plumeGrid g(gridType::axis, checked(x, "x", false), none, none);
    g.halfWidth_ = radius;
    return g;
}


impact::plumeGrid impact::plumeGrid::plane
(
    const range& x,
    const range& y,
    double position,
    double thickness
)
{
    checkRange("thickness", thickness, "(0, 1e15) m");
    checkRange("position", position, "(-1e15, 1e15) m");
    plumeGrid g
    (
        gridType::plane, checked(x, "x", false), checked(y, "y", false), none
    );
    g.halfWidth_ = 0.5*thickness;
    g.centre_.z = position;
    return g;
}


impact::plumeGrid impact::plumeGrid::meridian
(
    const range& x,
    const range& r
)
{
    return plumeGrid
    (
        gridType::meridian, checked(x, "x", false), checked(r, "r", true),
        none
    );
}


impact::plumeGrid impact::plumeGrid::sphere
(
    const vector3& centre,
    const range& r,
    int nPolar,
    int nAzimuth
)
{
    checkRange("nPolar", nPolar, "[1, 1e4]");
    checkRange("nAzimuth", nAzimuth, "[1, 1e4]");
    checkRange("centre", centre, "(-1e15, 1e15) m");
    plumeGrid g
    (
        gridType::sphere, checked(r, "r", true),
        {0, M_PI, nPolar}, {0, 2*M_PI, nAzimuth}
    );
    g.centre_ = centre;
    return g;
}


double impact::plumeGrid::coordinate(int d, double i) const
{
    const range& r = ranges_[d];
    return r.from + i*(r.to - r.from)/r.n;
}


impact::vector3 impact::plumeGrid::point(double i, double j, double k) const
{
    const double a = coordinate(0, i);
    switch (type_)
    {
        case gridType::axis:
            return {a, 0, 0};

        case gridType::plane:
            return {a, coordinate(1, j), centre_.z};

        case gridType::meridian:
            return {a, coordinate(1, j), 0};

        default:
        {
            const double polar = coordinate(1, j), phi = coordinate(2, k);
            const double r = a*std::sin(polar);
            return centre_ + vector3
            {
                a*std::cos(polar), r*std::cos(phi), r*std::sin(phi)
            };
        }
    }
}


double impact::plumeGrid::volume(int i, int j, int k) const
{
    const double a = coordinate(0, i), b = coordinate(0, i + 1);
    const double c = coordinate(1, j), d = coordinate(1, j + 1);
    switch (type_)
    {
        case gridType::axis:
            return (b - a)*M_PI*halfWidth_*halfWidth_;

        case gridType::plane:
            return (b - a)*(d - c)*2*halfWidth_;

        case gridType::meridian:
            return (b - a)*M_PI*(d - c)*(d + c);

        default:
            // cos c - cos d without loss at the poles
            return (b - a)*(a*a + a*b + b*b)/3
               *2*std::sin(0.5*(d - c))*std::sin(0.5*(d + c))
               *(coordinate(2, k + 1) - coordinate(2, k));
    }
}


void impact::plumeGrid::locate
(
    int n,
    const double* x,
    const double* y,
    const double* z,
    int* cell
) const
{
    gridShape s = {};
    for (int d = 0; d < 3; ++d)
    {
        const range& r = ranges_[d];
        s.from[d] = r.from;
        s.inverse[d] = r.n/(r.to - r.from);
        s.n[d] = r.n;
        s.centre[d] = centre_[d];
    }
    s.halfWidth = halfWidth_;
    locateCells(type_, n, s, x, y, z, cell);
}
