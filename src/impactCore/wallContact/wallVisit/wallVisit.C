/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "wallVisit.H"
#include "shadowKernels.H"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace
{

using namespace impact;

//- The point of least height above the relief
struct lowest
{
    double gap;
    double x;
    double slope;       // of the relief

    //- Where on the body: parameter of the lower arc of an ellipse; the
    //  share from vertex i to vertex j of a polygon
    double parameter;
    int i, j;
};


inline double heightIn(const relief::interval& s, double x)
{
    const double u = x - s.x0;
    return s.c0 + u*(s.c1 + u*(s.c2 + u*s.c3));
}

inline double slopeIn(const relief::interval& s, double x)
{
    const double u = x - s.x0;
    return s.c1 + u*(2*s.c2 + 3*u*s.c3);
}

inline double bendIn(const relief::interval& s, double x)
{
    return 2*s.c2 + 6*(x - s.x0)*s.c3;
}


//- A gap at some time, its rate, and whose it is
struct gapSample
{
    double t, gap, rate;
    int i, j;

    //- When it is zero, by Newton's method
    double zero() const
    {
        return t - gap/rate;
    }

    //- The same by the inverse cubic through another sample, if they are of
    //  one point and not far off
    double zero(const gapSample& a) const
    {
        const double h = gap - a.gap;
        const double x = -a.gap, y = gap;
        if
        (
            !(rate < 0 && a.rate < 0) || i != a.i || j != a.j || i != j
         || !(x*h > -0.5*h*h && y*h > -0.5*h*h)
        )
        {
            return zero();
        }
        const double u = x/h, v = y/h;
        return a.t + u*u*(3 - 2*u)*(t - a.t) + h*u*v*(v/a.rate - u/rate);
    }
};


//- An edge of a shadow, between two points of numbers i and j
struct straightEdge
{
    double xi, yi, xj, yj;
    int i, j;

    //- The crest of an interval, if it lies under the edge
    void offerCrest(const relief::interval& s, lowest& out) const
    {
        const double xa = std::min(xi, xj);
        const double xb = std::max(xi, xj);
        if (s.x1 <= xa || s.x0 >= xb || !(s.crest > 0))
        {
            return;
        }
        // Slope of the relief equal to m, falling
        const double m = (yj - yi)/(xj - xi);
        const double q = s.c1 - m;
        const double disc = s.c2*s.c2 - 3*s.c3*q;
        if (!(disc > 0))
        {
            return;
        }
        const double root = std::sqrt(disc);
        const double den = root - s.c2;
        double u;
        if (s.c2 <= 0 || s.c3 == 0)
        {
            if (!(den > 0))
            {
                return;
            }
            u = q/den;
        }
        else
        {
            u = (-s.c2 - root)/(3*s.c3);
        }
        const double x = s.x0 + u;
        if (!(x > std::max(xa, s.x0)) || !(x < std::min(xb, s.x1)))
        {
            return;
        }
        const double f = (x - xi)/(xj - xi);
        const double gap = yi + f*(yj - yi) - heightIn(s, x);
        if (gap < out.gap)
        {
            out.gap = gap;
            out.x = x;
            out.slope = m;
            out.i = i;
            out.j = j;
            out.parameter = f;
        }
    }
};


class polygonShadow
{
    //- Arrays of one thread
    struct scratch
    {
        std::vector<double> X, Y, gap, intervals;

        static scratch& ofThread()
        {
            static thread_local scratch s;
            return s;
        }

        void reserve(std::size_t n)
        {
            if (X.size() < n)
            {
                for (auto* list : {&X, &Y, &gap})
                {
                    list->resize(n);
                }
            }
        }
    };

    const convexBody& body_;
    scratch& w_;
    vector3 ex_, ey_, ez_;

    //- Crests under the edge from vertex i to j
    void offerCrests
    (
        int i,
        int j,
        std::int64_t first,
        std::int64_t last,
        reliefPiece& piece,
        lowest& out
    ) const
    {
        const straightEdge e = {w_.X[i], w_.Y[i], w_.X[j], w_.Y[j], i, j};
        for (std::int64_t l = first; l <= last; ++l)
        {
            e.offerCrest(piece.at(l), out);
        }
    }


public:

    explicit polygonShadow(const convexBody& body)
    :
        body_(body),
        w_(scratch::ofThread())
    {
        w_.reserve(body.paddedVertices().size()/3);
    }

    //- Orientation of the body
    void turn(const rotationState& r)
    {
        ex_ = r.ex;
        ey_ = r.ey;
        ez_ = r.ez();
    }

    //- The lowest point with the centre at (x, y)
    lowest find
    (
        double x,
        double y,
        reliefPiece& piece,
        std::int64_t hint
    ) const
    {
        const auto& padded = body_.paddedVertices();
        const auto& normals = body_.faceNormals();
        const int n = int(body_.vertices().size());
        const int room = int(padded.size())/3;
        scratch& w = w_;
        double* X = w.X.data();
        double* Y = w.Y.data();
        double* G = w.gap.data();

        // The intervals under the circumscribed circle
        const double R = body_.radius();
        const std::int64_t first = piece.find(x - R, hint);
        const std::int64_t last = piece.find(x + R, first);
        double crest = 0;
        const std::size_t needed = 5*std::size_t(last - first + 1);
        if (w.intervals.size() < needed)
        {
            w.intervals.resize(needed);
        }
        double* copy = w.intervals.data();
        for (std::int64_t k = first; k <= last; ++k, copy += 5)
        {
            const relief::interval& s = piece.at(k);
            crest = std::max(crest, s.crest);
            copy[0] = s.x0;
            copy[1] = s.c0;
            copy[2] = s.c1;
            copy[3] = s.c2;
            copy[4] = s.c3;
        }
        const double pose[8] =
            {x, y, ex_.x, ex_.y, ex_.z, ey_.x, ey_.y, ey_.z};
        shadowGaps
        (
            room, padded.data(), pose, int(last - first + 1),
            w.intervals.data(), X, Y, G
        );
        // The first of the lowest; what pads the list repeats a vertex of it
        const double least = smallest(room, G);
        int best = 0;
        while (best < n - 1 && G[best] != least)
        {
            ++best;
        }
        std::int64_t under = first;
        while (under < last && X[best] >= piece.at(under).x1)
        {
            ++under;
        }

        lowest out;
        out.gap = G[best];
        out.x = X[best];
        out.slope = slopeIn(piece.at(under), X[best]);
        out.i = out.j = best;
        out.parameter = 0;

        // A crest may reach the inside of an edge: no deeper below the lower
        // of its ends than the sag of the sharpest crest over its length
        const double sag = 0.125*crest;
        const double near = crest > 0
          ? least + sag*body_.longestEdge()*body_.longestEdge() : -1e300;
        for (int i = 0; i < n; ++i)
        {
            if (!(G[i] < near))
            {
                continue;
            }
            const convexBody::spoke* end = body_.endSpokes(i);
            for (auto* e = body_.beginSpokes(i); e != end; ++e)
            {
                const int j = e->vertex;
                const double dx = X[j] - X[i];

                // From its lower end; an edge bounds the shadow if one of its
                // faces looks up along Z and the other down.
                // The gap along it stays above the parabola of the bend
                // -8 sag through both ends, whose least value is
                // G_i - (bow - rise)^2/(4 bow) if it lies between them
                const double rise = G[j] - G[i];
                const double bow = 4*sag*dx*dx;
                if
                (
                    rise < 0 || (rise == 0 && j < i) || rise >= bow
                 || 4*bow*(G[i] - out.gap) >= (bow - rise)*(bow - rise)
                 || dot(ez_, normals[e->faces[0]])
                   *dot(ez_, normals[e->faces[1]]) > 0
                )
                {
                    continue;
                }
                offerCrests(i, j, first, last, piece, out);
            }
        }
        return out;
    }

    //- The material point, body components
    vector3 point(const lowest& l) const
    {
        const auto& v = body_.vertices();
        return v[l.i] + l.parameter*(v[l.j] - v[l.i]);
    }

    //- The same for a contact: several vertices over one point of the curve
    //  are an edge across the relief, which touches it along its length;
    //  its centre is the contact. Valid after the find() of l.
    vector3 contactPoint(const lowest& l) const
    {
        const auto& v = body_.vertices();
        const double near = 1e-9*body_.radius();
        vector3 sum = {0, 0, 0};
        int count = 0;
        for (int i = 0; l.i == l.j && i < int(v.size()); ++i)
        {
            if
            (
                std::fabs(w_.X[i] - l.x) < near
             && std::fabs(w_.gap[i] - l.gap) < near
            )
            {
                sum = sum + v[i];
                ++count;
            }
        }
        return count > 1 ? (1./count)*sum : point(l);
    }
};


//- The shadow of a box is a sum of three segments: its lower boundary is those
//  segments one after the other by rising slope, from corner 0 to corner 3
class boxShadow
{
    const convexBody& body_;

    //- Half of each segment, towards x, by axis of the box; the half side that
    //  it is the shadow of
    double gx_[3], gy_[3], side_[3];

    //- Axes of the segments by rising slope
    const int* order_ = nullptr;

    //- Corners from the centre
    double x_[4], y_[4];


public:

    explicit boxShadow(const convexBody& body)
    :
        body_(body)
    {}

    //- Orientation of the body
    void turn(const rotationState& r)
    {
        const vector3& half = body_.semiAxes();
        const double ex[3] = {r.ex.x, r.ex.y, r.ex.z};
        const double ey[3] = {r.ey.x, r.ey.y, r.ey.z};
        const double sides[3] = {half.x, half.y, half.z};
        for (int k = 0; k < 3; ++k)
        {
            side_[k] = std::copysign(sides[k], ex[k]);
            gx_[k] = side_[k]*ex[k];
            gy_[k] = side_[k]*ey[k];
        }

        // From the three comparisons of two: which is steeper cannot be
        // foreseen, and branches would often be guessed wrongly. Two of the
        // cases are round-off
        static constexpr int orders[8][3] =
        {
            {0, 1, 2}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0},
            {0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}
        };
        auto steeper = [&](int a, int b)
        {
            return int(gy_[a]*gx_[b] > gy_[b]*gx_[a]);
        };
        order_ = orders
            [steeper(0, 1) + 2*steeper(1, 2) + 4*steeper(0, 2)];
        const int least = order_[0], most = order_[2];
        x_[3] = gx_[0] + gx_[1] + gx_[2];
        y_[3] = gy_[0] + gy_[1] + gy_[2];
        x_[0] = -x_[3];
        y_[0] = -y_[3];
        x_[1] = x_[0] + 2*gx_[least];
        y_[1] = y_[0] + 2*gy_[least];
        x_[2] = x_[3] - 2*gx_[most];
        y_[2] = y_[3] - 2*gy_[most];
    }

    //- The lowest point with the centre at (x, y)
    lowest find
    (
        double x,
        double y,
        reliefPiece& piece,
        std::int64_t hint
    ) const
    {
        std::int64_t n = piece.find(x + x_[0], hint);
        const relief::interval* s = &piece.at(n);

        // Second derivative of the relief under the corners, and the least
        // of it since the last one: it is linear between knots
        double gap[4], bend[4], least[4];
        std::int64_t interval[4];
        for (int i = 0; i < 4; ++i)
        {
            const double at = x + x_[i];
            double knot = 0;
            while (at >= s->x1)
            {
                s = &piece.at(++n);
                knot = std::min(knot, 2*s->c2);
            }
            interval[i] = n;
            bend[i] = bendIn(*s, at);
            least[i] = std::min(knot, bend[i]);
            gap[i] = y + y_[i] - heightIn(*s, at);
        }

        // Which is the lowest cannot be foreseen: no branches
        const int a = gap[1] < gap[0];
        const int b = 2 + (gap[3] < gap[2]);
        const int best = a + (b - a)*(gap[b] < gap[a]);
        lowest out;
        out.gap = gap[best];
        out.x = x + x_[best];
        out.slope = slopeIn(piece.at(interval[best]), out.x);
        out.i = out.j = best;
        out.parameter = 0;

        // A crest may reach the inside of an edge: see polygonShadow
        for (int i = 0; i < 3; ++i)
        {
            const double crest = -std::min(bend[i], least[i + 1]);
            const double dx = x_[i + 1] - x_[i];
            const double bow = 0.5*crest*dx*dx;
            const double low = std::min(gap[i], gap[i + 1]);
            const double rise = std::fabs(gap[i + 1] - gap[i]);
            const double rest = bow - rise;
            const bool reaches =
                (rest > 0) & (4*bow*(low - out.gap) < rest*rest);
            if (!reaches)
            {
                continue;
            }
            const straightEdge e =
            {
                x + x_[i], y + y_[i], x + x_[i + 1], y + y_[i + 1], i, i + 1
            };
            for (std::int64_t k = interval[i]; k <= interval[i + 1]; ++k)
            {
                e.offerCrest(piece.at(k), out);
            }
        }
        return out;
    }

    //- The material point, body components
    vector3 point(const lowest& l) const
    {
        vector3 r;
        for (int k = 0; k < 3; ++k)
        {
            const double share =
                k < l.i ? 1 : k < l.j ? 2*l.parameter - 1 : -1;
            r[order_[k]] = share*side_[order_[k]];
        }
        return r;
    }

    //- The same for a contact: see polygonShadow
    vector3 contactPoint(const lowest& l) const
    {
        const double near = 0.5e-9*body_.radius();
        vector3 r = point(l);
        for (int k = 0; l.i == l.j && k < 3; ++k)
        {
            if (gx_[k] < near && std::fabs(gy_[k] - l.slope*gx_[k]) < near)
            {
                r[k] = 0;
            }
        }
        return r;
    }
};


class ellipseShadow
{
    //- y = cy + k xi w - d sqrt(1 - xi^2), x = cx + w xi; in the variable
    //  p = xi/sqrt(1 - xi^2) the lower arc has the slope k + (d/w) p
    const convexBody& body_;
    rotationState rotation_;
    double w_ = 0, k_ = 0, d_ = 0;
    double depth_ = 0;          // of the lowest point below the centre

    //- Centre of the shadow being looked at
    mutable double cx_ = 0, cy_ = 0;

    double xOf(double p) const
    {
        return cx_ + w_*p/std::sqrt(1 + p*p);
    }

    //- Sign of the slope of the gap, and its derivative
    double excess(const relief::interval& s, double p, double& rate) const
    {
        const double q = 1/std::sqrt(1 + p*p);
        const double x = cx_ + w_*p*q;
        const double f = w_/d_;
        rate = 1 - bendIn(s, x)*f*w_*q*q*q;
        return p - (slopeIn(s, x) - k_)*f;
    }

    double gapAt(const relief::interval& s, double p) const
    {
        const double q = 1/std::sqrt(1 + p*p);
        const double xi = p*q;
        return cy_ + k_*w_*xi - d_*q - heightIn(s, cx_ + w_*xi);
    }

    //- Root of the excess, which rises from lo to hi
    double rising(const relief::interval& s, double lo, double hi) const
    {
        // From where the slope at the middle of the arc would meet it
        const double f = w_/d_;
        const double middle = std::max(s.x0, std::min(s.x1, cx_));
        double p = std::max
        (
            lo,
            std::min(hi, (slopeIn(s, middle) - k_)*f)
        );
        for (int i = 0; i < 100; ++i)
        {
            double rate;
            const double e = excess(s, p, rate);
            (e > 0 ? hi : lo) = p;
            if (rate > 0)
            {
                // An error of p left here comes back squared
                const double step = e/rate;
                if (std::fabs(step) <= 1e-5*(1 + std::fabs(p)))
                {
                    return p - step;
                }
                p -= step;
                if (p > lo && p < hi)
                {
                    continue;
                }
            }
            p = 0.5*(lo + hi);
        }
        return p;
    }


public:

    explicit ellipseShadow(const convexBody& body)
    :
        body_(body)
    {}

    //- Orientation of the body
    void turn(const rotationState& r)
    {
        rotation_ = r;
        const vector3 X = multiply(body_.semiAxes(), r.ex);
        const vector3 Y = multiply(body_.semiAxes(), r.ey);
        const double Qxx = dot(X, X);
        w_ = std::sqrt(Qxx);
        k_ = dot(X, Y)/Qxx;
        d_ = mag(cross(X, Y))/w_;
        depth_ = mag(Y);
    }

    //- The lowest point with the centre at (x, y)
    lowest find
    (
        double x,
        double y,
        reliefPiece& piece,
        std::int64_t hint
    ) const
    {
        cx_ = x;
        cy_ = y;
        const ellipseShadow& e = *this;
        const double bottom = y - depth_;
        const double left = x - w_;
        const double right = x + w_;
        const double endless = 1e8;

        lowest out;
        out.gap = 1e300;
        double bestP = 0;
        std::int64_t best = 0;
        auto offer = [&](std::int64_t n, const relief::interval& s, double P)
        {
            const double g = e.gapAt(s, P);
            if (g < out.gap)
            {
                out.gap = g;
                bestP = P;
                best = n;
            }
        };

        for
        (
            std::int64_t n = piece.find(left, hint);
            piece.at(n).x0 < right;
            ++n
        )
        {
            const relief::interval& s = piece.at(n);
            if (bottom - s.top >= out.gap)
            {
                continue;
            }
            // The part of the arc over this interval
            auto pOf = [&](double x)
            {
                const double xi = (x - e.cx_)/e.w_;
                const double rest = 1 - xi*xi;
                return rest > 1e-16
                  ? xi/std::sqrt(rest) : (xi > 0 ? endless : -endless);
            };
            const bool cutLo = s.x0 > left;
            const bool cutHi = s.x1 < right;
            const double lo = cutLo ? pOf(s.x0) : -endless;
            const double hi = cutHi ? pOf(s.x1) : endless;
            const double f = e.w_/e.d_;
            const double eLo = cutLo ? lo - (s.c1 - e.k_)*f : -1;
            const double eHi =
                cutHi ? hi - (slopeIn(s, s.x1) - e.k_)*f : 1;

            // Does the excess rise throughout? Its rate is 1 - bend/bend of
            // the arc; the arc is flattest where p is nearest to 0
            const double flat =
                lo > 0 ? lo : hi < 0 ? hi : 0;
            const double bend = std::max
            (
                bendIn(s, std::max(s.x0, left)),
                bendIn(s, std::min(s.x1, right))
            );
            const double q2 = flat == 0 ? 1 : 1/(1 + flat*flat);
            if (bend*e.w_*f*q2*(flat == 0 ? 1 : std::sqrt(q2)) < 1)
            {
                offer
                (
                    n, s,
                    eLo >= 0 ? lo : eHi <= 0 ? hi : e.rising(s, lo, hi)
                );
                continue;
            }

            // A pit sharper than the arc. The bend of the arc less that of
            // the relief is a convex function of x: it has at most two
            // zeros, the excess rises, falls, rises, and its leftmost and
            // rightmost roots are the two minima of the gap
            double peak = lo, trough = hi;
            double rateLo, rateHi;
            e.excess(s, lo, rateLo);
            e.excess(s, hi, rateHi);
            turningPoints(e, s, lo, hi, rateLo, rateHi, peak, trough);
            double r;
            if (eLo >= 0)
            {
                offer(n, s, lo);
            }
            else if (e.excess(s, peak, r) >= 0)
            {
                offer(n, s, e.rising(s, lo, peak));
            }
            if (eHi <= 0)
            {
                offer(n, s, hi);
            }
            else if (e.excess(s, trough, r) <= 0)
            {
                offer(n, s, e.rising(s, trough, hi));
            }
        }

        out.x = e.xOf(bestP);
        out.slope = slopeIn(piece.at(best), out.x);
        out.parameter = bestP;
        out.i = out.j = 0;
        return out;
    }

    //- The material point, body components: the support along (slope, -1),
    //  the outward normal of the arc there
    vector3 point(const lowest& l) const
    {
        const vector3& a = body_.semiAxes();
        const double m = k_ + d_/w_*l.parameter;
        const vector3 n = multiply(a, m*rotation_.ex - rotation_.ey);
        return (1/mag(n))*multiply(a, n);
    }

    vector3 contactPoint(const lowest& l) const
    {
        return point(l);
    }


private:

    //- Ends of the first and of the last part on which the excess rises
    static void turningPoints
    (
        const ellipseShadow& e,
        const relief::interval& s,
        double lo,
        double hi,
        double rateLo,
        double rateHi,
        double& peak,
        double& trough
    )
    {
        // Least value of U(x) = bend of the arc - bend of the relief by
        // golden section in p (U is convex in x, so it has one minimum in p)
        auto U = [&](double p)
        {
            const double c = 1 + p*p;
            return e.d_/(e.w_*e.w_)*c*std::sqrt(c) - bendIn(s, e.xOf(p));
        };
        double a = std::max(lo, -1e3), b = std::min(hi, 1e3);
        const double golden = 0.6180339887498949;
        double x1 = b - golden*(b - a), x2 = a + golden*(b - a);
        double u1 = U(x1), u2 = U(x2);
        for (int i = 0; i < 40 && u1 > 0 && u2 > 0; ++i)
        {
            if (u1 < u2)
            {
                b = x2;
                x2 = x1;
                u2 = u1;
                x1 = b - golden*(b - a);
                u1 = U(x1);
            }
            else
            {
                a = x1;
                x1 = x2;
                u1 = u2;
                x2 = a + golden*(b - a);
                u2 = U(x2);
            }
        }
        const double low = u1 < u2 ? x1 : x2;
        auto zero = [&](double inside, double outside)
        {
            for (int i = 0; i < 60; ++i)
            {
                const double mid = 0.5*(inside + outside);
                (U(mid) > 0 ? outside : inside) = mid;
            }
            return outside;
        };
        const bool dips = U(low) <= 0;
        peak = rateLo <= 0 ? lo : dips ? zero(low, lo) : low;
        trough = rateHi <= 0 ? hi : dips ? zero(low, hi) : low;
    }
};

//- An ellipsoid of revolution over a flat wall: how deep it reaches depends on
//  the height of the end of its axis alone, a harmonic oscillation
class flatSpheroid
{
    const convexBody& body_;
    int axis_;
    double across2_, extra2_;       // semi-axes squared: across, along - across
    double y_ = 0, Vy_ = 0;
    freeRotation::oscillation end_ = {};

public:

    //- Does it describe these?
    static bool holds(const convexBody& body, const relief& wall)
    {
        return
            wall.isFlat() && body.symmetryAxis() >= 0
         && body.shape() == convexBody::shapeType::ellipsoid;
    }

    explicit flatSpheroid(const convexBody& body)
    :
        body_(body),
        axis_(body.symmetryAxis() % 3)
    {
        const vector3& a = body.semiAxes();
        const double across = a[(axis_ + 1) % 3];
        across2_ = across*across;
        extra2_ = a[axis_]*a[axis_] - across2_;
    }

    //- At the start of a flight
    void begin(const bodyState& state, const freeRotation& rotation)
    {
        y_ = state.y;
        Vy_ = state.V.y;
        end_ = rotation.heightOf(axis_);
    }

    //- The lowest point at time t: its gap alone
    lowest find(double t, double& rate) const
    {
        double s, c;
        sinCos(end_.rate*t, s, c);
        const double q = end_.mean + end_.cosine*c + end_.sine*s;
        const double turning = end_.rate*(end_.sine*c - end_.cosine*s);
        const double depth = std::sqrt(across2_ + extra2_*q*q);
        rate = Vy_ - extra2_*q*turning/depth;
        lowest out = {};
        out.gap = y_ + Vy_*t - depth;
        return out;
    }

    vector3 contactPoint(const rotationState& r) const
    {
        const vector3 n = multiply(body_.semiAxes(), r.ey);
        return (-1/mag(n))*multiply(body_.semiAxes(), n);
    }
};

} // End anonymous namespace


impact::wallVisit::wallVisit
(
    const convexBody& body,
    const reboundLaw& law,
    visitTreatment treatment,
    int maxImpacts
)
:
    body_(&body),
    law_(law),
    treatment_(treatment),
    maxImpacts_(maxImpacts),
    skewness_(freeRotation::skewness(body))
{}


template<class Shadow>
impact::contactPoint impact::wallVisit::search
(
    const bodyState& state,
    freeRotation& rotation,
    bool touching,
    double departure,
    reliefPiece& piece,
    std::int64_t& hint,
    bool& lost
) const
{
    const double R = body_->radius();
    const double tolerance = 1e-11*R;

    // Passing the relief at a smaller depth is not a contact: without it a
    // body that rolls would be followed in steps of the size of round-off
    const double allowed = 1e-10*R;
    const double omega = rotation.atRest() ? 0 : rotation.maxOmega();

    // The body is the union of balls of its least radius of curvature; a
    // point of a ball may be taken to move with the centre of the ball
    const double lever = R - body_->leastCurvature();
    const double acceleration =
        lever*omega*omega*(1 + skewness_);
    const double accelerationOfPoint = R*omega*omega*(1 + skewness_);
    const double jerk =
        R*omega*omega*omega*(1 + 2*skewness_)*(1 + 2*skewness_);
    const double speed =
        std::sqrt(state.V.x*state.V.x + state.V.y*state.V.y);
    const double fastest = speed + omega*R;
    const double speedX = std::fabs(state.V.x) + omega*lever;
    const double least = 1e-10*R/fastest;

    contactPoint none = {false, 0, 0, 0, 0, {0, 0, 0}};
    if (!(fastest > 0))
    {
        lost = true;
        return none;
    }

    const bool turning = !rotation.atRest() && !body_->isSphere();
    constexpr bool closed = std::is_same_v<Shadow, flatSpheroid>;
    Shadow shadow(*body_);
    if constexpr (closed)
    {
        shadow.begin(state, rotation);
    }
    else
    {
        shadow.turn(state.rotation);
    }
    // Of the last evaluation: rotation, velocity of the lowest point along x
    rotationState now = state.rotation;
    double speedOfPoint = 0;
    auto evaluate = [&](double t, double& rate)
    {
        if constexpr (closed)
        {
            return shadow.find(t, rate);
        }
        else
        {
            if (turning)
            {
                rotation.evaluate(t, now);
                shadow.turn(now);
            }
            const lowest l = shadow.find
            (
                state.x + state.V.x*t, state.y + state.V.y*t, piece, hint
            );
            double vx = state.V.x;
            double vy = state.V.y;
            if (turning)
            {
                const vector3 spin = cross(now.omega, shadow.point(l));
                vx += dot(spin, now.ex);
                vy += dot(spin, now.ey);
            }
            rate = vy - l.slope*vx;
            speedOfPoint = vx;
            return l;
        }
    };
    // Of the last evaluation
    auto contact = [&](double t, const lowest& l)
    {
        if constexpr (closed)
        {
            if (turning)
            {
                rotation.evaluate(t, now);
            }
            const vector3 r = shadow.contactPoint(now);
            return contactPoint
            {
                true, t, l.gap, 0, state.x + state.V.x*t + dot(r, now.ex), r
            };
        }
        else
        {
            return contactPoint
                {true, t, l.gap, l.slope, l.x, shadow.contactPoint(l)};
        }
    };

    // A corner of the body close to the relief, at the last evaluation: the
    // time until it touches by its acceleration, if the third derivative of
    // its gap leaves an error of less than half the tolerance; else 0
    constexpr bool corners =
        std::is_same_v<Shadow, boxShadow>
     || std::is_same_v<Shadow, polygonShadow>;
    auto whenTouching = [&](lowest& l, double rate)
    {
        if constexpr (corners)
        {
            if (!(rate < 0) || l.i != l.j)
            {
                return 0.;
            }
            const relief::interval& s = piece.at(piece.find(l.x, hint));
            const double bend = bendIn(s, l.x);
            double ax = 0, ay = 0;
            if (turning)
            {
                const vector3& J = body_->inertia();
                const vector3& w = now.omega;
                const vector3 alpha =
                {
                    (J.y - J.z)/J.x*w.y*w.z,
                    (J.z - J.x)/J.y*w.z*w.x,
                    (J.x - J.y)/J.z*w.x*w.y
                };
                const vector3 r = shadow.point(l);
                const vector3 a = cross(w, cross(w, r)) + cross(alpha, r);
                ax = dot(a, now.ex);
                ay = dot(a, now.ey);
            }
            const double second = ay - l.slope*ax
              - bend*speedOfPoint*speedOfPoint;
            const double root = rate*rate - 2*second*l.gap;
            if (!(root > 0.5*rate*rate))
            {
                return 0.;
            }
            const double t = 2*l.gap/(std::sqrt(root) - rate);
            const double third =
                std::sqrt(1 + l.slope*l.slope)*jerk
              + 3*std::fabs(bend)*fastest*accelerationOfPoint
              + 6*std::fabs(s.c3)*fastest*fastest*fastest;
            if (!(std::fabs(t*t*t)*third < 3*tolerance))
            {
                return 0.;
            }
            l.x += t*(speedOfPoint + 0.5*t*ax);
            l.gap = 0;
            l.slope = slopeIn(piece.at(piece.find(l.x, hint)), l.x);
            return t;
        }
        return 0.;
    };

    // Longest step: bounds hold over what the body can reach within it, and
    // are lower where that is less. So not much longer than the last one
    const double far = std::max(4*R/fastest, speed > 0 ? R/speed : 0.);
    double longest = far;
    double t0 = 0;
    double stop = 0;            // the relief is pierced there
    bool known = touching && departure > 0;
    lowest low0 = {};
    double rate0 = departure;
    for (int count = 0; ; ++count)
    {
        if (count > 1000000)
        {
            lost = true;
            return none;
        }
        // Close to the relief the circle is within its reach
        const double jump = known && low0.gap < 0.1*R ? t0 : piece.firstReach
        (
            state.x, state.y, state.V.x, state.V.y, R, R, t0, hint, lost
        );
        if (lost || jump == std::numeric_limits<double>::infinity())
        {
            return none;
        }
        if (jump > t0)
        {
            t0 = jump;
            known = false;
        }
        while (t0 >= rotation.horizon())
        {
            rotationState now;
            const double to = rotation.horizon();
            rotation.evaluate(to, now);
            rotation.restart(to, now);
        }
        if (!known)
        {
            low0 = evaluate(t0, rate0);
            known = true;
        }
        const double g0 = std::max(low0.gap, 0.);
        if (low0.gap <= tolerance && !(touching && count == 0) && rate0 < 0)
        {
            return contact(t0, low0);
        }

        // Bounds over what the body can reach within the longest step
        const double limit =
            std::min(longest, rotation.horizon() - t0);
        double steep = 0, crest = 0;
        {
            const double xa = state.x + state.V.x*t0;
            const double xb = xa + state.V.x*limit;
            const double begin = std::min(xa, xb) - R;
            const double end = std::max(xa, xb) + R;
            std::int64_t n = piece.find(begin, hint);
            hint = n;
            for (; piece.knot(n) < end; ++n)
            {
                // The bend is linear in between
                const relief::interval& s = piece.at(n);
                steep = std::max(steep, s.steep);
                const double first = bendIn(s, std::max(begin, s.x0));
                const double last = bendIn(s, std::min(end, s.x1));
                crest = std::max(crest, -std::min(first, last));
            }
        }
        const double B =
            1.0001*(acceleration*std::sqrt(1 + steep*steep)
          + crest*speedX*speedX) + 1e-30*fastest*fastest/R;
        const double reach = std::sqrt(2/B);
        const double root0 = std::sqrt(g0 + allowed);

        // Were the gap to go on at its rate, a step of at most
        // reach^2 rate + 2 reach root0 would be certain; and one to the
        // contact, if it is no longer than reach root0
        double tau;
        if (rate0 < 0 && g0 < -0.99*rate0*reach*root0)
        {
            tau = -g0/rate0;
        }
        else
        {
            tau = 0.75*reach*(reach*rate0 + 2*root0);
            if (stop > t0)
            {
                tau = std::min(tau, 0.7*(stop - t0));
            }
        }
        tau = std::max(least, tau);
        tau = std::min(tau, limit);

        // Share of a step that failed which is likely to succeed, by the cubic
        // through both ends
        auto shorter = [&](double step, double gap1, double rate1)
        {
            for (double f = 0.85; f > 0.1; f -= 0.15)
            {
                const double rest = 1 - f;
                const double g =
                    rest*rest*((1 + 2*f)*g0 + f*step*rate0)
                  + f*f*((1 + 2*rest)*gap1 - rest*step*rate1);
                if
                (
                    g > 0
                 && reach*(root0 + std::sqrt(g)) > 1.1*f*step
                )
                {
                    return f;
                }
            }
            return 0.1;
        };

        // Shorten the step until it is certain, or ends at a contact
        gapSample last = {t0, low0.gap, rate0, low0.i, low0.j};
        for (int k = 0; ; ++k)
        {
            const double t1 = t0 + tau;
            double rate1;
            const lowest low1 = evaluate(t1, rate1);
            const double root1 =
                std::sqrt(std::max(low1.gap, 0.) + allowed);
            const bool clear = root0 + root1 > tau/reach;
            const gapSample here = {t1, low1.gap, rate1, low1.i, low1.j};
            if (std::fabs(low1.gap) < 1e-3*R && std::fabs(low1.gap) > tolerance)
            {
                lowest touch = low1;
                const double rest = whenTouching(touch, rate1);
                if (rest != 0 && tau + rest < reach*root0 && tau + rest > 0)
                {
                    return contact(t1 + rest, touch);
                }
            }
            if (low1.gap >= -tolerance)
            {
                if (clear || tau <= least)
                {
                    if (low1.gap <= tolerance && rate1 < 0)
                    {
                        return contact(t1, low1);
                    }
                    // On to the contact, if it is within the same bounds
                    const double next = rate1 < 0 && k < 8
                      ? here.zero(last) - t0 : limit;
                    if (next > tau && next < std::min(limit, 0.99*reach*root0))
                    {
                        tau = next;
                        last = here;
                        continue;
                    }
                    t0 = t1;
                    low0 = low1;
                    rate0 = rate1;
                    longest = std::min(far, std::max(0.2*far, 3*tau));
                    break;
                }
                tau = std::max(least, tau*shorter(tau, low1.gap, rate1));
                last = here;
                continue;
            }
            // The relief is pierced within the step
            if (tau <= least)
            {
                return contact(t1, low1);
            }
            if (k > 1000)
            {
                lost = true;
                return none;
            }
            double next = rate1 < 0 ? here.zero(last) - t0 : -1;
            if (!(next > 0 && next < tau))
            {
                next = tau*g0/(g0 - low1.gap);
            }
            if (!(next > 0.01*tau))
            {
                next = 0.01*tau;
            }
            if (next >= reach*root0)
            {
                // Not certain then, without a gap at its end
                stop = t1;
                const double certain =
                    std::min(0.999*reach*root0, 0.9*tau);
                next = k < 4
                  ? std::max(certain, tau*shorter(tau, low1.gap, rate1))
                  : certain;
            }
            tau = std::max(least, std::min(next, (1 - 1e-13)*tau));
            last = here;
        }
    }
}


template<class Shadow>
impact::visitResult impact::wallVisit::visitWith
(
    bodyState state,
    reliefPiece& piece,
    std::int64_t hint,
    int impacts
) const
{
    visitResult out = {};
    const double small = 1e-3*mag(state.V);
    const vector3& J = body_->inertia();
    const vector3& spin = state.rotation.omega;
    out.energyOnArrival =
        0.5*(dot(state.V, state.V) + dot(multiply(J, spin), spin));
    bool touching = impacts > 0;
    bool lost = false;
    double departure = 0;
    for (;;)
    {
        freeRotation rotation(*body_, state.rotation);
        const contactPoint c =
            search<Shadow>
            (
                state, rotation, touching, departure, piece, hint, lost
            );
        if (lost)
        {
            out.capped = true;
        }
        if (!c.found)
        {
            break;
        }
        if (treatment_ == visitTreatment::firstImpact && impacts > 0)
        {
            // Would strike again
            out.second = true;
            break;
        }
        if (impacts >= maxImpacts_)
        {
            out.capped = true;
            break;
        }

        // The orientation of a sphere is of no account
        rotationState at = state.rotation;
        if (!body_->isSphere())
        {
            rotation.evaluate(c.time, at);
        }
        const double f = 1/std::sqrt(1 + c.slope*c.slope);
        const vector3 n = f*(at.ey - c.slope*at.ex);
        const vector3 ez = at.ez();
        const vector3 V =
            state.V.x*at.ex + state.V.y*at.ey + state.V.z*ez;
        state.x += state.V.x*c.time;
        state.y += state.V.y*c.time;
        touching = true;

        const impactRecord record =
            law_.impact(J, c.r, n, V, at.omega);
        state.rotation = at;
        if (record.approachSpeed > 0)
        {
            out.second = out.second || impacts > 0;
            const vector3 V2 = V + record.dV;
            state.V = {dot(V2, at.ex), dot(V2, at.ey), dot(V2, ez)};
            state.rotation.omega = at.omega + record.dOmega;
            if (impacts == 0)
            {
                out.intoWall = state.V.y <= 0;
            }
            ++(record.approachSpeed > small ? out.impacts : out.microImpacts);
            out.pulling += record.pulling;
            out.gaining += record.gainsEnergy();
        }
        ++impacts;
        const vector3 Vn =
            state.V.x*at.ex + state.V.y*at.ey + state.V.z*ez;
        departure =
            dot(n, Vn + cross(state.rotation.omega, c.r))/f;
    }
    out.state = state;
    return out;
}


impact::visitResult impact::wallVisit::visit
(
    const bodyState& state,
    reliefPiece& piece,
    std::int64_t hint
) const
{
    return flatSpheroid::holds(*body_, piece.model())
      ? visitWith<flatSpheroid>(state, piece, hint, 0)
      : body_->shape() == convexBody::shapeType::ellipsoid
      ? visitWith<ellipseShadow>(state, piece, hint, 0)
      : body_->isBox()
      ? visitWith<boxShadow>(state, piece, hint, 0)
      : visitWith<polygonShadow>(state, piece, hint, 0);
}


impact::visitResult impact::wallVisit::resume
(
    const bodyState& state,
    int impacts,
    reliefPiece& piece,
    std::int64_t hint
) const
{
    return flatSpheroid::holds(*body_, piece.model())
      ? visitWith<flatSpheroid>(state, piece, hint, impacts)
      : body_->shape() == convexBody::shapeType::ellipsoid
      ? visitWith<ellipseShadow>(state, piece, hint, impacts)
      : body_->isBox()
      ? visitWith<boxShadow>(state, piece, hint, impacts)
      : visitWith<polygonShadow>(state, piece, hint, impacts);
}


impact::contactPoint impact::wallVisit::firstContact
(
    const bodyState& state,
    reliefPiece& piece,
    std::int64_t hint
) const
{
    freeRotation rotation(*body_, state.rotation);
    bool lost = false;
    return flatSpheroid::holds(*body_, piece.model())
      ? search<flatSpheroid>(state, rotation, false, 0, piece, hint, lost)
      : body_->shape() == convexBody::shapeType::ellipsoid
      ? search<ellipseShadow>(state, rotation, false, 0, piece, hint, lost)
      : body_->isBox()
      ? search<boxShadow>(state, rotation, false, 0, piece, hint, lost)
      : search<polygonShadow>(state, rotation, false, 0, piece, hint, lost);
}


double impact::wallVisit::gap
(
    const bodyState& state,
    reliefPiece& piece,
    std::int64_t hint
) const
{
    auto find = [&](auto shadow)
    {
        shadow.turn(state.rotation);
        return shadow.find(state.x, state.y, piece, hint).gap;
    };
    return body_->shape() == convexBody::shapeType::ellipsoid
      ? find(ellipseShadow(*body_))
      : body_->isBox()
      ? find(boxShadow(*body_)) : find(polygonShadow(*body_));
}
