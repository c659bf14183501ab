/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "nonSphericalDrag.H"

#include <cmath>

// * * * * * * * * * * * * * haiderLevenspielDrag  * * * * * * * * * * * * * //

impact::haiderLevenspielDrag::haiderLevenspielDrag(const coefficients& c)
:
    dragLawOf<haiderLevenspielDrag>(c.TpOverT)
{
    const double p = c.numbers.at("sphericity");
    A_ = std::exp(2.3288 + p*(-6.4581 + p*2.4486));
    B_ = 0.0964 + 0.5565*p;
    C_ = std::exp(4.905 + p*(-13.8944 + p*(18.4222 - p*10.2599)));
    D_ = std::exp(1.4681 + p*(12.2584 + p*(-20.7322 + p*15.8855)));
}


double impact::haiderLevenspielDrag::of(double Re, double, double) const
{
    return 24*(1 + A_*std::pow(Re, B_)) + C_*Re*(Re/(Re + D_));
}


// * * * * * * * * * * * * * holzerSommerfeldDrag  * * * * * * * * * * * * * //

impact::holzerSommerfeldDrag::holzerSommerfeldDrag(const coefficients& c)
:
    dragLawOf<holzerSommerfeldDrag>(c.TpOverT)
{
    const double p = c.numbers.at("sphericity");
    const double crosswise = c.numbers.at("crosswiseSphericity");
    const double lengthwise = c.numbers.at("lengthwiseSphericity");
    stokes_ = 8/std::sqrt(lengthwise) + 16/std::sqrt(p);
    transition_ = 3/std::pow(p, 0.75);
    newton_ =
        0.42*std::pow(10, 0.4*std::pow(-std::log10(p), 0.2))/crosswise;
}


double impact::holzerSommerfeldDrag::of(double Re, double, double) const
{
    return stokes_ + transition_*std::sqrt(Re) + newton_*Re;
}


// * * * * * * * * * * * * * * * * ganserDrag  * * * * * * * * * * * * * * * //

impact::ganserDrag::ganserDrag(const coefficients& c)
:
    dragLawOf<ganserDrag>(c.TpOverT)
{
    const double p = c.numbers.at("sphericity");
    const double dnOverdv = c.numbers.at("projectedDiameterRatio");
    K1_ = 3/(dnOverdv + 2/std::sqrt(p));
    K2_ = std::pow(10, 1.8148*std::pow(-std::log10(p), 0.5743));
}


double impact::ganserDrag::of(double Re, double, double) const
{
    const double X = Re*K1_*K2_;
    return
        24/K1_*(1 + 0.1118*std::pow(X, 0.6567))
      + 0.4305*K2_*Re*(X/(X + 3305));
}
