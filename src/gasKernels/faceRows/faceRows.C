/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorKernel.H"
#include "faceRows.H"

namespace Foam
{
namespace
{

//- Faces by which the values of cells are asked for ahead of their use: on
//  meshes that have been cut and refined they lie anywhere in memory
constexpr int facesAhead = 12;


//- Ask for n values
template<int n>
VECTOR_INLINE void fetch(const double* values)
{
    for (int i = 0; i < n; i += 8)
    {
        __builtin_prefetch(values + i);
    }
    __builtin_prefetch(values + n - 1);
}


//- Values of a cell and twice the change of its gradient along a way
template<int nDim>
VECTOR_INLINE void readSide
(
    const double* __restrict q,
    const double* __restrict g,
    const double* __restrict along,
    double* __restrict value,
    double* __restrict slope
)
{
    constexpr int nVar = nDim + 2;
    for (int k = 0; k < nVar; k++)
    {
        value[k] = q[k];
    }
    double change[nVar];
    for (int k = 0; k < nVar; k++)
    {
        change[k] = 2*along[0]*g[k];
    }
    for (int d = 1; d < nDim; d++)
    {
        for (int k = 0; k < nVar; k++)
        {
            change[k] += 2*along[d]*g[d*nVar + k];
        }
    }
    for (int k = 0; k < nVar; k++)
    {
        slope[k] = change[k];
    }
}


template<int nDim>
VECTOR_INLINE void readRows
(
    faceRows& rows,
    const faceLinks& faces,
    const int first,
    const int n,
    const double* q,
    const double* g
)
{
    constexpr int nVar = nDim + 2;
    const int* owner = faces.owner + first;
    const int* far = faces.far + first;
    const int last = faces.nFaces - 1 - first;
    for (int i = 0; i < n; i++)
    {
        if (faces.ahead)
        {
            const int next = i + facesAhead < last ? i + facesAhead : last;
            fetch<nVar>(q + owner[next]*nVar);
            fetch<nVar>(q + far[next]*nVar);
            fetch<nVar*nDim>(g + owner[next]*(nVar*nDim));
            fetch<nVar*nDim>(g + far[next]*(nVar*nDim));
        }
        readSide<nDim>
        (
            q + owner[i]*nVar,
            g + owner[i]*(nVar*nDim),
            faces.alongOwner + (first + i)*nDim,
            rows.owner + i*nVar,
            rows.slopeOwner + i*nVar
        );
        readSide<nDim>
        (
            q + far[i]*nVar,
            g + far[i]*(nVar*nDim),
            faces.alongFar + (first + i)*nDim,
            rows.far + i*nVar,
            rows.slopeFar + i*nVar
        );
    }
}


//- Rows of m values become columns
template<int m>
VECTOR_INLINE void turn
(
    const double* __restrict rows,
    const int n,
    double (*__restrict columns)[faceBlock::size]
)
{
    for (int i = 0; i < n; i++)
    {
        for (int k = 0; k < m; k++)
        {
            columns[k][i] = rows[i*m + k];
        }
    }
}


template<int nDim>
VECTOR_INLINE void turnRows
(
    const faceRows& rows,
    const double* normal,
    const int n,
    faceBlock& block
)
{
    turn<nDim + 2>(rows.owner, n, block.owner);
    turn<nDim + 2>(rows.far, n, block.far);
    turn<nDim + 2>(rows.slopeOwner, n, block.slopeOwner);
    turn<nDim + 2>(rows.slopeFar, n, block.slopeFar);
    turn<nDim>(normal, n, block.normal);
}


#define makeRows(nDim)                                                         \
    VECTOR_KERNEL                                                              \
    void read##nDim                                                            \
    (                                                                          \
        faceRows& rows,                                                        \
        const faceLinks& faces,                                                \
        const int first,                                                       \
        const int n,                                                           \
        const double* q,                                                       \
        const double* g                                                        \
    )                                                                          \
    {                                                                          \
        readRows<nDim>(rows, faces, first, n, q, g);                           \
    }                                                                          \
                                                                               \
    VECTOR_KERNEL                                                              \
    void turn##nDim                                                            \
    (                                                                          \
        const faceRows& rows,                                                  \
        const double* normal,                                                  \
        const int n,                                                           \
        faceBlock& block                                                       \
    )                                                                          \
    {                                                                          \
        turnRows<nDim>(rows, normal, n, block);                                \
    }

makeRows(2)
makeRows(3)

#undef makeRows

} // End anonymous namespace
} // End namespace Foam


void Foam::faceRows::read
(
    const faceLinks& faces,
    const int nDim,
    const int first,
    const int n,
    const double* q,
    const double* g
)
{
    nDim == 2
  ? read2(*this, faces, first, n, q, g)
  : read3(*this, faces, first, n, q, g);
}


void Foam::faceRows::turnOver
(
    const faceLinks& faces,
    const int nDim,
    const int first,
    const int n,
    faceBlock& block
) const
{
    const double* normal = faces.normal + first*nDim;
    nDim == 2 ? turn2(*this, normal, n, block) : turn3(*this, normal, n, block);
}
