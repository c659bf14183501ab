/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "laneKernels.H"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
    #include <immintrin.h>
    #define impactPacks
#endif

namespace
{

#ifdef impactPacks

// Compilers do not find the instruction that packs numbers themselves. (To pack
// columns of double precision with it brings nothing: the stores, at any
// address, take as long as those of single numbers.)

//- Does this machine have them?
const bool packs = __builtin_cpu_supports("x86-64-v4");


//- Which of 16 lanes, of which n count, have the mark
__attribute__((target("arch=x86-64-v4"))) inline __mmask16 markedVector
(
    int n,
    const int* mark,
    __m512i wanted
)
{
    const unsigned counted = n < 16 ? (1u << n) - 1 : 0xffffu;
    return _mm512_mask_cmpeq_epi32_mask
        (__mmask16(counted), _mm512_loadu_si512(mark), wanted);
}


__attribute__((target("arch=x86-64-v4"))) int findVector
(
    int n,
    const int* mark,
    int value,
    int* list
)
{
    const __m512i wanted = _mm512_set1_epi32(value);
    const __m512i step = _mm512_set1_epi32(16);
    __m512i lane = _mm512_setr_epi32
        (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    int found = 0;
    for (int i = 0; i < n; i += 16)
    {
        const __mmask16 m = markedVector(n - i, mark + i, wanted);
        _mm512_storeu_si512
            (list + found, _mm512_maskz_compress_epi32(m, lane));
        found += __builtin_popcount(m);
        lane = _mm512_add_epi32(lane, step);
    }
    return found;
}


__attribute__((target("arch=x86-64-v4"))) int packVector
(
    int n,
    const int* mark,
    int value,
    int columns,
    std::size_t stride,
    const int* from,
    int* to
)
{
    const __m512i wanted = _mm512_set1_epi32(value);
    const __m512i lane = _mm512_setr_epi32
        (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    int found = 0;
    for (int i = 0; i < n; i += 16)
    {
        const __mmask16 m = markedVector(n - i, mark + i, wanted);
        const __m512i places = _mm512_maskz_compress_epi32(m, lane);
        for (int c = 0; c < columns; ++c)
        {
            const __m512i x = _mm512_loadu_si512(from + c*stride + i);
            _mm512_storeu_si512
            (
                to + c*stride + found,
                _mm512_maskz_permutexvar_epi32(0xffff, places, x)
            );
        }
        found += __builtin_popcount(m);
    }
    return found;
}

#endif


int findPlain(int n, const int* mark, int value, int* list)
{
    int found = 0;
    for (int i = 0; i < n; ++i)
    {
        list[found] = i;
        found += mark[i] == value;
    }
    return found;
}


int packPlain
(
    int n,
    const int* mark,
    int value,
    int columns,
    std::size_t stride,
    const int* from,
    int* to
)
{
    // By pieces: no room is asked for
    const int piece = 256;
    int list[piece + 1];
    int found = 0;
    for (int i = 0; i < n; i += piece)
    {
        const int more =
            findPlain(n - i < piece ? n - i : piece, mark + i, value, list);
        for (int c = 0; c < columns; ++c)
        {
            for (int k = 0; k < more; ++k)
            {
                to[c*stride + found + k] = from[c*stride + i + list[k]];
            }
        }
        found += more;
    }
    return found;
}

} // End anonymous namespace


int impact::findLanes(int n, const int* mark, int value, int* list)
{
    #ifdef impactPacks
    if (packs)
    {
        return findVector(n, mark, value, list);
    }
    #endif
    return findPlain(n, mark, value, list);
}


int impact::packColumns
(
    int n,
    const int* mark,
    int value,
    int columns,
    std::size_t stride,
    const void* from,
    void* to
)
{
    const int* f = static_cast<const int*>(from);
    int* t = static_cast<int*>(to);
    #ifdef impactPacks
    if (packs)
    {
        return packVector(n, mark, value, columns, stride, f, t);
    }
    #endif
    return packPlain(n, mark, value, columns, stride, f, t);
}
