/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "hendersonKernels.H"
#include "elementary.H"
#include "vectorTargets.H"

impactKernel void impact::hendersonKernels::CdRe
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
    // As hendersonDrag::subsonic and supersonic, where the terms are explained
    for (int i = 0; i < n; ++i)
    {
        const double root = std::sqrt(K[i]);
        const double slow = K[i]*sqrtHalfGamma;
        const double slipping =
            (3.65 - 1.53*TpOverT[i])/(1 + 0.353*TpOverT[i])
           *exponential(-0.247/nonZero(slow));
        const double slip =
            slow*(slow > 0.247/40 ? 4.33 + slipping : 4.33);
        const double sqrtRe = std::sqrt(Re[i]);
        const double inertia = 0.03*Re[i] + 0.48*sqrtRe;
        const double M2 = M[i]*M[i];
        const double M4 = M2*M2;
        const double subsonic =
            24/(1 + slip)
          + Re[i]
           *(
                exponential(-0.5*K[i]*sqrtRe)
               *(
                    (4.5 + 0.38*inertia)/(1 + inertia)
                  + 0.1*M2
                  + 0.2*M4*M4
                )
              + (1 - exponential(-K[i]))*0.6*M[i]*sqrtHalfGamma
            );

        // M itself where this is wanted, and never 0
        const double fast = 1 + positivePart(M[i] - 1);
        const double S1 = 1/(fast*sqrtHalfGamma);
        const double S2 = S1*S1;
        const double rarefaction = 1.86*root;
        const double supersonic =
            Re[i]
           *(
                0.9 + 0.34/(fast*fast)
              + rarefaction
               *(2 + 2*S2 + 1.058*S1*std::sqrt(TpOverT[i]) - S2*S2)
            )
           /(1 + rarefaction);

        result[i] = M[i] <= 1 ? subsonic : supersonic;
    }
}
