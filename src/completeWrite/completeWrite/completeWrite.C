/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "completeWrite.H"
#include "OSspecific.H"
#include "OFstream.H"
#include "PstreamReduceOps.H"

namespace Foam
{

static fileName markFolder(const Time& runTime, const word& timeName)
{
    return runTime.path()/timeName/"uniform";
}

} // End namespace Foam


bool Foam::completeWrite::incomplete
(
    const Time& runTime,
    const word& timeName
)
{
    const bool here = isFile(markFolder(runTime, timeName)/"incomplete");
    return returnReduce(here, orOp<bool>());
}


void Foam::completeWrite::findStart(Time& runTime)
{
    if (!incomplete(runTime, runTime.timeName()))
    {
        return;
    }

    const word refused(runTime.timeName());
    const instantList times(runTime.times());

    for (label i = times.size() - 1; i >= 0; i--)
    {
        const instant& candidate = times[i];
        if
        (
            candidate.name() != runTime.constant()
         && candidate.value() < runTime.value()
         && !incomplete(runTime, candidate.name())
        )
        {
            Info<< "Time directory " << refused << " was not written to its"
                << " end: starting from " << candidate.name() << " instead"
                << nl << endl;
            runTime.setTime(candidate, i);
            return;
        }
    }

    FatalErrorInFunction
        << "Time directory " << refused << " was not written to its end, and"
        << " there is no complete one before it to start from."
        << exit(FatalError);
}


void Foam::completeWrite::begin(const Time& runTime)
{
    const fileName folder(markFolder(runTime, runTime.timeName()));
    mkDir(folder);
    rm(folder/"complete");
    OFstream mark(folder/"incomplete");
    mark<< "being written" << endl;
}


void Foam::completeWrite::end(const Time& runTime)
{
    label everyone = 1;
    reduce(everyone, sumOp<label>());

    const fileName folder(markFolder(runTime, runTime.timeName()));
    mv(folder/"incomplete", folder/"complete");
}


bool Foam::completeWrite::write(Time& runTime)
{
    if (!runTime.writeTime())
    {
        return false;
    }
    begin(runTime);
    runTime.write();
    end(runTime);
    return true;
}


void Foam::completeWrite::writeNow(Time& runTime)
{
    begin(runTime);
    runTime.writeNow();
    end(runTime);
}
