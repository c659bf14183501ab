/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "completeWrite.H"
#include "OSspecific.H"
#include "OFstream.H"
#include "PstreamReduceOps.H"
#include "DynamicList.H"
#include "HashSet.H"

namespace Foam
{

static fileName markFolder(const Time& runTime, const word& timeName)
{
    return runTime.path()/timeName/"uniform";
}

} // End namespace Foam


bool Foam::completeWrite::unfinished(const fileName& timeFolder)
{
    if (isFile(timeFolder/"uniform"/"incomplete"))
    {
        return true;
    }

    // Killed between making the directory and marking it
    return
        !isFile(timeFolder/"uniform"/"complete")
     && readDir(timeFolder, fileName::FILE).empty()
     && readDir(timeFolder/"uniform", fileName::FILE).empty()
     && !isDir(timeFolder/"lagrangian")
     && !isDir(timeFolder/"polyMesh");
}


void Foam::completeWrite::setAsideUnfinished(const argList& args)
{
    List<wordList> names(Pstream::nProcs());
    {
        DynamicList<word> here;
        for (const instant& t : TimePaths::findTimes(args.path(), "constant"))
        {
            if (t.name() != "constant" && unfinished(args.path()/t.name()))
            {
                here.append(t.name());
            }
        }
        names[Pstream::myProcNo()] = here;
    }
    Pstream::gatherList(names);
    Pstream::scatterList(names);

    // Unfinished on one rank is unfinished on all
    wordHashSet all;
    for (const wordList& list : names)
    {
        all.insert(list);
    }

    bool start = false;
    for (const instant& t : TimePaths::findTimes(args.path(), "constant"))
    {
        start = start || (t.name() != "constant" && !all.found(t.name()));
    }
    if (!all.empty() && !returnReduce(start, orOp<bool>()))
    {
        FatalErrorInFunction
            << "Time directories " << flatOutput(all.sortedToc())
            << " were not written to their end, and there is no complete one"
            << " to start from." << exit(FatalError);
    }

    for (const word& name : all.sortedToc())
    {
        Info<< "Time directory " << name << " was not written to its end:"
            << " set aside as " << name << ".unfinished" << nl << endl;

        const fileName folder(args.path()/name);
        if (isDir(folder))
        {
            rmDir(folder + ".unfinished", true);
            mv(folder, folder + ".unfinished");
        }
    }
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
