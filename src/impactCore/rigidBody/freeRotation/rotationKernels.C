/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorTargets.H"

#include "rotationKernels.H"

#include <cstring>

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
    typedef double row __attribute__((vector_size(width*sizeof(double))));
    typedef long long placesOf
        __attribute__((vector_size(width*sizeof(long long))));

    // Places of c[0 ... 7]; 8 is that of c[8]
    const placesOf inA = {1, 2, 0, 4, 5, 3, 7, 8};
    const placesOf inB = {2, 0, 1, 5, 3, 4, 6, 6};
    const placesOf inP = {8, 6, 7, 8, 6, 7, 8, 6};
    const placesOf inQ = {7, 8, 6, 7, 8, 6, 7, 7};
    const row factor = {1, 1, 1, 1, 1, 1, k[0], k[1]};
    const row both = {1, 1, 1, 1, 1, 1, 0, 0};
    row a[most], b[most], p[most], q[most];
    row now;
    std::memcpy(&now, c[0], sizeof(now));
    double last = c[0][8];
    for (int n = 0; n < order; ++n)
    {
        const row last8 =
            {last, last, last, last, last, last, last, last};
        const row an = __builtin_shuffle(now, last8, inA);
        const row bn = __builtin_shuffle(now, last8, inB);
        const row pn = __builtin_shuffle(now, last8, inP);
        const row qn = __builtin_shuffle(now, last8, inQ);
        a[n] = an;
        b[n] = bn;
        p[n] = pn;
        q[n] = qn;

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
            d2 += a[0]*pn;
            e2 += b[0]*qn;
        }
        d += an*p[0];
        e += bn*q[0];
        d += d2;
        e += e2;
        const double f = 1./(n + 1);
        now = (f*factor)*(d - both*e);
        last = f*k[2]*e[6];
        std::memcpy(c[n + 1], &now, sizeof(now));
        c[n + 1][8] = last;
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
