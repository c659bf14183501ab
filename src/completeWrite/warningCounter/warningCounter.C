/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "warningCounter.H"

#include <algorithm>
#include <iostream>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::warningCounter::readLine()
{
    const auto begins = [&](const char* text)
    {
        return line_.rfind(text, 0) == 0;
    };

    if (begins("--> FOAM ") && line_.find("Warning") != std::string::npos)
    {
        open_ = true;
        place_.clear();

        // The text may follow at once, as from Warning<<
        const std::size_t text = line_.find(" : ");
        line_.erase(0, text == std::string::npos ? text : text + 3);
    }
    const std::size_t first = line_.find_first_not_of(' ');
    if
    (
        !open_ || first == std::string::npos
     || begins("    From ") || begins("    Reading ")
    )
    {
        return;
    }
    const std::string file("    in file ");
    if (begins(file.c_str()))
    {
        place_ = line_.substr(file.size());
        return;
    }

    open_ = false;
    const std::string message(line_.substr(first));
    if (place_.empty())
    {
        place_ = message;
    }
    const auto known = std::find_if
    (
        kinds_.begin(),
        kinds_.end(),
        [&](const kind& k) { return k.place == place_; }
    );
    if (known == kinds_.end())
    {
        kinds_.push_back({place_, message, 1});
    }
    else
    {
        ++known->count;
    }
}


int Foam::warningCounter::overflow(int c)
{
    if (c == traits_type::eof())
    {
        return traits_type::not_eof(c);
    }
    const char one = traits_type::to_char_type(c);
    return xsputn(&one, 1) == 1 ? c : traits_type::eof();
}


std::streamsize Foam::warningCounter::xsputn
(
    const char* s,
    std::streamsize n
)
{
    const char* from = s;
    const char* const end = s + n;
    for
    (
        const char* at = std::find(from, end, '\n');
        at != end;
        at = std::find(from, end, '\n')
    )
    {
        line_.append(from, at);
        readLine();
        line_.clear();
        from = at + 1;
    }
    line_.append(from, end);
    return to_->sputn(s, n);
}


int Foam::warningCounter::sync()
{
    return to_->pubsync();
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::warningCounter::warningCounter()
:
    to_(std::cout.rdbuf())
{
    std::cout.rdbuf(this);
}


Foam::warningCounter::~warningCounter()
{
    std::cout.rdbuf(to_);
}


// ************************************************************************* //
