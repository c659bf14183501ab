/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Tests of jkrImpact and overlapRungeKutta.
\*---------------------------------------------------------------------------*/

#include "jkrImpact.H"
#include "overlapRungeKutta.H"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace impact;

namespace
{

// The rebuilt parameters of silica on steel, and of polystyrene on quartz
const double mass = 9.717993e-12;
const jkrContact pair(5e-6, 36.55648e9, mass/2, 0.0607);
const jkrContact wall(10e-6, 50e9, mass, 0.1528);
const double alpha = 1.1891;


impactSettings scheme(impactScheme s)
{
    impactSettings settings;
    settings.scheme = s;
    return settings;
}

} // End anonymous namespace


TEST(jkrImpact, capturesAtTheSpeedsOfTheSource)
{
    EXPECT_NEAR(jkrImpact(pair, alpha).captureSpeed(), 0.394, 0.5e-3);
    EXPECT_NEAR(jkrImpact(wall, alpha).captureSpeed(), 0.86, 0.5e-2);
    EXPECT_NEAR(jkrImpact(pair, 0).captureSpeed(), 0.0146, 1e-4);
    EXPECT_NEAR(jkrImpact(wall, 0).captureSpeed(), 0.0318, 1e-4);

    const double d = 1.27e-6;
    const jkrContact latex(d/2, 3.42734e9, 1050*M_PI/6*d*d*d, 0.06);
    EXPECT_NEAR(jkrImpact(latex, 0.225).captureSpeed(), 1.2, 0.5e-2);
}


TEST(jkrImpact, schemesAgree)
{
    const jkrImpact adaptive(wall, alpha);
    const jkrImpact table(wall, alpha, scheme(impactScheme::table));
    impactSettings fine = scheme(impactScheme::rk4);
    fine.timeStep = 2e-12;
    const jkrImpact rk4(wall, alpha, fine);
    for (double V : {0.5, 0.9, 1.5, 10.})
    {
        const impactOutcome a = adaptive.impact(V);
        const impactOutcome r = rk4.impact(V);
        const impactOutcome t = table.impact(V);
        EXPECT_EQ(a.captured, V < 0.86);
        EXPECT_EQ(r.captured, a.captured);
        EXPECT_EQ(t.captured, a.captured);
        EXPECT_NEAR(r.restitution, a.restitution, 1e-6) << V;
        EXPECT_NEAR(t.restitution, a.restitution, 1e-6) << V;
        EXPECT_NEAR(r.contactTime, a.contactTime, 1e-4*a.contactTime) << V;
        EXPECT_NEAR(r.maxOverlap, a.maxOverlap, 1e-6*a.maxOverlap) << V;
        const normalRebound quick = table.rebound(V);
        EXPECT_EQ(quick.captured, t.captured);
        EXPECT_EQ(quick.restitution, t.restitution);
    }
}


TEST(jkrImpact, schemeOfTheSourceIsOfFirstOrderWithoutInterpolation)
{
    const double V = 1.7;
    const double e = jkrImpact(wall, alpha).impact(V).restitution;
    auto error = [&](double timeStep, bool interpolate)
    {
        // Mean over steps next to each other: where the end falls within a
        // step is a matter of chance
        double sum = 0;
        const int n = 40;
        for (int i = 0; i < n; ++i)
        {
            impactSettings s = scheme(impactScheme::rk4);
            s.timeStep = timeStep*(1 + 0.01*i/n);
            s.interpolate = interpolate;
            sum += std::fabs
            (
                jkrImpact(wall, alpha, s).impact(V).restitution/e - 1
            );
        }
        return sum/n;
    };
    const double plain = error(1e-10, false);
    EXPECT_GT(plain, 3e-4);
    EXPECT_LT(plain, 3e-3);
    EXPECT_NEAR(error(1e-11, false)/plain, 0.1, 0.05);
    EXPECT_LT(error(1e-10, true), 1e-5);
    EXPECT_GT(error(1e-10, true)/error(1e-11, true), 8);
}


TEST(jkrImpact, trajectoryObeysTheEquationOfMotion)
{
    for (double V : {0.4, 2.})
    {
        const jkrImpact impact(wall, alpha);
        const auto path = impact.trajectory(V);
        const double k = 4./3*wall.modulus();
        ASSERT_GT(path.size(), 100u);
        EXPECT_NEAR(path.front().overlap, 0, 1e-20);
        EXPECT_EQ(path.front().velocity, V);
        double work = 0;
        for (std::size_t i = 1; i < path.size(); ++i)
        {
            const impactMoment& a = path[i - 1];
            const impactMoment& b = path[i];
            EXPECT_GT(b.time, a.time);
            const double force = wall.at(b.contactRadius).force
              + alpha*std::sqrt(mass*k*b.contactRadius)*b.velocity;
            EXPECT_NEAR(b.force, force, 1e-9*std::fabs(force) + 1e-15);

            // Hermite rule: exact to the fifth order of the interval
            work += 0.5*(a.force + b.force)*(b.overlap - a.overlap);
        }
        EXPECT_NEAR
        (
            0.5*mass*V*V - work,
            0.5*mass*path.back().velocity*path.back().velocity,
            0.01*(0.5*mass*V*V)
        );
        if (V > impact.captureSpeed())
        {
            EXPECT_NEAR
            (
                path.back().overlap,
                -wall.pullOffOverlap(),
                1e-9*wall.pullOffOverlap()
            );
            EXPECT_NEAR
            (
                -path.back().velocity/V, impact.impact(V).restitution, 1e-12
            );
        }
        else
        {
            EXPECT_NEAR(path.back().overlap, 0.884e-9, 1e-12);
            EXPECT_NEAR(path.back().velocity, 0, 1e-4*V);
        }
    }
}


TEST(jkrImpact, isFiniteFromNanometresToCentimetres)
{
    for (double d : {10e-9, 1e-6, 10e-3})
    {
        for (double w : {0., 1e-30, 1e-6, 0.1, 10.})
        {
            const jkrContact c(d/2, 50e9, 2500*M_PI/6*d*d*d, w);
            for (double a : {0., 1.1891, 2.3})
            {
                const jkrImpact adaptive(c, a);
                const jkrImpact table(c, a, scheme(impactScheme::table));
                EXPECT_GE
                (
                    adaptive.captureSpeed(), (1 - 1e-12)*c.separationSpeed()
                );
                for (double V : {1e-9, 1e-3, 1., 1e3, 1e6})
                {
                    const impactOutcome out = adaptive.impact(V);
                    EXPECT_EQ(out.captured, V <= adaptive.captureSpeed())
                        << d << ' ' << w << ' ' << a << ' ' << V;
                    EXPECT_TRUE(std::isfinite(out.contactTime));
                    EXPECT_GT(out.maxOverlap, 0);
                    EXPECT_TRUE
                    (
                        std::isfinite(adaptive.trajectory(V).back().force)
                    );
                    EXPECT_NEAR
                    (
                        table.rebound(V).restitution, out.restitution, 1e-6
                    );
                }
                if (std::isfinite(adaptive.captureSpeed()) && w > 0)
                {
                    const double V = adaptive.captureSpeed();
                    EXPECT_LT(adaptive.impact(V).restitution, 1e-4);
                    EXPECT_LT(table.impact(V).restitution, 1e-4);
                }
            }
        }
    }
}


TEST(jkrImpact, refusesWhatIsOutOfRange)
{
    const jkrImpact good(wall, alpha);
    EXPECT_THROW(good.impact(0), std::invalid_argument);
    EXPECT_THROW(good.rebound(-1), std::invalid_argument);
    EXPECT_THROW(jkrImpact(wall, -1), std::invalid_argument);
    EXPECT_THROW
    (
        jkrImpact(wall, alpha, scheme(impactScheme::table)).rebound(0),
        std::invalid_argument
    );
    impactSettings s = scheme(impactScheme::rk4);
    for (double timeStep : {1e-6, 1e-20, 0., -1e-10})
    {
        s.timeStep = timeStep;
        EXPECT_THROW
        (
            jkrImpact(wall, alpha, s).impact(1), std::invalid_argument
        );
    }
    EXPECT_THROW
    (
        overlapRungeKutta(1, unloadingType::soft, 0.3, true),
        std::invalid_argument
    );
}
