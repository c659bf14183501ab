/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "relief.H"
#include "elementary.H"
#include "outOfRange.H"
#include "philoxLanes.H"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace
{

typedef impact::relief::interval interval;

//- A number of values that no vector of a loop over them is part of: the
//  kernels take that many, since the last few would cost as much one by one
int wholeVectors(int n)
{
    return (n + 7) & ~7;
}


//- The first n of whole vectors of cubics between knots
void makeIntervals
(
    int n,
    const double* x,
    const double* y,
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
    impact::splineShapes(room, x, y, moment, c1, c3, top, steep, crest);
    for (int i = 0; i < n; ++i)
    {
        out[i] =
        {
            x[i], x[i + 1], y[i], c1[i], 0.5*moment[i], c3[i],
            top[i], steep[i], crest[i]
        };
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
    checkRange("meanSpacing", meanSpacing, "(0, 1e100) m");
    checkRange
    (
        sigmaSpacing >= 0 && 3*sigmaSpacing < meanSpacing,
        "sigmaSpacing", sigmaSpacing,
        "[0, meanSpacing/3): the knots would run backwards"
    );
    checkRange("sigmaHeight", sigmaHeight, "[0, 1e100) m");
    relief r;
    r.type_ = reliefType::rough;
    r.meanSpacing_ = meanSpacing;
    r.sigmaSpacing_ = sigmaSpacing;
    r.sigmaHeight_ = sigmaHeight;

    // A cubic spline overshoots its knots by up to 55 % on equal spacing (its
    // Lebesgue constant is 1.55); more between knots that may come close. The
    // highest of 1e7 intervals is 1.62, 2.07, 3.8, 8.4 and 185 times the
    // highest knot at deviations of 0.2, 0.25, 0.3, 0.32 and 0.333 of the mean
    const double closest = 1 - 3*sigmaSpacing/meanSpacing;
    r.top_ = std::max(1.6, 1 + 0.3/closest)*3*sigmaHeight;
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
    std::vector<interval> table(n);
    const int room = wholeVectors(n);
    std::vector<double> X(room + 1, 0);
    for (int i = 0; i < room; ++i)
    {
        X[i + 1] = X[i] + h[lead + i + 1];
    }
    work.resize(5*room);
    makeIntervals
    (
        n, X.data(), Y.data() + lead, M.data() + lead,
        work.data(), table.data()
    );
    table[n - 1].x1 = period;
    for (const interval& s : table)
    {
        top_ = std::max(top_, s.top);
    }
    table_ = std::make_shared<const std::vector<interval>>(std::move(table));
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
    checkRange("profile scale", scale, "(0, 1e100)");
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
    checkRange("amplitude", amplitude, "[0, 1e100) m");
    checkRange("wavelength", wavelength, "(0, 1e100) m");
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
    checkRange("period", period, "(0, 1e100) m");
    relief r;
    r.period_ = period;
    r.table_ = std::make_shared<const std::vector<interval>>
    (
        1, interval{0, period, 0, 0, 0, 0, 0, 0, 0}
    );
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
    scale_ *= scale;
}


impact::relief::interval impact::relief::at(std::int64_t i) const
{
    const std::int64_t size = std::int64_t(table_->size());
    const std::int64_t turn = i >= 0 ? i/size : -((size - 1 - i)/size);
    const double shift = double(turn)*period_;
    interval s = (*table_)[i - turn*size];
    s.x0 = scale_*s.x0 + shift;
    s.x1 = scale_*s.x1 + shift;
    s.c0 *= scale_;
    s.c2 /= scale_;
    s.c3 /= scale_*scale_;
    s.top *= scale_;
    s.crest /= scale_;
    return s;
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
    guard_(guardKnots + (guardKnots & 1))
{
    start(0, 1);
}


void impact::reliefPiece::start(std::uint64_t identity, int n)
{
    identity_ = identity;
    first_ = last_ = 0;
    generate(0, std::max(n, atOnce), false);
}


void impact::reliefPiece::generate
(
    std::int64_t from,
    std::int64_t to,
    bool front
)
{
    const bool random = relief_->type() == relief::reliefType::rough;
    const bool grown = random && last_ > first_;

    // The slope where it meets what is there already. The interval there is
    // shaped before it gets another neighbour
    double slope = 0;
    if (grown)
    {
        const relief::interval& s = at(front ? first_ : last_ - 1);
        const double h = s.x1 - s.x0;
        slope = front ? s.c1 : s.c1 + h*(2*s.c2 + 3*h*s.c3);
    }

    // All the knots that are drawn are used, but for one that would leave an
    // odd number
    const int before = grown && !front ? 0 : guard_;
    const int after = grown && front ? 0 : guard_;
    const int more = before + after + 2;
    const int room =
        (int(to - from) + more + drawnAtOnce - 1)/drawnAtOnce*drawnAtOnce;
    const int n = room - more;
    (front ? from : to) = front ? to - n : from + n;
    const std::size_t old = last_ - first_;
    first_ = front ? from : first_;
    last_ = front ? last_ : to;
    for (auto* column : {&x_, &y_, &moment_, &ceiling_})
    {
        if (front)
        {
            column->insert(column->begin(), n, 0);
        }
        else
        {
            column->resize(old + n + 1);
        }
    }
    if (front)
    {
        intervals_.insert(intervals_.begin(), n, interval());
    }
    else
    {
        intervals_.resize(old + n);
    }
    for (int i = 0; i < n; ++i)
    {
        intervals_[from - first_ + i].steep = -1;
    }

    const std::size_t at = from - first_;
    if (!random)
    {
        for (int i = 0; i < n; ++i)
        {
            const relief::interval s = relief_->at(from + i);
            x_[at + i] = s.x0;
            ceiling_[at + i] = s.top;
            if (!front)
            {
                x_[at + i + 1] = s.x1;
            }
        }
        return;
    }

    // Room for a knot before, too
    const std::size_t column = room + lead;
    if (drawn_.size() < 3*column)
    {
        drawn_.resize(3*column);
        work_.resize(5*column);
    }
    double* spacing = drawn_.data() + lead;
    double* height = spacing + column;
    double* moment = height + column;
    drawKnots
    (
        seed_, identity_, from - before, room,
        relief_->meanSpacing(), relief_->sigmaSpacing(),
        relief_->sigmaHeight(), spacing, height
    );
    const int begin = before == 0 ? -1 : 0;
    const int end = after == 0 ? before + n + 1 : room - 2;
    if (grown)
    {
        spacing[front ? end : 0] = 0;
        height[front ? end : -1] = slope;
    }
    splineMoments
    (
        end - begin + 1, spacing + begin, height + begin, moment + begin,
        work_.data()
    );
    spacing += before;
    height += before;
    moment += before;
    splineCeilings(n, spacing, height, moment, &ceiling_[at]);
    std::copy_n(height, n + 1, y_.begin() + at);
    std::copy_n(moment, n + 1, moment_.begin() + at);
    if (front)
    {
        for (int i = n - 1; i >= 0; --i)
        {
            x_[i] = x_[i + 1] - spacing[i + 1];
        }
    }
    else
    {
        // Two at once: half the sums that wait for one before. n is even
        double* x = &x_[at];
        x[0] = grown ? x[0] : 0;
        for (int i = 2; i <= n; i += 2)
        {
            x[i - 1] = x[i - 2] + spacing[i - 1];
            x[i] = x[i - 2] + (spacing[i - 1] + spacing[i]);
        }
    }
}


void impact::reliefPiece::grow(std::int64_t i)
{
    std::int64_t chunk = atOnce;
    if (relief_->type() == relief::reliefType::periodic)
    {
        const std::int64_t held = last_ - first_;
        const std::int64_t most =
            4*std::int64_t(relief_->table().size()) + 1024;
        if (held > most || i < first_ - held || i >= last_ + held)
        {
            // It is not drawn: no need of what is on the way
            first_ = last_ = i;
        }
        else if (i < first_)
        {
            // All the others move
            chunk = held;
        }
    }
    if (i < first_)
    {
        generate(std::min(i, first_ - chunk), first_, true);
    }
    else if (i >= last_)
    {
        generate(last_, std::max(i + 1, last_ + chunk), false);
    }
}


void impact::reliefPiece::shape(std::int64_t i)
{
    // Who is over this one often is over the one before, too
    const std::int64_t from =
        std::max(first_, std::min(i - 1, last_ - atOnce));
    const std::size_t at = from - first_;
    if (relief_->type() == relief::reliefType::periodic)
    {
        for (int k = 0; k < atOnce; ++k)
        {
            intervals_[at + k] = relief_->at(from + k);
        }
        return;
    }
    // One that is known has a neighbour that was not there then, perhaps
    double work[5*atOnce];
    relief::interval made[atOnce];
    makeIntervals(atOnce, &x_[at], &y_[at], &moment_[at], work, made);
    for (int k = 0; k < atOnce; ++k)
    {
        relief::interval& s = intervals_[at + k];
        if (s.steep < 0)
        {
            s = made[k];
        }
    }
}


double impact::reliefPiece::drawPlace
(
    std::uint64_t seed,
    std::uint64_t stream,
    int stride,
    std::int64_t& interval
)
{
    // It lies in a long interval more often than in a short one: they are
    // accepted in proportion to their length. One that is refused is a short
    // one, mostly: a body that is no longer than the stride stays clear of it
    const double longest =
        relief_->meanSpacing() + 3*relief_->sigmaSpacing();
    for (std::uint32_t attempt = 0; ; ++attempt, interval += stride)
    {
        const threeUnits p =
            threeUnits::drawn(seed, attempt, drawPurpose::position, stream);
        const double begin = knot(interval);
        const double length = knot(interval + 1) - begin;
        if (p.u0*longest < length)
        {
            return begin + p.u1*length;
        }
    }
}


double impact::reliefPiece::firstReach
(
    double x,
    double y,
    double Vx,
    double Vy,
    double R,
    double t,
    std::int64_t& hint,
    bool& lost
)
{
    const double infinite = std::numeric_limits<double>::infinity();
    const double bottom = y - R;
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
    std::int64_t n = find(Vx < 0 ? xs + R : xs - R, hint);
    hint = n;
    double found = infinite;
    int count = 0;
    if (Vx > 0 && Vy < 0)
    {
        // On the way down most intervals are left above their tops
        do
        {
            if (n >= last_)
            {
                grow(n);
            }
            const std::size_t k = n - first_;
            const int passed = intervalsPassed
            (
                int(last_ - n), &x_[k + 1], &ceiling_[k],
                bottom, Vy, perX, R - x
            );
            n += passed;
            count += passed;
        }
        while (n >= last_ && count <= 10000000);
    }
    for (; ; ++count, n += step)
    {
        const double x0 = knot(n), x1 = knot(n + 1);

        // The square is over this interval from 'enter' to 'leave'
        double enter = start;
        double leave = infinite;
        if (Vx > 0)
        {
            enter = std::max(start, (x0 - R - x)*perX);
            leave = (x1 + R - x)*perX;
        }
        else if (Vx < 0)
        {
            enter = std::max(start, (x1 + R - x)*perX);
            leave = (x0 - R - x)*perX;
        }
        else if (x0 > xs + R)
        {
            break;
        }
        if (enter >= found)
        {
            break;
        }
        const double room = bottom + Vy*enter - at(n).top;
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
