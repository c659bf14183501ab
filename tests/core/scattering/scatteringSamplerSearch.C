/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The kernels of many bodies, on smooth walls and random relief, against the
    general search of one (wallVisit), whose first contact a brute-force search
    checks: the same particles, so that only what round-off turns into another
    bounce may differ.
\*---------------------------------------------------------------------------*/

#include "scatteringSamplerTest.H"

using namespace impact;
using namespace samplerTest;

namespace
{

const auto untilExit = visitTreatment::untilExit;
const auto once = visitTreatment::firstImpact;
const vector3 still = {0, 0, 0};

const convexBody ball = convexBody::sphere(a);
const convexBody egg = convexBody::ellipsoid({1.4*a, a, a});
const convexBody lens = convexBody::ellipsoid({0.3*a, a, a});
const convexBody brick = convexBody::box({a, 0.8*a, 0.8*a});
const convexBody plate = convexBody::box({0.1*a, a, a});
const convexBody needle = convexBody::box({0.1*a, 0.1*a, a});
const convexBody cube = convexBody::box({a, a, a});
const convexBody large = convexBody::sphere(3*a);
const convexBody rod = convexBody::box({2.5*a, a, a});
const convexBody block = convexBody::box({a, 0.8*a, 0.6*a});

struct variant
{
    convexBody body;
    double incidence;
    vector3 spin;
    visitTreatment treatment;
    reboundLaw law;
    std::shared_ptr<const relief> wall;
};


reboundLaw usual()
{
    return reboundLaw::restitution();
}


//- Coefficients of the local angle and speed
reboundLaw localLaw()
{
    typedef reboundCoefficient form;
    return reboundLaw::restitution
    (
        form::table
        (
            reboundLaw::normalQuantity(), {0, 20, 90}, {50, 200},
            {0.95, 0.9, 0.8, 0.7, 0.5, 0.3}
        ),
        form::fit(reboundLaw::tangentialQuantity(), "GrantTabakoff")
    );
}


std::vector<variant> onRandomRelief()
{
    const auto paper = paperRelief();
    const auto steep = std::make_shared<const relief>
        (relief::rough(80e-6, 10e-6, 60e-6));
    std::vector<variant> variants;
    for (int k = 0; k < 5; ++k)
    {
        variants.push_back
            ({paperShapes()[k], 15, still, untilExit, usual(), paper});
    }
    variants.push_back({cube, 30, still, untilExit, usual(), paper});
    variants.push_back({ball, 60, still, untilExit, usual(), steep});

    // Wider than some intervals
    variants.push_back({large, 15, still, untilExit, usual(), paper});
    variants.push_back({rod, 30, {0, 1e6, 1e6}, untilExit, usual(), paper});
    variants.push_back({egg, 90, still, untilExit, usual(), steep});
    variants.push_back({lens, 20, {1e6, -2e6, 5e6}, untilExit, usual(), paper});
    variants.push_back({brick, 45, {0, 0, 2e7}, untilExit, usual(), paper});
    variants.push_back({plate, 15, {0, 3e6, 0}, once, usual(), paper});
    variants.push_back({needle, 5, still, untilExit, usual(), paper});
    variants.push_back
    (
        {
            brick, 15, still, untilExit, reboundLaw::restitution(0.5, 0.5), steep
        }
    );
    const reboundLaw rubbing = reboundLaw::coulomb(0.8, 0.3);
    variants.push_back({ball, 15, still, untilExit, rubbing, paper});
    variants.push_back({egg, 5, still, untilExit, rubbing, paper});
    variants.push_back({brick, 45, {1e6, 2e7, 0}, untilExit, rubbing, paper});
    variants.push_back({rod, 15, still, once, rubbing, steep});

    const reboundLaw local = localLaw();
    variants.push_back({egg, 15, still, untilExit, local, paper});
    variants.push_back({brick, 30, {0, 1e6, 0}, untilExit, local, paper});
    return variants;
}


std::vector<variant> onTheSmoothWall()
{
    std::vector<variant> variants;
    const std::shared_ptr<const relief> smooth;
    variants.push_back({brick, 15, still, untilExit, localLaw(), smooth});
    for
    (
        const convexBody& body : {brick, cube, plate, needle, block, egg, lens}
    )
    {
        for (const auto treatment : {untilExit, once})
        {
            variants.push_back({body, 15, still, treatment, usual(), smooth});
        }
        variants.push_back({body, 45, {1e6, -2e6, 3e6}, untilExit, usual(), smooth});
        if (body.isBox())
        {
            variants.push_back({body, 2, still, untilExit, usual(), smooth});
        }
        variants.push_back
        (
            {
                body, 60, {0, 2e6, -1e6}, untilExit,
                reboundLaw::restitution(0.5, 0.3), smooth
            }
        );
    }
    return variants;
}


void followsTheGeneralSearch(const variant& v)
{
    scatteringSampler::setup s = basic(v.body);
    s.incidence = v.incidence;
    s.spin = v.spin;
    s.treatment = v.treatment;
    s.law = v.law;
    s.wall = v.wall;
    const int n = 8192;
    const scatteringStatistics r = run(s, n);
    const scatteringSampler sampler(s);
    std::vector<double> bins(r.nBins());
    double impacts = 0, second = 0, into = 0, pulling = 0;
    double rotational = 0, rolling = 0;
    for (const visitResult& one : sampler.visits(0, n))
    {
        rolling += one.microImpacts > 20 ? one.pulling : 0;
        impacts += one.impacts;
        second += one.second;
        into += one.intoWall;
        pulling += one.pulling;
        const vector3& w = one.state.rotation.omega;
        rotational += dot(multiply(v.body.inertia(), w), w);
        const double alpha =
            std::atan2(one.state.V.y, one.state.V.x)*180/M_PI;
        if (alpha >= 0)
        {
            bins[std::min(int(alpha/r.binWidth()), r.nBins() - 1)] += 1;
        }
    }
    double differ = 0;
    for (int i = 0; i < r.nBins(); ++i)
    {
        differ += 0.5*std::fabs(bins[i] - r.alphaCount(i));
    }
    // Observed: no difference but in pulling (1) and micro impacts
    EXPECT_LE(differ, 2);
    EXPECT_NEAR(r.count(S::secondImpact), second, 2);
    EXPECT_NEAR(r.count(S::intoWall), into, 1);
    EXPECT_NEAR(r.count(S::impacts), impacts, 4);

    // A body that rolls makes some 200 impacts, each of which multiplies
    // the round-off of those before: the pulling ones among them differ by
    // up to 6 % from one order of the same operations to another, while
    // all large impacts are the same
    EXPECT_NEAR(r.count(S::pulling), pulling, 4 + 0.1*rolling);
    EXPECT_NEAR
    (
        r.mean(S::rotational)*n*s.speed*s.speed, rotational,
        1e-4*rotational + 1e-30
    );
}

} // End anonymous namespace


TEST(scatteringSampler, followsManyBodiesAsTheGeneralSearchFollowsOne)
{
    int number = 0;
    for (const auto& variants : {onRandomRelief(), onTheSmoothWall()})
    {
        for (const variant& v : variants)
        {
            SCOPED_TRACE(number++);
            followsTheGeneralSearch(v);
        }
    }
}


TEST(scatteringSampler, capsVisitsToASmoothWallAsTheGeneralSearchDoes)
{
    for
    (
        const convexBody& body :
        {
            convexBody::box({a, 0.8*a, 0.8*a}),
            convexBody::ellipsoid({0.3*a, a, a})
        }
    )
    {
        for (int most : {1, 2, 3})
        {
            scatteringSampler::setup s = basic(body);
            s.maxImpacts = most;
            const int n = 8192;
            const scatteringStatistics r = run(s, n);
            double impacts = 0, second = 0, capped = 0;
            for (const visitResult& one : scatteringSampler(s).visits(0, n))
            {
                impacts += one.impacts + one.microImpacts;
                second += one.second;
                capped += one.capped;
            }
            EXPECT_GT(capped, most < 3 ? 10 : 0);
            EXPECT_NEAR(r.count(S::capped), capped, 1);
            EXPECT_NEAR(r.count(S::secondImpact), second, 1);
            EXPECT_NEAR
            (
                r.count(S::impacts) + r.count(S::microImpacts), impacts, 2
            );
        }
    }
}
