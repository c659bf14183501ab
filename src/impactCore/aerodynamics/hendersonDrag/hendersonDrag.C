/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "hendersonDrag.H"

#include <algorithm>
#include <cmath>

namespace
{

// Cd*Re for M <= 1. Re and M vanish together with the relative speed; their
// ratio stays finite and only enters as S/Re, so all terms are written in it.
double subsonic(double Re, double M, double gamma, double TwOverT)
{
    const double S = M*std::sqrt(0.5*gamma);

    // Re/S in the exponent: infinite for M = 0, where S times it is zero
    const double slip =
        S > 0
      ? S
       *(
            4.33
          + (3.65 - 1.53*TwOverT)/(1 + 0.353*TwOverT)
           *std::exp(-std::min(0.247*Re/S, 700.0))
        )
      : 0;

    if (!(Re > 0))
    {
        // Relative motion without inertia: only the first term survives,
        // 24 Re/(Re + slip), which is 24 in the continuum (M = 0 as well)
        return S > 0 ? 0 : 24;
    }

    const double sqrtRe = std::sqrt(Re);
    const double inertia = 0.03*Re + 0.48*sqrtRe;
    const double M2 = M*M;

    return
        24*Re/(Re + slip)
      + Re
       *(
            std::exp(-std::min(0.5*M/sqrtRe, 700.0))
           *(
                (4.5 + 0.38*inertia)/(1 + inertia)
              + 0.1*M2
              + 0.2*M2*M2*M2*M2
            )
          - std::expm1(-std::min(M/Re, 700.0))*0.6*S
        );
}


// Cd*Re for M >= 1.75
double supersonic(double Re, double M, double gamma, double TwOverT)
{
    const double S = M*std::sqrt(0.5*gamma);
    const double rarefaction = 1.86*std::sqrt(M/std::max(Re, 1e-300));

    return
        Re
       *(
            0.9 + 0.34/(M*M)
          + rarefaction
           *(2 + 2/(S*S) + 1.058/S*std::sqrt(TwOverT) - 1/(S*S*S*S))
        )
       /(1 + rarefaction);
}

} // End anonymous namespace


double impact::hendersonCdRe
(
    double Re,
    double M,
    double gamma,
    double TwOverT
)
{
    if (M <= 1)
    {
        return subsonic(Re, M, gamma, TwOverT);
    }

    if (M >= 1.75)
    {
        return supersonic(Re, M, gamma, TwOverT);
    }

    const double w = (M - 1)/0.75;
    return
        (1 - w)*subsonic(Re, 1, gamma, TwOverT)
      + w*supersonic(Re, 1.75, gamma, TwOverT);
}
