/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorTargets.H"

#include "slipTurn.H"
#include "elementary.H"

#include <algorithm>
#include <cmath>

// Rows are never passed on: their functions are all inlined
#pragma GCC diagnostic ignored "-Wpsabi"

namespace
{

using namespace impact;

//- So many at once
constexpr int lanes = 8;
constexpr int shortPanel = 16, longPanel = slipTurn::points;
typedef double row
    __attribute__((vector_size(lanes*sizeof(double)), may_alias));
typedef std::uint64_t rowOfPlaces
    __attribute__((vector_size(sizeof(row)), may_alias));


//- Points and weights of Radau on [-1, 1]
template<int points>
struct radauPoints
{
    static_assert(points % lanes == 0, "whole rows of points");

    alignas(64) double x[points] = {};

    //- Integral to point j: sum over k of to[k][j] times the value at k
    alignas(64) double to[points][points] = {};

    //- The last two terms in Legendre's polynomials: sums over the values
    alignas(64) double last[points] = {};
    alignas(64) double before[points] = {};

    //- Of barycentric interpolation
    alignas(64) double share[points] = {};

    //- Legendre's polynomials up to order points + 1
    static constexpr void legendre(double x, double* P)
    {
        P[0] = 1;
        P[1] = x;
        for (int m = 1; m <= points; ++m)
        {
            P[m + 1] = ((2*m + 1)*x*P[m] - m*P[m - 1])/(m + 1);
        }
    }

    //- Zero at the points
    static constexpr double nodal(double x)
    {
        double P[points + 2] = {};
        legendre(x, P);
        return P[points] - P[points - 1];
    }

    constexpr radauPoints()
    {
        const int parts = 500;
        int found = 0;
        for (int i = 0; i < parts - 1; ++i)
        {
            double lo = -1 + 2.*i/parts, hi = -1 + 2.*(i + 1)/parts;
            const bool above = nodal(lo) > 0;
            if ((nodal(hi) > 0) == above)
            {
                continue;
            }
            for (int k = 0; k < 54; ++k)
            {
                const double mid = 0.5*(lo + hi);
                ((nodal(mid) > 0) == above ? lo : hi) = mid;
            }
            x[found++] = 0.5*(lo + hi);
        }
        x[points - 1] = 1;

        double P[points][points + 2] = {};
        double weight[points] = {}, sum = 0;
        for (int k = 0; k < points; ++k)
        {
            legendre(x[k], P[k]);
            const double last = points*P[k][points - 1];
            weight[k] = (1 + x[k])/(last*last);
            sum += weight[k];
        }
        for (int k = 0; k < points; ++k)
        {
            weight[k] *= 2/sum;
            for (int j = 0; j < points; ++j)
            {
                double integral = x[j] + 1;
                for (int m = 1; m < points; ++m)
                {
                    integral += P[k][m]*(P[j][m + 1] - P[j][m - 1]);
                }
                to[k][j] = 0.5*weight[k]*integral;
            }
            last[k] = 0.5*(2*points - 1)*weight[k]*P[k][points - 1];
            before[k] = 0.5*(2*points - 3)*weight[k]*P[k][points - 2];
            double product = 1;
            for (int j = 0; j < points; ++j)
            {
                product *= j == k ? 1 : 2*(x[k] - x[j]);
            }
            share[k] = 1/product;
        }
    }
};

template<int points>
constexpr radauPoints<points> radau;


inline const row* asRows(const double* a)
{
    return reinterpret_cast<const row*>(a);
}

inline row* asRows(double* a)
{
    return reinterpret_cast<row*>(a);
}


//- Exponential of |x| < 600 by its series, x less a multiple of log 2:
//  error 3e-16 (1 + |x|)
template<class V, class I>
impactInline V exponential(const V& x)
{
    const V shifted = x*1.4426950408889634 + 0x1.8p52;
    const V n = shifted - 0x1.8p52;
    const V r = (x - n*0x1.62e42feep-1) - n*0x1.a39ef35793c76p-33;
    const V r2 = r*r, r4 = r2*r2;
    const V low = (1 + r) + r2*(1./2 + r*(1./6));
    const V mid = (1./24 + r*(1./120)) + r2*(1./720 + r*(1./5040));
    const V high = (1./40320 + r*(1./362880))
      + r2*((1./3628800 + r*(1./39916800))
      + r2*(1./479001600 + r*(1./6227020800)));
    const I power = (__builtin_bit_cast(I, shifted) + 1023) << 52;
    return __builtin_bit_cast(V, power)*(low + r4*(mid + r4*high));
}


//- Value at zeta of a polynomial
template<class V>
impactInline V second(const double* c, const V& z)
{
    return c[0] + z*(c[1] + z*c[2]);
}

template<class V>
impactInline V fourth(const double* c, const V& z)
{
    return c[0] + z*(c[1] + z*(c[2] + z*(c[3] + z*c[4])));
}


//- Product of two polynomials of second degree
inline void multiplied(const double* a, const double* b, double* c)
{
    c[0] = a[0]*b[0];
    c[1] = a[0]*b[1] + a[1]*b[0];
    c[2] = (a[0]*b[2] + a[2]*b[0]) + a[1]*b[1];
    c[3] = a[1]*b[2] + a[2]*b[1];
    c[4] = a[2]*b[2];
}


//- Natural logarithm to 0.004, for lengths of panels
inline double roughLogarithm(double x)
{
    const std::uint64_t bits = __builtin_bit_cast(std::uint64_t, x);
    const double m = __builtin_bit_cast
    (
        double,
        (bits & 0xfffffffffffffull) | 0x3ff0000000000000ull
    );
    const double e = double(int(bits >> 52) - 1023);
    return 0.6931471805599453*(e + (m - 1)*(1 + 0.345*(2 - m)));
}


//- Angle of the point (x, y), y >= 0, to 0.005
inline double roughAngle(double y, double x)
{
    const double ax = std::fabs(x);
    const bool steep = y > ax;
    const double t = (steep ? ax : y)/nonZero(steep ? y : ax);
    const double a = t*(1.0584 - 0.2732*t);
    const double b = steep ? 1.5707963267948966 - a : a;
    return x < 0 ? 3.1415926535897931 - b : b;
}


//- Directions of whole parts of a turn
struct directions
{
    //- The grid that zeros are looked for on
    static constexpr int cells = 32;
    alignas(64) double c[cells], s[cells], c2[cells], s2[cells];

    //- Half the angle of the middles of its cells
    double halfC[cells], halfS[cells];

    //- Bit number i
    alignas(64) std::uint64_t bit[cells];

    directions()
    {
        for (int i = 0; i < cells; ++i)
        {
            bit[i] = std::uint64_t(1) << i;
            sinCosTurns(double(i)/cells, s[i], c[i]);
            sinCosTurns(2.*i/cells, s2[i], c2[i]);
            sinCosTurns((i + 0.5)/(2*cells), halfS[i], halfC[i]);
        }
    }

    static const directions& all()
    {
        static const directions d;
        return d;
    }
};


//- Which of them are positive: bits
impactKernel std::uint32_t turningAround
(
    const directions& d,
    double c,
    double s,
    double c2,
    double s2,
    double* T
)
{
    rowOfPlaces positive = {};
    for (int i = 0; i < directions::cells/lanes; ++i)
    {
        const row t =
            (c*asRows(d.c)[i] + s*asRows(d.s)[i])
          + (c2*asRows(d.c2)[i] + s2*asRows(d.s2)[i]);
        asRows(T)[i] = t;
        positive |= rowOfPlaces(t > 0)
          & reinterpret_cast<const rowOfPlaces*>(d.bit)[i];
    }
    return std::uint32_t
    (
        ((positive[0] | positive[1]) | (positive[2] | positive[3]))
      | ((positive[4] | positive[5]) | (positive[6] | positive[7]))
    );
}


//- What a panel is made of
struct panelInput
{
    const double* H;
    const double* Ex;
    const double* Ey;
    const double* N;
    const double* R;
    const double* T;
    double factor, zeta, length;
    double s0, cx0, cy0, v0, work0;
    double mu, f1, f2, i11, i12, i22, g1, g2, schur;
};


//- Where its columns go
struct panelColumns
{
    double *w, *s, *cx, *cy, *p, *Z, *v, *work, *rate, *N;
};


impactInline double sumOf(const row& a)
{
    return
        ((a[0] + a[1]) + (a[2] + a[3])) + ((a[4] + a[5]) + (a[6] + a[7]));
}


impactInline double largestOf(const row& a)
{
    return std::max
    (
        std::max(std::max(a[0], a[1]), std::max(a[2], a[3])),
        std::max(std::max(a[4], a[5]), std::max(a[6], a[7]))
    );
}


//- Integrals of values to all points
template<int points>
impactInline void integrate(const row* value, row* integral)
{
    constexpr int rows = points/lanes;
    row sum[rows] = {};
    #pragma GCC unroll 8
    for (int i = 0; i < rows; ++i)
    {
        #pragma GCC unroll 8
        for (int l = 0; l < lanes; ++l)
        {
            const double v = value[i][l];
            const row* to = asRows(radau<points>.to[lanes*i + l]);
            #pragma GCC unroll 8
            for (int j = 0; j < rows; ++j)
            {
                sum[j] += v*to[j];
            }
        }
    }
    #pragma GCC unroll 8
    for (int j = 0; j < rows; ++j)
    {
        integral[j] = sum[j];
    }
}


//- What is known of a panel: its error, and the least N
struct panelQuality
{
    double error, least;
};


//- The columns of a panel
template<int points>
impactInline panelQuality makePanel(const panelInput& q, const panelColumns& c)
{
    constexpr int rows = points/lanes;
    const double half = 0.5*q.length;
    row growth[rows], bySlip[rows], sum[rows], least;
    #pragma GCC unroll 8
    for (int i = 0; i < rows; ++i)
    {
        const row along = half*(1 + asRows(radau<points>.x)[i]);
        const row z = q.zeta*exponential<row, rowOfPlaces>(along);
        const row H = second(q.H, z);
        const row T = fourth(q.T, z);
        const row inverse = 1/(H*T);
        const row common = q.factor*z*inverse;
        const row unit = T*inverse;
        asRows(c.w)[i] = along;
        growth[i] = common*fourth(q.R, z);
        bySlip[i] = common*H*H;
        asRows(c.cx)[i] = second(q.Ex, z)*unit;
        asRows(c.cy)[i] = second(q.Ey, z)*unit;
        const row N = second(q.N, z)*unit;
        asRows(c.N)[i] = N;
        least = i == 0 ? N : N < least ? N : least;
    }
    integrate<points>(growth, sum);
    row squared[rows];
    row last = {}, before = {}, size = {};
    #pragma GCC unroll 8
    for (int i = 0; i < rows; ++i)
    {
        // Far less than a panel that is of use spans
        const row power = half*sum[i];
        const row bounded = power > 300 ? row{} + 300 : power;
        const row slip =
            q.s0*exponential<row, rowOfPlaces>
            (bounded < -300 ? row{} - 300 : bounded);
        asRows(c.s)[i] = slip;
        const row r = slip*bySlip[i];
        asRows(c.rate)[i] = r;
        squared[i] = slip*r;
        last += asRows(radau<points>.last)[i]*r;
        before += asRows(radau<points>.before)[i]*r;
        size = r > size ? r : size;
    }
    row impulse[rows];
    integrate<points>(asRows(c.rate), impulse);
    integrate<points>(squared, sum);
    #pragma GCC unroll 8
    for (int i = 0; i < rows; ++i)
    {
        const row P = half*impulse[i], slip = asRows(c.s)[i];
        const row z = half*sum[i];
        const row x = slip*asRows(c.cx)[i], y = slip*asRows(c.cy)[i];
        const row dx = x - q.s0*q.cx0, dy = y - q.s0*q.cy0;
        const row b1 = dx - q.f1*P, b2 = dy - q.f2*P;
        const row dv = q.schur*P + (q.g1*dx + q.g2*dy);
        asRows(c.p)[i] = P;
        asRows(c.Z)[i] = z;
        asRows(c.v)[i] = q.v0 + dv;
        asRows(c.work)[i] = q.work0
          + 0.5
           *(
                (q.i11*b1 + q.i12*b2)*(x + q.s0*q.cx0)
              + (q.i12*b1 + q.i22*b2)*(y + q.s0*q.cy0)
              + P*(2*q.v0 + dv)
            )
          + q.mu*z;
    }
    const double most =
        std::max(std::fabs(sumOf(last)), std::fabs(sumOf(before)));
    return {most/largestOf(size), -largestOf(-least)};
}


impactKernel panelQuality makeShortPanel
(
    const panelInput& q,
    const panelColumns& c
)
{
    return makePanel<shortPanel>(q, c);
}

impactKernel panelQuality makeLongPanel
(
    const panelInput& q,
    const panelColumns& c
)
{
    return makePanel<longPanel>(q, c);
}


//- Values in between, of three columns at x
template<int points>
impactInline void interpolated
(
    double x,
    const double* a,
    const double* b,
    const double* c,
    double* value
)
{
    constexpr int rows = points/lanes;
    row all = {}, sumA = {}, sumB = {}, sumC = {};
    #pragma GCC unroll 8
    for (int i = 0; i < rows; ++i)
    {
        // At a point that point alone counts
        const row distance = x - asRows(radau<points>.x)[i];
        const row apart = distance == 0 ? row{} + 1e-100 : distance;
        const row share = asRows(radau<points>.share)[i]/apart;
        all += share;
        sumA += share*asRows(a)[i];
        sumB += share*asRows(b)[i];
        sumC += share*asRows(c)[i];
    }
    const double unit = 1/sumOf(all);
    value[0] = unit*sumOf(sumA);
    value[1] = unit*sumOf(sumB);
    value[2] = unit*sumOf(sumC);
}


impactKernel void interpolateShort
(
    double x,
    const double* a,
    const double* b,
    const double* c,
    double* value
)
{
    interpolated<shortPanel>(x, a, b, c, value);
}

impactKernel void interpolateLong
(
    double x,
    const double* a,
    const double* b,
    const double* c,
    double* value
)
{
    interpolated<longPanel>(x, a, b, c, value);
}


double exponentialOf(double x)
{
    return exponential<double, std::uint64_t>(x);
}


//- Where a function is zero, by the inverse cubic through two places:
//  fa < 0 <= fb, and its rates there
double crossing
(
    double a,
    double fa,
    double ra,
    double b,
    double fb,
    double rb
)
{
    const double h = fb - fa;
    if (!(h > 0))
    {
        return b;
    }
    const double t = -fa/h;
    const double u = 1 - t;
    const double x =
        a + t*t*(3 - 2*t)*(b - a) + h*t*u*(u/ra - t/rb);
    return x > a && x < b ? x : a + t*(b - a);
}

} // End anonymous namespace


bool impact::slipTurn::begin(const contactResponse& c, double x, double y)
{
    mu_ = c.mu;
    a_ = c.a;
    const double slip = std::sqrt(x*x + y*y);
    ux_ = x/slip;
    uy_ = y/slip;

    // Along the slip and across
    const double kxy =
        c.k12*(ux_*ux_ - uy_*uy_) + (c.k22 - c.k11)*ux_*uy_;
    k11_ = c.k11*ux_*ux_ + 2*c.k12*ux_*uy_ + c.k22*uy_*uy_;
    k22_ = c.k11 + c.k22 - k11_;
    f1_ = c.f1*ux_ + c.f2*uy_;
    const double across = c.f2*ux_ - c.f1*uy_;
    side_ = across - mu_*kxy < 0 ? -1 : 1;
    f2_ = side_*across;
    k12_ = side_*kxy;

    const double k = k11_*k22_ - k12_*k12_;
    i11_ = k22_/k;
    i12_ = -k12_/k;
    i22_ = k11_/k;
    g1_ = i11_*f1_ + i12_*f2_;
    g2_ = i12_*f1_ + i22_*f2_;
    schur_ = a_ - f1_*g1_ - f2_*g2_;

    // T is the product of these with the cosine and the sine of the angle and
    // of twice the angle
    const double mean = 0.5*(k11_ + k22_);
    const double skew = 0.5*mu_*(k11_ - k22_);
    const double shear = mu_*k12_;
    const directions& around = directions::all();
    alignas(64) double T[directions::cells];
    constexpr int n = directions::cells;
    static_assert(n == 32, "a bit for each");
    const std::uint32_t others =
        ~turningAround(around, f2_, -f1_, -shear, skew, T);
    if (others == 0 || (others & 1))
    {
        return false;
    }
    const int ahead = __builtin_ctz(others);
    const int behind = n - 1 - __builtin_clz(others);

    // The zero in a cell as half its direction, from its middle; cells have
    // the same share of half a turn
    const double edge = 0.0491;
    auto zero = [&](int cell, double T0, double T1, double& C, double& S)
    {
        const double hc = around.halfC[cell], hs = around.halfS[cell];
        const double cc = hc*hc - hs*hs, cs = 2*hc*hs;
        const double cc2 = cc*cc - cs*cs, cs2 = 2*cc*cs;
        const double g1 = f1_*cc + f2_*cs, g2 = f2_*cc - f1_*cs;
        const double w1 = skew*cc2 + shear*cs2, w2 = shear*cc2 - skew*cs2;
        const double q[5] =
            {g2 - w2, 4*w1 - 2*g1, 6*w2, -4*w1 - 2*g1, -g2 - w2};
        double t = edge*(T0 + T1)/(T0 - T1);
        for (int i = 0; i < 2; ++i)
        {
            const double value = fourth(q, t);
            const double slope =
                q[1] + t*(2*q[2] + t*(3*q[3] + t*4*q[4]));
            if (!(std::fabs(value) < 0.1*std::fabs(slope)))
            {
                return false;
            }
            t -= value/slope;
        }
        C = hc - t*hs;
        S = hs + t*hc;
        return std::fabs(t) < 1.1*edge;
    };
    double Cb, Sb, Cg, Sg;
    if
    (
        !zero(ahead - 1, T[ahead - 1], T[ahead], Cb, Sb)
     || !zero(behind, T[behind], T[(behind + 1) % n], Cg, Sg)
    )
    {
        return false;
    }
    // Behind, by half a turn of the half angle
    Cg = -Cg;
    Sg = -Sg;
    const double sine = Cg*Sb - Sg*Cb, cosine = Cg*Cb + Sg*Sb;
    if (!(Sb > 1e-6 && Sg < -1e-6 && sine > 1e-3))
    {
        return false;
    }

    H_[0] = Cg*Cg + Sg*Sg;
    H_[1] = 2*cosine;
    H_[2] = Cb*Cb + Sb*Sb;
    Ex_[0] = Cg*Cg - Sg*Sg;
    Ex_[1] = 2*(Cg*Cb - Sg*Sb);
    Ex_[2] = Cb*Cb - Sb*Sb;
    Ey_[0] = 2*Cg*Sg;
    Ey_[1] = 2*(Cg*Sb + Sg*Cb);
    Ey_[2] = 2*Cb*Sb;
    double turn[3], brake[3];
    for (int i = 0; i < 3; ++i)
    {
        const double drive = f1_*Ex_[i] + f2_*Ey_[i];
        turn[i] = f2_*Ex_[i] - f1_*Ey_[i];
        brake[i] = drive - mu_*mean*H_[i];
        N_[i] = a_*H_[i] - mu_*drive;
    }
    double squareX[5], squareY[5], product[5];
    multiplied(Ex_, Ex_, squareX);
    multiplied(Ey_, Ey_, squareY);
    multiplied(Ex_, Ey_, product);
    multiplied(turn, H_, T_);
    multiplied(brake, H_, R_);
    for (int i = 0; i < 5; ++i)
    {
        const double difference = squareX[i] - squareY[i];
        T_[i] += 2*skew*product[i] - shear*difference;
        R_[i] -= skew*difference + 2*shear*product[i];
    }
    factor_ = 2*sine;

    // Direction of angle 0
    zeta_ = -Sg/Sb;
    const double w = roughLogarithm(zeta_);

    nSingular_ = 0;
    auto add = [&](double squaredModulus, double angle)
    {
        singular_[nSingular_][0] = 0.5*roughLogarithm(squaredModulus) - w;
        singular_[nSingular_][1] = angle;
        ++nSingular_;
    };
    constexpr double pi = 3.14159265358979323846;
    add(H_[0]/H_[2], roughAngle(sine, -cosine));
    const double A = T_[3], B = T_[2], C = T_[1];
    if (!(A > 0 && C > 0))
    {
        return false;
    }
    const double disc = B*B - 4*A*C;
    if (disc < 0)
    {
        add(C/A, roughAngle(std::sqrt(-disc), -B));
    }
    else
    {
        if (!(B > 0))
        {
            return false;
        }
        const double q = 0.5*(B + std::sqrt(disc));
        const double r1 = q/A, r2 = C/q;
        if (!(r1 < 1e30 && r2 > 1e-30))
        {
            return false;
        }
        add(r1*r1, pi);
        add(r2*r2, pi);
    }
    start_ = {};
    rates(start_, zeta_);
    return true;
}


void impact::slipTurn::rates(place& q, double zeta) const
{
    const double H = second(H_, zeta), T = fourth(T_, zeta);
    const double inverse = 1/(H*T), unit = T*inverse;
    q.cx = second(Ex_, zeta)*unit;
    q.cy = second(Ey_, zeta)*unit;
    q.T = T*unit*unit;
    q.N = second(N_, zeta)*unit;
    q.rate = factor_*zeta*H*H*inverse;
}


bool impact::slipTurn::panel
(
    double s,
    double v,
    double work,
    double impulse,
    double tolerance
)
{
    // Not where it hardly turns any more
    const double byTau = start_.rate;
    if (!(start_.T > 0 && start_.N > 0 && zeta_ < 1e8))
    {
        return false;
    }
    start_.s = s;
    start_.v = v;
    start_.work = work;
    start_.rate = s*byTau;

    // Of ln s by tau
    const double R = (f1_*start_.cx + f2_*start_.cy)
      - mu_
       *(
            start_.cx*(k11_*start_.cx + 2*k12_*start_.cy)
          + k22_*start_.cy*start_.cy
        );

    // Up to the nearest singular point: the sum of its distances from both
    // ends is so many times the length that terms fall by 10^9.6
    const double axes = 1.45, shortAxes = 2.3;
    double length = 12, shortLength = 12;
    for (int i = 0; i < nSingular_; ++i)
    {
        const double x = singular_[i][0], y = singular_[i][1];
        const double away = std::sqrt(x*x + y*y);
        length = std::min(length, (axes*away - x)*(2/(axes*axes - 1)));
        shortLength = std::min
        (
            shortLength,
            (shortAxes*away - x)*(2/(shortAxes*shortAxes - 1))
        );
    }
    // Slip grows or falls exponentially; the impulse is that long if its rate
    // stays, with a margin
    const double growth = R*byTau;
    length /= 1 + 0.05*std::fabs(growth)*length;
    shortLength /= 1 + 0.12*std::fabs(growth)*shortLength;
    const double change = 1.2*impulse*R/s;
    const double needed = std::fabs(change) < 0.1
      ? 1.2*impulse/start_.rate*(1 - 0.5*change)
      : change < -0.9975 ? 6/-growth : roughLogarithm(1 + change)/growth;
    length_ = std::min(length, needed);
    n_ = length_ <= shortLength ? shortPanel : longPanel;

    const double share = std::min(1., s/impulse);
    for (int i = 0; i < 4; ++i)
    {
        const panelInput q =
        {
            H_, Ex_, Ey_, N_, R_, T_, factor_, zeta_, length_,
            s, start_.cx, start_.cy, v, work,
            mu_, f1_, f2_, i11_, i12_, i22_, g1_, g2_, schur_
        };
        const panelColumns to =
        {
            c_.w, c_.s, c_.cx, c_.cy, c_.p, c_.Z, c_.v, c_.work, c_.rate,
            c_.N
        };
        const bool few = n_ == shortPanel;
        const panelQuality made =
            few ? makeShortPanel(q, to) : makeLongPanel(q, to);
        const double error = share*made.error;
        // Few points may miss what they do not see
        if (error <= (few ? 0.05*tolerance : tolerance))
        {
            return made.least > 0;
        }
        if (few)
        {
            n_ = longPanel;
            continue;
        }
        const double ratio = tolerance/error;
        length_ *= 0.9*std::max
        (
            0.3,
            std::sqrt(std::sqrt(std::sqrt(std::sqrt(ratio))))
        );
    }
    return false;
}


void impact::slipTurn::proceed()
{
    start_ = end();
    start_.w = start_.p = start_.Z = 0;
    zeta_ *= exponentialOf(length_);
    for (int i = 0; i < nSingular_; ++i)
    {
        singular_[i][0] -= length_;
    }
    rates(start_, zeta_);
}


void impact::slipTurn::balance(place& q) const
{
    const double x = q.s*q.cx, y = q.s*q.cy;
    const double x0 = start_.s*start_.cx, y0 = start_.s*start_.cy;
    const double b1 = (x - x0) - f1_*q.p, b2 = (y - y0) - f2_*q.p;
    q.v = start_.v + schur_*q.p + (g1_*(x - x0) + g2_*(y - y0));
    q.work = start_.work
      + 0.5
       *(
            (i11_*b1 + i12_*b2)*(x + x0) + (i12_*b1 + i22_*b2)*(y + y0)
          + q.p*(start_.v + q.v)
        )
      + mu_*q.Z;
}


impact::slipTurn::place impact::slipTurn::at(int i) const
{
    place q;
    q.w = c_.w[i];
    q.s = c_.s[i];
    q.cx = c_.cx[i];
    q.cy = c_.cy[i];
    q.p = c_.p[i];
    q.Z = c_.Z[i];
    q.v = c_.v[i];
    q.work = c_.work[i];
    q.rate = c_.rate[i];
    q.N = c_.N[i];
    q.T = 0;
    return q;
}


void impact::slipTurn::interpolate
(
    double w,
    const double* a,
    const double* b,
    const double* c,
    double* value
) const
{
    const double x = 2*w/length_ - 1;
    n_ == shortPanel
      ? interpolateShort(x, a, b, c, value)
      : interpolateLong(x, a, b, c, value);
}


impact::slipTurn::place impact::slipTurn::at(double w) const
{
    double value[3];
    interpolate(w, c_.s, c_.p, c_.Z, value);
    const double zeta = zeta_*exponentialOf(w);
    place q;
    q.w = w;
    q.s = value[0];
    q.p = value[1];
    q.Z = value[2];
    rates(q, zeta);
    q.rate *= q.s;
    balance(q);
    return q;
}


void impact::slipTurn::nudge(place& q, double dp) const
{
    // e turns by T/s; t'' = -mu k e' T/s
    const double bend = 0.5*dp*dp*mu_*q.T/q.s;
    const double x = q.s*q.cx
      + dp*(f1_ - mu_*(k11_*q.cx + k12_*q.cy))
      - bend*(k12_*q.cx - k11_*q.cy);
    const double y = q.s*q.cy
      + dp*(f2_ - mu_*(k12_*q.cx + k22_*q.cy))
      - bend*(k22_*q.cx - k12_*q.cy);
    const double s = std::sqrt(x*x + y*y);
    q.w += dp/q.rate;
    q.Z += 0.5*dp*(q.s + s);
    q.p += dp;
    q.s = s;
    q.cx = x/s;
    q.cy = y/s;
    balance(q);
}


impact::slipTurn::place impact::slipTurn::turningPoint() const
{
    int i = 0;
    while (i < n_ - 1 && c_.v[i] < 0)
    {
        ++i;
    }
    const double a = i ? c_.w[i - 1] : 0, va = i ? c_.v[i - 1] : start_.v;
    const double ra =
        i ? c_.rate[i - 1]*c_.N[i - 1] : start_.rate*start_.N;
    double lo = a, hi = c_.w[i];
    double w = crossing(a, va, ra, hi, c_.v[i], c_.rate[i]*c_.N[i]);
    for (int k = 0; ; ++k)
    {
        place q = at(w);
        (q.v < 0 ? lo : hi) = w;
        const double dp = -q.v/q.N;
        const double step = dp/q.rate;
        if (std::fabs(step) <= 1e-4*length_ || k == 30)
        {
            // Where the velocity is zero the work is least
            q.w += step;
            q.p += dp;
            q.work += 0.5*q.v*dp;
            q.v = 0;
            return q;
        }
        w = w + step > lo && w + step < hi ? w + step : 0.5*(lo + hi);
    }
}


impact::slipTurn::place impact::slipTurn::stoppingPoint() const
{
    place q = at(std::min(std::max(turningPoint().w, 0.), length_));
    for (int k = 0; k < 3; ++k)
    {
        nudge(q, -q.v/q.N);
    }
    return q;
}


impact::slipTurn::place impact::slipTurn::workDone
(
    const place& from,
    double deepest,
    double work
) const
{
    // The root of the work from the turning point on is smooth
    int i = 0;
    while (i < n_ - 1 && !(c_.w[i] > from.w && c_.work[i] >= work))
    {
        ++i;
    }
    auto rootOf = [&](double done)
    {
        return std::sqrt(std::max(1e-200, done - deepest));
    };
    const double goal = rootOf(work);
    const bool inside = i > 0 && c_.w[i - 1] > from.w;
    double lo = inside ? c_.w[i - 1] : from.w, hi = c_.w[i];
    const double root0 = rootOf(inside ? c_.work[i - 1] : from.work);
    const double root1 = rootOf(c_.work[i]);
    const double rate0 = inside
      ? 0.5*c_.v[i - 1]*c_.rate[i - 1]/root0
      : from.work > deepest && from.v > 0
      ? 0.5*from.v*from.rate/root0 : std::sqrt(0.5*from.N)*from.rate;
    const double rate1 = 0.5*c_.v[i]*c_.rate[i]/root1;
    double w = crossing(lo, root0 - goal, rate0, hi, root1 - goal, rate1);
    for (int k = 0; ; ++k)
    {
        place q = at(w);
        const double rest = work - q.work;
        const double way = w - from.w;
        (rest > 0 ? lo : hi) = w;
        const double square = q.v*q.v + 2*q.N*rest;
        const double dp = q.v > 0 && square > 0
          ? 2*rest/(q.v + std::sqrt(square)) : rest/(q.N*q.p);
        const double step = dp/q.rate;
        if (std::fabs(step) <= 1e-4*std::min(length_, 10*way) || k == 30)
        {
            nudge(q, dp);
            return q;
        }
        w = w + step > lo && w + step < hi ? w + step : 0.5*(lo + hi);
    }
}


void impact::slipTurn::tangential
(
    const place& q,
    double& S1,
    double& S2,
    double& x,
    double& y
) const
{
    const double tx = q.s*q.cx, ty = q.s*q.cy;
    const double b1 = (tx - start_.s*start_.cx) - f1_*q.p;
    const double b2 = (ty - start_.s*start_.cy) - f2_*q.p;
    const double along = i11_*b1 + i12_*b2;
    const double across = side_*(i12_*b1 + i22_*b2);
    S1 = ux_*along - uy_*across;
    S2 = uy_*along + ux_*across;
    x = ux_*tx - uy_*(side_*ty);
    y = uy_*tx + ux_*(side_*ty);
}
