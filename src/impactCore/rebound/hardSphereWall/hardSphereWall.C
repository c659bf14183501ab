/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "hardSphereWall.H"
#include "outOfRange.H"


impact::hardSphereWall::hardSphereWall(double restitution, double friction)
:
    restitution_(restitution),
    friction_(friction)
{
    checkRange("restitution", restitution, "[0, 1]");
    checkRange("friction", friction, "[0, 1e6]");
}


impact::hardSphereWall impact::hardSphereWall::constant
(
    double restitution,
    double friction
)
{
    return hardSphereWall(restitution, friction);
}


impact::hardSphereWall impact::hardSphereWall::McNamaraFalcon
(
    double restitution,
    double speed,
    double friction
)
{
    checkRange("restitutionSpeed", speed, "(1e-100, 1e100) m/s");
    hardSphereWall law(restitution, friction);
    law.perSpeed_ = 1/speed;
    return law;
}
