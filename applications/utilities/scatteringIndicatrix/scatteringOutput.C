/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "scatteringOutput.H"
#include "csvFile.H"

#include "OSspecific.H"
#include "scatteringTable.H"

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
        csvFile f(folder/"F.csv", "alpha2_deg,F_per_rad,stdError", 10);
        for (int i = 0; i < n; ++i)
        {
            f.row(s.alphaCentre(i), s.F(i), s.standardError(i));
        }
    }
    {
        csvFile f(folder/"I.csv", "alpha2_deg,beta2_deg,I", 10);
        for (int i = 0; i < n; ++i)
        {
            for (int j = 0; j < n; ++j)
            {
                f.row(s.alphaCentre(i), s.betaCentre(j), s.I(i, j));
            }
        }
    }
    writeConvergence(folder/"convergence.csv", run.convergence);

    const double N = double(s.count(S::particles));
    const double perParticle = N > 0 ? 1/N : 0;
    const double all =
        double(s.count(S::impacts) + s.count(S::microImpacts));
    const double perImpact = all > 0 ? 1/all : 0;
    csvFile f(folder/"summary.csv", "quantity,value");
    auto row = [&](const char* name, double value)
    {
        f.row(name, value);
    };
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
    row("outsideOfCoefficients", s.count(S::outside)*perImpact);
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
    std::vector<double> incidences
    (
        setup.incidences.begin(), setup.incidences.end()
    );
    std::sort(incidences.begin(), incidences.end());
    incidences.erase
    (
        std::unique(incidences.begin(), incidences.end()), incidences.end()
    );
    const impact::scatteringTable table
    (
        setup.sampler, incidences, setup.tableSamples, setup.tableSpeeds
    );
    textFile f(folder/"responseTable.csv");
    table.write([&](const char* text) { f.print(text); });
}
