/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Where the lines of a stream enter: every point of a slanted square once,
    none beside it, several behind one another.
\*---------------------------------------------------------------------------*/

#include "entrySection.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    // Two triangles of a square in the plane x = at + slope y
    void addSquare(pointField& corners, const scalar at, const scalar slope)
    {
        const point a(at, 0, 0), b(at + slope, 1, 0);
        const point c(at + slope, 1, 1), d(at, 0, 1);
        for (const point& p : {a, b, c, a, c, d})
        {
            corners.append(p);
        }
    }
}


TEST(entrySection, meetsASlantedSquareOnce)
{
    pointField corners;
    addSquare(corners, 0.2, 0.5);
    for (const vector& empty : {vector(0, 0, 0), vector(0, 0, 1)})
    {
        const entrySection section(corners, vector(3, 0, 0), empty);
        EXPECT_NEAR(section.area(), 1, 1e-12);
        for (const scalar a : {0.0, 0.25, 0.5, 1.0})
        {
            for (const scalar b : {0.0, 0.25, 0.5, 1.0})
            {
                point x;
                ASSERT_EQ
                (
                    section.enter(a, b, x), entrySection::entries::one
                );
                EXPECT_NEAR(x.x(), 0.2 + 0.5*x.y(), 1e-12);
            }
        }
    }
}


TEST(entrySection, missesWhatIsBeside)
{
    // Half of the square
    pointField corners;
    addSquare(corners, 0, 0);
    corners.resize(3);
    const entrySection section(corners, vector(1, 0, 0), vector::zero);
    label n = 0;
    for (label i = 0; i < 100; ++i)
    {
        for (label j = 0; j < 100; ++j)
        {
            point x;
            n +=
                section.enter((i + 0.25)/100, (j + 0.5)/100, x)
             == entrySection::entries::one;
        }
    }
    EXPECT_NEAR(n, 5000, 50);
}


TEST(entrySection, seesASecondEntry)
{
    pointField corners;
    addSquare(corners, 0, 0);
    addSquare(corners, 1, 0);
    const entrySection section(corners, vector(1, 0, 0), vector::zero);
    point x;
    EXPECT_EQ
    (
        section.enter(0.3, 0.6, x), entrySection::entries::several
    );
}
