/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorKernel.H"
#include "expansion.H"

namespace Foam
{
namespace
{

template<int nDim>
VECTOR_INLINE void expansion(faceBlock& block, const int n, const double R)
{
    for (int i = 0; i < n; i++)
    {
        double across = 0, aroundOwner = 0, aroundFar = 0;
        for (int d = 0; d < nDim; d++)
        {
            const double normal = block.normal[d][i];
            across += (block.far[2 + d][i] - block.owner[2 + d][i])*normal;
            aroundOwner += block.slopeOwner[2 + d][i]*normal;
            aroundFar += block.slopeFar[2 + d][i]*normal;
        }
        const double apart =
            max(min(across, min(aroundOwner, aroundFar) - across), 0);
        const double small = 1e-3*(R*0.5*(block.owner[1][i] + block.far[1][i]));
        block.expands[i] = apart*apart/(apart*apart + small);
    }
}


VECTOR_KERNEL void expansion2(faceBlock& block, const int n, const double R)
{
    expansion<2>(block, n, R);
}


VECTOR_KERNEL void expansion3(faceBlock& block, const int n, const double R)
{
    expansion<3>(block, n, R);
}

} // End anonymous namespace
} // End namespace Foam


void Foam::faceExpansion
(
    faceBlock& block,
    const int n,
    const int nDim,
    const double R
)
{
    nDim == 2 ? expansion2(block, n, R) : expansion3(block, n, R);
}
