/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "specificHeat.H"
#include "outOfRange.H"

#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

impact::specificHeat::specificHeat
(
    const std::vector<double>& c,
    const melting& m,
    double highest
)
:
    c_(c),
    melting_(m),
    constant_(c.size() == 1 && m.latentHeat == 0)
{
    if (c_.empty())
    {
        throwInvalid("Cp0 (): valid range at least one number");
    }
    for (const double ci : c_)
    {
        checkRange("Cp0", ci, "(-1e30, 1e30) J/kg/K");
    }
    checkRange("latentHeat", m.latentHeat, "[0, 1e9] J/kg");
    if (m.latentHeat > 0)
    {
        checkRange("solidus", m.solidus, "(0, 1e8) K, nothing is solid there");
        checkRange
        (
            m.liquidus > m.solidus && within(m.liquidus, "(0, 1e8)"),
            "liquidus", m.liquidus, "(solidus, 1e8) K"
        );
    }

    // Without the latent heat, which only adds
    melting_.latentHeat = 0;
    for (int i = 0; i <= 1000; ++i)
    {
        const double T = 1 + (highest - 1)*0.001*i;
        checkRange
        (
            within(cp(T), "[1e-3, 1e9]"), "Cp0", cp(T),
            "[0.001, 1e9] J/kg/K at all temperatures from 1 to "
          + std::to_string(int(highest)) + " K"
        );
        if (c_.size() == 1)
        {
            break;
        }
    }
    melting_.latentHeat = m.latentHeat;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

double impact::specificHeat::solve(double h) const
{
    if (h <= 0)
    {
        return 0;
    }

    // Enclosed, and by a straight line where Newton's step leads out
    double low = 0;
    double high = std::max(2*h/std::max(cp(300), 1e-3), 1000.);
    for (int i = 0; i < 200 && this->h(high) < h; ++i)
    {
        high *= 2;
    }
    double T = std::min(std::max(h/cp(300), low), high);
    for (int i = 0; i < 200; ++i)
    {
        const double miss = this->h(T) - h;
        (miss > 0 ? high : low) = T;
        double next = T - miss/cp(T);
        if (!(next > low && next < high))
        {
            next = 0.5*(low + high);
        }
        if (std::fabs(next - T) <= 4e-16*T)
        {
            return next;
        }
        T = next;
    }
    return T;
}
