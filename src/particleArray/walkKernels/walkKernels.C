/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "walkKernels.H"
#include "vectorTargets.H"

#include <cstring>

namespace
{
    using Foam::walkKernels::stride;
    using Foam::walkKernels::width;

    // A group of planes. Loops over its places do not become vector code by
    // themselves; these types are that of every instruction set, and never
    // leave this file.
    typedef double lanes __attribute__((vector_size(8*width)));
    typedef std::int64_t marks __attribute__((vector_size(8*width)));

    #define inKernel inline __attribute__((always_inline))

    inKernel lanes load(const double* p)
    {
        lanes a;
        std::memcpy(&a, p, sizeof(a));
        return a;
    }

    inKernel lanes all(const double a)
    {
        return lanes{a, a, a, a};
    }

    //- positivePart, by the bits: a selection might be undone, and a division
    //  by what was not selected would trap
    inKernel lanes positive(const lanes a)
    {
        const std::int64_t allButSign = 0x7fffffffffffffff;
        const marks bits =
        {
            allButSign, allButSign, allButSign, allButSign
        };
        const lanes size =
            reinterpret_cast<lanes>(reinterpret_cast<marks>(a) & bits);
        return all(0.5)*(a + size);
    }

    const std::int32_t maxCrossings = 100000;
}


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

            // Greatest height above a plane
            lanes worst = all(-1);
            for (const double* p = first; p < last; p += stride)
            {
                const lanes h =
                    load(p)*all(xe) + load(p + width)*all(ye)
                  + load(p + 2*width)*all(ze) - load(p + 3*width);
                worst = h > worst ? h : worst;
            }
            const lanes other = __builtin_shuffle(worst, marks{2, 3, 0, 1});
            worst = worst > other ? worst : other;
            const bool leaves = (worst[0] > 0) | (worst[1] > 0);

            // No branch: whether a particle leaves is hard to predict
            leavers[n] = i;
            n += leaves;
            x[i] = leaves ? x[i] : xe;
            y[i] = leaves ? y[i] : ye;
            z[i] = leaves ? z[i] : ze;
        }
    }
    return n;
}


impactKernel
std::int32_t Foam::walkKernels::cross
(
    std::int32_t n,
    std::int32_t* leavers,
    std::int32_t* stopped,
    const std::int32_t* firstGroup,
    const double* planes,
    const std::int32_t* targets,
    double* x,
    double* y,
    double* z,
    const double* u,
    const double* v,
    const double* w,
    const double* dt,
    std::int32_t* cell
)
{
    // Speeds below this are parallel to a face; no quotient overflows, since
    // no length is above 1e100 m
    const double still = 1e-200;
    const double far = 1e100;

    // All cross one face, then those that go on the next: none of the
    // branches depends on a single particle
    std::int32_t nStopped = 0;
    for (std::int32_t crossing = 0; n && crossing < maxCrossings; ++crossing)
    {
        std::int32_t nOn = 0;
        for (std::int32_t k = 0; k < n; ++k)
        {
            const std::int32_t i = leavers[k];

            // In units of the time step
            const double ux = dt[0]*u[i], uy = dt[1]*v[i], uz = dt[2]*w[i];

            const std::int32_t g = firstGroup[cell[i]];
            const double* p = planes + stride*std::int64_t(g);
            const double* last =
                planes + stride*std::int64_t(firstGroup[cell[i] + 1]);
            marks here = {0, 1, 2, 3};
            here += width*std::int64_t(g);
            lanes least = all(1);
            marks place = {-1, -1, -1, -1};
            for (; p < last; p += stride)
            {
                const lanes nx = load(p);
                const lanes ny = load(p + width);
                const lanes nz = load(p + 2*width);
                const lanes speed = nx*all(ux) + ny*all(uy) + nz*all(uz);
                const lanes depth =
                    load(p + 3*width)
                  - (nx*all(x[i]) + ny*all(y[i]) + nz*all(z[i]));
                const marks out = speed > all(still);
                const lanes quotient = depth/(positive(speed) + all(still));
                const lanes time = out ? quotient : all(far);
                const marks earlier = time < least;
                least = earlier ? time : least;
                place = earlier ? here : place;
                here += width;
            }

            // The earliest of the four
            const marks turn = {2, 3, 0, 1};
            const lanes time = __builtin_shuffle(least, turn);
            const marks earlier = time < least;
            least = earlier ? time : least;
            place = earlier ? __builtin_shuffle(place, turn) : place;
            const std::int64_t exit =
                least[1] < least[0] ? place[1] : place[0];

            const bool arrived = exit < 0;
            const std::int32_t next = targets[arrived ? 0 : exit];
            const bool stops = !arrived & (next < 0);
            const bool on = !arrived & (next >= 0);

            x[i] = arrived ? x[i] + ux : x[i];
            y[i] = arrived ? y[i] + uy : y[i];
            z[i] = arrived ? z[i] + uz : z[i];
            cell[i] = on ? next : cell[i];
            leavers[nOn] = i;
            nOn += on;
            stopped[nStopped] = i;
            nStopped += stops;
        }
        n = nOn;
    }

    // Whoever goes round and round
    for (std::int32_t k = 0; k < n; ++k)
    {
        stopped[nStopped++] = leavers[k];
    }
    return nStopped;
}
