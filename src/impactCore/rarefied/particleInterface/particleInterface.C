/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "particleInterface.H"
#include "csvLine.H"
#include "outOfRange.H"

#include <charconv>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace
{

const char* const title = "# particleInterface version ";

const int nColumns = 9;
const char* const columns[nColumns] =
    {"x", "y", "z", "ux", "uy", "uz", "T", "diameter", "weight"};


[[noreturn]] void complain(const std::string& file, const std::string& what)
{
    throw std::invalid_argument(file + ": " + what);
}


//- For each column of the file, its place in a record, or -1
std::vector<int> header(const std::string& file, const std::string& line)
{
    std::vector<int> place;
    int found[nColumns] = {};
    std::istringstream is(line);
    for (std::string name; std::getline(is, name, ',');)
    {
        while (!name.empty() && (name.back() == '\r' || name.back() == ' '))
        {
            name.pop_back();
        }
        name.erase(0, name.find_first_not_of(' '));
        place.push_back(-1);
        for (int i = 0; i < nColumns; ++i)
        {
            if (name == columns[i])
            {
                place.back() = i;
                ++found[i];
            }
        }
    }
    for (int i = 0; i < nColumns; ++i)
    {
        if (found[i] != 1)
        {
            complain
            (
                file, "the line of column names has "
              + std::to_string(found[i]) + " columns '" + columns[i]
              + "', needed are x,y,z,ux,uy,uz,T,diameter,weight once each"
            );
        }
    }
    return place;
}


void check
(
    const std::string& file,
    int lineNumber,
    int column,
    double value
)
{
    impact::checkRange
    (
        file + ": line " + std::to_string(lineNumber) + ": " + columns[column],
        value,
        column < 6 ? "(-inf, inf)" : column < 8 ? "(0, inf)" : "[0, inf)"
    );
}

} // End anonymous namespace


std::vector<impact::particleInterface::record>
impact::particleInterface::read(const std::string& file)
{
    std::ifstream is(file);
    if (!is)
    {
        complain(file, "cannot be read");
    }
    std::string line;
    std::getline(is, line);
    const std::string start(title);
    if (line.compare(0, start.size(), start))
    {
        complain
        (
            file, "does not begin with '" + start
          + std::to_string(version) + "'"
        );
    }
    if (std::atoi(line.c_str() + start.size()) != version)
    {
        complain
        (
            file, "has version " + line.substr(start.size())
          + ", this program reads version " + std::to_string(version)
        );
    }

    std::vector<int> place;
    std::vector<record> records;
    for (int n = 2; std::getline(is, line); ++n)
    {
        const std::size_t first = line.find_first_not_of(" \t\r");
        if (first == std::string::npos || line[first] == '#')
        {
            continue;
        }
        if (place.empty())
        {
            place = header(file, line);
            continue;
        }
        double values[nColumns] = {};
        const char* at = line.c_str();
        for (std::size_t i = 0; i < place.size(); ++i)
        {
            if (place[i] < 0)
            {
                while (*at && *at != ',')
                {
                    ++at;
                }
            }
            else
            {
                // (strtod of too large a number ends a run that traps)
                while (*at == ' ' || *at == '\t')
                {
                    ++at;
                }
                at += *at == '+' && at[1] != '-';
                const auto number = std::from_chars
                    (at, line.c_str() + line.size(), values[place[i]]);
                bool read = number.ec == std::errc();
                if (number.ec == std::errc::result_out_of_range)
                {
                    read = true;
                    const std::string text(at, number.ptr);
                    values[place[i]] =
                        text.find("e-") != std::string::npos
                     || text.find("E-") != std::string::npos
                      ? 0
                      : std::numeric_limits<double>::infinity();
                }
                at = number.ptr;
                while (*at == ' ' || *at == '\r')
                {
                    ++at;
                }
                if (!read || (*at != ',' && *at != '\0'))
                {
                    complain
                    (
                        file, "line " + std::to_string(n) + ": column "
                      + columns[place[i]] + " is not a number"
                    );
                }
                check(file, n, place[i], values[place[i]]);
            }
            const bool last = i + 1 == place.size();
            if (last ? *at == ',' : *at != ',')
            {
                complain
                (
                    file, "line " + std::to_string(n)
                  + (last ? " has more" : " has fewer") + " than the "
                  + std::to_string(place.size()) + " columns named"
                );
            }
            ++at;
        }
        records.push_back
        ({
            {values[0], values[1], values[2]},
            {values[3], values[4], values[5]},
            values[6], values[7], values[8]
        });
    }
    if (place.empty())
    {
        complain(file, "has no line of column names");
    }
    return records;
}


std::string impact::particleInterface::text
(
    const std::vector<record>& records,
    const std::string& comment
)
{
    std::ostringstream os;
    os << title << version << '\n';
    std::istringstream lines(comment);
    for (std::string line; std::getline(lines, line);)
    {
        os << "# " << line << '\n';
    }
    csvLine line;
    for (const char* name : columns)
    {
        line.add(name);
    }
    os << line.take();
    int n = 0;
    for (const record& r : records)
    {
        ++n;
        const double values[nColumns] =
        {
            r.position.x, r.position.y, r.position.z,
            r.velocity.x, r.velocity.y, r.velocity.z,
            r.temperature, r.diameter, r.weight
        };
        for (int i = 0; i < nColumns; ++i)
        {
            check("writing record", n, i, values[i]);
            line.add(values[i]);
        }
        os << line.take();
    }
    return os.str();
}
