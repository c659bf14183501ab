/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "semiEmpiricalRebound.H"

#include <cmath>

impact::reboundCoefficient::quantity
impact::semiEmpiricalRebound::normalQuantity()
{
    return {"normal", 0, 1, reboundCoefficient::component::normal};
}


impact::reboundCoefficient::quantity
impact::semiEmpiricalRebound::tangentialQuantity()
{
    return
        {"tangential", 0, 1, reboundCoefficient::component::tangential};
}


impact::reboundCoefficient::quantity
impact::semiEmpiricalRebound::criticalAngleQuantity()
{
    return {"criticalAngle", 0, 90};
}


impact::semiEmpiricalRebound::semiEmpiricalRebound
(
    const reboundCoefficient& normal,
    const reboundCoefficient& tangential,
    const reboundCoefficient& criticalAngle
)
:
    normal_(normal),
    tangential_(tangential),
    criticalAngle_(criticalAngle)
{}


impact::semiEmpiricalRebound::outcome impact::semiEmpiricalRebound::rebound
(
    const vector3& n,
    double radius,
    sphereState& s
) const
{
    const double vn = dot(s.V, n);
    const vector3 Vt = s.V - vn*n;
    const double vx0 = mag(Vt);
    const double speed = mag(s.V);
    const double angle = 57.295779513082320877*std::atan2(-vn, vx0);

    outcome out;
    out.outside =
        normal_.outside(angle, speed) || tangential_.outside(angle, speed)
     || criticalAngle_.outside(angle, speed);
    out.rolls = angle >= criticalAngle_(angle, speed);
    const double eN = normal_(angle, speed);
    const double eT = tangential_(angle, speed);
    const double before =
        translationalEnergy(s.V) + sphereRotationalEnergy(radius, s.omega);

    // The direction x: of the slip of a sphere that falls vertically
    vector3 x = {0, 0, 0};
    if (vx0 > 0)
    {
        x = (1/vx0)*Vt;
    }
    else
    {
        const vector3 turning = cross(n, s.omega);
        const double rate = mag(turning);
        if (rate > 0)
        {
            x = (1/rate)*turning;
        }
    }
    const vector3 z = cross(x, n);
    const double w0 = radius*dot(s.omega, z);
    double vx, w;
    if (out.rolls)
    {
        vx = eT*vx0 - (2./7)*w0;
        w = (2./7)*w0 - eT*vx0;
    }
    else
    {
        vx = eT*vx0 + (eT - 1)*w0;
        w = 2.5*((eT - 1)*vx0 + (eT - 0.6)*w0);
    }
    s.V = (-eN*vn)*n + vx*x;
    s.omega = s.omega + ((w - w0)/radius)*z;

    const double after =
        translationalEnergy(s.V) + sphereRotationalEnergy(radius, s.omega);
    out.gains = after > (1 + 1e-12)*before;
    return out;
}
