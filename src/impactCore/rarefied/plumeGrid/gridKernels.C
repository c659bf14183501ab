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

} // End anonymous namespace


namespace impact
{

impactKernel void locateAxis
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
    const double R = g.halfWidth;
    for (int l = 0; l < n; ++l)
    {
        std::int64_t i;
        const bool in = along(g, 0, x[l], i);
        const bool near = y[l]*y[l] + z[l]*z[l] < R*R;
        cell[l] = (in & near) ? int(i) : -1;
    }
}


impactKernel void locatePlane
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
        std::int64_t i, j;
        const bool inX = along(g, 0, x[l], i);
        const bool inY = along(g, 1, y[l], j);
        const bool near = std::fabs(z[l] - g.centre[2]) < g.halfWidth;
        const int c = int(i) + g.n[0]*int(j);
        cell[l] = (inX & inY & near) ? c : -1;
    }
}


impactKernel void locateMeridian
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
        std::int64_t i, j;
        const bool inX = along(g, 0, x[l], i);
        const double r = std::sqrt(y[l]*y[l] + z[l]*z[l]);
        const bool inR = along(g, 1, r, j);
        const int c = int(i) + g.n[0]*int(j);
        cell[l] = (inX & inR) ? c : -1;
    }
}


impactKernel void locateSphere
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
        const double a = x[l] - g.centre[0];
        const double b = y[l] - g.centre[1];
        const double c = z[l] - g.centre[2];
        const double r2 = b*b + c*c;
        std::int64_t i, j, k;
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
        cell[l] = in ? m : -1;
    }
}

} // End namespace impact
