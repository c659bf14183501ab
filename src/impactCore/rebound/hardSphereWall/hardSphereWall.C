/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "hardSphereWall.H"

typedef impact::reboundCoefficient coefficient;


coefficient::quantity impact::hardSphereWall::restitutionQuantity()
{
    return {"restitution", 0, 1, coefficient::component::normal};
}


coefficient::quantity impact::hardSphereWall::frictionQuantity()
{
    return {"friction", 0, 1e6};
}


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
        coefficient::constant(restitutionQuantity(), restitution),
        coefficient::constant(frictionQuantity(), friction)
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
        coefficient::McNamaraFalcon(restitutionQuantity(), restitution, speed),
        coefficient::constant(frictionQuantity(), friction)
    );
}
