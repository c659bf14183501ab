/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "scatteringTable.H"
#include "outOfRange.H"
#include "scatteringSampler.H"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace
{

using namespace impact;

constexpr double pi = 3.14159265358979323846;
constexpr double degrees = 180/pi;

const char* const firstLine = "# scatteringResponse version 2";
const char* const columns =
    "alpha1_deg,alpha2_deg,beta2_deg,speedRatio,spinX,spinY,spinZ,rotation";


template<class... Parts>
std::string text(const Parts&... parts)
{
    std::ostringstream os;
    os.precision(12);
    (os << ... << parts);
    return os.str();
}


template<class... Parts>
[[noreturn]] void refuse(const Parts&... parts)
{
    impact::throwInvalid(text(parts...));
}


double equivalentDiameter(const convexBody& body)
{
    return std::cbrt(6*body.volume()/pi);
}


//- Are the words of two lines the same, numbers within a relative 1e-6?
bool agree(const std::string& a, const std::string& b)
{
    std::istringstream wordsA(a), wordsB(b);
    std::string x, y;
    for (;;)
    {
        const bool moreA = bool(wordsA >> x);
        const bool moreB = bool(wordsB >> y);
        if (moreA != moreB)
        {
            return false;
        }
        if (!moreA)
        {
            return true;
        }
        char* endX;
        char* endY;
        const double p = std::strtod(x.c_str(), &endX);
        const double q = std::strtod(y.c_str(), &endY);
        const bool numbers = !*endX && !*endY;
        const double most = std::max(std::fabs(p), std::fabs(q));
        if (numbers ? std::fabs(p - q) > 1e-6*most : x != y)
        {
            return false;
        }
    }
}


//- What a line describes: its first word
std::string keyOf(const std::string& line)
{
    return line.substr(0, line.find(' '));
}


//- The numbers of a row, and on to the next row: false if there are others
bool takeRow(const char*& at, double (&v)[8])
{
    for (int k = 0; k < 8; ++k)
    {
        char* end;
        v[k] = std::strtod(at, &end);
        const char expected = k < 7 ? ',' : '\n';
        const bool closed = *end == expected || (k == 7 && *end == '\r');
        if (end == at || !closed || !(std::fabs(v[k]) < 1e30))
        {
            return false;
        }
        at = end + 1 + (*end == '\r');
    }
    return true;
}

} // End anonymous namespace


std::vector<std::string> impact::scatteringTable::describe
(
    const wallEncounter& s,
    const vector3& spin
)
{
    std::vector<std::string> lines;
    const convexBody& body = s.body;
    const double d = equivalentDiameter(body);

    // Proportions by what tells bodies apart: extent, inertia, vertices
    const vector3& a = body.semiAxes();
    const vector3& J = body.inertia();
    lines.push_back
    (
        text
        (
            "shape ",
            body.shape() == convexBody::shapeType::ellipsoid
          ? "ellipsoid" : "polyhedron",
            ' ', a.x/d, ' ', a.y/d, ' ', a.z/d,
            ' ', J.x/(d*d), ' ', J.y/(d*d), ' ', J.z/(d*d),
            ' ', body.radius()/d, ' ', body.vertices().size()
        )
    );
    if (s.law.dependsOnSpeed())
    {
        refuse
        (
            "a table holds for every speed: its law must not depend on it"
        );
    }
    const std::string normal = s.law.normal().describe();
    const std::string other = s.law.other().describe();
    lines.push_back
    (
        s.law.law() == reboundLaw::lawType::restitution
      ? text("law restitution ", normal, ' ', other)
      : text("law friction ", normal, ' ', other)
    );
    if (!s.wall)
    {
        lines.push_back("wall smooth");
    }
    else
    {
        const relief& wall = *s.wall;
        if (wall.type() == relief::reliefType::rough)
        {
            lines.push_back
            (
                text
                (
                    "wall rough ", wall.meanSpacing(), ' ',
                    wall.sigmaSpacing(), ' ', wall.sigmaHeight()
                )
            );
        }
        else
        {
            double sum = 0, moment = 0;
            for (const relief::interval& in : wall.table())
            {
                sum += std::fabs(in.c0);
                moment += in.x0*std::fabs(in.c0);
            }
            lines.push_back
            (
                text
                (
                    "wall periodic ", wall.period(), ' ', wall.top(), ' ',
                    wall.table().size(), ' ', sum, ' ', moment
                )
            );
        }
        lines.push_back(text("size ", d));
    }
    lines.push_back
    (
        s.treatment == visitTreatment::untilExit
      ? text("treatment untilExit ", s.maxImpacts)
      : text("treatment firstImpact")
    );
    lines.push_back
    (
        s.orientation == orientationLaw::isotropic
      ? "orientation isotropic" : "orientation uniformEuler"
    );
    lines.push_back
    (
        text("spin ", spin.x, ' ', spin.y, ' ', spin.z)
    );
    return lines;
}


impact::scatteringTable::scatteringTable
(
    const samplerSetup& setup,
    const std::vector<double>& incidences,
    int nRows
)
:
    description_(describe(setup, setup.spin)),
    incidences_(incidences),
    nRows_(nRows),
    radius_(setup.body.radius()),
    diameter_(equivalentDiameter(setup.body))
{
    checkRange("rows of a table", nRows, "[1, inf)");
    for (std::size_t i = 0; i < incidences.size(); ++i)
    {
        if (i > 0 && !(incidences[i] > incidences[i - 1]))
        {
            refuse
            (
                "incidence ", incidences[i], " of a table follows ",
                incidences[i - 1], ": they must increase"
            );
        }
        samplerSetup one(setup);
        one.incidence = incidences[i];
        const scatteringSampler sampler(one);
        const double unit = radius_/one.speed;
        const vector3& J = setup.body.inertia();
        for (const visitResult& r : sampler.visits(0, nRows))
        {
            const vector3& V = r.state.V;
            const rotationState& s = r.state.rotation;
            row x;
            x.alpha = float(std::atan2(V.y, V.x));
            x.beta = float(std::atan2(V.z, std::hypot(V.x, V.y)));
            x.speed = float(mag(V)/one.speed);
            x.spin[0] = float(unit*dot(s.omega, s.ex));
            x.spin[1] = float(unit*dot(s.omega, s.ey));
            x.spin[2] = float(unit*dot(s.omega, s.ez()));
            x.rotation = float
            (
                dot(multiply(J, s.omega), s.omega)/(one.speed*one.speed)
            );
            rows_.push_back(x);
        }
        std::sort
        (
            rows_.end() - nRows, rows_.end(),
            [](const row& a, const row& b) { return a.alpha < b.alpha; }
        );
    }
}


void impact::scatteringTable::write
(
    const std::function<void(const char*)>& print
) const
{
    print(firstLine);
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
    print
    (
        text
        (
            "# radius ", radius_, "\n# diameter ", diameter_,
            "\n# nIncidences ", incidences_.size(),
            "\n# nRows ", nRows_, '\n', columns, '\n'
        ).c_str()
    );
    char line[200];
    for (std::size_t i = 0; i < rows_.size(); ++i)
    {
        const row& r = rows_[i];
        std::snprintf
        (
            line, sizeof(line), "%.9g,%.7g,%.7g,%.7g,%.6g,%.6g,%.6g,%.6g\n",
            incidences_[i/nRows_], degrees*r.alpha, degrees*r.beta,
            double(r.speed), double(r.spin[0]), double(r.spin[1]),
            double(r.spin[2]), double(r.rotation)
        );
        print(line);
    }
}


long impact::scatteringTable::readHead
(
    std::istream& file,
    const std::string& fileName
)
{
    std::string line;
    std::getline(file, line);
    if (line != firstLine)
    {
        refuse
        (
            "table \"", fileName, "\" begins with '", line.substr(0, 60),
            "' instead of '", firstLine, "': write it anew with"
            " scatteringIndicatrix -table"
        );
    }
    long nIncidences = 0, nRows = 0;
    while (std::getline(file, line) && line.compare(0, 2, "# ") == 0)
    {
        line = line.substr(2);
        const std::string key = keyOf(line);
        const std::string value =
            line.size() > key.size() ? line.substr(key.size() + 1) : "";
        if (key == "radius")
        {
            radius_ = std::strtod(value.c_str(), nullptr);
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
    if (line != columns)
    {
        refuse
        (
            "table \"", fileName, "\" has the columns '",
            line.substr(0, 100), "' instead of '", columns, "'"
        );
    }
    if
    (
        !(radius_ > 0) || !(diameter_ > 0) || nIncidences < 1 || nRows < 1
     || double(nIncidences)*double(nRows) > 1e9
    )
    {
        refuse
        (
            "table \"", fileName, "\": radius ", radius_, ", nIncidences ",
            nIncidences, ", nRows ", nRows, ": valid range > 0"
        );
    }
    nRows_ = int(nRows);
    return nIncidences;
}


impact::scatteringTable::scatteringTable(const std::string& fileName)
{
    std::ifstream file(fileName, std::ios::binary);
    if (!file)
    {
        refuse("table \"", fileName, "\" cannot be read");
    }
    const std::size_t total =
        std::size_t(readHead(file, fileName))*std::size_t(nRows_);
    const std::string body
    (
        (std::istreambuf_iterator<char>(file)),
        std::istreambuf_iterator<char>()
    );
    const char* at = body.c_str();
    rows_.reserve(total);
    for (std::size_t i = 0; i < total; ++i)
    {
        double v[8];
        if (!takeRow(at, v))
        {
            refuse
            (
                "table \"", fileName, "\", row ", i + 1, " of ", total,
                ": eight numbers expected"
            );
        }
        if (i % std::size_t(nRows_) == 0)
        {
            if (!incidences_.empty() && !(v[0] > incidences_.back()))
            {
                refuse
                (
                    "table \"", fileName, "\": incidence ", v[0],
                    " follows ", incidences_.back(), ": they must increase"
                );
            }
            incidences_.push_back(v[0]);
        }
        else if
        (
            v[0] != incidences_.back()
         || v[1]/degrees < double(rows_.back().alpha) - 1e-6
        )
        {
            refuse
            (
                "table \"", fileName, "\", row ", i + 1,
                ": the rows are not in order"
            );
        }
        rows_.push_back
        ({
            float(v[1]/degrees), float(v[2]/degrees), float(v[3]),
            {float(v[4]), float(v[5]), float(v[6])}, float(v[7])
        });
    }
    if (*at != 0)
    {
        refuse
        (
            "table \"", fileName, "\" goes on after its ", total, " rows"
        );
    }
}


void impact::scatteringTable::checkCovers
(
    const wallEncounter& request,
    double lowest,
    double highest
) const
{
    for (const std::string& wanted : describe(request, {0, 0, 0}))
    {
        const std::string key = keyOf(wanted);
        const auto has = std::find_if
        (
            description_.begin(), description_.end(),
            [&](const std::string& line) { return keyOf(line) == key; }
        );
        if (has == description_.end() || !agree(*has, wanted))
        {
            refuse
            (
                "the table was sampled with '",
                has == description_.end() ? "no " + key : *has,
                "', this wall has '", wanted, "'"
            );
        }
    }
    const double slack = 1e-9;
    if
    (
        lowest < incidences_.front() - slack
     || highest > incidences_.back() + slack
    )
    {
        refuse
        (
            "the table holds the incidences ", incidences_.front(), " to ",
            incidences_.back(), " deg, this wall needs ", lowest, " to ",
            highest
        );
    }
}


impact::wallDeparture impact::scatteringTable::depart
(
    const vector3& V,
    double diameter,
    const impactKey& key,
    bool& outside
) const
{
    const double speed = mag(V);
    const double incidence = degrees*std::atan2(-V.y, std::fabs(V.x));
    const int last = int(incidences_.size()) - 1;
    outside = incidence < incidences_[0] || incidence > incidences_[last];
    int low = 0;
    double share = 0;
    if (incidence >= incidences_[last])
    {
        low = last;
    }
    else if (incidence > incidences_[0])
    {
        low = int
        (
            std::upper_bound
            (
                incidences_.begin(), incidences_.end(), incidence
            ) - incidences_.begin()
        ) - 1;
        share =
            (incidence - incidences_[low])
           /(incidences_[low + 1] - incidences_[low]);
    }
    const int high = std::min(low + 1, last);

    std::uint64_t w0, w1, w2, w3;
    philoxLane
    (
        key.seed, 0, drawPurpose::tableRow, key.stream, w0, w1, w2, w3
    );
    double u, choice, unused;
    threeUnits(w0, w1, w2, w3, u, choice, unused);
    const double place = u*nRows_ - 0.5;
    const int first = std::max(0, int(std::floor(place)));
    const int second = std::min(first + 1, nRows_ - 1);
    const double f = std::max(0., place - first);
    const row* a = rows(low);
    const row* b = rows(high);
    const double alpha =
        (1 - share)*((1 - f)*a[first].alpha + f*a[second].alpha)
      + share*((1 - f)*b[first].alpha + f*b[second].alpha);
    const int nearest = f < 0.5 ? first : second;
    const row& r = choice < share ? b[nearest] : a[nearest];

    // A table looks along the motion of its particles
    const double forward = V.x < 0 ? -1 : 1;
    double sinA, cosA, sinB, cosB;
    sinCos(alpha, sinA, cosA);
    sinCos(r.beta, sinB, cosB);
    const double outSpeed = r.speed*speed;
    const double unit = speed/(radius_*diameter/diameter_);

    wallDeparture out = {};
    out.V =
    {
        forward*outSpeed*cosB*cosA, outSpeed*cosB*sinA,
        forward*outSpeed*sinB
    };
    out.omega =
    {
        forward*unit*r.spin[0], unit*r.spin[1], forward*unit*r.spin[2]
    };
    out.rotation1 = 0.5*r.rotation*speed*speed;
    out.impacts = 1;
    return out;
}
