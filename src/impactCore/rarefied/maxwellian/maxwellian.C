/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "maxwellian.H"

#include <cmath>

namespace
{
    const double rootPi = 1.7724538509055160;
}


double impact::maxwellian::mostProbableSpeed(double temperature, double mass)
{
    return std::sqrt(2*boltzmann*temperature/mass);
}


double impact::maxwellian::meanSpeed(double temperature, double mass)
{
    return std::sqrt(8*boltzmann*temperature/(M_PI*mass));
}


double impact::maxwellian::fluxFactor(double s)
{
    // erfc keeps the small flux against a fast stream accurate
    return (std::exp(-s*s) + rootPi*s*std::erfc(-s))/(2*rootPi);
}


double impact::maxwellian::fluxSpeed(double s, counterRandom& rnd)
{
    if (s == 0)
    {
        return std::sqrt(-std::log(rnd.uniform()));
    }

    if (s > 0)
    {
        // With x = s + t: the envelope (s + |t|) exp(-t^2) on the whole line
        // is a sum of a normal law, of weight sqrt(pi) s, and of two
        // halves |t| exp(-t^2), of weight 1
        while (true)
        {
            double t;
            if ((rootPi*s + 1)*rnd.uniform() < rootPi*s)
            {
                t = rnd.normal()*std::sqrt(0.5);
            }
            else
            {
                const double sign = rnd.uniform() < 0.5 ? -1 : 1;
                t = sign*std::sqrt(-std::log(rnd.uniform()));
            }
            if (s + t > 0 && (s + std::fabs(t))*rnd.uniform() < s + t)
            {
                return s + t;
            }
        }
    }

    // Against the stream: x exp(-x^2) exp(-2|s|x), the smaller of the two
    // exponentials being left to the rejection
    while (true)
    {
        if (s > -1)
        {
            const double x = std::sqrt(-std::log(rnd.uniform()));
            if (rnd.uniform() < std::exp(2*s*x))
            {
                return x;
            }
        }
        else
        {
            const double x = gammaVariate(2, rnd)/(-2*s);
            if (rnd.uniform() < std::exp(-x*x))
            {
                return x;
            }
        }
    }
}


impact::vector3 impact::maxwellian::crossingVelocity
(
    const vector3& direction,
    const vector3& along,
    double c,
    double s,
    counterRandom& rnd
)
{
    // Any thermal vector without its normal component will do for the
    // components along the surface
    const double sigma = c*std::sqrt(0.5);
    const double tx = sigma*rnd.normal();
    const double ty = sigma*rnd.normal();
    const double tz = sigma*rnd.normal();
    const vector3 t{tx, ty, tz};
    const double through = c*fluxSpeed(s, rnd);
    return along + t + (through - dot(t, direction))*direction;
}


double impact::maxwellian::gammaVariate(double a, counterRandom& rnd)
{
    if (a == 1)
    {
        return -std::log(rnd.uniform());
    }
    if (a < 1)
    {
        const double g = gammaVariate(a + 1, rnd);
        return g*std::pow(rnd.uniform(), 1/a);
    }

    const double d = a - 1.0/3;
    const double c = 1/std::sqrt(9*d);
    while (true)
    {
        const double x = rnd.normal();
        const double v = 1 + c*x;
        if (v <= 0)
        {
            continue;
        }
        const double v3 = v*v*v;
        if (std::log(rnd.uniform()) < 0.5*x*x + d*(1 - v3 + std::log(v3)))
        {
            return d*v3;
        }
    }
}


double impact::maxwellian::betaVariate(double a, double b, counterRandom& rnd)
{
    if (a == 1)
    {
        return 1 - std::pow(rnd.uniform(), 1/b);
    }
    const double x = gammaVariate(a, rnd);
    return x/(x + gammaVariate(b, rnd));
}


double impact::maxwellian::internalEnergy
(
    int degreesOfFreedom,
    counterRandom& rnd
)
{
    return degreesOfFreedom ? gammaVariate(0.5*degreesOfFreedom, rnd) : 0;
}
