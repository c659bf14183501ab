/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorTargets.H"

#include "elementary.H"
#include "frictionKernels.H"

namespace
{

using namespace impact;

//- Four at once, out of arrays of any alignment
typedef double row
    __attribute__((vector_size(4*sizeof(double)), aligned(8), may_alias));


//- Columns of the linear part by x, y, s; that of s includes the rate of s
//  to first order
struct linearPart
{
    row x, y, s;
    double inverse;         // 1/s0
    row first;              // terms of order 1 times that: x, y, s
};


//- Terms m and up. With z' the linear part, and by orders of s^2 = x^2 + y^2,
//      s0 s_m = x0 x_m + y0 y_m
//        + 1/2 sum_{k = 1}^{m - 1} (x_k x_{m-k} + y_k y_{m-k} - s_k s_{m-k})
//  the term before last is in x0 x_m + y0 y_m, as the linear part, and in
//  k = 1 and m - 1: all else is summed without waiting for it
template<int m>
impactInline void addTerms
(
    const linearPart& q,
    const row& last,
    frictionSeries& c
)
{
    constexpr double unit = 1./m;
    constexpr double once = m == 2 ? 0.5 : 1;
    row* rows = reinterpret_cast<row*>(c.z);
    typedef long long places __attribute__((vector_size(sizeof(row))));
    const row zx = __builtin_shuffle(last, places{0, 0, 0, 0});
    const row zy = __builtin_shuffle(last, places{1, 1, 1, 1});
    const row zs = __builtin_shuffle(last, places{2, 2, 2, 2});
    const row bySlip =
        unit*q.s - row{0, 0, once*q.first[2], 0};
    const row byX = unit*q.x + row{0, 0, once*q.first[0], 0};
    const row byY = unit*q.y + row{0, 0, once*q.first[1], 0};
    row sum = {0, 0, 0, 0};
    if (m % 2 == 0 && m > 2)
    {
        const row middle = rows[m/2];
        sum = 0.5*(middle*middle);
    }
    #pragma GCC unroll 12
    for (int k = (m - 1)/2; k > 1; --k)
    {
        sum += rows[k]*rows[m - k];
    }
    const double along = sum[0] + sum[1];
    const row earlier = {0, 0, q.inverse*(along - sum[2]), 0};
    const row next = (earlier + bySlip*zs) + (byX*zx + byY*zy);
    rows[m] = next;
    c.square[m] =
        2
       *(
            along
          + (
                (c.z[0][0]*next[0] + c.z[0][1]*next[1])
              + once*(c.z[1][0]*last[0] + c.z[1][1]*last[1])
            )
        );
    if constexpr (m < frictionOrder)
    {
        addTerms<m + 1>(q, next, c);
    }
}

} // End anonymous namespace


namespace impact
{

impactKernel void expandFriction
(
    double mu,
    const double* k,
    const double* f,
    frictionSeries& c
)
{
    const double x = c.z[0][0], y = c.z[0][1], s = c.z[0][2];
    linearPart q;
    q.inverse = 1/s;
    const double ux = q.inverse*x, uy = q.inverse*y;
    const double kx = k[0]*ux + k[1]*uy, ky = k[1]*ux + k[2]*uy;
    q.x = -mu*row{k[0], k[1], kx, f[0]};
    q.y = -mu*row{k[1], k[2], ky, f[1]};
    q.s = row{f[0], f[1], f[0]*ux + f[1]*uy, f[2]};
    const row one = q.s*s + (q.x*x + q.y*y);
    reinterpret_cast<row*>(c.z)[1] = one;
    q.first = q.inverse*one;
    c.square[0] = s*s;
    c.square[1] = 2*(x*one[0] + y*one[1]);
    addTerms<2>(q, one, c);
}


impactKernel void sumFriction
(
    double tau,
    const frictionSeries& c,
    double* sums
)
{
    // Even and odd orders apart, in powers of the square: half the time is
    // spent waiting for results of before
    static_assert(frictionOrder % 2 == 0, "pairs of orders");
    const row* rows = reinterpret_cast<const row*>(c.z);
    const double tau2 = tau*tau;
    row value[2] = {}, total[2] = {};
    double square[2] = {};
    #pragma GCC unroll 4
    for (int n = frictionOrder; n >= 2; n -= 2)
    {
        #pragma GCC unroll 2
        for (int odd = 0; odd < 2; ++odd)
        {
            const int k = n - odd;
            value[odd] = rows[k] + tau2*value[odd];
            total[odd] = inverses.of[k + 1]*rows[k] + tau2*total[odd];
            square[odd] = inverses.of[k + 1]*c.square[k] + tau2*square[odd];
        }
    }
    value[0] = rows[0] + tau2*value[0];
    total[0] = rows[0] + tau2*total[0];
    square[0] = c.square[0] + tau2*square[0];
    value[0] = value[0] + tau*value[1];
    total[0] = tau*(total[0] + tau*total[1]);
    total[0][3] = tau*(square[0] + tau*square[1]);
    row* out = reinterpret_cast<row*>(sums);
    out[0] = value[0];
    out[1] = total[0];
}

} // End namespace impact
