/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "samplerWorkspace.H"

namespace
{

using impact::findLanes;
using impact::flightColumns;
using impact::hopDoubles;
using impact::hopSingles;
using impact::hopStride;
using impact::smoothFlights;
using impact::smoothHops;
using impact::smoothStride;

//- Flights and hops that are not followed until a batch has been added
constexpr int fewFlights = 64;

//- Room for the numbers of lanes
constexpr int laneRoom = impact::smoothRoom + impact::lanePadding;

//- Steps after which a flight is left to the general search
constexpr int manySteps = 100;


//- Copy columns of a lane to another place
template<int columns, std::size_t stride, class Number>
inline void copyLane(const Number* from, Number* to)
{
    #pragma GCC unroll 32
    for (int c = 0; c < columns; ++c)
    {
        to[c*stride] = from[c*stride];
    }
}


//- Copy columns of those of n lanes whose mark is value, without gaps. Returns
//  how many
template<int columns>
int packLanes
(
    int n,
    const int* mark,
    int value,
    const double* from,
    double* to
)
{
    int list[laneRoom];
    const int found = findLanes(n, mark, value, list);
    for (int k = 0; k < found; ++k)
    {
        copyLane<columns, smoothStride>(from + list[k], to + k);
    }
    return found;
}


//- Take out the flights that have ended, few of n: the last ones come into
//  their places. Returns the number left
int removeEnded(smoothFlights& f, int n)
{
    int ended[laneRoom], movers[laneRoom];
    const int m = n - findLanes(n, f.ended, 0, movers);
    int k = 0;
    for (int i = 0; i < n; ++i)
    {
        ended[k] = i;
        k += f.ended[i] != 0;
    }
    const int moves = findLanes(m, f.ended + n - m, 0, movers);
    for (int j = 0; j < moves; ++j)
    {
        movers[j] += n - m;
        copyLane<flightColumns, smoothStride>
            (f.ex[0] + movers[j], f.ex[0] + ended[j]);
        f.launched[ended[j]] = f.launched[movers[j]];
    }
    return n - m;
}


//- Take out the hops that have, most of n. Returns the number left
int removeEnded(smoothHops& h, int n)
{
    int stay[laneRoom];
    const int left = findLanes(n, h.outcome, impact::hopOutcome::again, stay);
    for (int k = 0; k < left; ++k)
    {
        copyLane<hopDoubles, smoothStride>(h.ex[0] + stay[k], h.ex[0] + k);
        copyLane<hopSingles, hopStride>(h.m[0] + stay[k], h.m[0] + k);
    }
    return left;
}


//- The start of a flight as the state of a body
impact::bodyState stateOf(const smoothFlights& f, int i, double x)
{
    impact::bodyState b;
    b.rotation.ex = {f.ex[0][i], f.ex[1][i], f.ex[2][i]};
    b.rotation.ey = {f.ey[0][i], f.ey[1][i], f.ey[2][i]};
    b.rotation.omega = {f.w[0][i], f.w[1][i], f.w[2][i]};
    b.V = {f.V[0][i], f.V[1][i], f.V[2][i]};
    b.x = x;
    b.y = f.y[i];
    return b;
}

} // End anonymous namespace


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
     || !(still || setup_.body.isSphere())
    )
    {
        sampleRough(first, n, w, result);
        return;
    }
    const bool decide =
        setup_.treatment == wallVisit::treatmentType::firstImpact;
    const double small = 1e-3*mag(V1_);
    const double V[3] = {V1_.x, V1_.y, V1_.z};
    const double spin[3] = {setup_.spin.x, setup_.spin.y, setup_.spin.z};
    const vector3& J = setup_.body.inertia();
    const double most = setup_.maxImpacts;
    visitCounts total;
    smoothLanes& l = w.lanes;
    smoothLanes& again = w.struck;
    smoothFlights& f = w.flights;
    smoothHops& hops = w.hops;
    int inFlight = 0, hopping = 0;
    int step = 0;

    auto tally = [&](const smoothLanes& lanes, int m)
    {
        int counts[4];
        smoothTally(m, small, lanes, counts);
        total.impacts += counts[0];
        total.micro += m - counts[0];
        total.pulling += counts[1];
        total.gaining += counts[2];
        return counts[3];
    };

    // The rest of the visit of flight i outside the kernels
    auto finish = [&](int i)
    {
        const bodyState b = stateOf(f, i, 0.5*flat_.period());
        const visitResult r = visit_.resume(b, int(f.contacts[i]), w.piece, 0);
        total.addImpacts(r);
        total.second += f.contacts[i] == 1 && r.second;
        const vector3& omega = r.state.rotation.omega;
        const int particle = int(f.id[i]);
        w.Vx[particle] = r.state.V.x;
        w.Vy[particle] = r.state.V.y;
        w.Vz[particle] = r.state.V.z;
        w.spinEnergy[particle] = dot(multiply(J, omega), omega);
    };

    // Take marked lanes into the flights
    auto toFlights = [&](int m, const int* mark, int value, const double* from)
    {
        const int k = packLanes<motionColumns>
            (m, mark, value, from, f.ex[0] + inFlight);
        if (!vectorFlights_)
        {
            for (int j = 0; j < k; ++j)
            {
                finish(inFlight + j);
            }
            return;
        }
        std::fill_n(f.launched + inFlight, k, step);
        smoothLaunch(inFlight, inFlight + k, smooth_, f);
        inFlight += k;
    };

    // Launch those of the lanes that may come back
    auto launch = [&](const smoothLanes& lanes, int m)
    {
        if (hops_)
        {
            const int k = packLanes<motionColumns>
                (m, lanes.mayReturn, 1, lanes.ex[0], hops.ex[0] + hopping);
            hopBegin(hopping, hopping + k, smooth_, hops);
            hopping += k;
        }
        else
        {
            toFlights(m, lanes.mayReturn, 1, lanes.ex[0]);
        }
    };

    // Of the lanes of again, which strike, those that have not done so too
    // often
    auto countStrikes = [&](int m)
    {
        int capped[laneRoom];
        int left = m;
        for (int i = 0; i < m; ++i)
        {
            total.second += again.contacts[i] == 1 ? 1 : 0;
            capped[i] = again.contacts[i] < most ? 0 : 1;
            left -= capped[i];
        }
        if (left < m)
        {
            total.capped += m - left;
            packLanes<lanesColumns>(m, capped, 0, again.ex[0], again.ex[0]);
        }
        return left;
    };

    // The state after an impact of the lanes of again is the result unless
    // another one follows
    auto record = [&](int m)
    {
        tally(again, m);
        for (int i = 0; i < m; ++i)
        {
            const int particle = int(again.id[i]);
            w.Vx[particle] = again.V[0][i];
            w.Vy[particle] = again.V[1][i];
            w.Vz[particle] = again.V[2][i];
            w.spinEnergy[particle] = again.spinEnergy[i];
        }
        launch(again, m);
    };

    // Those of m lanes of again that have not come to the contact expected: by
    // steps from the start of their hops. Returns the number of the others
    auto takeBack = [&](int m, int n, const int* missed)
    {
        int miss[laneRoom], mark[laneRoom] = {};
        const int misses = findLanes(m, missed, 1, miss);
        for (int k = 0; k < misses; ++k)
        {
            const double id = again.id[miss[k]];
            const int i = int(std::find(hops.id, hops.id + n, id) - hops.id);
            total.second -= hops.contacts[i] == 1 ? 1 : 0;
            mark[i] = 1;
        }
        toFlights(n, mark, 1, hops.ex[0]);
        const int left = packLanes<lanesColumns>
            (m, missed, 0, again.ex[0], again.ex[0]);
        for (int i = 0, k = 0; i < m; ++i)
        {
            again.mayReturn[k] = again.mayReturn[i];
            k += missed[i] ? 0 : 1;
        }
        return left;
    };

    // A look at the end of all hops, and the impacts where it is found
    auto hop = [&]
    {
        const int n = hopping;
        hopLook(n, smooth_, decide, hops);
        toFlights(n, hops.outcome, hopOutcome::open, hops.ex[0]);
        if (decide)
        {
            int strikes[laneRoom];
            total.second +=
                findLanes(n, hops.outcome, hopOutcome::strikes, strikes);
            hopping = removeEnded(hops, n);
            return;
        }
        int m = packLanes<flownColumns>
            (n, hops.outcome, hopOutcome::strikes, hops.ex[0], again.ex[0]);
        m = countStrikes(m);
        for (int c = 0; c < flownColumns; ++c)
        {
            std::fill_n(again.ex[0] + c*smoothStride + m, 8, 0.);
        }
        int missed[laneRoom];
        if (hopStrike(m, smooth_, again, missed) > 0)
        {
            m = takeBack(m, n, missed);
        }
        hopping = removeEnded(hops, n);
        record(m);
    };

    // One step of all flights, and the impacts at its end
    auto fly = [&]
    {
        // Whole vectors: what lies behind the last flight is an old one, and
        // harmless
        smoothAdvance((inFlight + 7) & ~7, smooth_, decide, f);
        ++step;
        if (step % 64 == 0)
        {
            for (int i = 0; i < inFlight; ++i)
            {
                if (!f.ended[i] && step - f.launched[i] > manySteps)
                {
                    finish(i);
                    f.ended[i] = 1;
                }
            }
        }
        if (decide)
        {
            int strikes[laneRoom];
            total.second += findLanes(inFlight, f.ended, 2, strikes);
            inFlight = removeEnded(f, inFlight);
            return;
        }
        int strikes[laneRoom];
        int m = findLanes(inFlight, f.ended, 2, strikes);
        packLanes<motionColumns>(inFlight, f.ended, 2, f.ex[0], again.ex[0]);
        for (int k = 0; k < m; ++k)
        {
            again.end[k] = f.t[strikes[k]] + f.tau[strikes[k]];
        }
        inFlight = removeEnded(f, inFlight);
        if (m > 0)
        {
            smoothTurn(m, smooth_, again);
            m = countStrikes(m);
            smoothImpact(m, smooth_, again);
            smoothCull(m, smooth_, decide, again);
            record(m);
        }
    };

    // Until no more than so many are left of each. What may be under way at
    // once, a batch and twice as many as are left, fits the room of either.
    static_assert(smoothBatch + 2*fewFlights <= smoothRoom, "room");
    auto follow = [&](int few)
    {
        while (hopping > few || inFlight > few)
        {
            hopping > few ? hop() : fly();
        }
    };

    for (int from = 0; from < n; from += smoothBatch)
    {
        const int m = std::min(smoothBatch, n - from);
        const bool isotropic =
            setup_.orientation == orientationLaw::isotropic;
        if (still && !smooth_.vertices)
        {
            smoothMeet
            (
                isotropic, setup_.seed, first + from, m, V, smooth_, decide, l
            );
        }
        else
        {
            smoothArrive
            (
                isotropic, setup_.seed, first + from, m, V, spin, smooth_, l
            );
            smoothImpact(m, smooth_, l);
        }
        const int into = tally(l, m);
        total.into += into;
        total.second += decide ? into : 0;
        std::copy_n(l.V[0], m, w.Vx + from);
        std::copy_n(l.V[1], m, w.Vy + from);
        std::copy_n(l.V[2], m, w.Vz + from);
        std::copy_n(l.spinEnergy, m, w.spinEnergy + from);
        for (int i = 0; i < m; ++i)
        {
            l.id[i] = from + i;
        }
        if (!hops_)
        {
            smoothCull(m, smooth_, decide, l);
        }
        launch(l, m);
        follow(fewFlights);
    }
    follow(0);
    total.addTo(result);
}
