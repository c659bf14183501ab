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
        Write responseTable.csv: sampled responses against the incidence.

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
    run with what was gathered so far, labelled with its number of particles.

    Entries: see etc/caseDicts/annotated/scatteringIndicatrixDict.
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "IFstream.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "scatteringOutput.H"
#include "utilityTools.H"

#include <chrono>
#include <csignal>
#include <ctime>
#include <future>

namespace
{

using namespace Foam;

std::atomic<bool> stopped(false);

void onInterrupt(int)
{
    stopped = true;
}


double cpuSeconds()
{
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return t.tv_sec + 1e-9*t.tv_nsec;
}


//- Statistics of all processes, on the master
impact::scatteringStatistics gathered
(
    const impact::scatteringSampler& sampler,
    const impact::scatteringStatistics& own
)
{
    impact::scatteringStatistics all(own);
    if (Pstream::parRun())
    {
        const std::vector<int64_t> packed(own.pack());
        List<List<int64_t>> data(Pstream::nProcs());
        data[Pstream::myProcNo()] =
            List<int64_t>(UList<int64_t>
            (
                const_cast<int64_t*>(packed.data()), label(packed.size())
            ));
        Pstream::gatherList(data);
        if (Pstream::master())
        {
            for (label i = 1; i < data.size(); ++i)
            {
                impact::scatteringStatistics other(sampler.emptyStatistics());
                other.unpack
                (
                    std::vector<int64_t>(data[i].begin(), data[i].end())
                );
                all.add(other);
            }
        }
    }
    return all;
}


//- Sample all particles of one angle of incidence and write the results
void run
(
    const scatteringSetup& setup,
    scalar incidence,
    const fileName& folder,
    const fileName& stopFile,
    int threads
)
{
    impact::scatteringSampler::setup one(setup.sampler);
    one.incidence = incidence;
    const impact::scatteringSampler sampler(one);
    impact::scatteringStatistics own(sampler.emptyStatistics());
    impact::scatteringStatistics all(own);
    std::vector<convergencePoint> convergence;

    const double cpuStart = cpuSeconds();
    const auto wallStart = std::chrono::steady_clock::now();
    double lastReport = 0;
    const int64_t N = setup.nParticles;
    const int64_t block = impact::scatteringSampler::blockSize;
    const int64_t nBlocks = (N + block - 1)/block;
    std::atomic<int64_t> done(0);

    // The error is looked at after numbers of particles fixed beforehand, so
    // that a run that stops at targetError stops at the same one always.
    // Threads and processes wait for each other then: no more often than
    // is needed.
    const int64_t parts = setup.targetError > 0 ? 4 : 1;
    int64_t from = 0;
    double cpu = 0;
    bool complete = false;
    while (!complete && !stopped)
    {
        const int64_t to =
            std::min(nBlocks, std::max(from + 1, from + from/parts));
        auto round = std::async(std::launch::async, [&]
        {
            sampler.sample
            (
                from*block, std::min(to*block, N),
                Pstream::myProcNo(), Pstream::nProcs(), threads,
                stopped, done, own
            );
        });
        while
        (
            round.wait_for(std::chrono::milliseconds(500))
         != std::future_status::ready
        )
        {
            if (Pstream::parRun() && isFile(stopFile))
            {
                stopped = true;
            }
            const double elapsed = std::chrono::duration<double>
            (
                std::chrono::steady_clock::now() - wallStart
            ).count();
            if (elapsed > lastReport + 5)
            {
                lastReport = elapsed;
                const double share =
                    double(done)*Pstream::nProcs()/double(N);
                Info<< "    " << 100*share << " %, remaining "
                    << elapsed*(1/max(share, 1e-12) - 1) << " s" << endl;
            }
        }
        round.get();
        from = to;

        bool stop = stopped;
        reduce(stop, orOp<bool>());
        stopped = stop;
        cpu = cpuSeconds() - cpuStart;
        reduce(cpu, sumOp<scalar>());
        all = gathered(sampler, own);
        complete = to == nBlocks && !stop;
        if (Pstream::master())
        {
            const double error = all.largestError();
            convergence.push_back
            ({
                all.count(impact::scatteringStatistics::particles), error, cpu
            });
            if (!stop && error < setup.targetError)
            {
                complete = true;
            }
        }
        Pstream::scatter(complete);
    }

    if (Pstream::master())
    {
        writeScattering(folder, all, convergence, cpu, complete);
        const double n =
            double(all.count(impact::scatteringStatistics::particles));
        Info<< "incidence " << incidence << " deg: "
            << n << " particles" << (complete ? "" : " (interrupted)")
            << ", alpha2 " << all.meanAlpha() << " +- "
            << all.deviationAlpha() << " deg, mode " << all.modeAlpha()
            << " deg, largest relative standard error "
            << convergence.back().error << ", "
            << n/max(cpu, 1e-9) << " particles per CPU second" << endl;
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
    argList::noFunctionObjects();
    argList::noCheckProcessorDirectories();
    argList::addOption
    (
        "threads",
        "N",
        "Threads of each process (default: OMP_NUM_THREADS, else 1)"
    );
    argList::addBoolOption
    (
        "table",
        "Write the sampled response as a function of the incidence"
    );
    argList::addBoolOption("noPlot", "Do not call the plot script");
    argList args(argc, argv);

    const fileName casePath(args.globalPath());
    const fileName dictFile(casePath/"system/scatteringIndicatrixDict");
    IFstream is(dictFile);
    if (!is.good())
    {
        FatalErrorInFunction
            << "Cannot read " << dictFile << exit(FatalError);
    }
    const dictionary dict(is);
    const scatteringSetup setup(dict, casePath);

    label threads = 1;
    const string environment(getEnv("OMP_NUM_THREADS"));
    if (!environment.empty())
    {
        threads = std::max(1, std::atoi(environment.c_str()));
    }
    args.readIfPresent("threads", threads);
    if (threads < 1 || threads > 1024)
    {
        FatalErrorInFunction
            << "-threads " << threads << ": valid range 1 to 1024"
            << exit(FatalError);
    }

    // OpenFOAM's handler of Ctrl-C would end the process at once
    std::signal(SIGINT, onInterrupt);
    const fileName stopFile(casePath/"system/stopScatteringIndicatrix");

    const fileName folder(casePath/"postProcessing/scatteringIndicatrix");
    const bool sweep = setup.incidences.size() > 1;
    for (const scalar incidence : setup.incidences)
    {
        const fileName target
        (
            sweep ? folder/("incidence_" + Foam::name(incidence)) : folder
        );
        run(setup, incidence, target, stopFile, threads);
        if (Pstream::master() && !args.found("noPlot"))
        {
            plotResults("scatteringIndicatrix", target);
        }
        if (stopped)
        {
            break;
        }
    }
    if (args.found("table") && Pstream::master() && !stopped)
    {
        writeResponseTable(folder, setup);
    }
    if (Pstream::master() && stopped && Pstream::parRun())
    {
        rm(stopFile);
    }

    Info<< "End" << endl;
    return 0;
}
