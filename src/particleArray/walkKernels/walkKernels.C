/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "walkKernels.H"
#include "lanes.H"

namespace
{
    using Foam::walkKernels::stride;
    using Foam::walkKernels::width;

    // A group of planes
    using impact::lanes;
    using impact::allLanes;
    using impact::exchanged;
    using impact::loadLanes;
    using impact::positivePart;
    using impact::storeLanes;
    typedef impact::laneMarks marks;
    static_assert(width == impact::nLanes, "lanes of a group");

    //- a or b by the bits: of a selection the compiler makes a branch, which is
    //  mispredicted for as many particles as leave their cells
    impactInline double choose(const bool first, const double a, const double b)
    {
        std::int64_t ia, ib;
        std::memcpy(&ia, &a, sizeof(a));
        std::memcpy(&ib, &b, sizeof(b));
        const std::int64_t mask = -std::int64_t(first);
        const std::int64_t ic = ib ^ ((ia ^ ib) & mask);
        double c;
        std::memcpy(&c, &ic, sizeof(c));
        return c;
    }

    const std::int32_t maxCrossings = 100000;

    //- Cells of a block: their particles and planes fit the nearest cache
    const std::int32_t blockSize = 128;

    typedef Foam::walkKernels::convexShapes convexShapes;

    impactInline bool isBox(const convexShapes& shapes, const std::int32_t c)
    {
        using Foam::walkKernels::boundStride;
        const double* b = shapes.bounds + boundStride*std::int64_t(c);
        return b[0] <= b[4];
    }


    //- Of the particles of a cell those that stay fly; the others are listed
    impactInline std::int32_t stay
    (
        const std::int32_t c,
        const std::int32_t nAll,
        const std::int32_t* start,
        const convexShapes& shapes,
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
        const double dtx = dt[0], dty = dt[1], dtz = dt[2];
        std::int32_t n = 0;

        if (shapes.bounds && isBox(shapes, c))
        {
            // Four particles at once; the last of the cell with some of the
            // next one, which stay as they are
            const double* b =
                shapes.bounds + Foam::walkKernels::boundStride*std::int64_t(c);
            const lanes low[3] =
                {allLanes(b[0]), allLanes(b[1]), allLanes(b[2])};
            const lanes high[3] =
                {allLanes(b[4]), allLanes(b[5]), allLanes(b[6])};
            const std::int32_t end = start[c + 1];
            std::int32_t i = start[c];
            const std::int32_t safe = nAll - width + 1;
            for (; i < end && i < safe; i += width)
            {
                const lanes x0 = loadLanes(x + i);
                const lanes y0 = loadLanes(y + i);
                const lanes z0 = loadLanes(z + i);
                const lanes xe = x0 + allLanes(dtx)*loadLanes(u + i);
                const lanes ye = y0 + allLanes(dty)*loadLanes(v + i);
                const lanes ze = z0 + allLanes(dtz)*loadLanes(w + i);
                const marks number = marks{0, 1, 2, 3} + std::int64_t(i);
                const marks here = number < std::int64_t(end);
                const marks out =
                    (xe < low[0]) | (xe > high[0])
                  | (ye < low[1]) | (ye > high[1])
                  | (ze < low[2]) | (ze > high[2]);
                const marks stays = here & ~out;
                const marks leaves = here & out;
                storeLanes(x + i, stays ? xe : x0);
                storeLanes(y + i, stays ? ye : y0);
                storeLanes(z + i, stays ? ze : z0);
                for (int k = 0; k < width; ++k)
                {
                    leavers[n] = i + k;
                    n -= std::int32_t(leaves[k]);
                }
            }
            for (; i < end; ++i)
            {
                const double xe = x[i] + dtx*u[i];
                const double ye = y[i] + dty*v[i];
                const double ze = z[i] + dtz*w[i];
                const bool leaves =
                    (xe < b[0]) | (xe > b[4])
                  | (ye < b[1]) | (ye > b[5])
                  | (ze < b[2]) | (ze > b[6]);
                leavers[n] = i;
                n += leaves;
                x[i] = choose(leaves, x[i], xe);
                y[i] = choose(leaves, y[i], ye);
                z[i] = choose(leaves, z[i], ze);
            }
            return n;
        }

        const double* first =
            shapes.planes + stride*std::int64_t(shapes.firstGroup[c]);
        const double* last =
            shapes.planes + stride*std::int64_t(shapes.firstGroup[c + 1]);
        for (std::int32_t i = start[c]; i < start[c + 1]; ++i)
        {
            const double xe = x[i] + dtx*u[i];
            const double ye = y[i] + dty*v[i];
            const double ze = z[i] + dtz*w[i];

            // Greatest height above a plane
            lanes worst = allLanes(-1);
            for (const double* p = first; p < last; p += stride)
            {
                const lanes h =
                    loadLanes(p)*allLanes(xe)
                  + loadLanes(p + width)*allLanes(ye)
                  + loadLanes(p + 2*width)*allLanes(ze)
                  - loadLanes(p + 3*width);
                worst = h > worst ? h : worst;
            }
            const lanes other = exchanged(worst, marks{2, 3, 0, 1});
            worst = worst > other ? worst : other;
            const bool leaves = (worst[0] > 0) | (worst[1] > 0);

            leavers[n] = i;
            n += leaves;
            x[i] = choose(leaves, x[i], xe);
            y[i] = choose(leaves, y[i], ye);
            z[i] = choose(leaves, z[i], ze);
        }
        return n;
    }


    //- Of each lane and its partner the earlier one
    impactInline void pairUp(lanes& time, marks& place, const marks& partner)
    {
        const lanes other = exchanged(time, partner);
        const marks otherPlace = exchanged(place, partner);
        const marks earlier = other < time;
        time = earlier ? other : time;
        place = earlier ? otherPlace : place;
    }


    //- The earliest of four, and its place, become the first
    impactInline void earliest(lanes& time, marks& place)
    {
        pairUp(time, place, marks{2, 3, 0, 1});
        pairUp(time, place, marks{1, 0, 3, 2});
    }


    //- Where a flight of one time step from x leaves a cell
    struct wayOut
    {
        bool arrives;
        std::int32_t next;
    };

    // Speeds below this are parallel to a face; no quotient overflows, since
    // no length is above 1e100 m
    const double still = 1e-200;
    const double far = 1e100;

    impactInline wayOut leave
    (
        const convexShapes& shapes,
        const std::int32_t c,
        const double x,
        const double y,
        const double z,
        const double ux,
        const double uy,
        const double uz
    )
    {
        if (shapes.bounds && isBox(shapes, c))
        {
            using Foam::walkKernels::boundStride;
            const double* b = shapes.bounds + boundStride*std::int64_t(c);
            const lanes position = {x, y, z, 0};
            const lanes speed = {ux, uy, uz, 0};
            const marks up = speed > allLanes(0);
            const lanes depth =
                up ? loadLanes(b + width) - position : position - loadLanes(b);
            const lanes magnitude = positivePart(speed) + positivePart(-speed);
            const marks out = magnitude > allLanes(still);
            const lanes quotient = depth/(magnitude + allLanes(still));
            lanes time = out ? quotient : allLanes(far);
            marks place = marks{0, 1, 2, 3} - up*width;

            earliest(time, place);
            return
            {
                !(time[0] < 1),
                shapes.beyond[boundStride*std::int64_t(c) + place[0]]
            };
        }

        const std::int32_t g = shapes.firstGroup[c];
        const double* p = shapes.planes + stride*std::int64_t(g);
        const double* last =
            shapes.planes + stride*std::int64_t(shapes.firstGroup[c + 1]);
        marks here = {0, 1, 2, 3};
        here += width*std::int64_t(g);
        lanes minTime = allLanes(1);
        marks place = {-1, -1, -1, -1};
        for (; p < last; p += stride)
        {
            const lanes nx = loadLanes(p);
            const lanes ny = loadLanes(p + width);
            const lanes nz = loadLanes(p + 2*width);
            const lanes speed =
                nx*allLanes(ux) + ny*allLanes(uy) + nz*allLanes(uz);
            const lanes depth =
                loadLanes(p + 3*width)
              - (nx*allLanes(x) + ny*allLanes(y) + nz*allLanes(z));
            const marks out = speed > allLanes(still);
            const lanes quotient =
                depth/(positivePart(speed) + allLanes(still));
            const lanes time = out ? quotient : allLanes(far);
            const marks earlier = time < minTime;
            minTime = earlier ? time : minTime;
            place = earlier ? here : place;
            here += width;
        }

        earliest(minTime, place);
        const bool arrives = place[0] < 0;
        return {arrives, shapes.targets[arrives ? 0 : place[0]]};
    }
}


impactKernel
std::int32_t Foam::walkKernels::fly
(
    std::int32_t nCells,
    const std::int32_t* start,
    const convexShapes& shapes,
    double* x,
    double* y,
    double* z,
    const double* u,
    const double* v,
    const double* w,
    const double* dt,
    std::int32_t* cell,
    std::int32_t* leavers,
    std::int32_t* stopped
)
{
    std::int32_t nStopped = 0;
    for (std::int32_t begin = 0; begin < nCells; begin += blockSize)
    {
        const std::int32_t end =
            begin + blockSize < nCells ? begin + blockSize : nCells;
        std::int32_t n = 0;
        for (std::int32_t c = begin; c < end; ++c)
        {
            n += stay
            (
                c, start[nCells], start, shapes, x, y, z, u, v, w, dt,
                leavers + n
            );
        }

        // All cross one face, then those that go on the next: none of the
        // branches depends on a single particle
        for
        (
            std::int32_t crossing = 0;
            n && crossing < maxCrossings;
            ++crossing
        )
        {
            std::int32_t nOn = 0;
            for (std::int32_t k = 0; k < n; ++k)
            {
                const std::int32_t i = leavers[k];

                // In units of the time step
                const double ux = dt[0]*u[i];
                const double uy = dt[1]*v[i];
                const double uz = dt[2]*w[i];
                const wayOut way =
                    leave(shapes, cell[i], x[i], y[i], z[i], ux, uy, uz);
                const bool stops = !way.arrives & (way.next < 0);
                const bool on = !way.arrives & (way.next >= 0);

                x[i] = choose(way.arrives, x[i] + ux, x[i]);
                y[i] = choose(way.arrives, y[i] + uy, y[i]);
                z[i] = choose(way.arrives, z[i] + uz, z[i]);
                cell[i] = on ? way.next : cell[i];
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
    }
    return nStopped;
}


impactKernel void Foam::walkKernels::exitTimes
(
    const std::int32_t n,
    const convexShapes& shapes,
    const std::int32_t* cell,
    const double* x,
    const double* y,
    const double* z,
    const double* u,
    const double* v,
    const double* w,
    const double* limit,
    double* time
)
{
    for (std::int32_t i = 0; i < n; ++i)
    {
        const lanes
            px = allLanes(x[i]), py = allLanes(y[i]), pz = allLanes(z[i]),
            pu = allLanes(u[i]), pv = allLanes(v[i]), pw = allLanes(w[i]);
        double minTime = limit[i];
        const std::int32_t end = shapes.firstGroup[cell[i] + 1];
        for (std::int32_t g = shapes.firstGroup[cell[i]]; g < end; ++g)
        {
            const double* p = shapes.planes + stride*std::size_t(g);
            const lanes nx = loadLanes(p), ny = loadLanes(p + width);
            const lanes nz = loadLanes(p + 2*width);
            double speed[width], depth[width];
            storeLanes(speed, nx*pu + ny*pv + nz*pw);
            storeLanes(depth, loadLanes(p + 3*width) - (nx*px + ny*py + nz*pz));
            for (int k = 0; k < width; ++k)
            {
                // Only faces that the ray goes out of
                if (speed[k] > 0 && depth[k] < minTime*speed[k])
                {
                    minTime = depth[k]/speed[k];
                }
            }
        }
        time[i] = minTime;
    }
}


impactKernel void Foam::walkKernels::pathsInside
(
    const std::int32_t n,
    const convexShapes& shapes,
    const std::int32_t* cell,
    const double* const* points,
    unsigned char* stays
)
{
    for (std::int32_t i = 0; i < n; ++i)
    {
        marks outside = {0, 0, 0, 0};
        const std::int32_t end = shapes.firstGroup[cell[i] + 1];
        for (std::int32_t g = shapes.firstGroup[cell[i]]; g < end; ++g)
        {
            const double* p = shapes.planes + stride*std::size_t(g);
            const lanes nx = loadLanes(p), ny = loadLanes(p + width);
            const lanes nz = loadLanes(p + 2*width), d = loadLanes(p + 3*width);
            for (int b = 0; b < 3; ++b)
            {
                const double* const* q = points + 3*b;
                outside |=
                    nx*allLanes(q[0][i]) + ny*allLanes(q[1][i])
                  + nz*allLanes(q[2][i]) - d
                  > allLanes(0);
            }
        }
        stays[i] = !(outside[0] | outside[1] | outside[2] | outside[3]);
    }
}
