/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Vectors of a Krylov space, of lengths that are no multiple of a piece nor
    of a vector register.
\*---------------------------------------------------------------------------*/

#include "krylovBasis.H"
#include "randomNumbers.H"
#include "largest.H"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <random>

namespace
{

typedef std::vector<double> numbers;


double dot(const numbers& a, const numbers& b)
{
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); k++)
    {
        sum += a[k]*b[k];
    }
    return sum;
}


void alone(double*, int)
{}

} // End anonymous namespace


TEST(krylovBasis, becomesOrthonormal)
{
    const int m = 30;
    for (const int n : {37, 2048, 5003})
    {
        std::mt19937 random(n);
        Foam::krylovBasis basis;
        double rebuilt = 0;
        for (int i = 0; i < m; i++)
        {
            // Nearly along the one before, as with a good preconditioner
            numbers w(randomNumbers(random, n));
            if (i > 0)
            {
                numbers last(n);
                basis.get(i - 1, last);
                for (int k = 0; k < n; k++)
                {
                    w[k] = 0.1*w[k] + 30*last[k];
                }
            }
            const numbers before(w);
            numbers h(i + 1);
            basis.remove(i, w, h.data(), alone);
            basis.set(i, w, h[i]);

            // The coefficients give back what was there
            numbers sum(n, 0.0);
            basis.add(i + 1, 1, h.data(), sum);
            for (int k = 0; k < n; k++)
            {
                rebuilt = largest(rebuilt, std::fabs(sum[k] - before[k]));
            }
        }
        double worst = 0;
        numbers a(n), b(n);
        for (int i = 0; i < m; i++)
        {
            basis.get(i, a);
            for (int j = 0; j <= i; j++)
            {
                basis.get(j, b);
                worst = largest(worst, std::fabs(dot(a, b) - (i == j)));
            }
        }
        EXPECT_LT(worst, 1e-5) << "n = " << n;
        EXPECT_LT(rebuilt, 1e-5) << "n = " << n;
    }
}


TEST(krylovBasis, addsShares)
{
    for (const int n : {1, 8, 2047, 2049, 6001})
    {
        std::mt19937 random(n);
        Foam::krylovBasis basis;
        std::vector<numbers> v;
        for (int i = 0; i < 3; i++)
        {
            v.push_back(randomNumbers(random, n));
            basis.set(i, v[i], 2);
        }
        const numbers w(randomNumbers(random, n));
        const double y[3] = {1, -2, 0.5};
        numbers sum(w);
        basis.add(3, 4, y, sum);
        for (int k = 0; k < n; k++)
        {
            const double expected =
                w[k] + 2*(v[0][k] - 2*v[1][k] + 0.5*v[2][k]);
            ASSERT_NEAR(sum[k], expected, 3e-6) << n << ", " << k;
        }
    }
}
