/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "particleMotion.H"
#include "outOfRange.H"

#include <complex>

namespace
{

//- 1/n!
struct inverseFactorials
{
    double value[24];

    inverseFactorials()
    {
        value[0] = 1;
        for (int n = 1; n < 24; ++n)
        {
            value[n] = value[n - 1]/n;
        }
    }
};

const inverseFactorials inverse;


//- phi_1 ... phi_4 at z
template<class Number>
void phiFunctions(const Number& z, double magnitude, Number* phi)
{
    if (magnitude < 1)
    {
        // Down from the series of phi_4: upwards the differences would cancel
        Number sum = inverse.value[23];
        for (int n = 22; n >= 4; --n)
        {
            sum = sum*z + inverse.value[n];
        }
        phi[4] = sum;
        for (int j = 3; j >= 1; --j)
        {
            phi[j] = inverse.value[j] + z*phi[j + 1];
        }
    }
    else
    {
        phi[1] = (std::exp(z) - 1.)/z;
        for (int j = 2; j <= 4; ++j)
        {
            phi[j] = (phi[j - 1] - inverse.value[j - 1])/z;
        }
    }
}

} // End anonymous namespace


impact::particleMotion::frozenFlow::frozenFlow
(
    double k,
    const vector3& turn,
    double h
)
{
    phiFunctions<double>(-k*h, std::fabs(k*h), along_);

    const double rate = mag(turn);
    turns_ = rate*h > 1e-12;
    if (turns_)
    {
        // In the plane across the axis a vector is a complex number, and
        // dv/dt = -k v - turn x v is multiplication by -k - i |turn|
        const std::complex<double> z(-k*h, -rate*h);
        std::complex<double> phi[5];
        phiFunctions<std::complex<double>>(z, std::abs(z), phi);
        for (int j = 1; j <= 4; ++j)
        {
            across_[j] = phi[j].real();
            turned_[j] = phi[j].imag();
        }
        axis_ = (1/rate)*turn;
    }
}


impact::particleMotion::particleMotion(double tolerance)
:
    tolerance_(tolerance)
{
    checkRange("tolerance", tolerance, "[1e-14, 0.1]");
}
