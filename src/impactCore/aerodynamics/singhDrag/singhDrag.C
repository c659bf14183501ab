/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "singhDrag.H"
#include "compressibleRange.H"
#include "freeMolecularSphere.H"

#include <algorithm>
#include <cmath>

namespace
{
    constexpr double A0 = 24/(9.4*9.4);
    constexpr double a0 = 0.3555;

    //- The law is at its limit long before, and products would overflow
    constexpr double highestK = 1e100;

    //- Beyond it the denominator of C has a root in M > 1 (at gamma 2.1)
    constexpr double highestGamma = 2;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

impact::singhDrag::singhDrag(const coefficients& c)
:
    dragLawOf<singhDrag>(c.TpOverT),
    omega_(c.numbers.at("omega")),
    alphaHoc_(c.numbers.at("alphaHoc"))
{
    setGamma(compressibleRange::checkedGamma(c.gamma, highestGamma));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void impact::singhDrag::setGamma(double gamma)
{
    const double g1 = gamma - 1;
    gamma_ = gamma;
    sqrtHalfGamma_ = std::sqrt(0.5*gamma);
    KnOverK_ = std::sqrt(M_PI)*sqrtHalfGamma_;
    thetaExponent_ = gamma/g1;
    ReExponent_ = 0.5*(gamma + 1)/gamma - g1*omega_/gamma;
    C_ = 0.9 - A0*std::pow(1 + 0.25*g1*g1/gamma, thetaExponent_);
}


double impact::singhDrag::of(double Re, double K0, double TpOverT) const
{
    const double K = std::min(K0, highestK);
    const double M = std::min(K0*Re, compressibleRange::highestMach);
    const double M2 = M*M;
    const double g1 = gamma_ - 1;

    double Ms2 = M2;
    double pressure = 0;
    double ReRatio = 1;
    double hot = 1;
    if (M > 1)
    {
        const double behind = 2 + g1*M2;
        const double ahead = 2*gamma_*M2 - g1;
        const double U = behind/((gamma_ + 1)*M2);
        const double Ts = U*(ahead/(gamma_ + 1));
        const double a = 1/(1 + a0*(M - 1));
        Ms2 = behind/ahead;
        pressure = C_*(1 - a*U)/(1 - g1/((gamma_ + 1)*a0*M));
        ReRatio = std::pow(a*a*Ts, -omega_);
        hot = std::pow(1 + TpOverT/Ts, omega_);
    }

    const double theta = std::pow(1 + 0.5*g1*Ms2, thetaExponent_);
    const double sqrtRatio =
        std::sqrt(ReRatio*std::pow(theta, ReExponent_));
    const double sqrtRe = std::sqrt(Re) + 9.4/sqrtRatio;
    const double continuum = pressure*Re + A0*theta*sqrtRe*sqrtRe;

    // Written with K = M/Re nothing is divided by what vanishes at rest
    const double power = std::pow(M, 2*omega_ - 1);
    const double W = K*power*hot;
    const double BOverK = (power + 1)*hot;
    const double B = K*BOverK;
    const double B08 = std::pow(B, 0.8);
    const double f = 1/(slipCorrection(KnOverK_*K)*(1 + alphaHoc_*W));
    const double MCfm =
        freeMolecularSphere::sCd(sqrtHalfGamma_*M, TpOverT)/sqrtHalfGamma_;

    return (continuum*f + MCfm*BOverK*B08)/(1 + B*B08);
}
