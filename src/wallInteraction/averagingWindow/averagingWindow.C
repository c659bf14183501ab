/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "averagingWindow.H"
#include "checked.H"

Foam::averagingWindow::averagingWindow
(
    const dictionary& dict,
    const word& functionName,
    const Time& time,
    const bool continued
)
:
    time_(time),
    start_(-GREAT),
    end_(GREAT)
{
    const dictionary* window = findBlock(dict, "window");
    if (!window)
    {
        return;
    }
    refuseOthers(*window, {"start", "end"});
    start_ = getNumber(*window, "start", validRange::time, start_);
    end_ = getNumber(*window, "end", validRange::time, end_);

    if (!(end_ > start_))
    {
        refuse(*window, "end", end_, "greater than start, ", start_);
    }

    if (end_ < time.value() + 0.5*time.deltaTValue() && !continued)
    {
        refuse
        (
            *window, "end", end_, "greater than the time at which the run"
            " begins, ", time.value(), ": of an earlier part no averages were"
            " kept"
        );
    }

    if (start_ >= time.endTime().value())
    {
        Warning
            << functionName << ": the averaging window begins at " << start_
            << ", not before the end of the run at " << time.endTime().value()
            << ": this run adds nothing to it." << endl;
    }
}
