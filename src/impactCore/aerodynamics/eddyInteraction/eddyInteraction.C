/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "eddyInteraction.H"

#include <algorithm>
#include <cmath>

namespace
{

// As long as numbers may be in the files of OpenFOAM, which refuses 1e300
constexpr double never = 1e299;

} // End namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double impact::eddyInteraction::lifetime(const turbulence& t)
{
    // Without turbulence there is no eddy to end
    return t.k > 0 && t.epsilon > 0 ? 0.3*t.k/t.epsilon : never;
}


double impact::eddyInteraction::size(const turbulence& t)
{
    const double Cmu = 0.09;
    return
        t.k > 0 && t.epsilon > 0
      ? std::pow(Cmu, 0.75)*t.k*std::sqrt(t.k)/t.epsilon
      : never;
}


double impact::eddyInteraction::crossing(double size, double speed, double rate)
{
    if (!(size*rate < speed))
    {
        return never;
    }

    // Of the way that it would come
    const double share = size*rate/speed;
    return share > 1e-12 ? -std::log1p(-share)/rate : size/speed;
}


impact::eddyInteraction::eddy impact::eddyInteraction::begin
(
    const turbulence& t,
    const vector3& w,
    double rate,
    const vector3& solved,
    double shortest,
    counterRandom random
)
{
    eddy e{vector3{0, 0, 0}, lifetime(t)};
    if (e.life == never)
    {
        return e;
    }
    const double sigma = std::sqrt((2./3)*t.k);
    for (int c = 0; c < 3; ++c)
    {
        e.u[c] = solved[c]*sigma*random.normal();
    }
    e.life = std::min(e.life, crossing(size(t), mag(w + e.u), rate));
    if (e.life < shortest)
    {
        e.u = std::sqrt(e.life/shortest)*e.u;
        e.life = shortest;
    }
    return e;
}
