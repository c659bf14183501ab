/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "fastNumberOutput.H"

#include <algorithm>
#include <charconv>
#include <ios>

namespace Foam
{

// Numbers as printf writes them with %.*g, what streams do unless they are told
// otherwise; then, and where the library has no to_chars for them, as ever
class numbersByToChars
:
    public std::num_put<char>
{
    static constexpr int maxPrecision = 40;

    iter_type do_put
    (
        iter_type out,
        std::ios_base& stream,
        char fill,
        double value
    ) const override
    {
#ifdef __cpp_lib_to_chars
        const auto others =
            std::ios_base::floatfield | std::ios_base::showpoint
          | std::ios_base::showpos | std::ios_base::uppercase;
        const std::streamsize precision = stream.precision();
        const bool plain =
            stream.width() == 0 && !(stream.flags() & others)
         && precision >= 0 && precision <= maxPrecision;
        if (plain)
        {
            char text[maxPrecision + 16];
            const auto end = std::to_chars
            (
                text, text + sizeof(text), value, std::chars_format::general,
                int(precision)
            );
            return std::copy(text, end.ptr, out);
        }
#endif
        return std::num_put<char>::do_put(out, stream, fill, value);
    }
};

} // End namespace Foam


Foam::fastNumberOutput::fastNumberOutput()
:
    before_
    (
        std::locale::global
        (
            std::locale(std::locale::classic(), new numbersByToChars)
        )
    )
{}


Foam::fastNumberOutput::~fastNumberOutput()
{
    std::locale::global(before_);
}
