/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "adhesiveRebound.H"
#include "outOfRange.H"

#include <algorithm>

namespace
{

using namespace impact;

double massOf(const adhesiveRebound::sphere& s)
{
    return M_PI/6*s.density*s.diameter*s.diameter*s.diameter;
}


void check(const adhesiveRebound::materials& m)
{
    checkRange("modulus", m.modulus, "(0, inf) Pa");
    checkRange("workOfAdhesion of a wall", m.workOfAdhesion, "(0, inf) J/m2");
}

} // End anonymous namespace


impact::adhesiveRebound::adhesiveRebound
(
    const materials& wall,
    const lawCurve& curve,
    double friction
)
:
    wall_(wall),
    curve_(curve),
    friction_(friction),
    perSpeedScale_(0)
{
    check(wall);
    checkRange("friction", friction, "[0, 1e6]");

    // Of a sphere of a micrometre, where all is of the order of one
    const sphere micron = {2e-6, 1000};
    const double v = jkrContact
    (
        1e-6, wall.modulus, massOf(micron), wall.workOfAdhesion
    ).separationSpeed();
    perSpeedScale_ = 1/(v*radiusPower(1e-6)*std::sqrt(micron.density));
}


void impact::adhesiveRebound::setLayer(const layerSettings& layer)
{
    check(layer.contact);
    layer_ = layer;

    // Whatever it refuses it refuses now
    chain({2e-6, 1000}, {2e-6, 1000});
}


impact::contactChain impact::adhesiveRebound::chain
(
    const sphere& first,
    const sphere& second
) const
{
    const double m1 = massOf(first), m2 = massOf(second);
    const double r1 = 0.5*first.diameter, r2 = 0.5*second.diameter;
    return contactChain
    (
        jkrContact
        (
            r1*r2/(r1 + r2),
            layer_->contact.modulus,
            m1*m2/(m1 + m2),
            layer_->contact.workOfAdhesion
        ),
        layer_->alpha,
        jkrContact(r2, wall_.modulus, m2, wall_.workOfAdhesion),
        layer_->wallAlpha,
        layer_->coupling,
        layer_->tolerance
    );
}


impact::adhesiveRebound::outcome impact::adhesiveRebound::rebound
(
    const vector3& n,
    const sphere& first,
    sphereState& s,
    const sphere& second,
    sphereState& s2
) const
{
    const double v = -dot(s.V, n);
    const double r1 = 0.5*first.diameter, r2 = 0.5*second.diameter;
    const chainOutcome normal = chain(first, second).impact(v);
    const double overlap = std::max
    (
        normal.maxOverlap1*(r1 + r2)/(r1*r2), normal.maxOverlap2/r2
    );
    const sphereState rest = {{0, 0, 0}, {0, 0, 0}};
    outcome out =
        {false, false, normal.secondDetached, normal.decided, overlap};
    s2 = rest;

    double v1 = normal.firstSpeed, v2 = normal.secondSpeed;
    out.detached = normal.secondDetached && v2 > 0;
    if (normal.firstCaptured && !out.detached)
    {
        s = rest;
        out.captured = true;
        return out;
    }
    if (v1 <= 0)
    {
        const normalRebound again =
            v1 < 0 ? restitution(first, -v1) : normalRebound{true, 0};
        out.captured = again.captured;
        v1 *= -again.restitution;
    }

    const double m1 = massOf(first), m2 = massOf(second);
    const vector3 Vc = contactVelocity(n, r1, s);
    const vector3 slip = Vc - dot(Vc, n)*n;
    const double speed = mag(slip);
    const double Jn = v + v1;
    const double stop = out.detached ? 2./7*m2/(m1 + m2) : 2./7;
    const double f = friction_;
    out.slides = f*Jn < stop*speed;
    const vector3 Jt = -(out.slides ? f*Jn/speed : stop)*slip;

    if (out.detached)
    {
        s2.V = v2*n - (m1/m2)*Jt;
        s2.omega = (-2.5/r2*m1/m2)*cross(n, Jt);
    }
    if (out.captured)
    {
        s = rest;
    }
    else
    {
        s.V = s.V + Jn*n + Jt;
        s.omega = s.omega - (2.5/r1)*cross(n, Jt);
    }
    return out;
}
