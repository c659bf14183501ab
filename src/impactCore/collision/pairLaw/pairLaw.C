/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "pairLaw.H"
#include "outOfRange.H"

typedef impact::reboundCoefficient coefficient;


impact::pairLaw::pairLaw
(
    const reboundCoefficient& restitution,
    const reboundCoefficient& friction,
    bool spin,
    double tangentialRestitution
)
:
    restitution_(restitution),
    friction_(friction),
    tangentialRestitution_(tangentialRestitution),
    spin_(spin)
{
    checkRange("tangentialRestitution", tangentialRestitution, -1, 1);
}


impact::pairLaw::pairLaw
(
    double restitution,
    double friction,
    bool spin,
    double tangentialRestitution
)
:
    pairLaw
    (
        coefficient::constant(coefficient::restitutionQuantity(), restitution),
        coefficient::constant({"friction", 0, 1e12}, friction),
        spin,
        tangentialRestitution
    )
{}


impact::pairCollision impact::pairLaw::collide
(
    const collidingSphere& first,
    const collidingSphere& second,
    const vector3& n,
    bool elastic
) const
{
    const vector3 zero = {0, 0, 0};
    const vector3 omega1 = spin_ ? first.omega : zero;
    const vector3 omega2 = spin_ ? second.omega : zero;
    const vector3 G = first.v - second.v;
    const double Gn = dot(n, G);

    pairCollision out;
    out.v1 = first.v;
    out.v2 = second.v;
    out.omega1 = omega1;
    out.omega2 = omega2;
    out.impulse = zero;
    out.approachSpeed = Gn;
    out.restitutionLoss = 0;
    out.frictionLoss = 0;
    out.sliding = false;
    if (!(Gn > 0))
    {
        return out;
    }

    const double inverse1 = 1/first.mass;
    const double inverse2 = 1/second.mass;
    const double m = 1/(inverse1 + inverse2);
    const vector3 surface = first.radius*omega1 + second.radius*omega2;
    impactPoint at;
    if (!restitution_.isConstant() || !friction_.isConstant())
    {
        at = impactPoint(G + cross(surface, n), -n);
    }
    const double e = elastic ? 1 : restitution_(at);
    const double friction = elastic ? 0 : friction_(at);
    const double normal = (1 + e)*Gn*m;
    vector3 J = (-normal)*n;

    if (friction > 0)
    {
        const vector3 slip = (G - Gn*n) + cross(surface, n);
        const double speed = mag(slip);
        const double stick = (2./7)*(1 + tangentialRestitution_)*m;
        const double limit = friction*normal;
        out.sliding = limit < stick*speed;

        // Impulse per unit of slip; a contact that slides has some
        const double k = out.sliding ? limit/speed : stick;
        const vector3 Jt = (-k)*slip;
        J = J + Jt;
        out.frictionLoss = k*speed*speed*(1 - 1.75*k/m);

        if (spin_)
        {
            // r/I = 5/(2 m r); an immovable body may be a plane, radius 0
            const vector3 twist = 2.5*cross(n, Jt);
            if (inverse1 > 0)
            {
                out.omega1 = omega1 + (inverse1/first.radius)*twist;
            }
            if (inverse2 > 0)
            {
                out.omega2 = omega2 + (inverse2/second.radius)*twist;
            }
        }
        else
        {
            out.frictionLoss += 1.25*k*k*speed*speed/m;
        }
    }

    out.impulse = J;
    out.v1 = first.v + inverse1*J;
    out.v2 = second.v - inverse2*J;
    out.restitutionLoss = 0.5*m*Gn*Gn*(1 - e*e);
    return out;
}
