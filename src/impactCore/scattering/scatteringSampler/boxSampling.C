/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "flightQueue.H"
#include "smoothInline.H"

#include <climits>

namespace
{

//- Boxes that arrive together
constexpr int boxBatch = 512;

//- Lanes that are kept for hops that go on when the next batch arrives
constexpr int held = 64;

} // End anonymous namespace


void impact::scatteringSampler::sampleBoxes
(
    std::int64_t first,
    int n,
    workspace& w,
    scatteringStatistics& result
) const
{
    const bool decide =
        setup_.treatment == wallVisit::treatmentType::firstImpact;
    const int most = decide ? INT_MAX : setup_.maxImpacts;
    const double V[3] = {V1_.x, V1_.y, V1_.z};
    visitCounts total;
    flightQueue flights(*this, w, total, decide);
    smoothLanes& l = w.lanes;
    smoothHops& hops = w.hops;
    smoothHops& next = w.nextHops;
    const smoothResults results = w.results();
    int hopping = 0;

    // The lanes of a batch begin behind those held
    int batch = 0;
    int particles[held + boxBatch];

    // Add those of m next hops that begin
    auto begin = [&](int m)
    {
        const int k = packColumns
        (
            m, next.outcome, hopOutcome::again, hopStartColumns, hopStride,
            next.slot, hops.slot + hopping
        );

        // And behind them, where packing may have left parts of hops: what is
        // looked at in whole vectors must not overflow
        const int whole = k + lanePadding;
        std::fill_n(hops.elapsed + hopping, whole, 0.f);
        std::fill_n(hops.trial + hopping, whole, 0.f);
        std::fill_n(hops.attempts + hopping, whole, 0.f);
        hopping += k;
    };

    // Hops with that outcome become flights
    auto leave = [&](int m, const smoothHops& h, int outcome)
    {
        int list[held + boxBatch + lanePadding];
        const int k = findLanes(m, h.outcome, outcome, list);
        for (int j = 0; j < k; ++j)
        {
            const int i = h.slot[list[j]];
            const vector3 ey = at(l.ey, i);
            const vector3 r =
            {
                std::copysign(smooth_.a[0], -ey.x),
                std::copysign(smooth_.a[1], -ey.y),
                std::copysign(smooth_.a[2], -ey.z)
            };
            const double rise =
                l.V[1][i] + dot(ey, cross(at(l.w, i), r));
            l.y[i] = -dot(r, ey);
            l.approach[i] =
                smooth_.normal > 0 ? positivePart(rise)/smooth_.normal : 0;
            l.id[i] = particles[i];
            l.contacts[i] = h.contacts[list[j]];
            list[j] = i;
        }
        flights.add(k, list, l);
    };

    // A look at the end of all hops, and the impacts where it is found
    auto hop = [&]
    {
        const int m = hopping;
        hopLook(m, smooth_, decide, hops);
        int second, capped;
        const int strikes = hopCount(m, most, hops, second, capped);
        total.second += second;
        total.capped += capped;
        leave(m, hops, hopOutcome::open);
        if (!decide)
        {
            packColumns
            (
                m, hops.outcome, hopOutcome::strikes, hopEndColumns, hopStride,
                hops.slot, next.slot
            );
        }
        hopping = packColumns
        (
            m, hops.outcome, hopOutcome::again, hopColumns, hopStride,
            hops.slot, hops.slot
        );
        if (!decide)
        {
            int counts[4];
            const int missed =
                hopStrike
                (
                    strikes, smooth_, flights.small(), particles, l, next,
                    results, counts
                );
            flights.addCounts(strikes - missed, counts);
            if (missed > 0)
            {
                for (int i = 0; i < strikes; ++i)
                {
                    total.second -=
                        next.outcome[i] == hopOutcome::open
                     && next.contacts[i] == 1 ? 1 : 0;
                }
                leave(strikes, next, hopOutcome::open);
            }
            begin(strikes);
        }
    };

    // Hops that go on move to the lanes that are kept
    auto hold = [&]
    {
        bool taken[held] = {};
        for (int k = 0; k < hopping; ++k)
        {
            if (hops.slot[k] < held)
            {
                taken[hops.slot[k]] = true;
            }
        }
        int free = 0;
        for (int k = 0; k < hopping; ++k)
        {
            const int i = hops.slot[k];
            if (i >= held)
            {
                while (taken[free])
                {
                    ++free;
                }
                copyColumns<stateColumns>(laneOf(l, i), laneOf(l, free));
                particles[free] = particles[i];
                hops.slot[k] = free++;
            }
        }
    };

    static_assert(held + boxBatch <= smoothRoom, "room");
    static_assert(boxBatch + held <= flightQueue::room, "room");
    for (; batch < n; batch += boxBatch)
    {
        const int m = std::min(boxBatch, n - batch);
        const bool last = batch + m == n;
        int counts[4];
        hopMeet
        (
            setup_.orientation == orientationLaw::isotropic, setup_.seed,
            first + batch, m, V, smooth_, decide, held, l, next, counts
        );
        counts[0] = -V1_.y > flights.small() ? m : 0;
        flights.addCounts(m, counts);
        smoothRecord(held, m, smooth_, l, batch, results);
        for (int i = 0; i < m; ++i)
        {
            particles[held + i] = batch + i;
        }
        total.into += counts[3];
        total.second += decide ? counts[3] : 0;
        if (hops_)
        {
            begin(m);
        }
        else
        {
            leave(m, next, hopOutcome::again);
        }
        while (hopping > (last ? 0 : held))
        {
            hop();
        }
        hold();
        flights.follow(last ? 0 : flightQueue::few);
    }
    total.addTo(result);
}
