/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "secondaryForces.H"

#include <cmath>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

impact::vector3 impact::secondaryForces::frame
(
    const vector3& x,
    const vector3& v,
    double r
) const
{
    const vector3 s = x - centre;
    const double share = buoyantFrame ? 1 - r : 1;
    return
        share
       *(
            cross(s, OmegaDot) + 2*cross(v, Omega)
          + cross(Omega, cross(s, Omega)) - acceleration
        );
}


double impact::secondaryForces::liftCoefficient(double Re, double Res)
{
    if (!(Res > 0 && Re > 0))
    {
        // Without a relative motion or a shear there is no lift
        return 0;
    }
    const double b = 0.5*Res/Re;
    const double s = 0.3314*std::sqrt(b);
    const double f =
        Re < 40 ? (1 - s)*std::exp(-0.1*Re) + s : 0.0524*std::sqrt(b*Re);
    return 3/(2*M_PI*std::sqrt(Res))*6.46*f;
}


void impact::secondaryForces::add
(
    const linearGas& field,
    const gasState& gas,
    const vector3& x,
    const vector3& v,
    double d,
    double inverseRhoP,
    motionRate& rate
) const
{
    const double r = gas.rho*inverseRhoP;
    if (pressureGradient || virtualMass > 0)
    {
        rate.a =
            rate.a + r*(pressureGradient + virtualMass)*field.acceleration(x);
    }
    if (shearLift)
    {
        const vector3 w = gas.u - v;
        const vector3 curl = 2*gas.spin;
        const double scale = d*gas.rho/gas.mu;
        const double Cl = liftCoefficient(scale*mag(w), scale*d*mag(curl));
        const vector3 turn = -r*Cl*curl;
        rate.turn = rate.turn + turn;
        rate.a = rate.a + cross(turn, w);
    }
    if (framed())
    {
        // The relative velocity turns in the frame as well
        rate.a = rate.a + frame(x, v, r);
        rate.turn = rate.turn + (buoyantFrame ? 2*(1 - r) : 2)*Omega;
    }
    const double share = 1/massRatio(r);
    rate.a = share*rate.a;
    rate.k *= share;
    rate.turn = share*rate.turn;
}
