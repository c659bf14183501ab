/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Two-body motion against the anomalies of ellipse, parabola and
    hyperbola, against straight falls and a numerical integration.
\*---------------------------------------------------------------------------*/

#include "keplerOrbit.H"
#include "counterRandom.H"

#include <gtest/gtest.h>
#include <cmath>
#include <stdexcept>

using namespace impact;

namespace
{

const double mu = 3.986004418e14;

struct state
{
    vector3 r, v;
};


//- On an ellipse, from the eccentric anomaly E
state ellipse(double a, double e, double E)
{
    const double b = a*std::sqrt(1 - e*e);
    const double n = std::sqrt(mu/(a*a*a));
    const double rate = n/(1 - e*std::cos(E));
    return
    {
        {a*(std::cos(E) - e), b*std::sin(E), 0},
        {-a*std::sin(E)*rate, b*std::cos(E)*rate, 0}
    };
}


//- On a hyperbola with the semi-axis a > 0
state hyperbola(double a, double e, double H)
{
    const double b = a*std::sqrt(e*e - 1);
    const double n = std::sqrt(mu/(a*a*a));
    const double rate = n/(e*std::cosh(H) - 1);
    return
    {
        {a*(e - std::cosh(H)), b*std::sinh(H), 0},
        {-a*std::sinh(H)*rate, b*std::cosh(H)*rate, 0}
    };
}


//- On a parabola with the nearest distance q, D = tan(anomaly/2)
state parabola(double q, double D)
{
    const double rate = std::sqrt(mu/(2*q*q*q))/(1 + D*D);
    return {{q*(1 - D*D), 2*q*D, 0}, {-2*q*D*rate, 2*q*rate, 0}};
}


void expectMove
(
    const state& from,
    const state& to,
    double time,
    double tolerance
)
{
    state s(from);
    keplerOrbit(mu).move(s.r, s.v, time);
    EXPECT_LT(mag(s.r - to.r), tolerance*mag(to.r));
    EXPECT_LT(mag(s.v - to.v), tolerance*mag(to.v));
}

} // End anonymous namespace


TEST(keplerOrbit, followsEllipses)
{
    for (double e : {0., 1e-9, 0.1, 0.7, 0.99})
    {
        const double a = 7e6;
        const double n = std::sqrt(mu/(a*a*a));
        for (double E0 : {-3., -0.2, 0., 1., 2.8})
        {
            for (double dE : {-40., -1., -1e-3, 0., 1e-6, 0.3, 3., 6., 90.})
            {
                const double E1 = E0 + dE;
                const double time =
                    (dE - 2*e*std::sin(0.5*dE)*std::cos(0.5*(E0 + E1)))/n;

                // Rounding of 15 periods moves a body at the pericentre
                expectMove
                (
                    ellipse(a, e, E0), ellipse(a, e, E1), time,
                    e > 0.9 ? 2e-10 : 2e-11
                );
            }
        }
    }
}


TEST(keplerOrbit, followsHyperbolas)
{
    for (double e : {1.01, 2., 30.})
    {
        const double a = 8e6;
        const double n = std::sqrt(mu/(a*a*a));
        for (double H0 : {-4., 0., 2.})
        {
            for (double H1 : {-5., -0.1, 0., 0.5, 6.})
            {
                const double time =
                    (e*(std::sinh(H1) - std::sinh(H0)) - (H1 - H0))/n;
                expectMove
                (
                    hyperbola(a, e, H0), hyperbola(a, e, H1), time, 2e-10
                );
            }
        }
    }
}


TEST(keplerOrbit, followsParabolas)
{
    const double q = 6.6e6;
    for (double D0 : {-3., 0., 0.7})
    {
        for (double D1 : {-10., -0.5, 0., 1., 20.})
        {
            const double time = std::sqrt(2*q*q*q/mu)
               *(D1 - D0 + (D1*D1*D1 - D0*D0*D0)/3);
            expectMove(parabola(q, D0), parabola(q, D1), time, 2e-10);
        }
    }
}


TEST(keplerOrbit, fallsStraight)
{
    // From rest at r0: t = sqrt(r0^3/(8 mu)) (eta + sin eta),
    // r = r0 cos^2(eta/2)
    const double r0 = 7e6;
    for (double eta : {1e-3, 0.5, 2.})
    {
        state s = {{0, r0, 0}, {0, 0, 0}};
        keplerOrbit(mu).move
        (
            s.r, s.v,
            std::sqrt(r0*r0*r0/(8*mu))*(eta + std::sin(eta))
        );
        const double c = std::cos(0.5*eta);
        EXPECT_NEAR(s.r.y, r0*c*c, 1e-11*r0);
        EXPECT_LT(s.v.y, 0);
        EXPECT_EQ(s.r.x, 0);
    }

    // For a short time: g t^2/2 down
    state s = {{0, r0, 0}, {0, 0, 0}};
    keplerOrbit(mu).move(s.r, s.v, 1);
    EXPECT_NEAR(r0 - s.r.y, 0.5*mu/(r0*r0), 1e-6);
}


TEST(keplerOrbit, agreesWithANumericalIntegration)
{
    counterRandom rnd(3);
    for (int k = 0; k < 50; ++k)
    {
        state s =
        {
            {7e6*rnd.normal(), 7e6*rnd.normal(), 7e6*(1 + rnd.uniform())},
            {8e3*rnd.normal(), 8e3*rnd.normal(), 8e3*rnd.normal()}
        };
        state kepler(s);
        const double time = 500;
        keplerOrbit(mu).move(kepler.r, kepler.v, time);
        const int n = 20000;
        const double h = time/n;
        auto pull = [](const vector3& r)
        {
            const double d = mag(r);
            return (-mu/(d*d*d))*r;
        };
        for (int i = 0; i < n; ++i)
        {
            const vector3 a1 = pull(s.r);
            const vector3 v2 = s.v + 0.5*h*a1;
            const vector3 a2 = pull(s.r + 0.5*h*s.v);
            const vector3 v3 = s.v + 0.5*h*a2;
            const vector3 a3 = pull(s.r + 0.5*h*v2);
            const vector3 v4 = s.v + h*a3;
            const vector3 a4 = pull(s.r + h*v3);
            s.r = s.r + (h/6)*(s.v + 2.*v2 + 2.*v3 + v4);
            s.v = s.v + (h/6)*(a1 + 2.*a2 + 2.*a3 + a4);
        }
        EXPECT_LT(mag(s.r - kepler.r), 1e-10*mag(s.r));
        EXPECT_LT(mag(s.v - kepler.v), 1e-10*mag(s.v));
    }
}


TEST(keplerOrbit, comesBack)
{
    counterRandom rnd(4);
    for (int k = 0; k < 2000; ++k)
    {
        const state from =
        {
            {7e6*rnd.normal(), 7e6*rnd.normal(), 7e6*rnd.normal()},
            {6e3*rnd.normal(), 6e3*rnd.normal(), 6e3*rnd.normal()}
        };
        const double time = 1e5*rnd.uniform();
        state s(from);
        const keplerOrbit orbit(mu);
        orbit.move(s.r, s.v, time);
        const double energy = 0.5*dot(s.v, s.v) - mu/mag(s.r);
        const double before = 0.5*dot(from.v, from.v) - mu/mag(from.r);
        EXPECT_NEAR(energy, before, 1e-9*mu/std::min(mag(s.r), mag(from.r)));
        orbit.move(s.r, s.v, -time);
        EXPECT_LT(mag(s.r - from.r), 1e-6*mag(from.r));
    }
}


TEST(keplerOrbit, refusesNoMass)
{
    EXPECT_THROW(keplerOrbit(0), std::invalid_argument);
    EXPECT_THROW(keplerOrbit(-1), std::invalid_argument);
}
