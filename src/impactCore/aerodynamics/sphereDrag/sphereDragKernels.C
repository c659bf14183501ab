/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "sphereDrag.H"
#include "vectorTargets.H"

namespace impact
{

impactKernel static void ofMany
(
    const int n,
    const double* __restrict__ Re,
    double* __restrict__ result
)
{
    for (int i = 0; i < n; ++i)
    {
        result[i] = sphereDrag::CdReOf(Re[i]);
    }
}


void sphereDrag::CdRe
(
    const int n,
    const double* Re,
    const double*,
    const double*,
    double* result
) const
{
    ofMany(n, Re, result);
}

} // End namespace impact
