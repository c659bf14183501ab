/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "motionBlock.H"
#include "motionKernels.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Spheres>
void impact::motionBlock::rates
(
    int n,
    const Spheres& s,
    const gasRows& there,
    const row (&u)[3],
    const row (&spin)[3],
    const row& enthalpies,
    rateRows& r
) const
{
    const sphereForces& p = forces_;
    motionKernels::numbers q;
    row CdRe, magnus, clRe, T, TpOverT;
    motionKernels::reynolds
    (
        n, there, u, spin, s.d, heat_ ? heat_->gammaR() : p.gammaR_, q
    );
    if (heat_)
    {
        for (int i = 0; i < n; ++i)
        {
            T[i] = heat_->material().T(enthalpies[i]);
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
        n, there, u, spin, s.inverseRhoP, s.drag0, s.torque0, CdRe, magnus,
        clRe, p.g_, solved_, rotation_, r
    );
    if (heat_)
    {
        heat_->rates
        (
            n, q.Re, q.K, there.mu, there.T, s.convection0, s.radiation0, T,
            enthalpies, r.hDot, r.kHeat
        );
    }
    else
    {
        std::fill_n(r.hDot, n, 0.);
        std::fill_n(r.kHeat, n, 0.);
    }
}


void impact::motionBlock::longer::keep(int j, int i)
{
    if (i == j)
    {
        return;
    }
    index[i] = index[j];
    gas[i] = gas[j];
    for (row* r : {&d, &inverseRhoP, &drag0, &torque0, &convection0,
        &radiation0, &enthalpy, &h, &vScale, &spinScale, &hScale, &worst,
        &state.h})
    {
        (*r)[i] = (*r)[j];
    }
    for (int c = 0; c < 3; ++c)
    {
        for (row* r : {&x[c], &v[c], &omega[c], &state.x[c], &state.v[c],
            &state.omega[c]})
        {
            (*r)[i] = (*r)[j];
        }
        for (int stage = 0; stage < 4; ++stage)
        {
            k[stage].hDot[i] = k[stage].hDot[j];
            kx[stage][c][i] = kx[stage][c][j];
            k[stage].a[c][i] = k[stage].a[c][j];
            k[stage].alpha[c][i] = k[stage].alpha[c][j];
        }
    }
}


void impact::motionBlock::stages(int from, int to)
{
    longer& l = longer_;
    gasRows gasThere;
    row place[3];
    for (int stage = from; stage < to; ++stage)
    {
        motionKernels::sum
        (
            l.n, l.v, l.omega, l.enthalpy, l.h, l.kx, l.k,
            cashKarp::stage[stage], stage,
            l.other
        );
        for (int c = 0; c < 3; ++c)
        {
            for (int i = 0; i < l.n; ++i)
            {
                place[c][i] = l.x[c][i] + l.other.x[c][i];
                l.kx[stage][c][i] = l.other.v[c][i];
            }
        }
        motionKernels::gas(l.n, l.gas, place, gasThere);
        rates
        (
            l.n, l, gasThere, l.other.v, l.other.omega, l.other.h, l.k[stage]
        );
    }
}


void impact::motionBlock::accept(double limit, double nEvaluations, double root)
{
    longer& l = longer_;
    int kept = 0;
    for (int i = 0; i < l.n; ++i)
    {
        const int to = l.index[i];
        if (l.worst[i] <= 1)
        {
            set(last.x, to, of(l.state.x, i));
            set(last.v, to, of(l.state.v, i));
            set(last.omega, to, of(l.state.omega, i));
            last.h[to] = l.state.h[i];
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


void impact::motionBlock::goOn(int n)
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
        l.gas[to] = gas[i];
        l.d[to] = d[i];
        l.inverseRhoP[to] = inverseRhoP[i];
        l.drag0[to] = drag0[i];
        l.torque0[to] = torque0[i];
        l.convection0[to] = convection0[i];
        l.radiation0[to] = radiation0[i];
        l.enthalpy[to] = enthalpy[i];
        l.hScale[to] = hScale[i];
        l.k[0].hDot[to] = f.hDot[i];
        l.k[1].hDot[to] = g.hDot[i];
        l.other.h[to] = last.h[i];
        l.h[to] = h[i];
        l.vScale[to] = vScale[i];
        l.spinScale[to] = spinScale[i];
        set(l.x, to, of(x, i));
        set(l.v, to, of(v, i));
        set(l.omega, to, of(omega, i));
        set(l.kx[0], to, of(v, i));
        set(l.k[0].a, to, of(f.a, i));
        set(l.k[0].alpha, to, of(f.alpha, i));
        set(l.kx[1], to, of(middle.v, i));
        set(l.k[1].a, to, of(g.a, i));
        set(l.k[1].alpha, to, of(g.alpha, i));
        set(l.other.v, to, of(last.v, i));
        set(l.other.omega, to, of(last.omega, i));
    }
    if (l.n == 0)
    {
        return;
    }

    // Order 3 against 2. Errors of these orders and 5 grow as the third and
    // the sixth power of the step: see particleMotion::step.
    const stateRows second(l.other);
    stages(2, 4);
    motionKernels::sum
    (
        l.n, l.v, l.omega, l.enthalpy, l.h, l.kx, l.k, cashKarp::third, 4,
        l.state
    );
    motionKernels::error
    (
        l.n, l.state, second, l.vScale, l.spinScale, l.hScale, tolerance_,
        l.worst
    );
    accept(std::sqrt(tolerance_)/tolerance_, 4, 1./3);
    if (l.n == 0)
    {
        return;
    }

    // Order 5 against 4
    stages(4, 6);
    motionKernels::sum
    (
        l.n, l.v, l.omega, l.enthalpy, l.h, l.kx, l.k, cashKarp::fifth, 6,
        l.state
    );
    motionKernels::sum
    (
        l.n, l.v, l.omega, l.enthalpy, l.h, l.kx, l.k, cashKarp::fourth, 6,
        l.other
    );
    motionKernels::error
    (
        l.n, l.state, l.other, l.vScale, l.spinScale, l.hScale, tolerance_,
        l.worst
    );
    accept(0, 6, 1./5);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

impact::motionBlock::motionBlock
(
    const sphereForces& forces,
    const sphereHeat* heat,
    double tolerance,
    const vector3& solved,
    const vector3& rotation
)
:
    forces_(forces),
    heat_(heat),
    tolerance_(tolerance),
    solved_(solved),
    rotation_(rotation)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void impact::motionBlock::sphere(int i, double diameter, double rhoP)
{
    d[i] = diameter;
    inverseRhoP[i] = 1/rhoP;
    drag0[i] = 0.75/(rhoP*diameter*diameter);
    torque0[i] = rotationalTorque::scale(diameter, rhoP, 1);
    enthalpy[i] = 0;
    convection0[i] = heat_ ? heat_->convection(diameter, rhoP) : 0;
    radiation0[i] = heat_ ? heat_->radiation(diameter, rhoP) : 0;
}


void impact::motionBlock::move(int j, int i)
{
    d[i] = d[j];
    inverseRhoP[i] = inverseRhoP[j];
    drag0[i] = drag0[j];
    torque0[i] = torque0[j];
    convection0[i] = convection0[j];
    radiation0[i] = radiation0[j];
    enthalpy[i] = enthalpy[j];
    hTry[i] = hTry[j];
    gas[i] = gas[j];
    set(x, i, of(x, j));
    set(v, i, of(v, j));
    set(omega, i, of(omega, j));
}


void impact::motionBlock::begin(int n)
{
    motionKernels::gas(n, gas, x, here);
    rates(n, *this, here, v, omega, enthalpy, f);
}


void impact::motionBlock::end(int n)
{
    row place[3];
    motionKernels::stretch
    (
        n, x, v, omega, enthalpy, f, hMax, hTry, h, middle, place
    );
    motionKernels::gas(n, gas, place, there);
    rates(n, *this, there, middle.v, middle.omega, middle.h, g);
    motionKernels::end
    (
        n, here, v, omega, enthalpy, f, middle, g, h, tolerance_, last,
        vScale, spinScale, hScale, worst, power, accepted, more_
    );
    for (int i = 0; i < n; ++i)
    {
        nForces[i] = 2;
    }
    goOn(n);
}
