/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "runSummary.H"
#include "processorTime.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "messageStream.H"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace
{

//- A cell of a table
std::string cell(const Foam::scalar number, const int decimals)
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
            << std::setw(12) << cell(times[i], 3) << std::setw(9)
            << cell(100*times[i]/std::max(all, SMALL), 1) << " %\n";
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
            text<< std::setw(11) << cell(n, 0);
        }
        for (const scalar n : {b.escaped, b.stuck, b.lost()})
        {
            text<< std::setw(11) << (b.fatesKnown ? cell(n, 0) : "unknown");
        }
        text<< '\n';
    }
    return text.str();
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::runSummary::runSummary()
:
    warnings_(),
    parts_(),
    times_(),
    balances_()
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


void Foam::runSummary::print() const
{
    Info<< nl << "Summary of this run" << nl << timeTable().c_str();
    if (balances_.size())
    {
        Info<< nl << particleTable().c_str();
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
