/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Application
    scatteringIndicatrix

Group
    grpPreProcessingUtilities

Description
    Samples how particles of a given shape are scattered by a smooth or rough
    wall, and writes the distribution of their directions.

Usage
    \b scatteringIndicatrix [OPTION]

      - \par -case DIR
        The case; needs DIR/system/scatteringIndicatrixDict only.

      - \par -threads N
        Number of threads of each process; default OMP_NUM_THREADS, else 1.

      - \par -table
        Write responseTable.csv: sampled responses against the incidence
        and, if the law depends on it, the speed.

      - \par -noPlot
        Do not call the plot script.

      - \par -parallel
        Divide the particles among MPI processes. Needs no decomposition.

    Results in postProcessing/scatteringIndicatrix, with a sub-folder
    incidence_<value> for each angle of a sweep: F.csv, I.csv, summary.csv,
    convergence.csv and, where python3 with matplotlib is found, F.png and
    I.png. The histograms depend on the dictionary alone, not on the number
    of threads and processes.

    Ctrl-C, or a file system/stopScatteringIndicatrix under mpirun, ends the
    run with what was gathered so far, labelled with its number of particles;
    while the table is sampled, without a table.

    Entries: see etc/caseDicts/annotated/scatteringIndicatrixDict.
\*---------------------------------------------------------------------------*/

#include "monteCarloRun.H"
#include "release.H"
#include "scatteringOutput.H"

namespace
{

using namespace Foam;

//- Sample all particles of one angle of incidence and write the results
void run
(
    const monteCarloRun& monteCarlo,
    const scatteringSetup& setup,
    scalar incidence,
    const fileName& folder
)
{
    typedef impact::scatteringStatistics statistics;
    impact::scatteringSampler::setup one(setup.sampler);
    one.incidence = incidence;
    const impact::scatteringSampler sampler(one);
    const int64_t N = setup.nParticles;
    const int64_t block = impact::scatteringSampler::blockSize;
    statistics all(sampler.emptyStatistics());
    const monteCarloRun::result r = monteCarlo.sample
    (
        (N + block - 1)/block, N, setup.targetError,
        sampler.emptyStatistics(), all,
        [&]
        (
            int64_t from, int64_t to, int proc, int nProcs, int threads,
            const std::atomic<bool>& stop, std::atomic<int64_t>& done,
            statistics& own
        )
        {
            sampler.sample
            (
                from*block, std::min(to*block, N), proc, nProcs, threads,
                stop, done, own
            );
        },
        [](const statistics& s) { return s.count(statistics::particles); },
        [](const statistics& s) { return s.largestError(); }
    );

    if (Pstream::master())
    {
        writeScattering(folder, all, r);
        const double n = double(all.count(statistics::particles));
        Info<< "incidence " << incidence << " deg: "
            << n << " particles" << (r.complete ? "" : " (interrupted)")
            << ", alpha2 " << all.meanAlpha() << " +- "
            << all.deviationAlpha() << " deg, mode " << all.modeAlpha()
            << " deg, largest relative standard error "
            << r.convergence.back().error << ", "
            << n/max(r.cpuSeconds, 1e-9) << " particles per CPU second"
            << endl;

        const double capped = all.count(statistics::capped)/max(n, 1.0);
        if (capped > 0.01)
        {
            WarningInFunction
                << 100*capped << " % of the particles were still at the wall"
                << " after as many impacts as are followed (capped in"
                << " summary.csv): they are binned as they were then. A law"
                << " that leaves them no velocity off the wall has no"
                << " scattering; raise restitution or maxImpacts" << endl;
        }
    }
}

} // End anonymous namespace


int main(int argc, char* argv[])
{
    argList::addNote
    (
        "Scattering of particles by a smooth or rough wall:"
        " distribution of their directions"
    );
    monteCarloRun::addOptions();
    argList::addBoolOption
    (
        "table",
        "Write the sampled response as a function of the incidence and,"
        " if the law depends on it, of the speed"
    );
    argList args(argc, argv);
    foamCompat::printRelease();
    const monteCarloRun monteCarlo(args, "scatteringIndicatrix");
    const scatteringSetup setup
    (
        monteCarlo.readDictionary(), monteCarlo.casePath(),
        args.found("table")
    );

    const fileName folder(monteCarlo.folder());
    const bool sweep = setup.incidences.size() > 1;
    for (const scalar incidence : setup.incidences)
    {
        const fileName target
        (
            sweep ? folder/("incidence_" + Foam::name(incidence)) : folder
        );
        run(monteCarlo, setup, incidence, target);
        monteCarlo.plot(target);
        if (monteCarlo.stopped())
        {
            break;
        }
    }
    if (args.found("table") && Pstream::master() && !monteCarlo.stopped())
    {
        Info<< "Sampling the response table (Ctrl-C ends without it)" << endl;
        monteCarlo.endAtOnce();
        writeResponseTable(folder, setup);
    }
    monteCarlo.finish();
    return 0;
}
