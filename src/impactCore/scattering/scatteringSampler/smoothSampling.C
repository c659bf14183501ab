/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "samplerWorkspace.H"

#include <numeric>

namespace
{

using impact::lanesColumns;
using impact::motionColumns;
using impact::smoothFlights;
using impact::smoothMotion;
using impact::smoothStride;

//- Flights and hops that are not followed until a batch has been added
constexpr int fewFlights = 64;

//- Steps after which a flight is left to the general search
constexpr int manySteps = 100;


//- Take out the flights ended[0 ... m - 1], in rising order, of n: the last
//  ones come into their places. Returns the number left
int removeFlights(smoothFlights& f, int n, const int* ended, int m)
{
    const int left = n - m;
    int movers[impact::smoothRoom + 1];
    int moves = 0;
    for (int i = left; i < n; ++i)
    {
        movers[moves] = i;
        moves += f.ended[i] == 0;
    }
    const int fields = int((&f.status - f.ex)) + 1;
    for (int c = 0; c < fields; ++c)
    {
        double* x = f.ex[0] + c*smoothStride;
        for (int k = 0; k < moves; ++k)
        {
            x[ended[k]] = x[movers[k]];
        }
    }
    for (int k = 0; k < moves; ++k)
    {
        f.launched[ended[k]] = f.launched[movers[k]];
    }
    return left;
}


//- Copy columns of the lanes place[0 ... m - 1] without gaps
template<int columns>
void copyColumns(const double* from, const int* place, int m, double* to)
{
    for (int k = 0; k < m; ++k, ++to)
    {
        const double* x = from + place[k];
        #pragma GCC unroll 32
        for (int c = 0; c < columns; ++c)
        {
            to[c*smoothStride] = x[c*smoothStride];
        }
    }
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
    smoothLanes& landed = w.landed;
    smoothFlights& f = w.flights;
    int inFlight = 0;
    int step = 0;

    // Hops of this round and of the next; of the first ones it has been guessed
    // where they end
    smoothHops* now = &w.hops[0];
    smoothHops* next = &w.hops[1];
    int hopping = 0, guessed = 0;

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

    // Launch those of the lanes that may come back
    auto launch = [&](smoothLanes& lanes, int m)
    {
        total.second += smoothCull(m, smooth_, decide, lanes);
        int place[smoothRoom + 1];
        int k = 0;
        for (int i = 0; i < m; ++i)
        {
            place[k] = i;
            k += lanes.mayReturn[i] != 0 ? 1 : 0;
        }
        if (hops_)
        {
            smoothHops& hops = *now;
            copyColumns<motionColumns>
                (lanes.ex[0], place, k, hops.ex[0] + hopping);
            std::fill_n(hops.attempts + hopping, k, 0.);
            hopping += k;
            return;
        }
        copyColumns<motionColumns>(lanes.ex[0], place, k, f.ex[0] + inFlight);
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

    // Those of the lanes of again that have not struck too often
    auto leaveCapped = [&](int m)
    {
        int place[smoothRoom];
        int k = 0;
        for (int i = 0; i < m; ++i)
        {
            place[k] = i;
            k += again.contacts[i] < most ? 1 : 0;
        }
        if (k < m)
        {
            total.capped += m - k;
            copyColumns<lanesColumns>(again.ex[0], place, k, again.ex[0]);
        }
        return k;
    };

    // The lanes of again rebound. The state after an impact is the result
    // unless another one follows
    auto strike = [&](int m)
    {
        int second = 0;
        for (int i = 0; i < m; ++i)
        {
            second += again.contacts[i] == 1 ? 1 : 0;
        }
        total.second += second;
        m = leaveCapped(m);
        smoothImpact(m, smooth_, again);
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

    // All hops to their ends, as far as those are found at once, and the
    // impacts there
    auto hop = [&]
    {
        // Whole vectors, as below
        smoothHops& hops = *now;
        smoothHops& later = *next;
        const int n = hopping;
        const int whole = (n + 7) & ~7;
        smoothGuess(guessed, whole, smooth_, decide, hops);
        decide ? smoothDecide(whole, smooth_, hops)
          : smoothLand(whole, smooth_, hops, landed);
        int open[smoothRoom + 1], hits[smoothRoom + 1];
        int stay[smoothRoom + 1], clear[smoothRoom + 1];
        int m = 0, struck = 0, stays = 0, clears = 0;
        for (int i = 0; i < n; ++i)
        {
            const int outcome = int(hops.outcome[i]);
            open[m] = hits[struck] = stay[stays] = clear[clears] = i;
            m += outcome == int(hopOutcome::open) ? 1 : 0;
            struck += outcome == int(hopOutcome::strikes) ? 1 : 0;
            stays += outcome == int(hopOutcome::again) ? 1 : 0;
            clears += outcome == int(hopOutcome::clear) ? 1 : 0;
        }

        // Those that the steps of the flights are to follow
        copyColumns<motionColumns>(hops.ex[0], open, m, f.ex[0] + inFlight);
        std::fill_n(f.launched + inFlight, m, step);
        smoothLaunch(inFlight, inFlight + m, smooth_, f);
        inFlight += m;

        if (decide)
        {
            total.second += struck;
            hopping = guessed = 0;
            return;
        }
        copyColumns<motionColumns>(hops.ex[0], hits, struck, again.ex[0]);
        copyColumns<3>(landed.r[0], hits, struck, again.r[0]);
        copyColumns<hopColumns>(hops.ex[0], stay, stays, later.ex[0]);
        copyColumns<hopColumns>(hops.ex[0], clear, clears, later.ex[0] + stays);
        guessed = stays;
        hopping = stays + clears;
        std::swap(now, next);
        strike(struck);
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
        int ended[smoothRoom + 1], hits[smoothRoom + 1];
        int m = 0;
        for (int i = 0; i < inFlight; ++i)
        {
            ended[m] = i;
            m += f.ended[i] != 0;
        }
        int struck = 0;
        for (int k = 0; k < m; ++k)
        {
            hits[struck] = ended[k];
            struck += f.ended[ended[k]] >> 1;
        }
        if (decide)
        {
            total.second += struck;
            inFlight = removeFlights(f, inFlight, ended, m);
            return;
        }
        double times[smoothRoom];
        for (int k = 0; k < struck; ++k)
        {
            times[k] = f.t[hits[k]] + f.tau[hits[k]];
        }
        copyColumns<motionColumns>(f.ex[0], hits, struck, again.ex[0]);
        inFlight = removeFlights(f, inFlight, ended, m);
        if (struck > 0)
        {
            smoothTurn(struck, smooth_, times, again);
            strike(struck);
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
                (isotropic, setup_.seed, first + from, m, V, smooth_, l);
        }
        else
        {
            smoothArrive
            (
                isotropic, setup_.seed, first + from, m, V, spin, smooth_, l
            );
            smoothImpact(m, smooth_, l);
        }
        total.into += tally(l, m);
        std::copy_n(l.V[0], m, w.Vx + from);
        std::copy_n(l.V[1], m, w.Vy + from);
        std::copy_n(l.V[2], m, w.Vz + from);
        std::copy_n(l.spinEnergy, m, w.spinEnergy + from);
        std::iota(l.id, l.id + m, double(from));
        launch(l, m);
        follow(fewFlights);
    }
    follow(0);
    total.addTo(result);
}
