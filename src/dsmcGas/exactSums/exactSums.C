/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "exactSums.H"
#include "Time.H"
#include "scalarIOField.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::IOobject Foam::exactSums::object(const IOobject::readOption read) const
{
    return IOobject
    (
        name_,
        mesh_.time().timeName(),
        "uniform",
        mesh_,
        read,
        IOobject::NO_WRITE,
        false
    );
}


Foam::scalarList Foam::exactSums::owner(const label nSteps) const
{
    return
    {
        scalar(Pstream::parRun() ? Pstream::nProcs() : 0),
        scalar(Pstream::myProcNo()),
        scalar(mesh_.nCells()),
        scalar(mesh_.nFaces()),
        scalar(nSteps)
    };
}


Foam::label Foam::exactSums::size() const
{
    std::size_t n = 0;
    for (const numbers& s : sums_)
    {
        n += s.n;
    }
    return label(n);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::IOdictionary Foam::exactSums::state
(
    const fvMesh& mesh,
    const word& name,
    const IOobject::readOption read
)
{
    return IOdictionary(exactSums(mesh, name).object(read));
}


void Foam::exactSums::write
(
    const word& stateName,
    const label nSteps,
    const scalar duration
) const
{
    IOdictionary means(state(mesh_, stateName));
    means.add("nSteps", nSteps);
    means.add("duration", duration);
    means.regIOobject::write();

    const scalarList head(owner(nSteps));
    scalarIOField all(object(IOobject::NO_READ), head.size() + size());
    scalar* to = std::copy(head.begin(), head.end(), all.begin());
    for (const numbers& s : sums_)
    {
        to = std::copy(s.begin, s.begin + s.n, to);
    }
    all.regIOobject::writeObject
    (
        IOstream::BINARY,
        IOstream::currentVersion,
        IOstream::UNCOMPRESSED,
        true
    );
}


bool Foam::exactSums::read(const label nSteps)
{
    const scalarIOField all(object(IOobject::READ_IF_PRESENT));
    const scalarList head(owner(nSteps));
    const bool ours =
        all.size() == head.size() + size()
     && std::equal(head.begin(), head.end(), all.begin());
    if (!returnReduce(ours, andOp<bool>()))
    {
        return false;
    }
    const scalar* from = all.begin() + head.size();
    for (const numbers& s : sums_)
    {
        std::copy(from, from + s.n, s.begin);
        from += s.n;
    }
    return true;
}
