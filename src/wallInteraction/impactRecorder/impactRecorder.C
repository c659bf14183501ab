/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "impactRecorder.H"

Foam::impactRecorder::impactRecorder
(
    const dictionary&,
    const word& cloudName,
    const word& functionName,
    const fvMesh& mesh,
    const boolList&
)
:
    time_(mesh.time()),
    restart_(cloudName, functionName, mesh),
    log_(cloudName, functionName, mesh.time(), mesh.boundaryMesh().names())
{
    if (restart_.found())
    {
        firsts_.set(restart_.labels());
        restart_.clear();
    }
}


void Foam::impactRecorder::take
(
    const wallImpact& impact,
    const bool spinKnown,
    const bool reboundKnown
)
{
    firsts_.note
    (
        impact.origProc,
        impact.origId,
        impact.time,
        log_.append(impact, spinKnown, reboundKnown)
    );
}


void Foam::impactRecorder::end()
{
    for (const label place : firsts_.resolve())
    {
        log_.setFirst(place);
    }

    if (time_.writeTime() || averagingWindow::lastStep(time_))
    {
        log_.write();
    }
    if (time_.writeTime())
    {
        restart_.set(firsts_.labels(), scalarList());
    }
}
