/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "counterRandom.H"

#include <cmath>

double impact::counterRandom::normal()
{
    if (haveSpareNormal_)
    {
        haveSpareNormal_ = false;
        return spareNormal_;
    }

    // Box and Muller: two independent normal numbers from two uniform ones.
    // No rejection, so that a draw always uses the same number of words.
    const double radius = std::sqrt(-2*std::log(uniform()));
    const double angle = 2*M_PI*uniform();
    spareNormal_ = radius*std::sin(angle);
    haveSpareNormal_ = true;
    return radius*std::cos(angle);
}
