/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "erosionLaw.H"
#include "outOfRange.H"

#include <algorithm>
#include <cmath>

namespace impact
{

namespace
{

void check(const char* name, double value, bool zeroToo = false)
{
    checkRange(name, value, zeroToo ? "[0, inf)" : "(0, inf)");
}

} // End anonymous namespace


erosionLaw::okaConstants::okaConstants(double Hv)
:
    hardness(Hv),
    K(65e-9),
    k1(-0.12),
    k3(0.19),
    referenceSpeed(104),
    referenceDiameter(326e-6)
{
    check("hardness", Hv);
    n1 = 0.71*std::pow(Hv, 0.14);
    n2 = 2.4*std::pow(Hv, -0.94);
    k2 = 2.3*std::pow(Hv, 0.038);
}


erosionLaw erosionLaw::finnie(double p, double psi, double K)
{
    check("p", p);
    check("psi", psi);
    check("K", K);

    erosionLaw law(kind::finnie, 1/(p*psi*K), okaConstants(1));
    law.K_ = K;
    return law;
}


erosionLaw erosionLaw::oka(const okaConstants& c)
{
    check("hardness", c.hardness);
    check("K", c.K);
    check("n1", c.n1, true);
    check("n2", c.n2, true);
    check("k2", c.k2, true);
    check("k3", c.k3, true);
    check("referenceSpeed", c.referenceSpeed);
    check("referenceDiameter", c.referenceDiameter);
    checkRange("k1", c.k1, "(-inf, inf)");

    return erosionLaw(kind::oka, c.K*std::pow(c.hardness, c.k1), c);
}


double erosionLaw::volume
(
    double mass,
    double diameter,
    double speed,
    double angle
) const
{
    const double s = std::sin(angle);

    if (kind_ == kind::finnie)
    {
        // tan(angle) <= K/6 without a division by cos(angle) = 0
        const double c = std::cos(angle);
        return mass*speed*speed*factor_
           *(6*s <= K_*c ? 2*s*c - 6/K_*s*s : K_/6*c*c);
    }

    if (!(s > 0) || !(speed > 0))
    {
        return 0;
    }

    // One exponential for the four powers
    return
        mass*factor_*std::exp
        (
            oka_.n1*std::log(s)
          + oka_.n2*std::log1p(oka_.hardness*std::max(1 - s, 0.0))
          + oka_.k2*std::log(speed/oka_.referenceSpeed)
          + oka_.k3*std::log(diameter/oka_.referenceDiameter)
        );
}

} // End namespace impact
