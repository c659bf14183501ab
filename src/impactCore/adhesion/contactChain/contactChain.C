/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "contactChain.H"
#include "bracketedRoot.H"
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

    // Beyond these a step was far too long
    static constexpr double largest = 5;

    static double bounded(double u)
    {
        return std::clamp(u, -largest, largest);
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


//- An impact on its way
class chainImpact
{
    typedef dormandPrince8<5> integrator;

    chainRate rate_;
    const jkrContact::units unit1_, unit2_;
    const double tolerance_;
    std::vector<chainMoment>* moments_;

    // Separations; stiffness where the forces vanish
    const double end1_, end2_;
    const double b1_, b2_;

    // Energies at rest, and from there to the separations
    const double energyUnit2_;
    const double bottom1_, bottom2_;
    const double barrier1_, barrier2_;

    integrator step_;
    double h_;

    // Largest overlaps, and whether a maximum is behind
    double maxU1_, maxU2_;
    bool turned1_, turned2_;

    chainOutcome out_;


    void note(const chainState& y)
    {
        if (moments_)
        {
            moments_->push_back
            ({
                y[4]*unit1_.time,
                rate_.curve1.overlap(y[0])*unit1_.length,
                y[1]*unit1_.speed,
                rate_.curve2.overlap(y[2])*unit2_.length,
                y[3]*unit1_.speed
            });
        }
    }

    //- Error of the step that was tried over the tolerance
    double error() const
    {
        const chainState y = step_.end();
        const double u = std::max(std::fabs(y[0]), std::fabs(y[2]));
        if (!(u <= rate_.largest))
        {
            // The rate is blind there, and so is its error
            return 1e10;
        }
        const double x1 = fourth(y[0])*y[0], x2 = fourth(y[2])*y[2];
        const double v2 = y[3]/rate_.speed;
        const double speed1 =
            std::max(std::sqrt(y[1]*y[1] + x1*x1), b1_*rate_.curve1.uB());
        const double speed2 =
            std::max(std::sqrt(v2*v2 + x2*x2), b2_*rate_.curve2.uB());
        return step_.error
        ({
            rate_.touch1 ? (5*fourth(y[0]) + b1_)/speed1 : 0,
            rate_.touch1 ? 1/speed1 : 0,
            rate_.touch2 ? (5*fourth(y[2]) + b2_)/speed2 : 0,
            1/(speed2*rate_.speed),
            0
        })/tolerance_;
    }

    //- The first of the separations in the step
    //  \param[out] fraction  its place in the step, or 1
    //  \return contact 1 or 2, or 0
    int separation(double& fraction) const
    {
        const chainState y = step_.end();
        fraction = 1;
        int leaves = 0;
        if (rate_.touch1 && y[0] <= end1_)
        {
            fraction = step_.when(0, end1_, 1);
            leaves = 1;
        }
        if (rate_.touch2 && y[2] <= end2_)
        {
            const double s = step_.when(2, end2_, 1);
            if (s <= fraction)
            {
                fraction = s;
                leaves = 2;
            }
        }
        return leaves;
    }

    //- Moments of a part of the step, and the largest overlaps in it
    void sample(double fraction)
    {
        const int nSamples = 8;
        for (int i = 1; i <= nSamples; ++i)
        {
            chainState z;
            for (int k = 0; k < 5; ++k)
            {
                z[k] = step_.at(k, fraction*i/nSamples);
            }
            maxU1_ = rate_.touch1 ? std::max(maxU1_, z[0]) : maxU1_;
            maxU2_ = rate_.touch2 ? std::max(maxU2_, z[2]) : maxU2_;
            note(z);
        }
        maximum(0, rate_.touch1, maxU1_, turned1_);
        maximum(2, rate_.touch2, maxU2_, turned2_);
    }

    //- Where the velocity behind u changes its sign
    void maximum(int u, bool touch, double& peak, bool& turned) const
    {
        if (touch && step_.begin()[u + 1] > 0 && step_.end()[u + 1] <= 0)
        {
            peak = std::max(peak, step_.at(u, step_.when(u + 1, 0, 1)));
            turned = true;
        }
    }

    //- End the step where a contact separates
    void separate(int contact, double fraction)
    {
        step_.attempt(rate_, fraction*h_);
        chainState end = step_.end();
        if (contact == 1)
        {
            out_.firstCaptured = false;
            out_.firstSpeed =
                -(rate_.oneWay ? end[1] : end[1] + end[3])*unit1_.speed;
            rate_.touch1 = false;
            end[1] = 0;
        }
        else
        {
            out_.secondDetached = true;
            rate_.touch2 = false;
        }
        if (out_.secondDetached)
        {
            out_.secondSpeed = -end[3]*unit1_.speed;
        }
        step_ = integrator(rate_, end);

        // One factor of the time scale is gone
        h_ *= contact == 1
          ? 0.6*rate_.curve1.beta() : 0.6*rate_.curve2.beta()*rate_.length;
    }


public:

    //- \param moments  filled unless null
    chainImpact
    (
        const chainRate& rate,
        const jkrContact::units& unit1,
        const jkrContact::units& unit2,
        double speed,
        double tolerance,
        std::vector<chainMoment>* moments
    )
    :
        rate_(rate),
        unit1_(unit1),
        unit2_(unit2),
        tolerance_(tolerance),
        moments_(moments),
        end1_(rate.curve1.uS()),
        end2_(rate.curve2.uS()),
        b1_(fourth(rate.curve1.uB())),
        b2_(fourth(rate.curve2.uB())),
        energyUnit2_(rate.force*rate.length),
        bottom1_(rate.curve1.energy(rate.curve1.uB())),
        bottom2_(energyUnit2_*rate.curve2.energy(rate.curve2.uB())),
        barrier1_(rate.curve1.energy(end1_) - bottom1_),
        barrier2_(energyUnit2_*rate.curve2.energy(end2_) - bottom2_),
        step_
        (
            rate_,
            {rate.curve1.uA(), speed/unit1.speed, rate.curve2.uB(), 0, 0}
        ),
        h_(0.05/rate.length),
        maxU1_(rate.curve1.uA()),
        maxU2_(rate.curve2.uB()),
        turned1_(false),
        turned2_(false),
        out_{true, 0, false, 0, 0, 0, true}
    {
        note(step_.begin());
    }

    //- A step, or a part of one up to a separation
    //  \return was it accepted?
    bool step()
    {
        step_.attempt(rate_, h_);
        const double e = error();
        if (e > 1)
        {
            h_ *= integrator::factor(e);
            return false;
        }
        step_.interpolate(rate_);
        double fraction;
        const int leaves = separation(fraction);
        sample(fraction);
        if (leaves)
        {
            separate(leaves, fraction);
        }
        else
        {
            step_.accept();
            h_ *= integrator::factor(e);
        }
        return true;
    }

    //- Is the outcome known? By the energies above those in equilibrium
    bool over()
    {
        if (!rate_.touch1 && !rate_.touch2)
        {
            return true;
        }
        const chainState& z = step_.begin();
        const double well1 = rate_.curve1.energy(z[0]) - bottom1_;
        const double well2 =
            energyUnit2_*rate_.curve2.energy(z[2]) - bottom2_;
        const double inner = well1 + 0.5*z[1]*z[1];
        const double outer = well2 + 0.5*rate_.mass2*z[3]*z[3];
        const double small = moments_ || !(turned1_ && turned2_) ? 1e-8 : 1;
        if (!rate_.touch2)
        {
            if (!(inner < small*barrier1_))
            {
                return false;
            }

            // A free pair: y1' is its relative velocity in both couplings
            const double m1 = rate_.mass1, m2 = rate_.mass2;
            const double v = (m1*(z[1] + z[3]) + m2*z[3])/(m1 + m2);
            out_.firstSpeed = -v*unit1_.speed;
            out_.secondSpeed = out_.firstSpeed;
            return true;
        }
        if (!rate_.touch1)
        {
            return outer < small*barrier2_;
        }
        if (rate_.oneWay)
        {
            // P1 drives P2 until it rests
            return
                inner < 1e-4*small*barrier1_ && outer < 0.5*small*barrier2_;
        }
        const double w = z[1] + z[3];
        return
            well1 + outer + 0.5*rate_.mass1*w*w
          < small*std::min(barrier1_, barrier2_);
    }

    chainOutcome outcome(bool decided) const
    {
        chainOutcome out(out_);
        out.decided = decided;
        out.maxOverlap1 = rate_.curve1.overlap(maxU1_)*unit1_.length;
        out.maxOverlap2 = rate_.curve2.overlap(maxU2_)*unit2_.length;
        return out;
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


long impact::contactChain::maxSteps() const
{
    // The heavier P1 is, the more often P2 swings while P1 turns
    const double swings = coupling_ == chainCoupling::twoWay
      ? std::sqrt(mass1_/second_.mass()) : 0;
    return long(std::clamp(10*swings, 2e4, 1e9));
}


impact::chainOutcome impact::contactChain::run
(
    double speed,
    std::vector<chainMoment>* moments
) const
{
    checkRange("speed", speed, "(0, inf) m/s");

    // Newton's P1 squeezes P2 with all of its energy, however light P2 is:
    // numbers are of order one in units of an impact of its mass
    const bool oneWay = coupling_ == chainCoupling::oneWay;
    auto unitsOf = [&](const jkrContact& c)
    {
        const double share = oneWay ? 1 : std::max(1., mass1_/c.mass());
        return c.scales(std::sqrt(share)*speed);
    };
    const jkrContact::units unit1 = unitsOf(first_);
    const jkrContact::units unit2 = unitsOf(second_);
    const chainRate rate =
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
        oneWay,
        true,
        true
    };
    chainImpact impact(rate, unit1, unit2, speed, tolerance_, moments);
    const long last = maxSteps();
    for (long n = 0; n < last; ++n)
    {
        if (impact.step() && impact.over())
        {
            return impact.outcome(true);
        }
    }
    return impact.outcome(false);
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
    if (happens(what, low) == happens(what, high))
    {
        throwOutOfRange
        (
            "speeds",
            rangeText("()", low, high),
            "two with different outcomes"
        );
    }
    const auto ends = bracketedChange
    (
        [&](double s) { return happens(what, s); },
        low,
        high,
        [](double a, double b) { return b - a <= 1e-9*b; }
    );
    return 0.5*(ends.first + ends.second);
}
