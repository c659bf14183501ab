/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "hendersonFormulas.H"
#include "vectorTargets.H"

impactKernel void impact::hendersonFormulas::CdRe
(
    const int n,
    const double* __restrict__ Re,
    const double* __restrict__ K,
    const double* __restrict__ M,
    const double* __restrict__ TpOverT,
    const double sqrtHalfGamma,
    double* __restrict__ result
)
{
    for (int i = 0; i < n; ++i)
    {
        // The ends of the interpolation have this Re, hence another K
        const double perRe = 1/nonZero(Re[i]);
        const double Ms = M[i] < 1 ? M[i] : 1;
        const double Mf = M[i] > 1.75 ? M[i] : 1.75;
        const double Ks = M[i] > 1 ? perRe : K[i];
        const double Kf = M[i] < 1.75 ? 1.75*perRe : K[i];
        const double slow =
            subsonic(Re[i], Ks, Ms, TpOverT[i], sqrtHalfGamma);
        const double fast =
            supersonic(Re[i], Kf, Mf, TpOverT[i], sqrtHalfGamma);
        const double w = (M[i] - 1)/0.75;
        const double between = (1 - w)*slow + w*fast;
        const double first = M[i] <= 1 ? slow : between;
        result[i] = M[i] >= 1.75 ? fast : first;
    }
}
