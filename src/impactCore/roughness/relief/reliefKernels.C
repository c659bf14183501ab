/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorTargets.H"

#include "relief.H"
#include "elementary.H"
#include "philoxLanes.H"

#include <algorithm>

namespace impact
{

impactKernel void drawKnots
(
    std::uint64_t seed,
    std::uint64_t identity,
    std::int64_t i0,
    int n,
    double meanSpacing,
    double sigmaSpacing,
    double sigmaHeight,
    double* __restrict__ spacing,
    double* __restrict__ height
)
{
    for (int i = 0; i < n; ++i)
    {
        std::uint64_t w0, w1, w2, w3;
        philoxLane
        (
            seed, std::uint32_t(i0 + i), drawPurpose::knots, identity,
            w0, w1, w2, w3
        );
        const double u = unitOf((w0 << 20) | (w1 >> 12));
        const double v = unitOf((w2 << 20) | (w3 >> 12));
        spacing[i] = meanSpacing + sigmaSpacing*truncatedNormal(u);
        height[i] = sigmaHeight*truncatedNormal(v);
    }
}


impactKernel void splineMoments
(
    int n,
    const double* __restrict__ spacing,
    const double* __restrict__ height,
    double* __restrict__ moment,
    double* __restrict__ work
)
{
    // Continuity of the slope at knot k, h the spacings either side:
    //   h0 m- + 2(h0 + h1) m + h1 m+ = 6((y+ - y)/h1 - (y - y-)/h0)
    // Thomas elimination over eight parts at once, each with the guard knots
    // of its neighbours either side: the recurrence becomes vector code
    const int lanes = 8;
    const int guard = reliefPiece::guard;
    double* __restrict__ slope = work;
    double* __restrict__ ratio = work + n;
    for (int k = 1; k < n; ++k)
    {
        slope[k] = (height[k] - height[k - 1])/spacing[k];
    }
    moment[0] = moment[n - 1] = 0;
    ratio[0] = ratio[n - 1] = 0;

    const int part = (n + lanes - 1)/lanes;
    if (part < 2*guard)
    {
        double d = 0;
        double c = 0;
        for (int k = 1; k < n - 1; ++k)
        {
            const double h0 = spacing[k];
            const double h1 = spacing[k + 1];
            const double pivot = 1/(2*(h0 + h1) - h0*c);
            d = (6*(slope[k + 1] - slope[k]) - h0*d)*pivot;
            c = h1*pivot;
            ratio[k] = c;
            moment[k] = d;
        }
        for (int k = n - 2; k > 0; --k)
        {
            moment[k] -= ratio[k]*moment[k + 1];
        }
        return;
    }

    // Forward: part p covers [p part, (p + 1) part), started a guard before
    double c[lanes] = {}, d[lanes] = {};
    for (int j = -guard; j < part; ++j)
    {
        double h0[lanes], h1[lanes], rhs[lanes];
        for (int p = 0; p < lanes; ++p)
        {
            const int k = std::min(std::max(p*part + j, 1), n - 2);
            h0[p] = spacing[k];
            h1[p] = spacing[k + 1];
            rhs[p] = 6*(slope[k + 1] - slope[k]);
        }
        for (int p = 0; p < lanes; ++p)
        {
            const double pivot = 1/(2*(h0[p] + h1[p]) - h0[p]*c[p]);
            const bool inside = p*part + j >= 1;
            d[p] = inside ? (rhs[p] - h0[p]*d[p])*pivot : 0;
            c[p] = inside ? h1[p]*pivot : 0;
        }
        if (j >= 0)
        {
            for (int p = 0; p < lanes; ++p)
            {
                const int k = p*part + j;
                if (k >= 1 && k < n - 1)
                {
                    ratio[k] = c[p];
                    moment[k] = d[p];
                }
            }
        }
    }

    // Backward, started a guard behind the part. Results go to slope, which
    // is done with, since the neighbour still needs the forward values.
    double m[lanes] = {};
    for (int j = part + guard - 1; j >= 0; --j)
    {
        for (int p = 0; p < lanes; ++p)
        {
            const int k = p*part + j;
            const bool inside = k < n - 1;
            const int at = inside ? k : n - 1;
            m[p] = inside ? moment[at] - ratio[at]*m[p] : 0;
        }
        if (j < part)
        {
            for (int p = 0; p < lanes; ++p)
            {
                const int k = p*part + j;
                if (k < n)
                {
                    slope[k] = m[p];
                }
            }
        }
    }
    for (int k = 1; k < n - 1; ++k)
    {
        moment[k] = slope[k];
    }
}

} // End namespace impact
