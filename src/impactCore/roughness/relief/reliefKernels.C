/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorTargets.H"

#include "relief.H"
#include "elementary.H"
#include "philoxLanes.H"

#include <algorithm>
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
    // Thomas elimination over eight parts at once, each with the guard knots
    // of its neighbours either side: the recurrence becomes vector code
    const int lanes = 8;
    const int guard = reliefPiece::guard;
    double* __restrict__ slope = work;
    double* __restrict__ ratio = work + n;
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
    moment[0] = moment[n - 1] = 0;
    ratio[0] = ratio[n - 1] = 0;

    const int part = (n + lanes - 1)/lanes;
    if (part < 2*guard)
    {
        // From both ends at once to the middle. The pivots are ratios of the
        // determinants of ever more equations, and so are the right sides:
        // no division waits for another. Spacings in units of one of them
        const int left = (n - 2)/2;
        double* __restrict__ h = work + 2*n;
        double* __restrict__ diagonal = work + 3*n;
        double* __restrict__ right = work + 4*n;
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
        struct determinants
        {
            double now = 1, before = 0, side = 0;

            //- Another equation: h to the one before
            void add
            (
                double h0,
                double diagonal,
                double right,
                double& last,
                double& next,
                double& nextSide
            )
            {
                const double another = diagonal*now - (h0*h0)*before;
                side = right*now - h0*side;
                before = now;
                now = another;
                last = before;
                next = now;
                nextSide = side;
                if (!(now < 1e100 && now > 1e-100))
                {
                    before /= now;
                    side /= now;
                    now = 1;
                }
            }
        };
        determinants fromLeft, fromRight;
        for (int k = 1; k <= left; ++k)
        {
            const int j = n - 1 - k;
            fromLeft.add
                (h[k], diagonal[k], right[k], ratio[k], slope[k], moment[k]);
            fromRight.add
            (
                h[j + 1], diagonal[j], right[j], ratio[j], slope[j],
                moment[j]
            );
        }
        if (n - 2 > 2*left)
        {
            const int j = left + 1;
            fromRight.add
            (
                h[j + 1], diagonal[j], right[j], ratio[j], slope[j],
                moment[j]
            );
        }
        for (int k = 1; k < n - 1; ++k)
        {
            const double inverse = 1/slope[k];
            ratio[k] *= inverse;
            moment[k] *= inverse;
        }
        for (int k = 1; k <= left; ++k)
        {
            ratio[k] *= h[k + 1];
        }
        for (int k = left + 1; k < n - 1; ++k)
        {
            ratio[k] *= h[k];
        }
        const double c = left > 0 ? ratio[left] : 0;
        const double d = left > 0 ? moment[left] : 0;
        const double e = n > 2 ? ratio[left + 1] : 0;
        const double f = n > 2 ? moment[left + 1] : 0;
        double below = (d - c*f)/(1 - c*e);
        moment[left] = left > 0 ? below : 0;
        double above = f - e*moment[left];
        if (n > 2)
        {
            moment[left + 1] = above;
        }
        for (int k = 1; k < n - 2 - left; ++k)
        {
            const int i = left - k, j = left + 1 + k;
            if (i > 0)
            {
                below = moment[i] - ratio[i]*below;
                moment[i] = below;
            }
            above = moment[j] - ratio[j]*above;
            moment[j] = above;
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

            // Zero at the last knot, and so behind it
            const int at = std::min(k, n - 1);
            m[p] = moment[at] - ratio[at]*m[p];
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
        const double least = m0 < m1 ? m0 : m1;
        const double higher = y0 > y1 ? y0 : y1;
        const double bow = 0.5*h*h*positivePart(-least);
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
        const double size = den < 0 ? -den : den;
        const double ratio = num/(size + 1e-300);
        const double u = den < 0 ? -ratio : ratio;
        const bool inside = (disc > 0) & (size > 0) & (u > 0) & (u < h);
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

        const double least = m0 < m1 ? m0 : m1;
        crest[i] = least < 0 ? -least : 0;
        c1[i] = b;
        c3[i] = p;
    }
}

} // End namespace impact
