/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "freeMolecularSphere.H"

#include <cmath>

namespace
{

//- Coefficients of (-s^2)^n in (16/(3 sqrt(pi))) 1F1(-1/2; 5/2; -s^2)
struct series
{
    static constexpr int n = 18;

    double value[n];

    series()
    {
        value[0] = 16/(3*std::sqrt(M_PI));
        for (int i = 1; i < n; ++i)
        {
            value[i] = value[i - 1]*(i - 1.5)/((i + 1.5)*i);
        }
    }
};

const series kummer;

} // End anonymous namespace


double impact::freeMolecularSphere::sCd(double s, double TpOverT)
{
    const double s2 = s*s;
    double arriving;
    if (s < 1)
    {
        arriving = kummer.value[series::n - 1];
        for (int i = series::n - 2; i >= 0; --i)
        {
            arriving = kummer.value[i] - s2*arriving;
        }
    }
    else
    {
        const double inverse2 = 1/s2;
        arriving =
            (2 + inverse2)*std::exp(-s2)/std::sqrt(M_PI)
          + s*(2 + inverse2*(2 - 0.5*inverse2))*std::erf(s);
    }
    return arriving + 2./3*std::sqrt(M_PI*TpOverT);
}
