/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "impactLog.H"
#include "csvLine.H"
#include "finishFile.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "functionObject.H"

#include <algorithm>
#include <cstring>
#include <tuple>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::impactLog::writeRecord(const record& r)
{
    const wallImpact& i = r.impact;
    impact::csvLine line;
    const auto add = [&line](const bool known, const vector& v)
    {
        line.add(known, v.x());
        line.add(known, v.y());
        line.add(known, v.z());
    };

    line.add(r.step);
    line.add(i.origProc);
    line.add(i.origId);
    line.add(i.time);
    add(true, i.position);
    add(true, i.U0);
    line.add(i.d);
    line.add(i.nParticle);
    line.add(patchNames_[i.patch]);
    line.add(r.first);
    add(r.spinKnown, i.omega0);
    add(r.reboundKnown, i.U1);
    add(r.reboundKnown, i.omega1);
    line.add(r.reboundKnown, i.captured);
    line.add(r.reboundKnown);
    line.add(i.T > 0, i.T);
    file_->stdStream() << line.take();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::impactLog::impactLog
(
    const word& cloudName,
    const word& functionName,
    const Time& time,
    const wordList& patchNames
)
:
    time_(time),
    patchNames_(patchNames)
{
    if (Pstream::master())
    {
        const fileName part
        (
            folder(cloudName, functionName, time)/time.timeName()
        );
        mkDir(part);
        file_.reset(new OFstream(part/"impacts.csv"));
        file_()
            << "step,origProc,origId,time,x,y,z,Ux,Uy,Uz,d,nParticle,patch,"
            << "firstImpact,omegaX,omegaY,omegaZ,UxOut,UyOut,UzOut,"
            << "omegaXOut,omegaYOut,omegaZOut,captured,reboundKnown,T" << endl;
    }
}


Foam::fileName Foam::impactLog::folder
(
    const word& cloudName,
    const word& functionName,
    const Time& time
)
{
    return
        time.globalPath()/functionObject::outputPrefix/functionName/cloudName;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::impactLog::append
(
    const wallImpact& impact,
    const bool spinKnown,
    const bool reboundKnown
)
{
    // Colliding clouds track in parts of the step
    const label step =
        time_.subCycling()
      ? time_.prevTimeState().timeIndex()
      : time_.timeIndex();
    records_.append(record{impact, step, false, spinKnown, reboundKnown});
    return records_.size() - 1;
}


void Foam::impactLog::write()
{
    // A record is numbers and no pointers: its bytes travel as they are, in
    // pieces whose bytes a label can count
    const label piece = 1000000;
    DynamicList<record> all;
    for
    (
        label first = 0;
        returnReduce(first < records_.size(), orOp<bool>());
        first += piece
    )
    {
        List<List<char>> sent(Pstream::nProcs());
        List<char>& mine = sent[Pstream::myProcNo()];
        const label n = max(min(records_.size() - first, piece), label(0));
        mine.setSize(label(n*sizeof(record)));
        if (n)
        {
            std::memcpy
            (
                mine.data(),
                static_cast<const void*>(&records_[first]),
                mine.size()
            );
        }
        Pstream::gatherList(sent);
        for (const List<char>& bytes : sent)
        {
            const label m = label(bytes.size()/sizeof(record));
            if (m && Pstream::master())
            {
                const label at = all.size();
                all.setSize(at + m);
                std::memcpy
                (
                    static_cast<void*>(&all[at]), bytes.cdata(), bytes.size()
                );
            }
        }
    }
    records_.clear();
    if (!Pstream::master())
    {
        return;
    }

    // Hits of a parcel at one instant stay in the order in which they came
    std::stable_sort
    (
        all.begin(),
        all.end(),
        [](const record& a, const record& b)
        {
            const wallImpact& i = a.impact;
            const wallImpact& j = b.impact;
            return
                std::tie(a.step, i.origProc, i.origId, i.time)
              < std::tie(b.step, j.origProc, j.origId, j.time);
        }
    );
    for (const record& r : all)
    {
        writeRecord(r);
    }
    finishFile(*file_);
}
