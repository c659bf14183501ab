/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "rotationalTorque.H"

double impact::rotationalTorque::remaining(double ReOmega, double t)
{
    if (ReOmega <= ReSlow)
    {
        return std::exp(-64*M_PI*t);
    }

    // With y = ReOmega^(-1/2) the law is linear:
    // dy/dt = (12.9 + 128.4 y)/2
    const double ratio = 12.9/128.4;
    const double y = 1/std::sqrt(ReOmega);
    const double tSlow =
        std::log((1/std::sqrt(ReSlow) + ratio)/(y + ratio))/64.2;

    if (t < tSlow)
    {
        const double yt = y + (y + ratio)*std::expm1(64.2*t);
        return y*y/(yt*yt);
    }
    return ReSlow/ReOmega*std::exp(-64*M_PI*(t - tSlow));
}
