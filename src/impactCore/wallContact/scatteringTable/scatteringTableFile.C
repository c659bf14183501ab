/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The file of a scatteringTable.
\*---------------------------------------------------------------------------*/

#include "scatteringTable.H"
#include "outOfRange.H"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace
{

constexpr double degrees = 180/3.14159265358979323846;

// Without and with several speeds of arrival
const char* const firstLine = "# scatteringResponse version 2";
const char* const firstLineOfSpeeds = "# scatteringResponse version 3";
const char* const columns =
    "alpha1_deg,alpha2_deg,beta2_deg,speedRatio,spinX,spinY,spinZ,rotation";
const char* const columnOfSpeeds = "speed1,";


//- The numbers of a row from number first on, and on to the next row: false
//  if there are others
bool takeRow(const char*& at, int first, double (&v)[9])
{
    for (int k = first; k < 9; ++k)
    {
        char* end;
        v[k] = std::strtod(at, &end);
        const char expected = k < 8 ? ',' : '\n';
        const bool closed = *end == expected || (k == 8 && *end == '\r');
        if (end == at || !closed || !(std::fabs(v[k]) < 1e30))
        {
            return false;
        }
        at = end + 1 + (*end == '\r');
    }
    return true;
}

//- A line without its end, that of other systems, too
bool takeLine(std::istream& file, std::string& line)
{
    const bool good = bool(std::getline(file, line));
    if (!line.empty() && line.back() == '\r')
    {
        line.pop_back();
    }
    return good;
}

} // End anonymous namespace


void impact::scatteringTable::write
(
    const std::function<void(const char*)>& print
) const
{
    const bool ofSpeeds = !speeds_.empty();
    print(ofSpeeds ? firstLineOfSpeeds : firstLine);
    print
    (
        "\n# A row is one particle; rows of an incidence are in the order of"
        " alpha2, so that row k of one and of the next angle of incidence"
        " are the same quantile of alpha2.\n"
        "# speedRatio = |V2|/|V1|, spin = omega2 radius/|V1| in axes of the"
        " wall (x along it, y normal to it), rotation = share of |V1|^2/2"
        " that rotates\n"
    );
    for (const std::string& line : description_)
    {
        print(("# " + line + "\n").c_str());
    }
    std::ostringstream sizes;
    sizes.precision(12);
    sizes
        << "# radius " << radius_ << "\n# diameter " << diameter_ << '\n';
    if (ofSpeeds)
    {
        sizes<< "# nSpeeds " << speeds_.size() << '\n';
    }
    sizes
        << "# nIncidences " << incidences_.size() << "\n# nRows " << nRows_
        << '\n' << (ofSpeeds ? columnOfSpeeds : "") << columns << '\n';
    print(sizes.str().c_str());
    char line[200];
    for (std::size_t i = 0; i < rows_.size(); ++i)
    {
        const row& r = rows_[i];
        const std::size_t block = i/nRows_;
        if (ofSpeeds)
        {
            std::snprintf
            (
                line, sizeof(line), "%.9g,",
                speeds_[block/incidences_.size()]
            );
            print(line);
        }
        std::snprintf
        (
            line, sizeof(line), "%.9g,%.7g,%.7g,%.7g,%.6g,%.6g,%.6g,%.6g\n",
            incidences_[block % incidences_.size()],
            degrees*r.alpha, degrees*r.beta, double(r.speed),
            double(r.spin[0]), double(r.spin[1]), double(r.spin[2]),
            double(r.rotation)
        );
        print(line);
    }
}


impact::scatteringTable::sizes impact::scatteringTable::readHead
(
    std::istream& file,
    const std::string& fileName
)
{
    std::string line;
    takeLine(file, line);
    const bool ofSpeeds = line == firstLineOfSpeeds;
    if (line != firstLine && !ofSpeeds)
    {
        throwInvalid
        (
            "table \"", fileName, "\" begins with '", line.substr(0, 60),
            "' instead of '", firstLine, "' or '", firstLineOfSpeeds,
            "': write it anew with scatteringIndicatrix -table"
        );
    }
    long nSpeeds = ofSpeeds ? 0 : 1, nIncidences = 0, nRows = 0;
    while (takeLine(file, line) && line.compare(0, 2, "# ") == 0)
    {
        line = line.substr(2);
        const std::string key = line.substr(0, line.find(' '));
        const std::string value =
            line.size() > key.size() ? line.substr(key.size() + 1) : "";
        if (key == "radius")
        {
            radius_ = std::strtod(value.c_str(), nullptr);
        }
        else if (key == "nSpeeds" && ofSpeeds)
        {
            nSpeeds = std::strtol(value.c_str(), nullptr, 10);
        }
        else if (key == "nIncidences")
        {
            nIncidences = std::strtol(value.c_str(), nullptr, 10);
        }
        else if (key == "nRows")
        {
            nRows = std::strtol(value.c_str(), nullptr, 10);
        }
        else if (key == "diameter")
        {
            diameter_ = std::strtod(value.c_str(), nullptr);
        }
        else
        {
            description_.push_back(line);
        }
    }
    const std::string expected =
        std::string(ofSpeeds ? columnOfSpeeds : "") + columns;
    if (line != expected)
    {
        throwInvalid
        (
            "table \"", fileName, "\" has the columns '",
            line.substr(0, 100), "' instead of '", expected, "'"
        );
    }
    if
    (
        !(radius_ > 0) || !(diameter_ > 0)
     || nSpeeds < 1 || nIncidences < 1 || nRows < 1
     || double(nSpeeds)*double(nIncidences)*double(nRows) > 1e9
    )
    {
        throwInvalid
        (
            "table \"", fileName, "\": radius ", radius_, ", nSpeeds ",
            nSpeeds, ", nIncidences ", nIncidences, ", nRows ", nRows,
            ": valid range > 0"
        );
    }
    nRows_ = int(nRows);
    return {ofSpeeds, std::size_t(nSpeeds), std::size_t(nIncidences)};
}


void impact::scatteringTable::takeNodes
(
    const std::string& fileName,
    const sizes& n,
    double speed,
    double incidence
)
{
    const std::size_t block = rows_.size()/nRows_;
    auto take = [&]
    (
        const char* what, std::vector<double>& grid, std::size_t i, double x
    )
    {
        const bool isNew = i == grid.size();
        if (isNew ? i > 0 && !(x > grid[i - 1]) : x != grid[i])
        {
            throwInvalid
            (
                "table \"", fileName, "\": ", what, ' ', x, " follows ",
                grid[i > 0 ? i - 1 : 0], isNew ? ": they must increase"
              : ": they must be alike at each speed"
            );
        }
        if (isNew)
        {
            grid.push_back(x);
        }
    };
    take("incidence", incidences_, block % n.incidences, incidence);
    if (n.ofSpeeds)
    {
        checkRange("table \"" + fileName + "\": speed", speed, "(0, 3e8) m/s");
        take("speed", speeds_, block/n.incidences, speed);
    }
}


impact::scatteringTable::scatteringTable(const std::string& fileName)
{
    std::ifstream file(fileName, std::ios::binary);
    if (!file)
    {
        throwInvalid("table \"", fileName, "\" cannot be read");
    }
    const sizes n(readHead(file, fileName));
    const std::size_t total = n.speeds*n.incidences*std::size_t(nRows_);
    const std::string body
    (
        (std::istreambuf_iterator<char>(file)),
        std::istreambuf_iterator<char>()
    );
    const char* at = body.c_str();
    rows_.reserve(total);
    double speed = 0, incidence = 0;
    for (std::size_t i = 0; i < total; ++i)
    {
        // Speed, incidence, outcome
        double v[9] = {};
        if (!takeRow(at, n.ofSpeeds ? 0 : 1, v))
        {
            throwInvalid
            (
                "table \"", fileName, "\", row ", i + 1, " of ", total,
                n.ofSpeeds ? ": nine" : ": eight", " numbers expected"
            );
        }
        if (i % std::size_t(nRows_) == 0)
        {
            takeNodes(fileName, n, v[0], v[1]);
            speed = v[0];
            incidence = v[1];
        }
        else if
        (
            v[0] != speed || v[1] != incidence
         || v[2]/degrees < double(rows_.back().alpha) - 1e-6
        )
        {
            throwInvalid
            (
                "table \"", fileName, "\", row ", i + 1,
                ": the rows are not in order"
            );
        }
        rows_.push_back
        ({
            float(v[2]/degrees), float(v[3]/degrees), float(v[4]),
            {float(v[5]), float(v[6]), float(v[7])}, float(v[8])
        });
    }
    if (*at != 0)
    {
        throwInvalid
        (
            "table \"", fileName, "\" goes on after its ", total, " rows"
        );
    }
    setLogarithms();
}
