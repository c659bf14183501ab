/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "jkrImpactSetup.H"
#include "checked.H"

#include "FlatOutput.H"
#include "ListOps.H"
#include "Switch.H"

namespace
{

using namespace Foam;

impact::impactSettings readSettings(const dictionary& dict)
{
    typedef impact::impactScheme scheme;

    impact::impactSettings settings;
    const word name
    (
        getWordOf(dict, "scheme", "adaptive", {"rk4", "adaptive", "table"})
    );
    settings.scheme =
        name == "rk4" ? scheme::rk4
      : name == "table" ? scheme::table
      : scheme::adaptive;
    settings.unloading = adhesionEntries::unloading(dict);
    settings.tolerance =
        dict.getOrDefault<scalar>("tolerance", settings.tolerance);
    settings.timeStep =
        dict.getOrDefault<scalar>("timeStep", settings.timeStep);
    settings.interpolate =
        dict.getOrDefault<Switch>("interpolate", settings.interpolate);
    return settings;
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
            getWordOf(range, "spacing", "log", {"log", "linear"}) == "log";
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
        ITstream& is = dict.lookup("speeds");
        if (is.size() && is[0].isNumber())
        {
            FatalIOErrorInFunction(dict)
                << "speeds " << is[0]
                << ": valid forms: (1 2 5), or { min 1; max 5; n 10; }"
                << exit(FatalIOError);
        }
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
        adhesionEntries::contact
        (
            dict.isDict("contact") ? dict.subDict("contact") : dict
        )
    ),
    settings(readSettings(dict)),
    measured(),
    law
    (
        adhesionEntries::law
        (
            dict, casePath, contact, settings.unloading, measured
        )
    ),
    ofContactWithoutAdhesion
    (
        dict.isDict("alpha")
     && dict.subDict("alpha").get<word>("type") == "marshall"
     && !law.isConstant()
    ),
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
            getWordOf(block, "coupling", "", {"oneWay", "twoWay"}) == "oneWay";
        chain = checked(block, [&]()
        {
            return impact::contactChain
            (
                adhesionEntries::contact(first),
                readChainAlpha(first, law),
                adhesionEntries::contact(second),
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
