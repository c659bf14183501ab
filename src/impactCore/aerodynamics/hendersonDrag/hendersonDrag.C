/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "hendersonDrag.H"
#include "compressibleRange.H"
#include "hendersonFormulas.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

impact::hendersonDrag::hendersonDrag(double gamma, double TpOverT)
:
    dragLawOf<hendersonDrag>(TpOverT)
{
    setGamma(compressibleRange::checkedGamma(gamma));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void impact::hendersonDrag::setGamma(double gamma)
{
    sqrtHalfGamma_ = std::sqrt(0.5*gamma);
}


double impact::hendersonDrag::of(double Re, double K, double ratio) const
{
    // From 5285 on the slip correction of the fit would turn negative
    const double TpOverT = std::min(ratio, compressibleRange::highestTpOverT);

    // All terms are at their limits long before
    const double M = std::min(K*Re, compressibleRange::highestMach);

    const double s = sqrtHalfGamma_;
    if (M <= 1)
    {
        return hendersonFormulas::subsonic(Re, K, M, TpOverT, s);
    }

    if (M >= 1.75)
    {
        return hendersonFormulas::supersonic(Re, K, M, TpOverT, s);
    }

    // The ends of the interpolation have this Re, hence another K
    const double w = (M - 1)/0.75;
    return
        (1 - w)*hendersonFormulas::subsonic(Re, 1/Re, 1, TpOverT, s)
      + w*hendersonFormulas::supersonic(Re, 1.75/Re, 1.75, TpOverT, s);
}


void impact::hendersonDrag::CdRe
(
    int n,
    const double* Re,
    const double* K,
    const double* TpOverT,
    double* result
) const
{
    constexpr int size = 64;
    double M[size], ratio[size];
    for (int from = 0; from < n; from += size)
    {
        const int m = std::min(size, n - from);
        for (int i = 0; i < m; ++i)
        {
            const int j = from + i;
            M[i] = std::min(K[j]*Re[j], compressibleRange::highestMach);
            ratio[i] = std::min
            (
                TpOverT ? TpOverT[j] : this->TpOverT(),
                compressibleRange::highestTpOverT
            );
        }
        hendersonFormulas::CdRe
        (
            m, Re + from, K + from, M, ratio, sqrtHalfGamma_, result + from
        );
    }
}
