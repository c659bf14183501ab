/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "hendersonDrag.H"

#include <cmath>
#include <stdexcept>
#include <string>

namespace
{

double checked(double value, double lower, const char* name)
{
    // A NaN in an ordered comparison would raise the trap it is refused for
    if (!std::isfinite(value) || value <= lower)
    {
        throw std::invalid_argument
        (
            std::string("hendersonDrag: ") + name + " = "
          + std::to_string(value) + " is outside the valid range ("
          + std::to_string(lower) + ", infinity)"
        );
    }
    return value;
}

} // End anonymous namespace


impact::hendersonDrag::hendersonDrag(double gamma, double TwOverT)
:
    sqrtHalfGamma_(std::sqrt(0.5*checked(gamma, 1, "gamma"))),
    sqrtTwOverT_(std::sqrt(checked(TwOverT, 0, "TwOverT"))),
    slipAmplitude_((3.65 - 1.53*TwOverT)/(1 + 0.353*TwOverT))
{}


double impact::hendersonDrag::subsonic(double Re, double K, double M) const
{
    // Below 0.247/40 the exponential is lost in the rounding of 4.33, and
    // near zero the quotient would overflow
    const double SOverRe = K*sqrtHalfGamma_;
    const double slip =
        SOverRe
       *(
            SOverRe > 0.247/40
          ? 4.33 + slipAmplitude_*std::exp(-0.247/SOverRe)
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


double impact::hendersonDrag::supersonic(double Re, double K, double M) const
{
    const double S1 = 1/(M*sqrtHalfGamma_);
    const double S2 = S1*S1;
    const double rarefaction = 1.86*std::sqrt(K);

    return
        Re
       *(
            0.9 + 0.34/(M*M)
          + rarefaction*(2 + 2*S2 + 1.058*S1*sqrtTwOverT_ - S2*S2)
        )
       /(1 + rarefaction);
}


double impact::hendersonDrag::CdRe(double Re, double K) const
{
    const double M = K*Re;

    if (M <= 1)
    {
        return subsonic(Re, K, M);
    }

    if (M >= 1.75)
    {
        return supersonic(Re, K, M);
    }

    // The ends of the interpolation have this Re, hence another K
    const double w = (M - 1)/0.75;
    return
        (1 - w)*subsonic(Re, 1/Re, 1)
      + w*supersonic(Re, 1.75/Re, 1.75);
}
