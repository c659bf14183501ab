/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "transferKernels.H"
#include "elementary.H"
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


impactKernel
void sumSpinLanes
(
    int n,
    const double* __restrict__ u,
    const double* __restrict__ v,
    const double* __restrict__ w,
    const double* __restrict__ mass,
    double up,
    double vp,
    double wp,
    double* __restrict__ lanes
)
{
    double all[width] = {}, x[width] = {}, y[width] = {}, z[width] = {};
    double xx[width] = {}, yy[width] = {}, zz[width] = {};
    double xy[width] = {}, xz[width] = {}, yz[width] = {};
    for (int i = 0; i < n; i += width)
    {
        for (int k = 0; k < width; ++k)
        {
            const double m = mass[i + k];
            const double du = u[i + k] - up;
            const double dv = v[i + k] - vp;
            const double dw = w[i + k] - wp;
            const double c = std::sqrt(du*du + dv*dv + dw*dw);
            const double perSpeed = m/impact::nonZero(c);
            all[k] += m;
            x[k] += m*du;
            y[k] += m*dv;
            z[k] += m*dw;
            xx[k] += perSpeed*du*du;
            yy[k] += perSpeed*dv*dv;
            zz[k] += perSpeed*dw*dw;
            xy[k] += perSpeed*du*dv;
            xz[k] += perSpeed*du*dw;
            yz[k] += perSpeed*dv*dw;
        }
    }
    for (int k = 0; k < width; ++k)
    {
        lanes[k] = all[k];
        lanes[width + k] = x[k];
        lanes[2*width + k] = y[k];
        lanes[3*width + k] = z[k];
        lanes[4*width + k] = xx[k];
        lanes[5*width + k] = yy[k];
        lanes[6*width + k] = zz[k];
        lanes[7*width + k] = xy[k];
        lanes[8*width + k] = xz[k];
        lanes[9*width + k] = yz[k];
    }
}


//- Add up the lanes of each sum
template<int n>
void addLanes(const double (&lanes)[n*width], double (&total)[n])
{
    for (int j = 0; j < n; ++j)
    {
        total[j] = 0;
        for (int k = 0; k < width; ++k)
        {
            total[j] += lanes[j*width + k];
        }
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
    addLanes(lanes, total);
    return {total[0], {total[1], total[2], total[3]}, total[4], total[5]};
}


impact::transferKernels::spinSums impact::transferKernels::sumSpin
(
    const molecules& gas,
    const double p[3]
)
{
    double lanes[10*width];
    sumSpinLanes
    (
        gas.n, gas.u, gas.v, gas.w, gas.mass, p[0], p[1], p[2], lanes
    );
    double t[10];
    addLanes(lanes, t);
    return
    {
        t[0], {t[1], t[2], t[3]}, {t[4], t[5], t[6], t[7], t[8], t[9]}
    };
}
