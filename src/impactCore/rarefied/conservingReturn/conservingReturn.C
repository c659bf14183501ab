/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "conservingReturn.H"

#include <cmath>

impact::balance impact::conservingReturn::of
(
    const cellCollisions::molecules& gas
) const
{
    balance b;
    for (int i = 0; i < gas.n; ++i)
    {
        const cellCollisions::species& s = species_[gas.species[i]];
        const vector3 u = gas.velocity(i);
        b.momentum = b.momentum + s.mass*u;
        b.energy += 0.5*s.mass*dot(u, u) + s.internal(gas.internalEnergy[i]);
    }
    return b;
}


impact::balance impact::conservingReturn::give
(
    const cellCollisions::molecules& gas,
    const balance& b
) const
{
    if (gas.n < 2 || b.isZero())
    {
        return b;
    }

    double mass = 0;
    vector3 momentum{0, 0, 0};
    for (int i = 0; i < gas.n; ++i)
    {
        const double m = species_[gas.species[i]].mass;
        mass += m;
        momentum = momentum + m*gas.velocity(i);
    }
    const vector3 U = (1/mass)*momentum;
    double thermal = 0;
    for (int i = 0; i < gas.n; ++i)
    {
        const cellCollisions::species& s = species_[gas.species[i]];
        const vector3 c = gas.velocity(i) - U;
        thermal += 0.5*s.mass*dot(c, c) + s.internal(gas.internalEnergy[i]);
    }

    for (double part = 1; part >= 1./1024; part *= 0.5)
    {
        const vector3 P = part*b.momentum;
        const double after =
            thermal + part*b.energy - dot(U, P) - 0.5*dot(P, P)/mass;
        if (!(after >= 0.25*thermal && after <= 4*thermal && after > 0))
        {
            continue;
        }
        const double factor = after/thermal;
        const double root = std::sqrt(factor);
        const vector3 to = U + (1/mass)*P;
        for (int i = 0; i < gas.n; ++i)
        {
            gas.u[i] = to.x + root*(gas.u[i] - U.x);
            gas.v[i] = to.y + root*(gas.v[i] - U.y);
            gas.w[i] = to.z + root*(gas.w[i] - U.z);
            gas.internalEnergy[i] *= factor;
        }
        return part == 1 ? balance() : (1 - part)*b;
    }
    return b;
}
