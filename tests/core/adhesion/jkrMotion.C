/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Tests of jkrMotion, on dormandPrince8 with it.
\*---------------------------------------------------------------------------*/

#include "jkrMotion.H"
#include "bracketedRoot.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <vector>

using namespace impact;

namespace
{

//- Impact at q times the undamped speed of capture; exit speeds in units of
//  the speed of arrival
motionOutcome impactAt
(
    const jkrMotion& motion,
    double q,
    double* arrival = nullptr
)
{
    double p = q*jkrMotion::separationSpeed();
    const double ratio = std::max(1., std::pow(p, 0.2));
    p /= std::pow(ratio, 5);
    motionOutcome out = motion.impact(jkrCurve(2./3/std::pow(ratio, 3)), p);
    if (arrival)
    {
        *arrival = p;
    }
    out.exitSpeed /= p;
    return out;
}


//- Restitution by Runge-Kutta steps of fourth order and fixed size in other
//  units, lengths and forces in those of the pull-off point
double plainRestitution(double alpha, double q, int nSteps)
{
    const double c = std::cbrt(6.), kappa = std::sqrt(2/c);
    const double W = 0.935502783061;
    auto rate = [&](const double* y, double* r)
    {
        const double u = y[0], p = y[1], u3 = u*u*u;
        const double slope = c*(8*u3 - 4./3);
        r[0] = p;
        r[1] = -slope*(4*(u3*u3 - u3) + alpha*kappa*u*p);
    };
    const double V = q*std::sqrt(2*W);
    double y[2] = {std::cbrt(2./3), V};
    const double end = std::cbrt(1./6), h = 1./nSteps;
    for (;;)
    {
        double k1[2], k2[2], k3[2], k4[2], z[2], next[2];
        rate(y, k1);
        for (int i = 0; i < 2; ++i) z[i] = y[i] + 0.5*h*k1[i];
        rate(z, k2);
        for (int i = 0; i < 2; ++i) z[i] = y[i] + 0.5*h*k2[i];
        rate(z, k3);
        for (int i = 0; i < 2; ++i) z[i] = y[i] + h*k3[i];
        rate(z, k4);
        for (int i = 0; i < 2; ++i)
        {
            next[i] = y[i] + h/6*(k1[i] + 2*k2[i] + 2*k3[i] + k4[i]);
        }
        if (next[0] <= end && next[1] < 0)
        {
            // dp/ds = 0 there
            return -next[1]/V;
        }
        if (y[1] < 0 && next[1] >= 0)
        {
            return 0;
        }
        y[0] = next[0];
        y[1] = next[1];
    }
}

} // End anonymous namespace


TEST(jkrMotion, integratorIsOfEighthOrder)
{
    // A pendulum, against itself with halved steps, and its energy
    auto pendulum = [](const std::array<double, 2>& y,
        std::array<double, 2>& r)
    {
        r = {y[1], -std::sin(y[0])};
    };
    auto run = [&](int n)
    {
        dormandPrince8<2> step(pendulum, {1, 0.5});
        for (int i = 0; i < n; ++i)
        {
            step.attempt(pendulum, 8./n);
            step.accept();
        }
        return step.begin();
    };
    const auto exact = run(640);
    const double e1 = std::fabs(run(16)[0] - exact[0]);
    const double e2 = std::fabs(run(32)[0] - exact[0]);
    EXPECT_NEAR
    (
        0.5*exact[1]*exact[1] - std::cos(exact[0]),
        0.125 - std::cos(1),
        1e-14
    );
    EXPECT_GT(e1/e2, 150);

    // The interpolant, and its inverse, within a step
    dormandPrince8<2> step(pendulum, {1, 0.5});
    step.attempt(pendulum, 0.1);
    step.interpolate(pendulum);
    for (double x : {0.1, 0.4, 0.9})
    {
        dormandPrince8<2> part(pendulum, {1, 0.5});
        part.attempt(pendulum, 0.1*x);
        EXPECT_NEAR(step.at(0, x), part.end()[0], 1e-12);
        EXPECT_NEAR(step.when(0, part.end()[0], 1), x, 1e-10);
    }

    // A motion that is not a number has no error that a step could keep
    const double none = std::numeric_limits<double>::quiet_NaN();
    dormandPrince8<2> lost(pendulum, {1, none});
    lost.attempt(pendulum, 0.1);
    EXPECT_THROW(lost.error({1, 1}), std::invalid_argument);
}


TEST(jkrMotion, undampedReboundIsExact)
{
    const jkrMotion motion(0, unloadingType::soft, 1e-13);
    for (double q : {1.001, 1.1, 2., 10., 1e3, 1e6, 1e9})
    {
        const motionOutcome out = impactAt(motion, q);
        EXPECT_FALSE(out.captured);
        EXPECT_NEAR(out.exitSpeed, std::sqrt(1 - 1/(q*q)), 1e-10) << q;
        EXPECT_EQ(out.dissipated, 0);
    }
    for (double q : {1e-9, 0.1, 0.999999})
    {
        EXPECT_TRUE(impactAt(motion, q).captured) << q;
    }
}


TEST(jkrMotion, hardUnloadingLosesLess)
{
    const jkrMotion motion(0, unloadingType::hard, 1e-13);
    const double g = motion.captureRatio();
    EXPECT_NEAR(g, std::sqrt(0.462014009/0.935502783), 1e-9);
    for (double f : {1.001, 1.1, 5., 1e4})
    {
        EXPECT_NEAR
        (
            impactAt(motion, f*g).exitSpeed, std::sqrt(1 - 1/(f*f)), 1e-10
        ) << f;
    }
    EXPECT_TRUE(impactAt(motion, 0.9999*g).captured);
}


TEST(jkrMotion, capturesBelowTheSpeedsOfTheSource)
{
    auto G = [](double alpha)
    {
        return jkrMotion(alpha, unloadingType::soft, 1e-12).captureRatio();
    };
    EXPECT_NEAR(G(0), 1, 1e-11);
    EXPECT_NEAR(G(0.5), 4.628, 1e-4*4.628);
    EXPECT_NEAR(G(1), 15.81, 1e-4*15.81);
    EXPECT_NEAR(G(1.2), 27.95, 1e-4*27.95);
}


TEST(jkrMotion, separatrixAgreesWithBisection)
{
    for (unloadingType unloading : {unloadingType::soft, unloadingType::hard})
    {
        for (double alpha : {0.05, 0.3, 1.19, 1.6, 2.})
        {
            const jkrMotion motion(alpha, unloading, 1e-13);
            const double g = motion.captureRatio();
            const double low = bracketedChange
            (
                [&](double p) { return impactAt(motion, p).captured; },
                0.5*g,
                2*g,
                [=](double a, double b) { return b - a <= 1e-12*g; }
            ).first;
            EXPECT_NEAR(low/g, 1, 1e-10) << alpha;
        }
    }
}


TEST(jkrMotion, agreesWithAPlainIntegration)
{
    for (double alpha : {0., 0.225, 1.1891, 1.6})
    {
        const jkrMotion motion(alpha, unloadingType::soft, 1e-13);
        const double g = motion.captureRatio();
        for (double f : {1.01, 1.5, 8.})
        {
            const double e = plainRestitution(alpha, f*g, 100000);
            EXPECT_GT(e, 0);
            EXPECT_NEAR(impactAt(motion, f*g).exitSpeed, e, 2e-9)
                << alpha << ' ' << f;
        }
        EXPECT_EQ(plainRestitution(alpha, 0.99*g, 100000), 0);
    }
}


TEST(jkrMotion, tendsToHertzAndTsuji)
{
    // Without adhesion at all, ended at zero overlap
    for (double alpha : {0., 0.1, 0.5, 1., 1.5, 2., 2.2})
    {
        const jkrMotion motion(alpha, unloadingType::soft, 1e-12);
        const motionOutcome out = motion.impact(jkrCurve(0), 1);
        EXPECT_FALSE(out.captured);
        EXPECT_NEAR
        (
            out.exitSpeed,
            std::exp(-M_PI*alpha/std::sqrt(5 - alpha*alpha)),
            1e-10
        ) << alpha;
    }
    for (double alpha : {std::sqrt(5.), 2.3, 3.})
    {
        const jkrMotion motion(alpha);
        EXPECT_TRUE(motion.impact(jkrCurve(0), 1).captured);
        EXPECT_EQ(jkrMotion::hertzRestitution(alpha), 0);
        EXPECT_TRUE(std::isinf(motion.captureSpeed()));
    }

    // With ever less of it
    for (double alpha : {0., 0.5, 1.19, 1.6})
    {
        const jkrMotion motion(alpha, unloadingType::soft, 1e-12);
        const double limit = jkrMotion::hertzRestitution(alpha);
        double last = 1;
        for (double q : {1e4, 1e6, 1e8, 1e10})
        {
            const double gap = limit - impactAt(motion, q).exitSpeed;
            EXPECT_LT(gap, 0.2*last + 1e-12);
            last = gap;
        }
        EXPECT_LT(std::fabs(last), 2e-6);
    }

    // The largest overlap and the duration of the contact after Hertz
    const motionOutcome out =
        jkrMotion(0, unloadingType::soft, 1e-12).impact(jkrCurve(0), 1);
    EXPECT_NEAR(0.4*std::pow(out.maxU, 10), 0.5, 1e-9);
    const double overlap = std::pow(out.maxU, 4);
    EXPECT_NEAR(out.time, 2.943275*overlap, 1e-5);
}


TEST(jkrMotion, accountsForTheEnergy)
{
    for (double alpha : {0., 0.225, 1.19, 1.6})
    {
        const jkrMotion motion(alpha, unloadingType::soft, 1e-10);
        for (double q : {0.5, 2., 40., 1e3, 1e6})
        {
            double p = q*jkrMotion::separationSpeed();
            const double ratio = std::max(1., std::pow(p, 0.2));
            p /= std::pow(ratio, 5);
            const jkrCurve curve(2./3/std::pow(ratio, 3));
            const motionOutcome out = motion.impact(curve, p);
            const double before = 0.5*p*p + curve.energy(curve.uA());
            EXPECT_NEAR
            (
                out.energy + out.dissipated, before, 1e-9*(0.5*p*p + 1e-2)
            ) << alpha << ' ' << q;
            if (!out.captured)
            {
                EXPECT_NEAR
                (
                    0.5*out.exitSpeed*out.exitSpeed + out.dissipated
                  + curve.separationWork(unloadingType::soft),
                    0.5*p*p,
                    1e-9*0.5*p*p
                );
            }
        }
    }
}


TEST(jkrMotion, capturedParticleSettlesInEquilibrium)
{
    for (double alpha : {0.225, 1.19, 3.})
    {
        const jkrMotion motion(alpha, unloadingType::soft, 1e-11);
        const jkrCurve curve(2./3);
        double u = 0, p = 0;
        const motionOutcome out = motion.follow
        (
            curve,
            0.9*jkrMotion::separationSpeed(),
            [&](const jkrMotion::integrator& step)
            {
                u = step.end()[0];
                p = step.end()[1];
                return step.end()[2] < 300;
            }
        );
        EXPECT_TRUE(out.captured);
        EXPECT_NEAR(u, curve.uB(), 1e-8) << alpha;
        EXPECT_NEAR(p, 0, 1e-8) << alpha;
    }
}


TEST(jkrMotion, undampedLoopsDoNotShrink)
{
    const jkrMotion motion(0, unloadingType::soft, 1e-12);
    const jkrCurve curve(2./3);
    std::vector<double> peaks;
    double last = 1;
    motion.follow
    (
        curve,
        0.99*jkrMotion::separationSpeed(),
        [&](const jkrMotion::integrator& step)
        {
            if (last > 0 && step.end()[1] <= 0)
            {
                peaks.push_back(step.at(0, step.when(1, 0, 1)));
            }
            last = step.end()[1];
            return peaks.size() < 60;
        }
    );
    for (double peak : peaks)
    {
        EXPECT_NEAR(peak, peaks[0], 1e-9);
    }
}


TEST(jkrMotion, reachesEightDigitsInFewEvaluations)
{
    for (double alpha : {0., 0.225, 1.1891, 1.6})
    {
        const double g =
            jkrMotion(alpha, unloadingType::soft, 1e-13).captureRatio();
        for (double f : {1.001, 1.1, 3., 100., 1e4})
        {
            const jkrMotion truth(alpha, unloadingType::soft, 1e-13);
            const double e = impactAt(truth, f*g).exitSpeed;

            // The cheapest of a range of tolerances that is good enough
            long fewest = 100000;
            for (double tolerance : {1e-7, 1e-8, 5e-9, 1e-9, 5e-10})
            {
                const motionOutcome out = impactAt
                (
                    jkrMotion(alpha, unloadingType::soft, tolerance), f*g
                );
                if (std::fabs(out.exitSpeed - e) < 1e-8)
                {
                    fewest = std::min(fewest, out.evaluations);
                }
            }
            EXPECT_LE(fewest, 500) << alpha << ' ' << f;

            // The default is good enough
            EXPECT_NEAR(impactAt(jkrMotion(alpha), f*g).exitSpeed, e, 1e-8);
        }
    }
}


TEST(jkrMotion, isFiniteAndClassifiedAtExtremes)
{
    std::vector<double> alphas = {0, 1e-9, 0.5, 1.6, 2, 2.2, 2.23, 2.236};
    alphas.push_back(std::sqrt(5.));
    alphas.push_back(2.3);
    alphas.push_back(3);
    alphas.push_back(10);
    for (unloadingType unloading : {unloadingType::soft, unloadingType::hard})
    {
        for (double alpha : alphas)
        {
            const jkrMotion motion(alpha, unloading);
            const double g = motion.captureRatio();
            EXPECT_GT(g, 0.7);
            for (double q = 1e-9; q < 2e9; q *= 10)
            {
                double p;
                const motionOutcome out = impactAt(motion, q, &p);
                EXPECT_TRUE(std::isfinite(out.maxU) && out.maxU > 0);
                EXPECT_GE(out.dissipated, 0);
                EXPECT_TRUE(out.exitSpeed >= 0 && out.exitSpeed < 1);
                if (std::fabs(q/g - 1) > 1e-4)
                {
                    EXPECT_EQ(out.captured, q < g) << alpha << ' ' << q;
                }
                EXPECT_EQ(out.captured, out.exitSpeed == 0);
                EXPECT_LT(out.evaluations, 20000) << alpha << ' ' << q;
            }
            if (alpha < 2.2)
            {
                // On the edge itself either is right, as long as it ends
                const motionOutcome edge = impactAt(motion, g);
                EXPECT_LT(edge.exitSpeed, 1e-3);
                EXPECT_LT(edge.evaluations, 20000);
            }
        }
    }
}


TEST(jkrMotion, overlapGrowsAndContactShortensWithSpeed)
{
    const jkrMotion motion(1.19);
    const double g = motion.captureRatio();
    double overlap = 0, duration = 1e9;
    for (double f = 1.01; f < 1e3; f *= 1.5)
    {
        double p = f*g*jkrMotion::separationSpeed();
        const double ratio = std::max(1., std::pow(p, 0.2));
        p /= std::pow(ratio, 5);
        const jkrCurve curve(2./3/std::pow(ratio, 3));
        const motionOutcome out = motion.impact(curve, p);

        // In the common units: length as ar^2, time as 1/sqrt(ar)
        const double r = ratio*ratio;
        const double newOverlap = r*r*curve.overlap(out.maxU);
        const double newDuration = out.time/std::sqrt(r);
        EXPECT_GT(newOverlap, overlap);
        EXPECT_LT(newDuration, duration);
        overlap = newOverlap;
        duration = newDuration;
    }
}


TEST(jkrMotion, refusesWhatIsOutOfRange)
{
    EXPECT_THROW(jkrMotion(-0.1), std::invalid_argument);
    EXPECT_THROW(jkrMotion(11), std::invalid_argument);
    EXPECT_THROW
    (
        jkrMotion(1, unloadingType::soft, 0), std::invalid_argument
    );
    EXPECT_THROW
    (
        jkrMotion(1, unloadingType::soft, 0.1), std::invalid_argument
    );
}
