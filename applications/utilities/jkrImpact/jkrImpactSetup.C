/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "jkrImpactSetup.H"
#include "checked.H"

namespace
{

using namespace Foam;

//- Entries beside those of the contact
const wordList ours
{
    "contact", "alpha", "speeds", "scheme", "unloading", "tolerance",
    "timeStep", "interpolate", "trajectories", "nLoops", "chain"
};

const char* const speedRange = "[1e-12, 3e8) m/s, less than light";


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
    for (const char* entry : {"timeStep", "interpolate"})
    {
        if (name != "rk4" && dict.found(entry))
        {
            FatalIOErrorInFunction(dict)
                << "Entry " << entry << " is one of scheme rk4, and scheme is "
                << name << nl << "Remove it, or give 'scheme rk4;'"
                << exit(FatalIOError);
        }
    }
    settings.unloading = adhesionEntries::unloading(dict);
    settings.tolerance = getNumber
    (
        dict, "tolerance", "[1e-14, 1e-3]", scalar(settings.tolerance)
    );
    settings.timeStep = getNumber
    (
        dict, "timeStep", "[1e-30, 1e12] s", scalar(settings.timeStep)
    );
    settings.interpolate =
        dict.getOrDefault<Switch>("interpolate", settings.interpolate);
    return settings;
}


List<scalar> readSpeeds(const dictionary& dict)
{
    List<scalar> speeds;
    if (dict.isDict("speeds"))
    {
        const dictionary& range = getBlock(dict, "speeds");
        refuseOthers(range, {"min", "max", "n", "spacing"});
        const scalar low = getNumber(range, "min", speedRange);
        const scalar high = getNumber(range, "max", speedRange);
        const label n = getNumber<label>(range, "n", "[2, 100000]");
        const bool logarithmic =
            getWordOf(range, "spacing", "log", {"log", "linear"}) == "log";
        if (!(high > low))
        {
            refuse(range, "max", high, "greater than min, ", low);
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
            refuse
            (
                dict, "speeds", is[0].number(),
                "(1 2 5), or { min 1; max 5; n 10; }"
            );
        }
        speeds = getNumbers(dict, "speeds", speedRange);
    }
    return speeds;
}


} // End anonymous namespace


Foam::jkrImpactSetup::jkrImpactSetup
(
    const dictionary& dict,
    const fileName& casePath
)
:
    dict(dict),
    contact
    (
        dict.found("contact")
      ? adhesionEntries::contact(getBlock(dict, "contact"))
      : adhesionEntries::contact(dict, ours)
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
     && getBlock(dict, "alpha").get<word>("type") == "marshall"
     && !law.isConstant()
    ),
    speeds(readSpeeds(dict))
{
    if (dict.found("contact"))
    {
        refuseOthers(dict, ours);
    }
    trajectories =
        dict.getOrDefault<Switch>("trajectories", !dict.isDict("speeds"));
    nLoops = getNumber<label>(dict, "nLoops", "[1, 10000]", 20);

    // alpha(e) is of the impact with adhesion: without, it is not solvable
    if (!law.isConstant() && !(contact.separationSpeed() > 0))
    {
        refuse
        (
            dict, "workOfAdhesion", contact.workOfAdhesion(),
            "with an alpha that depends on e (0, inf)"
        );
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

    if (const dictionary* found = findBlock(dict, "chain"))
    {
        const dictionary& block = *found;
        refuseOthers(block, {"particle", "wall", "coupling", "speeds"});
        if (settings.unloading != impact::unloadingType::soft)
        {
            refuse(dict, "unloading", "hard", "with a chain: soft");
        }
        const dictionary& first = getBlock(block, "particle");
        const dictionary& second = getBlock(block, "wall");
        const bool oneWay =
            getWordOf(block, "coupling", "", {"oneWay", "twoWay"}) == "oneWay";
        chain = checked(block, [&]()
        {
            return impact::contactChain
            (
                adhesionEntries::contact(first, {"alpha"}),
                adhesionEntries::chainAlpha(first, "alpha", law),
                adhesionEntries::contact(second, {"alpha"}),
                adhesionEntries::chainAlpha(second, "alpha", law),
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
