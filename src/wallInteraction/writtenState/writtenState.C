/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "writtenState.H"
#include "IOdictionary.H"
#include "PstreamReduceOps.H"
#include "pastWrite.H"
#include "Time.H"

namespace
{

using namespace Foam;

const word block("writtenState");
const word parcels("parcels");


//- The output properties of a cloud, nullptr if it has none
IOdictionary* properties(const polyMesh& mesh, const word& cloudName)
{
    const word name(cloudName + "OutputProperties");
    return
        mesh.foundObject<IOdictionary>(name)
      ? &mesh.lookupObjectRef<IOdictionary>(name) : nullptr;
}


//- The notes of the present time
dictionary* notes(const polyMesh& mesh, const word& cloudName)
{
    IOdictionary* all = properties(mesh, cloudName);
    if (!all)
    {
        return nullptr;
    }
    const word now(mesh.time().timeName());
    const dictionary* old = all->findDict(block);
    if (!old || old->getOrDefault<string>("time", "") != now)
    {
        dictionary fresh;
        fresh.add("time", string(now));
        all->set(block, fresh);
    }
    return &all->subDict(block);
}


//- The notes of the directory that a run starts from
const dictionary* found(const polyMesh& mesh, const word& cloudName)
{
    const IOdictionary* all = properties(mesh, cloudName);
    const dictionary* old = all ? all->findDict(block) : nullptr;
    return
        old
     && old->getOrDefault<string>("time", "") == mesh.time().timeName()
      ? old : nullptr;
}


[[noreturn]] void unfinished
(
    const polyMesh& mesh,
    const word& cloudName,
    const string& what
)
{
    // (A list of function objects goes on without one that fails otherwise)
    FatalIOErrorInFunction(*properties(mesh, cloudName))
        << "Time directory " << mesh.time().timeName() << " of cloud "
        << cloudName << " was not written to its end: " << what.c_str() << nl
        << "Start from the time before. If it was changed on purpose, remove "
        << block << " from "
        << mesh.time().timeName()/"uniform"/"lagrangian"/cloudName
          /(cloudName + "OutputProperties")
        << exit(FatalIOError);
    std::abort();
}

} // End anonymous namespace


void Foam::writtenState::add
(
    const polyMesh& mesh,
    const word& cloudName,
    const word& file
)
{
    if (dictionary* d = notes(mesh, cloudName))
    {
        wordList files(d->getOrDefault<wordList>("files", wordList()));
        if (!files.found(file))
        {
            files.append(file);
            d->set("files", files);
        }
    }
}


void Foam::writtenState::addParcels
(
    const polyMesh& mesh,
    const regIOobject& cloud,
    label nParcels
)
{
    reduce(nParcels, sumOp<label>());
    if (dictionary* d = notes(mesh, cloud.name()))
    {
        d->set(parcels, nParcels);
    }
    pastWrite::catchUp(mesh, cloud);
}


void Foam::writtenState::check
(
    const polyMesh& mesh,
    const word& cloudName,
    const word& file
)
{
    const dictionary* d = found(mesh, cloudName);
    if (d && d->getOrDefault<wordList>("files", wordList()).found(file))
    {
        unfinished(mesh, cloudName, file + " is missing");
    }
}


void Foam::writtenState::checkParcels
(
    const polyMesh& mesh,
    const word& cloudName,
    label nParcels
)
{
    pastWrite::of(mesh);
    reduce(nParcels, sumOp<label>());
    const dictionary* d = found(mesh, cloudName);
    const label noted =
        d ? d->getOrDefault<label>(parcels, nParcels) : nParcels;
    if (noted != nParcels)
    {
        unfinished
        (
            mesh, cloudName,
            Foam::name(nParcels) + " parcels of " + Foam::name(noted)
          + " are there"
        );
    }
}
