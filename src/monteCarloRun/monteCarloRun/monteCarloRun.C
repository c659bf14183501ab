/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "monteCarloRun.H"
#include "plotResults.H"
#include "csvFile.H"

#include "IFstream.H"
#include "OSspecific.H"

#include <cctype>
#include <csignal>
#include <ctime>

namespace
{

void onInterrupt(int)
{
    Foam::monteCarloStop() = true;
}


//- A file that ends the run when it appears
Foam::fileName stopFile
(
    const Foam::fileName& casePath,
    Foam::word application
)
{
    application[0] = char(std::toupper(application[0]));
    return casePath/"system"/("stop" + application);
}

} // End anonymous namespace


std::atomic<bool>& Foam::monteCarloStop()
{
    static std::atomic<bool> stop(false);
    return stop;
}


void Foam::writeConvergence
(
    const fileName& file,
    const std::vector<convergencePoint>& points
)
{
    csvFile f(file, "N,largestRelativeStdError,cpuSeconds", 6);
    for (const convergencePoint& p : points)
    {
        f.row(p.N, p.error, p.cpuSeconds);
    }
}


void Foam::monteCarloRun::addOptions()
{
    argList::noFunctionObjects();
    argList::noCheckProcessorDirectories();
    argList::addOption
    (
        "threads",
        "N",
        "Threads of each process (default: OMP_NUM_THREADS, else 1)"
    );
    argList::addBoolOption("noPlot", "Do not call the plot script");
}


Foam::monteCarloRun::monteCarloRun
(
    const argList& args,
    const word& application
)
:
    application_(application),
    casePath_(args.globalPath()),
    threads_(1),
    plots_(!args.found("noPlot"))
{
    const string environment(getEnv("OMP_NUM_THREADS"));
    if (!environment.empty())
    {
        threads_ = std::max(1, std::atoi(environment.c_str()));
    }
    args.readIfPresent("threads", threads_);
    if (threads_ < 1 || threads_ > 1024)
    {
        FatalErrorInFunction
            << "-threads " << threads_ << ": valid range 1 to 1024"
            << exit(FatalError);
    }

    // OpenFOAM's handler of Ctrl-C would end the process at once. The flag
    // must exist before ours can be called.
    monteCarloStop();
    std::signal(SIGINT, onInterrupt);

    // One that an earlier run ended without seeing would stop this one
    const fileName file(stopFile(casePath_, application_));
    if (Pstream::parRun())
    {
        if (Pstream::master() && isFile(file) && rm(file))
        {
            WarningInFunction
                << "removed " << file << " of an earlier run: while this one"
                << " goes on, write it again to end it" << endl;
        }
        bool removed = true;
        Pstream::scatter(removed);
    }
}


Foam::dictionary Foam::monteCarloRun::readDictionary() const
{
    const fileName file(casePath_/"system"/(application_ + "Dict"));
    IFstream is(file);
    if (!is.good())
    {
        FatalErrorInFunction
            << "Cannot read " << file << exit(FatalError);
    }
    return dictionary(is);
}


bool Foam::monteCarloRun::stopped() const
{
    return monteCarloStop();
}


double Foam::monteCarloRun::cpuSeconds()
{
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9*double(t.tv_nsec);
}


void Foam::monteCarloRun::watch
(
    const std::function<void()>& round,
    const std::atomic<int64_t>& done,
    int64_t nParticles,
    const std::chrono::steady_clock::time_point& start
) const
{
    static double lastReport = 0;
    auto working = std::async(std::launch::async, round);
    const fileName file(stopFile(casePath_, application_));
    while
    (
        working.wait_for(std::chrono::milliseconds(500))
     != std::future_status::ready
    )
    {
        if (Pstream::parRun() && isFile(file))
        {
            monteCarloStop() = true;
        }
        const double elapsed = std::chrono::duration<double>
        (
            std::chrono::steady_clock::now() - start
        ).count();
        lastReport = std::min(lastReport, elapsed);
        if (elapsed > lastReport + 5)
        {
            lastReport = elapsed;
            const double share =
                double(done)*Pstream::nProcs()/double(nParticles);
            Info<< "    " << 100*share << " %, ";
            if (share > 0)
            {
                Info<< "remaining " << elapsed*(1/share - 1) << " s" << endl;
            }
            else
            {
                Info<< "none done after " << elapsed << " s" << endl;
            }
        }
    }
    working.get();
}


void Foam::monteCarloRun::plot(const fileName& folder) const
{
    if (plots_ && Pstream::master())
    {
        plotResults(application_, folder);
    }
}


void Foam::monteCarloRun::endAtOnce() const
{
    std::signal(SIGINT, SIG_DFL);
}


void Foam::monteCarloRun::finish() const
{
    if (Pstream::master() && stopped() && Pstream::parRun())
    {
        rm(stopFile(casePath_, application_));
    }
    Info<< "End" << endl;
}
