/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "samplerWorkspace.H"

namespace
{

using impact::smoothFlights;
using impact::smoothLanes;

//- Flights and hops that are not followed until a batch has been added
constexpr int fewFlights = 64;

//- Attempts to bring a hop to its end before it is left to the search step by
//  step
constexpr int manyAttempts = 2;

//- Steps after which a flight is left to the general search
constexpr int manySteps = 100;


//- Take out the flights ended[0 ... m - 1], in rising order, of n: the last
//  ones come into their places. Returns the number left
int removeFlights(smoothFlights& f, int n, const int* ended, int m)
{
    const int left = n - m;
    int movers[smoothFlights::room + 1];
    int moves = 0;
    for (int i = left; i < n; ++i)
    {
        movers[moves] = i;
        moves += f.ended[i] == 0;
    }
    const std::size_t stride = sizeof(smoothFlights::lane)/sizeof(double);
    const int fields = int(&f.status - f.ex) + 1;
    for (int c = 0; c < fields; ++c)
    {
        double* x = f.ex[0] + c*stride;
        for (int k = 0; k < moves; ++k)
        {
            x[ended[k]] = x[movers[k]];
        }
    }
    for (int* x : {f.id, f.contacts, f.launched})
    {
        for (int k = 0; k < moves; ++k)
        {
            x[ended[k]] = x[movers[k]];
        }
    }
    return left;
}


//- Copy the motion of the places place[0 ... m - 1] behind n others
template<class From, class To>
void copyMotion(const From& l, const int* place, int m, To& f, int n)
{
    for (int c = 0; c < 3; ++c)
    {
        for (int k = 0; k < m; ++k)
        {
            const int i = place[k];
            f.ex[c][n + k] = l.ex[c][i];
            f.ey[c][n + k] = l.ey[c][i];
            f.w[c][n + k] = l.w[c][i];
            f.V[c][n + k] = l.V[c][i];
        }
    }
}


//- Add the lanes place[0 ... m - 1], on the wall, to n flights or hops
template<class Flights>
void addFlights
(
    const smoothLanes& l,
    const int* place,
    int m,
    Flights& f,
    int n
)
{
    copyMotion(l, place, m, f, n);
    for (int k = 0; k < m; ++k)
    {
        const int i = place[k];
        f.y[n + k] =
           -(
                l.r[0][i]*l.ey[0][i] + l.r[1][i]*l.ey[1][i]
              + l.r[2][i]*l.ey[2][i]
            );
        f.approach[n + k] = l.approach[i];
    }
}


//- Add the hops place[0 ... m - 1] to n flights or hops
template<class Flights>
void addHops
(
    const impact::smoothHops& h,
    const int* place,
    int m,
    Flights& f,
    int n
)
{
    copyMotion(h, place, m, f, n);
    for (int k = 0; k < m; ++k)
    {
        const int i = place[k];
        f.y[n + k] = h.y[i];
        f.approach[n + k] = h.approach[i];
        f.id[n + k] = h.id[i];
        f.contacts[n + k] = h.contacts[i];
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
    visitCounts total;
    smoothLanes& l = w.lanes;
    smoothLanes& again = w.struck;
    smoothLanes& landed = w.landed;
    smoothFlights& f = w.flights;
    int inFlight = 0;
    int step = 0;

    // Hops of the next round; of the first ones the end is known already
    smoothHops* hops = &w.hops[0];
    smoothHops* later = &w.hops[1];
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

    // The state after an impact is the result unless another one follows
    auto record = [&](const smoothLanes& lanes, int i, int particle)
    {
        w.Vx[particle] = lanes.V[0][i];
        w.Vy[particle] = lanes.V[1][i];
        w.Vz[particle] = lanes.V[2][i];
        w.spinEnergy[particle] =
            J.x*lanes.w[0][i]*lanes.w[0][i] + J.y*lanes.w[1][i]*lanes.w[1][i]
          + J.z*lanes.w[2][i]*lanes.w[2][i];
    };

    // The rest of the visit of flight i outside the kernels
    auto finish = [&](int i)
    {
        const bodyState b = stateOf(f, i, 0.5*flat_.period());
        const visitResult r = visit_.resume(b, f.contacts[i], w.piece, 0);
        total.addImpacts(r);
        total.second += f.contacts[i] == 1 && r.second;
        const vector3& omega = r.state.rotation.omega;
        const int particle = f.id[i];
        w.Vx[particle] = r.state.V.x;
        w.Vy[particle] = r.state.V.y;
        w.Vz[particle] = r.state.V.z;
        w.spinEnergy[particle] = dot(multiply(J, omega), omega);
    };

    // Launch those of the lanes that may come back. Their particles are
    // number base + i, or of a list
    auto launch = [&]
    (
        const smoothLanes& lanes,
        int m,
        int base,
        const int* particles,
        const int* contacts
    )
    {
        int may[smoothFlights::room];
        int place[smoothFlights::room + 1];
        place[0] = 0;
        total.second += smoothCull(m, smooth_, lanes, decide, may);
        int k = 0;
        for (int i = 0; i < m; ++i)
        {
            place[k] = i;
            k += may[i];
        }
        if (hops_)
        {
            addFlights(lanes, place, k, *hops, hopping);
            for (int j = 0; j < k; ++j)
            {
                const int i = place[j];
                hops->id[hopping + j] = particles ? particles[i] : base + i;
                hops->contacts[hopping + j] = contacts ? contacts[i] : 1;
                hops->attempts[hopping + j] = 0;
            }
            hopping += k;
            return;
        }
        addFlights(lanes, place, k, f, inFlight);
        for (int j = 0; j < k; ++j)
        {
            const int i = place[j];
            f.id[inFlight + j] = particles ? particles[i] : base + i;
            f.contacts[inFlight + j] = contacts ? contacts[i] : 1;
            f.launched[inFlight + j] = step;
        }
        if (!vectorFlights_)
        {
            for (int j = 0; j < k; ++j)
            {
                finish(inFlight + j);
            }
            return;
        }
        smoothLaunch(inFlight, inFlight + k, smooth_, f);
        inFlight += k;
    };

    // The lanes of again rebound
    auto strike = [&](int m, const int* particles, const int* contacts)
    {
        smoothImpact(m, smooth_, again);
        tally(again, m);
        for (int i = 0; i < m; ++i)
        {
            record(again, i, particles[i]);
        }
        launch(again, m, 0, particles, contacts);
    };

    // Hops that the steps of the flights are to follow
    auto leaveToSteps = [&](const smoothHops& h, const int* place, int m)
    {
        addHops(h, place, m, f, inFlight);
        std::fill_n(f.launched + inFlight, m, step);
        smoothLaunch(inFlight, inFlight + m, smooth_, f);
        inFlight += m;
    };

    // All hops to their ends, as far as those are found at once, and the
    // impacts there
    auto hop = [&]
    {
        // Whole vectors, as below
        const int n = hopping;
        const int whole = (n + 7) & ~7;
        smoothHops& h = *hops;
        smoothGuess(guessed, whole, smooth_, decide, h);
        int open[smoothHops::room + 1];
        int m = 0;
        if (decide)
        {
            smoothDecide(whole, smooth_, h);
            for (int i = 0; i < n; ++i)
            {
                total.second += h.outcome[i] == hopOutcome::strikes;
                open[m] = i;
                m += h.outcome[i] == hopOutcome::open;
            }
            hopping = guessed = 0;
            leaveToSteps(h, open, m);
            return;
        }

        smoothLand(whole, smooth_, h, landed);
        int nearly[smoothHops::room + 1], struck[smoothHops::room + 1];
        int close = 0, hits = 0;
        for (int i = 0; i < n; ++i)
        {
            const int outcome = int(h.outcome[i]);
            const int more = h.attempts[i] < manyAttempts;
            const int isClose = outcome == int(hopOutcome::nearly);
            open[m] = nearly[close] = struck[hits] = i;
            m += (outcome == int(hopOutcome::open)) | (isClose & !more);
            close += isClose & more;
            hits += outcome == int(hopOutcome::strikes);
        }
        addHops(h, nearly, close, *later, 0);
        for (int j = 0; j < close; ++j)
        {
            const int i = nearly[j];
            later->t[j] = h.t[i];
            later->outcome[j] = h.outcome[i];
            later->attempts[j] = h.attempts[i] + 1;
        }
        leaveToSteps(h, open, m);

        // Those that strike, but for those that have done so too often
        int particles[smoothHops::room], contacts[smoothHops::room];
        int k = 0;
        for (int j = 0; j < hits; ++j)
        {
            const int i = struck[j];
            struck[k] = i;
            particles[k] = h.id[i];
            contacts[k] = h.contacts[i] + 1;
            total.second += h.contacts[i] == 1;
            k += h.contacts[i] < setup_.maxImpacts;
        }
        total.capped += hits - k;
        copyMotion(landed, struck, k, again, 0);
        for (int c = 0; c < 3; ++c)
        {
            for (int j = 0; j < k; ++j)
            {
                again.r[c][j] = landed.r[c][struck[j]];
            }
        }
        std::swap(hops, later);
        hopping = guessed = close;
        strike(k, particles, contacts);
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
        int ended[smoothFlights::room + 1], hits[smoothFlights::room + 1];
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
        int particles[smoothFlights::room], contacts[smoothFlights::room];
        double times[smoothFlights::room];
        int k = 0;
        for (int h = 0; h < struck; ++h)
        {
            const int i = hits[h];
            hits[k] = i;
            times[k] = f.t[i] + f.tau[i];
            particles[k] = f.id[i];
            contacts[k] = f.contacts[i] + 1;
            total.second += f.contacts[i] == 1;
            k += f.contacts[i] < setup_.maxImpacts;
        }
        total.capped += struck - k;
        struck = k;
        for (int c = 0; c < 3; ++c)
        {
            for (int h = 0; h < struck; ++h)
            {
                again.ex[c][h] = f.ex[c][hits[h]];
                again.ey[c][h] = f.ey[c][hits[h]];
                again.w[c][h] = f.w[c][hits[h]];
                again.V[c][h] = f.V[c][hits[h]];
            }
        }
        inFlight = removeFlights(f, inFlight, ended, m);
        if (struck == 0)
        {
            return;
        }
        smoothTurn(struck, smooth_, times, again);
        strike(struck, particles, contacts);
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
        for (int i = 0; i < m; ++i)
        {
            record(l, i, from + i);
        }
        launch(l, m, from, nullptr, nullptr);
        follow(fewFlights);
    }
    follow(0);
    total.addTo(result);
}
