/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "lanes.H"

#include "rotationKernels.H"

namespace
{

using namespace impact;

//- A vector, and a lane to spare
impactInline lanes three(const double* p)
{
    return lanes{p[0], p[1], p[2], 0};
}


impactInline void put(double* p, const lanes& a)
{
    p[0] = a[0];
    p[1] = a[1];
    p[2] = a[2];
}


//- The terms of a vector, as both factors of a cross product take them
struct crossTerms
{
    static constexpr int maxOrder = 32;
    lanes yzx[maxOrder], zxy[maxOrder];

    impactInline void add(int n, const lanes& a)
    {
        yzx[n] = exchanged(a, laneMarks{1, 2, 0, 3});
        zxy[n] = exchanged(a, laneMarks{2, 0, 1, 3});
    }
};


//- Parts of the term of order n of a x b
struct crossSum
{
    lanes plus = {}, minus = {};

    impactInline void add
    (
        const crossTerms& a,
        int i,
        const crossTerms& b,
        int j
    )
    {
        plus += a.yzx[i]*b.zxy[j];
        minus += a.zxy[i]*b.yzx[j];
    }

    impactInline void add(const crossSum& other)
    {
        plus += other.plus;
        minus += other.minus;
    }
};

} // End anonymous namespace


namespace impact
{

impactKernel void rotationSeries
(
    int order,
    const double k[3],
    double (* __restrict__ c)[9]
)
{
    // The laboratory axes turn by their cross products with the angular
    // velocity w, and w by products of its own components
    crossTerms x, y, w;
    lanes xn = three(c[0]), yn = three(c[0] + 3), wn = three(c[0] + 6);
    const lanes factor = three(k);
    for (int n = 0; n < order; ++n)
    {
        x.add(n, xn);
        y.add(n, yn);
        w.add(n, wn);

        // Sums of every other term: they do not wait for each other. The
        // terms just made come last
        crossSum dx, dy, dw, dx2, dy2, dw2;
        int i = 1;
        for (; i + 1 < n; i += 2)
        {
            dx.add(x, i, w, n - i);
            dy.add(y, i, w, n - i);
            dw.add(w, i, w, n - i);
            dx2.add(x, i + 1, w, n - i - 1);
            dy2.add(y, i + 1, w, n - i - 1);
            dw2.add(w, i + 1, w, n - i - 1);
        }
        if (i < n)
        {
            dx.add(x, i, w, n - i);
            dy.add(y, i, w, n - i);
            dw.add(w, i, w, n - i);
        }
        if (n > 0)
        {
            dx2.add(x, 0, w, n);
            dy2.add(y, 0, w, n);
            dw2.add(w, 0, w, n);
        }
        dx.add(x, n, w, 0);
        dy.add(y, n, w, 0);
        dw.add(w, n, w, 0);
        dx.add(dx2);
        dy.add(dy2);
        dw.add(dw2);
        const double f = 1./(n + 1);
        xn = f*(dx.plus - dx.minus);
        yn = f*(dy.plus - dy.minus);
        wn = (f*factor)*dw.plus;
        put(c[n + 1], xn);
        put(c[n + 1] + 3, yn);
        put(c[n + 1] + 6, wn);
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
