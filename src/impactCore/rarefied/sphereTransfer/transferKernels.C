/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "transferKernels.H"
#include "vectorTargets.H"

#include <cmath>

namespace
{

using impact::transferKernels::width;

//- Lanes stay apart, so that vector code rounds as scalar code does
impactKernel
void sumLanes
(
    int n,
    const double* __restrict__ u,
    const double* __restrict__ v,
    const double* __restrict__ w,
    const double* __restrict__ internalEnergy,
    const double* __restrict__ mass,
    const double* __restrict__ rootMass,
    const double* __restrict__ reflected,
    double up,
    double vp,
    double wp,
    double a,
    double* __restrict__ lanes
)
{
    double drag[width] = {}, x[width] = {}, y[width] = {}, z[width] = {};
    double energy[width] = {}, cooling[width] = {};
    for (int i = 0; i < n; i += width)
    {
        for (int k = 0; k < width; ++k)
        {
            const double du = u[i + k] - up;
            const double dv = v[i + k] - vp;
            const double dw = w[i + k] - wp;
            const double c2 = du*du + dv*dv + dw*dw;
            const double c = std::sqrt(c2);
            const double m = mass[i + k];
            const double d = m*c + a*rootMass[i + k];
            drag[k] += d;
            x[k] += d*du;
            y[k] += d*dv;
            z[k] += d*dw;
            energy[k] += c*(0.5*m*c2 + internalEnergy[i + k]);
            cooling[k] += c*reflected[i + k];
        }
    }
    for (int k = 0; k < width; ++k)
    {
        lanes[k] = drag[k];
        lanes[width + k] = x[k];
        lanes[2*width + k] = y[k];
        lanes[3*width + k] = z[k];
        lanes[4*width + k] = energy[k];
        lanes[5*width + k] = cooling[k];
    }
}

} // End anonymous namespace


impact::transferKernels::sums impact::transferKernels::sum
(
    const molecules& gas,
    const double p[3],
    double a
)
{
    double lanes[6*width];
    sumLanes
    (
        gas.n, gas.u, gas.v, gas.w, gas.internalEnergy, gas.mass,
        gas.rootMass, gas.reflected, p[0], p[1], p[2], a, lanes
    );
    double total[6];
    for (int j = 0; j < 6; ++j)
    {
        total[j] = 0;
        for (int k = 0; k < width; ++k)
        {
            total[j] += lanes[j*width + k];
        }
    }
    return {total[0], {total[1], total[2], total[3]}, total[4], total[5]};
}
