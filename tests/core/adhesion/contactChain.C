/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Tests of contactChain.
\*---------------------------------------------------------------------------*/

#include "contactChain.H"
#include "jkrImpact.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace impact;

namespace
{

typedef contactChain::event event;

const double mass = 9.717993e-12;
const double alpha = 1.1891;
const jkrContact pair(5e-6, 36.55648e9, mass/2, 0.0607);
const jkrContact wall(10e-6, 50e9, mass, 0.1528);


contactChain chain(chainCoupling coupling, double a = alpha, double aw = alpha)
{
    return contactChain(pair, a, wall, aw, coupling);
}


//- P1 and P2 by small Runge-Kutta steps in time and SI units, until both have
//  left or the time is up
struct plainChain
{
    bool oneWay;
    double a1, a2;
    double v1 = 0, v2 = 0;
    bool left1 = false, left2 = false;

    static double force
    (
        const jkrContact& c,
        double a,
        double overlap,
        double speed
    )
    {
        const jkrContact::units unit = c.scales(0);
        const double u = unit.curve.uOf(overlap/unit.length);
        const double r = unit.radius*u*u;
        return c.at(r).force
          + a*std::sqrt(c.mass()*4./3*c.modulus()*r)*speed;
    }

    void run(double V, double dt, double endTime)
    {
        double y[4] = {0, V, wall.equilibrium().overlap, 0};
        auto rate = [&](const double* s, double* r)
        {
            const double F1 = left1 ? 0 : force(pair, a1, s[0], s[1]);
            const double F2 = left2 ? 0 : force(wall, a2, s[2], s[3]);
            r[0] = s[1];
            r[2] = s[3];
            r[3] = (F1 - F2)/mass;
            r[1] = oneWay ? -F1/pair.mass() : -F1/mass - r[3];
        };
        for (double t = 0; t < endTime; t += dt)
        {
            double k1[4], k2[4], k3[4], k4[4], z[4];
            rate(y, k1);
            for (int i = 0; i < 4; ++i) z[i] = y[i] + 0.5*dt*k1[i];
            rate(z, k2);
            for (int i = 0; i < 4; ++i) z[i] = y[i] + 0.5*dt*k2[i];
            rate(z, k3);
            for (int i = 0; i < 4; ++i) z[i] = y[i] + dt*k3[i];
            rate(z, k4);
            for (int i = 0; i < 4; ++i)
            {
                y[i] += dt/6*(k1[i] + 2*k2[i] + 2*k3[i] + k4[i]);
            }
            if (!left1 && y[0] <= -pair.pullOffOverlap() && y[1] < 0)
            {
                left1 = true;
                v1 = -(oneWay ? y[1] : y[1] + y[3]);
            }
            if (!left2 && y[2] <= -wall.pullOffOverlap() && y[3] < 0)
            {
                left2 = true;
                v2 = -y[3];
            }
        }
    }
};

} // End anonymous namespace


TEST(contactChain, hasTheThresholdsOfTheEquations)
{
    const contactChain one = chain(chainCoupling::oneWay);
    EXPECT_NEAR(one.threshold(event::firstRebounds, 0.1, 2), 0.394, 5e-4);
    EXPECT_NEAR(one.threshold(event::secondDetaches, 0.1, 2), 0.780, 5e-4);
    EXPECT_NEAR
    (
        chain(chainCoupling::oneWay, alpha, 1.147).threshold
            (event::secondDetaches, 0.1, 2),
        0.695,
        1e-3
    );
    const contactChain two = chain(chainCoupling::twoWay);
    EXPECT_NEAR(two.threshold(event::firstRebounds, 0.02, 2), 0.0891, 5e-5);
    EXPECT_NEAR(two.threshold(event::secondDetaches, 0.1, 2), 0.6255, 5e-5);
}


TEST(contactChain, agreesWithAPlainIntegration)
{
    for (chainCoupling coupling :
        {chainCoupling::oneWay, chainCoupling::twoWay})
    {
        const contactChain c = chain(coupling);
        for (double V : {0.3, 0.5, 0.9, 2.})
        {
            const chainOutcome out = c.impact(V);
            plainChain plain = {coupling == chainCoupling::oneWay,
                alpha, alpha};
            plain.run(V, 2e-12, 4e-7);
            EXPECT_EQ(out.firstCaptured, !plain.left1) << V;
            EXPECT_EQ(out.secondDetached, plain.left2) << V;
            EXPECT_NEAR(out.firstSpeed, plain.v1, 1e-4*V) << V;
            EXPECT_NEAR(out.secondSpeed, plain.v2, 1e-3*V) << V;
            EXPECT_TRUE(out.decided);
        }
    }
}


TEST(contactChain, firstParticleOfOneWayIsAFreePair)
{
    const contactChain c = chain(chainCoupling::oneWay);
    const jkrImpact alone(pair, alpha);
    for (double V : {0.2, 0.41, 0.7, 3., 50.})
    {
        const chainOutcome out = c.impact(V);
        const impactOutcome free = alone.impact(V);
        EXPECT_EQ(out.firstCaptured, free.captured);
        EXPECT_NEAR(out.firstSpeed, V*free.restitution, 1e-8*V);
        EXPECT_NEAR(out.maxOverlap1, free.maxOverlap, 1e-7*free.maxOverlap);
    }
}


TEST(contactChain, secondParticleThatStaysEndsWhereItBegan)
{
    for (chainCoupling coupling :
        {chainCoupling::oneWay, chainCoupling::twoWay})
    {
        const contactChain c = chain(coupling);
        for (double V : {0.01, 0.05, 0.3, 0.6})
        {
            EXPECT_FALSE(c.impact(V).secondDetached);
            const auto path = c.trajectory(V);
            EXPECT_NEAR(path.front().overlap2, 0.884e-9, 1e-12);
            EXPECT_NEAR
            (
                path.back().overlap2, path.front().overlap2, 2e-13
            ) << V;
            EXPECT_NEAR(path.back().velocity2, 0, 1e-4*V + 1e-5);
        }
    }
}


TEST(contactChain, twoWayConservesMomentumAndEnergy)
{
    // Without damping, in free flight after both have left
    const contactChain c = chain(chainCoupling::twoWay, 0, 0);
    for (double V : {0.2, 1., 5.})
    {
        const chainOutcome out = c.impact(V);
        if (out.secondDetached && !out.firstCaptured)
        {
            // P2 leaves the wall from its equilibrium, not from A
            const double before = 0.5*mass*V*V;
            const double after = 0.5*mass
               *(
                    out.firstSpeed*out.firstSpeed
                  + out.secondSpeed*out.secondSpeed
                );
            const jkrContact::units unit = wall.scales(0);
            const double release = unit.energy
               *(
                    unit.curve.energy(unit.curve.uS())
                  - unit.curve.energy(unit.curve.uB())
                );
            EXPECT_NEAR
            (
                after, before - pair.separationWork() - release, 1e-8*before
            );
        }
    }
    EXPECT_TRUE(c.impact(5).secondDetached);
}


TEST(contactChain, isFiniteAndDecidedAtExtremes)
{
    const jkrContact small(1e-9, 50e9, 1e-22, 0.1);
    const jkrContact below(5e-9, 50e9, 1e-20, 0.1);
    for (chainCoupling coupling :
        {chainCoupling::oneWay, chainCoupling::twoWay})
    {
        for (double a : {0., 0.5, 2., 3.})
        {
            for (double V = 1e-6; V < 2e4; V *= 10)
            {
                const chainOutcome out = chain(coupling, a, a).impact(V);
                EXPECT_TRUE(std::isfinite(out.firstSpeed));
                EXPECT_TRUE(std::isfinite(out.secondSpeed));
                EXPECT_GE(out.maxOverlap1, 0);
                EXPECT_GE(out.maxOverlap2, 0.88e-9);
                if (a > 0)
                {
                    EXPECT_TRUE(out.decided) << a << ' ' << V;
                }
                const chainOutcome light =
                    contactChain(small, a, below, a, coupling).impact(V);
                EXPECT_TRUE(std::isfinite(light.firstSpeed));
            }
        }
    }
}


TEST(contactChain, heavyParticleLeavesALightOne)
{
    // P2 hardly brakes it: as two springs of Hertz in series
    const double r2 = 0.5e-6, rho = 2500;
    const double m2 = rho*4./3*M_PI*r2*r2*r2;
    const jkrContact below(r2, 5e10, m2, 0.15);
    for (double ratio : {1e2, 3e2, 1e3, 1e4})
    {
        const double m1 = m2*ratio*ratio*ratio;
        const jkrContact above
        (
            r2*ratio/(1 + ratio), 3.6e10, m1*m2/(m1 + m2), 0.06
        );
        const contactChain c(above, 0.5, below, 0.5, chainCoupling::twoWay);
        auto stiffness = [](const jkrContact& x)
        {
            return 4./3*x.modulus()*std::sqrt(x.radius());
        };
        const double k1 = stiffness(above), k2 = stiffness(below);
        const double soft = std::pow(k1, -2./3) + std::pow(k2, -2./3);
        for (double V : ratio > 5e3
            ? std::vector<double>{10} : std::vector<double>{10, 100})
        {
            const chainOutcome out = c.impact(V);
            EXPECT_TRUE(out.decided);
            EXPECT_FALSE(out.firstCaptured);
            EXPECT_NEAR
            (
                (1 - out.firstSpeed/V)*ratio*std::sqrt(ratio), 0.5, 0.003
            );
            const double force = std::pow(1.25*m1*V*V/soft, 0.6);
            const double d1 = std::pow(force/k1, 2./3);
            const double d2 = std::pow(force/k2, 2./3);
            EXPECT_NEAR(out.maxOverlap1, d1, 5e-3*d1);
            EXPECT_NEAR(out.maxOverlap2, d2, 5e-3*d2);

            // P2 follows quietly until the end, whatever squeezed it
            EXPECT_TRUE(out.secondDetached);
            EXPECT_NEAR(out.secondSpeed/V, V > 50 ? 0.456 : 0.440, 2e-3);
        }
    }
}


TEST(contactChain, pairThatFliesOffSharesItsMomentum)
{
    // Impacts end before the pair has stopped swinging
    for (chainCoupling coupling :
        {chainCoupling::oneWay, chainCoupling::twoWay})
    {
        const contactChain c
        (
            jkrContact(5e-6, 36e9, mass/2, 0.3), 0.3,
            jkrContact(10e-6, 50e9, mass, 0.005), 0.3, coupling
        );
        for (double V : {0.05, 0.1})
        {
            const chainOutcome out = c.impact(V);
            EXPECT_TRUE(out.firstCaptured && out.secondDetached);
            EXPECT_EQ(out.firstSpeed, out.secondSpeed);
            EXPECT_NEAR
            (
                out.firstSpeed, -c.trajectory(V).back().velocity2, 1e-3*V
            );
        }
    }
}


TEST(contactChain, refusesWhatIsOutOfRange)
{
    const chainCoupling coupling = chainCoupling::oneWay;
    EXPECT_THROW(chainAlpha({}, {}), std::invalid_argument);
    EXPECT_THROW(chainAlpha({1, 2}, {1}), std::invalid_argument);
    EXPECT_THROW(chainAlpha({1, 1}, {1, 1}), std::invalid_argument);
    EXPECT_THROW(chainAlpha({1, 2}, {1, 11}), std::invalid_argument);
    EXPECT_THROW(chainAlpha({-1, 2}, {1, 1}), std::invalid_argument);
    EXPECT_THROW
    (
        contactChain(wall, 1, pair, 1, coupling), std::invalid_argument
    );
    EXPECT_THROW
    (
        contactChain(pair, -1, wall, 1, coupling), std::invalid_argument
    );
    EXPECT_THROW
    (
        contactChain
        (
            jkrContact(5e-6, 1e10, mass/2, 0), 1, wall, 1, coupling
        ),
        std::invalid_argument
    );
    EXPECT_THROW(chain(coupling).impact(0), std::invalid_argument);
    EXPECT_THROW
    (
        chain(coupling).threshold(event::firstRebounds, 0.1, 0.2),
        std::invalid_argument
    );
}


TEST(contactChain, takesAlphaAtTheSpeedOfTheImpact)
{
    // As the chain of constants that are worked out by hand
    const chainAlpha falls({0.4, 0.8}, {1.2, 1.0});
    const chainAlpha rises({0.3, 0.5, 1}, {0.9, 1.1, 1.3});
    for
    (
        const chainCoupling coupling :
        {chainCoupling::oneWay, chainCoupling::twoWay}
    )
    {
        const contactChain c(pair, falls, wall, rises, coupling);
        const double wanted[][3] =
        {
            {0.2, 1.2, 0.9}, {0.45, 1.175, 1.05}, {0.6, 1.1, 1.14},
            {0.9, 1, 1.26}, {2, 1, 1.3}
        };
        for (const auto& [V, a, aw] : wanted)
        {
            const chainOutcome x = c.impact(V);
            const chainOutcome y = chain(coupling, a, aw).impact(V);
            EXPECT_EQ(x.firstCaptured, y.firstCaptured) << V;
            EXPECT_EQ(x.secondDetached, y.secondDetached) << V;
            EXPECT_NEAR(x.firstSpeed, y.firstSpeed, 1e-8*V);
            EXPECT_NEAR(x.secondSpeed, y.secondSpeed, 1e-8*V);
            EXPECT_NEAR(x.maxOverlap2, y.maxOverlap2, 1e-8*y.maxOverlap2);
        }
    }

    // One alpha(V) for both contacts that keeps P1's speed of capture and
    // takes off P2 at the source's speed: alpha 1.1891 up to 0.394 m/s, less
    // above
    const auto detaches = [&](double at)
    {
        const chainAlpha law({0.394, 0.695}, {alpha, at});
        const contactChain c(pair, law, wall, law, chainCoupling::oneWay);
        EXPECT_NEAR(c.threshold(event::firstRebounds, 0.1, 2), 0.394, 5e-4);
        return c.threshold(event::secondDetaches, 0.1, 2);
    };
    EXPECT_GT(detaches(alpha), 0.75);
    EXPECT_LT(detaches(0.9), 0.69);
}
