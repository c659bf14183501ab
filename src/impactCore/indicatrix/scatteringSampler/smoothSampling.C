/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "flightQueue.H"

void impact::scatteringSampler::sampleSmooth
(
    std::int64_t first,
    int n,
    workspace& w,
    scatteringStatistics& result
) const
{
    // A body that turns as it arrives meets the wall in some orientations
    // more often than in others, as often as its lowest point approaches fast:
    // its flight down to the wall must be followed
    const bool still = mag(setup_.spin) == 0;
    if
    (
        setup_.law.law() != reboundLaw::lawType::restitution
     || !setup_.law.isConstant()
     || !(still || setup_.body.isSphere())
    )
    {
        sampleRough(first, n, w, result);
        return;
    }
    const bool decide =
        setup_.treatment == visitTreatment::firstImpact;
    const bool isotropic = setup_.orientation == orientationLaw::isotropic;
    const double V[3] = {V1_.x, V1_.y, V1_.z};
    const double spin[3] = {setup_.spin.x, setup_.spin.y, setup_.spin.z};
    smoothLanes& l = w.lanes;
    visitCounts total;
    flightQueue flights(*this, w, total, decide);
    const int batch = 256;
    static_assert(batch <= flightQueue::room, "room");
    for (int from = 0; from < n; from += batch)
    {
        const int m = std::min(batch, n - from);
        smoothArrive
        (
            isotropic, setup_.seed, first + from, m, V, spin, smooth_, l
        );
        smoothImpact(m, smooth_, l);
        int counts[4];
        smoothTally(m, flights.small(), l, counts);
        flights.addCounts(m, counts);
        total.into += counts[3];
        total.second += decide ? counts[3] : 0;
        smoothRecord(0, m, smooth_, l, from, w.results());
        for (int i = 0; i < m; ++i)
        {
            l.id[i] = from + i;
        }
        smoothCull(m, smooth_, decide, l);
        flights.add(m, l.mayReturn, 1, l);
        flights.follow(from + m < n ? flightQueue::few : 0);
    }
    total.addTo(result);
}
