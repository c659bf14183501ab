/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Mass properties against closed forms, polyhedra from files, and what is
    refused.
\*---------------------------------------------------------------------------*/

#include "convexBody.H"
#include "counterRandom.H"

#include <gtest/gtest.h>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <stdexcept>

using namespace impact;

namespace
{

//- A box as an OBJ file, turned and moved
std::string boxObj(const vector3& size, bool insideOut = false)
{
    std::string text = "# box\n";
    char line[200];
    for (int i = 0; i < 8; ++i)
    {
        const double x = (i & 1 ? 0.5 : -0.5)*size.x;
        const double y = (i & 2 ? 0.5 : -0.5)*size.y;
        const double z = (i & 4 ? 0.5 : -0.5)*size.z;
        const double c = 0.8, s = 0.6;
        std::snprintf
        (
            line, sizeof(line), "v %.17g %.17g %.17g\n",
            c*x - s*y + 7, s*x + c*y - 3, z + 2
        );
        text += line;
    }
    const int faces[6][4] =
    {
        {1, 5, 7, 3}, {2, 4, 8, 6}, {1, 2, 6, 5},
        {3, 7, 8, 4}, {1, 3, 4, 2}, {5, 6, 8, 7}
    };
    for (const auto& f : faces)
    {
        std::snprintf
        (
            line, sizeof(line), "f %d %d/1 %d//2 %d/1/2\n",
            f[0], f[insideOut ? 3 : 1], f[2], f[insideOut ? 1 : 3]
        );
        text += line;
    }
    return text;
}


std::string write(const std::string& name, const std::string& text)
{
    const std::string path = ::testing::TempDir() + name;
    std::ofstream(path, std::ios::binary) << text;
    return path;
}


//- Triangles of a box as STL, ASCII or binary
std::string boxStl(const vector3& h, bool binary)
{
    const int quads[6][4] =
    {
        {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
        {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}
    };
    std::string text = binary ? std::string(80, ' ') : "solid box\n";
    const std::uint32_t n = 12;
    if (binary)
    {
        text.append(reinterpret_cast<const char*>(&n), 4);
    }
    for (const auto& q : quads)
    {
        for (int t = 0; t < 2; ++t)
        {
            const int corner[3] = {q[0], q[t + 1], q[t + 2]};
            if (binary)
            {
                text.append(12, '\0');
            }
            else
            {
                text += "facet normal 0 0 0\nouter loop\n";
            }
            for (int c : corner)
            {
                const float p[3] =
                {
                    float(c & 1 ? h.x : -h.x), float(c & 2 ? h.y : -h.y),
                    float(c & 4 ? h.z : -h.z)
                };
                if (binary)
                {
                    text.append(reinterpret_cast<const char*>(p), 12);
                }
                else
                {
                    char line[100];
                    std::snprintf
                    (
                        line, sizeof(line), "vertex %g %g %g\n",
                        p[0], p[1], p[2]
                    );
                    text += line;
                }
            }
            text += binary ? std::string(2, '\0') : "endloop\nendfacet\n";
        }
    }
    return binary ? text : text + "endsolid\n";
}

} // End anonymous namespace


TEST(convexBody, hasTheMassPropertiesOfItsShape)
{
    const convexBody ball = convexBody::sphere(2);
    EXPECT_DOUBLE_EQ(ball.inertia().x, 0.4);
    EXPECT_EQ(ball.symmetryAxis(), 3);
    EXPECT_TRUE(ball.isSphere());

    const convexBody box = convexBody::box({1, 2, 3});
    EXPECT_NEAR(box.volume(), 6, 1e-14);
    EXPECT_NEAR(box.inertia().x, (4 + 9)/12., 1e-14);
    EXPECT_NEAR(box.inertia().y, (1 + 9)/12., 1e-14);
    EXPECT_NEAR(box.inertia().z, (1 + 4)/12., 1e-14);
    EXPECT_NEAR(box.radius(), std::sqrt(14.)/2, 1e-14);
    EXPECT_EQ(box.symmetryAxis(), -1);
    EXPECT_EQ(box.edges().size(), 12u);
    EXPECT_EQ(convexBody::box({1, 0.8, 0.8}).symmetryAxis(), 0);
    EXPECT_EQ(convexBody::box({0.8, 1, 0.8}).symmetryAxis(), 1);
    EXPECT_EQ(convexBody::box({0.8, 0.8, 1}).symmetryAxis(), 2);
    EXPECT_EQ(convexBody::box({1, 1, 1}).symmetryAxis(), 3);
    EXPECT_FALSE(convexBody::box({1, 1, 1}).isSphere());

    // A box less eight corner tetrahedra: centroid at a quarter, second
    // moments about the corner abc/60 a^2 and abc/120 ab
    const double a = 1, b = 0.6, c = 0.8, t = 0.25;
    const convexBody cut = convexBody::truncatedBox({a, b, c}, t);
    const double V = a*b*c;
    const double Vt = t*t*t*V/6;
    EXPECT_EQ(cut.vertices().size(), 24u);
    EXPECT_EQ(cut.edges().size(), 36u);
    EXPECT_NEAR(cut.volume(), V - 8*Vt, 1e-15);
    auto second = [&](double s)
    {
        // Integral of x^2 over the tetrahedron whose corner is at s/2 and
        // whose edge runs inwards by t s
        const double e = t*s;
        return V*s*s/12 - 8*(Vt*(s*s/4 - s*e/4) + t*t*t*V*e*e/60);
    };
    const double xx = second(a), yy = second(b), zz = second(c);
    EXPECT_NEAR(cut.inertia().x, (yy + zz)/cut.volume(), 1e-15);
    EXPECT_NEAR(cut.inertia().y, (zz + xx)/cut.volume(), 1e-15);
    EXPECT_NEAR(cut.inertia().z, (xx + yy)/cut.volume(), 1e-15);
}


TEST(convexBody, supportIsTheFurthestPoint)
{
    counterRandom rnd(2);
    const convexBody e = convexBody::ellipsoid({1, 0.3, 2});
    for (int i = 0; i < 100; ++i)
    {
        const vector3 n = {rnd.normal(), rnd.normal(), rnd.normal()};
        const vector3 s = e.support(n);
        EXPECT_NEAR
        (
            4*(s.x*s.x + s.y*s.y/0.09 + s.z*s.z/4), 1, 1e-13
        );
        for (int k = 0; k < 100; ++k)
        {
            const vector3 m = {rnd.normal(), rnd.normal(), rnd.normal()};
            EXPECT_LE(dot(n, e.support(m)), dot(n, s)*(1 + 1e-14));
        }
    }
    // Corner, centre of an edge, centre of a face
    const convexBody box = convexBody::box({1, 2, 3});
    EXPECT_NEAR(mag(box.support({1, 1, 1}) - vector3{0.5, 1, 1.5}), 0, 1e-15);
    EXPECT_NEAR(mag(box.support({1, 1, 0}) - vector3{0.5, 1, 0}), 0, 1e-15);
    EXPECT_NEAR(mag(box.support({0, -1, 0}) - vector3{0, -1, 0}), 0, 1e-15);
}


TEST(convexBody, readsPolyhedraFromFiles)
{
    const convexBody exact = convexBody::box({1, 2, 3});
    const std::string obj = write("box.obj", boxObj({1, 2, 3}));
    const std::string ascii = write("ascii.stl", boxStl({0.5, 1, 1.5}, 0));
    const std::string binary = write("binary.stl", boxStl({0.5, 1, 1.5}, 1));

    // Vertices of some triangles off by round-off, as of a cosine and a sine
    std::string text = boxStl({0.5, 1, 1.5}, 0);
    for (const char* x : {"vertex 0.5 ", "vertex -0.5 "})
    {
        std::string off(x);
        off.insert(off.size() - 1, "00000000000001");
        text.replace(text.rfind(x), std::string(x).size(), off);
    }
    const std::string uneven = write("uneven.stl", text);
    for (const std::string& name : {obj, ascii, binary, uneven})
    {
        const convexBody b = convexBody::polyhedron(name, 2);
        EXPECT_EQ(b.vertices().size(), 8u) << name;
        EXPECT_EQ(b.edges().size(), 12u) << name;
        EXPECT_NEAR(b.volume(), 48, 1e-12) << name;

        // Principal axes in any order
        double have[3] = {b.inertia().x, b.inertia().y, b.inertia().z};
        double want[3] =
            {exact.inertia().x, exact.inertia().y, exact.inertia().z};
        std::sort(have, have + 3);
        std::sort(want, want + 3);
        for (int i = 0; i < 3; ++i)
        {
            EXPECT_NEAR(have[i], 4*want[i], 1e-12) << name;
        }
    }
}


TEST(convexBody, refusesBadInput)
{
    auto refused = [](const std::string& name, const std::string& reason)
    {
        try
        {
            convexBody::polyhedron(name);
            ADD_FAILURE() << name << " was accepted";
        }
        catch (const std::invalid_argument& error)
        {
            EXPECT_NE
            (
                std::string(error.what()).find(reason), std::string::npos
            ) << error.what();
        }
    };
    refused("/nonexistent.stl", "cannot be read");
    refused(write("box.txt", boxObj({1, 1, 1})), ".stl or .obj");
    refused(write("in.obj", boxObj({1, 1, 1}, true)), "inside out");
    std::string open = boxObj({1, 1, 1});
    open.resize(open.rfind("f "));
    refused(write("open.obj", open), "not closed");
    refused(write("empty.obj", "v 0 0 0\n"), "no faces");
    refused(write("label.obj", "v 0 0 0\nf 1 2 3\n"), "does not exist");

    // A box with a dent: one corner pulled in past the centre
    std::string dent = boxObj({1, 1, 1});
    const std::size_t at = dent.find("v ", dent.find("v ") + 1);
    dent.replace(at, dent.find('\n', at) - at, "v 6.9 -3.02 1.9");
    refused(write("dent.obj", dent), "not convex");

    EXPECT_THROW(convexBody::sphere(0), std::invalid_argument);
    EXPECT_THROW(convexBody::ellipsoid({1, -1, 1}), std::invalid_argument);
    EXPECT_THROW(convexBody::box({1, 1, 0}), std::invalid_argument);
    EXPECT_THROW
    (
        convexBody::truncatedBox({1, 1, 1}, 0.5), std::invalid_argument
    );
    EXPECT_THROW
    (
        convexBody::truncatedBox({1, 1, 1}, 0), std::invalid_argument
    );
}


TEST(convexBody, rollsNoBallInsideThatIsLargerThanItself)
{
    // Whose square over it rounds up for some: the search takes the root of
    // the difference
    for (int i = 1; i <= 1000; ++i)
    {
        const convexBody ball = convexBody::sphere(1e-6*i);
        EXPECT_GE(ball.radius(), ball.minCurvature());
        EXPECT_NEAR(ball.minCurvature()/ball.radius(), 1, 1e-15);
    }
    const convexBody egg = convexBody::ellipsoid({2, 1, 1});
    EXPECT_NEAR(egg.minCurvature(), 0.25, 1e-15);
}
