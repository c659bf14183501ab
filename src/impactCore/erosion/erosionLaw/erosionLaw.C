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

    erosionLaw law;
    law.kind_ = kind::finnie;
    law.factor_ = 1/(p*psi*K);
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

    erosionLaw law;
    law.kind_ = kind::oka;
    law.factor_ = c.K*std::pow(c.hardness, c.k1);
    law.K_ = c.hardness;
    law.n1_ = c.n1;
    law.n2_ = c.n2;
    law.k2_ = c.k2;
    law.k3_ = c.k3;
    law.referenceSpeed_ = c.referenceSpeed;
    law.referenceDiameter_ = c.referenceDiameter;
    return law;
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
            n1_*std::log(s)
          + n2_*std::log1p(K_*std::max(1 - s, 0.0))
          + k2_*std::log(speed/referenceSpeed_)
          + k3_*std::log(diameter/referenceDiameter_)
        );
}

} // End namespace impact
