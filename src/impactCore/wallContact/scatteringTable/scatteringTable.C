/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "scatteringTable.H"
#include "gridPlace.H"
#include "outOfRange.H"
#include "scatteringSampler.H"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace
{

using namespace impact;

constexpr double degrees = 180/M_PI;


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
        const double larger = std::max(std::fabs(p), std::fabs(q));
        if (numbers ? std::fabs(p - q) > 1e-6*larger : x != y)
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


} // End anonymous namespace


std::vector<std::string> impact::scatteringTable::describe
(
    const wallEncounter& s,
    const vector3& spin
)
{
    std::vector<std::string> lines;
    const convexBody& body = s.body;
    const double d = body.equivalentDiameter();

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


void impact::scatteringTable::sample(const samplerSetup& setup)
{
    const scatteringSampler sampler(setup);
    const double unit = radius_/setup.speed;
    const vector3& J = setup.body.inertia();
    for (const visitResult& r : sampler.visits(0, nRows_))
    {
        const vector3 V = r.departure();
        const rotationState& s = r.state.rotation;
        row x;
        x.alpha = float(std::atan2(V.y, V.x));
        x.beta = float(std::atan2(V.z, std::hypot(V.x, V.y)));
        x.speed = float(mag(V)/setup.speed);
        x.spin[0] = float(unit*dot(s.omega, s.ex));
        x.spin[1] = float(unit*dot(s.omega, s.ey));
        x.spin[2] = float(unit*dot(s.omega, s.ez()));
        x.rotation = float
        (
            dot(multiply(J, s.omega), s.omega)/(setup.speed*setup.speed)
        );
        rows_.push_back(x);
    }
    std::sort
    (
        rows_.end() - nRows_, rows_.end(),
        [](const row& a, const row& b) { return a.alpha < b.alpha; }
    );
}


void impact::scatteringTable::setLogarithms()
{
    for (const double speed : speeds_)
    {
        logSpeeds_.push_back(std::log(speed));
    }
}


impact::scatteringTable::scatteringTable
(
    const samplerSetup& setup,
    const std::vector<double>& incidences,
    int nRows,
    const std::vector<double>& speeds
)
:
    description_(describe(setup, setup.spin)),
    incidences_(incidences),
    speeds_(speeds),
    nRows_(nRows),
    radius_(setup.body.radius()),
    diameter_(setup.body.equivalentDiameter())
{
    checkRange("rows of a table", nRows, "[1, inf)");
    if (setup.law.dependsOnSpeed() && speeds.empty())
    {
        refuse("the law depends on the speed: a table of it needs speeds");
    }
    if (!setup.law.dependsOnSpeed() && !speeds.empty())
    {
        refuse
        (
            "the law does not depend on the speed: a table of it holds for"
            " every speed and takes none"
        );
    }
    for (const double speed : speeds)
    {
        checkRange("speed of a table", speed, "(0, 3e8) m/s");
    }
    for (const auto* grid : {&incidences_, &speeds_})
    {
        for (std::size_t i = 1; i < grid->size(); ++i)
        {
            if (!((*grid)[i] > (*grid)[i - 1]))
            {
                refuse
                (
                    grid == &speeds_ ? "speed " : "incidence ", (*grid)[i],
                    " of a table follows ", (*grid)[i - 1],
                    ": they must increase"
                );
            }
        }
    }
    setLogarithms();
    samplerSetup one(setup);
    for (int j = 0; j < nSpeeds(); ++j)
    {
        one.speed = speeds.empty() ? setup.speed : speeds[j];
        for (const double incidence : incidences)
        {
            one.incidence = incidence;
            sample(one);
        }
    }
}


void impact::scatteringTable::checkCovers
(
    const wallEncounter& request,
    double lowest,
    double highest,
    double slowest,
    double fastest
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
    if (speeds_.empty() && request.law.dependsOnSpeed())
    {
        refuse
        (
            "the table holds no speeds, on which the law depends: write it"
            " anew with scatteringIndicatrix -table"
        );
    }
    if
    (
        !speeds_.empty()
     && (
            slowest < (1 - slack)*speeds_.front()
         || fastest > (1 + slack)*speeds_.back()
        )
    )
    {
        refuse
        (
            "the table holds the speeds ", speeds_.front(), " to ",
            speeds_.back(), " m/s, this wall needs ", slowest, " to ",
            fastest
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
    outside = incidence < incidences_[0] || incidence > incidences_.back();
    const gridPlace angle(incidences_, incidence);

    const threeUnits u =
        threeUnits::drawn(key.seed, 0, drawPurpose::tableRow, key.stream);
    const double place = u.u0*nRows_ - 0.5;
    const int first = std::max(0, int(std::floor(place)));
    const int second = std::min(first + 1, nRows_ - 1);
    const double f = std::max(0., place - first);
    auto alphaAt = [&](int j)
    {
        const row* a = rows(angle.low, j);
        const row* b = rows(angle.high, j);
        return
            (1 - angle.share)*((1 - f)*a[first].alpha + f*a[second].alpha)
          + angle.share*((1 - f)*b[first].alpha + f*b[second].alpha);
    };
    double alpha;
    int chosen = 0;
    bool held = false;
    if (speeds_.empty())
    {
        alpha = alphaAt(0);
    }
    else
    {
        held = speed < speeds_[0] || speed > speeds_.back();
        const gridPlace s(logSpeeds_, std::log(std::max(speed, 1e-300)));
        alpha = (1 - s.share)*alphaAt(s.low) + s.share*alphaAt(s.high);
        chosen = u.u2 < s.share ? s.high : s.low;
    }
    const int nearest = f < 0.5 ? first : second;
    const row& r =
        rows(u.u1 < angle.share ? angle.high : angle.low, chosen)[nearest];

    // That of a single number along the wall would lead into it
    alpha = std::min(alpha, M_PI);

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
    out.setSphereSpin(diameter);
    out.impacts = 1;
    out.held = held;
    return out;
}
