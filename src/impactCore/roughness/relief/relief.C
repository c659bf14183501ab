/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "relief.H"
#include "elementary.H"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace
{

typedef impact::relief::interval interval;

void require(bool ok, const char* name, double value, const char* range)
{
    if (!ok)
    {
        std::ostringstream text;
        text<< name << ' ' << value << ": valid range " << range;
        throw std::invalid_argument(text.str());
    }
}


//- A number of values that no vector of a loop over them is part of: the
//  kernels take that many, since the last few would cost as much one by one
int wholeVectors(int n)
{
    return (n + 7) & ~7;
}


//- The n cubics between n + 1 knots from x on, spacing[i + 1] that of the
//  cubic i, from heights and second derivatives; work holds 5 n, and there are
//  eight knots more behind
void makeIntervals
(
    int n,
    double x,
    const double* spacing,
    const double* height,
    const double* moment,
    double* work,
    interval* out
)
{
    const int room = wholeVectors(n);
    double* c1 = work;
    double* c3 = work + room;
    double* top = work + 2*room;
    double* steep = work + 3*room;
    double* crest = work + 4*room;
    impact::splineShapes
    (
        room, spacing, height, moment, c1, c3, top, steep, crest
    );
    for (int i = 0; i < n; ++i)
    {
        interval& s = out[i];
        s.x0 = x;
        x += spacing[i + 1];
        s.x1 = x;
        s.c0 = height[i];
        s.c1 = c1[i];
        s.c2 = 0.5*moment[i];
        s.c3 = c3[i];
        s.top = top[i];
        s.steep = steep[i];
        s.crest = crest[i];
    }
}

} // End anonymous namespace


impact::relief impact::relief::rough
(
    double meanSpacing,
    double sigmaSpacing,
    double sigmaHeight
)
{
    require
    (
        meanSpacing > 0 && meanSpacing < 1e100,
        "meanSpacing", meanSpacing, "(0, inf)"
    );
    require
    (
        sigmaSpacing >= 0 && 3*sigmaSpacing < meanSpacing,
        "sigmaSpacing", sigmaSpacing,
        "[0, meanSpacing/3): the knots would run backwards"
    );
    require
    (
        sigmaHeight >= 0 && sigmaHeight < 1e100,
        "sigmaHeight", sigmaHeight, "[0, inf)"
    );
    relief r;
    r.type_ = reliefType::rough;
    r.meanSpacing_ = meanSpacing;
    r.sigmaSpacing_ = sigmaSpacing;
    r.sigmaHeight_ = sigmaHeight;

    // A cubic spline overshoots its knots by up to 55 % on equal spacing
    // (its Lebesgue constant is 1.55)
    r.top_ = 1.6*3*sigmaHeight;
    return r;
}


void impact::relief::setPeriodic
(
    const std::vector<double>& x,
    const std::vector<double>& y,
    double period
)
{
    // Natural splines over a range that goes round: three periods at least
    // and enough knots for the ends to be forgotten
    const int n = int(x.size());
    const int turns = 1 + (2*reliefPiece::guard + n - 1)/n;
    const int lead = ((turns + 1)/2)*n;
    const int total = 2*lead + n + 1;
    std::vector<double> h(total), Y(total), M(total), work(5*total);
    for (int i = 0; i < total; ++i)
    {
        const int k = i % n;
        Y[i] = y[k];
        h[i] = k == 0 ? x[0] + period - x[n - 1] : x[k] - x[k - 1];
    }
    splineMoments(total, h.data(), Y.data(), M.data(), work.data());

    type_ = reliefType::periodic;
    period_ = period;
    top_ = -1e300;
    table_.resize(n);
    work.resize(5*wholeVectors(n));
    makeIntervals
    (
        n, 0, h.data() + lead, Y.data() + lead, M.data() + lead,
        work.data(), table_.data()
    );
    table_[n - 1].x1 = period;
    for (const interval& s : table_)
    {
        top_ = std::max(top_, s.top);
    }
}


impact::relief impact::relief::profile
(
    std::vector<double> x,
    std::vector<double> y
)
{
    if (x.size() < 4 || x.size() != y.size())
    {
        throw std::invalid_argument
        (
            "a profile needs at least 4 points (x, y), it has "
          + std::to_string(x.size())
        );
    }
    const std::size_t n = x.size();
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
        if (!std::isfinite(x[i]) || !std::isfinite(y[i]))
        {
            throw std::invalid_argument
            (
                "point " + std::to_string(i + 1)
              + " of the profile is not finite"
            );
        }
        if (i > 0 && !(x[i] > x[i - 1]))
        {
            throw std::invalid_argument
            (
                "point " + std::to_string(i + 1) + " of the profile is not"
                " beyond the one before: x must increase"
            );
        }
        sx += x[i] - x[0];
        sy += y[i];
        sxx += (x[i] - x[0])*(x[i] - x[0]);
        sxy += (x[i] - x[0])*y[i];
    }
    const double slope = (n*sxy - sx*sy)/(n*sxx - sx*sx);
    const double mean = (sy - slope*sx)/n;
    const double origin = x[0];
    for (std::size_t i = 0; i < n; ++i)
    {
        x[i] -= origin;
        y[i] -= mean + slope*x[i];
    }
    relief r;
    r.setPeriodic(x, y, x[n - 1] + x[n - 1]/(n - 1));
    return r;
}


impact::relief impact::relief::profile
(
    const std::string& fileName,
    double scale
)
{
    require(scale > 0 && scale < 1e100, "profile scale", scale, "(0, inf)");
    std::ifstream file(fileName);
    if (!file)
    {
        throw std::invalid_argument
        (
            "profile file \"" + fileName + "\" cannot be read"
        );
    }
    std::vector<double> x, y;
    int number = 0;
    for (std::string line; std::getline(file, line);)
    {
        ++number;
        line = line.substr(0, line.find('#'));
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream words(line);
        double a, b;
        std::string rest;
        if (words >> a >> b && !(words >> rest))
        {
            x.push_back(scale*a);
            y.push_back(scale*b);
        }
        else if (line.find_first_not_of(" \t\r") != std::string::npos)
        {
            throw std::invalid_argument
            (
                "profile file \"" + fileName + "\", line "
              + std::to_string(number) + ": two numbers x y expected"
            );
        }
    }
    try
    {
        return profile(x, y);
    }
    catch (const std::invalid_argument& error)
    {
        throw std::invalid_argument
        (
            "profile file \"" + fileName + "\": " + error.what()
        );
    }
}


impact::relief impact::relief::sinusoidal
(
    double amplitude,
    double wavelength
)
{
    require
    (
        amplitude >= 0 && amplitude < 1e100,
        "amplitude", amplitude, "[0, inf)"
    );
    require
    (
        wavelength > 0 && wavelength < 1e100,
        "wavelength", wavelength, "(0, inf)"
    );
    const int n = 64;
    std::vector<double> x(n), y(n);
    for (int i = 0; i < n; ++i)
    {
        double s, c;
        sinCosTurns(double(i)/n, s, c);
        x[i] = wavelength*i/n;
        y[i] = amplitude*s;
    }
    relief r;
    r.setPeriodic(x, y, wavelength);
    return r;
}


impact::relief impact::relief::flat(double period)
{
    require(period > 0 && period < 1e100, "period", period, "(0, inf)");
    relief r;
    r.period_ = period;
    r.table_ = {interval{0, period, 0, 0, 0, 0, 0, 0, 0}};
    return r;
}


void impact::relief::setScaled(const relief& other, double scale)
{
    *this = other;
    meanSpacing_ *= scale;
    sigmaSpacing_ *= scale;
    sigmaHeight_ *= scale;
    period_ *= scale;
    top_ *= scale;
    for (interval& s : table_)
    {
        s.x0 *= scale;
        s.x1 *= scale;
        s.c0 *= scale;
        s.c2 /= scale;
        s.c3 /= scale*scale;
        s.top *= scale;
        s.crest /= scale;
    }
}


impact::reliefPiece::reliefPiece
(
    const relief& r,
    std::uint64_t seed,
    int guardKnots
)
:
    relief_(&r),
    seed_(seed),
    guard_(guardKnots)
{
    start(0, 1);
}


void impact::reliefPiece::start(std::uint64_t identity, int n)
{
    identity_ = identity;
    first_ = last_ = 0;
    xFirst_ = xLast_ = 0;
    generate(0, n, false);
}


void impact::reliefPiece::generate
(
    std::int64_t from,
    std::int64_t to,
    bool front
)
{
    const int n = int(to - from);
    const std::size_t old = last_ - first_;
    if (front)
    {
        intervals_.insert(intervals_.begin(), n, interval());
        first_ = from;
    }
    else
    {
        intervals_.resize(old + n);
        last_ = to;
    }
    interval* out = &intervals_[from - first_];

    if (relief_->type() == relief::reliefType::periodic)
    {
        const auto& table = relief_->table();
        const std::int64_t size = std::int64_t(table.size());
        for (int i = 0; i < n; ++i)
        {
            const std::int64_t k = from + i;
            const std::int64_t turn =
                k >= 0 ? k/size : -((size - 1 - k)/size);
            const double shift = double(turn)*relief_->period();
            out[i] = table[k - turn*size];
            out[i].x0 += shift;
            out[i].x1 += shift;
        }
        return;
    }

    const int knots = n + 1 + 2*guard_;
    const std::size_t room = wholeVectors(knots);
    if (spacing_.size() < room)
    {
        spacing_.resize(room);
        height_.resize(room);
        moment_.resize(room);
        work_.resize(5*room);
    }
    drawKnots
    (
        seed_, identity_, from - guard_, int(room),
        relief_->meanSpacing(), relief_->sigmaSpacing(),
        relief_->sigmaHeight(), spacing_.data(), height_.data()
    );
    splineMoments
    (
        knots, spacing_.data(), height_.data(), moment_.data(), work_.data()
    );
    double x = xLast_;
    if (front)
    {
        for (int i = 0; i < n; ++i)
        {
            xFirst_ -= spacing_[guard_ + n - i];
        }
        x = xFirst_;
    }
    makeIntervals
    (
        n, x, spacing_.data() + guard_, height_.data() + guard_,
        moment_.data() + guard_, work_.data(), out
    );
    if (front && std::size_t(n) < intervals_.size())
    {
        out[n - 1].x1 = out[n].x0;      // not a round-off apart
    }
    if (!front)
    {
        xLast_ = out[n - 1].x1;
    }
}


void impact::reliefPiece::grow(std::int64_t i)
{
    const std::int64_t chunk = 16;
    if (i < first_)
    {
        generate(std::min(i, first_ - chunk), first_, true);
    }
    else if (i >= last_)
    {
        generate(last_, std::max(i + 1, last_ + chunk), false);
    }
}


double impact::reliefPiece::firstReach
(
    double x,
    double y,
    double Vx,
    double Vy,
    double deep,
    double wide,
    double t,
    std::int64_t& hint,
    bool& lost
)
{
    const double infinite = std::numeric_limits<double>::infinity();
    const double bottom = y - deep;
    const double top = relief_->top();

    // Above everything: straight down to the highest top there may be
    double start = t;
    if (bottom + Vy*t > top)
    {
        if (Vy >= 0)
        {
            return infinite;
        }
        start = t + (top - bottom - Vy*t)/Vy;
    }
    const double xs = x + Vx*start;
    const int step = Vx < 0 ? -1 : 1;
    const double perX = Vx != 0 ? 1/Vx : 0;
    const double perY = Vy != 0 ? 1/Vy : 0;
    std::int64_t n = find(Vx < 0 ? xs + wide : xs - wide, hint);
    hint = n;
    double found = infinite;
    int count = 0;
    if (Vx > 0 && Vy < 0)
    {
        // On the way down most intervals are left above their tops
        while
        (
            count <= 10000000
         && bottom + Vy*((at(n).x1 + wide - x)*perX) > at(n).top
        )
        {
            ++n;
            ++count;
        }
    }
    for (; ; ++count, n += step)
    {
        const relief::interval& s = at(n);

        // The rectangle is over this interval from 'enter' to 'leave'
        double enter = start;
        double leave = infinite;
        if (Vx > 0)
        {
            enter = std::max(start, (s.x0 - wide - x)*perX);
            leave = (s.x1 + wide - x)*perX;
        }
        else if (Vx < 0)
        {
            enter = std::max(start, (s.x1 + wide - x)*perX);
            leave = (s.x0 - wide - x)*perX;
        }
        else if (s.x0 > xs + wide)
        {
            break;
        }
        if (enter >= found)
        {
            break;
        }
        const double room = bottom + Vy*enter - s.top;
        if (room <= 0)
        {
            found = std::min(found, enter);
        }
        else if (Vy < 0)
        {
            const double reach = enter - room*perY;
            if (reach <= leave)
            {
                found = std::min(found, reach);
            }
        }
        if (Vy >= 0 && bottom + Vy*enter > top)
        {
            break;
        }
        if (count > 10000000)
        {
            lost = true;
            break;
        }
    }
    // Round-off must not carry past
    return found == infinite ? found
        : std::max(t, found - 1e-12*(found - t));
}


double impact::reliefPiece::height(double x, std::int64_t guess)
{
    const interval& s = at(find(x, guess));
    const double u = x - s.x0;
    return s.c0 + u*(s.c1 + u*(s.c2 + u*s.c3));
}
