/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "scatteringOutput.H"
#include "textFile.H"

#include "OSspecific.H"

#include <algorithm>

void Foam::writeScattering
(
    const fileName& folder,
    const impact::scatteringStatistics& s,
    const monteCarloRun::result& run
)
{
    typedef impact::scatteringStatistics S;
    mkDir(folder);
    const int n = s.nBins();
    {
        textFile f(folder/"F.csv");
        f.print("alpha2_deg,F_per_rad,stdError\n");
        for (int i = 0; i < n; ++i)
        {
            f.print
            (
                "%.10g,%.10g,%.10g\n",
                s.alphaCentre(i), s.F(i), s.standardError(i)
            );
        }
    }
    {
        textFile f(folder/"I.csv");
        f.print("alpha2_deg,beta2_deg,I\n");
        for (int i = 0; i < n; ++i)
        {
            for (int j = 0; j < n; ++j)
            {
                f.print
                (
                    "%.10g,%.10g,%.10g\n",
                    s.alphaCentre(i), s.betaCentre(j), s.I(i, j)
                );
            }
        }
    }
    writeConvergence(folder/"convergence.csv", run.convergence);

    const double N = double(s.count(S::particles));
    const double perParticle = N > 0 ? 1/N : 0;
    const double all =
        double(s.count(S::impacts) + s.count(S::microImpacts));
    const double perImpact = all > 0 ? 1/all : 0;
    textFile f(folder/"summary.csv");
    auto row = [&](const char* name, double value)
    {
        f.print("%s,%.12g\n", name, value);
    };
    f.print("quantity,value\n");
    row("nParticles", N);
    row("meanAlpha2_deg", s.meanAlpha());
    row("sdAlpha2_deg", s.deviationAlpha());
    row("modeAlpha2_deg", s.modeAlpha());
    row("meanBeta2_deg", s.meanBeta());
    row("sdBeta2_deg", s.deviationBeta());
    row("meanImpacts", s.count(S::impacts)*perParticle);
    row("keTranslationalRatio", s.mean(S::translational));
    row("keRotationalRatio", s.mean(S::rotational));
    row("fractionIntoWall", s.count(S::intoWall)*perParticle);
    row("fractionSecondImpact", s.count(S::secondImpact)*perParticle);
    row("fractionBackward", s.count(S::backward)*perParticle);
    row("fractionPulling", s.count(S::pulling)*perImpact);
    row("energyGaining", s.count(S::gaining)*perImpact);
    row("microImpacts", double(s.count(S::microImpacts)));
    row("capped", double(s.count(S::capped)));
    row("cpuSeconds", run.cpuSeconds);
    row
    (
        "particlesPerCpuSecond", run.cpuSeconds > 0 ? N/run.cpuSeconds : 0
    );
    row("complete", run.complete);
}


void Foam::writeResponseTable
(
    const fileName& folder,
    const scatteringSetup& setup
)
{
    mkDir(folder);
    const label n = setup.tableSamples;
    const double radius = setup.sampler.body.radius();
    const double degrees = 180/M_PI;

    textFile f(folder/"responseTable.csv");
    f.print
    (
        "# scatteringResponse version 1\n"
        "# A row is one particle; rows of an incidence are in the order of"
        " alpha2, so that row k of one and of the next angle of incidence"
        " are the same quantile of alpha2.\n"
        "# speedRatio = |V2|/|V1|, spin = omega2 %.10g/|V1| in laboratory"
        " axes (x along the wall, y normal to it)\n"
        "# nIncidences %ld nRows %ld\n"
        "alpha1_deg,alpha2_deg,beta2_deg,speedRatio,spinX,spinY,spinZ\n",
        radius, long(setup.incidences.size()), long(n)
    );
    for (const scalar incidence : setup.incidences)
    {
        impact::scatteringSampler::setup one(setup.sampler);
        one.incidence = incidence;
        const impact::scatteringSampler sampler(one);
        std::vector<impact::visitResult> results = sampler.visits(0, n);
        struct line
        {
            double alpha, beta, speed;
            impact::vector3 spin;
        };
        std::vector<line> lines;
        for (const impact::visitResult& r : results)
        {
            const impact::vector3& V = r.state.V;
            const impact::rotationState& rotation = r.state.rotation;
            const double unit = radius/one.speed;
            lines.push_back
            ({
                degrees*std::atan2(V.y, V.x),
                degrees*std::atan2(V.z, std::hypot(V.x, V.y)),
                mag(V)/one.speed,
                {
                    unit*dot(rotation.omega, rotation.ex),
                    unit*dot(rotation.omega, rotation.ey),
                    unit*dot(rotation.omega, rotation.ez())
                }
            });
        }
        std::sort
        (
            lines.begin(), lines.end(),
            [](const line& a, const line& b) { return a.alpha < b.alpha; }
        );
        for (const line& l : lines)
        {
            f.print
            (
                "%.6g,%.6g,%.6g,%.6g,%.5g,%.5g,%.5g\n",
                incidence, l.alpha, l.beta, l.speed,
                l.spin.x, l.spin.y, l.spin.z
            );
        }
    }
}
