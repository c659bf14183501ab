/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "lawCurve.H"
#include "bracketedRoot.H"
#include "outOfRange.H"

#include <algorithm>
#include <cmath>

namespace
{

const double infinity = std::numeric_limits<double>::infinity();

//- Values of e among which changes of sign are looked for
const int nScan = 400;

//- Rise of e between two nodes that is taken for a jump
const double jump = 0.02;

//- Third difference of the nodes up to which e is interpolated
const double smooth = 4e-6;

//- Threshold in q of a condition that comes true as q grows, between low,
//  where it is not, and high, where it is
template<class Condition>
double threshold(const Condition& holds, double low, double high)
{
    return std::exp
    (
        impact::bracketedChange
        (
            [&](double s) { return holds(std::exp(s)); },
            std::log(low),
            std::log(high),
            impact::allDigits
        ).second
    );
}

} // End anonymous namespace


double impact::lawCurve::excess(double e, double q) const
{
    return table_->rebound(law_.value(e), q).restitution - e;
}


double impact::lawCurve::search(double q) const
{
    double above = law_.high();
    for (int i = nScan - 1; i >= 0; --i)
    {
        const double e = law_.high()*i/nScan;
        if (excess(e, q) > 0)
        {
            return bracketedRoot
            (
                [&](double s) { return excess(s, q); }, e, above
            );
        }
        above = e;
    }
    return 0;
}


double impact::lawCurve::solve(double q) const
{
    const double y = std::pow(captureRatio_/q, 0.2);
    const double x = nNodes*std::sqrt(std::fmax(1 - y, 0.));
    const int i = int(x);
    if (i >= 1 && i + 2 < nNodes)
    {
        // Everett's cubic, good to a fortieth of the third difference
        const double* e = &nodes_[i - 1];
        const double before = e[0] - 2*e[1] + e[2];
        const double after = e[1] - 2*e[2] + e[3];
        if (std::fabs(after - before) < smooth)
        {
            const double t = x - i;
            return
                e[1] + t*(e[2] - e[1])
              - t*(1 - t)/6*((2 - t)*before + (1 + t)*after);
        }
    }
    if (i >= nNodes - 1 || nodes_[i + 1] - nodes_[i] > jump)
    {
        return search(q);
    }

    double low = std::fmax(nodes_[i] - 1e-9, 0.);
    double high = std::fmin(nodes_[i + 1] + 1e-9, law_.high());
    double fLow = excess(low, q), fHigh = excess(high, q);
    if (!(fLow >= 0 && fHigh <= 0 && fLow > fHigh))
    {
        return search(q);
    }
    return bracketedRoot
    (
        [&](double e) { return this->excess(e, q); },
        low,
        high,
        fLow,
        fHigh,
        [](double a, double b) { return b - a <= 1e-9; }
    );
}


void impact::lawCurve::refuse(double q) const
{
    std::ostringstream range;
    range<< "(0, " << highSpeed_ << "], where alpha(e) holds up to e = "
        << law_.high();
    throwOutOfRange("speed over v_st", q, range.str());
}


impact::lawCurve::lawCurve
(
    const dissipationLaw& law,
    unloadingType unloading,
    bool hold
)
:
    law_(law),
    highSpeed_(infinity)
{
    if (law.isConstant())
    {
        constant_.emplace(law_.coeffs()[0], unloading);
        captureRatio_ = constant_->captureRatio();
        highSpeed_ = captureRatio_;
        return;
    }
    if (law.low() > 0)
    {
        throwOutOfRange
        (
            "least restitution of alpha(e)",
            law.low(),
            "0: the speed of capture belongs to it (with type calibrated:"
            " extrapolate yes)"
        );
    }
    for (int i = 0; i <= nScan; ++i)
    {
        const double alpha =
            law.alpha(std::min(law.high()*i/nScan, law.high()));
        checkRange("alpha(e) of a wall", alpha, 0, restitutionTable::maxAlpha);
    }
    table_ = &restitutionTable::of(unloading);

    const double start = table_->captureRatio(law_.coeffs()[0]);
    if (law_.high() < 1 && excess(law_.high(), 1e9*start) >= 0)
    {
        highSpeed_ = threshold
        (
            [&](double q) { return excess(law_.high(), q) >= 0; },
            1e-3,
            1e9*start
        );
        if (hold)
        {
            constant_.emplace(law.alpha(law_.high()), unloading);
        }
    }
    captureRatio_ = std::min
    (
        highSpeed_,
        threshold
        (
            [&](double q)
            {
                return q >= highSpeed_ || search(q) > 0;
            },
            1e-3,
            2*start
        )
    );
    nodes_.resize(nNodes);
    for (int i = 0; i < nNodes; ++i)
    {
        const double x = double(i)/nNodes;
        const double q =
            captureRatio_*std::pow(1 - x*x, -5)*(i ? 1 : 1 + 1e-14);
        nodes_[i] = q < highSpeed_ ? search(q) : law_.high();
    }
}
