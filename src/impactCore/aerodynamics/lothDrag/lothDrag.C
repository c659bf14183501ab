/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "lothDrag.H"
#include "compressibleRange.H"
#include "elementary.H"
#include "freeMolecularSphere.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

double impact::lothDrag::rarefied
(
    double Re,
    double K,
    double M,
    double TpOverT
) const
{
    const double C1Re =
        24*(1 + 0.15*std::pow(Re, 0.687))/slipCorrection(KnOverK_*K);

    // M Cfm is finite at rest; so is Cfm/J, as J grows faster
    const double MCfm =
        freeMolecularSphere::sCd(sqrtHalfGamma_*M, TpOverT)/sqrtHalfGamma_;
    const double M2 = M*M;
    const double M3 = M2*M;
    const double J =
        M <= 1
      ? 0.14 + M2*(2.26*M - j1_)
      : 0.44 + M*(0.11 + M*(0.25 + 1.6*M));
    const double root = std::sqrt(Re/45);
    const double blend = 1 - root + root*MCfm*M2/J;

    // 0/0 at Re = 45 and M = 0
    return (C1Re + M3*Re*MCfm/nonZero(blend))/(1 + M3*M);
}


double impact::lothDrag::compressed(double Re, double M) const
{
    const double C =
        M < 1.5
      ? 1.65 + 0.65*std::tanh(4*M - 3.4)
      : 2.18 - c1_*std::tanh(0.9*M - 2.7);
    const double M2 = M*M;
    const double M3 = M2*M;
    const double G =
        M < 0.8 ? 20 + M*(-10.9 + M*(3.29 + 166*M)) : 5 + g0_/M3;
    const double H =
        M < 1 ? 1 + M*(-0.074 + M*(0.212 + 0.0239*M)) : h0_ + 1/(3.5 + M3*M2);

    // One logarithm for both powers
    const double logRe = std::log(Re);
    return
        24*(1 + 0.15*std::exp(0.687*logRe))*H
      + 0.42*C*Re
       /(1 + 42500*std::exp(-1.16*C*logRe) + G/std::sqrt(Re));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

impact::lothDrag::lothDrag(const coefficients& c)
:
    dragLawOf<lothDrag>(c.TpOverT)
{
    setGamma(compressibleRange::checkedGamma(c.gamma));
    if (c.form == "continuous")
    {
        j1_ = 0;
        c1_ = 0.12913149918318745;
        g0_ = 47.8093312;
        h0_ = 0.93967777777777772;
    }
    else
    {
        j1_ = 0.1;
        c1_ = 0.13;
        g0_ = 40;
        h0_ = 0.93;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void impact::lothDrag::setGamma(double gamma)
{
    sqrtHalfGamma_ = std::sqrt(0.5*gamma);
    KnOverK_ = std::sqrt(M_PI)*sqrtHalfGamma_;
}


double impact::lothDrag::of(double Re, double K, double TpOverT) const
{
    // All terms are at their limits long before
    const double M = std::min(K*Re, compressibleRange::highestMach);
    return Re <= 45 ? rarefied(Re, K, M, TpOverT) : compressed(Re, M);
}
