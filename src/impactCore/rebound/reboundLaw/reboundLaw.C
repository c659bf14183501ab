/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "reboundLaw.H"
#include "frictionImpact.H"

namespace
{

using impact::vector3;

//- Change of the contact point's velocity for an impulse S at it
vector3 response
(
    const vector3& inverseInertia,
    const vector3& r,
    const vector3& S
)
{
    return S + cross(multiply(inverseInertia, cross(r, S)), r);
}

} // End anonymous namespace


impact::reboundLaw::reboundLaw
(
    lawType law,
    const reboundCoefficient& normal,
    const reboundCoefficient& other
)
:
    law_(law),
    normal_(normal),
    other_(other)
{}


impact::reboundCoefficient::quantity impact::reboundLaw::normalQuantity()
{
    return {"normal", 0, 1, reboundCoefficient::component::normal};
}


impact::reboundCoefficient::quantity impact::reboundLaw::tangentialQuantity()
{
    return {"tangential", -1, 1, reboundCoefficient::component::tangential};
}


impact::reboundLaw impact::reboundLaw::restitution
(
    double normal,
    double tangential
)
{
    return reboundLaw
    (
        lawType::restitution,
        reboundCoefficient::constant(normalQuantity(), normal),
        reboundCoefficient::constant(tangentialQuantity(), tangential)
    );
}


impact::reboundLaw impact::reboundLaw::coulomb
(
    double restitution,
    double friction
)
{
    typedef reboundCoefficient form;
    return reboundLaw
    (
        lawType::friction,
        form::constant(form::restitutionQuantity(), restitution),
        form::constant(form::frictionQuantity(), friction)
    );
}


impact::vector3 impact::reboundLaw::frictionImpulse
(
    double restitution,
    double friction,
    const vector3& inertia,
    const vector3& r,
    const vector3& n,
    const vector3& Vc0
)
{
    const vector3 t1 = across(n);
    const vector3 t2 = cross(n, t1);
    const vector3 inverse = {1/inertia.x, 1/inertia.y, 1/inertia.z};
    const vector3 K1 = response(inverse, r, t1);
    const vector3 K2 = response(inverse, r, t2);
    const vector3 Kn = response(inverse, r, n);
    const double speed0 = mag(Vc0);
    if (!(speed0 > 0))
    {
        return {0, 0, 0};
    }
    const frictionImpact process
    (
        {
            friction,
            dot(t1, K1), dot(t1, K2), dot(t2, K2),
            dot(t1, Kn), dot(t2, Kn), dot(n, Kn)
        },
        restitution,
        dot(t1, Vc0)/speed0, dot(t2, Vc0)/speed0, dot(n, Vc0)/speed0
    );
    const frictionImpact::state& end = process.result();
    return
        (speed0*end[frictionImpact::impulseX])*t1
      + (speed0*end[frictionImpact::impulseY])*t2
      + (speed0*end[frictionImpact::impulse])*n;
}


impact::impactRecord impact::reboundLaw::impact
(
    const vector3& inertia,
    const vector3& r,
    const vector3& n,
    const vector3& V,
    const vector3& omega
) const
{
    const vector3 Vc = V + cross(omega, r);
    const impactPoint at =
        isConstant() ? impactPoint() : impactPoint(Vc, n);
    const double normal = normal_(at);
    const double other = other_(at);

    impactRecord out;
    if (law_ == lawType::restitution)
    {
        out = restitutionImpact(normal, other, inertia, r, n, V, omega);
    }
    else
    {
        out.approachSpeed = -dot(Vc, n);
        out.dV = frictionImpulse(normal, other, inertia, r, n, Vc);
        const vector3 m = cross(r, out.dV);
        out.dOmega = {m.x/inertia.x, m.y/inertia.y, m.z/inertia.z};
        setEnergies(inertia, n, V, omega, out);
    }
    out.outside = normal_.outside(at) || other_.outside(at);
    return out;
}
