/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorTargets.H"

#include "scatteringKernels.H"
#include "elementary.H"

namespace impact
{

impactKernel void directionAngles
(
    int n,
    const double* __restrict__ Vx,
    const double* __restrict__ Vy,
    const double* __restrict__ Vz,
    double reference,
    double binsPerDegree,
    int nBins,
    double* __restrict__ alpha,
    double* __restrict__ beta,
    int* __restrict__ bin
)
{
    const double scale = 57.295779513082323*binsPerDegree;
    for (int i = 0; i < n; ++i)
    {
        const double x = Vx[i];
        const double y = Vy[i];
        const double z = Vz[i];

        // A body at rest has no direction: it counts as leaving along x
        const double a = arcTan2(y, x);
        const double b = arcTan2(z, std::sqrt(x*x + y*y));
        alpha[i] = a - reference;
        beta[i] = b;
        int p = int(a*scale);
        int q = int(b*scale + 0.5*nBins);
        p = p < nBins ? p : nBins - 1;
        q = q < nBins ? q : nBins - 1;
        q = q < 0 ? 0 : q;
        bin[i] = a >= 0 ? p*nBins + q : nBins*nBins;
    }
}


impactKernel void sumAndSquares
(
    int n,
    const double* __restrict__ x,
    double& sum,
    double& squares
)
{
    // Eight sums, added in this order on every machine
    constexpr int lanes = 8;
    double s[lanes] = {}, q[lanes] = {};
    const int whole = n/lanes*lanes;
    for (int i = 0; i < whole; i += lanes)
    {
        for (int k = 0; k < lanes; ++k)
        {
            s[k] += x[i + k];
            q[k] += x[i + k]*x[i + k];
        }
    }
    sum = squares = 0;
    for (int i = whole; i < n; ++i)
    {
        sum += x[i];
        squares += x[i]*x[i];
    }
    for (int k = 0; k < lanes; ++k)
    {
        sum += s[k];
        squares += q[k];
    }
}

} // End namespace impact
