/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Runs the unit tests of the core with the floating-point traps that
    OpenFOAM sets, so that an invalid operation fails here as it would there.
\*---------------------------------------------------------------------------*/

#include <gtest/gtest.h>
#include <cfenv>

int main(int argc, char** argv)
{
    ::testing::InitGoogleTest(&argc, argv);
    feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);
    return RUN_ALL_TESTS();
}
