/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorTargets.H"

#include "shadowKernels.H"

namespace impact
{

impactKernel void shadowGaps
(
    int n,
    const double* __restrict__ vertices,
    const double* __restrict__ pose,
    int m,
    const double* __restrict__ s,
    double* __restrict__ X,
    double* __restrict__ Y,
    double* __restrict__ gap
)
{
    const double* __restrict__ vx = vertices;
    const double* __restrict__ vy = vertices + n;
    const double* __restrict__ vz = vertices + 2*n;
    const double cx = pose[0], cy = pose[1];
    const double ax = pose[2], ay = pose[3], az = pose[4];
    const double bx = pose[5], by = pose[6], bz = pose[7];

    // Nearly always one or two intervals: select between them
    const int k = m > 1 ? 5 : 0;
    const double p0 = s[0], q0 = s[k], split = m > 1 ? q0 : 1e300;
    const double p1 = s[1], p2 = s[2], p3 = s[3], p4 = s[4];
    const double q1 = s[k + 1], q2 = s[k + 2], q3 = s[k + 3], q4 = s[k + 4];
    for (int i = 0; i < n; ++i)
    {
        const double x = cx + (ax*vx[i] + ay*vy[i] + az*vz[i]);
        const double y = cy + (bx*vx[i] + by*vy[i] + bz*vz[i]);
        const bool second = x >= split;
        const double u = x - (second ? q0 : p0);
        const double c1 = second ? q1 : p1;
        const double c2 = second ? q2 : p2;
        const double c3 = second ? q3 : p3;
        const double c4 = second ? q4 : p4;
        X[i] = x;
        Y[i] = y;
        gap[i] = y - (c1 + u*(c2 + u*(c3 + u*c4)));
    }
    for (int l = 2; l < m; ++l)
    {
        const double x0 = s[5*l], c1 = s[5*l + 1], c2 = s[5*l + 2];
        const double c3 = s[5*l + 3], c4 = s[5*l + 4];
        for (int i = 0; i < n; ++i)
        {
            const double u = X[i] - x0;
            const double g = Y[i] - (c1 + u*(c2 + u*(c3 + u*c4)));
            gap[i] = u >= 0 ? g : gap[i];
        }
    }
}


impactKernel double smallest(int n, const double* x)
{
    constexpr int lanes = 8;
    double minima[lanes];
    for (int k = 0; k < lanes; ++k)
    {
        minima[k] = x[k];
    }
    for (int i = lanes; i < n; i += lanes)
    {
        for (int k = 0; k < lanes; ++k)
        {
            minima[k] = x[i + k] < minima[k] ? x[i + k] : minima[k];
        }
    }
    double s = minima[0];
    for (int k = 1; k < lanes; ++k)
    {
        s = minima[k] < s ? minima[k] : s;
    }
    return s;
}

} // End namespace impact
