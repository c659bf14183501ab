/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "runSummary.H"
#include "allGather.H"
#include "processorTime.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "messageStream.H"
#include "scalarField.H"

#include <algorithm>
#include <iomanip>
#include <numeric>
#include <sstream>

#include <sys/resource.h>

namespace
{

//- A cell of a table
std::string padded(const Foam::scalar number, const int decimals)
{
    std::ostringstream text;
    text<< std::fixed << std::setprecision(decimals) << number;
    return text.str();
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::string Foam::runSummary::timeTable() const
{
    std::vector<std::string> names(parts_);
    std::vector<scalar> times(times_);
    const scalar all =
        returnReduce(processorTime::now(), sumOp<scalar>());
    scalar rest = all;
    for (scalar& time : times)
    {
        time = returnReduce(time, sumOp<scalar>());
        rest -= time;
    }
    names.push_back("rest");
    times.push_back(rest);
    names.push_back("in all");
    times.push_back(all);

    std::ostringstream text;
    text<< std::left << std::setw(32) << "    processor time, all ranks"
        << std::right << std::setw(12) << "CPU s" << std::setw(11) << "share"
        << '\n';
    for (std::size_t i = 0; i < names.size(); ++i)
    {
        text<< std::left << std::setw(32) << "    " + names[i] << std::right
            << std::setw(12) << padded(times[i], 3) << std::setw(9)
            << padded(100*times[i]/std::max(all, SMALL), 1) << " %\n";
    }
    return text.str();
}


std::string Foam::runSummary::particleTable() const
{
    std::ostringstream text;
    text<< std::left << std::setw(20) << "    particles" << std::right;
    for
    (
        const char* title
      : {"at start", "injected", "in flight", "escaped", "stuck", "lost"}
    )
    {
        text<< std::setw(11) << title;
    }
    text<< '\n';
    for (const balance& b : balances_)
    {
        text<< std::left << std::setw(20) << "    " + b.name << std::right;
        for (const scalar n : {b.start, b.injected, b.inFlight})
        {
            text<< std::setw(11) << padded(n, 0);
        }
        for (const scalar n : {b.escaped, b.stuck, b.lost()})
        {
            text<< std::setw(11) << (b.fatesKnown ? padded(n, 0) : "unknown");
        }
        text<< '\n';
    }
    return text.str();
}


std::string Foam::runSummary::rankTable() const
{
    rusage used;
    getrusage(RUSAGE_SELF, &used);

    // Columns, by rank
    std::vector<std::string> titles{"CPU s", "peak MB"};
    std::vector<int> decimals{1, 0};
    std::vector<scalarList> columns(2 + tasks_.size());
    const auto gather = [](scalarList& column, const scalar value)
    {
        column.resize(Pstream::nProcs());
        column[Pstream::myProcNo()] = value;
        foamCompat::allGather(column);
    };
    gather(columns[0], processorTime::now());
    gather(columns[1], used.ru_maxrss/1024.0);

    // Of what has been measured: to start and to wait may take longer than
    // the run itself where processors are shared
    scalarList measured;
    gather(measured, std::accumulate(times_.begin(), times_.end(), scalar(0)));
    for (std::size_t i = 0; i < tasks_.size(); ++i)
    {
        const task& t = tasks_[i];
        titles.push_back(t.name);
        decimals.push_back(0);
        scalarList& steps = columns[2 + i];
        gather(steps, t.steps);

        const scalar mean = average(steps);
        const label most = findMax(steps);
        scalarList times;
        gather(times, t.time);
        const bool counts =
            sum(steps) > 1e5 && times[most] > 0.2*measured[most];
        if (counts && steps[most] >= 2*mean)
        {
            WarningInFunction
                << "Rank " << most << " has done "
                << 0.1*round(10*steps[most]/mean) << " times the mean number"
                << " of particle steps (" << t.name.c_str() << "), and others"
                << " have waited for it. Write 'decompositionWeights yes;' in "
                << (t.name == "molecules" || t.name == "solids"
                  ? "constant/dsmcProperties" : "constant/parcelClouds")
                << " and 'weightField decompositionWeights;' in"
                << " system/decomposeParDict" << endl;
        }
    }

    std::ostringstream text;
    const auto line = [&](const std::string& name, const auto& number)
    {
        text<< std::left << std::setw(20) << "    " + name << std::right;
        for (std::size_t k = 0; k < columns.size(); ++k)
        {
            text<< std::setw(max(15, int(titles[k].size()) + 2)) << number(k);
        }
        text<< '\n';
    };
    line("rank", [&](const std::size_t k) { return titles[k]; });

    // Of very many ranks the last line says enough
    const label nLines = Pstream::nProcs() <= 64 ? Pstream::nProcs() : 0;
    for (label rank = 0; rank < nLines; ++rank)
    {
        line
        (
            std::to_string(rank),
            [&](const std::size_t k)
            {
                return padded(columns[k][rank], decimals[k]);
            }
        );
    }
    line
    (
        "most over mean",
        [&](const std::size_t k)
        {
            return padded(max(columns[k])/max(average(columns[k]), SMALL), 2);
        }
    );
    return text.str();
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::runSummary::runSummary()
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::runSummary::part(const std::string& name, const scalar time)
{
    parts_.push_back(name);
    times_.push_back(time);
}


void Foam::runSummary::particles(const balance& b)
{
    balances_.push_back(b);
}


void Foam::runSummary::work
(
    const std::string& name,
    const scalar steps,
    const scalar time
)
{
    tasks_.push_back({name, steps, time});
}


void Foam::runSummary::print() const
{
    // (May warn)
    const std::string ranks(Pstream::parRun() ? rankTable() : "");
    Info<< nl << "Summary of this run" << nl << timeTable().c_str();
    if (balances_.size())
    {
        Info<< nl << particleTable().c_str();
    }
    if (Pstream::parRun())
    {
        Info<< nl << ranks.c_str();
    }
    Info<< nl << "    warnings"
        << (warnings_.kinds().empty() ? ": none" : ", each once") << nl;
    for (const warningCounter::kind& k : warnings_.kinds())
    {
        Info<< "    " << k.count << " x " << k.message.c_str();
        if (k.place != k.message)
        {
            Info<< " (" << k.place.c_str() << ')';
        }
        Info<< nl;
    }
    Info<< endl;
}


// ************************************************************************* //
