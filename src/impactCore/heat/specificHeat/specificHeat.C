/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "specificHeat.H"
#include "bracketedRoot.H"
#include "outOfRange.H"

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
    end_(highest),
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

    for (int i = 0; i <= 1000; ++i)
    {
        const double T = 1 + (highest - 1)*0.001*i;
        checkRange
        (
            within(polynomialCp(T), "[1e-3, 1e9]"), "Cp0", polynomialCp(T),
            "[0.001, 1e9] J/kg/K at all temperatures from 1 to "
          + std::to_string(int(highest)) + " K"
        );
        if (c_.size() == 1)
        {
            break;
        }
    }
    cpEnd_ = polynomialCp(end_);
    hEnd_ = polynomialH(end_);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

double impact::specificHeat::solve(double h) const
{
    if (h <= 0)
    {
        return 0;
    }

    boost::uintmax_t steps = 60;
    const auto ends = boost::math::tools::bracket_and_solve_root
    (
        [&](double T) { return this->h(T) - h; },
        h/cp(300), 1.5, true, allDigits, steps
    );
    return 0.5*(ends.first + ends.second);
}
