/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "scatteringSetup.H"

#include "checked.H"
#include "coreVector.H"
#include "scatteringEntries.H"

namespace
{

using namespace Foam;

const wordList ours
{
    "shape", "wall", "law", "incidence", "speed", "spin", "orientation",
    "nParticles", "seed", "binWidth", "targetError", "maxImpacts",
    "tableSamples", "tableSpeedRange", "tableSpeeds"
};


//- Speeds of a table of a law that depends on them, of equal ratios [m/s]
std::vector<double> readTableSpeeds
(
    const dictionary& dict,
    const bool dependsOnSpeed,
    const bool table
)
{
    if (!dependsOnSpeed)
    {
        for (const word& entry : {"tableSpeedRange", "tableSpeeds"})
        {
            if (dict.found(entry))
            {
                FatalIOErrorInFunction(dict)
                    << "Entry " << entry << ": the law does not depend on the"
                    << " speed, its table holds for every speed. Leave it out"
                    << exit(FatalIOError);
            }
        }
        return {};
    }
    if (table && !dict.found("tableSpeedRange"))
    {
        FatalIOErrorInFunction(dict)
            << "The law depends on the speed: -table needs the entry"
            << " tableSpeedRange (lowest highest) [m/s]"
            << exit(FatalIOError);
    }
    const label n = getNumber<label>(dict, "tableSpeeds", "[2, 1000]", 8);
    if (!dict.found("tableSpeedRange"))
    {
        return {};
    }
    const auto range(dict.get<Tuple2<scalar, scalar>>("tableSpeedRange"));
    for (const scalar speed : {range.first(), range.second()})
    {
        checkNumber
        (
            dict, "tableSpeedRange", speed, "[1e-6, 3e8) m/s, below light"
        );
    }
    if (range.first() >= range.second())
    {
        refuse(dict, "tableSpeedRange", range, "lowest < highest");
    }
    std::vector<double> speeds(n, range.second());
    for (label i = 0; i < n - 1; ++i)
    {
        speeds[i] = range.first()
           *std::pow(range.second()/range.first(), double(i)/(n - 1));
    }
    return speeds;
}


//- A body over thousands of knots takes as long as thousands of bodies; most
//  often its lengths are in other units than those of the wall
void warnOfScale(const impact::scatteringSampler::setup& sampler)
{
    if (!sampler.wall || sampler.wall->isFlat())
    {
        return;
    }
    const double size = 2*sampler.body.radius();
    const bool rough =
        sampler.wall->type() == impact::relief::reliefType::rough;
    const double spacing =
        rough ? sampler.wall->meanSpacing() : sampler.wall->period();
    if (size > 1000*spacing)
    {
        WarningInFunction
            << "The body is " << size << " m long, the "
            << (rough ? "points" : "periods") << " of the wall are "
            << spacing << " m apart: each impact is sought over all points"
            << " under the body, which takes long. Is an entry scale missing,"
            << " of shape or wall?" << endl;
    }
}

} // End anonymous namespace


Foam::scatteringSetup::scatteringSetup
(
    const dictionary& dict,
    const fileName& casePath,
    const bool table
)
:
    incidences(getNumbers(dict, "incidence", "[1e-6, 90] deg"))
{
    refuseOthers(dict, ours);
    refuseSameNames(dict, "incidence", incidences);
    scatteringEntries::read(dict, casePath, sampler);
    sampler.incidence = incidences[0];
    sampler.speed = getNumber(dict, "speed", "[1e-6, 3e8) m/s, below light");
    sampler.spin =
        toCore(getComponents(dict, "spin", validRange::spin, vector(Zero)));

    nParticles = getWhole(dict, "nParticles", "[1, 1e15]");
    sampler.seed = scatteringEntries::getSeed(dict);
    sampler.binWidth =
        getNumber(dict, "binWidth", "[0.1, 90] deg", scalar(1));

    targetError = getTargetError(dict);
    tableSamples = getNumber<label>(dict, "tableSamples", "[1, 1e7]", 1024);
    tableSpeeds =
        readTableSpeeds(dict, sampler.law.dependsOnSpeed(), table);

    checked(dict, [&]
    {
        impact::samplerSetup one(sampler);
        for (const scalar incidence : incidences)
        {
            one.incidence = incidence;
            impact::scatteringSampler(one).emptyStatistics();
        }
        return true;
    });
    warnOfScale(sampler);
}
