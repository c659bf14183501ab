/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "sphereReflection.H"
#include "elementary.H"

#include <cmath>

namespace
{
    //- Above the greatest value of the polynomial
    const double envelope = 0.75;

    double polynomial(double x)
    {
        return
            x*(1.248 + x*(0.4938 + x*(-1.903
          + x*(1.104 + x*(-0.2515 + x*0.02042)))));
    }

    double root(double x)
    {
        return std::sqrt(x > 0 ? x : 0);
    }
}


double impact::sphereReflection::density(law form, double x)
{
    return
        form == law::polynomial ? polynomial(x)
      : 4/(3*M_PI)*std::sin(x)*(std::sin(x) + (M_PI - x)*std::cos(x));
}


impact::vector3 impact::sphereReflection::diffuse
(
    law form,
    const vector3& incident,
    counterRandom& rnd
)
{
    double cosine;
    if (form == law::exact)
    {
        // Between normal and reversed incidence, and between normal and the
        // direction sought: both squares of the sines are uniform
        const double a = rnd.uniform();
        const double b = rnd.uniform();
        double s, c;
        sinCosTurns(rnd.uniform(), s, c);
        cosine = std::sqrt((1 - a)*(1 - b)) + std::sqrt(a*b)*c;
    }
    else
    {
        double x;
        do
        {
            x = M_PI*rnd.uniform();
        }
        while (envelope*rnd.uniform() >= polynomial(x));
        cosine = std::cos(x);
    }

    const vector3 back = -incident;
    const vector3 other = std::fabs(back.x) < 0.6
      ? vector3{1, 0, 0} : vector3{0, 1, 0};
    const vector3 side = cross(back, other);
    const vector3 first = (1/mag(side))*side;
    const vector3 second = cross(back, first);
    double s, c;
    sinCosTurns(rnd.uniform(), s, c);
    const double sine = root(1 - cosine*cosine);
    return cosine*back + (sine*c)*first + (sine*s)*second;
}


impact::vector3 impact::sphereReflection::specular(counterRandom& rnd)
{
    const double cosine = 2*rnd.uniform() - 1;
    const double sine = root(1 - cosine*cosine);
    double s, c;
    sinCosTurns(rnd.uniform(), s, c);
    return {cosine, sine*c, sine*s};
}
