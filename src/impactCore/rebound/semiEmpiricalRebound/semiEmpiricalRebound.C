/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "semiEmpiricalRebound.H"

#include <cmath>

namespace
{

using namespace impact;

//- The direction along the wall of a vector of a size, or none if what is along
//  it is round-off
vector3 alongWall(const vector3& n, const vector3& v, double size)
{
    const vector3 t = v - dot(v, n)*n;
    const double m = mag(t);
    return m > 1e-12*size ? (1/m)*t : vector3{0, 0, 0};
}

} // End anonymous namespace


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
    const double speed = mag(s.V);

    // The direction x: of the slip of a sphere that falls vertically
    vector3 x = alongWall(n, s.V - vn*n, speed);
    const double vx0 = dot(s.V, x);
    if (vx0 == 0)
    {
        x = alongWall(n, cross(n, s.omega), mag(s.omega));
    }
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
