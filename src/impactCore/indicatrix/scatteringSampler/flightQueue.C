/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "flightQueue.H"
#include "smoothInline.H"

namespace
{

using impact::findLanes;
using impact::flightColumns;
using impact::smoothFlights;

//- Room for the numbers of lanes
constexpr int laneRoom = impact::smoothRoom + impact::lanePadding;

//- Steps after which a flight is left to the general search
constexpr int manySteps = 100;


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
        impact::copyColumns<flightColumns>
            (laneOf(f, movers[j]), laneOf(f, ended[j]));
        f.launched[ended[j]] = f.launched[movers[j]];
    }
    return n - m;
}

} // End anonymous namespace


impact::scatteringSampler::flightQueue::flightQueue
(
    const scatteringSampler& sampler,
    workspace& work,
    visitCounts& total,
    bool decide
)
:
    sampler_(sampler),
    work_(work),
    total_(total),
    decide_(decide),
    small_(1e-3*mag(sampler.V1_))
{}


void impact::scatteringSampler::flightQueue::addCounts
(
    int m,
    const int counts[4]
)
{
    total_.impacts += counts[0];
    total_.micro += m - counts[0];
    total_.pulling += counts[1];
    total_.gaining += counts[2];
}


void impact::scatteringSampler::flightQueue::record
(
    int particle,
    const vector3& V,
    const vector3& omega
)
{
    work_.Vx[particle] = V.x;
    work_.Vy[particle] = V.y;
    work_.Vz[particle] = V.z;
    work_.spinEnergy[particle] =
        dot(multiply(sampler_.setup_.body.inertia(), omega), omega);
}


void impact::scatteringSampler::flightQueue::finish(int i)
{
    const smoothFlights& f = work_.flights;
    bodyState b;
    b.rotation.ex = at(f.ex, i);
    b.rotation.ey = at(f.ey, i);
    b.rotation.omega = at(f.w, i);
    b.V = at(f.V, i);
    b.x = 0.5*sampler_.flat_.period();
    b.y = f.y[i];
    const visitResult r =
        sampler_.visit_.resume(b, int(f.contacts[i]), work_.piece, 0);
    total_.addImpacts(r);
    total_.second += f.contacts[i] == 1 && r.second;
    record(int(f.id[i]), r.state.V, r.state.rotation.omega);
}


void impact::scatteringSampler::flightQueue::add
(
    int n,
    const int* mark,
    int value,
    const smoothLanes& lanes
)
{
    int list[laneRoom];
    const int found = findLanes(n, mark, value, list);
    smoothFlights& f = work_.flights;
    for (int k = 0; k < found; ++k)
    {
        copyColumns<motionColumns>(laneOf(lanes, list[k]), laneOf(f, n_ + k));
    }
    if (!sampler_.vectorFlights_)
    {
        for (int k = 0; k < found; ++k)
        {
            finish(n_ + k);
        }
        return;
    }
    std::fill_n(f.launched + n_, found, step_);
    smoothLaunch(n_, n_ + found, sampler_.smooth_, f);
    n_ += found;
}


void impact::scatteringSampler::flightQueue::fly()
{
    const smoothBody& body = sampler_.smooth_;
    smoothFlights& f = work_.flights;
    smoothLanes& struck = work_.struck;

    // Whole vectors: what lies behind the last flight is an old one, and
    // harmless
    smoothAdvance((n_ + 7) & ~7, body, decide_, f);
    ++step_;
    if (step_ % 64 == 0)
    {
        for (int i = 0; i < n_; ++i)
        {
            if (!f.ended[i] && step_ - f.launched[i] > manySteps)
            {
                finish(i);
                f.ended[i] = 1;
            }
        }
    }
    int strikes[laneRoom];
    const int m = findLanes(n_, f.ended, 2, strikes);
    if (decide_)
    {
        total_.second += m;
        n_ = removeEnded(f, n_);
        return;
    }
    int left = 0;
    for (int k = 0; k < m; ++k)
    {
        const int i = strikes[k];
        copyColumns<motionColumns>(laneOf(f, i), laneOf(struck, left));
        struck.end[left] = f.t[i] + f.tau[i];
        const bool strikes = f.contacts[i] < sampler_.setup_.maxImpacts;
        total_.second += strikes && f.contacts[i] == 1 ? 1 : 0;
        left += strikes ? 1 : 0;
    }
    total_.capped += m - left;
    n_ = removeEnded(f, n_);
    if (left > 0)
    {
        smoothTurn(left, body, struck);
        smoothTouch(left, body, struck);
        smoothImpact(left, body, struck);
        smoothCull(left, body, decide_, struck);
        int counts[4];
        smoothTally(left, small_, struck, counts);
        addCounts(left, counts);
        for (int i = 0; i < left; ++i)
        {
            record(int(struck.id[i]), at(struck.V, i), at(struck.w, i));
        }
        add(left, struck.mayReturn, 1, struck);
    }
}
