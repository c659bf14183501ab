/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "nonSphericalRebound.H"

#include <algorithm>
#include <cmath>

namespace
{

using namespace impact;

//- The curvature of the relief of one visit may have a step of 3e-5 of it
constexpr int guardKnots = 8;

constexpr double pi = 3.14159265358979323846;


//- Unit vector along the part of v that is tangential to the wall, or along
//  an arbitrary direction if there is none
vector3 tangent(const vector3& n, const vector3& v)
{
    const vector3 t = v - dot(v, n)*n;
    const double m = mag(t);
    if (m > 1e-12*mag(v))
    {
        return (1/m)*t;
    }
    const vector3 axis =
        std::fabs(n.x) < 0.6 ? vector3{1, 0, 0} : vector3{0, 1, 0};
    const vector3 other = axis - dot(axis, n)*n;
    return (1/mag(other))*other;
}


//- Three uniform numbers of one impact for one purpose
struct keyedUnits
{
    double u0, u1, u2;

    keyedUnits
    (
        const impactKey& key,
        std::uint32_t block,
        std::uint32_t purpose
    )
    {
        std::uint64_t w0, w1, w2, w3;
        philoxLane(key.seed, block, purpose, key.stream, w0, w1, w2, w3);
        threeUnits(w0, w1, w2, w3, u0, u1, u2);
    }
};

} // End anonymous namespace


impact::wallFrame impact::wallFrame::across
(
    const vector3& n,
    const vector3& direction
)
{
    const vector3 x = tangent(n, direction);
    return {x, n, cross(x, n)};
}


impact::wallFrame impact::wallFrame::along
(
    const vector3& n,
    const vector3& lay
)
{
    const vector3 z = tangent(n, lay);
    return {cross(n, z), n, z};
}


impact::nonSphericalRebound::nonSphericalRebound
(
    const scatteringSampler::setup& setup
)
:
    body_(setup.body),
    treatment_(setup.treatment),
    orientation_(setup.orientation),
    wall_(setup.wall),
    diameter_(std::cbrt(6*setup.body.volume()/pi)),
    visit_(body_, setup.law, setup.treatment, setup.maxImpacts),
    scaled_
    (
        // Long enough to be crossed at any incidence within one interval
        setup.wall ? *setup.wall : relief::flat(1e6*setup.body.radius())
    ),
    piece_(scaled_, 0, guardKnots)
{
    // The sampler knows the ranges of all values
    scatteringSampler::setup check(setup);
    check.incidence = 90;
    check.speed = 1;
    scatteringSampler{check};
}


impact::nonSphericalRebound::nonSphericalRebound
(
    const nonSphericalRebound& other
)
:
    body_(other.body_),
    treatment_(other.treatment_),
    orientation_(other.orientation_),
    wall_(other.wall_),
    diameter_(other.diameter_),
    visit_
    (
        body_,
        other.visit_.law(),
        other.treatment_,
        other.visit_.maxImpacts()
    ),
    scaled_(other.scaled_),
    scale_(other.scale_),
    piece_(scaled_, 0, guardKnots)
{}


void impact::nonSphericalRebound::setScale(double scale)
{
    if (scale != scale_)
    {
        scaled_.setScaled(*wall_, scale);
        scale_ = scale;
        if (wall_->type() != relief::reliefType::rough)
        {
            piece_.start(0, 1);
        }
    }
}


impact::wallDeparture impact::nonSphericalRebound::depart
(
    const vector3& V,
    const vector3& omega,
    double diameter,
    const impactKey& key
)
{
    wallDeparture out = {};
    const double scale = diameter_/diameter;
    const bool random =
        wall_ && wall_->type() == relief::reliefType::rough;
    if (wall_)
    {
        setScale(scale);
    }

    bodyState b;
    b.V = V;
    if (random)
    {
        const double speed = mag(V);
        static const double least = std::sin(leastIncidence*pi/180);
        if (-V.y < least*speed)
        {
            const double along = std::hypot(V.x, V.z);
            const double f = speed*std::sqrt(1 - least*least)/along;
            b.V = {f*V.x, -least*speed, f*V.z};
            out.raised = true;
        }
    }

    // A random relief is the same in law seen from the other side: turned by
    // half a turn about the normal, the particle always moves along x
    const double turn = random && b.V.x < 0 ? -1 : 1;
    b.V.x *= turn;
    b.V.z *= turn;
    const vector3 spin =
        (1/scale)*vector3{turn*omega.x, omega.y, turn*omega.z};

    const keyedUnits o(key, 0, drawPurpose::orientation);
    rotationState& r = b.rotation;
    if (orientation_ == orientationLaw::isotropic)
    {
        orient<orientationLaw::isotropic>(o.u0, o.u1, o.u2, r.ex, r.ey);
    }
    else
    {
        orient<orientationLaw::uniformEuler>(o.u0, o.u1, o.u2, r.ex, r.ey);
    }
    r.omega = spin.x*r.ex + spin.y*r.ey + spin.z*r.ez();

    std::int64_t hint = 0;
    if (!wall_)
    {
        const bool spins = dot(spin, spin) > 0 && !body_.isSphere();
        const vector3 down = -r.ey;
        b.y = spins ? body_.radius() : dot(body_.support(down), down);
        b.x = 0.5*scaled_.period();
    }
    else if (!random)
    {
        const keyedUnits p(key, 0, drawPurpose::position);
        b.y = scaled_.top() + body_.radius();
        b.x = p.u0*scaled_.period();
        hint = std::int64_t(p.u0*double(scaled_.table().size()));
    }
    else
    {
        // Room for the descent from the highest crest to the mean plane. A
        // particle that goes further makes the piece grow. On a long way down
        // most have struck before.
        b.y = scaled_.top() + body_.radius();
        const double along = std::min(b.V.x/-b.V.y, 1e4);
        const double high = 2.3*along*scaled_.sigmaHeight();
        const double descent = b.y*along + 4*body_.radius()
          - (high > 8*scaled_.meanSpacing() ? high : 0);
        const int stretch = int
        (
            std::min(1024., 5 + descent/scaled_.meanSpacing())
        );

        // The body may reach back from where it begins, hardly further than
        // these
        const double variation = 3*scaled_.sigmaSpacing();
        const int before = 1 + int
        (
            std::min
            (
                1024., body_.radius()/(scaled_.meanSpacing() - variation)
            )
        );
        hint = before;

        piece_.start(key.stream ^ key.seed, before + stretch);

        // Long intervals hold more places than short ones
        const double longest = scaled_.meanSpacing() + variation;
        for (std::uint32_t attempt = 0; ; ++attempt, ++hint)
        {
            const keyedUnits p(key, attempt, drawPurpose::position);
            const double begin = piece_.knot(hint);
            const double length = piece_.knot(hint + 1) - begin;
            if (p.u0*longest < length)
            {
                b.x = begin + p.u1*length;
                break;
            }
        }
    }

    const visitResult result = visit_.visit(b, piece_, hint);

    const vector3& J = body_.inertia();
    const rotationState& after = result.state.rotation;
    out.V = result.state.V;
    if (result.capped && out.V.y < 0)
    {
        out.V.y = 0;
    }
    out.V.x *= turn;
    out.V.z *= turn;
    out.omega =
    {
        scale*turn*dot(after.omega, after.ex),
        scale*dot(after.omega, after.ey),
        scale*turn*dot(after.omega, after.ez())
    };
    out.rotation0 = 0.5*dot(multiply(J, r.omega), r.omega);
    out.rotation1 = 0.5*dot(multiply(J, after.omega), after.omega);
    out.impacts = result.impacts + result.microImpacts;
    out.pulling = result.pulling;
    out.gaining = result.gaining;
    out.capped = result.capped;
    return out;
}
