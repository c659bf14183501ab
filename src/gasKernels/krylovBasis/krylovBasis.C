/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorKernel.H"
#include "krylovBasis.H"

#include <algorithm>
#include <cmath>

namespace Foam
{
namespace
{

//- Numbers of a vector at a time
constexpr int piece = 2048;


//- Eight sums side by side: a single one would wait for itself
template<class Type>
VECTOR_INLINE double sumOfProducts(const Type* b, const double* w, const int n)
{
    constexpr int lanes = 8;
    double sums[lanes] = {};
    const int whole = n - n%lanes;
    for (int k = 0; k < whole; k += lanes)
    {
        for (int j = 0; j < lanes; j++)
        {
            sums[j] += b[k + j]*w[k + j];
        }
    }
    for (int k = whole; k < n; k++)
    {
        sums[0] += b[k]*w[k];
    }
    double sum = 0;
    for (int j = 0; j < lanes; j++)
    {
        sum += sums[j];
    }
    return sum;
}


VECTOR_KERNEL double product(const float* b, const double* w, const int n)
{
    return sumOfProducts(b, w, n);
}


VECTOR_KERNEL double product(const double* b, const double* w, const int n)
{
    return sumOfProducts(b, w, n);
}


VECTOR_KERNEL void addTo
(
    double* w,
    const double h,
    const float* b,
    const int n
)
{
    for (int k = 0; k < n; k++)
    {
        w[k] += h*b[k];
    }
}


//- Call visit(start, length) for one piece of a vector after the other
template<class Visitor>
void pieces(const std::vector<double>& w, const Visitor& visit)
{
    const int size = int(w.size());
    for (int start = 0; start < size; start += piece)
    {
        visit(start, std::min(piece, size - start));
    }
}

} // End anonymous namespace
} // End namespace Foam


double Foam::krylovBasis::dot
(
    const std::vector<double>& a,
    const std::vector<double>& b
)
{
    return product(a.data(), b.data(), int(a.size()));
}


void Foam::krylovBasis::set
(
    const int i,
    const std::vector<double>& v,
    const double length
)
{
    if (int(vectors_.size()) <= i)
    {
        vectors_.resize(i + 1);
    }
    std::vector<float>& b = vectors_[i];
    b.resize(v.size());
    const double share = 1/length;
    for (std::size_t k = 0; k < v.size(); k++)
    {
        b[k] = float(share*v[k]);
    }
}


void Foam::krylovBasis::get(const int i, std::vector<double>& v) const
{
    std::copy(vectors_[i].begin(), vectors_[i].end(), v.begin());
}


void Foam::krylovBasis::products
(
    const int n,
    const std::vector<double>& w,
    double* h
) const
{
    std::fill_n(h, n, 0.0);
    pieces
    (
        w,
        [&](const int start, const int length)
        {
            for (int i = 0; i < n; i++)
            {
                h[i] += product(&vectors_[i][start], &w[start], length);
            }
        }
    );
}


void Foam::krylovBasis::remove
(
    const int n,
    std::vector<double>& w,
    double* h,
    const sumOverRanks& sum
) const
{
    std::vector<double> part(n);
    std::fill_n(h, n + 1, 0.0);
    for (int pass = 0; pass < 2; pass++)
    {
        products(n, w, part.data());
        sum(part.data(), n);
        add(n, -1, part.data(), w);
        double taken = 0;
        for (int i = 0; i < n; i++)
        {
            taken += part[i]*part[i];
            h[i] += part[i];
        }
        double left = dot(w, w);
        sum(&left, 1);
        h[n] = std::sqrt(left);
        if (left > 0.1*taken)
        {
            return;
        }
    }
}


void Foam::krylovBasis::add
(
    const int n,
    const double share,
    const double* h,
    std::vector<double>& w
) const
{
    pieces
    (
        w,
        [&](const int start, const int length)
        {
            for (int i = 0; i < n; i++)
            {
                addTo
                (
                    &w[start], share*h[i], &vectors_[i][start], length
                );
            }
        }
    );
}
