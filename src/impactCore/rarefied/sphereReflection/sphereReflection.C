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

    //- A direction at an angle to an axis, anywhere around it
    impact::vector3 around
    (
        const impact::vector3& axis,
        double cosine,
        impact::counterRandom& rnd
    )
    {
        const impact::vector3 first = across(axis);
        const impact::vector3 second = cross(axis, first);
        double s, c;
        impact::sinCosTurns(rnd.uniform(), s, c);
        const double sine = root(1 - cosine*cosine);
        return cosine*axis + (sine*c)*first + (sine*s)*second;
    }
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

    return around(-incident, cosine, rnd);
}


impact::vector3 impact::sphereReflection::normalHit
(
    const vector3& incident,
    counterRandom& rnd
)
{
    const double cosine = std::sqrt(rnd.uniform());
    return around(-incident, cosine, rnd);
}


impact::vector3 impact::sphereReflection::aboutNormal
(
    const vector3& normal,
    counterRandom& rnd
)
{
    const double cosine = std::sqrt(rnd.uniform());
    return around(normal, cosine, rnd);
}


impact::vector3 impact::sphereReflection::specular(counterRandom& rnd)
{
    const double cosine = 2*rnd.uniform() - 1;
    const double sine = root(1 - cosine*cosine);
    double s, c;
    sinCosTurns(rnd.uniform(), s, c);
    return {cosine, sine*c, sine*s};
}
