/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "hendersonDrag.H"
#include "compressibleRange.H"
#include "hendersonKernels.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

double impact::hendersonDrag::subsonic
(
    double Re,
    double K,
    double M,
    double TpOverT
) const
{
    const double slipAmplitude =
        (3.65 - 1.53*TpOverT)/(1 + 0.353*TpOverT);

    // Below 0.247/40 the exponential is lost in the rounding of 4.33, and
    // near zero the quotient would overflow
    const double SOverRe = K*sqrtHalfGamma_;
    const double slip =
        SOverRe
       *(
            SOverRe > 0.247/40
          ? 4.33 + slipAmplitude*std::exp(-0.247/SOverRe)
          : 4.33
        );

    const double sqrtRe = std::sqrt(Re);
    const double inertia = 0.03*Re + 0.48*sqrtRe;
    const double M2 = M*M;
    const double M4 = M2*M2;

    return
        24/(1 + slip)
      + Re
       *(
            std::exp(-0.5*K*sqrtRe)
           *(
                (4.5 + 0.38*inertia)/(1 + inertia)
              + 0.1*M2
              + 0.2*M4*M4
            )
          - std::expm1(-K)*0.6*M*sqrtHalfGamma_
        );
}


double impact::hendersonDrag::supersonic
(
    double Re,
    double K,
    double M,
    double TpOverT
) const
{
    const double S1 = 1/(M*sqrtHalfGamma_);
    const double S2 = S1*S1;
    const double rarefaction = 1.86*std::sqrt(K);

    return
        Re
       *(
            0.9 + 0.34/(M*M)
          + rarefaction*(2 + 2*S2 + 1.058*S1*std::sqrt(TpOverT) - S2*S2)
        )
       /(1 + rarefaction);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

impact::hendersonDrag::hendersonDrag(double gamma, double TpOverT)
:
    dragLawOf<hendersonDrag>(TpOverT),
    sqrtHalfGamma_(std::sqrt(0.5*compressibleRange::checkedGamma(gamma)))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double impact::hendersonDrag::of(double Re, double K, double ratio) const
{
    // From 5285 on the slip correction of the fit would turn negative
    const double TpOverT = std::min(ratio, compressibleRange::highestTpOverT);

    // All terms are at their limits long before
    const double M = std::min(K*Re, compressibleRange::highestMach);

    if (M <= 1)
    {
        return subsonic(Re, K, M, TpOverT);
    }

    if (M >= 1.75)
    {
        return supersonic(Re, K, M, TpOverT);
    }

    // The ends of the interpolation have this Re, hence another K
    const double w = (M - 1)/0.75;
    return
        (1 - w)*subsonic(Re, 1/Re, 1, TpOverT)
      + w*supersonic(Re, 1.75/Re, 1.75, TpOverT);
}


impact::hendersonDrag impact::hendersonDrag::in(double gamma) const
{
    hendersonDrag law(*this);
    law.sqrtHalfGamma_ = std::sqrt(0.5*gamma);
    return law;
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
        hendersonKernels::CdRe
        (
            m, Re + from, K + from, M, ratio, sqrtHalfGamma_, result + from
        );
        for (int i = 0; i < m; ++i)
        {
            if (M[i] > 1 && M[i] < 1.75)
            {
                result[from + i] = of(Re[from + i], K[from + i], ratio[i]);
            }
        }
    }
}
