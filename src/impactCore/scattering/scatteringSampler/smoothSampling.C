/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "samplerWorkspace.H"

namespace
{

using impact::smoothFlights;
using impact::smoothLanes;

//- Flights that are not followed until a batch has been added
constexpr int fewFlights = 128;

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


//- Add the lanes place[0 ... m - 1] to n flights
void addFlights
(
    const smoothLanes& l,
    const int* place,
    int m,
    smoothFlights& f,
    int n
)
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
    if (setup_.law.law() != reboundLaw::lawType::restitution)
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
    smoothFlights& f = w.flights;
    int inFlight = 0;
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
        smoothImpact(struck, smooth_, again);
        tally(again, struck);
        for (int i = 0; i < struck; ++i)
        {
            record(again, i, particles[i]);
        }
        launch(again, struck, 0, particles, contacts);
    };

    for (int from = 0; from < n; from += smoothBatch)
    {
        const int m = std::min(smoothBatch, n - from);
        smoothArrive
        (
            setup_.orientation == orientationLaw::isotropic, setup_.seed,
            first + from, m, V, spin, smooth_, l
        );
        smoothImpact(m, smooth_, l);
        total.into += tally(l, m);
        for (int i = 0; i < m; ++i)
        {
            record(l, i, from + i);
        }
        launch(l, m, from, nullptr, nullptr);
        while (inFlight > fewFlights)
        {
            fly();
        }
    }
    while (inFlight > 0)
    {
        fly();
    }
    total.addTo(result);
}
