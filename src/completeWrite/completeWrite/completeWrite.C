/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "completeWrite.H"
#include "allGather.H"
#include "OSspecific.H"
#include "OFstream.H"
#include "fileOperation.H"
#include "PstreamReduceOps.H"
#include "DynamicList.H"
#include "HashSet.H"
#include "SHA1.H"
#include "checked.H"
#include "cloud.H"
#include "fastNumberOutput.H"
#include "finishFile.H"
#include "polyMesh.H"
#include "processorTime.H"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <sstream>
#include <vector>
#include <sys/statvfs.h>

namespace Foam
{

// When this process began, in the time of files [s]
static const double processBegan =
    std::chrono::duration<double>
    (
        std::chrono::system_clock::now().time_since_epoch()
    ).count();


// First word of the list that a mark holds. A mark without it is one of an
// earlier version, or was copied by decomposePar or reconstructPar.
static const std::string listTitle("files of ");


// Files below a folder, by their path in it
static void filesBelow
(
    const fileName& top,
    const fileName& relative,
    DynamicList<fileName>& files
)
{
    const fileName folder(relative.empty() ? top : top/relative);
    const auto below = [&](const fileName& name)
    {
        return relative.empty() ? name : relative/name;
    };
    for (const fileName& name : readDir(folder, fileName::FILE, false))
    {
        if (below(name).path() != "uniform" || !name.ends_with("complete"))
        {
            files.append(below(name));
        }
    }
    for (const fileName& name : readDir(folder, fileName::DIRECTORY, false))
    {
        // Written by function objects, which come after the fields
        if (below(name) != "uniform/functionObjects")
        {
            filesBelow(top, below(name), files);
        }
    }
}


// Does a text end with the line that OpenFOAM writes last?
static bool endsAsWritten(const std::string& text)
{
    const std::string last("* //\n");
    return
        text.size() >= last.size()
     && text.compare(text.size() - last.size(), last.size(), last) == 0;
}


// Size and checksum of a file, as they stand in the list; whether it ends as
// OpenFOAM's files do
static std::string contents(const fileName& file, bool& whole)
{
    std::ifstream is(file, std::ios::binary);
    std::vector<char> buffer(1 << 20);
    SHA1 sum;
    std::string head, tail;
    long long size = 0;
    while (is)
    {
        is.read(buffer.data(), buffer.size());
        const std::size_t n = is.gcount();
        if (!n)
        {
            break;
        }
        sum.append(buffer.data(), n);
        if (!size)
        {
            head.assign(buffer.data(), std::min(n, std::size_t(200)));
        }
        const std::size_t end = std::min(n, std::size_t(100));
        tail.append(buffer.data() + n - end, end);
        if (tail.size() > 100)
        {
            tail.erase(0, tail.size() - 100);
        }
        size += n;
    }
    const bool banner =
        head.compare(0, 2, "/*") == 0
     && head.find("*- C++ -*-") != std::string::npos;
    whole =
        size > 0
     && (!banner || endsAsWritten(tail));

    std::ostringstream text;
    text<< size << ' ' << sum.str();
    return text.str();
}


// Why a file that the stock writers took for written was cut off
static int whyCut(const fileName& folder)
{
    struct statvfs space;
    return
        ::statvfs(folder.c_str(), &space) == 0 && space.f_bavail == 0
      ? ENOSPC : 0;
}


static const char* const goOn =
    ", it was not written to its end. The run can be continued from the time"
    " directory before";


// Which directory a mark belongs to: decomposePar copies that of the whole
// mesh to all processors, reconstructPar that of the first processor back
static std::string ownerOf(const Time& runTime)
{
    std::ostringstream text;
    text<< listTitle;
    if (Pstream::parRun())
    {
        text<< "processor " << Pstream::myProcNo() << " of "
            << Pstream::nProcs();
    }
    else
    {
        text<< "the whole mesh";
    }
    return text.str();
}


static fileName markFolder(const Time& runTime, const word& timeName)
{
    return runTime.path()/timeName/"uniform";
}

//- Each rank marks the files of its own
static void refuseCollated()
{
    const word handler(fileHandler().type());
    if (Pstream::parRun() && handler != "uncollated")
    {
        FatalErrorInFunction
            << "Files that ranks write or read together (fileHandler "
            << handler << ") cannot be marked as written to their end." << nl
            << "Decompose and run without it, or with -fileHandler uncollated"
            << exit(FatalError);
    }
}

} // End namespace Foam

bool Foam::completeWrite::pending_ = false;

Foam::scalar Foam::completeWrite::cpuTime_ = 0;


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
    refuseCollated();

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
    foamCompat::allGather(names);

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
    finishFile(mark);

    // A cloud without parcels writes no files: those of a run before would
    // stay. Functions may have written theirs of this step already
    for (const polyMesh* mesh : runTime.lookupClass<polyMesh>())
    {
        for (const word& name : mesh->lookupClass<cloud>().toc())
        {
            const fileName folder
            (
                runTime.path()/runTime.timeName()/mesh->dbDir()/cloud::prefix
               /name
            );
            for (const fileName& file : readDir(folder, fileName::FILE, false))
            {
                if (highResLastModified(folder/file) < processBegan)
                {
                    rm(folder/file);
                }
            }
        }
    }
}


void Foam::completeWrite::changed(const Time& runTime)
{
    rm(markFolder(runTime, runTime.timeName())/"complete");
}


void Foam::completeWrite::end(const Time& runTime)
{
    const fileName top(runTime.path()/runTime.timeName());
    DynamicList<fileName> files;
    filesBelow(top, "", files);
    sort(files);

    OFstream mark(top/"uniform"/"incomplete");
    mark.stdStream() << ownerOf(runTime) << '\n';
    for (const fileName& file : files)
    {
        bool whole;
        const std::string text(contents(top/file, whole));
        if (!whole)
        {
            failedFile(top/file, whyCut(top), goOn);
        }
        mark.stdStream() << text << ' ' << file << '\n';
    }
    finishFile(mark);

    label everyone = 1;
    reduce(everyone, sumOp<label>());

    if (!mv(top/"uniform"/"incomplete", top/"uniform"/"complete"))
    {
        failedFile(top/"uniform"/"complete", errno);
    }
}


void Foam::completeWrite::checkStart(const Time& runTime)
{
    checkNumber
    (
        runTime.controlDict(), "deltaT", runTime.deltaTValue(),
        validRange::duration
    );

    const fileName top(runTime.path()/runTime.timeName());
    std::ifstream mark(top/"uniform"/"complete");
    std::string line;
    const bool own = std::getline(mark, line) && line == ownerOf(runTime);
    if (!returnReduce(own, andOp<bool>()))
    {
        // Of a case that was put together and decomposed anew all processors
        // have the list of the first
        return;
    }
    while (std::getline(mark, line))
    {
        std::istringstream words(line);
        std::string size, sum, name;
        words >> size >> sum;
        std::getline(words >> std::ws, name);
        const fileName file(top/name);
        std::string what;
        if (!isFile(file))
        {
            what = "is missing";
        }
        else
        {
            bool whole;
            if (contents(file, whole) != size + ' ' + sum)
            {
                what = "is not what the run has written";
            }
        }
        if (!what.empty())
        {
            FatalErrorInFunction
                << "File " << file << ' ' << what << ": its size or checksum"
                << " is not that of the list " << top/"uniform"/"complete"
                << nl << "Restore it, or start from another time. If it was"
                << " changed on purpose, and cells have the numbers they had"
                << " (renumberMesh belongs before the first run), remove that"
                << " list"
                << exit(FatalError);
        }
    }
}


bool Foam::completeWrite::write(Time& runTime)
{
    if (!runTime.writeTime())
    {
        return false;
    }
    const processorTime timer(cpuTime_);
    const fastNumberOutput fast;
    begin(runTime);
    withReason([&] { runTime.write(); }, goOn);
    pending_ = true;
    return true;
}


void Foam::completeWrite::writeNow(Time& runTime)
{
    const processorTime timer(cpuTime_);
    const fastNumberOutput fast;
    begin(runTime);
    withReason([&] { runTime.writeNow(); }, goOn);
    pending_ = true;
}


bool Foam::completeWrite::run(Time& runTime)
{
    const bool goesOn = runTime.run();
    if (pending_)
    {
        const processorTime timer(cpuTime_);
        end(runTime);
        pending_ = false;
    }
    return goesOn;
}
