/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "walkKernels.H"
#include "vectorTargets.H"

impactKernel
std::int32_t Foam::walkKernels::fly
(
    std::int32_t nCells,
    const std::int32_t* start,
    const std::int32_t* firstGroup,
    const double* planes,
    double* x,
    double* y,
    double* z,
    const double* u,
    const double* v,
    const double* w,
    const double* dt,
    std::int32_t* leavers
)
{
    std::int32_t n = 0;
    const double dtx = dt[0], dty = dt[1], dtz = dt[2];

    for (std::int32_t c = 0; c < nCells; ++c)
    {
        const double* first = planes + stride*std::int64_t(firstGroup[c]);
        const double* last = planes + stride*std::int64_t(firstGroup[c + 1]);

        for (std::int32_t i = start[c]; i < start[c + 1]; ++i)
        {
            const double xe = x[i] + dtx*u[i];
            const double ye = y[i] + dty*v[i];
            const double ze = z[i] + dtz*w[i];

            // Greatest height above a plane, per place in the groups
            double height[width] = {-1, -1, -1, -1};
            for (const double* p = first; p < last; p += stride)
            {
                for (int k = 0; k < width; ++k)
                {
                    const double h =
                        p[k]*xe + p[width + k]*ye + p[2*width + k]*ze
                      - p[3*width + k];
                    height[k] = h > height[k] ? h : height[k];
                }
            }
            const double a = height[0] > height[1] ? height[0] : height[1];
            const double b = height[2] > height[3] ? height[2] : height[3];

            if (a > 0 || b > 0)
            {
                leavers[n++] = i;
            }
            else
            {
                x[i] = xe;
                y[i] = ye;
                z[i] = ze;
            }
        }
    }
    return n;
}
