/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "freeRotation.H"
#include "rotationKernels.H"

#include <algorithm>

namespace
{

using impact::vector3;

//- v turned about a coordinate axis; 3: about none
template<int axis>
inline void turn(vector3& v, double s, double c)
{
    if constexpr (axis < 3)
    {
        const int j = axis == 2 ? 0 : axis + 1;
        const int k = axis == 0 ? 2 : axis - 1;
        const double x = v[j], y = v[k];
        v[j] = c*x - s*y;
        v[k] = s*x + c*y;
    }
}


//- The same of all vectors of a state
template<int axis>
inline void turn(impact::rotationState& state, double angle)
{
    if constexpr (axis < 3)
    {
        double s, c;
        impact::sinCos(angle, s, c);
        turn<axis>(state.ex, s, c);
        turn<axis>(state.ey, s, c);
        turn<axis>(state.omega, s, c);
    }
}

} // End anonymous namespace


impact::freeRotation::freeRotation
(
    const convexBody& body,
    const rotationState& initial
)
:
    body_(&body)
{
    restart(0, initial);
}


void impact::freeRotation::restart(double t, const rotationState& state)
{
    initial_ = state;
    origin_ = t;
    horizon_ = std::numeric_limits<double>::infinity();
    const vector3 L = multiply(body_->inertia(), state.omega);
    const double magL = mag(L);
    atRest_ = !(magL > 0);
    if (atRest_)
    {
        return;
    }
    const int axis = body_->symmetryAxis();
    if (axis < 0)
    {
        expand();
        return;
    }
    const vector3& J = body_->inertia();
    const double across = J[axis == 0 ? 1 : 0];
    axisL_ = (1/magL)*L;
    rateL_ = magL/across;
    rateAxis_ = axis == 3 ? 0 : state.omega[axis]*(1 - J[axis]/across);
    ex_ = precession(state.ex, axisL_);
    ey_ = precession(state.ey, axisL_);
}


void impact::freeRotation::expand()
{
    const vector3& J = body_->inertia();
    const double kx = (J.y - J.z)/J.x;
    const double ky = (J.z - J.x)/J.y;
    const double kz = (J.x - J.y)/J.z;

    // Time is measured in units of 1/|omega|: coefficients of order one
    const double magOmega = mag(initial_.omega);
    scale_ = 1/magOmega;
    auto& c = series_;
    const vector3* start[3] = {&initial_.ex, &initial_.ey, &initial_.omega};
    for (int v = 0; v < 3; ++v)
    {
        const double unit = v == 2 ? scale_ : 1;
        c[0][3*v] = unit*start[v]->x;
        c[0][3*v + 1] = unit*start[v]->y;
        c[0][3*v + 2] = unit*start[v]->z;
    }
    const double k[3] = {kx, ky, kz};
    rotationSeries(order, k, c);

    // Where the last three terms have fallen to the tolerance: the largest
    // coefficient of each is compared, since single ones may vanish
    // by symmetry. The root of their ratio is taken to the next eighth of a
    // power of two below, by a chord of the logarithm: a power function of
    // the mathematics library may round differently on another machine.
    static const double eighths[8] =
    {
        1, 0x1.172b83c7d517ap+0, 0x1.306fe0a31b715p+0, 0x1.4bfdad5362a27p+0,
        0x1.6a09e667f3bccp+0, 0x1.8ace5422aa0dap+0, 0x1.ae89f995ad3acp+0,
        0x1.d5818dcfba486p+0
    };
    int reach = 80;
    for (int n = order - 2; n <= order; ++n)
    {
        double largest = 1e-100;
        for (double x : c[n])
        {
            largest = std::max(largest, std::fabs(x));
        }
        int exponent;
        const double mantissa = std::frexp(1e-14/largest, &exponent);
        reach = std::min
        (
            reach,
            int(std::floor(8*(exponent + 2*mantissa - 2)/n))
        );
    }
    const int power = int(std::floor(reach/8.));
    horizon_ =
        origin_ + std::ldexp(eighths[reach - 8*power], power)*scale_;
}


void impact::freeRotation::evaluate(double t, rotationState& state) const
{
    if (atRest_)
    {
        state = initial_;
        return;
    }
    const int axis = body_->symmetryAxis();
    if (axis < 0)
    {
        const double x = (t - origin_)/scale_;
        double v[9];
        rotationSum(order, series_, x, v);
        const double unit = 1/scale_;
        state.ex = {v[0], v[1], v[2]};
        state.ey = {v[3], v[4], v[5]};
        state.omega = {unit*v[6], unit*v[7], unit*v[8]};
        return;
    }
    const double since = t - origin_;
    double s, c;
    sinCos(-rateL_*since, s, c);
    state.ex = ex_.mean + (c*ex_.cosine + s*ex_.sine);
    state.ey = ey_.mean + (c*ey_.cosine + s*ey_.sine);
    state.omega = initial_.omega;
    const double angle = -rateAxis_*since;
    axis == 0 ? turn<0>(state, angle)
  : axis == 1 ? turn<1>(state, angle)
  : axis == 2 ? turn<2>(state, angle)
  : turn<3>(state, angle);
}


impact::freeRotation::oscillation
impact::freeRotation::heightOf(int axis) const
{
    const vector3& ey = initial_.ey;
    if (atRest_)
    {
        return {ey[axis], 0, 0, 0};
    }
    // The turn about the angular momentum; that about the axis itself leaves
    // it where it is
    const double mean = dot(axisL_, ey)*axisL_[axis];
    const double cosine = ey[axis] - mean;
    const double sine = -cross(axisL_, ey)[axis];
    double s, c;
    sinCos(rateL_*origin_, s, c);
    return {mean, cosine*c - sine*s, cosine*s + sine*c, rateL_};
}


double impact::freeRotation::maxOmega() const
{
    const vector3& J = body_->inertia();
    if (body_->symmetryAxis() >= 0)
    {
        return mag(initial_.omega);
    }
    // |omega|^2 <= |L|^2/Jmin^2 and <= 2T/Jmin
    const vector3 L = multiply(J, initial_.omega);
    const double minMoment = std::min({J.x, J.y, J.z});
    return std::sqrt
    (
        std::min
        (
            dot(L, initial_.omega)/minMoment, dot(L, L)/(minMoment*minMoment)
        )
    );
}


double impact::freeRotation::skewness(const convexBody& body)
{
    const vector3& J = body.inertia();
    double k = 0;
    for (int i = 0; i < 3; ++i)
    {
        k = std::max
        (
            k,
            std::fabs((J[(i + 1) % 3] - J[(i + 2) % 3])/J[i])
        );
    }
    // The products of two components of omega make a vector no longer than
    // omega^2/sqrt(3)
    return 0.57736*k;
}
