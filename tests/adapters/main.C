/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Runs the tests of the OpenFOAM adapters with the floating-point traps that
    OpenFOAM sets. Fatal errors become exceptions, so that a test can look at
    the message.
\*---------------------------------------------------------------------------*/

#include "error.H"
#include "IOstreams.H"

#include <gtest/gtest.h>
#include <cfenv>

int main(int argc, char** argv)
{
    ::testing::InitGoogleTest(&argc, argv);
    feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);
    Foam::FatalError.throwExceptions();
    Foam::FatalIOError.throwExceptions();
    Foam::messageStream::level = 0;
    return RUN_ALL_TESTS();
}
