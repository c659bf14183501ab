/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorTargets.H"

#include "rotationKernels.H"

namespace impact
{

impactKernel void rotationSeries
(
    int order,
    const double k[3],
    double (* __restrict__ c)[9]
)
{
    // All products are of a component with one of the angular velocity:
    // rows of both in the order in which they are multiplied
    constexpr int width = 8;
    constexpr int most = 32;
    const int left[2][width] =
        {{1, 2, 0, 4, 5, 3, 7, 8}, {2, 0, 1, 5, 3, 4, 6, 6}};
    const int right[2][width] =
        {{8, 6, 7, 8, 6, 7, 8, 6}, {7, 8, 6, 7, 8, 6, 7, 7}};
    typedef double row __attribute__((vector_size(width*sizeof(double))));
    row a[most], b[most], p[most], q[most];
    for (int n = 0; n < order; ++n)
    {
        for (int v = 0; v < width; ++v)
        {
            a[n][v] = c[n][left[0][v]];
            b[n][v] = c[n][left[1][v]];
            p[n][v] = c[n][right[0][v]];
            q[n][v] = c[n][right[1][v]];
        }
        // Sums of every other term: they do not wait for each other. The
        // rows just made come last
        row d = {}, e = {}, d2 = {}, e2 = {};
        int i = 1;
        for (; i + 1 < n; i += 2)
        {
            d += a[i]*p[n - i];
            e += b[i]*q[n - i];
            d2 += a[i + 1]*p[n - i - 1];
            e2 += b[i + 1]*q[n - i - 1];
        }
        if (i < n)
        {
            d += a[i]*p[n - i];
            e += b[i]*q[n - i];
        }
        if (n > 0)
        {
            d2 += a[0]*p[n];
            e2 += b[0]*q[n];
        }
        d += a[n]*p[0];
        e += b[n]*q[0];
        d += d2;
        e += e2;
        const double f = 1./(n + 1);
        for (int v = 0; v < 6; ++v)
        {
            c[n + 1][v] = f*(d[v] - e[v]);
        }
        c[n + 1][6] = f*k[0]*d[6];
        c[n + 1][7] = f*k[1]*d[7];
        c[n + 1][8] = f*k[2]*e[6];
    }
}


impactKernel void rotationSum
(
    int order,
    const double (* __restrict__ c)[9],
    double x,
    double* __restrict__ sum
)
{
    double v[9];
    for (int i = 0; i < 9; ++i)
    {
        v[i] = c[order][i];
    }
    for (int n = order - 1; n >= 0; --n)
    {
        for (int i = 0; i < 9; ++i)
        {
            v[i] = c[n][i] + x*v[i];
        }
    }
    for (int i = 0; i < 9; ++i)
    {
        sum[i] = v[i];
    }
}

} // End namespace impact
