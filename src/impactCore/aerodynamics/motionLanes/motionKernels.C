/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "motionKernels.H"
#include "elementary.H"
#include "vectorTargets.H"

#include <cmath>

namespace
{

using impact::motionKernels::row;

impactInline double larger(double a, double b)
{
    return a > b ? a : b;
}

//- Largest component, as the error control measures
impactInline double largest(double x, double y, double z)
{
    return larger(std::fabs(x), larger(std::fabs(y), std::fabs(z)));
}

impactInline double largest(const row (&q)[3], int i)
{
    return largest(q[0][i], q[1][i], q[2][i]);
}

impactInline double largestGap(const row (&a)[3], const row (&b)[3], int i)
{
    return largest(a[0][i] - b[0][i], a[1][i] - b[1][i], a[2][i] - b[2][i]);
}

impactInline double length(double x, double y, double z)
{
    return std::sqrt(x*x + y*y + z*z);
}

impactInline double length(const row (&q)[3], int i)
{
    return length(q[0][i], q[1][i], q[2][i]);
}

impactInline double gap(const row (&a)[3], const row (&b)[3], int i)
{
    return length(a[0][i] - b[0][i], a[1][i] - b[1][i], a[2][i] - b[2][i]);
}

//- What a rate changes in a step that may be long for its relaxation k
impactInline double gain(double rate, double k, double h)
{
    // The larger of h k and 1 without a selection, of which a compiler would
    // divide by both sides, zero among them
    return rate*h/(1 + impact::positivePart(h*k - 1));
}

} // End namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

impactKernel void impact::motionKernels::gas
(
    const int n,
    const linearGas* const* __restrict__ fields,
    const row (&__restrict__ x)[3],
    gasRows& __restrict__ g
)
{
    constexpr int nValues = linearGas::nValues;
    for (int i = 0; i < n; ++i)
    {
        const linearGas& f = *fields[i];
        const double rx = x[0][i] - f.centre.x;
        const double ry = x[1][i] - f.centre.y;
        const double rz = x[2][i] - f.centre.z;
        const double* value = &f.value.u.x;
        const auto at = [&](int k)
        {
            return
                value[k] + f.slope[0][k]*rx + f.slope[1][k]*ry
              + f.slope[2][k]*rz;
        };

        // Eight at a time are a vector, nine would be taken one by one
        double q[nValues];
        #pragma GCC unroll 1
        for (int k = 0; k < 8; ++k)
        {
            q[k] = at(k);
        }
        q[8] = at(8);
        for (int k = 0; k < 3; ++k)
        {
            g.u[k][i] = q[k];
            g.spin[k][i] = q[3 + k];
        }
        g.rho[i] = larger(q[6], f.minima[0]);
        g.mu[i] = larger(q[7], f.minima[1]);
        g.T[i] = larger(q[8], f.minima[2]);
    }
}


impactKernel void impact::motionKernels::reynolds
(
    const int n,
    const gasRows& __restrict__ gas,
    const stateRows& __restrict__ s,
    const row& __restrict__ d,
    const double gammaR,
    numbers& __restrict__ q
)
{
    for (int i = 0; i < n; ++i)
    {
        const double ReOverSpeed = d[i]*gas.rho[i]/gas.mu[i];
        q.Re[i] = ReOverSpeed*gap(gas.u, s.v, i);
        q.K[i] = 1/(ReOverSpeed*std::sqrt(gammaR*gas.T[i]));
        q.ReOmega[i] = ReOverSpeed*d[i]*gap(gas.spin, s.omega, i);
    }
}


impactKernel void impact::motionKernels::rates
(
    const int n,
    const gasRows& __restrict__ gas,
    const stateRows& __restrict__ s,
    const constantRows& __restrict__ q,
    const row& __restrict__ CdRe,
    const row& __restrict__ magnus,
    const row& __restrict__ clRe,
    const vector3& __restrict__ g,
    const vector3& __restrict__ solved,
    const vector3& __restrict__ rotation,
    rateRows& __restrict__ r
)
{
    const vector3 gravity = g, keep = solved, keepSpin = rotation;
    for (int i = 0; i < n; ++i)
    {
        const double density = gas.rho[i]*q.inverseRhoP[i];
        const double k = q.drag0[i]*gas.mu[i]*CdRe[i];
        const double kSpin = q.torque0[i]*gas.mu[i]*clRe[i];
        const double c = 0.75*density*magnus[i];
        const double wx = gas.u[0][i] - s.v[0][i];
        const double wy = gas.u[1][i] - s.v[1][i];
        const double wz = gas.u[2][i] - s.v[2][i];
        const double Wx = gas.spin[0][i] - s.omega[0][i];
        const double Wy = gas.spin[1][i] - s.omega[1][i];
        const double Wz = gas.spin[2][i] - s.omega[2][i];
        const double tx = c*Wx, ty = c*Wy, tz = c*Wz;
        const double buoyant = 1 - density;
        r.k[i] = k;
        r.kSpin[i] = kSpin;
        r.a[0][i] = keep.x*(buoyant*gravity.x + k*wx + (ty*wz - tz*wy));
        r.a[1][i] = keep.y*(buoyant*gravity.y + k*wy + (tz*wx - tx*wz));
        r.a[2][i] = keep.z*(buoyant*gravity.z + k*wz + (tx*wy - ty*wx));
        r.turn[0][i] = keepSpin.x*tx;
        r.turn[1][i] = keepSpin.y*ty;
        r.turn[2][i] = keepSpin.z*tz;
        r.alpha[0][i] = kSpin*Wx;
        r.alpha[1][i] = kSpin*Wy;
        r.alpha[2][i] = kSpin*Wz;
    }
}


impactKernel void impact::motionKernels::stretch
(
    const int n,
    const stateRows& __restrict__ start,
    const rateRows& __restrict__ f,
    const row& __restrict__ hMax,
    const row& __restrict__ hTry,
    row& __restrict__ h,
    stateRows& __restrict__ middle,
    row (&__restrict__ place)[3]
)
{
    for (int i = 0; i < n; ++i)
    {
        h[i] = hMax[i] < hTry[i] ? hMax[i] : hTry[i];
        middle.h[i] = start.h[i] + h[i]*(1./5)*f.hDot[i];
    }
    for (int c = 0; c < 3; ++c)
    {
        for (int i = 0; i < n; ++i)
        {
            const double w = h[i]*(1./5);
            middle.x[c][i] = w*start.v[c][i];
            place[c][i] = start.x[c][i] + middle.x[c][i];
            middle.v[c][i] = start.v[c][i] + w*f.a[c][i];
            middle.omega[c][i] = start.omega[c][i] + w*f.alpha[c][i];
        }
    }
}


impactKernel void impact::motionKernels::end
(
    const int n,
    const gasRows& __restrict__ gas,
    const stateRows& __restrict__ start,
    const rateRows& __restrict__ f,
    const stateRows& __restrict__ middle,
    const rateRows& __restrict__ g,
    const row& __restrict__ h,
    const double tolerance,
    stateRows& __restrict__ last,
    scaleRows& __restrict__ scales,
    row& __restrict__ worst,
    row& __restrict__ power,
    row& __restrict__ accepted,
    row& __restrict__ more
)
{
    for (int c = 0; c < 3; ++c)
    {
        for (int i = 0; i < n; ++i)
        {
            const double w0 = h[i]*(-3./2), w1 = h[i]*(5./2);
            last.x[c][i] = w0*start.v[c][i] + w1*middle.v[c][i];
            last.v[c][i] = start.v[c][i] + w0*f.a[c][i] + w1*g.a[c][i];
            last.omega[c][i] =
                start.omega[c][i] + w0*f.alpha[c][i] + w1*g.alpha[c][i];
        }
    }
    for (int i = 0; i < n; ++i)
    {
        const double sizeA = largest(f.a, i);
        const double sizeAlpha = largest(f.alpha, i);
        const double speed = larger(largest(start.v, i), length(gas.u, i));
        const double spin =
            larger(largest(start.omega, i), length(gas.spin, i));
        scales.v[i] = larger(speed, gain(sizeA, f.k[i], h[i])) + 1e-100;
        scales.omega[i] = larger
        (
            spin,
            larger(gain(sizeAlpha, f.kSpin[i], h[i]), particleMotion::noSpin)
        );
        const double dv = largest
        (
            last.v[0][i] - (start.v[0][i] + h[i]*f.a[0][i]),
            last.v[1][i] - (start.v[1][i] + h[i]*f.a[1][i]),
            last.v[2][i] - (start.v[2][i] + h[i]*f.a[2][i])
        );
        const double dOmega = largest
        (
            last.omega[0][i] - (start.omega[0][i] + h[i]*f.alpha[0][i]),
            last.omega[1][i] - (start.omega[1][i] + h[i]*f.alpha[1][i]),
            last.omega[2][i] - (start.omega[2][i] + h[i]*f.alpha[2][i])
        );
        last.h[i] =
            start.h[i] + h[i]*(-3./2)*f.hDot[i] + h[i]*(5./2)*g.hDot[i];
        scales.h[i] =
            larger
            (
                start.h[i], gain(std::fabs(f.hDot[i]), f.kHeat[i], h[i])
            ) + 1e-100;
        const double dh =
            std::fabs(last.h[i] - (start.h[i] + h[i]*f.hDot[i]));
        const double first = larger
        (
            larger(dv/scales.v[i], dOmega/scales.omega[i]), dh/scales.h[i]
        )/tolerance;

        // Errors of orders 1 and 5: see particleMotion::step
        const double first2 = first*tolerance;
        const bool hopeless = first2*first2*first2 > tolerance;
        const double fastest = larger
        (
            larger(larger(f.k[i], f.kSpin[i]), f.kHeat[i]),
            largest(f.turn, i)
        );
        const double heatChange =
            std::fabs(g.hDot[i] - f.hDot[i])/(std::fabs(f.hDot[i]) + 1e-100);
        const double motionChange = larger
        (
            largestGap(g.a, f.a, i)/(sizeA + 1e-100),
            largestGap(g.alpha, f.alpha, i)/(sizeAlpha + 1e-100)
        );
        const double change = 5*larger(motionChange, heatChange);
        const double share = 2*larger(change, h[i]*fastest);
        const double better = first*(share < 1 ? share : 1);
        const bool large = first > 1;
        worst[i] = large ? better : first;
        power[i] = large ? 1./3 : 1./2;
        const bool small = worst[i] <= 1;
        const bool soft = h[i]*fastest <= 1.5;
        accepted[i] = small & soft & !hopeless ? 1 : 0;
        more[i] = worst[i] > 1 && soft && !hopeless ? 1 : 0;
    }
}


impactKernel void impact::motionKernels::sum
(
    const int n,
    const stateRows& __restrict__ start,
    const row& __restrict__ h,
    const row (* __restrict__ kx)[3],
    const rateRows* __restrict__ k,
    const double* __restrict__ weights,
    const int nSlopes,
    stateRows& __restrict__ s
)
{
    for (int i = 0; i < n; ++i)
    {
        s.h[i] = start.h[i];
    }
    for (int j = 0; j < nSlopes; ++j)
    {
        const double weight = weights[j];
        for (int i = 0; i < n; ++i)
        {
            s.h[i] += h[i]*weight*k[j].hDot[i];
        }
    }
    for (int c = 0; c < 3; ++c)
    {
        for (int i = 0; i < n; ++i)
        {
            s.x[c][i] = 0;
            s.v[c][i] = start.v[c][i];
            s.omega[c][i] = start.omega[c][i];
        }
        for (int j = 0; j < nSlopes; ++j)
        {
            const double weight = weights[j];
            for (int i = 0; i < n; ++i)
            {
                const double w = h[i]*weight;
                s.x[c][i] += w*kx[j][c][i];
                s.v[c][i] += w*k[j].a[c][i];
                s.omega[c][i] += w*k[j].alpha[c][i];
            }
        }
    }
}


impactKernel void impact::motionKernels::error
(
    const int n,
    const stateRows& __restrict__ a,
    const stateRows& __restrict__ b,
    const scaleRows& __restrict__ scales,
    const double tolerance,
    row& __restrict__ worst
)
{
    for (int i = 0; i < n; ++i)
    {
        const double motion = larger
        (
            largestGap(a.v, b.v, i)/scales.v[i],
            largestGap(a.omega, b.omega, i)/scales.omega[i]
        );
        worst[i] =
            larger(motion, std::fabs(a.h[i] - b.h[i])/scales.h[i])/tolerance;
    }
}
