/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "firstImpacts.H"
#include "allGather.H"
#include "PstreamReduceOps.H"
#include "scalarList.H"

#include <algorithm>
#include <tuple>

Foam::labelList Foam::firstImpacts::resolve()
{
    const label me = Pstream::myProcNo();
    List<candidate> all;

    if (!Pstream::parRun())
    {
        if (candidates_.empty())
        {
            return labelList();
        }
        all = candidates_;
    }
    else
    {
        if (returnReduce(candidates_.size(), sumOp<label>()) == 0)
        {
            return labelList();
        }

        List<scalarList> sent(Pstream::nProcs());
        scalarList& mine = sent[me];
        mine.setSize(3*candidates_.size());
        forAll(candidates_, i)
        {
            mine[3*i] = candidates_[i].origProc;
            mine[3*i + 1] = candidates_[i].origId;
            mine[3*i + 2] = candidates_[i].time;
        }
        foamCompat::allGather(sent);

        DynamicList<candidate> received;
        forAll(sent, rank)
        {
            for (label i = 0; i < sent[rank].size()/3; ++i)
            {
                const scalar* s = &sent[rank][3*i];
                received.append({label(s[0]), label(s[1]), s[2], rank, i});
            }
        }
        all.transfer(received);
    }

    std::sort
    (
        all.begin(),
        all.end(),
        [](const candidate& a, const candidate& b)
        {
            return
                std::tie(a.origProc, a.origId, a.time, a.rank, a.index)
              < std::tie(b.origProc, b.origId, b.time, b.rank, b.index);
        }
    );

    DynamicList<label> first;
    for (const candidate& c : all)
    {
        if (hit_.insert(c.origProc, c.origId) && c.rank == me)
        {
            first.append(tags_[c.index]);
        }
    }
    candidates_.clear();
    tags_.clear();
    return labelList(std::move(first));
}


Foam::labelList Foam::firstImpacts::labels() const
{
    const std::vector<std::uint64_t> words(hit_.words());
    labelList halves(2*words.size());
    for (std::size_t i = 0; i < words.size(); ++i)
    {
        // Halves fit labels of 32 and of 64 bits
        halves[2*i] = label(std::int32_t(words[i] & 0xffffffffULL));
        halves[2*i + 1] = label(std::int32_t(words[i] >> 32));
    }
    return halves;
}


void Foam::firstImpacts::set(const UList<label>& labels)
{
    std::vector<std::uint64_t> words(labels.size()/2);
    for (std::size_t i = 0; i < words.size(); ++i)
    {
        words[i] =
            std::uint64_t(std::uint32_t(labels[2*i]))
          | std::uint64_t(std::uint32_t(labels[2*i + 1])) << 32;
    }
    hit_ = impact::identitySet(words);
}
