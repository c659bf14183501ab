/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "overlapRungeKutta.H"
#include "bracketedRoot.H"
#include "outOfRange.H"

#include <algorithm>

impact::overlapRungeKutta::overlapRungeKutta
(
    double alpha,
    unloadingType unloading,
    double step,
    bool interpolate
)
:
    alpha_(jkrMotion(alpha).alpha()),
    unloading_(unloading),
    step_(step),
    interpolate_(interpolate)
{
    checkRange("step", step, minStep, maxStep);
}


impact::motionOutcome impact::overlapRungeKutta::impact
(
    const jkrCurve& curve,
    double p0
) const
{
    motionOutcome out = {true, 0, 0, curve.uA(), 0, 0, 0};
    auto acceleration = [&](double overlap, double p)
    {
        ++out.evaluations;
        const double u = curve.uOf(overlap);
        return -curve.force(u) - alpha_*u*p;
    };
    const double end = curve.overlap(curve.uEnd(unloading_));
    const double barrier = curve.energy(curve.uEnd(unloading_));
    const double bottom = curve.energy(curve.uB());
    const double settled = bottom + 1e-12*(barrier - bottom);
    const bool noReturn = curve.beta() == 0 && alpha_ >= std::sqrt(5.);

    double x = 0, p = p0, time = 0;
    double xNew = 0, pNew = 0;
    auto advance = [&](double h)
    {
        const double a1 = acceleration(x, p);
        const double p2 = p + 0.5*h*a1;
        const double a2 = acceleration(x + 0.5*h*p, p2);
        const double p3 = p + 0.5*h*a2;
        const double a3 = acceleration(x + 0.5*h*p2, p3);
        const double p4 = p + h*a3;
        const double a4 = acceleration(x + h*p3, p4);
        xNew = x + h/6*(p + 2*p2 + 2*p3 + p4);
        pNew = p + h/6*(a1 + 2*a2 + 2*a3 + a4);
    };
    const double h = step_;
    bool turned = false;
    for (;;)
    {
        advance(h);

        // Hermite cubic of the overlap in the fraction of the step
        auto overlapAt = [&](double s)
        {
            const double r = 1 - s;
            return r*r*((1 + 2*s)*x + s*h*p)
              + s*s*((3 - 2*s)*xNew - r*h*pNew);
        };
        if (!turned && pNew <= 0)
        {
            turned = true;
            const double s = p > 0 ? p/(p - pNew) : 0;
            out.maxU = curve.uOf(std::max(overlapAt(s), 0.));
        }
        if (turned && xNew <= end && pNew < 0)
        {
            double part = 1;
            if (interpolate_)
            {
                part = bracketedRoot
                (
                    [&](double s) { return overlapAt(s) - end; }, 0, 1
                );
                advance(part*h);
            }
            out.exitSpeed = -pNew;
            out.captured = false;
            out.time = time + part*h;
            out.energy = 0.5*pNew*pNew + barrier;
            break;
        }
        x = xNew;
        p = pNew;
        time += h;
        const double energy = 0.5*p*p + curve.energy(curve.uOf(x));
        if
        (
            (turned && (energy < barrier || p >= 0 || noReturn))
         || energy <= settled
        )
        {
            out.maxU = turned ? out.maxU : curve.uOf(x);
            out.energy = energy;
            break;
        }
    }
    out.dissipated = 0.5*p0*p0 + curve.energy(curve.uA()) - out.energy;
    return out;
}
