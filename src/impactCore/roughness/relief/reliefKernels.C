/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorTargets.H"

#include "relief.H"
#include "elementary.H"
#include "philoxLanes.H"

#include <cmath>

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
    // The middle of one of 2^32 parts
    auto unit = [](std::uint64_t word)
    {
        return unitOf((word << 20) | 0x80000);
    };
    constexpr int pairs = reliefPiece::drawnAtOnce/2;
    for (int from = 0; from < n; from += 2*pairs)
    {
        for (std::int64_t j = 0; j < pairs; ++j)
        {
            std::uint64_t w0, w1, w2, w3;
            philoxLane
            (
                seed, std::uint64_t((i0 + from)/2 + j), drawPurpose::knots,
                identity, w0, w1, w2, w3
            );
            const std::int64_t i = from + 2*j;
            spacing[i] =
                meanSpacing + sigmaSpacing*truncatedNormal(unit(w0));
            height[i] = sigmaHeight*truncatedNormal(unit(w1));
            spacing[i + 1] =
                meanSpacing + sigmaSpacing*truncatedNormal(unit(w2));
            height[i + 1] = sigmaHeight*truncatedNormal(unit(w3));
        }
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
    // Spacings in units of one of them
    double* __restrict__ slope = work;
    double* __restrict__ h = work + n;
    double* __restrict__ diagonal = work + 2*n;
    double* __restrict__ right = work + 3*n;
    double* __restrict__ ratio = work + 4*n;
    auto slopeOf = [&](int k)
    {
        return (height[k] - height[k - 1])/spacing[k];
    };
    for (int k = 2; k < n - 1; ++k)
    {
        slope[k] = slopeOf(k);
    }
    slope[1] = spacing[1] > 0 ? slopeOf(1) : height[0];
    slope[n - 1] = spacing[n - 1] > 0 ? slopeOf(n - 1) : height[n - 1];
    const double unit = 1/spacing[2];
    for (int k = 1; k < n; ++k)
    {
        h[k] = unit*spacing[k];
    }
    for (int k = 1; k < n - 1; ++k)
    {
        diagonal[k] = 2*(h[k] + h[k + 1]);
        right[k] = 6*unit*(slope[k + 1] - slope[k]);
    }

    // The pivots are ratios of the determinants of ever more equations, and so
    // are the right sides: no division waits for another
    double now = 1, before = 0, side = 0;
    for (int k = 1; k < n - 1; ++k)
    {
        const double another = diagonal[k]*now - (h[k]*h[k])*before;
        side = right[k]*now - h[k]*side;
        before = now;
        now = another;
        ratio[k] = before;
        slope[k] = now;
        moment[k] = side;
        if (!(now < 1e100 && now > 1e-100))
        {
            before /= now;
            side /= now;
            now = 1;
        }
    }
    for (int k = 1; k < n - 1; ++k)
    {
        const double inverse = 1/slope[k];
        ratio[k] *= inverse*h[k + 1];
        moment[k] *= inverse;
    }
    moment[0] = moment[n - 1] = 0;
    for (int k = n - 3; k > 0; --k)
    {
        moment[k] -= ratio[k]*moment[k + 1];
    }
}


impactKernel void splineCeilings
(
    int n,
    const double* __restrict__ spacing,
    const double* __restrict__ height,
    const double* __restrict__ moment,
    double* __restrict__ ceiling
)
{
    for (int i = 0; i < n; ++i)
    {
        // No higher than a parabola of the bend of the sharpest crest through
        // both ends
        const double h = spacing[i + 1];
        const double y0 = height[i], y1 = height[i + 1];
        const double m0 = moment[i], m1 = moment[i + 1];
        const double minMoment = m0 < m1 ? m0 : m1;
        const double higher = y0 > y1 ? y0 : y1;
        const double bow = 0.5*h*h*positivePart(-minMoment);
        const double over = positivePart(bow - std::fabs(y1 - y0));
        ceiling[i] = higher + 0.25*over*over/nonZero(bow);
    }
}


impactKernel int intervalsPassed
(
    int n,
    const double* __restrict__ x1,
    const double* __restrict__ ceiling,
    double bottom,
    double Vy,
    double perX,
    double ahead
)
{
    auto clear = [&](int k)
    {
        return bottom + Vy*((x1[k] + ahead)*perX) > ceiling[k];
    };
    constexpr int lanes = 8;
    int passed = 0;
    for (; passed + lanes <= n; passed += lanes)
    {
        int below = 0;
        for (int i = 0; i < lanes; ++i)
        {
            below += clear(passed + i) ? 0 : 1;
        }
        if (below > 0)
        {
            break;
        }
    }
    while (passed < n && clear(passed))
    {
        ++passed;
    }
    return passed;
}


impactKernel void splineShapes
(
    int n,
    const double* __restrict__ x,
    const double* __restrict__ height,
    const double* __restrict__ moment,
    double* __restrict__ c1,
    double* __restrict__ c3,
    double* __restrict__ top,
    double* __restrict__ steep,
    double* __restrict__ crest
)
{
    for (int i = 0; i < n; ++i)
    {
        const double h = x[i + 1] - x[i];
        const double y0 = height[i], y1 = height[i + 1];
        const double m0 = moment[i], m1 = moment[i + 1];
        const double perH = 1/h, sixth = 1./6;
        const double b = (y1 - y0)*perH - h*(2*m0 + m1)*sixth;
        const double q = 0.5*m0;
        const double p = (m1 - m0)*perH*sixth;
        const double slope1 = b + h*(2*q + 3*h*p);
        const double start = b < 0 ? -b : b;
        const double end = slope1 < 0 ? -slope1 : slope1;
        double steepest = start > end ? start : end;

        // Highest point inside: where the slope falls through zero. Of the
        // two forms of the root, the one without cancellation
        const double disc = q*q - 3*p*b;
        const double root = std::sqrt(positivePart(disc));
        const double num = q > 0 ? -q - root : b;
        const double den = q > 0 ? 3*p : root - q;
        const double magnitude = den < 0 ? -den : den;
        const double ratio = num/(magnitude + 1e-300);
        const double u = den < 0 ? -ratio : ratio;
        const bool inside = (disc > 0) & (magnitude > 0) & (u > 0) & (u < h);
        const double at = inside ? u : 0;
        const double peak = y0 + at*(b + at*(q + at*p));
        const double higher = y0 > y1 ? y0 : y1;
        top[i] = inside & (peak > higher) ? peak : higher;

        // Steepest point inside: the inflection
        const double bend = p < 0 ? -p : p;
        const double back = q*q/(3*(bend + 1e-300));
        const double flex = b - (p < 0 ? -back : back);
        const double flexSize = flex < 0 ? -flex : flex;
        const bool turns = ((m0 > 0) != (m1 > 0)) & (bend > 0);
        steep[i] = turns & (flexSize > steepest) ? flexSize : steepest;

        const double minMoment = m0 < m1 ? m0 : m1;
        crest[i] = minMoment < 0 ? -minMoment : 0;
        c1[i] = b;
        c3[i] = p;
    }
}

} // End namespace impact
