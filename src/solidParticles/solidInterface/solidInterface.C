/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "solidInterface.H"
#include "checked.H"
#include "exactSums.H"
#include "OSspecific.H"
#include "rankMail.H"
#include "textFile.H"
#include "Time.H"
#include "wordRes.H"

namespace Foam
{
    static const word interfaceState("solidInterfaceState");
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fileName Foam::solidInterface::file() const
{
    return
        mesh_.time().globalPath()/"postProcessing"/"particleInterface"
       /mesh_.time().timeName()/"interface.csv";
}


Foam::wordList Foam::solidInterface::patches() const
{
    DynamicList<word> names;
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (isSurface_[patch.index()])
        {
            names.append(patch.name());
        }
    }
    return names;
}


void Foam::solidInterface::restore(const dictionary& dict)
{
    const IOdictionary state
    (
        exactSums::state(mesh_, interfaceState, IOobject::READ_IF_PRESENT)
    );
    if (!state.found("duration"))
    {
        return;
    }
    duration_ = state.get<scalar>("duration");
    const wordList was(state.getOrDefault<wordList>("patches", patches()));
    if (was != patches())
    {
        refuse
        (
            dict, "patches", flatOutput(patches()),
            "those of the records before time ", mesh_.time().timeName(), ", ",
            flatOutput(was)
        );
    }
    const auto keep =
        [&](const char* entry, const auto& now, const scalar tolerance)
        {
            typedef std::decay_t<decltype(now)> Type;
            const Type was(state.getOrDefault<Type>(entry, now));
            if (mag(was - now) > tolerance*mag(was))
            {
                refuse
                (
                    dict, entry, now, "that of the records before time ",
                    mesh_.time().timeName(), ", ", was
                );
            }
        };
    if (duration_ > 0)
    {
        keep("start", start_, 1e-12);
    }
    keep("origin", origin_, 1e-12);
    keep("sectors", sectors_, 0);
    if (!(duration_ > 0) || !Pstream::master())
    {
        return;
    }
    try
    {
        records_ = impact::particleInterface::read(file());
    }
    catch (const std::invalid_argument& e)
    {
        FatalErrorInFunction
            << "The records before time " << mesh_.time().timeName()
            << " are to be continued: " << e.what() << exit(FatalError);
    }
    for (auto& r : records_)
    {
        r.weight *= duration_/sectors_;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solidInterface::solidInterface
(
    const dictionary& dict,
    const fvMesh& mesh
)
:
    mesh_(mesh),
    isSurface_(mesh.boundary().size()),
    start_(getNumber(dict, "start", validRange::time, scalar(0))),
    sectors_(getNumber(dict, "sectors", "(0, 1e6]", scalar(1))),
    origin_
    (
        getComponents(dict, "origin", validRange::coordinate, vector(Zero))
    )
{
    refuseOthers(dict, {"patches", "start", "sectors", "origin"});
    warnOfLateStart(dict, mesh.time(), start_);

    isSurface_ = false;
    const wordRes expressions(getItems<wordRe>(dict, "patches"));
    if (expressions.empty())
    {
        refuse(dict, "patches", "()", "one open patch at least");
    }
    for (const wordRe& expression : expressions)
    {
        bool found = false;
        wordList open;
        for (const polyPatch& patch : mesh_.boundaryMesh())
        {
            if (!isType<polyPatch>(patch))
            {
                continue;
            }
            open.append(patch.name());
            if (expression.match(patch.name()))
            {
                isSurface_[patch.index()] = true;
                found = true;
            }
        }
        if (!found)
        {
            unknownWord(dict, "patches: open patch", expression, open);
        }
    }
    restore(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solidInterface::beginStep()
{
    const scalar deltaT = mesh_.time().deltaTValue();
    recording_ = mesh_.time().value() > start_ + 0.5*deltaT;
    if (recording_)
    {
        duration_ += deltaT;
    }
}


void Foam::solidInterface::info() const
{
    scalar weight = 0;
    for (const auto& r : records_)
    {
        weight += r.weight;
    }
    reduce(weight, sumOp<scalar>());
    Info<< "Interface to the far field: "
        << returnReduce(label(records_.size()), sumOp<label>())
        << " records in " << duration_ << " s, "
        << (duration_ > 0 ? sectors_*weight/duration_ : 0)
        << " real particles per second" << nl << endl;
}


void Foam::solidInterface::write() const
{
    auto records(records_);
    rankMail::gather(records);
    if (Pstream::master() && duration_ > 0)
    {
        for (auto& r : records)
        {
            r.weight *= sectors_/duration_;
        }
        mkDir(file().path());
        try
        {
            textFile(file()).print
            (
                impact::particleInterface::text
                (
                    records,
                    "written by dsmcParcelFoam, recorded for "
                  + Foam::name(duration_) + " s until "
                  + mesh_.time().timeName() + " s"
                ).c_str()
            );
        }
        catch (const std::invalid_argument& e)
        {
            FatalErrorInFunction
                << file() << ": " << e.what() << exit(FatalError);
        }
    }
    IOdictionary state(exactSums::state(mesh_, interfaceState));
    state.add("duration", duration_);
    state.add("patches", patches());
    state.add("start", start_);
    state.add("sectors", sectors_);
    state.add("origin", origin_);
    const unsigned precision = IOstream::defaultPrecision(17);
    state.regIOobject::write();
    IOstream::defaultPrecision(precision);
}
