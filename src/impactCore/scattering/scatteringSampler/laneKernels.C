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
// the columns of the lanes with it brings nothing: the stores, at any address,
// take as long as those of single numbers.)

//- Does this machine have them?
const bool packs = __builtin_cpu_supports("x86-64-v4");


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
        const unsigned rest = n - i < 16 ? (1u << (n - i)) - 1 : 0xffffu;
        const __mmask16 m = _mm512_mask_cmpeq_epi32_mask
            (__mmask16(rest), _mm512_loadu_si512(mark + i), wanted);
        _mm512_storeu_si512
            (list + found, _mm512_maskz_compress_epi32(m, lane));
        found += __builtin_popcount(m);
        lane = _mm512_add_epi32(lane, step);
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
