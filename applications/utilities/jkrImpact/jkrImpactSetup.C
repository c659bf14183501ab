/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "jkrImpactSetup.H"
#include "checked.H"

#include "FlatOutput.H"
#include "ListOps.H"
#include "Switch.H"

#include <fstream>
#include <sstream>

namespace
{

using namespace Foam;

//- The one of the valid words that an entry has
word getWord
(
    const dictionary& dict,
    const word& entry,
    const wordList& valid,
    const word& deflt = word::null
)
{
    const word value
    (
        deflt.empty()
      ? dict.get<word>(entry) : dict.getOrDefault<word>(entry, deflt)
    );
    if (!valid.found(value))
    {
        FatalIOErrorInFunction(dict)
            << "Unknown " << entry << ' ' << value << nl
            << "Valid words: " << flatOutput(valid) << exit(FatalIOError);
    }
    return value;
}


impact::elasticSolid readSolid(const dictionary& dict)
{
    return {dict.get<scalar>("E"), dict.get<scalar>("nu")};
}


impact::elasticSphere readSphere(const dictionary& dict)
{
    return
    {
        dict.get<scalar>("diameter"),
        dict.get<scalar>("density"),
        readSolid(dict)
    };
}


//- Effective quantities, or materials
impact::jkrContact readContact(const dictionary& dict)
{
    return checked(dict, [&]()
    {
        const scalar w = dict.get<scalar>("workOfAdhesion");
        if (dict.found("radius"))
        {
            return impact::jkrContact
            (
                dict.get<scalar>("radius"),
                dict.get<scalar>("modulus"),
                dict.get<scalar>("mass"),
                w
            );
        }
        const impact::elasticSphere particle =
            readSphere(dict.subDict("particle"));
        return dict.found("partner")
          ? impact::jkrContact::between
            (
                particle, readSphere(dict.subDict("partner")), w
            )
          : impact::jkrContact::onWall
            (
                particle, readSolid(dict.subDict("wall")), w
            );
    });
}


impact::impactSettings readSettings(const dictionary& dict)
{
    typedef impact::impactScheme scheme;
    typedef impact::unloadingType unloading;

    impact::impactSettings settings;
    const word name
    (
        getWord(dict, "scheme", {"rk4", "adaptive", "table"}, "adaptive")
    );
    settings.scheme =
        name == "rk4" ? scheme::rk4
      : name == "table" ? scheme::table
      : scheme::adaptive;
    settings.unloading =
        getWord(dict, "unloading", {"soft", "hard"}, "soft") == "soft"
      ? unloading::soft : unloading::hard;
    settings.tolerance =
        dict.getOrDefault<scalar>("tolerance", settings.tolerance);
    settings.timeStep =
        dict.getOrDefault<scalar>("timeStep", settings.timeStep);
    settings.interpolate =
        dict.getOrDefault<Switch>("interpolate", settings.interpolate);
    return settings;
}


//- Columns V, e of a file; commas and lines that begin with # are skipped
std::vector<measuredImpact> readMeasured
(
    const dictionary& dict,
    const fileName& casePath
)
{
    fileName file(dict.get<fileName>("file"));
    file.expand();
    if (!file.isAbsolute())
    {
        file = casePath/file;
    }
    std::ifstream is(file);
    if (!is)
    {
        FatalIOErrorInFunction(dict)
            << "file " << file << " cannot be read" << exit(FatalIOError);
    }
    std::vector<measuredImpact> data;
    std::string line;
    for (label number = 1; std::getline(is, line); ++number)
    {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream columns(line);
        std::string first;
        if (!(columns >> first) || first[0] == '#')
        {
            continue;
        }
        measuredImpact m = {0, 0};
        columns.clear();
        columns.seekg(0);
        if (!(columns >> m.speed >> m.restitution) || !(m.speed > 0))
        {
            FatalIOErrorInFunction(dict)
                << "file " << file << ", line " << number << ", '" << line
                << "': valid lines: V (0, inf) and e (0, 1)"
                << exit(FatalIOError);
        }
        data.push_back(m);
    }
    return data;
}


//- alpha, or type and entries of the law
impact::dissipationLaw readLaw
(
    const dictionary& dict,
    const fileName& casePath,
    const impact::jkrContact& contact,
    impact::unloadingType unloading,
    std::vector<measuredImpact>& measured
)
{
    typedef impact::dissipationLaw law;
    if (!dict.isDict("alpha"))
    {
        return checked(dict, [&]()
        {
            return law::constant(dict.get<scalar>("alpha"), unloading);
        });
    }
    const dictionary& alpha = dict.subDict("alpha");
    const word type
    (
        getWord
        (
            alpha, "type", {"constant", "marshall", "polynomial", "calibrated"}
        )
    );
    return checked(alpha, [&]()
    {
        if (type == "constant")
        {
            return law::constant(alpha.get<scalar>("value"), unloading);
        }
        if (type == "marshall")
        {
            // P gives back the restitution of a contact without adhesion: as
            // a function of that of the impact itself no speed belongs to it
            if (!alpha.found("restitution"))
            {
                FatalIOErrorInFunction(alpha)
                    << "alpha of type marshall needs the entry restitution,"
                    << " that of the contact without adhesion: valid range"
                    << " [0, 1]" << exit(FatalIOError);
            }
            return law::constant
            (
                law::marshall().alpha(alpha.get<scalar>("restitution")),
                unloading
            );
        }
        if (type == "polynomial")
        {
            const List<scalar> coeffs(alpha.get<List<scalar>>("coeffs"));
            const List<scalar> range
            (
                alpha.getOrDefault<List<scalar>>("range", {0, 1})
            );
            if (range.size() != 2)
            {
                FatalIOErrorInFunction(alpha)
                    << "range " << flatOutput(range)
                    << ": valid (low high), 0 <= low < high <= 1"
                    << exit(FatalIOError);
            }
            const law polynomial = law::polynomial
            (
                std::vector<double>(coeffs.begin(), coeffs.end()),
                range[0],
                range[1],
                unloading
            );
            return alpha.found("restitution")
              ? law::constant
                (
                    polynomial.alpha(alpha.get<scalar>("restitution")),
                    unloading
                )
              : polynomial;
        }
        const scalar v = contact.separationSpeed();
        if (!(v > 0))
        {
            FatalIOErrorInFunction(dict)
                << "workOfAdhesion " << contact.workOfAdhesion()
                << ": valid range with alpha calibrated (0, inf)"
                << exit(FatalIOError);
        }
        measured = readMeasured(alpha, casePath);
        std::vector<law::measurement> data;
        for (const measuredImpact& m : measured)
        {
            data.push_back({m.speed/v, m.restitution});
        }
        return law::fit
        (
            data,
            alpha.getOrDefault<label>("degree", 3),
            alpha.getOrDefault<Switch>("extrapolate", false),
            unloading
        );
    });
}


List<scalar> readSpeeds(const dictionary& dict)
{
    List<scalar> speeds;
    if (dict.isDict("speeds"))
    {
        const dictionary& range = dict.subDict("speeds");
        const scalar low = range.get<scalar>("min");
        const scalar high = range.get<scalar>("max");
        const label n = range.get<label>("n");
        const bool logarithmic =
            getWord(range, "spacing", {"log", "linear"}, "log") == "log";
        if (!(low > 0 && high > low))
        {
            FatalIOErrorInFunction(range)
                << "min " << low << ", max " << high
                << ": valid range 0 < min < max" << exit(FatalIOError);
        }
        if (n < 2 || n > 100000)
        {
            FatalIOErrorInFunction(range)
                << "n " << n << ": valid range 2 to 100000"
                << exit(FatalIOError);
        }
        speeds.setSize(n);
        forAll(speeds, i)
        {
            const scalar part = scalar(i)/(n - 1);
            speeds[i] =
                i == n - 1 ? high
              : logarithmic ? low*std::pow(high/low, part)
              : low + (high - low)*part;
        }
    }
    else
    {
        speeds = dict.get<List<scalar>>("speeds");
        if (speeds.empty())
        {
            FatalIOErrorInFunction(dict)
                << "speeds: the list is empty" << exit(FatalIOError);
        }
    }
    forAll(speeds, i)
    {
        if (!(speeds[i] > 0 && std::isfinite(speeds[i])))
        {
            FatalIOErrorInFunction(dict)
                << "speeds " << speeds[i] << ": valid range (0, inf) m/s"
                << exit(FatalIOError);
        }
    }
    return speeds;
}


//- The constant alpha of one contact of the chain
scalar readChainAlpha
(
    const dictionary& dict,
    const impact::dissipationLaw& law
)
{
    if (dict.found("alpha"))
    {
        return dict.get<scalar>("alpha");
    }
    if (!law.isConstant())
    {
        FatalIOErrorInFunction(dict)
            << "entry alpha is needed: the one outside chain is not constant"
            << exit(FatalIOError);
    }
    return law.coeffs()[0];
}

} // End anonymous namespace


Foam::jkrImpactSetup::jkrImpactSetup
(
    const dictionary& dict,
    const fileName& casePath
)
:
    contact
    (
        readContact(dict.isDict("contact") ? dict.subDict("contact") : dict)
    ),
    settings(readSettings(dict)),
    measured(),
    law(readLaw(dict, casePath, contact, settings.unloading, measured)),
    speeds(readSpeeds(dict))
{
    trajectories =
        dict.getOrDefault<Switch>("trajectories", !dict.isDict("speeds"));
    nLoops = dict.getOrDefault<label>("nLoops", 20);
    if (nLoops < 1 || nLoops > 10000)
    {
        FatalIOErrorInFunction(dict)
            << "nLoops " << nLoops << ": valid range 1 to 10000"
            << exit(FatalIOError);
    }

    // alpha(e) is of the impact with adhesion: without, it is not solvable
    if (!law.isConstant() && !(contact.separationSpeed() > 0))
    {
        FatalIOErrorInFunction(dict)
            << "workOfAdhesion " << contact.workOfAdhesion()
            << ": valid range with an alpha that depends on e (0, inf)"
            << exit(FatalIOError);
    }

    // Settings and speeds that no impact can be made with end here, not in
    // the middle of the run
    checked(dict, [&]()
    {
        const impact::jkrImpact impact
        (
            contact, law.isConstant() ? law.coeffs()[0] : 0, settings
        );
        forAll(speeds, i)
        {
            if (settings.scheme == impact::impactScheme::rk4)
            {
                impact.checkTimeStep(speeds[i]);
            }
        }
        return true;
    });

    if (dict.found("chain"))
    {
        const dictionary& block = dict.subDict("chain");
        if (settings.unloading != impact::unloadingType::soft)
        {
            FatalIOErrorInFunction(dict)
                << "unloading hard: valid with a chain: soft"
                << exit(FatalIOError);
        }
        const dictionary& first = block.subDict("particle");
        const dictionary& second = block.subDict("wall");
        const bool oneWay =
            getWord(block, "coupling", {"oneWay", "twoWay"}) == "oneWay";
        chain = checked(block, [&]()
        {
            return impact::contactChain
            (
                readContact(first),
                readChainAlpha(first, law),
                readContact(second),
                readChainAlpha(second, law),
                oneWay
              ? impact::chainCoupling::oneWay
              : impact::chainCoupling::twoWay,
                min(settings.tolerance, scalar(1e-10))
            );
        });
        chainSpeeds = block.found("speeds") ? readSpeeds(block) : speeds;
        sort(chainSpeeds);
    }
}
