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
        const double slow =
            subsonic(Re[i], K[i], M[i], TpOverT[i], sqrtHalfGamma);
        const double fast =
            supersonic(Re[i], K[i], M[i], TpOverT[i], sqrtHalfGamma);
        result[i] = M[i] <= 1 ? slow : fast;
    }
}
