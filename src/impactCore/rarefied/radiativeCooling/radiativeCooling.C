/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "radiativeCooling.H"
#include "bracketedRoot.H"
#include "outOfRange.H"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace
{

const double infinity = std::numeric_limits<double>::infinity();

//- Distance from the equilibrium, relative to it, that rounding hides
const double hidden = 4e-16;

//- Temperatures the table reaches, on the scale of the equilibrium
const double hottest = 1e6;


double arcoth(double distance)
{
    return 0.5*std::log1p(2/distance);
}


double fourth(double x)
{
    return (x*x)*(x*x);
}


//- (arcoth x - arccot x)/2, which is u^3/3 + u^7/7 + ... with u = 1/x
double hotPrimitive(double x)
{
    const double u = 1/x;
    if (u > 0.5)
    {
        return 0.5*(arcoth(std::max(x - 1, hidden)) - std::atan(u));
    }
    const double z = fourth(u);
    double sum = 0;
    for (int j = 13; j >= 0; --j)
    {
        sum = sum*z + 1./(4*j + 3);
    }
    return sum*u*u*u;
}

} // End anonymous namespace


impact::radiativeCooling::radiativeCooling(const setup& s)
:
    setup_(s),
    absorbed_(0),
    scaleT_(1000),
    scaleC_(1),
    equilibrium_(0),
    kinked_(s.heatCapacity.size() > 1),
    table_(2*std::size_t(nCells), cell{}),
    law_(lawType::none)
{
    checkRange("density", s.density, "(0, 1e6) kg/m3");
    checkRange("absorptivity", s.absorptivity, "[0, 1]");
    checkRange("emissivity", s.emissivity, "[0, 1]");
    checkRange("sunlight", s.sunlight, "[0, 1e12) W/m2");
    checkRange("reflected", s.reflected, "[0, 1e12) W/m2");
    checkRange("infrared", s.infrared, "[0, 1e12) W/m2");
    if (s.heatCapacity.empty())
    {
        throw std::invalid_argument("heatCapacity: the list is empty");
    }
    for (std::size_t i = 0; i < s.heatCapacity.size(); ++i)
    {
        const auto& p = s.heatCapacity[i];
        checkRange("heatCapacity", p.second, "(0, 1e9) J/(kg K)");
        if (kinked_)
        {
            checkRange("temperature of heatCapacity", p.first, "(0, 1e8) K");
        }
        checkRange
        (
            i == 0 || p.first > s.heatCapacity[i - 1].first,
            "temperature of heatCapacity", p.first,
            "greater than the one before, K"
        );
    }

    absorbed_ =
        s.absorptivity*(s.sunlight + s.reflected) + s.emissivity*s.infrared;
    if (s.emissivity > 0)
    {
        law_ = absorbed_ > 0 ? lawType::both : lawType::emission;
        equilibrium_ =
            std::pow(absorbed_/(4*s.emissivity*stefanBoltzmann), 0.25);
    }
    else if (absorbed_ > 0)
    {
        law_ = lawType::absorption;
        equilibrium_ = infinity;
    }
    if (law_ == lawType::both)
    {
        scaleT_ = equilibrium_;
        checkRange
        (
            !kinked_
         || (
                equilibrium_ >= s.heatCapacity.front().first
             && equilibrium_ <= s.heatCapacity.back().first
            ),
            "equilibrium temperature", equilibrium_,
            "that of the pairs of heatCapacity, K"
        );
    }
    makePieces();
    if (law_ == lawType::both || law_ == lawType::emission)
    {
        makeTable(true);
    }
    if (law_ != lawType::emission)
    {
        makeTable(false);
    }
}


void impact::radiativeCooling::makePieces()
{
    const auto& c = setup_.heatCapacity;
    scaleC_ = c.front().second;
    pieces_.assign(1, {0, infinity, 1, 0, 0, 0});
    for (std::size_t i = 0; i + 1 < c.size(); ++i)
    {
        const double x0 = c[i].first/scaleT_;
        const double x1 = c[i + 1].first/scaleT_;
        const double c0 = c[i].second/scaleC_;
        const double b = (c[i + 1].second/scaleC_ - c0)/(x1 - x0);
        pieces_.back().to = x0;
        pieces_.push_back({x0, x1, c0 - b*x0, b, 0, 0});
    }
    if (kinked_)
    {
        const double last = c.back().second/scaleC_;
        pieces_.push_back
            ({pieces_.back().to, infinity, last, 0, 0, 0});
    }
    if (law_ == lawType::none)
    {
        pieces_.assign(1, {0, infinity, 1, 0, 0, 0});
    }

    // y at the ends that the branches come from
    const bool bounded = law_ == lawType::both;
    for (std::size_t i = pieces_.size(); i-- > 1;)
    {
        const piece& p = pieces_[i];
        const double low = p.from;
        if (law_ == lawType::emission || (bounded && low > 1))
        {
            pieces_[i - 1].yHot = p.yHot + primitive(p, low, true)
              - (p.to < infinity ? primitive(p, p.to, true) : 0);
        }
    }
    for (std::size_t i = 0; i + 1 < pieces_.size(); ++i)
    {
        const piece& p = pieces_[i];
        if (law_ == lawType::absorption || (bounded && p.to < 1))
        {
            pieces_[i + 1].yCold = p.yCold
              + primitive(p, p.to, false) - primitive(p, p.from, false);
        }
    }
}


double impact::radiativeCooling::primitive
(
    const piece& p,
    double x,
    bool hot
) const
{
    switch (law_)
    {
        case lawType::emission:
            return (p.a/(3*x) + p.b/2)/(x*x);

        case lawType::both:
        {
            const double gap = std::max(std::fabs(x - 1), hidden);
            if (hot)
            {
                return p.a*hotPrimitive(x)
                  + (p.b != 0 ? 0.5*p.b*arcoth(gap*(x + 1)) : 0);
            }
            const double z = x*x;
            return
                0.5*p.a*(0.5*std::log1p(2*x/gap) + std::atan(x))
              + 0.25*p.b*std::log1p(2*z/(gap*(1 + x)));
        }

        default:
            return x*(p.a + 0.5*p.b*x);
    }
}


const impact::radiativeCooling::piece&
impact::radiativeCooling::at(double x) const
{
    std::size_t i = 0;
    while (i + 1 < pieces_.size() && x > pieces_[i].to)
    {
        ++i;
    }
    return pieces_[i];
}


double impact::radiativeCooling::coordinate(double x, bool hot) const
{
    const piece& p = at(x);
    return
        hot
      ? p.yHot + primitive(p, x, true)
      - (p.to < infinity ? primitive(p, p.to, true) : 0)
      : p.yCold + primitive(p, x, false)
      - (p.from > 0 ? primitive(p, p.from, false) : 0);
}


void impact::radiativeCooling::slopes
(
    double x,
    double& first,
    double& second
) const
{
    // dx/dy = g/c, with the sign of g that of the balance
    const piece& p = at(x);
    const double c = p.a + p.b*x;
    double g = 1, dg = 0;
    if (law_ == lawType::both)
    {
        g = (1 - x)*(1 + x)*(1 + x*x);
        dg = -4*x*x*x;
    }
    else if (law_ == lawType::emission)
    {
        g = -fourth(x);
        dg = -4*x*x*x;
    }
    first = g/c;
    second = (dg - g*p.b/c)/c*first;
}


double impact::radiativeCooling::invert(double y, bool hot) const
{
    if (law_ == lawType::none)
    {
        return y;
    }
    const bool both = law_ == lawType::both;
    if (both && y >= coordinate(hot ? 1 + hidden : 1 - hidden, hot))
    {
        return 1;
    }

    // In w, with x = exp(w), or the logarithm of the distance from the
    // equilibrium, log y is nearly straight
    auto place = [=](double w)
    {
        const double e = std::exp(w);
        return !both ? e : hot ? 1 + e : e/(1 + e);
    };
    const double logY = std::log(y);
    return place
    (
        bracketedRoot
        (
            [&](double w)
            {
                return std::log(coordinate(place(w), hot)) - logY;
            },
            -50,
            both ? 37 : 50
        )
    );
}


void impact::radiativeCooling::makeTable(bool hot)
{
    const int cells = 1 << perOctaveBits;
    cell* table = table_.data() + (hot ? 0 : nCells);
    double x0 = invert(std::ldexp(1., lowestExponent), hot);
    for (int i = 0; i < nCells; ++i)
    {
        const double octave =
            std::ldexp(1., lowestExponent + i/cells);
        const double h = octave/cells;
        const double x1 = invert(octave + (i % cells + 1)*h, hot);
        double d0 = 0, s0 = 0, d1 = 0, s1 = 0;

        // Where rounding hides the distance from the equilibrium there is
        // nothing to interpolate
        const bool flat =
            law_ == lawType::both && std::fabs(x0 - 1) < 1e-14;
        if (!flat)
        {
            slopes(x0, d0, s0);
            slopes(x1, d1, s1);
        }
        d0 *= h;
        d1 *= h;
        s0 *= h*h;
        s1 *= h*h;
        const double d = flat ? 0 : x1 - x0;
        const double a[6] =
        {
            x0,
            d0,
            0.5*s0,
            10*d - 6*d0 - 4*d1 - 1.5*s0 + 0.5*s1,
            -15*d + 8*d0 + 7*d1 + 1.5*s0 - s1,
            6*d - 3*d0 - 3*d1 - 0.5*s0 + 0.5*s1
        };
        for (int k = 0; k < 6; ++k)
        {
            table[i].a[k] = scaleT_*a[k];
        }
        x0 = x1;
    }
}


impact::radiativeCooling::state
impact::radiativeCooling::start(double T) const
{
    const auto& c = setup_.heatCapacity;
    const double top =
        kinked_ ? c.back().first
      : law_ == lawType::both ? std::min(1e8, hottest*equilibrium_) : 1e8;
    const double bottom = kinked_ ? c.front().first : 1e-6;
    if (!(T >= bottom && T <= top))
    {
        throwOutOfRange
        (
            "temperature", T, '[', bottom, ", ", top, "] K",
            kinked_ ? ", that of the pairs of heatCapacity" : ""
        );
    }
    const double x = T/scaleT_;
    const bool hot =
        law_ == lawType::emission || (law_ == lawType::both && x > 1);
    return {coordinate(x, hot), hot ? 0 : nCells};
}


double impact::radiativeCooling::rate(double diameter) const
{
    const double eps = setup_.emissivity;
    const double power =
        law_ == lawType::none ? 0
      : law_ == lawType::absorption ? 0.25*absorbed_
      : eps*stefanBoltzmann*fourth(scaleT_);
    return 3*power/(0.5*diameter*setup_.density*scaleC_*scaleT_);
}


double impact::radiativeCooling::exactTemperature(const state& s) const
{
    return scaleT_*invert(s.y, s.branch == 0);
}


double impact::radiativeCooling::mended(const state& s, double T) const
{
    const double x = T/scaleT_;
    if (law_ == lawType::both && std::fabs(x - 1) < 1e-9)
    {
        return T;
    }
    double first, second;
    slopes(x, first, second);
    return T - scaleT_*(coordinate(x, s.branch == 0) - s.y)*first;
}


double impact::radiativeCooling::after
(
    double T,
    double diameter,
    double time
) const
{
    state s = start(T);
    s.y += rate(diameter)*time;
    return exactTemperature(s);
}


void impact::radiativeCooling::checkEnd
(
    double T,
    double diameter,
    double time
) const
{
    const double end = after(T, diameter, time);
    const double low = setup_.heatCapacity.front().first;
    const double high = setup_.heatCapacity.back().first;

    // An end of the pairs is reached to round-off
    if (kinked_ && !(end >= low*(1 - 1e-9) && end <= high*(1 + 1e-9)))
    {
        throwOutOfRange
        (
            "temperature", end, '[', low, ", ", high, "] K, that of the pairs"
            " of heatCapacity, which a particle of diameter ", diameter,
            " m leaves within ", time, " s from ", T, " K: more pairs"
        );
    }
}


double impact::radiativeCooling::eulerHeat(double diameter) const
{
    const double c = setup_.heatCapacity.front().second;
    return 1.5*absorbed_/(diameter*setup_.density*c);
}


double impact::radiativeCooling::eulerLoss(double diameter) const
{
    const double c = setup_.heatCapacity.front().second;
    return
        6*setup_.emissivity*stefanBoltzmann/(diameter*setup_.density*c);
}


double impact::radiativeCooling::eulerLimit(double T, double diameter) const
{
    if (!(setup_.emissivity > 0))
    {
        return infinity;
    }
    double c = infinity;
    for (const auto& p : setup_.heatCapacity)
    {
        c = std::min(c, p.second);
    }
    const double top = std::max(T, equilibrium_);
    return
        0.5*diameter*setup_.density*c
       /(12*setup_.emissivity*stefanBoltzmann*top*top*top);
}
