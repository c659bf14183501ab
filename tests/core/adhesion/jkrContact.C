/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Tests of jkrCurve and jkrContact.
\*---------------------------------------------------------------------------*/

#include "jkrContact.H"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

using namespace impact;

namespace
{

// The rebuilt parameters of the silica particle and the steel wall
const double mass = 9.717993e-12;
const jkrContact pair(5e-6, 36.55648e9, mass/2, 0.0607);
const jkrContact wall(10e-6, 50e9, mass, 0.1528);

} // End anonymous namespace


TEST(jkrContact, hasThePointsOfTheSource)
{
    EXPECT_NEAR(pair.lastTouch().overlap, -0.386e-9, 0.5e-12);
    EXPECT_NEAR(wall.lastTouch().overlap, -0.73e-9, 0.5e-11);
    EXPECT_NEAR(wall.equilibrium().overlap, 0.884e-9, 0.5e-12);

    // What sticks at 0.014 m/s does so below v_st
    EXPECT_GT(pair.separationSpeed(), 0.014);
    EXPECT_LT(pair.separationSpeed(), 0.015);
    EXPECT_NEAR(wall.separationSpeed(), 0.032, 0.5e-3);
}


TEST(jkrContact, agreesWithTheDimensionalFormulae)
{
    // delta(a) and F(a) of Johnson, Kendall & Roberts as they stand
    for (const jkrContact& c : {pair, wall})
    {
        const double R = c.radius(), E = c.modulus(), w = c.workOfAdhesion();
        for (double x : {0.31, 0.5, 1., 3., 40.})
        {
            const double a = x*c.equilibriumRadius();
            const double overlap = a*a/R - std::sqrt(2*M_PI*w*a/E);
            const double force =
                4*E*a*a*a/(3*R) - std::sqrt(8*M_PI*w*E*a*a*a);
            EXPECT_NEAR
            (
                c.at(a).overlap, overlap, 1e-13*(a*a/R + std::fabs(overlap))
            );
            EXPECT_NEAR
            (
                c.at(a).force,
                force,
                1e-13*(4*E*a*a*a/(3*R) + std::fabs(force))
            );
        }
    }
}


TEST(jkrContact, hasTheUniversalPoints)
{
    const double F = wall.pullOffForce(), d = wall.pullOffOverlap();
    const double a0 = wall.equilibriumRadius();
    EXPECT_NEAR(d, a0*a0/(2*std::cbrt(6.)*wall.radius()), 1e-13*d);
    EXPECT_NEAR(wall.firstTouch().overlap, 0, 1e-14*d);
    EXPECT_NEAR(wall.firstTouch().force, -8./9*F, 1e-13*F);
    EXPECT_NEAR(wall.equilibrium().force, 0, 1e-13*F);
    EXPECT_NEAR(wall.equilibrium().overlap, 1.211414*d, 1e-6*d);
    EXPECT_NEAR(wall.pullOff().force, -F, 1e-13*F);
    EXPECT_NEAR(wall.pullOff().overlap, -0.480750*d, 1e-6*d);
    EXPECT_NEAR(wall.lastTouch().force, -5./9*F, 1e-13*F);
}


TEST(jkrContact, separationWorkIsTheIntegralOfTheForce)
{
    for (const jkrContact& c : {pair, wall})
    {
        // Simpson's rule in the contact radius with the formulae in SI
        const double R = c.radius(), E = c.modulus(), w = c.workOfAdhesion();
        const double a0 = c.equilibriumRadius();
        const double from = a0*std::pow(2./3, 2./3);
        auto integral = [&](double to)
        {
            auto f = [&](double a)
            {
                const double force =
                    4*E*a*a*a/(3*R) - std::sqrt(8*M_PI*w*E*a*a*a);
                return force*(2*a/R - std::sqrt(0.5*M_PI*w/(E*a)));
            };
            const int n = 2000;
            const double h = (to - from)/n;
            double sum = f(from) + f(to);
            for (int i = 1; i < n; ++i)
            {
                sum += (i % 2 ? 4 : 2)*f(from + i*h);
            }
            return sum*h/3;
        };
        const double soft = c.separationWork();
        const double hard = c.separationWork(unloadingType::hard);
        EXPECT_NEAR
        (
            soft, integral(a0*std::pow(1./6, 2./3)), 1e-10*soft
        );
        EXPECT_NEAR
        (
            hard, integral(a0*std::pow(0.5, 2./3)), 1e-10*hard
        );

        const double unit = c.pullOffForce()*c.pullOffOverlap();
        EXPECT_NEAR(soft, 0.935502783*unit, 1e-9*unit);
        EXPECT_NEAR(hard, 0.462014009*unit, 1e-9*unit);
        EXPECT_NEAR
        (
            soft,
            7.0922*std::cbrt(std::pow(w, 5)*std::pow(R, 4)/(E*E)),
            1e-5*soft
        );
        EXPECT_NEAR
        (
            c.separationSpeed(unloadingType::hard)/c.separationSpeed(),
            0.7028,
            5e-5
        );
    }
}


TEST(jkrContact, followsFromMaterials)
{
    // Effective quantities of a sphere on a wall and of unequal spheres
    const elasticSphere glass = {20e-6, 2320, {70e9, 0.2}};
    const elasticSphere grain = {5e-6, 2650, {90e9, 0.17}};
    const elasticSolid steel = {210e9, 0.3};
    const jkrContact a = jkrContact::onWall(glass, steel, 0.1);
    EXPECT_NEAR(a.radius(), 10e-6, 1e-20);
    EXPECT_NEAR(a.mass(), mass, 1e-6*mass);
    EXPECT_NEAR(1/a.modulus(), 0.96/70e9 + 0.91/210e9, 1e-24);

    const jkrContact b = jkrContact::between(glass, grain, 0.1);
    EXPECT_NEAR(1/b.radius(), 1/10e-6 + 1/2.5e-6, 1e-6);
    EXPECT_NEAR(1/b.mass(), 1/glass.mass() + 1/grain.mass(), 1e-3);
    EXPECT_NEAR
    (
        1/b.modulus(), 0.96/70e9 + (1 - 0.17*0.17)/90e9, 1e-24
    );
}


TEST(jkrContact, invertsTheOverlapAtAnyScale)
{
    for (double beta : {0., 1e-12, 1e-3, 2./3})
    {
        const jkrCurve curve(beta);
        for (double x = 1e-9; x < 1e9; x *= 3.7)
        {
            const double u = curve.uS() + x;
            EXPECT_NEAR(curve.uOf(curve.overlap(u)), u, 1e-7*u);
        }
        EXPECT_EQ(curve.uOf(-1e300), curve.uS());
    }
}


TEST(jkrContact, isThatOfHertzWithoutAdhesion)
{
    const jkrContact c(1e-6, 1e9, 1e-15, 0);
    EXPECT_EQ(c.separationSpeed(), 0);
    EXPECT_EQ(c.pullOffForce(), 0);
    const double overlap = 1e-9;
    const double a = std::sqrt(overlap*1e-6);
    EXPECT_NEAR(c.at(a).overlap, overlap, 1e-12*overlap);
    EXPECT_NEAR
    (
        c.at(a).force, 4./3*1e9*std::sqrt(1e-6)*std::pow(overlap, 1.5), 1e-20
    );
}


TEST(jkrContact, refusesWhatIsOutOfRange)
{
    const double inf = std::numeric_limits<double>::infinity();
    EXPECT_THROW(jkrContact(0, 1, 1, 1), std::invalid_argument);
    EXPECT_THROW(jkrContact(1, -1, 1, 1), std::invalid_argument);
    EXPECT_THROW(jkrContact(1, 1, 0, 1), std::invalid_argument);
    EXPECT_THROW(jkrContact(1, 1, 1, -1e-9), std::invalid_argument);
    EXPECT_THROW(jkrContact(inf, 1, 1, 1), std::invalid_argument);
    const elasticSolid solid = {1e9, 0.3};
    for (double nu : {-1., 0.5, 0.7})
    {
        EXPECT_THROW
        (
            jkrContact::onWall({1e-6, 1000, {1e9, nu}}, solid, 0.1),
            std::invalid_argument
        );
    }
    EXPECT_THROW
    (
        jkrContact::onWall({-1e-6, 1000, solid}, solid, 0.1),
        std::invalid_argument
    );
    EXPECT_THROW
    (
        jkrContact::between
        (
            {1e-6, 1000, solid}, {1e-6, 0, solid}, 0.1
        ),
        std::invalid_argument
    );
}
