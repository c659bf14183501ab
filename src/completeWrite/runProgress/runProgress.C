/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "runProgress.H"

// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::runProgress::runProgress(const Time& runTime)
:
    time_(runTime),
    start_(runTime.value()),
    firstShare_(-1),
    percent_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::runProgress::report()
{
    const scalar span = time_.endTime().value() - start_;
    if (span <= 0)
    {
        return;
    }
    const scalar share = (time_.value() - start_)/span;
    if (firstShare_ < 0)
    {
        firstShare_ = share;
        first_ = last_ = clock::now();
        return;
    }

    // Steps that make up the time may fall short of it by round-off
    const label percent = label(100*share*(1 + 1e-9));
    if (percent <= percent_ || percent >= 100 || share <= firstShare_)
    {
        return;
    }
    const bool tenth = percent/10 > percent_/10;
    percent_ = percent;
    const clock::time_point now = clock::now();
    if (!tenth && now - last_ < std::chrono::seconds(1))
    {
        return;
    }
    last_ = now;

    const scalar seconds =
        std::chrono::duration<scalar>(now - first_).count()
       *(1 - share)/(share - firstShare_);
    Info<< percent << " % of the run, about ";
    if (seconds < 120)
    {
        Info<< label(seconds + 0.5) << " s";
    }
    else if (seconds < 7200)
    {
        Info<< label(seconds/60 + 0.5) << " min";
    }
    else
    {
        Info<< label(seconds/3600 + 0.5) << " h";
    }
    Info<< " left" << endl;
}


// ************************************************************************* //
