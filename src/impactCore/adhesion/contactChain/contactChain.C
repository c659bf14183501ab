/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "contactChain.H"
#include "dormandPrince8.H"
#include "jkrMotion.H"
#include "outOfRange.H"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{

using namespace impact;

typedef std::array<double, 5> chainState;

inline double fourth(double u)
{
    return (u*u)*(u*u);
}


//- Right-hand side in u1, y1', u2, y2', time; units of the first contact
struct chainRate
{
    jkrCurve curve1, curve2;
    double alpha1, alpha2;

    // Units of the second contact over those of the first: length, force,
    // speed
    double length, force, speed;

    // m1 and m2 over m*
    double mass1, mass2;

    bool oneWay;

    // Is there a contact
    bool touch1, touch2;

    static double bounded(double u)
    {
        return std::clamp(u, -5., 5.);
    }

    double force1(double u, double v) const
    {
        return touch1 ? curve1.force(u) + alpha1*u*v : 0;
    }

    double force2(double u, double v) const
    {
        return touch2 ? force*(curve2.force(u) + alpha2*u*v/speed) : 0;
    }

    void operator()(const chainState& y, chainState& rate) const
    {
        const double u1 = bounded(y[0]), v1 = y[1];
        const double u2 = bounded(y[2]), v2 = y[3];
        const double s1 = touch1 ? curve1.slope(u1) : 1;
        const double s2 = touch2 ? length*curve2.slope(u2) : 1;
        const double F1 = force1(u1, v1), F2 = force2(u2, v2);
        const double a2 = (F1 - F2)/mass2;
        const double a1 = oneWay ? -F1 : -F1/mass1 - a2;
        const double dt = s1*s2;
        rate[0] = touch1 ? v1*s2 : 0;
        rate[1] = a1*dt;
        rate[2] = touch2 ? v2*s1 : 0;
        rate[3] = a2*dt;
        rate[4] = dt;
    }
};

} // End anonymous namespace


impact::contactChain::contactChain
(
    const jkrContact& first,
    const chainAlpha& alpha1,
    const jkrContact& second,
    const chainAlpha& alpha2,
    chainCoupling coupling,
    double tolerance
)
:
    first_(first),
    second_(second),
    alpha1_(alpha1),
    alpha2_(alpha2),
    coupling_(coupling),
    tolerance_(tolerance)
{
    checkRange("tolerance", tolerance, 1e-14, 1e-3);
    if (!(first.mass() < second.mass()))
    {
        std::ostringstream range;
        range<< "(0, " << second.mass() << "), below the mass of P2";
        throwOutOfRange
        (
            "mass of the contact of P1 and P2", first.mass(), range.str()
        );
    }
    for (const jkrContact* contact : {&first, &second})
    {
        if (!(contact->workOfAdhesion() > 0))
        {
            throwOutOfRange
            (
                "workOfAdhesion of a chain",
                contact->workOfAdhesion(),
                "(0, inf)"
            );
        }
    }
    mass1_ = 1/(1/first.mass() - 1/second.mass());
}


impact::chainOutcome impact::contactChain::run
(
    double speed,
    std::vector<chainMoment>* moments
) const
{
    checkRange("speed", speed, "(0, inf) m/s");
    const jkrContact::units unit1 = first_.scales(speed);
    const jkrContact::units unit2 = second_.scales(speed);
    chainRate rate =
    {
        unit1.curve,
        unit2.curve,
        alpha1_(speed),
        alpha2_(speed),
        unit2.length/unit1.length,
        unit2.force/unit1.force,
        unit2.speed/unit1.speed,
        mass1_/first_.mass(),
        second_.mass()/first_.mass(),
        coupling_ == chainCoupling::oneWay,
        true,
        true
    };
    const jkrCurve& c1 = rate.curve1;
    const jkrCurve& c2 = rate.curve2;
    const double end1 = c1.uS(), end2 = c2.uS();
    const double b1 = fourth(c1.uB()), b2 = fourth(c2.uB());
    const double energyUnit2 = rate.force*rate.length;
    const double bottom1 = c1.energy(c1.uB());
    const double bottom2 = energyUnit2*c2.energy(c2.uB());
    const double barrier1 = c1.energy(end1) - bottom1;
    const double barrier2 = energyUnit2*c2.energy(end2) - bottom2;

    chainOutcome out = {true, 0, false, 0, 0, 0, 0, true, 0};
    typedef dormandPrince8<5> integrator;
    integrator step(rate, {c1.uA(), speed/unit1.speed, c2.uB(), 0, 0});
    long evaluations = 0;
    double maxU1 = c1.uA(), maxU2 = c2.uB();
    bool turned1 = false, turned2 = false;      // a maximum is behind
    auto note = [&](const chainState& y)
    {
        if (moments)
        {
            moments->push_back
            ({
                y[4]*unit1.time,
                c1.overlap(y[0])*unit1.length,
                y[1]*unit1.speed,
                c2.overlap(y[2])*unit2.length,
                y[3]*unit1.speed
            });
        }
    };
    note(step.begin());

    double h = 0.05/rate.length;
    for (long n = 0; ; ++n)
    {
        if (n == maxSteps)
        {
            out.decided = false;
            break;
        }
        step.attempt(rate, h);
        const chainState y = step.end();
        const double x1 = fourth(y[0])*y[0], x2 = fourth(y[2])*y[2];
        const double v2 = y[3]/rate.speed;
        const double speed1 =
            std::max(std::sqrt(y[1]*y[1] + x1*x1), b1*c1.uB());
        const double speed2 = std::max(std::sqrt(v2*v2 + x2*x2), b2*c2.uB());
        const double error = step.error
        ({
            rate.touch1 ? (5*fourth(y[0]) + b1)/speed1 : 0,
            rate.touch1 ? 1/speed1 : 0,
            rate.touch2 ? (5*fourth(y[2]) + b2)/speed2 : 0,
            1/(speed2*rate.speed),
            0
        })/tolerance_;
        if (error > 1)
        {
            h *= integrator::factor(error);
            continue;
        }
        step.interpolate(rate);

        // The first of the separations in this step
        double fraction = 1;
        int leaves = 0;
        if (rate.touch1 && y[0] <= end1)
        {
            fraction = step.when(0, end1, 1);
            leaves = 1;
        }
        if (rate.touch2 && y[2] <= end2)
        {
            const double s = step.when(2, end2, 1);
            if (s <= fraction)
            {
                fraction = s;
                leaves = 2;
            }
        }
        const int nSamples = 8;
        for (int i = 1; i <= nSamples; ++i)
        {
            const double s = fraction*i/nSamples;
            chainState z;
            for (int k = 0; k < 5; ++k)
            {
                z[k] = step.at(k, s);
            }
            maxU1 = rate.touch1 ? std::max(maxU1, z[0]) : maxU1;
            maxU2 = rate.touch2 ? std::max(maxU2, z[2]) : maxU2;
            note(z);
        }
        const auto maximum =
            [&](int u, int v, bool touch, double& most, bool& turned)
        {
            if (touch && step.begin()[v] > 0 && y[v] <= 0)
            {
                most = std::max(most, step.at(u, step.when(v, 0, 1)));
                turned = true;
            }
        };
        maximum(0, 1, rate.touch1, maxU1, turned1);
        maximum(2, 3, rate.touch2, maxU2, turned2);

        if (leaves)
        {
            step.attempt(rate, fraction*h);
            chainState end = step.end();
            if (leaves == 1)
            {
                out.firstCaptured = false;
                out.firstSpeed =
                    -(rate.oneWay ? end[1] : end[1] + end[3])*unit1.speed;
                rate.touch1 = false;
                end[1] = 0;
            }
            else
            {
                out.secondDetached = true;
                rate.touch2 = false;
            }
            if (out.secondDetached)
            {
                out.secondSpeed = -end[3]*unit1.speed;
            }
            evaluations += step.evaluations();
            step = integrator(rate, end);
            if (!rate.touch1 && !rate.touch2)
            {
                break;
            }

            // One factor of the time scale is gone
            h *= leaves == 1 ? 0.4 : 0.4*rate.length;
        }
        else
        {
            step.accept();
            h *= integrator::factor(error);
        }

        // Energies above those in equilibrium
        const chainState& z = step.begin();
        const double well1 = c1.energy(z[0]) - bottom1;
        const double well2 = energyUnit2*c2.energy(z[2]) - bottom2;
        const double inner = well1 + 0.5*z[1]*z[1];
        const double outer = well2 + 0.5*rate.mass2*z[3]*z[3];
        const double small = moments || !(turned1 && turned2) ? 1e-8 : 1;
        if (!rate.touch2)
        {
            // A free pair: y1' is its relative velocity in both couplings
            if (inner < small*barrier1)
            {
                const double m1 = rate.mass1, m2 = rate.mass2;
                const double v = rate.oneWay
                  ? z[3] : (m1*(z[1] + z[3]) + m2*z[3])/(m1 + m2);
                out.firstSpeed = -v*unit1.speed;
                out.secondSpeed = out.firstSpeed;
                break;
            }
        }
        else if (!rate.touch1)
        {
            if (outer < small*barrier2)
            {
                break;
            }
        }
        else if (rate.oneWay)
        {
            // P1 drives P2 until it rests
            const bool settled = inner < 1e-4*small*barrier1;
            if (settled && outer < 0.5*small*barrier2)
            {
                break;
            }
        }
        else
        {
            const double w = z[1] + z[3];
            const double energy =
                well1 + outer + 0.5*rate.mass1*w*w;
            if (energy < small*std::min(barrier1, barrier2))
            {
                break;
            }
        }
    }
    out.maxOverlap1 = c1.overlap(maxU1)*unit1.length;
    out.maxOverlap2 = c2.overlap(maxU2)*unit2.length;
    out.finalOverlap2 = c2.overlap(step.begin()[2])*unit2.length;
    out.evaluations = evaluations + step.evaluations();
    return out;
}


std::vector<impact::chainMoment> impact::contactChain::trajectory
(
    double speed
) const
{
    std::vector<chainMoment> moments;
    run(speed, &moments);
    return moments;
}


bool impact::contactChain::happens(event what, double speed) const
{
    const chainOutcome out = impact(speed);
    return what == event::firstRebounds
      ? !out.firstCaptured : out.secondDetached;
}


double impact::contactChain::threshold
(
    event what,
    double low,
    double high
) const
{
    const bool atLow = happens(what, low);
    if (atLow == happens(what, high))
    {
        throwOutOfRange
        (
            "speeds",
            rangeText("()", low, high),
            "two with different outcomes"
        );
    }
    while (high - low > 1e-9*high)
    {
        const double mid = 0.5*(low + high);
        (happens(what, mid) == atLow ? low : high) = mid;
    }
    return 0.5*(low + high);
}
