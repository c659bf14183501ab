/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Application
    freeMolecularPlume

Group
    grpPostProcessingUtilities

Description
    The far field of a two-phase plume in vacuum: where the solid particles
    of a rocket motor are at given times, and how hot, by test particles that
    fly freely and exchange radiation.

Usage
    \b freeMolecularPlume [OPTION]

      - \par -case DIR
        The case; needs DIR/system/freeMolecularPlumeDict only.

      - \par -threads N
        Number of threads of each process; default OMP_NUM_THREADS, else 1.

      - \par -noPlot
        Do not call the plot script.

      - \par -parallel
        Divide the particles among MPI processes. Needs no decomposition.

    Results in postProcessing/freeMolecularPlume/<time>: <grid>.csv and
    <grid>.vtk for each grid, groups.csv, summary.csv, convergence.csv and,
    where python3 with matplotlib is found, PNG pictures. All but the times
    of computing depend on the dictionary alone, not on the number of threads
    and processes.

    Ctrl-C, or a file system/stopFreeMolecularPlume under mpirun, ends the
    run with what was gathered so far, labelled with its number of particles.

    Entries: see etc/caseDicts/annotated/freeMolecularPlumeDict.
\*---------------------------------------------------------------------------*/

#include "monteCarloRun.H"
#include "plumeOutput.H"
#include "release.H"

namespace
{

using namespace Foam;

//- Sample one time of observation and write the results
void run
(
    const monteCarloRun& monteCarlo,
    const plumeSetup& setup,
    scalar time,
    const fileName& folder
)
{
    typedef impact::plumeStatistics statistics;
    const impact::plumeSampler sampler(setup.at(time));
    const statistics empty(sampler.emptyStatistics());
    statistics all(empty);
    const monteCarloRun::result r = monteCarlo.sample
    (
        sampler.nBlocks(), setup.sampler.nParticles, setup.targetError,
        empty, all,
        [&]
        (
            int64_t from, int64_t to, int proc, int nProcs, int threads,
            const std::atomic<bool>& stop, std::atomic<int64_t>& done,
            statistics& own
        )
        {
            sampler.sample(from, to, proc, nProcs, threads, stop, done, own);
        },
        [](const statistics& s) { return s.sampled(); },
        [](const statistics& s) { return s.largestError(); }
    );
    if (!Pstream::master())
    {
        return;
    }

    writePlume(folder, setup, sampler, all, r);
    const double n = double(all.sampled());
    Info<< "time " << time << " s: " << n << " test particles"
        << (r.complete ? "" : " (interrupted)");
    if (n > 0)
    {
        Info<< ", largest relative standard error "
            << r.convergence.back().error << ", "
            << n/max(r.cpuSeconds, 1e-9) << " particles per CPU second";
    }
    else if (r.complete)
    {
        Info<< ", before ignition at " << setup.sampler.burnStart << " s";
    }
    Info<< nl;
    for (int g = 0; g < all.nGroups() && n > 0; ++g)
    {
        Info<< "    diameter " << setup.sampler.source->groups()[g].diameter
            << " m: 99.8 % from x = " << all.quantile(g, 0.001) << " to "
            << all.quantile(g, 0.999) << " m, mean temperature "
            << all.temperature(g).value << " K" << nl;
    }
    Info<< flush;
}

} // End anonymous namespace


int main(int argc, char* argv[])
{
    argList::addNote
    (
        "Far field of the solid particles of a plume in vacuum,"
        " by test particles"
    );
    monteCarloRun::addOptions();
    argList args(argc, argv);
    foamCompat::printRelease();
    const monteCarloRun monteCarlo(args, "freeMolecularPlume");
    const plumeSetup setup
        (monteCarlo.readDictionary(), monteCarlo.casePath());
    if (setup.nRecords)
    {
        Info<< setup.nRecords << " records, "
            << label(setup.sampler.source->groups().size()) << " groups"
            << endl;
    }

    for (const scalar time : setup.times)
    {
        const fileName target(monteCarlo.folder()/Foam::name(time));
        run(monteCarlo, setup, time, target);
        monteCarlo.plot(target);
        if (monteCarlo.stopped())
        {
            break;
        }
    }
    monteCarlo.finish();
    return 0;
}
