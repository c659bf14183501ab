/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "adheredParticles.H"
#include "outOfRange.H"

impact::adheredParticles::adheredParticles
(
    const std::vector<double>& bounds,
    std::size_t nFaces
)
:
    bounds_(bounds),
    nClasses_(int(bounds.size()) + 1),
    faces_(nFaces*nClasses_, sums{})
{
    checkRange("number of sizeClasses", double(bounds.size()), 0, maxBounds);
    double last = 0;
    for (double bound : bounds)
    {
        if (!(bound > last && std::isfinite(bound)))
        {
            throwOutOfRange
            (
                "sizeClasses", bound, rangeText("()", last, INFINITY) + " m"
            );
        }
        last = bound;
    }
}


void impact::adheredParticles::add
(
    std::size_t face,
    int k,
    double numberPerArea,
    double diameter,
    double particleMass
)
{
    sums& s = at(face, k);
    const double d2 = diameter*diameter;
    s[number] += numberPerArea;
    s[mass] += numberPerArea*particleMass;
    s[area] += numberPerArea*(M_PI/4*d2);
    s[volume] += numberPerArea*(M_PI/6*d2*diameter);
}


impact::adheredParticles::sums impact::adheredParticles::take
(
    std::size_t face,
    int k,
    double numberPerArea
)
{
    sums& s = at(face, k);
    sums taken = s;

    // What round-off leaves of the last particle is no particle
    if (numberPerArea < s[number]*(1 - 1e-12))
    {
        const double part = numberPerArea/s[number];
        for (int i = 0; i < nQuantities; ++i)
        {
            taken[i] = part*s[i];
            s[i] -= taken[i];
        }
    }
    else
    {
        s = sums{};
    }
    return taken;
}
