/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "convexBody.H"
#include "outOfRange.H"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace
{

typedef impact::convexBody::surface surface;
using impact::vector3;

//- Make coordinates the same that differ by round-off alone
void align
(
    std::vector<vector3>& points,
    double vector3::* coordinate
)
{
    std::vector<int> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort
    (
        order.begin(), order.end(),
        [&](int i, int j)
        {
            return points[i].*coordinate < points[j].*coordinate;
        }
    );
    double nearest = 1e-9;
    if (!order.empty())
    {
        nearest *=
            points[order.back()].*coordinate
          - points[order.front()].*coordinate;
    }
    for (std::size_t k = 1; k < order.size(); ++k)
    {
        const double before = points[order[k - 1]].*coordinate;
        double& x = points[order[k]].*coordinate;
        x = x - before <= nearest ? before : x;
    }
}


//- Triangles share no vertices in an STL file: join those that coincide. Three
//  vertices to a triangle
surface joined(std::vector<vector3> vertices)
{
    align(vertices, &vector3::x);
    align(vertices, &vector3::y);
    align(vertices, &vector3::z);
    surface s;
    std::map<std::tuple<double, double, double>, int> labels;
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
        const vector3& p = vertices[i];
        const auto found =
            labels.emplace
            (
                std::make_tuple(p.x, p.y, p.z), int(s.points.size())
            );
        if (found.second)
        {
            s.points.push_back(p);
        }
        if (i % 3 == 0)
        {
            s.faces.emplace_back();
        }
        s.faces.back().push_back(found.first->second);
    }
    return s;
}


[[noreturn]] void fail(const std::string& fileName, const std::string& why)
{
    throw std::invalid_argument("file \"" + fileName + "\": " + why);
}


surface readObj(const std::string& fileName, const std::string& text)
{
    surface s;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
    {
        std::istringstream words(line);
        std::string key;
        words >> key;
        if (key == "v")
        {
            vector3 p;
            if (!(words >> p.x >> p.y >> p.z))
            {
                fail(fileName, "a vertex line without three numbers");
            }
            s.points.push_back(p);
        }
        else if (key == "f")
        {
            std::vector<int> face;
            for (std::string word; words >> word;)
            {
                // v, v/vt, v//vn or v/vt/vn; negative counts from the end
                int v = std::atoi(word.c_str());
                v = v < 0 ? v + int(s.points.size()) : v - 1;
                if (v < 0 || v >= int(s.points.size()))
                {
                    fail(fileName, "a face names vertex '" + word
                        + "', which does not exist");
                }
                face.push_back(v);
            }
            if (face.size() < 3)
            {
                fail(fileName, "a face of fewer than 3 vertices");
            }
            s.faces.push_back(face);
        }
    }
    return s;
}


surface readStl(const std::string& fileName, const std::string& text)
{
    std::vector<vector3> vertices;

    // A binary file is recognised by its length: some begin with "solid" too
    std::uint32_t n = 0;
    if (text.size() >= 84)
    {
        std::memcpy(&n, text.data() + 80, 4);
    }
    if (text.size() >= 84 && text.size() == 84 + 50*std::size_t(n))
    {
        for (std::size_t i = 0; i < n; ++i)
        {
            float xyz[9];
            std::memcpy(xyz, text.data() + 84 + 50*i + 12, sizeof(xyz));
            for (int k = 0; k < 3; ++k)
            {
                vertices.push_back({xyz[3*k], xyz[3*k + 1], xyz[3*k + 2]});
            }
        }
        return joined(vertices);
    }

    std::istringstream words(text);
    int corners = 0;
    for (std::string word; words >> word;)
    {
        if (word == "vertex")
        {
            vector3 p;
            if (!(words >> p.x >> p.y >> p.z))
            {
                fail(fileName, "a vertex without three numbers");
            }
            vertices.push_back(p);
            ++corners;
        }
        else if (word == "endloop")
        {
            if (corners != 3)
            {
                fail(fileName, "a facet that is not a triangle");
            }
            corners = 0;
        }
    }
    vertices.resize(vertices.size() - corners);
    return joined(vertices);
}

} // End anonymous namespace


impact::convexBody::surface impact::convexBody::readSurface
(
    const std::string& fileName
)
{
    std::ifstream file(fileName, std::ios::binary);
    if (!file)
    {
        fail(fileName, "cannot be read");
    }
    std::ostringstream buffer;
    buffer << file.rdbuf();

    std::string extension = fileName.substr(fileName.find_last_of('.') + 1);
    for (char& c : extension)
    {
        c = char(std::tolower(c));
    }
    surface s;
    if (extension == "obj")
    {
        s = readObj(fileName, buffer.str());
    }
    else if (extension == "stl")
    {
        s = readStl(fileName, buffer.str());
    }
    else
    {
        fail(fileName, "the name must end in .stl or .obj");
    }
    if (s.faces.empty())
    {
        fail(fileName, "holds no faces");
    }
    return s;
}


impact::convexBody impact::convexBody::polyhedron
(
    const std::string& fileName,
    double scale
)
{
    checkRange("polyhedron scale", scale, "(0, 1e100)");
    surface s = readSurface(fileName);
    for (vector3& p : s.points)
    {
        p = scale*p;
    }
    try
    {
        return polyhedron(s);
    }
    catch (const std::invalid_argument& error)
    {
        fail(fileName, error.what());
    }
}
