/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorTargets.H"

#include "gridKernels.H"
#include "elementary.H"

namespace
{

using namespace impact;

//- Number of the cell along one direction. No conversion of a number that
//  may be too large for an integer: that would be a trap.
impactInline bool along
(
    const gridShape& g,
    int d,
    double x,
    std::int64_t& i
)
{
    const double t = (x - g.from[d])*g.inverse[d];

    // Halves may have gone to the even number below
    const double below = nearest(t - 0.5, i);
    i += below + 1 <= t;
    return (t >= 0) & (t < g.n[d]);
}

//- Number of the cell of a place, or -1
template<plumeGrid::gridType type>
impactInline int cellOf(const gridShape& g, double x, double y, double z)
{
    std::int64_t i, j, k;
    if constexpr (type == plumeGrid::gridType::axis)
    {
        const bool in = along(g, 0, x, i);
        const bool near = y*y + z*z < g.halfWidth*g.halfWidth;
        return (in & near) ? int(i) : -1;
    }
    else if constexpr (type == plumeGrid::gridType::plane)
    {
        const bool inX = along(g, 0, x, i);
        const bool inY = along(g, 1, y, j);
        const bool near = std::fabs(z - g.centre[2]) < g.halfWidth;
        const int c = int(i) + g.n[0]*int(j);
        return (inX & inY & near) ? c : -1;
    }
    else if constexpr (type == plumeGrid::gridType::meridian)
    {
        const bool inX = along(g, 0, x, i);
        const bool inR = along(g, 1, std::sqrt(y*y + z*z), j);
        const int c = int(i) + g.n[0]*int(j);
        return (inX & inR) ? c : -1;
    }
    else
    {
        const double a = x - g.centre[0];
        const double b = y - g.centre[1];
        const double c = z - g.centre[2];
        const double r2 = b*b + c*c;
        const bool in = along(g, 0, std::sqrt(a*a + r2), i);

        // On the last boundary an angle belongs to the last cell
        const double polar = arcTan2(std::sqrt(r2), a);
        const double phi = arcTan2(c, b);
        const double turned = phi < 0 ? phi + 6.2831853071795862 : phi;
        const bool below = along(g, 1, polar, j);
        const bool before = along(g, 2, turned, k);
        const int jj = below ? int(j) : g.n[1] - 1;
        const int kk = before ? int(k) : g.n[2] - 1;
        const int m = int(i) + g.n[0]*(jj + g.n[1]*kk);
        return in ? m : -1;
    }
}


template<plumeGrid::gridType type>
impactInline void locateOn
(
    int n,
    const gridShape& shape,
    const double* __restrict__ x,
    const double* __restrict__ y,
    const double* __restrict__ z,
    int* __restrict__ cell
)
{
    const gridShape g = shape;
    for (int l = 0; l < n; ++l)
    {
        cell[l] = cellOf<type>(g, x[l], y[l], z[l]);
    }
}

} // End anonymous namespace


impactKernel void impact::locateCells
(
    plumeGrid::gridType type,
    int n,
    const gridShape& g,
    const double* x,
    const double* y,
    const double* z,
    int* cell
)
{
    typedef plumeGrid::gridType grid;
    type == grid::axis ? locateOn<grid::axis>(n, g, x, y, z, cell)
  : type == grid::plane ? locateOn<grid::plane>(n, g, x, y, z, cell)
  : type == grid::meridian ? locateOn<grid::meridian>(n, g, x, y, z, cell)
  : locateOn<grid::sphere>(n, g, x, y, z, cell);
}
