/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The search for the first contact against brute force: small steps in time,
    the shadow as a dense set of points of the body's surface, each compared
    with the height of the relief. Then the laws of a whole visit.
\*---------------------------------------------------------------------------*/

#include "wallVisit.H"
#include "contactSearch.H"
#include "orientation.H"
#include "counterRandom.H"

#include <gtest/gtest.h>
#include <cmath>
#include <vector>

using namespace impact;

namespace
{

//- Points that cover the surface: every point of the shadow's outline is the
//  shadow of one nearby
std::vector<vector3> surfacePoints(const convexBody& b)
{
    std::vector<vector3> p;
    if (b.shape() == convexBody::shapeType::ellipsoid)
    {
        const int n = 6000;
        for (int i = 0; i < n; ++i)
        {
            const double z = 1 - 2*(i + 0.5)/n;
            const double r = std::sqrt(1 - z*z);
            const double a = 2.399963229728653*i;
            p.push_back
            (
                multiply
                (
                    b.semiAxes(),
                    {z, r*std::cos(a), r*std::sin(a)}
                )
            );
        }
    }
    else
    {
        for (const auto& e : b.edges())
        {
            for (int i = 0; i <= 100; ++i)
            {
                const vector3& u = b.vertices()[e[0]];
                const vector3& v = b.vertices()[e[1]];
                p.push_back(u + (0.01*i)*(v - u));
            }
        }
    }
    return p;
}


double bruteGap
(
    const std::vector<vector3>& points,
    const bodyState& s,
    const rotationState& r,
    double t,
    reliefPiece& piece
)
{
    const double cx = s.x + s.V.x*t;
    const double cy = s.y + s.V.y*t;
    double minGap = 1e300;
    std::int64_t k = piece.find(cx, 0);
    for (const vector3& p : points)
    {
        const double x = cx + dot(r.ex, p);
        const double y = cy + dot(r.ey, p);
        if (y - piece.model().top() < minGap)
        {
            minGap = std::min(minGap, y - piece.height(x, k));
        }
    }
    return minGap;
}


bodyState randomState
(
    counterRandom& rnd,
    const convexBody& body,
    double spinScale,
    double height
)
{
    bodyState s;
    s.x = 400e-6 + 800e-6*rnd.uniform();
    s.y = height + body.radius();
    const double alpha = (2 + 86*rnd.uniform())*M_PI/180;
    const double sign = rnd.uniform() < 0.5 ? -1 : 1;
    s.V = {200*sign*std::cos(alpha), -200*std::sin(alpha), 0};
    const double u0 = rnd.uniform(), u1 = rnd.uniform(), u2 = rnd.uniform();
    orient<orientationLaw::isotropic>
        (u0, u1, u2, s.rotation.ex, s.rotation.ey);
    const double w = spinScale*200/body.radius();
    s.rotation.omega =
        {w*rnd.normal(), w*rnd.normal(), w*rnd.normal()};
    return s;
}


template<class Shadow>
contactPoint contactOf
(
    const convexBody& body,
    const bodyState& s,
    reliefPiece& piece
)
{
    freeRotation rotation(body, s.rotation);
    bool lost = false;
    std::int64_t hint = 0;
    return contactSearch<Shadow>
        (
            body, freeRotation::skewness(body), s, rotation, piece, hint
        ).find(false, 0, lost);
}


contactPoint firstContact
(
    const convexBody& body,
    const bodyState& s,
    reliefPiece& piece
)
{
    return flatSpheroid::holds(body, piece.model())
      ? contactOf<flatSpheroid>(body, s, piece)
      : body.shape() == convexBody::shapeType::ellipsoid
      ? contactOf<ellipseShadow>(body, s, piece)
      : body.isBox() ? contactOf<boxShadow>(body, s, piece)
      : contactOf<polygonShadow>(body, s, piece);
}

} // End anonymous namespace


TEST(wallVisit, findsTheFirstContactThatBruteForceFinds)
{
    const double a = 32e-6;
    const std::vector<convexBody> bodies =
    {
        convexBody::sphere(a),
        convexBody::ellipsoid({a, 0.8*a, 0.8*a}),
        convexBody::ellipsoid({a, 0.3*a, 0.6*a}),
        convexBody::ellipsoid({0.1*a, a, a}),
        convexBody::box({a, 0.8*a, 0.8*a}),
        convexBody::box({a, 0.5*a, 0.2*a}),
        convexBody::truncatedBox({a, 0.6*a, 0.8*a}, 0.25),
        convexBody::polyhedron
        (
            {
                {
                    {0, 0, 0}, {a, 0, 0}, {0.2*a, 0.9*a, 0},
                    {0.3*a, 0.2*a, 0.8*a}
                },
                {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}
            }
        ),
        convexBody::sphere(4*a),
        convexBody::ellipsoid({4*a, 2*a, a}),
        convexBody::box({4*a, 2*a, 3*a})
    };
    // The paper's relief, one with steep flanks, one with narrow pits
    const std::vector<relief> reliefs =
    {
        relief::rough(80e-6, 10e-6, 20e-6),
        relief::rough(40e-6, 10e-6, 40e-6),
        relief::sinusoidal(20e-6, 60e-6),
        relief::flat()
    };
    int found = 0;
    for (std::size_t k = 0; k < bodies.size(); ++k)
    {
        const convexBody& body = bodies[k];
        const std::vector<vector3> points = surfacePoints(body);
        for (std::size_t m = 0; m < reliefs.size(); ++m)
        {
            reliefPiece piece(reliefs[m], 5);
            for (int i = 0; i < 15; ++i)
            {
                counterRandom rnd(1, i, std::uint32_t(100*k + m));
                piece.start(1000*k + i, 20);
                const bodyState s =
                    randomState(rnd, body, i % 3, reliefs[m].top());
                const contactPoint c = firstContact(body, s, piece);
                ASSERT_TRUE(c.found);
                ++found;

                freeRotation rotation(body, s.rotation);
                rotationState r;
                auto stateAt = [&](double t)
                {
                    while (t > rotation.horizon())
                    {
                        const double h = rotation.horizon();
                        rotation.evaluate(h, r);
                        rotation.restart(h, r);
                    }
                    rotation.evaluate(t, r);
                };
                const double fastest =
                    200 + mag(s.rotation.omega)*body.radius();
                const double step = 5e-3*body.radius()/fastest;
                double t = std::max(0., c.time - 400*step);
                for (; t < c.time - 1e-6*step; t += step)
                {
                    stateAt(t);
                    ASSERT_GT(bruteGap(points, s, r, t, piece), 0)
                        << "body " << k << " relief " << m << " run " << i
                        << " at " << t/c.time << " of the time found";
                }
                stateAt(c.time);
                if (body.isSphere())
                {
                    r = s.rotation;     // the search does not turn it
                }
                const double there = bruteGap(points, s, r, c.time, piece);
                EXPECT_GT(there, -1e-9*body.radius());
                // As close as the points are dense, steep flanks included
                EXPECT_LT(there, 0.05*body.radius());
                EXPECT_LT(std::fabs(c.gap), 1e-9*body.radius())
                    << "body " << k << " relief " << m << " run " << i;

                // The point found is a point of the body on the curve
                const double x = s.x + s.V.x*c.time + dot(r.ex, c.r);
                const double y = s.y + s.V.y*c.time + dot(r.ey, c.r);
                EXPECT_NEAR
                (
                    y, piece.height(x), 1e-9*body.radius()
                ) << "body " << k << " relief " << m << " run " << i;
            }
        }
    }
    EXPECT_EQ(found, int(15*bodies.size()*reliefs.size()));
}
