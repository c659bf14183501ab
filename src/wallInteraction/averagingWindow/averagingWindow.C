/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "averagingWindow.H"

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
    const dictionary* window = dict.findDict("window");
    if (!window)
    {
        return;
    }
    window->readIfPresent("start", start_);
    window->readIfPresent("end", end_);

    if (!(end_ > start_))
    {
        FatalIOErrorInFunction(*window)
            << functionName << ": entry 'end', value " << end_
            << ", is outside the valid range (" << start_
            << ", infinity): the window from 'start' to 'end' is empty"
            << exit(FatalIOError);
    }

    if (end_ < time.value() + 0.5*time.deltaTValue() && !continued)
    {
        FatalIOErrorInFunction(*window)
            << functionName << ": entry 'end', value " << end_
            << ", is outside the valid range (" << time.value()
            << ", infinity): the run begins at " << time.value()
            << ", and of an earlier part of it no averages were kept"
            << exit(FatalIOError);
    }

    if (start_ >= time.endTime().value())
    {
        Warning
            << functionName << ": the averaging window begins at " << start_
            << ", not before the end of the run at " << time.endTime().value()
            << ": this run adds nothing to it." << endl;
    }
}
