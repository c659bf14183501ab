/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Sampling: exact results, conservation over whole visits, independence of
    threads and processes, statistical errors, and extremes.
\*---------------------------------------------------------------------------*/

#include "scatteringSamplerTest.H"

#include <limits>
#include <random>
#include <stdexcept>

using namespace impact;
using namespace samplerTest;

namespace
{

//- Leave what is not a number on the stack, where the next call has its frame;
//  to compare that with < is an invalid operation
__attribute__((noinline)) void spoilStack()
{
    volatile double rubbish[1 << 15];
    for (volatile double& r : rubbish)
    {
        r = std::numeric_limits<double>::quiet_NaN();
    }
}


//- One of many measured profiles of the same roughness
std::shared_ptr<const relief> randomProfile(int number)
{
    std::mt19937 draw(number);
    std::vector<double> x, y;
    for (int i = 0; i < 400; ++i)
    {
        x.push_back(40e-6*i);
        y.push_back(30e-6*(double(draw()) + double(draw()))/0x1p32);
    }
    return std::make_shared<const relief>(relief::profile(x, y));
}

} // End anonymous namespace


TEST(scatteringSampler, trapsNothingWhateverTheStackHolds)
{
    // Lanes of a vector that a branch leaves out hold what was on the stack
    for (bool box : {false, true})
    {
        smoothBody body{};
        body.box = box;
        body.along = body.across = body.radius = a;
        body.Ja = body.Jc = 0.4*a*a;
        body.normal = 0.8;
        for (double Vy : {-1., 0., 1.})
        {
            auto l = std::make_unique<smoothLanes>();
            std::fill_n(l->ex[0], smoothRoom, 1.);
            std::fill_n(l->ey[1], smoothRoom, 1.);
            std::fill_n(l->V[1], smoothRoom, Vy);
            spoilStack();
            smoothImpact(smoothRoom, body, *l);
            EXPECT_DOUBLE_EQ(l->approach[3], -Vy);
            spoilStack();
            smoothAdvance(smoothRoom, body, *l);
            EXPECT_EQ(l->trials[3], 1);
        }
    }
}


TEST(scatteringSampler, reboundsSpheresFromASmoothWallAtTheExactAngle)
{
    for (double alpha : {0.01, 1., 15., 45., 89.99})
    {
        scatteringSampler::setup s = basic(convexBody::sphere(a));
        s.incidence = alpha;
        const scatteringStatistics r = run(s, 5000);
        const double exact = std::atan2
        (
            0.8*std::sin(alpha*M_PI/180), 5./7*std::cos(alpha*M_PI/180)
        )*180/M_PI;
        EXPECT_NEAR(r.meanAlpha(), exact, 1e-12*180/M_PI);
        EXPECT_LT(r.deviationAlpha(), 1e-12*180/M_PI);
        EXPECT_EQ(r.alphaCount(int(exact)), 5000);
        EXPECT_EQ(r.count(S::secondImpact), 0);
        
        // Below 0.057 degrees the approach counts as a micro impact
        EXPECT_EQ(r.count(S::impacts) + r.count(S::microImpacts), 5000);
        EXPECT_EQ(r.count(S::microImpacts), alpha < 0.05 ? 5000 : 0);
        EXPECT_NEAR(r.meanBeta(), 0, 1e-12);
    }
}


TEST(scatteringSampler, keepsTheEnergyOfALosslessLawOverRoughVisits)
{
    for (const convexBody& body : paperShapes())
    {
        scatteringSampler::setup s = basic(body);
        s.wall = paperRelief();
        s.law = reboundLaw::restitution(1, -1);
        s.spin = {1e6, -2e6, 3e6};
        const scatteringSampler sampler(s);
        int several = 0;
        for (const visitResult& r : sampler.visits(0, 2000))
        {
            const vector3& w = r.state.rotation.omega;
            // The tensor of inertia turns the spin of arrival into an energy
            // that depends on the orientation: kept by impacts and flights
            const double T =
                dot(r.state.V, r.state.V)
              + dot(multiply(body.inertia(), w), w);
            several += r.impacts > 1;
            EXPECT_NEAR(r.energyOnArrival, 0.5*T, 1e-12*0.5*T);
        }
        EXPECT_GT(several, 5);
    }
}


TEST(scatteringSampler, doesNotDependOnThreadsOrProcesses)
{
    for (bool rough : {false, true})
    {
        scatteringSampler::setup s = basic(paperShapes()[3]);
        if (rough)
        {
            s.wall = paperRelief();
        }
        const int n = 5*scatteringSampler::blockSize + 123;
        const scatteringStatistics one = run(s, n);
        EXPECT_EQ(one.pack(), run(s, n, 2).pack());
        EXPECT_EQ(one.pack(), run(s, n, 1, 3).pack());
    }
}


TEST(scatteringSampler, isSymmetricOutOfThePlane)
{
    for (bool rough : {false, true})
    {
        scatteringSampler::setup s = basic(paperShapes()[3]);
        if (rough)
        {
            s.wall = paperRelief();
        }
        const scatteringStatistics r = run(s, 200000);
        const double n = double(r.count(S::particles));
        EXPECT_LT
        (
            std::fabs(r.meanBeta()), 4*r.deviationBeta()/std::sqrt(n)
        );
        // Counts of opposite sectors, 10 degrees by 10 degrees
        double chi2 = 0;
        int terms = 0;
        for (int i = 0; i < 180; i += 10)
        {
            for (int j = 0; j < 90; j += 10)
            {
                double left = 0, right = 0;
                for (int k = 0; k < 100; ++k)
                {
                    left += r.count(i + k/10, j + k % 10);
                    right += r.count(i + k/10, 179 - j - k % 10);
                }
                if (left + right > 20)
                {
                    chi2 += (left - right)*(left - right)/(left + right);
                    ++terms;
                }
            }
        }
        EXPECT_GT(terms, 20);
        EXPECT_LT(chi2, terms + 4*std::sqrt(2.*terms));
    }
}


TEST(scatteringSampler, treatsAFlatReliefAsASmoothWall)
{
    for (const convexBody& body : paperShapes())
    {
        for
        (
            auto treatment :
            {
                visitTreatment::untilExit,
                visitTreatment::firstImpact
            }
        )
        {
            scatteringSampler::setup s = basic(body);
            s.treatment = treatment;
            const scatteringStatistics smooth = run(s, 40000);
            s.wall = std::make_shared<const relief>(relief::flat());
            const scatteringStatistics flat = run(s, 40000);

            // The same orientations: more than statistically the same
            EXPECT_LT(variation(smooth, flat), 2e-3);
            EXPECT_NEAR(smooth.meanAlpha(), flat.meanAlpha(), 0.02);
            EXPECT_NEAR
            (
                share(smooth, S::secondImpact),
                share(flat, S::secondImpact), 1e-3
            );
            EXPECT_NEAR
            (
                share(smooth, S::intoWall), share(flat, S::intoWall), 1e-3
            );
            EXPECT_NEAR
            (
                smooth.mean(S::rotational), flat.mean(S::rotational), 1e-3
            );
        }
    }
}


TEST(scatteringSampler, claimsTheErrorThatRepeatedRunsShow)
{
    for (const std::string wall : {"smooth", "rough", "profile"})
    {
        scatteringSampler::setup s = basic(paperShapes()[3]);
        s.binWidth = 10;
        if (wall == "rough")
        {
            s.wall = paperRelief();
        }
        s.sharedRelief = wall == "profile";
        const int runs = 60, n = 4096;
        std::vector<double> sum(18), squares(18), claimed(18);
        for (int k = 0; k < runs; ++k)
        {
            s.seed = 1000 + k;
            if (s.sharedRelief)
            {
                s.wall = randomProfile(k);
            }
            const scatteringStatistics r = run(s, n);
            for (int i = 0; i < 18; ++i)
            {
                sum[i] += r.F(i)/runs;
                squares[i] += r.F(i)*r.F(i)/runs;
                claimed[i] +=
                    r.standardError(i)*r.standardError(i)/runs;
            }
        }
        // Ratio of variances, averaged over the populated bins: its own
        // standard error is sqrt(2/(runs bins))
        double ratio = 0;
        int bins = 0;
        for (int i = 0; i < 18; ++i)
        {
            if (sum[i] > 0.02)
            {
                const double variance =
                    (squares[i] - sum[i]*sum[i])*runs/(runs - 1);
                ratio += variance/claimed[i];
                ++bins;
            }
        }
        ratio /= bins;
        EXPECT_GT(bins, 5);
        EXPECT_NEAR(ratio, 1, 4*std::sqrt(2./(runs*bins))) << wall;
    }
}


TEST(scatteringSampler, showsWhatThePaperReports)
{
    const std::vector<convexBody> shapes = paperShapes();
    std::vector<scatteringStatistics> smooth, rough;
    for (const convexBody& body : shapes)
    {
        scatteringSampler::setup s = basic(body);
        s.orientation = orientationLaw::uniformEuler;
        s.treatment = visitTreatment::firstImpact;
        smooth.push_back(run(s, 100000));
        s.treatment = visitTreatment::untilExit;
        s.wall = paperRelief();
        rough.push_back(run(s, 40000));
    }
    // Smooth: prisms scatter far more widely than ellipsoids, about another
    // most probable angle than the sphere's 16.7 degrees
    for (int e : {1, 2})
    {
        EXPECT_LT(smooth[e].deviationAlpha(), 8);
        EXPECT_EQ(smooth[e].count(S::intoWall), 0);
        for (int p : {3, 4, 5})
        {
            EXPECT_GT
            (
                smooth[p].deviationAlpha(), 2*smooth[e].deviationAlpha()
            );
            EXPECT_GT(std::fabs(smooth[p].modeAlpha() - 16.7), 5);
        }
    }
    for (int p : {3, 4})
    {
        EXPECT_NEAR(smooth[p].modeAlpha(), 2, 1.5);
        EXPECT_NEAR(share(smooth[p], S::intoWall), 0.36, 0.03);
        EXPECT_NEAR(share(smooth[p], S::secondImpact), 0.45, 0.03);
    }

    // Until they leave, prisms have a flat maximum that reaches 30 degrees
    // under the paper's law of orientation, less so under the isotropic one
    for (int p : {3, 4})
    {
        scatteringSampler::setup s = basic(shapes[p]);
        s.binWidth = 5;
        double at30[2];
        for (bool isotropic : {false, true})
        {
            s.orientation = isotropic
              ? orientationLaw::isotropic : orientationLaw::uniformEuler;
            const scatteringStatistics r = run(s, 400000);
            double peak = 0;
            int best = 0;
            for (int i = 0; i < r.nBins(); ++i)
            {
                best = r.F(i) > peak ? i : best;
                peak = r.F(best);
            }
            EXPECT_GE(5*best, 15);
            EXPECT_LE(5*best, 30);
            at30[isotropic] = 0.5*(r.F(5) + r.F(6))/peak;
        }
        // 0.99 and 0.95, with a standard error of 0.005
        EXPECT_GT(at30[0], 0.97);
        EXPECT_LT(at30[1], at30[0]);
    }

    // What an independent program counted of the prisms: about 7 % of the
    // impacts at 15 degrees pull, about 9 % at 45 degrees gain energy; none
    // of the sphere or the ellipsoids does
    EXPECT_NEAR(share(smooth[3], S::pulling), 0.08, 0.02);
    EXPECT_EQ(smooth[1].count(S::pulling), 0);
    scatteringSampler::setup steep = basic(shapes[3]);
    steep.incidence = 45;
    steep.treatment = visitTreatment::firstImpact;
    EXPECT_NEAR(share(run(steep, 100000), S::gaining), 0.09, 0.015);
    steep.body = shapes[1];
    EXPECT_EQ(run(steep, 100000).count(S::gaining), 0);

    // Rough: all six nearly the same, much steeper and wider
    for (int k = 0; k < 6; ++k)
    {
        EXPECT_GT(rough[k].modeAlpha(), 35);
        EXPECT_GT(rough[k].deviationAlpha(), smooth[k].deviationAlpha());
        EXPECT_LT(variation(rough[k], rough[0]), 0.1);
    }
    for (int k = 1; k < 6; ++k)
    {
        EXPECT_GT
        (
            variation(smooth[k], smooth[0]), 5*variation(rough[k], rough[0])
        );
    }
}


TEST(scatteringSampler, accountsForEveryParticleAtTheExtremes)
{
    std::vector<scatteringSampler::setup> cases;
    for (bool rough : {false, true})
    {
        scatteringSampler::setup s = basic(paperShapes()[3]);
        if (rough)
        {
            s.wall = paperRelief();
        }
        auto add = [&](auto change)
        {
            scatteringSampler::setup t = s;
            change(t);
            cases.push_back(t);
        };
        add([](auto& t) { t.incidence = 0.01; });
        add([](auto& t) { t.incidence = 89.99; });
        add([](auto& t) { t.incidence = 90; });
        add([](auto& t) { t.law = reboundLaw::restitution(0); });
        add([](auto& t) { t.law = reboundLaw::coulomb(0, 0.5); });
        add([](auto& t) { t.law = reboundLaw::coulomb(0.8, 0.3); });
        add([](auto& t) { t.spin = {1e8, 1e8, -1e8}; });
        for (const convexBody& b :
            {
                convexBody::ellipsoid({a, 0.01*a, 0.01*a}),
                convexBody::ellipsoid({a, 100*a, 100*a}),
                convexBody::box({a, 0.01*a, 0.01*a}),
                convexBody::box({a, 100*a, 100*a}),
                convexBody::ellipsoid({a, 0.01*a, 0.3*a}),
                convexBody::box({a, 0.01*a, 0.3*a}),
                convexBody::sphere(20*a)
            })
        {
            add([&](auto& t) { t.body = b; });
        }
        if (rough)
        {
            add([](auto& t)
            {
                // Flanks of 85 degrees and more
                t.wall = std::make_shared<const relief>
                    (relief::rough(20e-6, 6e-6, 40e-6));
            });
        }
    }
    for (std::size_t k = 0; k < cases.size(); ++k)
    {
        const scatteringSampler::setup& s = cases[k];
        for (int n : {1, 200})
        {
            const scatteringStatistics r = run(s, n);
            EXPECT_EQ(r.count(S::particles), n);
            EXPECT_GE(r.count(S::impacts) + r.count(S::microImpacts), n)
                << "case " << k;
            std::int64_t binned = 0;
            for (int i = 0; i < r.nBins(); ++i)
            {
                binned += r.alphaCount(i);
            }
            // What is not in the histogram goes into the wall: capped
            EXPECT_LE(n - binned, r.count(S::capped)) << "case " << k;
            EXPECT_TRUE(std::isfinite(r.meanAlpha()));
            EXPECT_TRUE(std::isfinite(r.mean(S::rotational)));
        }
    }
}


TEST(scatteringSampler, startsAnywhereOnTheWall)
{
    // The interval behind the one of the start is one like any other
    scatteringSampler::setup s = basic(convexBody::sphere(20e-6));
    const double mean = 80e-6, sigma = 10e-6;
    s.wall =
        std::make_shared<const relief>(relief::rough(mean, sigma, 20e-6));
    s.incidence = 90;
    const scatteringSampler sampler(s);
    reliefPiece piece(*s.wall, s.seed);
    std::int64_t identity = -1;
    const int n = 40000;
    double before = 0, at = 0;
    for (int i = 0; i < n; ++i)
    {
        std::int64_t k = 0;
        sampler.arrival(i, piece, identity, k);
        before += (piece.knot(k) - piece.knot(k - 1))/n;
        at += (piece.knot(k + 1) - piece.knot(k))/n;
    }
    const double error = sigma/std::sqrt(n);
    EXPECT_NEAR(before, mean, 5*error);

    // Long ones hold more places; the normal law is cut off at 3 deviations
    EXPECT_NEAR(at, mean + 0.9733*sigma*sigma/mean, 5*error);
}


TEST(scatteringSampler, refusesBadInput)
{
    const scatteringSampler::setup good = basic(convexBody::sphere(a));
    for (const relief& wall : {*paperRelief(), relief::sinusoidal(a, 9*a)})
    {
        scatteringSampler::setup s = good;
        s.incidence = 1e-6;
        EXPECT_NO_THROW(scatteringSampler{s});
        s.wall = std::make_shared<const relief>(wall);
        EXPECT_THROW(scatteringSampler{s}, std::invalid_argument);
        s.incidence = 1e-3;
        EXPECT_NO_THROW(scatteringSampler{s});
    }
    for (double incidence : {0., -1., 90.1})
    {
        scatteringSampler::setup s = good;
        s.incidence = incidence;
        EXPECT_THROW(scatteringSampler{s}, std::invalid_argument);
    }
    for (double speed : {0., -1.})
    {
        scatteringSampler::setup s = good;
        s.speed = speed;
        EXPECT_THROW(scatteringSampler{s}, std::invalid_argument);
    }
    for (double width : {0., -1., 7., 181., 1e-3})
    {
        scatteringSampler::setup s = good;
        s.binWidth = width;
        EXPECT_THROW
        (
            scatteringSampler(s).emptyStatistics(), std::invalid_argument
        );
    }
}
