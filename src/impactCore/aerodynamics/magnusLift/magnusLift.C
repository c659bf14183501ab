/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "magnusLift.H"

#include <cmath>

double impact::magnusLift::coefficient(double Re, double ReOmega)
{
    const double slow = 0.45*Re;

    // The second test keeps log() from zero and denormal numbers; the
    // exponential is 1 to rounding there
    if (ReOmega <= slow || Re < 1e-60 || ReOmega < 1e-60)
    {
        return 1;
    }

    const double share = slow/ReOmega;
    const double power =
        std::exp(0.4*std::log(ReOmega) + 0.3*std::log(Re));
    return share + (1 - share)*std::exp(-0.05684*power);
}
