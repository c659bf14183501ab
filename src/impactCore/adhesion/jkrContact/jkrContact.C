/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "jkrContact.H"
#include "outOfRange.H"

#include <algorithm>
#include <cmath>

namespace
{

using namespace impact;

void checkSolid(const elasticSolid& solid)
{
    checkRange("E", solid.E, "(0, inf) Pa");
    checkRange("nu", solid.nu, "(-1, 0.5)");
}


void checkSphere(const elasticSphere& sphere)
{
    checkRange("diameter", sphere.diameter, "(0, inf) m");
    checkRange("density", sphere.density, "(0, inf) kg/m3");
    checkSolid(sphere.solid);
}


double compliance(const elasticSolid& solid)
{
    return (1 - solid.nu*solid.nu)/solid.E;
}

} // End anonymous namespace


impact::jkrContact::jkrContact
(
    double radius,
    double modulus,
    double mass,
    double workOfAdhesion
)
:
    radius_(radius),
    modulus_(modulus),
    mass_(mass),
    workOfAdhesion_(workOfAdhesion)
{
    checkRange("radius", radius, "(0, inf) m");
    checkRange("modulus", modulus, "(0, inf) Pa");
    checkRange("mass", mass, "(0, inf) kg");
    checkRange("workOfAdhesion", workOfAdhesion, "[0, inf) J/m2");
    equilibriumRadius_ =
        std::cbrt(4.5*M_PI*workOfAdhesion*radius*radius/modulus);
}


impact::jkrContact impact::jkrContact::onWall
(
    const elasticSphere& particle,
    const elasticSolid& wall,
    double workOfAdhesion
)
{
    checkSphere(particle);
    checkSolid(wall);
    return jkrContact
    (
        0.5*particle.diameter,
        1/(compliance(particle.solid) + compliance(wall)),
        particle.mass(),
        workOfAdhesion
    );
}


impact::jkrContact impact::jkrContact::between
(
    const elasticSphere& first,
    const elasticSphere& second,
    double workOfAdhesion
)
{
    checkSphere(first);
    checkSphere(second);
    const double d1 = first.diameter, d2 = second.diameter;
    const double m1 = first.mass(), m2 = second.mass();
    return jkrContact
    (
        0.5/(1/d1 + 1/d2),
        1/(compliance(first.solid) + compliance(second.solid)),
        1/(1/m1 + 1/m2),
        workOfAdhesion
    );
}


double impact::jkrContact::pullOffForce() const
{
    return 1.5*M_PI*workOfAdhesion_*radius_;
}


double impact::jkrContact::pullOffOverlap() const
{
    return -lastTouch().overlap;
}


double impact::jkrContact::separationWork(unloadingType unloading) const
{
    const units scale = scales(0);
    return scale.energy*scale.curve.separationWork(unloading);
}


double impact::jkrContact::separationSpeed(unloadingType unloading) const
{
    return std::sqrt(2*separationWork(unloading)/mass_);
}


impact::contactState impact::jkrContact::at(double contactRadius) const
{
    const units scale = scales(0);
    const double u = std::sqrt(contactRadius/scale.radius);
    return
    {
        contactRadius,
        scale.length*scale.curve.overlap(u),
        scale.force*scale.curve.force(u)
    };
}


impact::contactState impact::jkrContact::firstTouch() const
{
    return at(equilibriumRadius_*std::pow(2./3, 2./3));
}


impact::contactState impact::jkrContact::equilibrium() const
{
    return at(equilibriumRadius_);
}


impact::contactState impact::jkrContact::pullOff() const
{
    return at(equilibriumRadius_*std::pow(0.5, 2./3));
}


impact::contactState impact::jkrContact::lastTouch() const
{
    return at(equilibriumRadius_*std::pow(1./6, 2./3));
}


impact::jkrContact::units impact::jkrContact::scales(double speed) const
{
    const double hertz = std::pow
    (
        0.75*mass_*radius_*radius_*speed*speed/modulus_, 0.2
    );
    double r = std::max(equilibriumRadius_, hertz);
    if (r == 0)
    {
        r = radius_;
    }
    const double ratio = equilibriumRadius_/r;
    const double length = r*r/radius_;
    const double force = 4*modulus_*r*r*r/(3*radius_);
    const double time = std::sqrt(mass_*length/force);
    return
    {
        jkrCurve(2./3*ratio*std::sqrt(ratio)),
        r,
        length,
        force,
        time,
        length/time,
        force*length
    };
}
