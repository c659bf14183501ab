/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "rankMail.H"
#include "PstreamBuffers.H"
#include "PstreamReduceOps.H"
#include "UIPstream.H"
#include "UOPstream.H"

#include <algorithm>

namespace
{

//- MPI counts the bytes of a message in 32 bits
constexpr std::size_t maxBytes = 1 << 30;

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::rankMail::send
(
    const label rank,
    const void* data,
    const std::size_t n
)
{
    const char* from = static_cast<const char*>(data);
    for (std::size_t i = 0; i < n; i += maxBytes)
    {
        UOPstream::write
        (
            Pstream::commsTypes::scheduled, rank, from + i,
            std::min(maxBytes, n - i)
        );
    }
}


void Foam::rankMail::receive
(
    const label rank,
    void* data,
    const std::size_t n
)
{
    char* to = static_cast<char*>(data);
    for (std::size_t i = 0; i < n; i += maxBytes)
    {
        UIPstream::read
        (
            Pstream::commsTypes::scheduled, rank, to + i,
            std::min(maxBytes, n - i)
        );
    }
}


bool Foam::rankMail::any(const post& out)
{
    const auto some = [](const std::string& bytes) { return !bytes.empty(); };
    return returnReduce
    (
        std::any_of(out.begin(), out.end(), some), orOp<bool>()
    );
}


Foam::rankMail::post Foam::rankMail::exchange(post& out)
{
    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
    for (std::size_t rank = 0; rank < out.size(); ++rank)
    {
        if (!out[rank].empty())
        {
            UOPstream stream(rank, buffers);
            stream<< UList<char>(&out[rank][0], out[rank].size());
            out[rank].clear();
        }
    }
    labelList sizes;
    buffers.finishedSends(sizes);
    post in(Pstream::nProcs());
    forAll(sizes, rank)
    {
        if (sizes[rank])
        {
            UIPstream stream(rank, buffers);
            const List<char> bytes(stream);
            in[rank].assign(bytes.cdata(), bytes.size());
        }
    }
    return in;
}
