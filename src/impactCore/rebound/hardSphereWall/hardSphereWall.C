/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "hardSphereWall.H"

#include <sstream>
#include <stdexcept>

namespace
{

void require(bool ok, const char* name, double value, const char* range)
{
    if (!ok)
    {
        std::ostringstream text;
        text<< name << ' ' << value << ": valid range " << range;
        throw std::invalid_argument(text.str());
    }
}

} // End anonymous namespace


impact::hardSphereWall::hardSphereWall(double restitution, double friction)
:
    restitution_(restitution),
    friction_(friction)
{
    require
    (
        restitution >= 0 && restitution <= 1,
        "restitution", restitution, "[0, 1]"
    );
    require
    (
        friction >= 0 && friction <= 1e6, "friction", friction, "[0, 1e6]"
    );
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
    require
    (
        speed > 1e-100 && speed < 1e100,
        "restitutionSpeed", speed, "(0, inf) (m/s)"
    );
    hardSphereWall law(restitution, friction);
    law.perSpeed_ = 1/speed;
    return law;
}
