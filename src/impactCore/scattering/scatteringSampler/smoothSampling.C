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


//- Put flight j in the place of flight i
void moveFlight(smoothFlights& f, int j, int i)
{
    const std::size_t stride = sizeof(smoothFlights::lane)/sizeof(double);
    const int fields = int(&f.status - f.ex) + 1;
    double* x = f.ex[0];
    for (int k = 0; k < fields; ++k)
    {
        x[k*stride + i] = x[k*stride + j];
    }
    f.id[i] = f.id[j];
    f.contacts[i] = f.contacts[j];
    f.launched[i] = f.launched[j];
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
        int may[smoothBatch];
        int place[smoothBatch + 1];
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
                f.ended[i] |= step - f.launched[i] > manySteps;
            }
        }
        int ended[smoothFlights::room + 1];
        int m = 0;
        for (int i = 0; i < inFlight; ++i)
        {
            ended[m] = i;
            m += f.ended[i];
        }
        int particles[smoothBatch], contacts[smoothBatch];
        double times[smoothBatch];
        int struck = 0;
        for (int k = m - 1; k >= 0; --k)
        {
            const int i = ended[k];
            if (f.status[i] == 2)
            {
                total.second += f.contacts[i] == 1;
                if (!decide && f.contacts[i] >= setup_.maxImpacts)
                {
                    ++total.capped;
                }
                else if (!decide)
                {
                    if (struck == smoothBatch)
                    {
                        // Stays where it is until the next step
                        total.second -= f.contacts[i] == 1;
                        continue;
                    }
                    for (int c = 0; c < 3; ++c)
                    {
                        again.ex[c][struck] = f.ex[c][i];
                        again.ey[c][struck] = f.ey[c][i];
                        again.w[c][struck] = f.w[c][i];
                        again.V[c][struck] = f.V[c][i];
                    }
                    times[struck] = f.t[i] + f.tau[i];
                    particles[struck] = f.id[i];
                    contacts[struck] = f.contacts[i] + 1;
                    ++struck;
                }
            }
            else if (f.status[i] == 0)
            {
                finish(i);
            }
            --inFlight;
            if (i < inFlight)
            {
                moveFlight(f, inFlight, i);
            }
        }
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
