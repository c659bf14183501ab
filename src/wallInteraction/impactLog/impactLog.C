/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "impactLog.H"
#include "finishFile.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "functionObject.H"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <tuple>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::impactLog::writeRecord(const record& r)
{
    const wallImpact& i = r.impact;

    // Streams spend several microseconds on a line. The shortest text that
    // reads back as the same number has at most 24 characters.
    char line[32*24];
    char* at = line;
    const auto put = [&at](const auto value)
    {
        at = std::to_chars(at, at + 24, value).ptr;
        *at++ = ',';
    };
    const auto putVector = [&at, &put](const vector& v, const bool known)
    {
        for (const scalar x : {v.x(), v.y(), v.z()})
        {
            if (known)
            {
                put(x);
            }
            else
            {
                *at++ = ',';
            }
        }
    };

    put(r.step);
    put(i.origProc);
    put(i.origId);
    put(i.time);
    putVector(i.position, true);
    putVector(i.U0, true);
    put(i.d);
    put(i.nParticle);
    std::ostream& os = file_->stdStream();
    os.write(line, at - line);
    os  << patchNames_[i.patch].c_str() << ',';

    at = line;
    put(label(r.first));
    putVector(i.omega0, r.spinKnown);
    putVector(i.U1, r.reboundKnown);
    putVector(i.omega1, r.reboundKnown);
    if (r.reboundKnown)
    {
        put(label(i.captured));
    }
    else
    {
        *at++ = ',';
    }
    put(label(r.reboundKnown));
    at[-1] = '\n';
    os.write(line, at - line);
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
    patchNames_(patchNames),
    records_(),
    file_(nullptr)
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
            << "omegaXOut,omegaYOut,omegaZOut,captured,reboundKnown" << endl;
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
    // A record is numbers and no pointers: its bytes travel as they are
    List<List<char>> sent(Pstream::nProcs());
    List<char>& mine = sent[Pstream::myProcNo()];
    mine.setSize(label(records_.size()*sizeof(record)));
    if (records_.size())
    {
        std::memcpy
        (
            mine.data(),
            static_cast<const void*>(records_.cdata()),
            mine.size()
        );
    }
    records_.clear();
    Pstream::gatherList(sent);

    if (!Pstream::master())
    {
        return;
    }

    label n = 0;
    for (const List<char>& bytes : sent)
    {
        n += label(bytes.size()/sizeof(record));
    }
    List<record> all(n);
    n = 0;
    for (const List<char>& bytes : sent)
    {
        if (bytes.size())
        {
            std::memcpy
            (
                static_cast<void*>(&all[n]),
                bytes.cdata(),
                bytes.size()
            );
        }
        n += label(bytes.size()/sizeof(record));
    }

    std::sort
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
