/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorKernel.H"
#include "gradients.H"

namespace Foam
{
namespace
{

//- Neighbours by which values are asked for ahead of their use: on meshes that
//  have been cut and refined they lie anywhere in memory
constexpr int ahead = 24;


template<int nDim>
VECTOR_INLINE void gradients
(
    const leastSquaresLinks& links,
    const double* __restrict q,
    double* __restrict g
)
{
    constexpr int nVar = nDim + 2;
    const int* start = links.start;
    const int* neighbour = links.neighbour;
    const double* vectors = links.vectors;
    const int last = start[links.nCells] - 1;

    for (int c = 0; c < links.nCells; c++)
    {
        const double* own = q + c*nVar;
        double sum[nDim*nVar] = {};
        for (int i = start[c]; i < start[c + 1]; i++)
        {
            const int next = i + ahead < last ? i + ahead : last;
            __builtin_prefetch(q + neighbour[next]*nVar);

            const double* other = q + neighbour[i]*nVar;
            const double* vector = vectors + i*nDim;
            double jump[nVar];
            for (int k = 0; k < nVar; k++)
            {
                jump[k] = other[k] - own[k];
            }
            for (int d = 0; d < nDim; d++)
            {
                for (int k = 0; k < nVar; k++)
                {
                    sum[d*nVar + k] += vector[d]*jump[k];
                }
            }
        }
        for (int k = 0; k < nDim*nVar; k++)
        {
            g[c*(nDim*nVar) + k] = sum[k];
        }
    }
}


VECTOR_KERNEL void gradients2
(
    const leastSquaresLinks& links,
    const double* q,
    double* g
)
{
    gradients<2>(links, q, g);
}


VECTOR_KERNEL void gradients3
(
    const leastSquaresLinks& links,
    const double* q,
    double* g
)
{
    gradients<3>(links, q, g);
}

} // End anonymous namespace
} // End namespace Foam


void Foam::leastSquaresGradients
(
    const leastSquaresLinks& links,
    const int nDim,
    const double* q,
    double* g
)
{
    nDim == 2 ? gradients2(links, q, g) : gradients3(links, q, g);
}
