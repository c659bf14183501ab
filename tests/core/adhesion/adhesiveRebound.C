/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Tests of adhesiveRebound.
\*---------------------------------------------------------------------------*/

#include "adhesiveRebound.H"
#include "jkrImpact.H"

#include <gtest/gtest.h>

#include <algorithm>

using namespace impact;

namespace
{

typedef adhesiveRebound::sphere sphere;

const adhesiveRebound::materials steel = {50e9, 0.1528};
const adhesiveRebound::materials silica = {36.55648e9, 0.0607};
const sphere grain = {20e-6, 2320};
const vector3 n = {0, 1, 0};


adhesiveRebound wall(double alpha = 1.1891, double friction = 0.3)
{
    return adhesiveRebound
    (
        steel, lawCurve(dissipationLaw::constant(alpha)), friction
    );
}


double massOf(const sphere& s)
{
    return M_PI/6*s.density*s.diameter*s.diameter*s.diameter;
}


double energy(const sphere& p, const sphereState& s)
{
    return massOf(p)
       *(
            translationalEnergy(s.V)
          + sphereRotationalEnergy(0.5*p.diameter, s.omega)
        );
}


//- Angular momentum about a point that P1 is r above
vector3 angularAbout(const sphere& p, double r, const sphereState& s)
{
    return massOf(p)
       *(
            cross(r*n, s.V)
          + sphereInertia(0.5*p.diameter)*s.omega
        );
}

} // End anonymous namespace


TEST(adhesiveRebound, isThatOfTheSingleContactForAllSizes)
{
    impactSettings settings;
    settings.scheme = impactScheme::adaptive;
    for (double alpha : {0., 0.5, 1.1891})
    {
        const adhesiveRebound law = wall(alpha);
        for (const sphere& s : {grain, sphere{1e-8, 1000}, sphere{5e-7, 8000},
            sphere{1e-2, 2000}})
        {
            const jkrImpact one
            (
                jkrContact
                (
                    0.5*s.diameter, steel.modulus, massOf(s),
                    steel.workOfAdhesion
                ),
                alpha, settings
            );
            const double V = one.captureSpeed();
            EXPECT_NEAR(law.captureSpeed(s)/V, 1, 1e-11);
            for (double times : {0.5, 0.999, 1.001, 1.5, 30.})
            {
                const auto a = law.restitution(s, times*V);
                const auto b = one.rebound(times*V);
                EXPECT_EQ(a.captured, b.captured);
                EXPECT_NEAR(a.restitution, b.restitution, 1e-6);
            }
        }
    }
    EXPECT_NEAR(wall().captureSpeed(grain), 0.86, 0.005);
}


TEST(adhesiveRebound, overlapIsThatOfTheContactWhereAdhesionIsSmall)
{
    const adhesiveRebound law = wall();
    impactSettings settings;
    settings.scheme = impactScheme::adaptive;
    const jkrImpact one
    (
        jkrContact
        (
            0.5*grain.diameter, steel.modulus, massOf(grain), 1e-6
        ),
        0, settings
    );
    for (double V : {3., 30., 300.})
    {
        const double deepest = one.impact(V).maxOverlap;
        EXPECT_NEAR
        (
            law.overlapShare(grain, V)/(deepest/(0.5*grain.diameter)), 1, 2e-3
        );
    }
}


TEST(adhesiveRebound, oblique)
{
    const adhesiveRebound law = wall();
    const sphereState before = {{2, -3, 1}, {1e4, 2e5, -3e4}};
    sphereState s = before;
    const auto out = law.rebound(n, grain, s);
    ASSERT_FALSE(out.captured);
    EXPECT_DOUBLE_EQ
    (
        s.V.y, 3*law.restitution(grain, 3).restitution
    );
    EXPECT_LT(energy(grain, s), energy(grain, before));
    const vector3 about0 = angularAbout(grain, 10e-6, before);
    const vector3 about1 = angularAbout(grain, 10e-6, s);
    EXPECT_NEAR(about1.x, about0.x, 1e-13*mag(about0));
    EXPECT_NEAR(about1.z, about0.z, 1e-13*mag(about0));

    // Too slow along the normal, however fast along the wall
    s = {{50, -0.85, 0}, {0, 0, 1e6}};
    const double V = -s.V.y;
    const auto stays = law.rebound(n, grain, s);
    EXPECT_TRUE(stays.captured);
    EXPECT_EQ(stays.overlap, law.overlapShare(grain, V));
    EXPECT_EQ(mag(s.V) + mag(s.omega), 0);

    // Sliding and sticking
    s = {{50, -3, 0}, {0, 0, 0}};
    EXPECT_TRUE(law.rebound(n, grain, s).slides);
    s = {{0.1, -3, 0}, {0, 0, 0}};
    EXPECT_FALSE(law.rebound(n, grain, s).slides);
    EXPECT_LT(mag(contactVelocity(n, 10e-6, s) - s.V.y*n), 1e-14);
}


TEST(adhesiveRebound, onAnAdheredParticle)
{
    for (auto coupling : {chainCoupling::twoWay, chainCoupling::oneWay})
    {
        adhesiveRebound law = wall();
        EXPECT_FALSE(law.hasLayer());
        law.setLayer({silica, 1.1891, 1.1891, coupling});
        EXPECT_TRUE(law.hasLayer());
        const bool both = coupling == chainCoupling::twoWay;

        // The thresholds of physics page 3.4 for this set of constants
        const double captures = both ? 0.0891 : 0.394;
        const double detaches = both ? 0.6255 : 0.780;
        for (double V : {0.98*captures, 1.02*captures, 0.99*detaches,
            1.01*detaches, 5.})
        {
            sphereState s = {{0, -V, 0}, {0, 0, 0}}, s2;
            const auto out = law.rebound(n, grain, s, grain, s2);
            const chainOutcome normal = law.chain(grain, grain).impact(V);
            const double r = 0.5*grain.diameter;
            EXPECT_DOUBLE_EQ
            (
                out.overlap,
                std::max(2*normal.maxOverlap1/r, normal.maxOverlap2/r)
            );
            EXPECT_TRUE(out.decided);
            EXPECT_EQ(out.captured, V < captures) << V;
            EXPECT_EQ(out.detached, V > detaches) << V;
            EXPECT_EQ(s.V.y > 0, !out.captured);
            EXPECT_EQ(s2.V.y > 0, out.detached);
        }
    }
}


TEST(adhesiveRebound, keepsMomentumAndLosesEnergy)
{
    const sphere second = {14e-6, 2600};
    for (double alpha : {0.1, 1.1891})
    {
        adhesiveRebound law = wall(alpha, 0.3);
        law.setLayer({silica, alpha, alpha});
        int detached = 0, free = 0;
        for (double V = 0.02; V < 200; V *= 1.5)
        {
            for (double Vt : {0., 0.3, 3., 100.})
            {
                const sphereState before = {{Vt, -V, 0.5*Vt}, {1e4, 3e4, 0}};
                sphereState s = before, s2;
                const auto out = law.rebound(n, grain, s, second, s2);
                const double all = energy(grain, before);
                EXPECT_LT
                (
                    energy(grain, s) + energy(second, s2), all*(1 + 1e-12)
                );
                EXPECT_GE(s.V.y, 0);
                if (!out.detached || out.captured)
                {
                    EXPECT_EQ
                    (
                        mag(s2.V) == 0 && mag(s2.omega) == 0, !out.detached
                    );
                    free += !out.captured;
                    continue;
                }
                ++detached;
                const vector3 p =
                    massOf(grain)*(s.V - before.V) + massOf(second)*s2.V;
                const double unit = massOf(grain)*mag(before.V);
                EXPECT_LT(std::hypot(p.x, p.z), 1e-14*unit);

                // About the point where they touch: P1 above, P2 below
                const vector3 L =
                    angularAbout(grain, 10e-6, s)
                  - angularAbout(grain, 10e-6, before)
                  + angularAbout(second, -7e-6, s2);
                EXPECT_LT(std::hypot(L.x, L.z), 1e-13*unit*10e-6);
                if (!out.slides)
                {
                    const vector3 slip =
                        contactVelocity(n, 10e-6, s)
                      - contactVelocity(-1*n, 7e-6, s2);
                    EXPECT_LT(mag(slip - dot(slip, n)*n), 1e-13*mag(before.V));
                }
            }
        }
        EXPECT_GT(detached, 20);
        EXPECT_GT(free, 5);
    }
}


TEST(adhesiveRebound, allSizesOnAllSizes)
{
    adhesiveRebound law = wall(0.2);
    for (auto coupling : {chainCoupling::twoWay, chainCoupling::oneWay})
    {
        law.setLayer({silica, 0.2, 0.2, coupling});
        for (double ratio : {0.05, 0.5, 1., 3., 20.})
        {
            for (double V = 1e-3; V < 100; V *= 2)
            {
                sphereState s = {{0.1, -V, 0}, {0, 0, 0}}, s2;
                const auto out = law.rebound
                (
                    n, {20e-6*ratio, 2320}, s, grain, s2
                );
                EXPECT_TRUE(out.decided);

                // Nothing that leaves goes into the wall
                EXPECT_TRUE(out.captured ? mag(s.V) == 0 : s.V.y > 0);
                EXPECT_TRUE(out.detached ? s2.V.y > 0 : mag(s2.V) == 0);
                EXPECT_TRUE(std::isfinite(s.V.y + s2.V.y + mag(s2.omega)));
            }
        }
    }
}


TEST(adhesiveRebound, extremes)
{
    for (double alpha : {0., 1e-6, 0.5, 2., 3.})
    {
        for (double w : {1e-12, 0.15, 1e3})
        {
            adhesiveRebound law
            (
                {50e9, w}, lawCurve(dissipationLaw::constant(alpha)), 0.3
            );
            law.setLayer({{36e9, w}, alpha, alpha});
            for (double d : {1e-8, 2e-5, 1e-2})
            {
                const sphere p = {d, 2500};
                const double unit = law.separationSpeed(p);
                for (double q : {1e-9, 1e-3, 1., 1e3, 1e9})
                {
                    const sphereState before =
                        {{q*unit, -q*unit, 0}, {0, 0, q*unit/d}};
                    sphereState s = before, s2 = {};
                    auto out = law.rebound(n, p, s);
                    EXPECT_EQ(out.captured, !(q*unit > law.captureSpeed(p)));
                    EXPECT_LE(energy(p, s), energy(p, before));
                    EXPECT_TRUE(std::isfinite(mag(s.V) + mag(s.omega)));

                    s = before;
                    out = law.rebound(n, p, s, {0.5*d, 2000}, s2);
                    EXPECT_TRUE(out.captured || s.V.y > 0);
                    EXPECT_TRUE(std::isfinite(mag(s.V) + mag(s.omega)));
                    EXPECT_TRUE(std::isfinite(mag(s2.V) + mag(s2.omega)));
                    EXPECT_LE
                    (
                        energy(p, s) + energy({0.5*d, 2000}, s2),
                        energy(p, before)*(1 + 1e-9)
                    );
                }
            }
        }
    }
}


TEST(adhesiveRebound, refuses)
{
    const lawCurve curve(dissipationLaw::constant(1));
    EXPECT_THROW(adhesiveRebound({0, 0.1}, curve, 0.3), std::invalid_argument);
    EXPECT_THROW(adhesiveRebound({1e9, 0}, curve, 0.3), std::invalid_argument);
    EXPECT_THROW(adhesiveRebound({1e9, 1}, curve, -1), std::invalid_argument);
    adhesiveRebound law({1e9, 0.1}, curve, 0.3);
    EXPECT_THROW(law.setLayer({{-1, 0.1}, 1, 1}), std::invalid_argument);
    EXPECT_THROW(law.setLayer({{1e9, 0.1}, 11, 1}), std::invalid_argument);
    EXPECT_THROW(law.setLayer({{1e9, 0.1}, 1, -1}), std::invalid_argument);
}


TEST(adhesiveRebound, aLayerTakesAlphaAtTheSpeedOfArrival)
{
    adhesiveRebound byTable = wall(), byNumbers = wall();
    byTable.setLayer
    (
        {silica, chainAlpha({0.5, 1.5}, {1.2, 0.8}), chainAlpha({1}, {0.9})}
    );
    int differ = 0;
    for (const double V : {0.2, 0.75, 1., 1.5, 4.})
    {
        const double alpha = V < 0.5 ? 1.2 : V > 1.5 ? 0.8 : 1.4 - 0.4*V;
        byNumbers.setLayer({silica, alpha, 0.9});
        sphereState a = {{0.3, -V, 0}, {0, 0, 0}}, a2, b = a, b2;
        const auto x = byTable.rebound(n, grain, a, grain, a2);
        const auto y = byNumbers.rebound(n, grain, b, grain, b2);
        EXPECT_EQ(x.captured, y.captured) << V;
        EXPECT_EQ(x.detached, y.detached) << V;
        EXPECT_LT(mag(a.V - b.V) + mag(a2.V - b2.V), 1e-7*V) << V;

        byNumbers.setLayer({silica, 1.0, 0.9});
        sphereState c = {{0.3, -V, 0}, {0, 0, 0}}, c2;
        byNumbers.rebound(n, grain, c, grain, c2);
        differ += mag(a.V - c.V) + mag(a2.V - c2.V) > 1e-3*V;
    }
    EXPECT_GE(differ, 3);
}
