/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "hardSphereWall.H"

typedef impact::reboundCoefficient coefficient;


impact::hardSphereWall::hardSphereWall
(
    const reboundCoefficient& restitution,
    const reboundCoefficient& friction
)
:
    restitution_(restitution),
    friction_(friction),
    constant_(restitution.isConstant() && friction.isConstant())
{}


impact::hardSphereWall impact::hardSphereWall::constant
(
    double restitution,
    double friction
)
{
    return hardSphereWall
    (
        coefficient::constant(coefficient::restitutionQuantity(), restitution),
        coefficient::constant(coefficient::frictionQuantity(), friction)
    );
}


impact::hardSphereWall impact::hardSphereWall::McNamaraFalcon
(
    double restitution,
    double speed,
    double friction
)
{
    return hardSphereWall
    (
        coefficient::McNamaraFalcon
        (
            coefficient::restitutionQuantity(), restitution, speed
        ),
        coefficient::constant(coefficient::frictionQuantity(), friction)
    );
}
