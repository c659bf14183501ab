/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "jkrImpact.H"
#include "outOfRange.H"
#include "overlapRungeKutta.H"

#include <cmath>
#include <sstream>

void impact::jkrImpact::refuse(double speed)
{
    throwOutOfRange("speed", speed, "(0, inf) m/s");
}


impact::jkrImpact::jkrImpact
(
    const jkrContact& contact,
    double alpha,
    const impactSettings& settings
)
:
    contact_(contact),
    settings_(settings),
    motion_(alpha, settings.unloading, settings.tolerance),
    inverseSeparationSpeed_(0),
    captureSpeed_
    (
        jkrMotion(alpha, settings.unloading, 1e-13).captureRatio()
    )
{
    if (settings.scheme == impactScheme::table)
    {
        curve_.emplace(alpha, settings.unloading);
    }

    // Without adhesion only the strongest damping captures
    const double separationSpeed = contact.separationSpeed();
    if (separationSpeed > 0)
    {
        inverseSeparationSpeed_ = 1/separationSpeed;
    }
    if (std::isfinite(captureSpeed_))
    {
        captureSpeed_ *= separationSpeed;
    }
}


void impact::jkrImpact::checkTimeStep(double speed) const
{
    const double time = contact_.scales(speed).time;
    const double low = overlapRungeKutta::minStep*time;
    const double high = overlapRungeKutta::maxStep*time;
    if (!(settings_.timeStep >= low && settings_.timeStep <= high))
    {
        std::ostringstream range;
        range<< rangeText("[]", low, high) << " s at the speed "
            << speed << " m/s";
        throwOutOfRange("timeStep", settings_.timeStep, range.str());
    }
}


impact::normalRebound impact::jkrImpact::integrated(double speed) const
{
    if (curve_)
    {
        const double e = jkrMotion::hertzRestitution(alpha());
        return {e == 0, e};
    }
    const impactOutcome out = impact(speed);
    return {out.captured, out.restitution};
}


impact::impactOutcome impact::jkrImpact::impact(double speed) const
{
    checkSpeed(speed);
    const jkrContact::units unit = contact_.scales(speed);
    const double p = speed/unit.speed;

    motionOutcome motion;
    if (settings_.scheme == impactScheme::rk4)
    {
        checkTimeStep(speed);
        motion = overlapRungeKutta
        (
            alpha(),
            settings_.unloading,
            settings_.timeStep/unit.time,
            settings_.interpolate
        ).impact(unit.curve, p);
    }
    else
    {
        motion = motion_.impact(unit.curve, p);
    }

    impactOutcome out;
    out.captured = motion.captured;
    out.restitution = motion.exitSpeed/p;
    out.contactTime = motion.time*unit.time;
    out.maxOverlap = unit.curve.overlap(motion.maxU)*unit.length;
    out.evaluations = motion.evaluations;
    if (curve_)
    {
        const normalRebound fast = rebound(speed);
        out.captured = fast.captured;
        out.restitution = fast.restitution;
        out.contactTime = fast.captured ? 0 : out.contactTime;
        out.evaluations = 0;
    }
    return out;
}


std::vector<impact::impactMoment> impact::jkrImpact::trajectory
(
    double speed,
    int nLoops
) const
{
    checkSpeed(speed);
    const jkrContact::units unit = contact_.scales(speed);
    const jkrCurve& curve = unit.curve;
    const double p0 = speed/unit.speed;
    const double bottom = curve.energy(curve.uB());
    const double depth =
        curve.energy(curve.uEnd(settings_.unloading)) - bottom;

    std::vector<impactMoment> moments;
    auto add = [&](double u, double p, double time)
    {
        const double force = curve.force(u) + alpha()*u*p;
        moments.push_back
        ({
            time*unit.time,
            curve.overlap(u)*unit.length,
            p*unit.speed,
            force*unit.force,
            u*u*unit.radius
        });
    };
    add(curve.uA(), p0, 0);
    int maxima = 0;
    motion_.follow
    (
        curve,
        p0,
        [&](const jkrMotion::integrator& step)
        {
            const int n = 16;
            for (int i = 1; i <= n; ++i)
            {
                const double s = double(i)/n;
                add(step.at(0, s), step.at(1, s), step.at(2, s));
            }
            const auto& a = step.begin();
            const auto& b = step.end();
            maxima += a[1] > 0 && b[1] <= 0;
            const double energy = 0.5*b[1]*b[1] + curve.energy(b[0]);
            return maxima <= nLoops
             && energy - bottom > 1e-10*depth + 1e-20*p0*p0;
        }
    );
    return moments;
}
