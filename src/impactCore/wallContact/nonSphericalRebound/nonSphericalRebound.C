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
    const wallEncounter& encounter
)
:
    encounter_(encounter),
    diameter_(encounter.body.equivalentDiameter()),
    visit_
    (
        encounter_.body, encounter.law, encounter.treatment,
        encounter.maxImpacts
    ),
    scaled_
    (
        // Long enough to be crossed at any incidence within one interval
        encounter.wall
      ? *encounter.wall : relief::flat(1e6*encounter.body.radius())
    ),
    piece_(scaled_, 0, guardKnots)
{
    encounter.check();
}


impact::nonSphericalRebound::nonSphericalRebound
(
    const nonSphericalRebound& other
)
:
    nonSphericalRebound(other.encounter_)
{}


void impact::nonSphericalRebound::setScale(double scale)
{
    if (scale != scale_)
    {
        scaled_.setScaled(*encounter_.wall, scale);
        scale_ = scale;
        if (encounter_.wall->type() != relief::reliefType::rough)
        {
            piece_.start(0, 1);
        }
    }
}


void impact::nonSphericalRebound::placeOverRelief
(
    const impactKey& key,
    bodyState& b,
    std::int64_t& hint
)
{
    // Room for the descent from the highest crest to the mean plane. A
    // particle that goes further makes the piece grow. On a long way down
    // most have struck before.
    const double R = encounter_.body.radius();
    b.y = scaled_.top() + R;
    const double along = std::min(b.V.x/-b.V.y, 1e4);
    const double high = 2.3*along*scaled_.sigmaHeight();
    const double descent = b.y*along + 4*R
      - (high > 8*scaled_.meanSpacing() ? high : 0);
    const int stretch = int
    (
        std::min(1024., 5 + descent/scaled_.meanSpacing())
    );

    // The body may reach back from where it begins
    const int before = scaled_.reach(R);
    hint = before;

    piece_.start(key.stream ^ key.seed, before + stretch);

    b.x = piece_.drawPlace(key.seed, key.stream, before + 1, hint);
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
    const convexBody& body = encounter_.body;
    const relief* const wall = encounter_.wall.get();
    const double scale = diameter_/diameter;
    const bool random = wall && wall->type() == relief::reliefType::rough;
    if (wall)
    {
        setScale(scale);
    }

    bodyState b;
    b.V = V;
    if (wall && !wall->isFlat())
    {
        const double speed = mag(V);
        static const double minSine = std::sin(minIncidence*M_PI/180);
        if (-V.y < minSine*speed)
        {
            const double along = std::hypot(V.x, V.z);
            const double f = speed*std::sqrt(1 - minSine*minSine)/along;
            b.V = {f*V.x, -minSine*speed, f*V.z};
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

    const threeUnits o = threeUnits::drawn
        (key.seed, 0, drawPurpose::orientation, key.stream);
    rotationState& r = b.rotation;
    orient(encounter_.orientation, o.u0, o.u1, o.u2, r.ex, r.ey);
    r.omega = spin.x*r.ex + spin.y*r.ey + spin.z*r.ez();
    const vector3& J = body.inertia();
    const double turning = 0.5*dot(multiply(J, r.omega), r.omega);
    if (turning > 0)
    {
        const double energy = sphereRotationalEnergy(0.5*diameter, omega);
        r.omega = std::sqrt(energy/turning)*r.omega;
    }

    std::int64_t hint = 0;
    if (random)
    {
        placeOverRelief(key, b, hint);
    }
    else if (wall)
    {
        const double u = threeUnits::drawn
            (key.seed, 0, drawPurpose::position, key.stream).u0;
        b.y = scaled_.top() + body.radius();
        b.x = u*scaled_.period();
        hint = std::int64_t(u*double(scaled_.table().size()));
    }
    else
    {
        const bool spins = dot(spin, spin) > 0 && !body.isSphere();
        const vector3 down = -r.ey;
        b.y = spins ? body.radius() : dot(body.support(down), down);
        b.x = 0.5*scaled_.period();
    }

    const visitResult result = visit_.visit(b, piece_, hint);

    const rotationState& after = result.state.rotation;
    out.V = result.departure();
    out.V.x *= turn;
    out.V.z *= turn;
    out.omega =
    {
        scale*turn*dot(after.omega, after.ex),
        scale*dot(after.omega, after.ey),
        scale*turn*dot(after.omega, after.ez())
    };
    out.rotation1 = 0.5*dot(multiply(J, after.omega), after.omega);
    out.setSphereSpin(diameter);
    out.impacts = result.impacts + result.microImpacts;
    out.pulling = result.pulling;
    out.gaining = result.gaining;
    out.outside = result.outside;
    out.capped = result.capped;
    return out;
}
