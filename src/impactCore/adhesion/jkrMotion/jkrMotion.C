/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "jkrMotion.H"
#include "outOfRange.H"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

using namespace impact;

//- Right-hand side of the motion in u, p, time and dissipated energy
struct motionRate
{
    double beta, alpha;

    // Bound on u: a stage of a step that is far too long, and refused
    // afterwards, must not overflow
    double largest;

    void operator()
    (
        const std::array<double, 4>& y,
        std::array<double, 4>& rate
    ) const
    {
        const double u = std::clamp(y[0], -largest, largest), p = y[1];
        const double c = u*u*u;
        const double slope = 4*c - beta;
        const double damping = alpha*u*p;
        rate[0] = p;
        rate[1] = -slope*(c*(c - 1.5*beta) + damping);
        rate[2] = slope;
        rate[3] = slope*damping*p;
    }
};


//- The same backward in s; u and p alone
struct backwardRate
{
    double beta, alpha, largest;

    void operator()
    (
        const std::array<double, 2>& y,
        std::array<double, 2>& rate
    ) const
    {
        const double u = std::clamp(y[0], -largest, largest), p = y[1];
        const double c = u*u*u;
        rate[0] = -p;
        rate[1] = (4*c - beta)*(c*(c - 1.5*beta) + alpha*u*p);
    }
};


inline double fourth(double u)
{
    return (u*u)*(u*u);
}


inline double localSpeed(double u, double p)
{
    const double x = fourth(u)*u;
    return std::sqrt(p*p + x*x);
}


//- Logarithm of the speed p at the overlap 0 that a motion without adhesion
//  had, of which u and p are given
double logHertzStart(double u, double p, double alpha)
{
    // x = u^5 and dx/dtau = p make a linear oscillator, x = r cos(phase),
    // (p + decay x)/omega = -r sin(phase), that started at phase = -pi/2
    const double x = fourth(u)*u;
    const double decay = 0.4*alpha;
    const double omega = std::sqrt(0.8 - decay*decay);
    const double q = (p + decay*x)/omega;
    double phase = std::atan2(-q, x);
    if (phase < -0.5*M_PI)
    {
        phase += 2*M_PI;
    }
    return std::log(omega*std::hypot(x, q))
      + decay*(phase + 0.5*M_PI)/omega;
}

} // End anonymous namespace


impact::jkrMotion::jkrMotion
(
    double alpha,
    unloadingType unloading,
    double tolerance
)
:
    alpha_(alpha),
    unloading_(unloading),
    tolerance_(tolerance)
{
    checkRange("alpha", alpha, 0, 10);
    checkRange("tolerance", tolerance, 1e-14, 1e-3);
}


impact::motionOutcome impact::jkrMotion::follow
(
    const jkrCurve& curve,
    double p0,
    const observer& see
) const
{
    motionRate rate = {curve.beta(), alpha_, 4};
    const double uA = curve.uA();
    const double uEnd = curve.uEnd(unloading_);
    const double barrier = curve.energy(uEnd);
    const double bottom = curve.energy(curve.uB());
    const double uB4 = fourth(curve.uB());

    // Speeds and energies below these do not matter to the outcome
    const double minSpeed = uB4*curve.uB();
    const double settled = bottom + 1e-12*(barrier - bottom);
    const double start = std::max(p0, minSpeed);
    const bool noReturn = curve.beta() == 0 && alpha_ >= std::sqrt(5.);

    motionOutcome out = {true, 0, 0, uA, 0, 0, 0};
    integrator step(rate, {uA, p0, 0, 0});
    double h = 0.1/start;
    bool turned = false;        // the first maximum is behind
    for (;;)
    {
        // Twice what the energy allows: u^10 < (5/4) p^2 without adhesion
        rate.largest = 2
           *(
                curve.uB()
              + std::max
                (
                    std::fabs(step.begin()[0]),
                    1.1*std::pow(std::fabs(step.begin()[1]), 0.2)
                )
            );
        step.attempt(rate, h);
        const integrator::state y = step.end();
        const double speed =
            std::sqrt(std::max(localSpeed(y[0], y[1]), minSpeed)*start);
        const double error =
            step.error({(5*fourth(y[0]) + uB4)/speed, 1/speed, 0, 0})
           /tolerance_;
        if (error > 1)
        {
            h *= integrator::factor(error);
            continue;
        }
        const bool turns = !turned && y[1] <= 0;
        const bool returns = turned && step.begin()[1] < 0 && y[1] >= 0;
        if (turns || returns || y[0] <= uEnd || see)
        {
            step.interpolate(rate);
        }
        if (turns)
        {
            turned = true;
            out.maxU = step.at(0, step.when(1, 0, 1));
        }

        // Hard unloading ends on the slope of the potential, from where the
        // motion could return within a step
        const double last = returns ? step.when(1, 0, 1) : 1;
        const double minOverlap = returns ? step.at(0, last) : y[0];
        if (turned && minOverlap <= uEnd)
        {
            // Step again to the end itself; the rest is below round-off
            step.attempt(rate, h*step.when(0, uEnd, last));
            const integrator::state& end = step.end();
            const integrator::state& r = step.endRate();
            const double ds = (uEnd - end[0])/r[0];
            out.captured = false;
            out.exitSpeed = -(end[1] + r[1]*ds);
            out.time = end[2] + r[2]*ds;
            out.dissipated = end[3] + r[3]*ds;
            out.energy = 0.5*out.exitSpeed*out.exitSpeed + barrier;
            if (see)
            {
                step.interpolate(rate);
                see(step);
            }
            break;
        }

        bool done = see && !see(step);
        if (!see)
        {
            const double energy = 0.5*y[1]*y[1] + curve.energy(y[0]);
            done =
                (turned && (energy < barrier || y[1] >= 0 || noReturn))
             || energy <= settled;
        }
        if (done)
        {
            out.maxU = turned ? out.maxU : y[0];
            out.dissipated = y[3];
            out.energy = 0.5*y[1]*y[1] + curve.energy(y[0]);
            break;
        }
        step.accept();
        h *= integrator::factor(error);
    }
    out.evaluations = step.evaluations();
    return out;
}


double impact::jkrMotion::hertzRestitution(double alpha)
{
    const double d = 5 - alpha*alpha;
    return d > 0 ? std::exp(-M_PI*alpha/std::sqrt(d)) : 0;
}


double impact::jkrMotion::separationSpeed()
{
    return std::sqrt(2*jkrCurve(2./3).separationWork(unloadingType::soft));
}


double impact::jkrMotion::captureSpeed() const
{
    const double infinity = std::numeric_limits<double>::infinity();
    if (alpha_ >= std::sqrt(5.))
    {
        return infinity;
    }
    const jkrCurve curve(2./3);
    const double uA = curve.uA();
    const double uEnd = curve.uEnd(unloading_);
    double u = uEnd, p = 0;
    if (unloading_ == unloadingType::soft)
    {
        // Off the saddle along its stable direction: far enough to move, and
        // near enough for the curvature of the manifold not to matter
        const double rate = std::sqrt(-12*u*u*curve.force(u));
        const double x = 1e-9;
        u += x;
        p = -rate*x;
    }

    // Adhesion is below round-off from here on
    const double large = 1e5;

    typedef dormandPrince8<2> integrator;
    backwardRate rate = {curve.beta(), alpha_, 4};
    integrator step(rate, {u, p});
    double h = 0.1;
    for (;;)
    {
        rate.largest = 4*(1 + step.begin()[0]);
        step.attempt(rate, h);
        const integrator::state y = step.end();
        const double speed = std::max(localSpeed(y[0], y[1]), 1e-9);
        const double error =
            step.error({(5*fourth(y[0]) + 1)/speed, 1/speed})/tolerance_;
        if (error > 1)
        {
            h *= integrator::factor(error);
            continue;
        }
        if (y[1] > 0 && y[0] <= uA)
        {
            step.interpolate(rate);
            step.attempt(rate, h*step.when(0, uA, 1));
            const integrator::state& end = step.end();
            const integrator::state& r = step.endRate();
            return end[1] + r[1]*(uA - end[0])/r[0];
        }
        if (y[0] > large)
        {
            const double logSpeed = logHertzStart(y[0], y[1], alpha_);
            return logSpeed < 700 ? std::exp(logSpeed) : infinity;
        }
        step.accept();
        h *= integrator::factor(error);
    }
}
