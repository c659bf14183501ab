/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "dissipationLaw.H"
#include "bracketedRoot.H"
#include "jkrMotion.H"
#include "outOfRange.H"

#include <Eigen/Dense>

#include <algorithm>
#include <limits>
#include <set>
#include <sstream>

namespace
{

const double infinity = std::numeric_limits<double>::infinity();

//- Values of e among which changes of sign are looked for
const int nScan = 400;

} // End anonymous namespace


impact::dissipationLaw::dissipationLaw
(
    const std::vector<double>& coeffs,
    double low,
    double high,
    unloadingType unloading
)
:
    coeffs_(coeffs),
    low_(low),
    high_(high),
    unloading_(unloading)
{
    if (coeffs.empty())
    {
        throwOutOfRange("number of coeffs", 0, ">= 1");
    }
    if (!(low >= 0 && low < high && high <= 1))
    {
        throwOutOfRange
        (
            "range of e", rangeText("()", low, high), "0 <= low < high <= 1"
        );
    }
    for (int i = 0; i <= nScan; ++i)
    {
        const double e = low + (high - low)*i/nScan;
        const double a = value(e);
        if (!(a >= 0 && a <= 10))
        {
            std::ostringstream entry;
            entry<< "alpha(e) at e = " << e << ": alpha";
            throwOutOfRange(entry.str(), a, "[0, 10]");
        }
    }
}


double impact::dissipationLaw::value(double e) const
{
    double a = 0;
    for (auto c = coeffs_.rbegin(); c != coeffs_.rend(); ++c)
    {
        a = a*e + *c;
    }
    return a;
}


impact::dissipationLaw impact::dissipationLaw::constant
(
    double alpha,
    unloadingType unloading
)
{
    return dissipationLaw({alpha}, 0, 1, unloading);
}


impact::dissipationLaw impact::dissipationLaw::marshall
(
    unloadingType unloading
)
{
    std::vector<double> coeffs =
        {1.2728, -4.2783, 11.087, -22.348, 27.467, -18.022, 4.8218};
    for (double& c : coeffs)
    {
        c *= std::sqrt(2.);
    }
    return dissipationLaw(coeffs, 0, 1, unloading);
}


double impact::dissipationLaw::restitution
(
    double alpha,
    double q,
    unloadingType unloading
)
{
    const double p = q*jkrMotion::separationSpeed();
    const double ratio = std::max(1., std::pow(p, 0.2));
    const double start = p/std::pow(ratio, 5);
    return jkrMotion(alpha, unloading, 1e-11).impact
    (
        jkrCurve(2./3/(ratio*ratio*ratio)), start
    ).exitSpeed/start;
}


double impact::dissipationLaw::calibrated
(
    double q,
    double e,
    unloadingType unloading
)
{
    const double limit = restitution(0, q, unloading);
    if (!(limit > 0))
    {
        std::ostringstream entry;
        entry<< "restitution " << e << ": its speed over v_st";
        throwOutOfRange
        (
            entry.str(), q, "(1, inf), slower ones stick without any loss"
        );
    }
    if (!(e > 0 && e < limit))
    {
        std::ostringstream entry;
        entry<< "restitution at " << q << " times v_st:";
        throwOutOfRange(entry.str(), e, rangeText("()", 0, limit));
    }
    return bracketedRoot
    (
        [&](double a) { return restitution(a, q, unloading) - e; },
        0,
        std::sqrt(5.)
    );
}


impact::dissipationLaw impact::dissipationLaw::fit
(
    const std::vector<measurement>& data,
    int degree,
    bool extrapolate,
    unloadingType unloading
)
{
    const int n = int(data.size());
    if (n < 2)
    {
        throwOutOfRange("number of data", n, ">= 2");
    }
    // Repeated measurements weigh more, but give no further coefficient
    std::set<double> different;
    for (const measurement& m : data)
    {
        different.insert(m.restitution);
    }
    const int maxDegree = int(different.size()) - 1;
    if (degree < 0 || degree > maxDegree)
    {
        throwOutOfRange("degree", degree, rangeText("[]", 0, maxDegree));
    }
    Eigen::MatrixXd powers(n, degree + 1);
    Eigen::VectorXd alpha(n);
    double low = 1, high = 0;
    for (int i = 0; i < n; ++i)
    {
        const double e = data[i].restitution;
        alpha[i] = calibrated(data[i].q, e, unloading);
        for (int k = 0; k <= degree; ++k)
        {
            powers(i, k) = std::pow(e, k);
        }
        low = std::min(low, e);
        high = std::max(high, e);
    }
    const Eigen::VectorXd c = powers.colPivHouseholderQr().solve(alpha);
    return dissipationLaw
    (
        std::vector<double>(c.data(), c.data() + c.size()),
        extrapolate ? 0 : low,
        high,
        unloading
    );
}


double impact::dissipationLaw::alpha(double e) const
{
    checkRange("restitution of alpha(e)", e, low_, high_);
    return value(e);
}


double impact::dissipationLaw::speed(double e) const
{
    const double a = alpha(e);
    const double capture =
        jkrMotion(a, unloading_, 1e-13).captureRatio();
    if (e == 0 || std::isinf(capture))
    {
        return capture;
    }
    if (e >= jkrMotion::hertzRestitution(a))
    {
        return infinity;
    }

    // In x = log(V/V_cap) up to where e is that without adhesion
    const double far = 80;
    const double x = bracketedRoot
    (
        [&](double s)
        {
            return e - restitution(a, capture*std::exp(s), unloading_);
        },
        0,
        far
    );
    return x < 0.999*far ? capture*std::exp(x) : infinity;
}


impact::normalRebound impact::dissipationLaw::rebound(double q) const
{
    if (isConstant())
    {
        const double e = restitution(coeffs_[0], q, unloading_);
        return {e == 0, e};
    }

    // From above, the first e at which E(alpha(e), q) is no longer below e
    auto excess = [&](double e)
    {
        return restitution(value(e), q, unloading_) - e;
    };
    double above = high_;
    if (excess(above) >= 0 && high_ < 1)
    {
        std::ostringstream range;
        range<< "of speeds with a restitution up to " << high_;
        throwOutOfRange("speed over v_st", q, range.str());
    }
    for (int i = nScan - 1; i >= 0; --i)
    {
        const double e = low_ + (high_ - low_)*i/nScan;
        const double x = excess(e);
        if (x > 0 || (x == 0 && e > 0))
        {
            return {false, bracketedRoot(excess, e, above)};
        }
        above = e;
    }
    if (low_ > 0)
    {
        std::ostringstream range;
        range<< "of speeds with a restitution from " << low_ << " on";
        throwOutOfRange("speed over v_st", q, range.str());
    }
    return {true, 0};
}


std::vector<impact::dissipationLaw::interval>
impact::dissipationLaw::ambiguous() const
{
    std::vector<interval> found;
    if (isConstant())
    {
        return found;
    }
    double last = speed(low_), top = last;
    bool falling = false;
    for (int i = 1; i <= nScan; ++i)
    {
        const double e = i < nScan ? low_ + (high_ - low_)*i/nScan : high_;
        const double q = speed(e);
        if (q < last)
        {
            if (!falling)
            {
                top = last;
            }
            falling = true;
        }
        else if (falling)
        {
            found.push_back({last, top});
            falling = false;
        }
        last = q;
    }
    if (falling)
    {
        found.push_back({last, top});
    }
    return found;
}


std::vector<impact::dissipationLaw::interval>
impact::dissipationLaw::unreachable() const
{
    auto reached = [&](double e)
    {
        return e == 0 || e < jkrMotion::hertzRestitution(value(e));
    };
    auto edge = [&](double a, double b)
    {
        return bracketedChange(reached, a, b, allDigits).first;
    };
    std::vector<interval> found;
    if (isConstant())
    {
        return found;
    }
    double last = low_;
    if (!reached(last))
    {
        found.push_back({low_, high_});
    }
    for (int i = 1; i <= nScan; ++i)
    {
        const double e = i < nScan ? low_ + (high_ - low_)*i/nScan : high_;
        if (reached(last) && !reached(e))
        {
            found.push_back({edge(last, e), high_});
        }
        else if (!reached(last) && reached(e))
        {
            found.back().high = edge(last, e);
        }
        last = e;
    }
    return found;
}
