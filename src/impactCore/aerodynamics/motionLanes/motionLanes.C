/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "motionLanes.H"
#include "motionKernels.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void impact::motionLanes::gasAt
(
    int n,
    const spheres& s,
    const row (&x)[3],
    gasRows& g
) const
{
    motionKernels::gas(n, s.gas, x, g);
    for (int c = 0; eddies_ && c < 3; ++c)
    {
        for (int i = 0; i < n; ++i)
        {
            g.u[c][i] += s.eddy[c][i];
        }
    }
}


void impact::motionLanes::rates
(
    int n,
    const spheres& s,
    const row (&x)[3],
    const gasRows& there,
    const stateRows& state,
    rateRows& r
) const
{
    const sphereForces& p = forces_;
    motionKernels::numbers q;
    row CdRe, magnus, clRe, T, TpOverT;
    motionKernels::reynolds
    (
        n, there, state, s.d, heat_ ? heat_->gammaR() : p.gammaR_, q
    );
    if (heat_)
    {
        for (int i = 0; i < n; ++i)
        {
            T[i] = heat_->material().T(state.h[i]);
            TpOverT[i] = T[i]/there.T[i];
        }
    }
    if (p.drag_)
    {
        p.drag_->CdRe(n, q.Re, q.K, heat_ ? TpOverT : nullptr, CdRe);
    }
    double beyondRe = 0, beyondSpin = 0;
    for (int i = 0; i < n; ++i)
    {
        if (!p.drag_)
        {
            CdRe[i] = 0;
        }
        magnus[i] =
            p.magnus_ ? magnusLift::coefficient(q.Re[i], q.ReOmega[i]) : 0;
        clRe[i] = p.torque_ ? rotationalTorque::clRe(q.ReOmega[i]) : 0;
        beyondRe += !magnusLift::inRange(q.Re[i]);
        beyondSpin += !rotationalTorque::inRange(q.ReOmega[i]);
    }
    if (p.magnus_)
    {
        p.counts_->magnus += n;
        p.counts_->magnusOutside += beyondRe;
    }
    if (p.torque_)
    {
        p.counts_->torque += n;
        p.counts_->torqueOutside += beyondSpin;
    }
    motionKernels::rates
    (
        n, there, state, s, CdRe, magnus, clRe, p.g_, solved_, rotation_, r
    );
    if (secondary_.any())
    {
        addSecondary(n, s, x, there, state.v, r);
    }
    if (heat_)
    {
        heat_->rates
        (
            n, q.Re, q.K, there.mu, there.T, s.convection0, s.radiation0, T,
            state.h, r.hDot, r.kHeat
        );
    }
    else
    {
        std::fill_n(r.hDot, n, 0.);
        std::fill_n(r.kHeat, n, 0.);
    }
}


void impact::motionLanes::addSecondary
(
    int n,
    const spheres& s,
    const row (&x)[3],
    const gasRows& there,
    const row (&v)[3],
    rateRows& r
) const
{
    for (int i = 0; i < n; ++i)
    {
        const gasState gas
        {
            of(there.u, i), of(there.spin, i), there.rho[i], there.mu[i],
            there.T[i]
        };
        motionRate rate;
        rate.a = of(r.a, i);
        rate.turn = of(r.turn, i);
        rate.k = r.k[i];
        secondary_.add
        (
            *s.gas[i], gas, of(x, i), of(v, i), s.d[i], s.inverseRhoP[i], rate
        );
        set(r.a, i, multiply(solved_, rate.a));
        set(r.turn, i, multiply(rotation_, rate.turn));
        r.k[i] = rate.k;
    }
}


void impact::motionLanes::spheres::take(const spheres& from, int j, int i)
{
    copy<stateRows>(from, j, *this, i);
    copy<constantRows>(from, j, *this, i);
    gas[i] = from.gas[j];
}


void impact::motionLanes::longer::keep(int j, int i)
{
    if (i == j)
    {
        return;
    }
    take(*this, j, i);
    index[i] = index[j];
    step[i] = step[j];
    worst[i] = worst[j];
    copy(scales, j, scales, i);
    copy(state, j, state, i);
    for (int stage = 0; stage < 4; ++stage)
    {
        copy(kx[stage], j, kx[stage], i);
        copy(k[stage], j, k[stage], i);
    }
}


void impact::motionLanes::stages(int from, int to)
{
    longer& l = longer_;
    gasRows gasThere;
    row place[3];
    for (int stage = from; stage < to; ++stage)
    {
        motionKernels::sum
        (
            l.n, l, l.step, l.kx, l.k, cashKarp::stage[stage], stage, l.other
        );
        for (int c = 0; c < 3; ++c)
        {
            for (int i = 0; i < l.n; ++i)
            {
                place[c][i] = l.x[c][i] + l.other.x[c][i];
                l.kx[stage][c][i] = l.other.v[c][i];
            }
        }
        gasAt(l.n, l, place, gasThere);
        rates(l.n, l, place, gasThere, l.other, l.k[stage]);
    }
}


void impact::motionLanes::accept(double limit, double nEvaluations, double root)
{
    longer& l = longer_;
    int kept = 0;
    for (int i = 0; i < l.n; ++i)
    {
        const int to = l.index[i];
        if (l.worst[i] <= 1)
        {
            copy(l.state, i, last, to);
            worst[to] = l.worst[i];
            power[to] = root;
            nForces[to] = nEvaluations;
            accepted[to] = 1;
        }
        else if (l.worst[i] <= limit)
        {
            l.keep(i, kept++);
        }
    }
    l.n = kept;
}


void impact::motionLanes::goOn(int n)
{
    longer& l = longer_;
    l.n = 0;
    for (int i = 0; i < n; ++i)
    {
        if (!(more_[i] > 0))
        {
            continue;
        }
        const int to = l.n++;
        l.index[to] = i;
        l.take(now, i, to);
        l.step[to] = h[i];
        copy(scales, i, l.scales, to);
        copy(now.v, i, l.kx[0], to);
        copy(f, i, l.k[0], to);
        copy(middle.v, i, l.kx[1], to);
        copy(g, i, l.k[1], to);
        copy(last, i, l.other, to);
    }
    if (l.n == 0)
    {
        return;
    }

    // Order 3 against 2. Errors of these orders and 5 grow as the third and
    // the sixth power of the step: see particleMotion::step.
    const stateRows second(l.other);
    stages(2, 4);
    motionKernels::sum(l.n, l, l.step, l.kx, l.k, cashKarp::third, 4, l.state);
    motionKernels::error(l.n, l.state, second, l.scales, tolerance_, l.worst);
    accept(std::sqrt(tolerance_)/tolerance_, 4, 1./3);
    if (l.n == 0)
    {
        return;
    }

    // Order 5 against 4
    stages(4, 6);
    motionKernels::sum(l.n, l, l.step, l.kx, l.k, cashKarp::fifth, 6, l.state);
    motionKernels::sum
    (
        l.n, l, l.step, l.kx, l.k, cashKarp::fourth, 6, l.other
    );
    motionKernels::error(l.n, l.state, l.other, l.scales, tolerance_, l.worst);
    accept(0, 6, 1./5);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

impact::motionLanes::motionLanes
(
    const sphereForces& forces,
    const sphereHeat* heat,
    double tolerance,
    const vector3& solved,
    const vector3& rotation,
    bool eddies,
    const secondaryForces& secondary
)
:
    forces_(forces),
    heat_(heat),
    tolerance_(tolerance),
    solved_(solved),
    rotation_(rotation),
    eddies_(eddies),
    secondary_(secondary)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void impact::motionLanes::sphere(int i, double diameter, double rhoP)
{
    now.d[i] = diameter;
    now.inverseRhoP[i] = 1/rhoP;
    now.drag0[i] = sphereForces::dragScale(diameter, rhoP);
    now.torque0[i] = rotationalTorque::scale(diameter, rhoP, 1);
    now.convection0[i] = heat_ ? heat_->convection(diameter, rhoP) : 0;
    now.radiation0[i] = heat_ ? heat_->radiation(diameter, rhoP) : 0;
    now.h[i] = 0;
    set(now.eddy, i, vector3{0, 0, 0});
}


void impact::motionLanes::move(int j, int i)
{
    now.take(now, j, i);
    hTry[i] = hTry[j];
}


void impact::motionLanes::begin(int n)
{
    gasAt(n, now, now.x, here);
    rates(n, now, now.x, here, now, f);
}


void impact::motionLanes::end(int n)
{
    row place[3];
    motionKernels::stretch(n, now, f, hMax, hTry, h, middle, place);
    gasAt(n, now, place, there);
    rates(n, now, place, there, middle, g);
    motionKernels::end
    (
        n, here, now, f, middle, g, h, tolerance_, last, scales, worst, power,
        accepted, more_
    );
    for (int i = 0; i < n; ++i)
    {
        nForces[i] = 2;
    }
    goOn(n);
}
